#!/usr/bin/env python3
"""Fail when an #include crosses an arrow that layers.toml does not allow.

usage: check_layers.py [ROOT]        exit 0 good, 1 a rule is broken, 2 the rules cannot be read

Checks, over src/loosefit and those who use all of it, apps and python:
  * a module includes only modules named in its `uses`;
  * layers.toml and the loosefit_module lines of CMakeLists.txt state the same arrows;
  * the arrows have no cycle and every folder of src/loosefit is a module;
  * external headers (VTK, CGAL, ...) stay in the places allowed to them;
  * inside a module no includes go in a circle, .h and .cpp of one name taken as one;
  * every .cpp of src/loosefit has a header of its own name beside it.
The last two may have exceptions in layers.toml ([[cycle]] and [[without_header]]: `files` as
patterns and a `reason`); an exception that is not needed is an error too.
Sub-folders belong to their module. Lists files above 500 lines; above 700 is an error.
"""
import fnmatch
import pathlib
import re
import sys
import tomllib

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
LONG, TOO_LONG = 500, 700


def read_rules(root):
    with open(root / "layers.toml", "rb") as file:
        rules = tomllib.load(file)
    exceptions = {kind: rules.get(kind, []) for kind in ("cycle", "without_header")}
    return rules["uses"], rules.get("external", []), exceptions


def cmake_uses(root):
    """Module -> used modules as declared by the loosefit_module(...) calls."""
    text = re.sub(r"#.*", "", (root / "CMakeLists.txt").read_text())
    declared = {}
    for call in re.findall(r"loosefit_module\(([^)]*)\)", text):
        words = call.split()
        uses = []
        if "USES" in words:
            for word in words[words.index("USES") + 1:]:
                if word in ("LIBRARIES", "TEST_USES"):
                    break
                uses.append(word)
        declared[words[0]] = uses
    return declared


def compare_with_cmake(uses, declared):
    for module in sorted(set(uses) | set(declared)):
        if module not in declared:
            yield f"layers.toml: {module} is not a loosefit_module of CMakeLists.txt"
        elif module not in uses:
            yield f"CMakeLists.txt: {module} is missing in layers.toml"
        elif set(uses[module]) != set(declared[module]):
            differing = sorted(set(uses[module]) ^ set(declared[module]))
            yield f"{module}: layers.toml and CMakeLists.txt differ in {', '.join(differing)}"


def find_cycle(uses):
    done, open_path = set(), []

    def visit(module):
        if module in open_path:
            return open_path[open_path.index(module):] + [module]
        if module in done:
            return None
        open_path.append(module)
        for used in uses.get(module, []):
            if cycle := visit(used):
                return cycle
        open_path.pop()
        done.add(module)
        return None

    for module in uses:
        if cycle := visit(module):
            yield "cycle: " + " -> ".join(cycle)
            return


def check_file(path, source, root, uses, external):
    """Problems of one file; `source` is src/loosefit, None for files of apps and python. A header
    beside the modules (loosefit.h) may include any of them."""
    below = path.relative_to(source or root)
    module = below.parts[0] if source and len(below.parts) > 1 else None
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        header = match.group(1)
        parts = header.split("/")
        if parts[0] == "loosefit" and len(parts) > 2:
            used = parts[1]
            if used not in uses:
                yield f"{path}:{number}: {header}: {used} is not a module"
            elif module and used != module and used not in uses[module]:
                yield f"{path}:{number}: {module} must not include {header}"
        for rule in external:
            if not any(header.startswith(prefix) for prefix in rule["prefixes"]):
                continue
            if not any(fnmatch.fnmatch(str(below), p) for p in rule["places"]):
                where = ", ".join(rule["places"])
                yield f"{path}:{number}: {header}: {rule['name']} belongs into {where}"


