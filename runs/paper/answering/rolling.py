"""Rolling over three wafers: how much of it bonds can make that the pull-off allows, and what the lines have
in common."""

import re

from answering import chart, program
from answering.answer import Answer

RADIUS = 8.5e-6


def work_of_bonds():
    """Work of adhesion on separation of the study [mJ/m2]."""
    return float(
        re.search(
            r"Work of adhesion on separation = (\S+) mJ/m\^2",
            (program.PAPER / "rolling_bonds.prm").read_text(),
        ).group(1)
    )


def lines():
    """RMS [nm] -> slope and force at no load [uN] of the published line."""
    found = {}
    for row in program.published("surfaces.csv"):
        slope = float(row["rolling_r"])
        found[float(row["rms [nm]"])] = (slope, slope * float(row["rolling_r_offset [uN]"]))
    return found


def points():
    """(RMS [nm], load, lateral force of either way and its standard deviation [uN]) as recorded."""
    rows = program.table(program.PAPER / "recordings/rolling_offset_and_roughness/series.csv")
    keys = ("rms_roughness [nm]", "normal_force [uN]", "lateral_force [uN]", "lateral_force_sd [uN]")
    return [tuple(abs(float(row[key])) for key in keys) for row in rows]


def least_squares(rows, columns, weights, values):
    """Normal equations of a few unknowns; each of `columns` maps a row to a number. Returns values and chi-
    square."""
    n = len(columns)
    matrix = [
        [sum(w * a(r) * b(r) for r, w in zip(rows, weights)) for b in columns]
        + [sum(w * a(r) * v for r, w, v in zip(rows, weights, values))]
        for a in columns
    ]
    for i in range(n):
        matrix[i] = [x / matrix[i][i] for x in matrix[i]]
        for k in range(n):
            if k != i:
                matrix[k] = [x - matrix[k][i] * y for x, y in zip(matrix[k], matrix[i])]
    found = [row[n] for row in matrix]
    return found, sum(
        w * (v - sum(f * c(r) for f, c in zip(found, columns))) ** 2
        for r, w, v in zip(rows, weights, values)
    )


def reduced(rows):
    """Chi-square a row of one friction and one force; of a friction for each wafer and one adhesion; of a
    friction for each and one force, with what the last found."""
    weights, values = [1 / sd**2 for *_, sd in rows], [value for _, _, value, _ in rows]
    surfaces = sorted({rms for rms, *_ in rows})
    slopes = [lambda r, rms=rms: r[1] if r[0] == rms else 0.0 for rms in surfaces]

    def force(_):
        return 1.0

    _, one = least_squares(rows, [lambda r: r[1], force], weights, values)
    fitted, each = least_squares(rows, slopes + [force], weights, values)
    adhesion = min(
        least_squares(
            rows,
            [lambda r, rms=rms, h=h: r[1] + h if r[0] == rms else 0.0 for rms in surfaces],
            weights,
            values,
        )[1]
        for h in range(0, 4000, 20)
    )
    return one / (len(rows) - 2), adhesion / (len(rows) - 4), each / (len(rows) - 4), fitted


def figure(rows, one_force):
    series = []
    for rms, fitted in zip(sorted({row[0] for row in rows}), one_force):
        of = sorted({row[1:] for row in rows if row[0] == rms})
        series.append((chart.RECORDED, "", of))
        series.append(
            (
                chart.AFTER,
                "{:g} nm".format(rms),
                [(load, fitted * load + one_force[-1], 0) for load, _, _ in of],
            )
        )
    return chart.drawn(
        "Rolling: a friction for each wafer and one force",
        ("normal force [uN]", "lateral force [uN]"),
        series,
    )


def answer(asperity, folder, _minutes):
    solved = {
        values["Contact"]: effective
        for values, effective in program.studied(asperity, "rolling_bonds.prm", folder)
    }
    recorded_rows = points()
    one, adhesion, each, fitted = reduced(recorded_rows)
    moment = {
        name: (of["rolling_dissipation"]["value"], of["rolling_dissipation"]["sd"])
        for name, of in solved.items()
    }
    rows, shares = [], []
    for rms, (slope, force) in lines().items():
        wafer = moment["{:g} nm".format(rms)]
        simulated = (wafer[0] + moment["diamond"][0]) / (2 * RADIUS) / program.MICRO
        recorded = slope * 100 + force
        shares.append(simulated / recorded)
        rows.append(
            [
                "{:g} nm".format(rms),
                "{:.2f} ± {:.2f}".format(*(v * 1e12 for v in wafer)),
                "{:.3f}".format(simulated),
                "{:.2f}".format(recorded),
                "{:.2f}".format(force),
            ]
        )
    bonds = max(shares)
    sentences = [
        "With bonds that take {:.0f} mJ/m2 to open, as the pull-off forces leave it, and all of that lost,"
        " both contacts together resist at 100 uN with {:.0f} to {:.0f} % of what was recorded: adhesion"
        " hysteresis, slip and yielding of this contact do not make the force that is left at no load."
        .format(work_of_bonds(), 100 * min(shares), 100 * bonds),
        "Three lines with one friction and one force have chi-square {:.3g} a row, a friction for each wafer"
        " and one adhesion {:.3g}, a friction for each and one force that does not depend on the load"
        " {:.2g}: {:.2f} uN on all three wafers.".format(one, adhesion, each, fitted[-1]),
        "The mesh of 32 nm makes rolling rather too large (verified on finer ones:"
        " docs/results_of_the_paper.md); the diamond's contact alone resists with {:.2f} ± {:.2f} pN m. One"
        " realisation.".format(*(value * 1e12 for value in moment["diamond"])),
        (
            "A force that is the same on three wafers and without load belongs to what they share: the"
            " diamond's contact, a film of water that both carry along, or the instrument."
        ),
    ]
    return Answer(
        "rolling",
        "Rolling: the friction falls with roughness, and a force is left at no load",
        "unexplained by the contact" if bonds < 0.5 else "ambiguous",
        sentences,
        [
            "wafer",
            "moment solved at 100 uN [pN m]",
            "force of both contacts [uN]",
            "recorded at 100 uN [uN]",
            "recorded at no load [uN]",
        ],
        rows,
        figure(recorded_rows, fitted),
        "Rolling on three wafers, with one force that does not depend on the load",
        (
            "spheres of two radii: the force of a contact's moment falls with the radius, an instrument's"
            " does not; and the indenter led back without a sphere."
        ),
    )
