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


def rows_of(said):
    rows = []
    for effect in said["left_out"]:
        for name, p in effect["parameters"].items():
            rows.append(["`" + effect["effect"] + "`", effect["equation"], name, interval(p["value"], *p["ci95"]) + " " + p["unit"], "yes" if effect["case_entries"] else "no"])
    return rows


def answer(asperity, folder, minutes):
    said = program.diagnosed(asperity, RECORDING, CASE, folder, minutes)
    before, after = said["baseline"], said["improved"]
    names = " and ".join("`{}`".format(effect["effect"]) for effect in said["left_out"])
    sentences = ["The case slides each wafer at three of its loads, with one spectrum scaled to each RMS roughness and a local friction of 0.3; it parts from the three lines "
                 "with chi-square {:.3g} a row.".format(before["chi2_reduced"])]
    others = "; ".join(" and ".join("`{}`".format(name) for name in other["effects"]) for other in said["alternatives"])
    if names:
        sentences.append("What was left out is {}: with it the case, solved again, leaves {:.3g}, and {:.3g} on rows kept out of the fit ({:.3g} before).".format(
            names, after["chi2_reduced"], after["held_out_chi2_reduced"], before["held_out_chi2_reduced"]))
    else:
        sentences.append("No set of effects that was solved explains it.")
    if others:
        sentences.append("As good or nearly: " + others + ".")
    sentences.append("{} solutions; friction is off by {:.1%} as stated (mesh, path). One realisation: the scatter between realisations is not in the intervals.".format(
        said["forward_model"]["solves"], said["forward_model"]["discretisation_error"]["value"]))
    return Answer("sliding", "Sliding friction rises with roughness: slopes of 0.23, 0.53 and 0.65", said["verdict"].replace("_", " "), sentences,
                  ["left out", "law", "parameter", "value (95 %)", "entry of the case"], rows_of(said), figure(folder), "Lateral force of three wafers, before and after",
                  "; ".join(other["told_apart_by"] for other in said["alternatives"])
                  or "the same wafers with another sphere radius: attraction then presses by another share, and local friction stays.")
