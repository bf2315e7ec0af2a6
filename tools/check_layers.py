#!/usr/bin/env python3
"""Fail when an #include crosses an arrow that layers.toml does not allow.

usage: check_layers.py [ROOT]        exit 0 good, 1 a rule is broken, 2 the rules cannot be read

Checks, over src/loosefit and apps:
  * a module includes only modules named in its `uses`;
  * layers.toml and the loosefit_module lines of CMakeLists.txt state the same arrows;
  * the arrows have no cycle and every folder of src/loosefit is a module;
  * external headers (VTK, CGAL, ...) stay in the places allowed to them.
Lists files above 400 lines; above 500 is an error.
"""
import fnmatch
import pathlib
import re
import sys
import tomllib

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
LONG, TOO_LONG = 400, 500


def read_rules(root):
    with open(root / "layers.toml", "rb") as file:
        rules = tomllib.load(file)
    return rules["uses"], rules.get("external", [])


def cmake_uses(root):
    """Module -> used modules as declared by the loosefit_module(...) calls."""
    text = re.sub(r"#.*", "", (root / "CMakeLists.txt").read_text())
    declared = {}
    for call in re.findall(r"loosefit_module\(([^)]*)\)", text):
        words = call.split()
        uses = []
        if "USES" in words:
            for word in words[words.index("USES") + 1:]:
                if word == "LIBRARIES":
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


def check_file(path, source, uses, external):
    """Problems of one file; `source` is src/loosefit, None for files of apps."""
    below = path.relative_to(source) if source else None
    module = below.parts[0] if below else None
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
            if below is None or not any(fnmatch.fnmatch(str(below), p) for p in rule["places"]):
                where = ", ".join(rule["places"])
                yield f"{path}:{number}: {header}: {rule['name']} belongs into {where}"


def main(argv):
    root = pathlib.Path(argv[1] if len(argv) > 1 else pathlib.Path(__file__).parents[1])
    source = root / "src" / "loosefit"
    try:
        uses, external = read_rules(root)
        declared = cmake_uses(root)
    except (OSError, tomllib.TOMLDecodeError, KeyError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    problems = list(compare_with_cmake(uses, declared)) + list(find_cycle(uses))
    for folder in sorted(p.name for p in source.iterdir() if p.is_dir()):
        if folder not in uses:
            problems.append(f"src/loosefit/{folder} is not a module of layers.toml")
    count = 0
    for tree, base in ((source, source), (root / "apps", None)):
        for path in sorted(p for p in tree.rglob("*") if p.suffix in (".h", ".cpp")):
            count += 1
            problems += check_file(path, base, uses, external)
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
