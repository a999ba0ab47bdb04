"""Sliding over three wafers, recorded as one: what the case lacks."""

from answering import chart, program
from answering.answer import Answer, interval

RECORDING, CASE = "sliding_three_wafers", "wafer_etched_1600.prm"


def points(folder, state):
    """(rms [nm], load [uN], recorded, its sd, simulated [uN]) of the way forward."""
    rows = [row for row in program.table(folder / (state + ".csv")) if row["segment"] == "forward"]
    keys = ("normal_force [N]", "lateral_force [N]", "lateral_force_sd [N]", "simulated_lateral_force [N]")
    return [(round(float(row["rms_roughness [m]"]) / program.NANO, 3), *(float(row[key]) / program.MICRO for key in keys)) for row in rows]


def figure(folder):
    before, after = points(folder, "before"), points(folder, "after")
    surfaces = sorted({row[0] for row in after})
    series = []
    for rms in surfaces:
        of = [row for row in after if row[0] == rms]
        series.append((chart.RECORDED, "", [(load, value, sd) for _, load, value, sd, _ in of]))
        series.append((chart.BEFORE, "", [(row[1], row[4], 0) for row in before if row[0] == rms]))
        series.append((chart.AFTER, "{:g} nm".format(rms), [(row[1], row[4], 0) for row in of]))
    return chart.drawn("Sliding on three wafers", ("normal force [uN]", "lateral force [uN]"), series)


def local_friction(said, surfaces):
    """Of each surface: what was found, as a row of the table; empty where friction by roughness was not left out."""
    for effect in said["left_out"]:
        if effect["effect"] == "friction_by_roughness":
            b, c = (effect["parameters"][name]["value"] for name in ("smooth_friction", "slope"))
            published = {float(row["rms [nm]"]): row["sliding_friction"] for row in program.published("surfaces.csv")}
            return [["{:g} nm".format(rms), published[rms], "{:.2f}".format(b + c * rms * program.NANO)] for rms in surfaces]
    return []


def answer(asperity, folder, minutes):
    said = program.diagnosed(asperity, RECORDING, CASE, folder, minutes)
    before, after = said["baseline"], said["improved"]
    names = " and ".join("`{}`".format(effect["effect"]) for effect in said["left_out"])
    sentences = ["The case slides each wafer at three of its loads, with one spectrum scaled to each RMS roughness and a local friction of 0.3; it parts from the three lines "
                 "with chi-square {:.3g} a row.".format(before["chi2_reduced"])]
    work = said["forward_model"].get("corrected", {}).get("Interface/Work of adhesion")
    if work:
        sentences.append("One work of adhesion serves all three wafers: {} mJ/m2 over a range of 1 nm (95 %).".format(interval(1e3 * work["value"], *(1e3 * v for v in work["ci95"]), "{:.0f}")))
    for region in said["remaining"][:1]:
        sentences.append("Structure remains: {:.0%} of what is left is between {:.3g} and {:.3g} uN of {}.".format(
            region["share"], region["from"] / program.MICRO, region["to"] / program.MICRO, region["variable"].replace("_", " ")) if region["unit"] == "N" else "Structure remains.")
    others = "; ".join(" and ".join("`{}`".format(name) for name in other["effects"]) for other in said["alternatives"])
    if names:
        sentences.append("What was left out is {}: with it the case, solved again, leaves {:.3g}, and {:.3g} on rows kept out of the fit ({:.3g} before).".format(
            names, after["chi2_reduced"], after["held_out_chi2_reduced"], before["held_out_chi2_reduced"]))
    else:
        sentences.append("No set of effects that was solved explains it.")
    if others:
        sentences.append("As good or nearly: " + others + ".")
    sentences.append("{} solutions; friction is off by {:.1f} % as stated (mesh, path). One realisation: the scatter between realisations is not in the intervals.".format(
        said["forward_model"]["solves"], 100 * said["forward_model"]["discretisation_error"]["value"]))
    return Answer("sliding", "Sliding friction rises with roughness: slopes of 0.23, 0.53 and 0.65", said["verdict"].replace("_", " "), sentences,
                  ["RMS", "published slope of the line", "local friction found"], local_friction(said, sorted({row[0] for row in points(folder, "after")})), figure(folder), "Lateral force of three wafers, before and after",
                  "; ".join(other["told_apart_by"] for other in said["alternatives"])
                  or "the same wafers with another sphere radius: attraction then presses by another share, and local friction stays.")
