#!/usr/bin/env python3
"""Drapes randomly drawn cases and tells how many settle, and why the others do not.

usage: robustness.py [--count N] [--seed SEED] [--cases 17,45,60-69] [--json FILE] [--record NOTE]
                     [--binary FILE] [--budget SECONDS] [-j N] [--out DIR] [--list]
       robustness.py --from-schema FILE.csv [--count N] [--seed SEED] [--cases …] [--edge METRES] [--budget SECONDS]
                     [--limit SECONDS] [--strangest N] [-j N] [--out DIR] [--binary FILE]

Body, fit, fabric, posture, start and mesh of case k follow from the seed and k alone
(robustness_draw.py). A draw for which there is no such body or no such shirt is drawn again and
counted as redrawn. Each case is a process of its own (`loosefit drape`), one at a time unless -j. With
--json the record is written after every case, and cases it holds already are not run again unless
--cases names them. Exit code 1 when a case did not settle.

With --from-schema cases are scenarios of any kind, drawn from `loosefit schema` (schema_draw.py), each with a hard
time limit; FILE.csv gets a row a case and is resumed. What is asked is that every one ends in words
(schema_cases.py): exit code 1 when one crashed, hung or left something behind. --strangest N draws pictures of the
certified drapes whose figures are farthest from the others, for a person to look at. A thousand of them:
robustness.py --from-schema rows.csv --count 1000 --seed 61 --out out/schema --strangest 20
"""
import argparse
import concurrent.futures
import datetime
import json
import pathlib
import re
import shutil
import sys
import tempfile

import records
import robustness_draw
import schema_cases
from run_bench import ROOT, git, machine, run_process, status

ATTEMPTS = 20
KILL_AFTER = 300  # seconds beyond the time budgets of all drapes of a case
NO_SUCH_CASE = re.compile(r"\b(measurements|measures\.\w+|fit\.\w+)\b")


def run(case, options, folder):
    """One row as in run_bench.py, with the reason when it did not settle."""
    scenario = folder.with_suffix(".toml")
    scenario.write_text(robustness_draw.scenario(case, options.budget))
    shutil.rmtree(folder, ignore_errors=True)  # what an earlier run left there is no answer
    drapes = 2 if "shift" in case["start"] else 1
    code, wall, cpu, peak, message = run_process(
        [options.binary, "drape", str(scenario), "-o", str(folder), "--quiet"], None,
        drapes * options.budget + KILL_AFTER)
    row = {"exit_code": code, "wall_seconds": round(wall, 2), "cpu_seconds": round(cpu, 2),
           "peak_memory_mb": round(peak, 1), "settled": False}
    file = folder / "summary.json"
    if not file.exists():
        error = message.replace(str(folder.parent) + "/", "")
        return row | {"error": error or f"exit {code} without a message"}
    summary = json.loads(file.read_text())
    # The worst of the drapes of the case: the first, and the donning askew.
    worst = summary
    for state in summary.get("states", []):
        if worst["settled"] and not state["settled"]:
            worst = state
    row |= {key: worst[key] for key in ("settled", "stop_reason", "residual", "intersections")}
    row["iterations"] = summary["settle"]["iterations"] + sum(
        state["iterations"] for state in summary.get("states", []))
    row["factorisations"] = summary["settle"]["factorisations"]
    row["vertices"] = summary["vertices"]
    row["versions"] = summary["versions"]
    unsettled = worst.get("unsettled") or worst.get("settle", {}).get("unsettled")
    if not row["settled"] and unsettled:
        row["unsettled"] = unsettled
    return row


def is_redrawn(row):
    return row["exit_code"] == 2 and NO_SUCH_CASE.search(row.get("error", "")) is not None


def settle_case(number, options, out):
    """The record of one case: the draw, what was redrawn before it, and its run."""
    redrawn = []
    for attempt in range(ATTEMPTS):
        case = robustness_draw.draw(options.seed, number, attempt)
        row = run(case, options, out / f"draw-{options.seed}-{number:03d}")
        if not is_redrawn(row):
            return {"groups": ["robustness"], "draw": case, "redrawn": redrawn, "runs": [row]}
        redrawn.append(row["error"])
    sys.exit(f"error: case {number}: nothing but bodies or shirts that do not exist: {redrawn[-1]}")


def cause(entry):
    row = entry["runs"][0]
    if "error" in row:
        return f"exit {row['exit_code']}: {row['error']}"
    cuts = row["intersections"]
    text = f"residual {row['residual']:.1e}, cuts {cuts['body']}+{cuts['self']}, {row['stop_reason']}"
    if "why" in row.get("unsettled", {}):
        text += "; " + row["unsettled"]["why"]
    return text


def print_case(number, entry):
    row = entry["runs"][0]
    print(f"{number:4d} {'settled' if status(entry) == 'settled' else 'FAILED':8} "
          f"{row['wall_seconds']:7.1f} {row['cpu_seconds']:7.1f} {row.get('iterations', 0):6d} "
          f"{row.get('residual', float('nan')):9.1e}  {robustness_draw.in_words(entry['draw'])}",
          flush=True)


