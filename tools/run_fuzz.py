#!/usr/bin/env python3
"""Reads damaged pattern files of every format and writes a table of what became of them.

usage: run_fuzz.py PROGRAM ... [--cases N] [--table FILE] [--build NAME]

PROGRAM: test programs; of each the tests called *Fuzz.* that keep a tally (tests/support/fuzz_tally.h) are run, every one as a process
of its own. --cases: files in all, shared out evenly. --table: a Markdown file. --build: what the programs were built with, for the
table. Exit code 1 if a test fails, crashes, hangs, or leaves no tally.
"""
import argparse
import datetime
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILTER = "*Fuzz.*-RunFolderFuzz.*:ScenarioFuzz.*"  # those damage no pattern files
# A file takes some milliseconds, under sanitizers ten times that; what takes far longer hangs.
SECONDS = 60
SECONDS_PER_FILE = 0.5


def tests_of(program):
    """Names of the fuzz tests of a program."""
    answer = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={FILTER}"], capture_output=True, text=True, check=True)
    names, suite = [], ""
    for line in answer.stdout.splitlines():
        if line.startswith("  "):
            names.append(suite + line.split("#")[0].strip())
        elif line.rstrip().endswith("."):
            suite = line.strip()
    return names


def last_words(text):
    """The seed and the complaint of a failure, without paths of this machine."""
    lines = [line.replace(str(ROOT) + "/", "") for line in text.splitlines()]
    told = [line.strip() for line in lines if "Failure" in line or "ERROR:" in line or "runtime error" in line or "trace" in line]
    return "; ".join(told[:3])


def run(program, test, cases):
    """One row of the table: counts of a format, or what has gone wrong."""
    with tempfile.TemporaryDirectory() as folder:
        tally = pathlib.Path(folder) / "tally"
        environment = os.environ | {"LOOSEFIT_FUZZ_CASES": str(cases), "LOOSEFIT_FUZZ_TALLY": str(tally)}
        row = {"test": test, "cases": cases, "verdict": ""}
        try:
            done = subprocess.run([program, f"--gtest_filter={test}"], env=environment, capture_output=True, text=True, errors="replace",
                                  timeout=SECONDS + SECONDS_PER_FILE * cases)
        except subprocess.TimeoutExpired:
            return row | {"verdict": "hangs"}
        if tally.exists():
            row |= json.loads(tally.read_text().splitlines()[-1])
        if done.returncode < 0 or not tally.exists():
            return row | {"verdict": f"crash (exit {done.returncode}): {last_words(done.stdout + done.stderr)}"}
        if done.returncode:
            return row | {"verdict": f"fails: {last_words(done.stdout + done.stderr)}"}
        return row


def table(rows, build):
    """Markdown; a format without counts shows what went wrong in their place."""
    total = {key: sum(row.get(key, 0) for row in rows) for key in ("cases", "refused", "read", "identical")}
    text = ["# Damaged pattern files", "",
            f"Written by `make fuzz` on {datetime.date.today().isoformat()}, {build}: files damaged as files get damaged, each read, checked and, where "
            "it is read, sewn or written again. Refused: an error that names the file. Read: other pieces than those of the whole file, finite, closed and "
            "no larger than the file's numbers allow, or other seams. Identical: the damage met nothing that is read.", "",
            "| format | files | refused | read | identical | slowest [ms] | verdict |", "|---|---:|---:|---:|---:|---:|---|"]
    for row in rows:
        numbers = " | ".join(str(row.get(key, "–")) for key in ("cases", "refused", "read", "identical", "slowest_ms"))
        text.append(f"| {row.get('format', row['test'])} | {numbers} | {row['verdict'] or 'holds'} |")
    text.append("| all | " + " | ".join(str(total[key]) for key in ("cases", "refused", "read", "identical")) + " | | |")
    return "\n".join(text) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    parser.add_argument("--cases", type=int, default=100000)
    parser.add_argument("--table", metavar="FILE")
    parser.add_argument("--build", default="a build of unknown kind")
    options = parser.parse_args()
    tests = [(program, test) for program in options.programs for test in tests_of(program)]
    if not tests or options.cases < len(tests):
        parser.error(f"{len(tests)} fuzz tests for {options.cases} files: at least one of each is needed")
    each = -(-options.cases // len(tests))
    rows = []
    for program, test in tests:
        rows.append(run(program, test, each))
        row = rows[-1]
        print(f"{row.get('format', test):28} {each:7} files: {row.get('refused', 0):7} refused, {row.get('read', 0):6} read, "
              f"{row.get('identical', 0):6} identical  {row['verdict'] or 'holds'}", flush=True)
    if options.table:
        pathlib.Path(options.table).write_text(table(rows, options.build))
    return 1 if any(row["verdict"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