def file_pairs(source):
    """File pair ("solver/linear/fill_order") -> file pairs of the same module that it includes."""
    pairs = {}
    for path in sorted(p for p in source.rglob("*") if p.suffix in (".h", ".cpp")):
        pair = path.relative_to(source).with_suffix("").as_posix()
        included = pairs.setdefault(pair, set())
        for line in path.read_text(errors="replace").splitlines():
            match = INCLUDE.match(line)
            if not match or not match.group(1).startswith("loosefit/"):
                continue
            other = pathlib.PurePosixPath(match.group(1)).relative_to("loosefit").with_suffix("")
            if other.parts[0] == pair.split("/")[0] and str(other) != pair:
                included.add(str(other))
    return pairs


def knots(pairs):
    """Largest sets of file pairs that all reach each other (Tarjan's algorithm), each sorted."""
    index, lowest, stack, found = {}, {}, [], []

    def visit(pair):
        index[pair] = lowest[pair] = len(index)
        stack.append(pair)
        for other in sorted(pairs[pair] & pairs.keys()):
            if other not in index:
                visit(other)
                lowest[pair] = min(lowest[pair], lowest[other])
            elif other in stack:
                lowest[pair] = min(lowest[pair], index[other])
        if lowest[pair] == index[pair]:
            start = stack.index(pair)
            if len(stack) - start > 1:
                found.append(sorted(stack[start:]))
            del stack[start:]

    for pair in sorted(pairs):
        if pair not in index:
            visit(pair)
    return found


class Exceptions:
    """Those of one kind: says whether they cover a set of files, and which were not needed."""

    def __init__(self, kind, entries):
        self.kind = kind
        self.entries = entries
        self.needed = set()

    def cover(self, names):
        for number, entry in enumerate(self.entries):
            hits = {(number, p) for p in entry.get("files", []) for n in names
                    if fnmatch.fnmatch(n, p)}
            if all(any(fnmatch.fnmatch(n, p) for _, p in hits) for n in names):
                self.needed |= hits
                return True
        return False

    def problems(self):
        for number, entry in enumerate(self.entries):
            if not entry.get("reason", "").strip():
                yield f"layers.toml: {self.kind} {entry.get('files', [])}: without a reason"
            for pattern in entry.get("files", []) or ["(no files)"]:
                if (number, pattern) not in self.needed:
                    yield f"layers.toml: {self.kind} {pattern}: exception not needed, remove it"


def check_file_pairs(source, exceptions):
    cycles = Exceptions("cycle", exceptions["cycle"])
    headless = Exceptions("without_header", exceptions["without_header"])
    pairs = file_pairs(source)
    for knot in knots(pairs):
        if not cycles.cover(knot):
            arrows = [f"{a} -> {b}" for a in knot for b in sorted(pairs[a] & set(knot))]
            yield "includes in a circle: " + ", ".join(arrows)
    for path in sorted(source.rglob("*.cpp")):
        name = path.relative_to(source).as_posix()
        if not path.with_suffix(".h").exists() and not headless.cover([name]):
            yield f"{path}: no header of its own name beside it"
    yield from cycles.problems()
    yield from headless.problems()


def main(argv):
    root = pathlib.Path(argv[1] if len(argv) > 1 else pathlib.Path(__file__).parents[1])
    source = root / "src" / "loosefit"
    try:
        uses, external, exceptions = read_rules(root)
        declared = cmake_uses(root)
    except (OSError, tomllib.TOMLDecodeError, KeyError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    problems = list(compare_with_cmake(uses, declared)) + list(find_cycle(uses))
    for folder in sorted(p.name for p in source.iterdir() if p.is_dir()):
        if folder not in uses:
            problems.append(f"src/loosefit/{folder} is not a module of layers.toml")
    problems += check_file_pairs(source, exceptions)
    count = 0
    for tree, base in ((source, source), (root / "apps", None), (root / "python", None)):
        for path in sorted(p for p in tree.rglob("*") if p.suffix in (".h", ".cpp")):
            count += 1
            problems += check_file(path, base, root, uses, external)
            lines = len(path.read_text(errors="replace").splitlines())
            if lines > TOO_LONG:
                problems.append(f"{path}: {lines} lines, at most {TOO_LONG}")
            elif lines > LONG:
                print(f"note: {path.relative_to(root)}: {lines} lines")
    for problem in problems:
        print(f"error: {problem}")
    print(f"{count} files, {len(uses)} modules, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
