#!/usr/bin/env python3
"""Puts many garments on many people and tells how many are worn, settled and certified, by class.

usage: corpus.py [--patterns DIR_OR_FILE ...] [--bodies DIR_OR_FILE ...] [--json FILE] [--csv FILE] [--binary FILE]
                 [--edge METRES] [--budget SECONDS] [--only WORD ...] [-j N] [--out DIR] [--list] [--write-patterns DIR]
                 [--twins] [--sample N] [--seed N]

Garments: those of corpus/garments.py, written anew in GarmentCode's grammar, those of corpus/drawn.py, SVG without seams or places, and the
files given. People: those of
corpus/people.py, for whom garments are cut to their girths and height but placed as for somebody of 1.72 m, and the meshes given, who
get what an average adult wears. With --twins also the scans of corpus/twins.py, which wear what their parametric twins do. With
--sample each garment is worn by N people drawn at random, so that a part of the corpus stands for all. Each pair is one run at the given edge length without movements of the wearer. With --json the
record is written after every run, and pairs that it holds already are not run again unless --only names them.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import pathlib
import random
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench" / "corpus"))
import drawn  # noqa: E402
import garments  # noqa: E402
import people  # noqa: E402

from run_bench import run_process  # noqa: E402

KILL_AFTER = 120  # seconds beyond the time budget

SCENARIO = """[body]
{body}

[garment]
pattern = "{pattern}"

[material]
name = "paper-cotton"

[simulation]
edge_length = {edge}
seed = 1
time_budget = {budget}

[donning]
movements = []

