"""Runs of asperity, and what they wrote."""

import csv
import json
import math
import pathlib
import statistics
import subprocess

PAPER = pathlib.Path(__file__).resolve().parent.parent
MICRO, NANO = 1e-6, 1e-9


def run(*arguments):
    subprocess.run([str(a) for a in arguments], check=True, stdout=subprocess.DEVNULL)


def diagnosed(asperity, recording, case, folder, minutes):
    """diagnosis.json of a recording set against a case; solutions that `folder` holds are used again."""
    run(
        asperity,
        "diagnose",
        PAPER / "recordings" / recording,
        "--case",
        PAPER / case,
        "--output",
        folder,
        "--minutes",
        minutes,
    )
    return json.loads((folder / "diagnosis.json").read_text())


def studied(asperity, study, folder):
    """Solved cases of a study: (values of its axes, effective values), only those that are done."""
    run(
        asperity,
        "study",
        PAPER / study,
        "--output",
        folder,
        *(["--resume"] if (folder / "study.json").exists() else [])
    )
    cases = json.loads((folder / "study.json").read_text())["cases"]
    return [(case["values"], case["effective"]) for case in cases if case["state"] == "done"]


def previewed(asperity, study, folder, realisations):
    """Cells of a study over many realisations by half-spaces: previews.json; solved cases in the folder
    correct their means."""
    run(
        asperity,
        "study",
        PAPER / study,
        "--preview",
        "--output",
        folder,
        "--set",
        "Study/Realisations={}".format(realisations),
    )
    return json.loads((folder / "previews.json").read_text())


def table(path):
    """Rows of a CSV file, without its comments; numbers of columns with a unit in the unit that the column
    says."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def published(name):
    return table(PAPER / "published" / name)


def mean_and_error(values):
    """Mean of realisations and its standard deviation; of one, none is known (NaN)."""
    if len(values) < 2:
        return values[0], math.nan
    return statistics.mean(values), statistics.stdev(values) / math.sqrt(len(values))


def length(text):
    """ "1.5 um" in metres."""
    number, unit = text.split()
    return float(number) * {"nm": 1e-9, "um": 1e-6, "pm": 1e-12}[unit]


def number(text):
    """ "60 mJ/m^2" as the number 60."""
    return float(text.split()[0])
