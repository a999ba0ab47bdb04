"""What one question got as an answer, and how the page shows it."""

from dataclasses import dataclass, field


@dataclass
class Answer:
    name: str  # of its figure
    question: str
    verdict: str  # explained, ambiguous, unexplained, ...: as a diagnosis says it
    said: list  # sentences, one a line
    head: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    figure: str = ""  # SVG
    caption: str = ""
    told_apart_by: str = ""  # the experiment; empty: none is needed

    def markdown(self, folder):
        lines = [
            "## " + self.question,
            "",
            "**" + self.verdict[0].upper() + self.verdict[1:] + ".** " + self.said[0],
            *self.said[1:],
            "",
        ]
        if self.rows:
            lines += ["| " + " | ".join(self.head) + " |", "|" + " --- |" * len(self.head)]
            lines += ["| " + " | ".join(row) + " |" for row in self.rows] + [""]
        if self.figure:
            lines += ["![{}]({}/{}.svg)".format(self.caption, folder, self.name), ""]
        if self.told_apart_by:
            lines += ["What would tell: " + self.told_apart_by, ""]
        return "\n".join(lines)


def interval(value, low, high, form="{:.3g}"):
    return "{} ({} to {})".format(*(form.format(v) for v in (value, low, high)))
