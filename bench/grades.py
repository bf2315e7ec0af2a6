#!/usr/bin/env python3
"""How far cases that are content with certificate grade B are from the same ones that go on to grade A.

usage: grades.py FOLDER [--binary FILE] [--count N] [--edges MM MM] [--garment KIND] [--jobs N] [--json FILE] [--page FILE]

Two studies of the same N cases, one to grade B and one to grade A: fabric cards, three fits, worn in or just put
on, two edge lengths, two wearers, and standing or bent forward alone (where the drape that is measured itself ends with B) or one after the
other (for metrics over postures), each level equally often (Latin hypercube). Both are kept in FOLDER; the same
command goes on where it stopped. Prints, for every metric of a site (not of lines) that the program knows and for every figure
of the whole garment, the absolute difference over all sites, scorecards and cases: how many values, median, 95th
and 99th percentile and largest; and what B saved. Exit code 1 when a value of one grade is missing from the other, or
the sites of a case are apart by more than what grade B promises of its last step: 0.1 mm anywhere, 0.2 degrees at the
99th percentile.
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
          # Most scores are 0 or 1, beyond which they are cut off; margins are not.
          "samples": ("modality, site, donning", "'margin'", "margin"),
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


def is_angle(metric):
    return metric.endswith("_deg") and not metric.endswith("_per_deg")


def apart(metric, x, y):
    """Angles go round."""
    difference = abs(x - y)
    if is_angle(metric):
        difference %= 360
        difference = min(difference, 360 - difference)
    return difference


def values_of(database, table, numbers):
    """{(case, key, …, metric): value} of the cases with these numbers."""
    keys, metric, value = TABLES[table]
    rows = database.execute(f"SELECT number, {keys}, {metric}, {value} FROM {table} WHERE {value} IS NOT NULL")
    return {row[:-1]: row[-1] for row in rows if row[0] in numbers}


def differences(b, a, table, numbers):
    """{(case, key, …, metric): absolute difference} of the values that both have; how many only one has."""
    of_b, of_a = values_of(b, table, numbers), values_of(a, table, numbers)
    found = {key: apart(key[-1], x, of_a[key]) for key, x in of_b.items() if key in of_a}
    return found, {"lost": len(of_a) - len(found), "gained": len(of_b) - len(found)}


def by_metric(found):
    values = {}
    for key, difference in found.items():
        values.setdefault(key[-1], []).append(difference)
    return {metric: summed_up(of_metric) for metric, of_metric in sorted(values.items())}


def by_case(b, found):
    """Of each case its residual and how far its sites are apart: largest of lengths, 99th percentile and largest of
    angles, and where these are. The case that is farthest apart comes first."""
    residuals = dict(b.execute("SELECT number, residual FROM cases"))
    cases = []
    for number in sorted({key[0] for key in found}):
        lengths = {key: d for key, d in found.items() if key[0] == number and key[-1].endswith("_mm")}
        angles = {key: d for key, d in found.items() if key[0] == number and is_angle(key[-1])}
        longest, widest = max(lengths, key=lengths.get), max(angles, key=angles.get)
        p99 = quantile(sorted(angles.values()), 0.99)
        cases.append({"case": number, "residual": residuals[number],
                      "largest_mm": lengths[longest], "at_mm": [str(word) for word in longest[1:-1]],
                      "p99_deg": p99, "largest_deg": angles[widest], "at_deg": [str(word) for word in widest[1:-1]],
                      "beyond": lengths[longest] > PROMISED_MM or p99 > PROMISED_DEG})
    return sorted(cases, key=lambda case: -max(case["largest_mm"] / PROMISED_MM, case["p99_deg"] / PROMISED_DEG))


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


def quantile(values, p):
    """The ⌈p n⌉-th smallest of sorted values: one that occurs."""
    return values[max(0, math.ceil(p * len(values) - 1e-9) - 1)]


def summed_up(values):
    """Of absolute differences."""
    values = sorted(values)
    return {"values": len(values), "equal": sum(v == 0 for v in values) / len(values),
            "median": statistics.median(values), "p95": quantile(values, 0.95),
            "p99": quantile(values, 0.99), "largest": values[-1]}


def print_table(title, rows):
    print(f"\n{title:34}{'values':>8}{'equal':>8}{'median':>11}{'p95':>11}{'p99':>11}{'largest':>11}")
    for metric, row in rows.items():
        print(f"{metric:34}{row['values']:8}{100 * row['equal']:6.0f} %{row['median']:11.2e}{row['p95']:11.2e}"
              f"{row['p99']:11.2e}{row['largest']:11.2e}")


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
    found = {table: differences(b, a, table, ended_b) for table in TABLES}
    tables = {table: by_metric(values) for table, (values, _) in found.items()}
    missing = {table: counts for table, (_, counts) in found.items()}
    cases = by_case(b, found["metrics"][0])
    beyond = [case for case in cases if case["beyond"]]
    record = {"date": datetime.date.today().isoformat(), "kind": options.garment, "edges_mm": options.edges,
              "versions": versions(b), "cases": len(of_b), "came_to_rest_in_both": len(both),
              "ended_with_b": len(ended_b), "ended_with_b_by_level": by_level(b, ended_b),
              "not_in_both": reasons(b, a, set(of_b) - both), "seconds_b_over_a": seconds[0] / seconds[1],
              "missing": missing, "beyond": len(beyond), "by_case": cases} | tables
    print(f"{len(of_b)} cases, {len(both)} came to rest in both ways, {len(ended_b)} of them ended with B; "
          f"seconds B / A: {record['seconds_b_over_a']:.3f}")
    print("differences of those that ended with B; 'equal': bit by bit")
    print_table("metric of a site", tables["metrics"])
    print_table("of a sample", tables["samples"])
    print_table("of the whole garment", tables["garment"])
    for axis, labels in record["ended_with_b_by_level"].items():
        print(f"{axis}: " + ", ".join(f"{label} {count}" for label, count in labels.items()))
    for case in cases[:3]:
        print(f"case {case['case']}, residual {case['residual']:.4f}: {case['largest_mm']:.3f} mm at "
              f"{' '.join(case['at_mm'])}, {case['largest_deg']:.3f} degrees at {' '.join(case['at_deg'])} (99 % below "
              f"{case['p99_deg']:.3f}){', more than promised' if case['beyond'] else ''}")
    print(f"{len(beyond)} of {len(cases)} cases are farther apart than promised; values of A that B lacks, and of B "
          f"that A lacks: " + ", ".join(f"{t} {c['lost']}, {c['gained']}" for t, c in missing.items()))
    if options.json:
        options.json.write_text(records.json_lines(record) + "\n")
    if options.page:
        put_into(options.page, tables)
    return int(bool(beyond) or any(c["lost"] or c["gained"] for c in missing.values()))


if __name__ == "__main__":
    sys.exit(main())
