"""The normal contact of a case in seconds."""

from __future__ import annotations

import math
import os
from typing import Optional

from . import _native
from ._native import Preview
from .program import Changes, Path


def preview(case: Path, changes: Optional[Changes] = None, hardness: float = math.inf) -> Preview:
    """Stiffness, real area and pressure of a case file's elastic half-spaces, each with the error of its spacing.

    changes: entries in place of the file's. hardness: largest pressure [Pa] of bodies that yield.
    """
    return _native.preview(os.fspath(case), [f"{entry}={value}" for entry, value in (changes or {}).items()], hardness)
