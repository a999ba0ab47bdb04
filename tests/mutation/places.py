"""Where a line of C++ can be changed a little, and how: each place gives (operator, original, mutated) parts of one line."""

import re

# Folders that are mutated: how many of 100 mutants each gets, and the test programs that could notice a change in it.
FOLDERS = {
    "core": (9, "core results surfaces dem_compare diagnosis"),
    "results": (3, "results dem_compare"),
    "surfaces": (18, "surfaces half_space"),
    "half_space": (5, "half_space"),
    "engines": (6, "engines dem_compare"),
    "dem_compare/laws": (12, "dem_compare diagnosis"),
    "dem_compare/motion": (2, "dem_compare"),
    "dem_compare/experiments": (3, "dem_compare"),
    "dem_compare/numbers": (2, "dem_compare"),
    "dem_compare/cases": (5, "dem_compare paper"),
    "dem_compare/derive": (5, "dem_compare"),
    "dem_compare/characterise": (1, "dem_compare"),
    "dem_compare/compare": (3, "dem_compare"),
    "dem_compare/resistance": (2, "dem_compare"),
    "paper": (4, "paper"),
    "diagnosis": (16, "diagnosis"),
    "fem/materials": (2, "fem_laws"),
    "fem/interface": (2, "fem_laws"),
}
QUOTAS = {folder: quota for folder, (quota, _) in FOLDERS.items()}
TRIED = {folder: [f"{name}_tests" for name in names.split()] for folder, (_, names) in FOLDERS.items()}
# What is not mutated, and why.
DEAL_II = "needs deal.II: a copy that is compiled twice takes an hour"
LEFT_OUT = {**{f"fem/{part}": DEAL_II for part in "cells levels mortar solver contact programs case output experiments".split()},
            "fem": DEAL_II, "meshing": DEAL_II, "report": "sentences and pictures, and VTK", "app": "the command line, which links fem",
            "python": "hands over what other rooms compute"}
WORDS = re.compile(r"(_text|_manual|describe|sentences)\.cc$")
# Signals to processes: with a changed sign they would end others than their own.
DANGEROUS = ("core/child_process.cc",)

SKIPPED_LINE = re.compile(r"^\s*(#|//|\*|template|using|case |default:|static_assert|namespace|typedef|return \"|throw )|constexpr|operator|asperity_mutant|\bnoexcept\b")
SWAPS = [("plus and minus", " + ", " - "), ("plus and minus", " - ", " + "), ("times and over", " * ", " / "), ("times and over", " / ", " * "),
         ("comparison turned", " < ", " > "), ("comparison turned", " > ", " < "), ("comparison turned", " <= ", " > "),
         ("comparison turned", " >= ", " < "), ("boundary", " < ", " <= "), ("boundary", " > ", " >= "), ("boundary", " <= ", " < "),
         ("boundary", " >= ", " > "), ("and, or", " && ", " || "), ("and, or", " || ", " && "),
         ("equal", " == ", " != "), ("equal", " != ", " == ")]
CALLS = [("root dropped", "std::sqrt(", "("), ("root dropped", "std::cbrt(", "("), ("absolute dropped", "std::abs(", "("),
         ("smallest and largest", "std::min(", "std::max("), ("smallest and largest", "std::max(", "std::min(")]
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d*(?![\w.])")
INTEGER = re.compile(r"(?<=[*/+-] )([2-9]|\d\d+)(?![\w.])|(?<![\w.\[])([2-9]|\d\d+)(?= [*/+-] )")
SIGN = re.compile(r"(?<=[(=,] )-(?=[A-Za-z(])|(?<=\()-(?=[A-Za-z(])|(?<=return )-(?=[A-Za-z(])")


