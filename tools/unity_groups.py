#!/usr/bin/env python3
"""Group the sources of a module so that each group compiles as one file.

usage: unity_groups.py ROOT FILE...     prints one line per group: GROUP FILE, for each file

Headers that a group shares are read and their templates are compiled once. Two files can be
together when no name of the unnamed namespaces of one is a word of the other, or is declared in a
header that only the other includes, so that nothing has to be renamed for the sake of it; what
GoogleTest declares by TEST is told by suite and name. A file that defines a macro stays alone.
Files that include the same heavy libraries are put together first. A group holds at most
MOST_BYTES of sources.
"""
import pathlib
import re
import sys

MOST_BYTES = 48_000
COMMENT_OR_TEXT = re.compile(
    r'R"(\w*)\((?:.|\n)*?\)\1"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'')
DIRECTIVE = re.compile(r"^[ \t]*#.*$", re.MULTILINE)
MACRO = re.compile(r"^[ \t]*#[ \t]*define\b", re.MULTILINE)
WORD = re.compile(r"\b[A-Za-z_]\w*\b")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
HEAVY = re.compile(r'#\s*include\s*[<"](CGAL|nlohmann|vtk|toml\+\+|CLI|tbb)')


def code_of(text):
    """The text without comments, literals and directives."""
    return DIRECTIVE.sub("", COMMENT_OR_TEXT.sub(" ", text))


def declarations(code):
    """What stands in the namespaces of `code`, without the bodies of functions and types: pairs of
    whether the namespace is an unnamed one, and the text."""
    parts, scopes, statement = [], [], ""
    outside = {"namespace", "unnamed"}
    for c in code:
        if c == "{":
            head = statement.split()
            if head and head[-1] == "namespace":
                scopes.append("unnamed")
            elif len(head) > 1 and head[-2] == "namespace":
                scopes.append("namespace")
            else:
                if set(scopes) <= outside:
                    parts.append(("unnamed" in scopes, statement))
                scopes.append("body")
            statement = ""
        elif c in ";}":
            if c == ";" and set(scopes) <= outside:
                parts.append(("unnamed" in scopes, statement))
            if c == "}" and scopes:
                scopes.pop()
            statement = ""
        else:
            statement += c
    return parts


def declared_in(part):
    """Names that a declaration introduces; rather one too many than one too few."""
    part = part.strip()
    if re.match(r"using\b[^=]*$|namespace\b|static_assert\b", part):
        return set()
    if match := re.match(r"TEST(?:_F|_P)?\s*\(\s*(\w+)\s*,\s*(\w+)\s*\)", part):
        return {"_".join((*match.groups(), "Test"))}
    if part.startswith("INSTANTIATE_TEST_SUITE_P"):
        return set()
    if match := re.match(r"(?:template\s*<.*?>\s*)?(?:struct|class|enum(?: class)?|using)\s+(\w+)",
                         part, re.DOTALL):
        return {match.group(1)}
    before = part.split("=")[0] if "(" not in part.split("=")[0] else part.split("(")[0]
    names = set(WORD.findall(before)[-1:])
    return names | set(re.findall(r",\s*(\w+)\s*=", part))


class Headers:
    """Headers of the project, each read once."""

    def __init__(self, folders):
        self.folders = folders
        self.declared = {}  # path -> names
        self.included = {}  # path -> paths

    def find(self, name, beside):
        for folder in (beside, *self.folders):
            if (folder / name).is_file():
                return folder / name
        return None

    def included_by(self, path, text):
        found = (self.find(name, path.parent) for name in INCLUDE.findall(text))
        return {header for header in found if header}

    def all_included_by(self, path, text):
        """Those that `path` includes, and those that they include, and so on."""
        seen, left = set(), self.included_by(path, text)
        while left:
            header = left.pop()
            if header in seen:
                continue
            seen.add(header)
            if header not in self.included:
                inside = header.read_text(encoding="utf-8")
                self.included[header] = self.included_by(header, inside)
                self.declared[header] = set().union(
                    *(declared_in(part) for _, part in declarations(code_of(inside))))
            left |= self.included[header] - seen
        return seen


class Source:
    def __init__(self, path, headers):
        text = path.read_text(encoding="utf-8")
        code = code_of(text)
        self.path, self.size = path, len(text)
        self.words = set(WORD.findall(code))
        self.own = set()
        for unnamed, part in declarations(code):
            if unnamed:
                self.own |= declared_in(part)
        self.headers = headers.all_included_by(path, text)
        self.defines = bool(MACRO.search(text))
        self.heavy = sorted(set(HEAVY.findall(text)))
        self.declared = headers.declared

    def meets(self, other):
        """Whether a name of this file alone means something else there."""
        if self.own & (other.words | other.own):
            return True
        return any(self.own & self.declared[h] for h in other.headers - self.headers)

    def clashes(self, other):
        return self.defines or other.defines or self.meets(other) or other.meets(self)


def groups_of(sources):
    groups = []
    for source in sorted(sources, key=lambda s: (s.heavy, str(s.path)), reverse=True):
        for group in groups:
            if (sum(s.size for s in group) + source.size <= MOST_BYTES
                    and not any(source.clashes(s) for s in group)):
                group.append(source)
                break
        else:
            groups.append([source])
    return groups


def main():
    root = pathlib.Path(sys.argv[1])
    home = pathlib.Path(__file__).resolve().parents[1]
    headers = Headers([home / "src", home / "tests"])
    sources = [Source(root / name, headers) for name in sys.argv[2:]]
    for number, group in enumerate(groups_of(sources)):
        for source in sorted(group, key=lambda s: str(s.path)):
            print(number, source.path)


if __name__ == "__main__":
    main()
