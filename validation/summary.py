#!/usr/bin/env python3
"""Writes the table of benchmarks in docs/accuracy.md from a validation.json.

    build/bin/loosefit validate -o out/validation
    python3 validation/summary.py out/validation/validation.json
"""

import json
import pathlib
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "accuracy.md"
BEGIN, END = "<!-- benchmarks: begin -->", "<!-- benchmarks: end -->"


def share_of_gate(finding):
    """Error as a share of its gate; the worst finding of a benchmark has the largest."""
    return finding["error"] / finding["limit"] if finding.get("limit") else 0.0


def number(value):
    return "–" if value is None else f"{value:.4g}"


def percent_or_number(finding, key):
    value = finding[key]
    if value is None:
        return "–"
    return f"{100 * value:.2g} %" if finding["gate"] == "relative" else f"{value:.2g} {finding['unit']}"


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    report = json.loads(pathlib.Path(sys.argv[1]).read_text())
    lines = ["| id | benchmark | figures | nearest to its gate | expected | obtained | error | gate | |",
             "|---|---|---|---|---|---|---|---|---|"]
    for benchmark in report["benchmarks"]:
        gated = [f for f in benchmark["findings"] if f["gate"] != "reported"]
        worst = max(gated, key=share_of_gate, default=None)
        if worst is None:
            lines.append(f"| {benchmark['id']} | {benchmark['title']} | "
                         f"{len(benchmark['findings'])} | reported, see below | | | | | – |")
            continue
        verdict = "pass" if all(f["pass"] for f in gated) else "**MISS**"
        lines.append(
            f"| {benchmark['id']} | {benchmark['title']} | {len(gated)} | {worst['what']} | "
            f"{number(worst['expected'])} | {number(worst['obtained'])} | "
            f"{percent_or_number(worst, 'error')} | {percent_or_number(worst, 'limit')} | {verdict} |")
    lines += ["", "Reported without a gate:", "", "| id | figure | reference | obtained |",
              "|---|---|---|---|"]
    for benchmark in report["benchmarks"]:
        if benchmark["id"] in ("D2", "S1"):
            lines += [f"| {benchmark['id']} | {f['what']} | {number(f['expected'])} | "
                      f"{number(f['obtained'])} {f['unit']} |" for f in benchmark["findings"]]
    page = PAGE.read_text()
    if BEGIN not in page or END not in page:
        raise SystemExit(f"error: {PAGE}: found no place for the table, expected {BEGIN} … {END}")
    head, rest = page.split(BEGIN, 1)
    PAGE.write_text(head + BEGIN + "\n" + "\n".join(lines) + "\n" + END + rest.split(END, 1)[1])


if __name__ == "__main__":
    main()
