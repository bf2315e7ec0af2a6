#!/usr/bin/env python3
"""Ratios between two records of run_bench.py or robustness.py, case by case.

usage: compare.py A B [--worse SHARE]

Figures are medians of the repeats; a ratio is B / A, so below 1 B is faster or smaller. The last line
is the geometric mean over the cases that settled in both. With --worse 0.1 the exit code is 1 when
a case of A that settled does not settle in B, or takes over 10 % more processor time.
"""
import argparse
import math
import sys

import records
from run_bench import median, status

FIGURES = (("wall_seconds", "wall"), ("cpu_seconds", "cpu"), ("peak_memory_mb", "memory"),
           ("iterations", "iter"))


def load(path):
    try:
        record = records.read(path)
        if not isinstance(record.get("cases"), dict):
            raise ValueError("no cases in it")
        return record
    except (OSError, ValueError, AttributeError) as wrong:
        sys.exit(f"error: {path}: {wrong}\nhint: records are written by run_bench.py --json or --record")


def figure(entry, key):
    return median([run.get(key) for run in entry["runs"]])


def spread(entry):
    """Largest over smallest processor time of the repeats."""
    values = [run["cpu_seconds"] for run in entry["runs"] if run.get("cpu_seconds")]
    return max(values) / min(values) if len(values) > 1 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("a")
    parser.add_argument("b")
    parser.add_argument("--worse", type=float, metavar="SHARE", help="fail beyond this")
    options = parser.parse_args()
    a, b = load(options.a), load(options.b)
    for name, record in (("A", a), ("B", b)):
        m = record["machine"]
        print(f"{name}: {record['date']} {record['commit']}  {m['processor']}, {m['cores']} cores, "
              f"load {m['load']}  {record['note']}")
    if a["machine"]["processor"] != b["machine"]["processor"] or \
            a["machine"]["cores"] != b["machine"]["cores"]:
        print("not the same machine: times do not compare")
    print(f"{'case':22} {'A':>12} {'B':>12} {'wall A':>8} {'wall B':>8} "
          + " ".join(f"{title + ' B/A':>10}" for _, title in FIGURES) + f" {'spread A, B':>12}")
    logs = {key: [] for key, _ in FIGURES}
    worse = []
    for name in list(a["cases"]) + [n for n in b["cases"] if n not in a["cases"]]:
        states, entries = [], []
        for record in (a, b):
            entry = record["cases"].get(name)
            entries.append(entry)
            states.append("absent" if entry is None else status(entry))
        line = f"{name:22} {states[0]:>12} {states[1]:>12}"
        usable = [e is not None and "runs" in e for e in entries]
        both = states == ["settled", "settled"]
        if states[0] == "settled" and states[1] not in ("settled", "absent"):
            worse.append(name)
        for entry, there in zip(entries, usable):
            seconds = figure(entry, "wall_seconds") if there else None
            line += f" {'–' if seconds is None else format(seconds, '.1f'):>8}"
        for key, _ in FIGURES:
            values = [figure(e, key) if there else None for e, there in zip(entries, usable)]
            if both and all(values):
                ratio = values[1] / values[0]
                logs[key].append(math.log(ratio))
                line += f" {ratio:10.3f}"
                if key == "cpu_seconds" and options.worse is not None and ratio > 1 + options.worse:
                    worse.append(name)
            else:
                line += f" {'–':>10}"
        spreads = [spread(e) if there else None for e, there in zip(entries, usable)]
        line += "  " + ", ".join("–" if s is None else f"{s:.2f}" for s in spreads)
        print(line)
    means = [math.exp(sum(v) / len(v)) if v else None for v in logs.values()]
    print(f"{'geometric mean':22} {'':12} {'':12} {'':8} {'':8} "
          + " ".join(f"{'–' if m is None else format(m, '.3f'):>10}" for m in means))
    if options.worse is not None and worse:
        print("worse: " + ", ".join(dict.fromkeys(worse)))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
