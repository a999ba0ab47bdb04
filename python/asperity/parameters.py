"""Parameters of a particle simulation from solved cases."""

from __future__ import annotations

import json
from typing import Any, Iterable, Optional, Union

from .program import Path, Progress, run


def derive(folders: Union[Path, Iterable[Path]], output: Path = "parameters.json",
           progress: Optional[Progress] = None) -> list[dict[str, Any]]:
    """Laws and parameters, one set for each pair of bodies, roughness and interface, as parameters.json holds them.

    folders: that `solve` or `study` wrote, or folders of such. The sets are also written to `output`.
    """
    list_of = [folders] if isinstance(folders, (str, bytes)) or hasattr(folders, "__fspath__") else list(folders)
    found = json.loads(run(["derive", *list_of, "--output", output, "--json"], progress))
    return found if isinstance(found, list) else [found]
