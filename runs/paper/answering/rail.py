"""Torsion on the flanks of rails: which local friction makes it."""

import math
from collections import defaultdict

from answering import program
from answering.answer import Answer

RADIUS, LOAD, LOCAL = 8.5e-6, 100e-6, 0.3
RAILS = (("25", "2.5 nm"), ("45", "3.6 nm"), ("60", "4.8 nm"))


def answer(asperity, folder, _minutes):
    simulated, mesh = defaultdict(list), 0.0
    for values, effective in program.studied(asperity, "rail_torsion.prm", folder):
        simulated[values["Rail"]].append(effective["torsion_moment"]["value"] / (LOAD * RADIUS))
        mesh = max(mesh, effective["torsion_moment"]["sd"] / effective["torsion_moment"]["value"])
    quoted = {row["quantity"]: row for row in program.published("quoted.csv")}
    measured, sd = (float(quoted["torsion_r"][key]) for key in ("value", "sd"))
    rows, local = [], []
    for angle, rms in RAILS:
        mean, error = program.mean_and_error(simulated[rms])
        error = math.hypot(error, mesh * mean)
        needed = LOCAL * measured / mean
        of = needed * math.hypot(sd / measured, error / mean)
        local.append((needed, needed * error / mean))
        rows.append(
            [
                angle + " deg, " + rms,
                "{:.4f} ± {:.4f}".format(mean, error),
                "{:.2f} ± {:.2f}".format(needed, of),
            ]
        )
    mean, scatter = (sum(numbers) / len(local) for numbers in zip(*local))
    # The measured torsion is one number, and the three surfaces are one, scaled: neither error averages out.
    error = math.hypot(mean * sd / measured, scatter)
    slope = float(quoted["glued_rail_load"]["value"]) / math.cos(math.radians(25))
    glued, of_glued = (float(quoted["glued_rail_force"][key]) / slope for key in ("value", "sd"))
    apart = {
        name: (friction - mean) / math.hypot(error, of_friction)
        for name, friction, of_friction in (
            ("glued", glued, of_glued),
            ("extrapolated", float(quoted["rail_sliding_friction_low"]["value"]), 0),
        )
    }
    is_glued, is_extrapolated = (abs(apart[name]) < 2 for name in ("glued", "extrapolated"))
    verdict = (
        "explained" if is_glued and not is_extrapolated else "ambiguous" if is_glued else "partly explained"
    )
    sentences = [
        "The torsion that the paper's rails leave, M/(P r) = {:.4f} ± {:.4f}, is what a local friction of"
        " {:.2f} ± {:.2f} makes on their roughness at 100 uN, under the attraction that the pull-off forces"
        " leave.".format(measured, sd, mean, error),
        "The friction of {:.2f} to {:.2f} that the paper extrapolates from the etched wafers to the rails"
        " would make {:.1f} to {:.1f} times the torsion ({:.1f} standard deviations off); its own sphere,"
        " glued into a rail, slides with {:.3f} ± {:.3f} ({:.1f} off).".format(
            *(float(quoted["rail_sliding_friction_" + end]["value"]) for end in ("low", "high")),
            *(float(quoted["rail_sliding_friction_" + end]["value"]) / mean for end in ("low", "high")),
            abs(apart["extrapolated"]),
            glued,
            of_glued,
            abs(apart["glued"])
        ),
    ]
    if is_glued and not is_extrapolated:
        sentences.append(
            "No torsion is missing: what does not hold is friction carried over from wafers that were etched"
            " to rails that were cut."
        )
    sentences.append(
        "Errors are of two realisations, of the mesh ({:.0f} % as stated) and of the measured torsion."
        .format(100 * mesh)
    )
    return Answer(
        "rail",
        "Torsion in the rails is seven times too small",
        verdict,
        sentences,
        [
            "rail",
            "M/(P r) solved with a local friction of {:g}".format(LOCAL),
            "local friction that makes the measured torsion",
        ],
        rows,
        told_apart_by=(
            "sliding along a flank, of a sphere that cannot roll, at three loads: its slope is the local"
            " friction and has to be that of the table."
        ),
    )
