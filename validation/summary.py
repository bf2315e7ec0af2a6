#!/usr/bin/env python3
"""Writes the figures of the benchmarks into validation/results.json and the documents.

    build/bin/loosefit validate -o out/validation
    python3 validation/summary.py out/validation/validation.json   # all or some of the benchmarks
    python3 validation/summary.py              # the documents again, from validation/results.json
    python3 validation/summary.py --check      # exit 1 when a document says something else

docs/accuracy.md has the tables between markers. Any document of docs may have a single figure,

    changes by <!-- figure M3 "50 mm wide" error -->2.3 %<!-- end -->

that is one of the keys expected, obtained, percent (of what is obtained), error, or limit of the finding of that benchmark whose
text contains the words in quotes.
"""

import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN, END = "<!-- benchmarks: begin -->", "<!-- benchmarks: end -->"
FIGURE = re.compile(r'(<!-- figure (\S+) "([^"]+)" (expected|obtained|percent|error|limit) -->)(.*?)(<!-- end -->)', re.S)
KEPT = ("what", "unit", "expected", "obtained", "error", "gate", "limit", "share_of_gate", "verdict",
        "known_miss")


def number(value):
    return "–" if value is None else f"{value:.4g}"


def with_unit(finding, value):
    text = "–" if value is None else f"{value:.2g}"
    return f"{text} {finding['unit']}".strip()


def measure(finding, key):
    """Error or limit in the measure of the gate."""
    value = finding[key]
    if isinstance(value, list):
        low, high = value
        if low is None:
            return f"at most {number(high)}"
        return f"at least {number(low)}" if high is None else f"{number(low)} to {number(high)}"
    if value is not None and finding["gate"] == "relative":
        return f"{100 * value:.0f} %" if value >= 1 else f"{100 * value:.2g} %"
    return with_unit(finding, value)


def cell(text):
    """A text in a table, where a bar would end the cell."""
    return text.replace("|", "\\|")


def share(finding):
    return float("inf") if finding["share_of_gate"] is None else finding["share_of_gate"]


def verdict_text(verdict):
    return verdict if verdict in ("pass", "reported") else f"**{verdict}**"


def overview(benchmarks):
    lines = ["| id | benchmark | figures | nearest to its gate | expected | obtained | error | gate | |",
             "|---|---|---|---|---|---|---|---|---|"]
    for benchmark in benchmarks:
        gated = [f for f in benchmark["findings"] if f["gate"] != "reported"]
        head = f"| {benchmark['id']} | {benchmark['title']} | {len(benchmark['findings'])} | "
        if gated:
            worst = max(gated, key=share)
            lines.append(f"{head}{cell(worst['what'])} | {number(worst['expected'])} | "
                         f"{number(worst['obtained'])} | {measure(worst, 'error')} | "
                         f"{measure(worst, 'limit')} | {verdict_text(benchmark['verdict'])} |")
        else:
            lines.append(f"{head}{benchmark['error'] or 'no gate'} | | | | | "
                         f"{verdict_text(benchmark['verdict'])} |")
    return lines


def misses(benchmarks):
    """Every figure that is not at its gate, with its reason."""
    lines = []
    for benchmark in benchmarks:
        for f in benchmark["findings"]:
            if f["verdict"] in ("pass", "reported"):
                continue
            why = f["known_miss"]["reason"] if f["known_miss"] else "not known"
            lines.append(f"| {benchmark['id']} | {cell(f['what'])} | {number(f['expected'])} | "
                         f"{number(f['obtained'])} {f['unit']} | {measure(f, 'limit')} | "
                         f"{verdict_text(f['verdict'])} | {cell(why)} |")
    if not lines:
        return ["", "No figure misses its gate."]
    return ["", "Figures that miss their gates, with the reason where it is known:", "",
            "| id | figure | expected | obtained | gate | | reason |",
            "|---|---|---|---|---|---|---|"] + lines


def reported(benchmarks):
    lines = [f"| {b['id']} | {cell(f['what'])} | {number(f['expected'])} | {number(f['obtained'])} {f['unit']} |"
             for b in benchmarks for f in b["findings"] if f["verdict"] == "reported"]
    if not lines:
        return []
    return ["", "Reported without a gate:", "", "| id | figure | reference | obtained |",
            "|---|---|---|---|"] + lines


def versions(benchmarks):
    """Which program found what: results of several runs may stand side by side."""
    by_version = {}
    for benchmark in benchmarks:
        by_version.setdefault(benchmark["version"], []).append(benchmark["id"])
    if len(by_version) == 1:
        return [f"Found by version {next(iter(by_version))} of the program.", ""]
    return ["Found by several versions of the program: "
            + "; ".join(f"{version}: {', '.join(ids)}" for version, ids in by_version.items()) + ".", ""]


def tables(benchmarks):
    return "\n".join(versions(benchmarks) + overview(benchmarks) + misses(benchmarks) + reported(benchmarks))


def figure(benchmarks, identity, words, key):
    found = [f for b in benchmarks if b["id"] == identity for f in b["findings"] if words in f["what"]]
    if len(found) != 1:
        raise SystemExit(f"error: {len(found)} findings of {identity} contain \"{words}\", expected one")
    if key in ("error", "limit"):
        return measure(found[0], key)
    if key == "percent":
        return f"{100 * found[0]['obtained']:.0f} %"
    return f"{number(found[0][key])} {found[0]['unit']}".strip()


def written(text, benchmarks):
    """The document as the results have it."""
    if BEGIN in text:
        head, rest = text.split(BEGIN, 1)
        text = head + BEGIN + "\n" + tables(benchmarks) + "\n" + END + rest.split(END, 1)[1]
    return FIGURE.sub(lambda m: m[1] + figure(benchmarks, m[2], m[3], m[4]) + m[6], text)


def merged(old, new):
    """New benchmarks in the place of old ones of their id; those that are new come last."""
    by_id = {b["id"]: b for b in new}
    kept = [by_id.pop(b["id"], b) for b in old]
    return kept + list(by_id.values())


def short(benchmark, version):
    """What is kept of a benchmark, with the version of the program that ran it."""
    return {**{key: benchmark[key] for key in ("id", "title", "verdict", "error")}, "version": version,
            "findings": [{key: f[key] for key in KEPT} for f in benchmark["findings"]]}


def program(versions):
    """Versions are seldom, changes of figures are not: the build tells the program too."""
    build = versions.get("build", "")[:8]
    return f"{versions['loosefit']} (build {build})" if build else versions["loosefit"]


def main(argv, root=ROOT):
    results = root / "validation" / "results.json"
    stored = json.loads(results.read_text()) if results.exists() else []
    if len(argv) > 2:
        raise SystemExit(__doc__)
    check = argv[1:] == ["--check"]
    if argv[1:] and not check:
        report = json.loads(pathlib.Path(argv[1]).read_text())
        if report["effort"] != "full":
            raise SystemExit(f"error: {argv[1]}: found the quick subset, expected a full validation")
        version = program(report["versions"])
        stored = merged(stored, [short(b, version) for b in report["benchmarks"]])
        results.write_text(json.dumps(stored, indent=1, ensure_ascii=False) + "\n")
    stale = []
    for page in sorted((root / "docs").rglob("*.md")):
        text = page.read_text()
        now = written(text, stored)
        if now == text:
            continue
        stale.append(page.relative_to(root).as_posix())
        if not check:
            page.write_text(now)
    for page in stale:
        print(f"error: {page} does not say what validation/results.json says" if check else f"wrote {page}")
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
