"""No rolling below 100 uN: whether a contact makes it."""

from answering import rolling, sliding
from answering.answer import Answer


def answer(asperity, folder, minutes):
    of_sliding = folder.parent / "sliding"
    all_of = sliding.diagnoses(asperity, of_sliding, minutes)
    rolloff = sliding.OF_PULL_OFF
    simulated = sliding.points(
        of_sliding / rolloff.replace(" ", "_"), "after" if all_of[rolloff]["left_out"] else "before"
    )
    rows, least = [], float("inf")
    for rms, (slope, force) in rolling.lines().items():
        load, limit = min((load, value) for surface, load, _, _, value in simulated if surface == rms)
        resists = slope * load + force
        least = min(least, limit / resists)
        rows.append(
            [
                "{:g} nm".format(rms),
                "{:g}".format(load),
                "{:.2f}".format(limit),
                "{:.2f}".format(resists),
                "{:.1f}".format(limit / resists),
            ]
        )
    sentences = [
        "A sphere rolls where the force that rolls it is below the friction that would let it slide. At the"
        " smallest load that was slid, the solved contacts hold {:.1f} times the force of the recorded"
        " rolling lines and more: by these contacts the sphere rolls at any load.".format(least),
        "Sliding at the diamond instead would need a friction there of less than {:.3f} at 100 uN.".format(
            max(slope * 100 + force for slope, force in rolling.lines().values()) / 100
        ),
        (
            "So the threshold is outside of what was simulated: the recorded lines begin at 100 uN, and what"
            " holds the sphere below is not in them."
        ),
    ]
    return Answer(
        "threshold",
        "No sphere rolls below 100 uN",
        "unexplained by the contact" if least > 1 else "ambiguous",
        sentences,
        [
            "wafer",
            "load [uN]",
            "sliding limit solved [uN]",
            "rolling line continued to that load [uN]",
            "limit over rolling",
        ],
        rows,
        told_apart_by=(
            "the lateral force while the load is lowered on a sphere that rolls already: a contact's"
            " threshold lets it stop, an instrument's noise does not."
        ),
    )
