"""Cases by finite elements: solving them, and what a solved one says."""

from __future__ import annotations

import csv
import math
import os
import pathlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Optional

from . import _native
from .program import Changes, Path, Progress, changes_as_arguments, run

if TYPE_CHECKING:
    import numpy
    import pandas


@dataclass(frozen=True)
class Number:
    """A number with its standard deviation (NaN: not stated) and unit."""

    value: float
    sd: float
    unit: str


class History:
    """Columns of a solved case, a row for each accepted step; names carry their units."""

    def __init__(self, native: Any) -> None:
        self._native = native

    @property
    def names(self) -> list[str]:
        """"normal_force [N]", ..."""
        return self._native.names

    def __getitem__(self, name: str) -> numpy.ndarray[Any, Any]:
        """A column by its name, with or without unit: a read-only view."""
        return self._native.column(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        """Accepted steps."""
        return len(self["normal_force"])

    def to_frame(self) -> pandas.DataFrame:
        """All columns as a pandas.DataFrame."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in self.names})


class Case:
    """What `asperity solve` left in a folder."""

    def __init__(self, folder: Path) -> None:
        self._native = _native.read_case(os.fspath(folder))
        self.folder = pathlib.Path(folder)
        self.history = History(self._native)

    @property
    def title(self) -> str:
        """That of the case file."""
        return self._native.title

    @property
    def finished(self) -> bool:
        """False: broken off or still being solved; the history is as far as it came."""
        return self._native.finished

    @property
    def entries(self) -> dict[str, str]:
        """"Particle/Radius" -> "8.5 um", ..."""
        return self._native.entries

    @property
    def result(self) -> Optional[dict[str, Any]]:
        """result.json (docs/result.md); None as long as the case is not finished."""
        return self._native.document

    @property
    def effective(self) -> dict[str, Number]:
        """The numbers that a particle simulation needs, such as effective["normal_stiffness"].value."""
        if self.result is None:
            return {}
        return {name: Number(n["value"] if n["value"] is not None else math.nan,
                             n["sd"] if n.get("sd") is not None else math.nan, n.get("unit", ""))
                for name, n in self.result["effective"].items() if isinstance(n, dict) and "value" in n}

    def __repr__(self) -> str:
        return f"<asperity.Case {self.folder}: {len(self.history)} steps, {'finished' if self.finished else 'not finished'}>"


def read_case(folder: Path) -> Case:
    """A folder that `asperity solve` wrote or is writing. Raises InputError."""
    return Case(folder)


def solve(case: Path, output: Path, changes: Optional[Changes] = None, resume: bool = False, overwrite: bool = False,
          progress: Optional[Progress] = None) -> Case:
    """Solves a case file into the folder `output`.

    changes: entries in place of the file's. resume: goes on after the last accepted step of a solution that was broken off.
    overwrite: begins anew. progress: called with each line of progress.
    """
    options = (["--resume"] if resume else []) + (["--overwrite"] if overwrite else [])
    run(["solve", case, "--output", output, *changes_as_arguments(changes), *options], progress)
    return Case(output)


def study(file: Path, output: Path, changes: Optional[Changes] = None, resume: bool = False,
          progress: Optional[Progress] = None) -> dict[str, Case]:
    """Solves all cases of a study file, several at a time, and returns those that are finished by the names of their folders."""
    run(["study", file, "--output", output, *changes_as_arguments(changes), *(["--resume"] if resume else [])], progress)
    with open(pathlib.Path(output) / "study.csv", newline="", encoding="utf-8") as table:
        names = [row["case"] for row in csv.DictReader(line for line in table if not line.startswith("#"))]
    cases = {name: Case(pathlib.Path(output) / name) for name in names}
    return {name: case for name, case in cases.items() if case.finished}
