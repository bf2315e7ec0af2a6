#!/usr/bin/env python3
"""How far cases that are content with certificate grade B are from the same ones that go on to grade A.

usage: grades.py FOLDER [--binary FILE] [--count N] [--edges MM MM] [--garment KIND] [--jobs N]

Two studies of the same N cases, one to grade B and one to grade A: fabric cards, two fits, two edge lengths, two
wearers, and standing or bent forward alone (where the drape that is measured itself ends with B) or one after the
other (for metrics over postures), each level equally often (Latin hypercube). Both are kept in FOLDER; the same
command goes on where it stopped. Prints, for every metric of a site that the program knows and for every figure
of the whole garment, the absolute difference over all sites, scorecards and cases: how many values, median, 95th
percentile and largest; and what B saved.
"""
import argparse
import pathlib
import sqlite3
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# With footprints of every size; each measures all metrics, whatever it judges by.
SCORECARDS = ("imu-inclination", "ecg", "pressure", "strain-respiration", "capacitive-ecg")
STUDY = """[study]
name = "grade {grade}"
design = "latin-hypercube"
samples = {count}
modalities = [{scorecards}]

[scenario.garment]
pattern = "{garment}"
[scenario.donning]
movements = []
[scenario.simulation]
certificate = "{grade}"

[[axis]]
name = "card"
fabrics = [{cards}]

[[axis]]
name = "fit"
levels = [
  {{ value = 0.05, set = {{ garment = {{ fit = {{ chest = 0.05, hip = 0.05, sleeve = 0.15 }} }} }} }},
  {{ value = 0.25, set = {{ garment = {{ fit = {{ chest = 0.25, hip = 0.25, sleeve = 0.35 }} }} }} }},
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


def print_table(title, found):
    print(f"\n{title:34}{'values':>8}{'equal':>8}{'median':>11}{'p95':>11}{'largest':>11}")
    for metric, values in sorted(found.items()):
        values.sort()
        equal = sum(v == 0 for v in values) / len(values)
        print(f"{metric:34}{len(values):8}{100 * equal:6.0f} %{statistics.median(values):11.2e}"
              f"{values[int(0.95 * (len(values) - 1))]:11.2e}{values[-1]:11.2e}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--count", type=int, default=60, help="cases")
    parser.add_argument("--edges", type=float, nargs="+", default=[14, 20], metavar="MM")
    parser.add_argument("--garment", default="long-sleeve-shirt")
    parser.add_argument("--jobs", type=int, default=0, help="cases at a time; 0: one per core")
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
    print(f"{len(of_b)} cases, {len(both)} came to rest in both ways, {len(ended_b)} of them ended with B; "
          f"seconds B / A: {seconds[0] / seconds[1]:.3f}")
    print("differences of those that ended with B; 'equal': bit by bit")
    print_table("metric of a site", differences(b, a, "metrics", ended_b))
    print_table("of the whole garment", differences(b, a, "garment", ended_b))
    return 0


if __name__ == "__main__":
    sys.exit(main())
