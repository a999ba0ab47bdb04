"""The declarations of a C++ file with their docstrings, by its text alone; formatted as .clang-format says."""

import re

TYPE = re.compile(r"^(?:class|struct|enum(?:\s+class|\s+struct)?|union)\s+(?:\[\[.*?\]\]\s*)?(?:alignas\([^)]*\)\s*)?([\w:<>, *]+?)\s*(?:final\s*)?(?::[^:].*)?$", re.S)
WORD = re.compile(r"(?:operator\s*\S+|~?[A-Za-z_]\w*(?:::~?[A-Za-z_]\w*)*)$")


class Source:
    """A file with comments, strings and directives blanked out, and its comments by line."""

    def __init__(self, text):
        self.lines = text.split("\n")
        self.above, self.behind, self.plain = {}, {}, set()
        out, i, n = list(text), 0, len(text)
        line = 1

        def blank(start, end):
            for k in range(start, end):
                if out[k] != "\n":
                    out[k] = " "

        while i < n:
            c, two = text[i], text[i:i + 2]
            if c == "\n":
                line += 1
                i += 1
            elif two == "//":
                end = text.find("\n", i)
                end = n if end < 0 else end
                comment = text[i:end]
                if comment.startswith("///<"):
                    self.behind[line] = comment[4:].strip()
                elif comment.startswith("///"):
                    self.above[line] = comment[3:].strip()
                else:
                    self.plain.add(line)
                blank(i, end)
                i = end
            elif two == "/*":
                end = text.find("*/", i) + 2
                line += text.count("\n", i, end)
                blank(i, end)
                i = end
            elif c == "R" and text[i:i + 2] == 'R"' and (i == 0 or not (text[i - 1].isalnum() or text[i - 1] == "_")):
                mark = text[i + 2:text.index("(", i)]
                end = text.index(")" + mark + '"', i) + len(mark) + 2
                line += text.count("\n", i, end)
                blank(i + 1, end)
                out[i] = '"'
                i = end
            elif c == '"' or (c == "'" and not (i and (text[i - 1].isalnum()))):
                end = i + 1
                while text[end] != c:
                    end += 2 if text[end] == "\\" else 1
                blank(i + 1, end)
                i = end + 1
            elif c == "#" and not text[text.rfind("\n", 0, i) + 1:i].strip():
                end = i
                while True:
                    stop = text.find("\n", end)
                    stop = n if stop < 0 else stop
                    if stop < n and text[stop - 1] == "\\":
                        end = stop + 1
                        continue
                    break
                # A comment behind a directive is none of a declaration's.
                line += text.count("\n", i, stop)
                blank(i, stop)
                i = stop
            else:
                i += 1
        self.code = "".join(out)

    def line_of(self, place):
        return self.code.count("\n", 0, place) + 1


def closing(code, opening):
    """Place of the brace that closes the one at `opening`."""
    depth = 0
    for place in range(opening, len(code)):
        if code[place] == "{":
            depth += 1
        elif code[place] == "}":
            depth -= 1
            if depth == 0:
                return place
    return len(code) - 1


def end_of_head(code, start, stop):
    """Place of the ';' or '{' at which a declaration's head ends."""
    depth = 0
    for place in range(start, stop):
        c = code[place]
        if c in "([":
            depth += 1
        elif c in ")]":
            depth -= 1
        elif c == "{" and depth > 0:
            depth += 1
        elif c == "}" and depth > 0:
            depth -= 1
        elif c in ";{" and depth == 0:
            return place
    return stop


def without_template(head):
    while True:
        begun = re.match(r"template\s*<", head)
        if not begun:
            return head
        depth, place = 1, begun.end()
        while depth and place < len(head):
            depth += {"<": 1, ">": -1}.get(head[place], 0)
            place += 1
        head = head[place:].strip()


class Declaration:
    def __init__(self, source, kind, name, head, first, last, owner, body=""):
        self.kind, self.name, self.head, self.owner, self.body = kind, name, head, owner, body
        self.first, self.last = first, last
        self.own, self.group = "", ""
        self.members = []
        self.is_held = False
        at = first - 1
        above = []
        while at in source.above:
            above.insert(0, source.above[at])
            at -= 1
        self.above = " ".join(above)
        behind = [source.behind[n] for n in range(first, last + 1) if n in source.behind] if kind != "type" else []
        if kind == "type":
            behind = [source.behind[n] for n in (first, last) if n in source.behind]
        at = last + 1
        while at in source.behind and not source.code.split("\n")[at - 1].strip():
            behind.append(source.behind[at])
            at += 1
        self.after = at  # the first line behind it
        self.own = (self.above + " " + " ".join(behind)).strip()

    def doc(self):
        return (self.own + " " + self.group).strip()