[output]
maps = ["distance"]
preset_sites = false
"""


def files(given, endings):
    found = []
    for entry in map(pathlib.Path, given):
        found += sorted(p for p in entry.iterdir() if p.suffix in endings) if entry.is_dir() else [entry]
    return found


def own_garments(make):
    return garments.build(make) | drawn.build(make)


def file_name(name, person=None):
    ending = ".svg" if name.startswith("drawn_") else "_specification.json"
    return f"{name}-{person}{ending}" if person else name + ending


def run(name, kind, pattern, body, options, folder):
    """One row: what became of a garment on a person, and why."""
    scenario = folder.with_suffix(".toml")
    scenario.write_text(SCENARIO.format(body=body, pattern=pattern, edge=options.edge, budget=options.budget))
    shutil.rmtree(folder, ignore_errors=True)  # what an earlier run left there is no answer
    code, wall, cpu, peak, message = run_process(
        [options.binary, "run", str(scenario), "-o", str(folder), "--quiet", "--no-pictures"], None,
        options.budget + KILL_AFTER)
    row = {"class": kind, "worn": False, "settled": False, "certified": False, "wall_seconds": round(wall, 1),
           "cpu_seconds": round(cpu, 1), "reason": ""}
    file = folder / "summary.json"
    if not file.exists():
        return row | {"reason": message.strip().replace(str(folder.parent) + "/", "") or f"exit {code} without a message"}
    summary = json.loads(file.read_text())
    cuts = summary["intersections"]
    row |= {"worn": bool(summary["worn"]), "settled": bool(summary["settled"])}
    row["certified"] = row["settled"] and row["worn"]
    reasons = list(summary.get("worn_reasons") or [])
    if not row["settled"]:
        reasons.append(f"not settled: {summary['stop_reason']}, residual {summary['residual']:.1e}, intersections {cuts}")
    return row | {"reason": "; ".join(reasons)}


def table(rows):
    """Share of certified runs by class."""
    classes = collections.defaultdict(list)
    for row in rows.values():
        classes[row["class"]].append(row)
    lines = [f"{'class':24} {'runs':>5} {'worn':>5} {'settled':>8} {'both':>5} {'share':>6} {'cpu s':>6}"]
    for kind, of in sorted(classes.items()) + [("all", list(rows.values()))]:
        n = len(of)
        both = sum(r["certified"] for r in of)
        cpu = sorted(r["cpu_seconds"] for r in of)[n // 2] if n else 0
        lines.append(f"{kind:24} {n:5} {sum(r['worn'] for r in of):5} {sum(r['settled'] for r in of):8} {both:5} "
                     f"{100 * both / max(1, n):5.0f}% {cpu:6.0f}")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--patterns", nargs="*", default=[])
    parser.add_argument("--bodies", nargs="*", default=[])
    parser.add_argument("--json")
    parser.add_argument("--csv")
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--edge", type=float, default=0.020)
    parser.add_argument("--budget", type=float, default=120)
    parser.add_argument("--only", nargs="*", help="names of runs (GARMENT@PERSON) must have one of these words in them")
    parser.add_argument("--no-own", action="store_true", help="leave out the garments of corpus/garments.py and corpus/drawn.py")
    parser.add_argument("--no-people", action="store_true", help="leave out the people of corpus/people.py")
    parser.add_argument("--twins", action="store_true", help="also scans made from twins (needs numpy)")
    parser.add_argument("--sample", type=int, default=0, help="people per garment, drawn at random; 0: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out")
    parser.add_argument("--write-patterns", help="only write the garments there")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("-j", type=int, default=1)
    options = parser.parse_args()

    if options.write_patterns:
        target = pathlib.Path(options.write_patterns)
        target.mkdir(parents=True, exist_ok=True)
        for name, (_, text) in own_garments(None).items():
            (target / file_name(name)).write_text(text)
        return 0
    folder = pathlib.Path(options.out or tempfile.mkdtemp(prefix="corpus-"))
    folder.mkdir(parents=True, exist_ok=True)
    bodies = {} if options.no_people else {name: (p["body"], p["make"]) for name, p in people.PEOPLE.items()}
    if options.twins:
        import twins
        for name, (who, _) in twins.TWINS.items():
            scan = twins.make(name, folder, options.binary, twins.NOISE, 1)
            bodies[name] = (f'file = "{scan.resolve()}"', people.PEOPLE[who]["make"])
    for file in files(options.bodies, {".obj", ".ply", ".stl"}):
        bodies[file.stem] = (f'file = "{file.resolve()}"', None)
    record = pathlib.Path(options.json) if options.json else None
    rows = json.loads(record.read_text())["runs"] if record and record.exists() else {}
    wanted = []
    for b, (body, make) in bodies.items():
        for name, (kind, text) in ({} if options.no_own else own_garments(make)).items():
            file = folder / file_name(name, b)
            file.write_text(text)
            wanted.append((f"{name}@{b}", kind, file, body))
        for file in files(options.patterns, {".json", ".svg", ".dxf"}):
            wanted.append((f"{file.stem.replace('_specification', '')}@{b}", "file", file.resolve(), body))
    if options.sample:
        draw = random.Random(options.seed)
        by_garment = collections.defaultdict(list)
        for w in wanted:
            by_garment[w[0].split("@")[0]].append(w)
        wanted = [w for of in by_garment.values() for w in draw.sample(of, min(options.sample, len(of)))]
    if options.only:
        wanted = [w for w in wanted if any(word in w[0] for word in options.only)]
    else:
        wanted = [w for w in wanted if w[0] not in rows]
    if options.list:
        print("\n".join(w[0] for w in wanted))
        return 0
    with concurrent.futures.ThreadPoolExecutor(options.j) as pool:
        jobs = {pool.submit(run, name, kind, file, body, options, folder / name.replace("@", "-")): name
                for name, kind, file, body in wanted}
        for job in concurrent.futures.as_completed(jobs):
            name, row = jobs[job], job.result()
            rows[name] = row
            print(f"{'ok ' if row['certified'] else 'BAD'} {name}  {row['cpu_seconds']} s  {row['reason']}", flush=True)
            if record:
                record.write_text(json.dumps({"edge": options.edge, "budget": options.budget, "runs": dict(sorted(rows.items()))}, indent=1))
    print(table(rows))
    if options.csv:
        with open(options.csv, "w", newline="") as out:
            writer = csv.writer(out)
            writer.writerow(["garment", "person", "class", "worn", "settled", "certified", "wall_seconds", "cpu_seconds", "reason"])
            for name, r in sorted(rows.items()):
                writer.writerow(name.split("@") + [r[k] for k in ("class", "worn", "settled", "certified", "wall_seconds", "cpu_seconds", "reason")])
    return 0 if all(r["certified"] for r in rows.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
