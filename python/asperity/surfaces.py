"""Topographies."""

from __future__ import annotations

import os
from typing import Any, Optional

from . import _native
from ._native import Surface
from .program import Path


def read_surface(path: Path, width: Optional[float] = None, height: Optional[float] = None, channel: Optional[str] = None,
                 height_unit: Optional[str] = None) -> Surface:
    """A scan in any of the formats of docs/surfaces.md.

    width, height: physical size [m], where the file does not state it. channel: name or number. height_unit: of a text file
    that names none. Raises InputError.
    """
    return _native.read_surface(os.fspath(path), width, height, channel, height_unit)


def generate_surface(rms: float, size: float, pixels: int, hurst: float = 0.8, rolloff: Optional[float] = None,
                     cutoff: Optional[float] = None, seed: int = 1) -> Surface:
    """A periodic Gaussian surface of RMS height `rms` [m] on `pixels` x `pixels`, of side `size` [m].

    Its spectrum is flat down to the wavelength `rolloff` [m], falls as q^(-2-2 hurst) down to `cutoff` [m] and ends there.
    Not given: a cut-off of 20 nm or four pixels, a roll-off of 200 nm or ten cut-offs, whichever is longer. Raises InputError.
    """
    return _native.generate_surface(rms, size, pixels, hurst, rolloff, cutoff, seed)


def surface(entry: str) -> Surface:
    """The surface that a case's entry `Topography` stands for: "generated(rms=1.5 nm, seed=3)", a scan's file."""
    return _native.surface_of_entry(entry)


def write_surface(path: Path, of: Surface) -> None:
    """Writes a Gwyddion Simple Field (.gsf), 32-bit heights in m."""
    _native.write_surface(os.fspath(path), of)


def measure_surface(of: Surface, level: str = "plane") -> dict[str, Any]:
    """Heights, slopes, correlation and spectrum as `asperity surface measure --json` gives them, in SI units.

    level: "mean", "plane", "quadratic", "rows0", "rows1" or "rows2" is taken off first.
    """
    return _native.measure_surface(of, level)