def name_of_function(head):
    """(name, parameters) of a function's head; ("", "") if it is none."""
    depth = 0
    for place, c in enumerate(head):
        if c == "<" and not head[:place].rstrip().endswith("operator"):
            depth += 1
        elif c == ">" and depth:
            depth -= 1
        elif c == "=" and depth == 0 and not re.search(r"operator\s*[=!<>+*/-]*$", head[:place]):
            return "", ""
        elif c == "(" and depth == 0:
            before = head[:place].rstrip()
            if before.endswith("operator"):
                return "operator()", ""
            if re.match(r"\(\s*\*", head[place:]):  # a pointer to a function
                return "", ""
            word = WORD.search(before)
            if not word or word.group() in ("decltype", "alignas", "noexcept", "__attribute__"):
                continue
            level, end = 0, place
            for end in range(place, len(head)):
                level += {"(": 1, ")": -1}.get(head[end], 0)
                if level == 0:
                    break
            return word.group(), head[place + 1:end]
    return "", ""


def scan(source, start, stop, owner, found, access="public"):
    """Appends the declarations between two places to `found`."""
    code = source.code
    place, before = start, None
    while place < stop:
        while place < stop and (code[place].isspace() or code[place] in ";}"):
            place += 1
        if place >= stop:
            return
        label = re.compile(r"(public|private|protected)\s*:(?!:)").match(code, place)
        if owner and label:
            access, place, before = label.group(1), label.end(), None
            continue
        end = end_of_head(code, place, stop)
        raw = code[place:end]
        first = source.line_of(place)
        head = re.sub(r"\[\[[^\]]*\]\]", "", without_template(raw.strip())).strip()
        declaration = None
        if end < stop and code[end] == "{":
            close = closing(code, end)
            if re.match(r"(inline\s+)?namespace\b|extern\s*\"", head):
                scan(source, end + 1, close, owner, found)
                place = close + 1
                continue
            kind_match = TYPE.match(head)
            if kind_match and "(" not in re.sub(r"alignas\([^)]*\)", "", head):
                after = end_of_head(code, close + 1, stop)
                declaration = Declaration(source, "type", kind_match.group(1).split("::")[-1].strip(), head, first,
                                          source.line_of(after), owner)
                if head.startswith("enum"):
                    declaration.kind = "enum"
                    lines = range(first, source.line_of(close) + 1)
                    said = [source.behind[n] for n in lines if n in source.behind] + [source.above[n] for n in lines if n in source.above]
                    declaration.own = (declaration.own + " " + " ".join(said)).strip()
                elif access == "public":
                    scan(source, end + 1, close, declaration, declaration.members,
                         "private" if head.startswith("class") else "public")
                place = after + 1
            else:
                name, parameters = name_of_function(head)
                if name:
                    while True:
                        rest = re.compile(r"\s*([,{])").match(code, close + 1)
                        if not rest or not re.search(r"\)\s*(noexcept\s*)?:[^:]", head):
                            break
                        close = closing(code, code.index("{", close + 1))
                        end = code.rindex("{", 0, close) if rest.group(1) == "{" else end
                    declaration = Declaration(source, "function", name, head, first, source.line_of(close), owner,
                                              code[end + 1:close])
                    declaration.parameters = parameters
                    place = close + 1
                else:
                    after = end_of_head(code, close + 1, stop)
                    declaration = Declaration(source, "variable", "", head, first, source.line_of(after), owner)
                    place = after + 1
        else:
            last = source.line_of(min(end, stop - 1))
            place = end + 1
            skipped = re.match(r"(using|typedef|friend|static_assert|extern\s+template|class\s+\w+$|struct\s+\w+$|enum\s+class\s+\w+$)\b", head)
            name, parameters = name_of_function(head)
            if skipped or not head:
                declaration = Declaration(source, "skipped", "", head, first, last, owner)
            elif name and re.match(r"^[A-Z_]+$", name):
                declaration = Declaration(source, "skipped", "", head, first, last, owner)
            elif name:
                declaration = Declaration(source, "function", name, head, first, last, owner)
                declaration.parameters = parameters
            else:
                declaration = Declaration(source, "variable", "", head, first, last, owner)
        # One that stands above a group stands for all of it.
        if before is not None and before.after == declaration.first and not declaration.above:
            declaration.group = before.above or before.group
        declaration.access = access
        before = declaration
        found.append(declaration)
