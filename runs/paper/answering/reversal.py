"""The slope after a reversal: asperities, or a spring in series."""

import json

from answering import program
from answering.answer import Answer, interval

RECORDING, WAFERS = "sliding_reversal_slope", ("untreated", "etched_1600", "etched_1800")


def answer(asperity, folder, minutes):
    said = program.diagnosed(asperity, RECORDING, "wafer_untreated.prm", folder, minutes)
    measured = next(
        float(row["value"])
        for row in program.published("quoted.csv")
        if row["quantity"] == "fitted_lateral_stiffness"
    )
    rows = []
    for wafer in WAFERS:
        solved = folder / ("lateral_" + wafer)
        if not (solved / "result.json").exists():
            pressed_only = (
                "Experiment/Type=normal",
                "Experiment/Distance=0 m",
                "Experiment/Unload=false",
                "Output/Fields=false",
            )
            program.run(
                asperity,
                "solve",
                program.PAPER / "wafer_{}.prm".format(wafer),
                "--output",
                solved,
                *(word for entry in pressed_only for word in ("--set", entry))
            )
        stiffness = json.loads((solved / "result.json").read_text())["effective"]["lateral_stiffness"]
        series = 1 / (1 / measured - 1 / stiffness["value"])
        rows.append(
            [
                wafer.replace("_", " "),
                "{:.1f} ± {:.1f}".format(stiffness["value"] / 1e3, stiffness["sd"] / 1e3),
                "{:.2f}".format(stiffness["value"] / measured),
                "{:.2f}".format(series / 1e3),
            ]
        )
    least, most = (of(float(row[2]) for row in rows) for of in (min, max))
    sentences = [
        "Before anything slips, the solved rough contacts are {:.1f} to {:.1f} times as stiff as the slope"
        " of {:.3g} kN/m: asperities {} it on these wafers.".format(
            least, most, measured / 1e3, "do not make" if least > 2 else "may make"
        )
    ]
    for effect in said["left_out"]:
        for name, p in effect["parameters"].items():
            sentences.append(
                "Set against the case, the loop names `{}` ({}): {} {} (95 %).".format(
                    effect["effect"],
                    effect["kind"],
                    name,
                    (interval(p["value"], *p["ci95"]) + " " + p["unit"]).strip(),
                )
            )
    sentences.append(
        "Chi-square falls from {:.3g} to {:.3g} on samples kept out of the fit.".format(
            said["baseline"]["held_out_chi2_reduced"], said["improved"]["held_out_chi2_reduced"]
        )
    )
    return Answer(
        "reversal",
        "The slope after a reversal is 2.2 kN/m, a tenth of the contact's",
        said["verdict"].replace("_", " "),
        sentences,
        [
            "wafer",
            "lateral stiffness solved at 100 uN [kN/m]",
            "over the recorded slope",
            "spring in series that makes the slope [kN/m]",
        ],
        rows,
        told_apart_by=(
            "loops at 10 and 300 uN: a contact's stiffness grows with the load, a holder's does not."
        ),
    )