def print_summary(cases):
    failures = {name: entry for name, entry in cases.items() if status(entry) != "settled"}
    redrawn = sum(len(entry["redrawn"]) for entry in cases.values())
    print(f"{len(cases) - len(failures)} of {len(cases)} settled; {redrawn} redrawn")
    for name, entry in sorted(failures.items()):
        print(f"{name}: {cause(entry)}\n    {robustness_draw.in_words(entry['draw'])}")
    return failures


def numbers(text):
    found = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        found += range(int(first), int(last or first) + 1)
    return found


def parse():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=2012)
    parser.add_argument("--cases", type=numbers, help="only these, also when recorded already")
    parser.add_argument("--json", metavar="FILE", help="resume and write this record; .csv: a line a case, draws left out")
    parser.add_argument("--record", metavar="NOTE", help="add to bench/history, with a note")
    parser.add_argument("--binary", default=str(ROOT / "build/bin/loosefit"))
    parser.add_argument("--budget", type=float, default=300, help="wall seconds of each drape")
    parser.add_argument("-j", type=int, default=1, dest="jobs", help="cases at a time")
    parser.add_argument("--out", help="keep the outputs in this folder")
    parser.add_argument("--list", action="store_true", help="the draws, nothing is run")
    parser.add_argument("--from-schema", metavar="FILE.csv", dest="rows", type=pathlib.Path,
                        help="cases drawn from the schema of scenarios; rows are added to this file")
    parser.add_argument("--edge", type=float, default=0.04, help="of meshes with --from-schema, metres")
    parser.add_argument("--limit", type=float, default=60, help="wall seconds of a case with --from-schema")
    parser.add_argument("--strangest", type=int, default=0, metavar="N", help="pictures with --from-schema")
    options = parser.parse_args()
    if options.rows:
        options.budget = min(options.budget, options.limit / 3)
    if options.count < 1 or options.jobs < 1 or options.budget < 0.1:
        parser.error("--count and -j: at least 1; --budget: at least 0.1")
    if not options.list and not pathlib.Path(options.binary).is_file():
        parser.error(f"{options.binary}: no such program; build it or give --binary")
    return options


def main():
    options = parse()
    if options.rows:
        commit = git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "-uno") else "")
        with tempfile.TemporaryDirectory() as scratch:
            out = pathlib.Path(options.out or scratch).resolve()
            out.mkdir(parents=True, exist_ok=True)
            bad = schema_cases.study(options, out, commit)
        for row in bad:
            print(f"BAD {row['case']}: {row['end']}: {row['words']}")
        return 1 if bad else 0
    wanted = options.cases or list(range(1, options.count + 1))
    if options.list:
        for number in wanted:
            print(f"{number:4d} {robustness_draw.in_words(robustness_draw.draw(options.seed, number))}")
        return 0
    commit = git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "-uno") else "")
    record = {"date": datetime.date.today().isoformat(), "commit": commit,
              "note": options.record or "", "machine": machine(), "versions": {},
              "pictures": False, "seed": options.seed, "budget": options.budget, "cases": {}}
    targets = []
    if options.json:
        targets.append(pathlib.Path(options.json))
        if targets[0].exists():
            earlier = records.read(targets[0])
            if earlier.get("seed") != options.seed:
                sys.exit(f"error: {options.json}: found seed {earlier.get('seed')}, expected "
                         f"{options.seed}\nhint: give another --json or --seed")
            for name, entry in earlier["cases"].items():
                case = robustness_draw.draw(options.seed, records.case_number(name), len(entry["redrawn"]))
                if entry.get("draw") != case:
                    sys.exit(f"error: {options.json}: {name}: found a case that this program draws "
                             "differently, expected its own\nhint: give another --json")
            record["cases"], record["versions"] = earlier["cases"], earlier["versions"]
    if options.record is not None:
        targets.append(ROOT / f"bench/history/robustness-{record['date']}-{commit.rstrip('+')}.csv")
    name_of = f"draw-{options.seed}-{{:03d}}".format
    if not options.cases:
        wanted = [number for number in wanted if name_of(number) not in record["cases"]]
    print(f"{'case':>4} {'state':8} {'wall s':>7} {'cpu s':>7} {'iter':>6} {'residual':>9}", flush=True)
    with tempfile.TemporaryDirectory() as scratch, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        out = pathlib.Path(options.out or scratch).resolve()
        out.mkdir(parents=True, exist_ok=True)
        running = {pool.submit(settle_case, number, options, out): number for number in wanted}
        for done in concurrent.futures.as_completed(running):
            entry = done.result()
            for row in entry["runs"]:
                record["versions"] |= row.pop("versions", {})
                row["commit"] = commit
            record["cases"][name_of(running[done])] = entry
            record["cases"] = dict(sorted(record["cases"].items()))
            print_case(running[done], entry)
            for path in targets:  # after every case: a study that is cut short keeps what it has
                records.write(path, record)
    failures = print_summary(record["cases"])
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
