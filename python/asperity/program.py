"""The program `asperity`, which this module starts for what takes long: it runs in processes of its own."""

from __future__ import annotations

import os
import pathlib
import shutil
import signal
import subprocess
import threading
from typing import IO, Callable, Mapping, Optional, Sequence, Union

from ._native import InputError, WorkError

Path = Union[str, "os.PathLike[str]"]
#: Called with each line that the program prints.
Progress = Callable[[str], None]
#: Entries of a case, "Section/Entry" and value: {"Experiment/Normal load": "100 uN"}.
Changes = Mapping[str, object]

_REFUSED = 2


def program() -> str:
    """Path of the program: $ASPERITY_PROGRAM, that of the build or installation this module is of, or that on $PATH."""
    here = pathlib.Path(__file__).resolve().parent
    candidates = [here.parent.parent / "asperity"] + [parent / "bin" / "asperity" for parent in here.parents]
    for candidate in [os.environ.get("ASPERITY_PROGRAM"), *candidates, shutil.which("asperity")]:
        if candidate and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            return str(candidate)
    raise WorkError("the program asperity was not found; name it in the environment variable ASPERITY_PROGRAM")


def changes_as_arguments(changes: Optional[Changes]) -> list[str]:
    """As the program's --set takes them."""
    return [text for entry, value in (changes or {}).items() for text in ("--set", f"{entry}={value}")]


def run(arguments: Sequence[object], progress: Optional[Progress] = None) -> str:
    """Runs `asperity ARGUMENTS` and returns what it printed (its standard output).

    progress: called with each line as it comes, notes and warnings included. Ctrl-C stops the program as in a terminal; what it solved is kept.
    Raises InputError or WorkError with the program's own sentence.
    """
    command = [program(), *[os.fspath(a) if isinstance(a, os.PathLike) else str(a) for a in arguments]]
    # In a session of its own the program hears of Ctrl-C once, from here.
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               errors="replace", start_new_session=True)
    printed: list[str] = []
    said: list[str] = []
    reader = threading.Thread(target=_collect, args=(process.stderr, said, progress), daemon=True)
    reader.start()
    with process:
        try:
            _collect(process.stdout, printed, progress)
            status = process.wait()
        except BaseException:
            _stop(process)
            raise
        finally:
            reader.join()
    if status == 0:
        return "".join(printed)
    sentence = next((line.strip() for line in reversed(printed + said) if line.strip()), f"asperity ended with status {status}")
    raise (InputError if status == _REFUSED else WorkError)(sentence)


def _collect(stream: Optional[IO[str]], lines: list[str], progress: Optional[Progress]) -> None:
    """Keeps the lines of a stream and tells of each."""
    for line in stream or ():
        lines.append(line)
        if progress is not None:
            progress(line.rstrip("\n"))


def _stop(process: subprocess.Popen[str]) -> None:
    """Asks the program and those it started to end, and sees to it that they do."""
    patience = 10
    for number in (signal.SIGINT, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            pass
        try:
            process.wait(timeout=patience)
            break
        except subprocess.TimeoutExpired:
            continue


def version() -> str:
    """Version of the program."""
    words = run(["--version"]).split()
    return words[1].rstrip(",") if len(words) > 1 else ""