def unnamed(root):
    """What the two lists above do not say of the folders that the build compiles, a sentence each; none if they say all."""
    rooms = set(re.findall(r"add_subdirectory\((\w+)\)", (root / "CMakeLists.txt").read_text())) - {"tests", "benchmarks"}
    known = set(FOLDERS) | set(LEFT_OUT)
    folders = {path.parent.relative_to(root) for room in rooms for path in (root / room).rglob("*") if path.suffix in (".cc", ".h")}
    for folder in sorted(folders):
        # "fem" stands for its own files alone: a new part of it is to be named.
        if not known & {str(folder), *(str(above) for above in folder.parents if str(above) != "fem")}:
            yield f"{folder} has code, but neither FOLDERS nor LEFT_OUT names it"
    for name in sorted(known):
        if not any(folder.is_relative_to(name) for folder in folders):
            yield f"{name} is named, but no room of the build has code there"


def blanked(line):
    """The line with strings, characters and its comment replaced by blanks of the same length."""
    line = re.sub(r"\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])'", lambda m: '"' + " " * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*", lambda m: " " * len(m.group(0)), line)


def closing(code, opening):
    """Index of the bracket that closes the one at `opening`; None if it is on another line."""
    depth = 0
    for i in range(opening, len(code)):
        depth += code[i] in "([{"
        depth -= code[i] in ")]}"
        if depth == 0:
            return i
    return None


def is_assignment(code, i):
    return code[i] == "=" and code[i + 1:i + 2] != "=" and code[i - 1] not in "=!<>"


def expression_around(code, begin, end):
    """Ends of the whole expression that holds code[begin:end]; None if it may go on in another line or is none."""
    depth, left = 0, begin
    while left > 0:
        c = code[left - 1]
        if c in ")]}":
            depth += 1
        elif c in "([{":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0:
            if c in ",;?" or is_assignment(code, left - 1) or (c == ":" and code[left - 2:left] != "::" and code[left:left + 1] != ":"):
                break
            if re.search(r"\breturn $", code[:left]):
                break
        left -= 1
    else:
        return None
    depth, right = 0, end
    while right < len(code):
        c = code[right]
        if c in "([{":
            if depth == 0 and c == "{":
                return None
            depth += 1
        elif c in ")]}":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0 and (c in ",;?" or (c == ":" and "::" not in code[right - 1:right + 2])):
            break
        right += 1
    else:
        return None
    left += len(code[left:right]) - len(code[left:right].lstrip())
    return left, right


def places_in(line):
    """(operator, begin, end, mutated text) of every place: line[begin:end] is an expression that may be put in brackets."""
    if SKIPPED_LINE.search(line):
        return
    code = blanked(line)
    in_for = re.match(r"\s*for \(", code)
    for operator, token, other in SWAPS:
        for m in re.finditer(re.escape(token), code):
            if in_for and operator in ("boundary", "comparison turned"):
                continue
            if operator == "boundary" and not re.match(r"[\w.]*\d", code[m.end():]) and ".size()" not in code:
                continue  # between numbers that are never equal it changes nothing
            found = expression_around(code, m.start(), m.end())
            if found and not (operator == "plus and minus" and '"' in code[found[0]:found[1]]):  # words are put together
                begin, end = found
                yield operator, begin, end, line[begin:m.start()] + other + line[m.end():end]
    for operator, call, other in CALLS:
        for m in re.finditer(re.escape(call), code):
            end = closing(code, m.end() - 1)
            if end is not None:
                yield operator, m.start(), end + 1, other + line[m.end():end + 1]
    for m in DECIMAL.finditer(code):
        if float(m.group(0)) != 0:
            yield "constant times 1.29", m.start(), m.end(), repr(float(m.group(0)) * 1.29)
    for m in INTEGER.finditer(code):
        yield "integer plus one", m.start(), m.end(), str(int(m.group(0)) + 1)
    for m in SIGN.finditer(code):
        found = expression_around(code, m.start(), m.end())
        if found:
            yield "sign dropped", found[0], found[1], line[found[0]:m.start()] + line[m.end():found[1]]


def schema(line, number, begin, end, mutated):
    """The line with both, chosen when it runs."""
    return f"{line[:begin]}(asperity_mutant({number}) ? ({mutated}) : ({line[begin:end]})){line[end:]}"
