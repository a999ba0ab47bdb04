"""Where a recording and its simulation part, and which physics was left out."""

from __future__ import annotations

import json
import os
import pathlib
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional

from . import _native
from .program import Path, Progress, run

if TYPE_CHECKING:
    import pandas


@dataclass
class Diagnosis:
    """An answer; `document` is all of diagnosis.json, in SI units."""

    document: dict[str, Any]
    #: Of each table of the recording: file, response, and columns with simulated_before and simulated_after.
    tables: list[dict[str, Any]] = field(repr=False)

    @property
    def verdict(self) -> str:
        """"no_mismatch", "explained", "partly_explained", "ambiguous" or "unexplained"."""
        return self.document["verdict"]

    @property
    def in_words(self) -> str:
        """The verdict in a sentence or two."""
        return self.document["in_words"]

    @property
    def left_out(self) -> dict[str, dict[str, Any]]:
        """Effects that were left out by name: kind, parameters with ci95, equation, source."""
        return {effect["effect"]: effect for effect in self.document["left_out"]}

    def to_frame(self, table: int = 0) -> pandas.DataFrame:
        """Rows of a table with what the simulation gives for each, before and after, as a pandas.DataFrame."""
        import pandas

        return pandas.DataFrame(self.tables[table]["columns"])


def diagnose(recording: Path, case: Optional[Path] = None, output: Optional[Path] = None,
             progress: Optional[Progress] = None) -> Diagnosis:
    """Diagnoses a recording's folder by reduced laws, or by a case of finite elements as `asperity diagnose --case`.

    output: folder for diagnosis.json, after.csv and report.html; needed with `case`, whose solutions it keeps.
    progress: called with each step. Ctrl-C ends it at the next one.
    """
    if case is None and output is None:
        return Diagnosis(*_native.diagnose(os.fspath(recording), progress))
    if output is None:
        raise _native.InputError("diagnosing by a case needs an output folder, where its solutions are kept; pass output=")
    run(["diagnose", recording, "--output", output, *(["--case", case] if case is not None else [])], progress)
    return Diagnosis(json.loads((pathlib.Path(output) / "diagnosis.json").read_text(encoding="utf-8")),
                     _tables_of(pathlib.Path(output)))


def _tables_of(output: pathlib.Path) -> list[dict[str, Any]]:
    """The files before.csv and after.csv as arrays."""
    import csv

    import numpy

    def rows_of(name: str) -> list[dict[str, str]]:
        with open(output / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def numbers(rows: list[dict[str, str]], name: str) -> Any:
        return numpy.array([float(row[name]) if row[name] else numpy.nan for row in rows])

    before, after = rows_of("before.csv"), rows_of("after.csv")
    tables = []
    for file in dict.fromkeys(row["table"] for row in after):
        rows = [row for row in after if row["table"] == file]
        same = [row for row in before if row["table"] == file]
        simulated = next(name for name in rows[0] if name.startswith("simulated_") and any(row[name] for row in rows))
        response = simulated[len("simulated_"):].split(" [")[0]
        columns = {name.split(" [")[0]: numbers(rows, name) for name in rows[0]
                   if name not in ("table", "segment") and not name.startswith("simulated_") and any(row[name] for row in rows)}
        columns["simulated_before"] = numbers(same, simulated)
        columns["simulated_after"] = numbers(rows, simulated)
        tables.append({"file": file, "response": response, "columns": columns})
    return tables
