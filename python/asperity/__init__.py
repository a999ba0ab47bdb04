"""What a rough micro-contact does, by finite elements, and what a particle (DEM) simulation needs of it.

Lengths are in m, forces in N, pressures in Pa throughout. Errors are `InputError` (a ValueError: what was asked for is
refused, in one sentence with the remedy) and `WorkError` (a RuntimeError: the work failed).
"""

from ._native import InputError, Preview, Surface, WorkError
from .cases import Case, History, read_case, solve, study
from .diagnosis import Diagnosis, diagnose
from .half_spaces import preview
from .parameters import derive
from .program import run, version
from .surfaces import generate_surface, measure_surface, read_surface, surface, write_surface

__all__ = ["Case", "Diagnosis", "History", "InputError", "Preview", "Surface", "WorkError", "derive", "diagnose",
           "generate_surface", "measure_surface", "preview", "read_case", "read_surface", "run", "solve", "study", "surface",
           "version", "write_surface"]
__version__ = version()
