"""Sliding over three wafers, recorded as one: what the case lacks."""

from answering import chart, program, pull_off
from answering.answer import Answer, interval

RECORDING = "sliding_three_wafers"
# Roll-off of the wafers' spectrum: what the pull-off forces leave, which the answer is of, and what the
# studies of motion took.
OF_PULL_OFF, OF_THE_STUDIES = "1.5 um", "200 nm"
CASES = {OF_PULL_OFF: "wafers_of_long_waves.prm", OF_THE_STUDIES: "wafer_etched_1600.prm"}


def points(folder, state):
    """(rms [nm], load [uN], recorded, its sd, simulated [uN]) of the way forward."""
    rows = [row for row in program.table(folder / (state + ".csv")) if row["segment"] == "forward"]
    keys = ("normal_force [N]", "lateral_force [N]", "lateral_force_sd [N]", "simulated_lateral_force [N]")
    return [
        (
            round(float(row["rms_roughness [m]"]) / program.NANO, 3),
            *(float(row[key]) / program.MICRO for key in keys),
        )
        for row in rows
    ]


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


def local_friction(said):
    """Of each surface: what was found, at the wafers' RMS [nm]; none where friction by roughness was not
    left out."""
    for effect in said["left_out"]:
        if effect["effect"] == "friction_by_roughness":
            b, c = (effect["parameters"][name]["value"] for name in ("smooth_friction", "slope"))
            return ", ".join(
                "{:.2f}".format(b + c * float(row["rms [nm]"]) * program.NANO)
                for row in program.published("surfaces.csv")
            )
    return "-"


def work_of_adhesion(said):
    work = said["forward_model"].get("corrected", {}).get("Interface/Work of adhesion")
    return interval(1e3 * work["value"], *(1e3 * v for v in work["ci95"]), "{:.0f}") if work else "-"


def diagnoses(asperity, folder, minutes):
    return {
        rolloff: program.diagnosed(asperity, RECORDING, case, folder / rolloff.replace(" ", "_"), minutes)
        for rolloff, case in CASES.items()
    }


def answer(asperity, folder, minutes):
    all_of = diagnoses(asperity, folder, minutes)
    rolloff = OF_PULL_OFF
    said, shorter = (all_of[which] for which in (OF_PULL_OFF, OF_THE_STUDIES))
    before, after = said["baseline"], said["improved"]
    names = " and ".join("`{}`".format(effect["effect"]) for effect in said["left_out"])
    sentences = [
        "The case slides each wafer at three of its loads, with one spectrum scaled to each RMS roughness, a"
        " local friction of 0.3 and nothing that attracts; it parts from the three lines with chi-square"
        " {:.3g} a row.".format(before["chi2_reduced"])
    ]
    if names:
        sentences.append(
            "What was left out is {}: solved again so, with a roll-off of {}, the case leaves {:.3g}, and"
            " {:.3g} on rows kept out of the fit ({:.3g} before).".format(
                names,
                rolloff,
                after["chi2_reduced"],
                after["held_out_chi2_reduced"],
                before["held_out_chi2_reduced"],
            )
        )
    else:
        sentences.append("No set of effects that was solved explains it.")
    if shorter["improved"]["held_out_chi2_reduced"] < after["held_out_chi2_reduced"]:
        sentences.append(
            "With a roll-off of {} sliding is met better ({:.3g} kept out).".format(
                OF_THE_STUDIES, shorter["improved"]["held_out_chi2_reduced"]
            )
        )
        if OF_THE_STUDIES not in pull_off.possible_rolloffs(asperity, folder.parent / "pull_off"):
            sentences.append(
                "The pull-off forces exclude it: the two measurements do not share one spectrum yet. Works"
                " of adhesion are in the table; pull-off, below, has its own."
            )
    others = "; ".join(
        " and ".join("`{}`".format(name) for name in other["effects"]) for other in said["alternatives"]
    )
    if others:
        how = "As good or nearly" if names else "Fits as far as it was solved, and was not solved to its end"
        sentences.append("{}: {}.".format(how, others))
    sentences.append(
        "Friction is off by {:.1f} % as stated (mesh, path). One realisation each: the scatter between"
        " realisations is not in the intervals.".format(
            100 * said["forward_model"]["discretisation_error"]["value"]
        )
    )
    rows = [
        [
            length,
            of["verdict"].replace("_", " "),
            local_friction(of),
            work_of_adhesion(of),
            "{:.3g} to {:.3g}".format(
                *(of[state]["held_out_chi2_reduced"] for state in ("baseline", "improved"))
            ),
            str(of["forward_model"]["solves"]),
        ]
        for length, of in all_of.items()
    ]
    return Answer(
        "sliding",
        "Sliding friction rises with roughness: slopes of 0.23, 0.53 and 0.65",
        said["verdict"].replace("_", " "),
        sentences,
        [
            "roll-off",
            "answer",
            "local friction at 0.3, 1.5, 2.7 nm",
            "work of adhesion over 1 nm [mJ/m2]",
            "chi-square, kept out",
            "solutions",
        ],
        rows,
        figure(folder / rolloff.replace(" ", "_")),
        "Lateral force of three wafers, before and after",
        "; ".join(other["told_apart_by"] for other in said["alternatives"])
        or "the same wafers with another sphere radius: attraction then presses by another share, and "
        "local friction stays.",
    )
