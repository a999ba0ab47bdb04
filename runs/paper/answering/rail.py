"""Torsion on the flanks of rails: which local friction makes it."""

import math
from collections import defaultdict

from answering import program
from answering.answer import Answer

RADIUS, LOAD, LOCAL = 8.5e-6, 100e-6, 0.3
RAILS = (("25", "2.5 nm"), ("45", "3.6 nm"), ("60", "4.8 nm"))


def answer(asperity, folder, _minutes):
    simulated = defaultdict(list)
    for values, effective in program.studied(asperity, "rail_torsion.prm", folder):
        simulated[values["Rail"]].append(effective["torsion_moment"]["value"] / (LOAD * RADIUS))
    quoted = {row["quantity"]: row for row in program.published("quoted.csv")}
    measured, sd = (float(quoted["torsion_r"][key]) for key in ("value", "sd"))
    rows, local = [], []
    for angle, rms in RAILS:
        mean, error = program.mean_and_error(simulated[rms])
        needed = LOCAL * measured / mean
        of = needed * math.hypot(sd / measured, error / mean)
        local.append((needed, of))
        rows.append([angle + " deg, " + rms, "{:.4f} ± {:.4f}".format(mean, error), "{:.2f} ± {:.2f}".format(needed, of)])
    low, high = min(value for value, _ in local), max(value for value, _ in local)
    glued = float(quoted["glued_rail_force"]["value"]) / (float(quoted["glued_rail_load"]["value"]) / math.cos(math.radians(25)))
    sentences = ["The torsion that the paper's rails leave, M/(P r) = {:.4f} ± {:.4f}, is what a local friction of {:.2f} to {:.2f} makes on their roughness at 100 uN.".format(measured, sd, low, high),
                 "The paper's own sphere glued into a rail slides with {:.3f}; the 0.63 to 0.72 that it extrapolates from the etched wafers would make {:.1f} to {:.1f} times the torsion.".format(
                     glued, 0.63 / high, 0.72 / low),
                 "No torsion is missing: what does not hold is friction carried over from wafers that were etched to rails that were cut."]
    return Answer("rail", "Torsion in the rails is seven times too small", "explained", sentences,
                  ["rail", "M/(P r) solved with a local friction of {:g}".format(LOCAL), "local friction that makes the measured torsion"], rows,
                  told_apart_by="sliding along a flank, of a sphere that cannot roll, at three loads: its slope is the local friction and has to be that of the table.")
