#!/usr/bin/env python3
"""Compile the sources of a module in groups, each as one file.

usage: unity_groups.py group FILE...        prints one line per file: GROUP FILE
       unity_groups.py write OUT FILE...    writes OUT, which compiles the files as one

Headers that a group shares are read and their templates are compiled once. What an unnamed
namespace declares belongs to its file alone: where the name is also a word of another file of the
group, a macro renames it while its own file is read. Not where its own file also uses the name as
a member or a namespace, or one of its headers declares it; such files are kept apart. Files that
include the same heavy libraries are put together first. A group holds at most MOST_BYTES.
"""
import pathlib
import re
import sys

MOST_BYTES = 80_000
COMMENT_OR_TEXT = re.compile(
    r'R"(\w*)\((?:.|\n)*?\)\1"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'')
DIRECTIVE = re.compile(r"^[ \t]*#.*$", re.MULTILINE)
WORD = re.compile(r"\b[A-Za-z_]\w*\b")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
INCLUDE_LINE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"][^>"]+[>"])', re.MULTILINE)
MEMBER = re.compile(r"(?:\.|->|::)\s*([A-Za-z_]\w*)")
QUALIFIER = re.compile(r"\b([A-Za-z_]\w*)\s*::")
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
    if match := re.match(r"(?:template\s*<.*?>\s*)?(?:struct|class|enum(?: class)?|using)\s+(\w+)",
                         part, re.DOTALL):
        return {match.group(1)}
    before = part.split("=")[0] if "(" not in part.split("=")[0] else part.split("(")[0]
    names = set(WORD.findall(before)[-1:])
    return names | set(re.findall(r",\s*(\w+)\s*=", part))


KEYWORDS = {"catch", "const", "override", "noexcept", "operator", "return", "final"}


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
                self.own |= declared_in(part) - KEYWORDS
        self.headers = headers.all_included_by(path, text)
        self.includes = [self.from_anywhere(header) for header in INCLUDE_LINE.findall(text)]
        self.heavy = sorted(set(HEAVY.findall(text)))
        self.declared = headers.declared
        elsewhere = set(MEMBER.findall(code) + QUALIFIER.findall(code))
        self.fixed = self.own & (elsewhere | self.declared_above(self.headers))

    def from_anywhere(self, header):
        beside = self.path.parent / header.strip('"')
        return f'"{beside}"' if header[0] == '"' and beside.is_file() else header

    def declared_above(self, included):
        return set().union(*(self.declared[header] for header in included))

    def met_by(self, other):
        """The names of this file alone that mean something else in the other one."""
        return self.own & (other.words | self.declared_above(other.headers - self.headers))

    def clashes(self, other):
        return bool(self.met_by(other) & self.fixed or other.met_by(self) & other.fixed)


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


def united(sources):
    """The text of a file that includes the sources, each with its names to itself."""
    lines = list(dict.fromkeys(  # headers first: no macro reaches them
        f"#include {header}" for source in sources for header in source.includes))
    for number, source in enumerate(sources):
        renamed = sorted(set().union(*(source.met_by(s) for s in sources if s is not source)))
        lines += [f"#define {name} {name}_of_{number}" for name in renamed]
        lines.append(f'#include "{source.path}"')
        lines += [f"#undef {name}" for name in renamed]
    return "\n".join(lines) + "\n"


def main():
    action, *paths = sys.argv[1:]
    paths = [pathlib.Path(path) for path in paths]
    out = paths.pop(0) if action == "write" else None
    headers = Headers([pathlib.Path(__file__).resolve().parents[1] / "src"])
    sources = [Source(path, headers) for path in paths]
    if out:
        out.parent.mkdir(parents=True, exist_ok=True)
        text = united(sources)
        if not out.is_file() or out.read_text(encoding="utf-8") != text:
            out.write_text(text, encoding="utf-8")
        return
    for number, group in enumerate(groups_of(sources)):
        for source in sorted(group, key=lambda s: str(s.path)):
            print(number, source.path)


if __name__ == "__main__":
    main()
