#!/usr/bin/env python3
"""commands_test BUILD [DOCUMENT...] [--as-printed]: runs the commands of README.md and of the tutorials as a reader types them.

Every block ```sh of a document is run, in order, in one folder that looks like a clone. A block ```text behind it shows what it prints:
each line of it must be found, in order, "..." standing for anything and numbers within 2 %. LIGHTER says what is run in place of
commands that take long; what they print, and what is made of their output, is not compared. --as-printed (./run-tests --nightly) runs everything as it is.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCUMENTS = ["README.md", "docs/first_hour.md"] + sorted(
    str(path.relative_to(ROOT)) for path in (ROOT / "docs/tutorials").glob("*.md"))
TOLERANCE = 0.02
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)

COARSE = ("--set 'Mesh/Interface spacing=60 nm' --set 'Mesh/Layers=1' --set 'Experiment/Load steps=2' "
          "--set 'Experiment/Motion steps=3'")
# Rough bodies need four cells over their shortest wave.
SMALL = ("--set 'Mesh/Interface spacing=25 nm' --set 'Mesh/Layers=1' --set 'Experiment/Normal load=20 uN' "
         "--set 'Experiment/Load steps=2' --set 'Experiment/Unload=false' --set 'Output/Fields=false'")
# What is lighter: a part of the command, what follows it every day.
LIGHTER = {
    "./quickstart": None,
    "./run-tests": None,
    "--quick --output characterised": "--plan",
    "lmp -in press.lmp": None,
    "--case contact.prm": None,
    "solve film.prm": COARSE,
    "study loads.prm --output": SMALL + " --set 'Study/Realisations=1'",
    "solve runs/quick/case.prm": SMALL,
}
# Needs what is left out every day.
ONLY_AS_PRINTED = ["characterised/", "by_elements/"]


def blocks(text):
    """(kind, text) of the fenced blocks of a page that are commands or what they print."""
    return [(kind, body) for kind, body in FENCE.findall(text) if kind in ("sh", "text")]


def lines_of(script):
    """The commands of a block: lines, joined where they go on behind a backslash or inside of a here-document."""
    commands, end = [], None
    for line in script.splitlines():
        if end is not None:
            commands[-1] += "\n" + line
            end = None if line == end else end
        elif commands and commands[-1].endswith("\\"):
            commands[-1] = commands[-1][:-1] + line.lstrip()
        elif line.strip():
            commands.append(line)
        here = re.search(r"<<'(\w+)'$", line)
        if here:
            end = here.group(1)
    return commands


def lighter(command):
    """The command that is run every day, empty if none is, and whether it is another one."""
    if any(part in command for part in ONLY_AS_PRINTED) and "<<" not in command:
        return "", True
    for part, added in LIGHTER.items():
        if part in command:
            code = re.sub(r"\s+#.*$", "", command)
            return ("" if added is None else f"{code} {added}"), True
    return command, False


def output_of(command):
    """The name behind --output; empty if there is none."""
    found = re.search(r"--output (\S+)", command)
    return found.group(1) if found else ""


def agrees(shown, printed):
    """Whether a shown line is the printed one: "..." stands for anything, numbers agree within the tolerance."""
    place = 0
    for part in (p.strip() for p in shown.split("...")):
        if not part:
            continue
        pattern = r"\s+".join(re.escape(NUMBER.sub("\0", word)) for word in part.split())
        pattern = pattern.replace(r"\x00", "\0").replace("\\\0", "\0").replace("\0", f"({NUMBER.pattern})")
        for found in re.compile(pattern).finditer(printed, place):
            wanted = [float(n) for n in NUMBER.findall(part)]
            if all(abs(float(a) - b) <= TOLERANCE * abs(b) + 1e-300 for a, b in zip(found.groups(), wanted)):
                place = found.end()
                break
        else:
            return False
    return True


def missing(shown, printed):
    """The first shown line that the output lacks behind those before it; None if all are there."""
    rest = iter(printed.splitlines())
    for line in shown.splitlines():
        if line.strip() in ("", "..."):
            continue
        if not any(agrees(line, candidate) for candidate in rest):
            return line
    return None


class Clone:
    """A folder with what the documents take from a clone, and the programs that were built."""

    def __init__(self, build, folder):
        self.build, self.folder = build, pathlib.Path(folder)
        (self.folder / "build").mkdir()
        for name in ("asperity", "asperity-solver"):
            (self.folder / "build" / name).symlink_to(build / name)
        for name in ("runs", "docs", "benchmarks"):
            (self.folder / name).symlink_to(ROOT / name)
        (self.folder / "fem/interface/friction").mkdir(parents=True)

    def link_own_laws(self):
        """In place of `ninja -C build asperity`: the same programs with the laws written into this folder, beside the build."""
        laws = sorted((self.folder / "fem/interface/friction").glob("*.h"))
        source = self.folder / "own_laws.cc"
        source.write_text("".join(f'#include "{law}"\n' for law in laws))

        def commands(target):
            said = subprocess.run(["ninja", "-C", self.build, "-t", "commands", target], capture_output=True, text=True, check=True)
            return said.stdout.splitlines()

        compiler = next(c for c in commands("fem/interface/libasperity_fem_interface.a") if c.endswith("friction_law.cc"))
        flags = re.sub(r" -MD .*", "", re.sub(r"^.*?ccache ", "", compiler))
        own = source.with_suffix(".o")
        subprocess.run(f"{flags} -c {source} -o {own}", shell=True, cwd=self.build, check=True)
        for name in ("asperity", "asperity-solver"):
            link = re.search(r": && (.*) && :$", commands(name)[-1]).group(1)
            program = self.folder / "build" / name
            program.unlink()
            subprocess.run(link.replace(f" -o {name} ", f" {own} -o {program} "), shell=True, cwd=self.build, check=True)

    def run(self, command):
        """Exit status and output."""
        if command.startswith("ninja -C build"):
            self.link_own_laws()
            return 0, ""
        environment = {**os.environ, "HWLOC_COMPONENTS": "-gl", "OMP_WAIT_POLICY": "passive"}
        done = subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout


def run_document(build, name, as_printed):
    """Runs one document; the sentences of what went wrong."""
    faults, printed, other = [], None, set()
    with tempfile.TemporaryDirectory() as folder:
        clone = Clone(build, folder)
        for kind, body in blocks((ROOT / name).read_text()):
            if kind == "text":
                lacking = missing(body, printed) if printed is not None else None
                if lacking is not None:
                    faults.append(f"{name}: shown, but not printed: {lacking}\n{printed}")
                continue
            printed = ""
            for command in lines_of(body):
                code, changed = (command, False) if as_printed and not command.startswith("./") else lighter(command)
                start = time.time()
                status, output = clone.run(code) if code else (0, "")
                first = command.splitlines()[0]
                print(f"{time.time() - start:6.1f} s  {first}{'' if not changed else '  (left out)' if not code else '  (lighter)'}", flush=True)
                if status:
                    return faults + [f"{name}: exit status {status}: {code}\n{output}"]
                if changed and output_of(command):
                    other.add(output_of(command))
                changed = changed or any(name in command for name in other)
                printed = None if changed or printed is None else printed + output
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("documents", nargs="*")
    parser.add_argument("--as-printed", action="store_true")
    arguments = parser.parse_intermixed_args()
    faults = []
    for name in arguments.documents or DOCUMENTS:
        found = blocks((ROOT / name).read_text())
        if not any(kind == "sh" for kind, _ in found):
            faults.append(f"{name}: no block ```sh, so nothing of it is tested")
        faults += run_document(arguments.build.resolve(), name, arguments.as_printed)
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
