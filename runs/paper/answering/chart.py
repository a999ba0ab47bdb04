"""A chart as SVG: recorded points with their standard deviations, and lines before and after, told apart by
marker as well as colour."""

from math import ceil, floor, log10
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 560, 330
LEFT, RIGHT, TOP, BOTTOM = 66, 16, 42, 46
RECORDED, BEFORE, AFTER, HELD_OUT = "recorded", "before", "after", "after, kept out of the fit"
LOOKS = {
    RECORDED: ("#1c2430", "circle", ""),
    BEFORE: ("#b3541e", "square", "6 4"),
    AFTER: ("#1f5f8b", "diamond", ""),
    HELD_OUT: ("#1f5f8b", "open", ""),
}


class Axis:
    """From values to pixels; logarithmic where that is asked for."""

    def __init__(self, values, low, high, logarithmic=False, from_zero=True):
        self.logarithmic = logarithmic
        self.low, self.high = low, high
        if logarithmic:
            self.start, self.end = log10(min(values) / 1.25), log10(max(values) * 1.25)
        else:
            self.start = min(0, min(values)) if from_zero else min(values)
            self.end = max(values) + 0.1 * (max(values) - self.start)

    def at(self, value):
        place = log10(value) if self.logarithmic else value
        return self.low + (self.high - self.low) * (place - self.start) / (self.end - self.start)

    def ticks(self):
        if self.logarithmic:
            powers = range(floor(self.start), ceil(self.end) + 1)
            return [
                n * 10.0**p
                for p in powers
                for n in (1, 3)
                if self.start <= log10(n * 10.0**p) <= self.end
            ]
        step = 10.0 ** floor(log10((self.end - self.start) / 4))
        step *= next(n for n in (1, 2, 5, 10) if (self.end - self.start) / (n * step) <= 7)
        first = ceil(self.start / step)
        return [n * step for n in range(first, floor(self.end / step) + 1)]


def marker(shape, x, y, colour):
    fill = "#fff" if shape == "open" else colour
    if shape in ("circle", "open"):
        return (
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{fill}" stroke="{colour}" stroke-width="1.6"/>'
        )
    if shape == "square":
        return f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" fill="{colour}"/>'
    return f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{colour}"/>'


def legend(looks):
    parts, x = [], LEFT
    for look in looks:
        colour, shape, _ = LOOKS[look]
        parts.append(marker(shape, x + 4, 30, colour) + f'<text x="{x + 14}" y="34">{escape(look)}</text>')
        x += 30 + 6.4 * len(look)
    return "".join(parts)


def frame(across, up, labels):
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    parts = []
    for value in across.ticks():
        parts.append(
            f'<path d="M{across.at(value):.1f} {TOP}V{bottom}" stroke="#e4e7ea"/>'
            f'<text x="{across.at(value):.1f}" y="{bottom + 16}" text-anchor="middle">{value:g}</text>'
        )
    for value in up.ticks():
        parts.append(
            f'<path d="M{LEFT} {up.at(value):.1f}H{right}" stroke="#e4e7ea"/>'
            f'<text x="{LEFT - 7}" y="{up.at(value) + 4:.1f}" text-anchor="end">{value:g}</text>'
        )
    parts.append(
        f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{bottom - TOP}" fill="none"'
        f' stroke="#59636f"/><text x="{(LEFT + right) / 2}" y="{HEIGHT - 8}"'
        f' text-anchor="middle">{escape(labels[0])}</text><text transform="translate(15'
        f' {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle">{escape(labels[1])}</text>'
    )
    return "".join(parts)


def drawn(title, labels, series, logarithmic=False):
    """series: (look, label or "", [(x, y, sd), ...]) each; points of one but the recorded are joined by a
    line."""
    points = [p for _, _, rows in series for p in rows]
    across = Axis([x for x, _, _ in points], LEFT + 10, WIDTH - RIGHT - 10, logarithmic)
    up = Axis([y + sd for _, y, sd in points] + [y - sd for _, y, sd in points], HEIGHT - BOTTOM, TOP)
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}"'
            ' font-family="sans-serif" font-size="12" fill="#1c2430">'
        ),
        '<rect width="100%" height="100%" fill="#fff"/>',
        f'<text x="{LEFT}" y="16" font-size="13" font-weight="bold">{escape(title)}</text>',
        legend(list(dict.fromkeys(look for look, _, _ in series))),
        frame(across, up, labels),
    ]
    for look, name, rows in series:
        colour, shape, dashes = LOOKS[look]
        rows = sorted(rows)
        if look not in (RECORDED, HELD_OUT):
            path = "L".join(f"{across.at(x):.1f} {up.at(y):.1f}" for x, y, _ in rows)
            parts.append(
                f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="1.6"'
                f' stroke-dasharray="{dashes}"/>'
            )
        for x, y, sd in rows:
            if sd > 0:
                parts.append(
                    f'<path d="M{across.at(x):.1f} {up.at(y - sd):.1f}V{up.at(y + sd):.1f}"'
                    f' stroke="{colour}" stroke-width="1.4"/>'
                )
            parts.append(marker(shape, across.at(x), up.at(y), colour))
        if name:
            x, y, _ = rows[-1]
            parts.append(
                f'<text x="{across.at(x) - 8:.1f}" y="{up.at(y) - 9:.1f}" text-anchor="end"'
                f' fill="{colour}">{escape(name)}</text>'
            )
    return "\n".join(parts + ["</svg>\n"])
