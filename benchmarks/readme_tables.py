"""Tables of benchmarks/README.md from what the benchmarks wrote, each between two marks of its name."""

import re

GiB = 2 ** 30


def block(name, text):
    return f"<!-- {name}: written by benchmarks/run, not by hand -->\n{text}<!-- end of {name} -->"


def replaced(page, name, text):
    """The page with the block of that name replaced. Raises ValueError if the page has none."""
    pattern = re.compile(rf"<!-- {name}:.*?<!-- end of {name} -->", re.S)
    if len(pattern.findall(page)) != 1:
        raise ValueError(f"benchmarks/README.md has no single block of the name '{name}'")
    return pattern.sub(lambda _: block(name, text), page)


def heading(report):
    """When, on what, and by which program: what makes two tables comparable."""
    machine, run = report["machine"], report["run"]
    threads = f", {report['threads']} thread{'s' if report['threads'] != 1 else ''}" if "threads" in report else ""
    load = ", ".join(f"{value:.1f}" for value in (machine["load"][0], run["load_after"]))
    return f"Commit {run['commit']}, {machine['time'][:10]}, {machine['processor']}, {machine['cores']} cores{threads}, load before and after {load}.\n"


def table(names, rows):
    lines = ["| " + " | ".join(names) + " |", "| " + " | ".join("---" for _ in names) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def count(number):
    return f"{int(number):,}".replace(",", " ")


def met(is_met):
    return "met" if is_met else "**not met**"


def rough_contact(report):
    rows = [(s["spacing"], count(s["unknowns"]), f"{s['steps']:.0f}", f"{s['wall_time']:.0f} s",
             f"{s['newton_per_step']:.1f} ({s['most_newton_in_a_step']:.0f})", f"{s['cg_per_step']:.0f}", f"{s['cg_per_newton']:.1f}",
             f"{s['peak_memory'] / GiB:.2f} GiB", f"{s['bytes_per_unknown'] / 1e3:.2f} kB", f"{s['contact_area_at_largest_load'] * 1e12:.4f} um^2")
            for s in report["sizes"]]
    text = heading(report) + "\n" + table(["spacing", "unknowns", "steps", "wall time", "Newton a step (most)", "CG a step", "CG a Newton step",
                                           "peak memory", "an unknown", "real contact area"], rows)
    if "growth" in report:
        last, growth = report["sizes"][-1], report["growth"]
        text += "\n" + table(["asked at " + count(last["unknowns"]) + " unknowns", "measured"], [
            ("20 steps within 90 s on two cores", f"{last['wall_time']:.0f} s: {met(last['wall_time'] <= 90)}"),
            ("within 0.6 GiB", f"{last['peak_memory'] / GiB:.2f} GiB: {met(last['peak_memory'] <= 0.6 * GiB)}"),
            (f"iterations grow by at most {growth['asked']}", f"Newton {growth['newton_per_step']:.2f}, CG a Newton step {growth['cg_per_newton']:.2f}, "
             f"CG a step {growth['cg_per_step']:.2f}: {met(max(growth['newton_per_step'], growth['cg_per_newton'], growth['cg_per_step']) <= growth['asked'])}")])
    return text


def rough_sliding(report):
    rows = [(p["spacing"], count(p["unknowns"]), f"{p['way'] * 1e6:.2f} um", f"{p['wall_time'] / 60:.1f} min",
             f"{p['loading']['steps']} in {p['loading']['seconds']:.1f} s", f"{p['motion']['seconds_per_step']:.2f} s", f"{p['motion_step_over_loading']:.3f}",
             f"{p['motion']['newton_per_step']:.1f}, {p['motion']['cg_per_step']:.0f}", f"{p['peak_memory'] / GiB:.2f} GiB",
             f"{p['peak_memory'] / p['unknowns'] / 1e3:.2f} kB", f"{p['balance']['energy']:.1e}") for p in report["paths"]]
    text = heading(report) + "\n" + table(["spacing", "unknowns", "path length", "wall time", "steps of pressing down", "a step of motion", "over pressing down",
                                           "Newton, CG a step", "peak memory", "an unknown", "energy"], rows)
    minutes = report["paths"][-1]["wall_time"] / 60
    if report["paths"][-1]["spacing"] == "10 nm":
        text += "\n" + table(["asked", "measured"], [("the loop at 10 nm within 3 min on two cores", f"{minutes:.1f} min: {met(minutes <= 3)}")])
    return text


def of_step42(r):
    return (r["name"], count(r["unknowns"]), f"1/{1 / r['spacing']:.0f}", f"{r['newton']}, {r['linear']}", f"{r['linear'] / r['newton']:.1f}",
            f"{r['wall_time']:.1f} s", f"{r['cpu_time']:.1f} s", f"{r['peak_memory'] / 1e6:.0f} MB", f"{r['contact_force']:.2f}")


def step42(report):
    """With the tutorial where it was run, else of asperity alone."""
    rows = [of_step42(r) for r in [report.get("step_42"), report.get("step_42_free_sides"), *report["asperity"]] if r]
    text = heading(report) + "\n" + table(["", "unknowns", "spacing", "Newton, linear", "linear a Newton step", "wall", "CPU", "memory", "force"], rows)
    if report.get("step_42"):
        text += "\n" + table(["asked at as many unknowns", "wall", "CPU", "memory", ""],
                             [(r["name"], *(f"{r['ratio'][k]:.1f}" for k in ("time", "cpu", "memory")),
                               met(r["ratio"]["time"] >= 3 and r["ratio"]["memory"] >= 2)) for r in report["asperity"]])
    return text


TABLES = {"rough_contact": rough_contact, "rough_sliding": rough_sliding, "step42": step42}
