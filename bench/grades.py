#!/usr/bin/env python3
"""How far cases that are content with certificate grade B are from the same ones that go on to grade A.

usage: grades.py FOLDER [--binary FILE] [--count N] [--edges MM MM] [--garment KIND] [--jobs N] [--json FILE] [--page FILE]

Two studies of the same N cases, one to grade B and one to grade A: fabric cards, three fits, worn in or just put
on, two edge lengths, two wearers, and standing or bent forward alone (where the drape that is measured itself ends with B) or one after the
other (for metrics over postures), each level equally often (Latin hypercube). Both are kept in FOLDER; the same
command goes on where it stopped. Prints, for every metric of a site that the program knows and for every figure
of the whole garment, the absolute difference over all sites, scorecards and cases: how many values, median, 95th
and 99th percentile and largest; and what B saved. Exit code 1 when they are apart by more than what grade B promises
of its last step: 0.1 mm anywhere, 0.2 degrees at the 99th percentile.
"""
import argparse
import datetime
import math
import pathlib
import sqlite3
import statistics
import subprocess
import sys

import records

ROOT = pathlib.Path(__file__).resolve().parents[1]
# What grade B lets the next Newton step move at most: a vertex, and a normal at the 99th percentile.
PROMISED_MM, PROMISED_DEG = 0.1, 0.2
MARKS = "<!-- grades: begin -->", "<!-- grades: end -->"
# With footprints of every size; each measures all metrics, whatever it judges by.
SCORECARDS = ("imu-inclination", "ecg", "pressure", "strain-respiration", "capacitive-ecg")
STUDY = """[study]
name = "grade {grade}"
design = "latin-hypercube"
samples = {count}
modalities = [{scorecards}]

[scenario.garment]
pattern = "{garment}"
[scenario.simulation]
certificate = "{grade}"

[[axis]]
name = "card"
fabrics = [{cards}]

[[axis]]
name = "fit"
levels = [
  {{ value = 0.05, set = {{ garment = {{ fit = {{ chest = 0.05, hip = 0.05, sleeve = 0.15 }} }} }} }},
  {{ value = 0.12, set = {{ garment = {{ fit = {{ chest = 0.12, hip = 0.12, sleeve = 0.2 }} }} }} }},
  {{ value = 0.25, set = {{ garment = {{ fit = {{ chest = 0.25, hip = 0.25, sleeve = 0.35 }} }} }} }},
]

[[axis]]
name = "wearing"
levels = [
  {{ label = "worn in", set = {{ donning = {{ repeats = 1 }} }} }},
  {{ label = "just put on", set = {{ donning = {{ movements = [] }} }} }},
]

[[axis]]
name = "edge"
key = "simulation.edge_length"
values = [{edges}]

[[axis]]
name = "wearer"
levels = [
  {{ label = "woman", set = {{ body = {{ sex = "female", height = 1.68 }} }} }},
  {{ label = "man", set = {{ body = {{ sex = "male", height = 1.78 }} }} }},
]

[[axis]]
name = "posture"
postures = [["standing"], ["forward-bend-30"], ["standing", "forward-bend-30"]]
"""
# Of which every value has its own line; keys that make two rows the same one.
TABLES = {"metrics": ("modality, site, donning, metric", "metric", "value"),
          "samples": ("modality, site, donning", "'score'", "score"),
          "garment": ("quantity", "quantity", "value")}


def quoted(words):
    return ", ".join(f'"{word}"' for word in words)


def run(options, grade):
    """One of the two studies, as far as it has not run."""
    cards = sorted(p.stem for p in (ROOT / "data" / "materials").glob("*.toml"))
    options.folder.mkdir(parents=True, exist_ok=True)
    file = options.folder / f"grade-{grade}.toml"
    file.write_text(STUDY.format(grade=grade, count=options.count, garment=options.garment, cards=quoted(cards),
                                 scorecards=quoted(SCORECARDS),
                                 edges=", ".join(f"{edge / 1000:g}" for edge in options.edges)))
    folder = options.folder / grade
    done = subprocess.run([options.binary, "study", "run", str(file), "-o", str(folder), "--jobs", str(options.jobs),
                           "--quiet"], check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"error: the study of grade {grade} ended with exit code {done.returncode}")
    return sqlite3.connect(f"{(folder / 'study.sqlite').absolute().as_uri()}?mode=ro", uri=True)


def apart(metric, x, y):
    """Angles go round."""
    difference = abs(x - y)
    if metric.endswith("_deg"):
        difference %= 360
        difference = min(difference, 360 - difference)
    return difference


def differences(b, a, table, numbers):
    """By metric, of the cases with these numbers."""
    keys, metric, value = TABLES[table]
    rows = f"SELECT number, {keys}, {metric}, {value} FROM {table} WHERE {value} IS NOT NULL"
    of_a = {row[:-2]: row[-1] for row in a.execute(rows)}
    found = {}
    for row in b.execute(rows):
        if row[0] in numbers and row[:-2] in of_a:
            found.setdefault(row[-2], []).append(apart(row[-2], row[-1], of_a[row[:-2]]))
    return found


