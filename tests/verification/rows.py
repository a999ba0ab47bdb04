"""Rows that tests leave with ASPERITY_VERIFICATION (support/verification.h), and the page made of them."""

import csv
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs" / "verification.md"
NOTES = ROOT / "tests" / "verification" / "notes.md"
NIGHTLY = ROOT / "tests" / "verification" / "nightly"
COLUMNS = ["topic", "quantity", "source", "asked", "measured", "met", "test"]
ASKED = ["topic", "quantity", "source", "asked", "test"]


def commit():
    command = ["git", "-C", ROOT, "describe", "--always", "--dirty=, with changes that are not committed"]
    described = subprocess.run(command, capture_output=True, text=True)
    return described.stdout.strip() if described.returncode == 0 else "unknown"


def read(folder):
    """Rows of all files of a folder, in the order of their names."""
    rows = []
    for path in sorted(pathlib.Path(folder).glob("*.csv")):
        with path.open(newline="") as file:
            rows += list(csv.DictReader(file))
    return rows


def merged(folder, nightly):
    """Rows of a run, and of the tests that it has no rows of those that a nightly run left."""
    today = read(folder)
    ran = {row["test"] for row in today}
    return today, [row for row in read(nightly) if row["test"] not in ran]


def cell(text):
    return text.replace("|", "\\|")


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def measured(row):
    return row["measured"] if row["met"] == "yes" else f"**{row['measured']}, not met**"


def sections(text):
    """{heading: text below it} of a page, in its order; what stands before the first heading is left out."""
    parts = re.split(r"^## (.+)\n", text, flags=re.M)
    return {parts[i].strip(): parts[i + 1].strip() for i in range(1, len(parts), 2)}


def written(text):
    """Rows that a page shows, with the date of each."""
    found = []
    for topic, body in sections(text).items():
        for row in body.splitlines():
            cells = [c.strip().replace("\\|", "|") for c in re.split(r"(?<!\\)\|", row)[1:-1]]
            if len(cells) != 7 or not cells[5].startswith("`"):
                continue
            missed = re.fullmatch(r"\*\*(.*), not met\*\*", cells[4])
            values = [topic, cells[0], cells[2], cells[3], missed.group(1) if missed else cells[4],
                      "no" if missed else "yes", cells[5].strip("`")]
            found.append({**dict(zip(COLUMNS, values)), "date": cells[6].removeprefix("nightly, ")})
    return found


def name_of_test(row):
    return row["test"].split(".", 1)[1].split("/")[0]


def sources(tests):
    """The text of all tests, in which each has its name."""
    return "".join(path.read_text() for path in pathlib.Path(tests).rglob("*_test.cc"))


def page_rows(text):
    """What a page says is asked, a tuple of ASKED for each row."""
    return {tuple(row[c] for c in ASKED) for row in written(text)}
