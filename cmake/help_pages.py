#!/usr/bin/env python3
"""help_pages.py PROGRAM FOLDER: manual pages and bash completion from what the program's --help says.

Writes FOLDER/man/asperity.1.gz, one page for each subcommand, and FOLDER/bash-completion/asperity.
"""

import gzip
import pathlib
import re
import subprocess
import sys

PARAGRAPH = ".PP\n"
COLUMN = 28


def help_of(program, words):
    return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout


def parts_of(text):
    """What it says first, its usage, its sections as (title, entries or lines), and what it says last."""
    lines = text.rstrip().splitlines()
    usage = next(i for i, line in enumerate(lines) if line.startswith("Usage: "))
    sections, last = [], []
    for line in lines[usage + 1:]:
        if re.match(r"^\[?[A-Z][\w ]*\]?:$", line):
            sections.append((line.rstrip(":").strip("[]"), []))
            last = []
        elif line.startswith("  ") and sections:
            sections[-1][1].append(line[2:])
        elif line.strip():
            last.append(line.strip())
    return " ".join(line.strip() for line in lines[:usage] if line.strip()), lines[usage][len("Usage: "):], sections, last


def entries_of(lines):
    """Names and explanations of options and subcommands; what stands further in goes on the one before."""
    entries = []
    for line in lines:
        # Explanations begin in one column; a name that is longer stands alone.
        name, says = (line[:COLUMN], line[COLUMN:]) if line[COLUMN - 1:COLUMN] == " " else (line, "")
        name = name.strip()
        if line.startswith(" "):
            if entries:
                entries[-1][1] = (entries[-1][1] + " " + line.strip()).strip()
        else:
            entries.append([name, says.strip()])
    return entries


def escaped(text):
    """As groff prints it."""
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def page(words, text, version):
    about, usage, sections, last = parts_of(text)
    name = "-".join(words)
    lines = [f'.TH "{name.upper()}" 1 "" "{version}" "asperity"', ".SH NAME", f"{escaped(name)} \\- {escaped(about)}", ".SH SYNOPSIS",
             f".B {escaped(usage)}"]
    for title, of_section in sections:
        lines.append(f".SH {title.upper()}")
        for entry, says in entries_of(of_section):
            lines += [".TP", f".B {escaped(entry)}", escaped(says) or "\\&"]
    if last:
        lines.append(".SH NOTES")
        lines += [PARAGRAPH + escaped(line) for line in last]
    return "\n".join(lines) + "\n"


def subcommands_of(text):
    for title, lines in parts_of(text)[2]:
        if title == "Subcommands":
            return [name for name, _ in entries_of(lines)]
    return []


def options_of(text):
    names = []
    for title, lines in parts_of(text)[2]:
        if title == "Options":
            for entry, _ in entries_of(lines):
                names += re.findall(r"(?<![\w-])--?[a-z][\w-]*", entry.split(" Excludes:")[0])
    return sorted(set(names))


def all_helps(program, words=()):
    text = help_of(program, words)
    yield ("asperity", *words), text
    for name in subcommands_of(text):
        yield from all_helps(program, (*words, name))


def completion(helps):
    """A function that offers subcommands, options of the one that is typed, and files."""
    cases = []
    for words, text in helps:
        offered = " ".join([*subcommands_of(text), *options_of(text)])
        cases.append(f"    '{' '.join(words[1:])}') offered='{offered}' ;;")
    return "\n".join(["# bash completion of asperity, made from its --help", "_asperity() {",
                      "  local current=${COMP_WORDS[COMP_CWORD]} typed='' word offered=''",
                      "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do", "    case \"$typed $word\" in",
                      *[f"      ' {words[1]}') typed='{words[1]}' ;;" if len(words) == 2 else
                        f"      '{' '.join(words[1:])}') typed='{' '.join(words[1:])}' ;;" for words, _ in helps if len(words) > 1],
                      "    esac", "  done", "  case \"$typed\" in", *cases, "  esac",
                      "  COMPREPLY=($(compgen -W \"$offered\" -- \"$current\"))", "}",
                      "complete -o default -F _asperity asperity", ""])


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    helps = list(all_helps(program))
    (folder / "man").mkdir(parents=True, exist_ok=True)
    (folder / "bash-completion").mkdir(exist_ok=True)
    for words, text in helps:
        with gzip.GzipFile(folder / "man" / ("-".join(words) + ".1.gz"), "wb", 9, mtime=0) as file:
            file.write(page(words, text, version.split(",")[0]).encode())
    (folder / "bash-completion" / "asperity").write_text(completion(helps), encoding="utf-8")


if __name__ == "__main__":
    main()