def by_level(database, numbers):
    """How many of the cases with these numbers have each level of each axis."""
    found = {}
    for number, axis, label in database.execute("SELECT number, axis, label FROM levels ORDER BY axis, level"):
        counts = found.setdefault(axis, {})
        counts[label] = counts.get(label, 0) + (number in numbers)
    return found


def reasons(b, a, numbers):
    """Why cases have no result, by number and grade."""
    return {number: {grade: reason for grade, database in (("B", b), ("A", a))
                     for reason, in database.execute("SELECT reason FROM cases WHERE number = ?", (number,)) if reason}
            for number in sorted(numbers)}


def versions(database):
    """Of the programs whose results these are."""
    return {library: [version for version, in database.execute(
        "SELECT DISTINCT version FROM versions WHERE library = ? ORDER BY version", (library,))]
        for library in ("loosefit", "build")}


def summed_up(values):
    """Of absolute differences; the percentiles are values that occur, none smaller."""
    values = sorted(values)
    last = len(values) - 1
    return {"values": len(values), "equal": sum(v == 0 for v in values) / len(values),
            "median": statistics.median(values), "p95": values[math.ceil(0.95 * last)],
            "p99": values[math.ceil(0.99 * last)], "largest": values[-1]}


def beyond_promise(metric, row):
    """Whether a metric differs by more than grade B says that is left to go."""
    return (metric.endswith("_deg") and row["p99"] > PROMISED_DEG) or \
        (metric.endswith("_mm") and row["largest"] > PROMISED_MM)


def print_table(title, rows):
    print(f"\n{title:34}{'values':>8}{'equal':>8}{'median':>11}{'p95':>11}{'p99':>11}{'largest':>11}")
    for metric, row in rows.items():
        print(f"{metric:34}{row['values']:8}{100 * row['equal']:6.0f} %{row['median']:11.2e}{row['p95']:11.2e}"
              f"{row['p99']:11.2e}{row['largest']:11.2e}{'  more than promised' if beyond_promise(metric, row) else ''}")


def put_into(page, tables):
    """The table of all metrics between the marks in a Markdown page. ValueError without them."""
    rows = ["| metric | values | the same bit by bit | median | 95th percentile | 99th percentile | largest |",
            "|---|---|---|---|---|---|---|"]
    for table in tables.values():
        for metric, row in table.items():
            figures = " | ".join(f"{row[name]:.2g}" for name in ("median", "p95", "p99", "largest"))
            rows.append(f"| `{metric}` | {row['values']} | {100 * row['equal']:.0f} % | {figures} |")
    text = page.read_text()
    before, after = text.index(MARKS[0]) + len(MARKS[0]), text.index(MARKS[1])
    page.write_text(text[:before] + "\n" + "\n".join(rows) + "\n" + text[after:])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--count", type=int, default=60, help="cases")
    parser.add_argument("--edges", type=float, nargs="+", default=[14, 20], metavar="MM")
    parser.add_argument("--garment", default="long-sleeve-shirt")
    parser.add_argument("--jobs", type=int, default=0, help="cases at a time; 0: one per core")
    parser.add_argument("--json", type=pathlib.Path, help="keep the table in this file")
    parser.add_argument("--page", type=pathlib.Path, help="write the table between the marks of this page")
    options = parser.parse_args()
    b, a = run(options, "B"), run(options, "A")
    states = "SELECT number, status, grade FROM cases"
    of_b = {number: (status, grade) for number, status, grade in b.execute(states)}
    of_a = {number: status for number, status, _ in a.execute(states)}
    both = {n for n in of_b if of_b[n][0] == of_a[n] == "done"}
    ended_b = {n for n in both if of_b[n][1] == "B"}
    if not ended_b:
        print("error: no case ended with grade B and came to rest to grade A, too", file=sys.stderr)
        return 1
    seconds = [sum(s for n, s in db.execute("SELECT number, seconds FROM execution") if n in both) for db in (b, a)]
    tables = {table: {metric: summed_up(values) for metric, values in sorted(differences(b, a, table, ended_b).items())}
              for table in TABLES}
    found = {"cases": len(of_b), "came_to_rest_in_both": len(both), "ended_with_b": len(ended_b),
             "ended_with_b_by_level": by_level(b, ended_b), "not_in_both": reasons(b, a, set(of_b) - both),
             "seconds_b_over_a": seconds[0] / seconds[1]}
    print(f"{len(of_b)} cases, {len(both)} came to rest in both ways, {len(ended_b)} of them ended with B; "
          f"seconds B / A: {found['seconds_b_over_a']:.3f}")
    print("differences of those that ended with B; 'equal': bit by bit")
    print_table("metric of a site", tables["metrics"])
    print_table("of a sample", tables["samples"])
    print_table("of the whole garment", tables["garment"])
    for axis, labels in found["ended_with_b_by_level"].items():
        print(f"{axis}: " + ", ".join(f"{label} {count}" for label, count in labels.items()))
    if options.json:
        record = {"date": datetime.date.today().isoformat(), "kind": options.garment, "edges_mm": options.edges,
                  "versions": versions(b)} | found | tables
        options.json.write_text(records.json_lines(record) + "\n")
    if options.page:
        put_into(options.page, tables)
    return int(any(beyond_promise(metric, row) for rows in tables.values() for metric, row in rows.items()))


if __name__ == "__main__":
    sys.exit(main())
