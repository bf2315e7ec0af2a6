#!/usr/bin/env python3
"""Puts many garments on many people and tells how many are worn, settled, certified and worn as they are cut, by class.

usage: corpus.py [--patterns DIR_OR_FILE ...] [--bodies DIR_OR_FILE ...] [--json FILE] [--csv FILE] [--binary FILE]
                 [--edge METRES] [--budget SECONDS] [--only WORD ...] [--keep-versions] [-j N] [--out DIR] [--list]
                 [--write-patterns DIR] [--twins] [--sample N] [--seed N]
       corpus.py --json FILE [FILE ...] --report FILE

Garments: those of corpus/garments.py, written anew in GarmentCode's grammar, those of corpus/drawn.py, SVG without seams or places,
those of corpus/cad.py, DXF as CAD programs store it, the drafts of corpus/drafts.py, some of them as DXF that the program writes and
reads back, and the files given. People: those of corpus/people.py, for whom garments are cut to their measures but placed as for
somebody of 1.72 m, and the meshes given, who get what an average adult wears. With --twins also the scans of corpus/twins.py, which wear
what their parametric twins do. With --sample each garment is worn by N people drawn at random, so that a part of the corpus stands for
all. Each pair is one run at the given edge length without movements of the wearer.

With --json the record is written after every run. Pairs that it holds are done again where the program, the garment, the person,
the edge length or the budget has changed since; with --keep-versions results of other programs stay. --only does what it names again.

Worn as cut is what is certified, has no warning that it is cut too tight or that a waist has risen, and presses with at most fifty
times its weight, unless it is meant to be stretched. --report writes such a record as a page, with version and date of the runs.
"""
import argparse
import collections
import concurrent.futures
import csv
import datetime
import hashlib
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench" / "corpus"))
import cad  # noqa: E402
import drafts  # noqa: E402
import drawn  # noqa: E402
import garments  # noqa: E402
import people  # noqa: E402
import report  # noqa: E402

from run_bench import run_process  # noqa: E402

KILL_AFTER = 120  # seconds beyond the time budget
SEAMS = cad.SEAMS | {name: cad.side_file(seams) for name, seams in drafts.SEAMS.items()}
STRETCHED = garments.STRETCHED | drawn.STRETCHED | drafts.STRETCHED

SCENARIO = """[body]
{body}

[garment]
{garment}

[material]
name = "{fabric}"

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
    return garments.build(make) | drawn.build(make) | cad.build(make)


def file_name(name, person=None):
    ending = ".svg" if name.startswith("drawn_") else ".dxf" if name.startswith("dxf_") else "_specification.json"
    return f"{name}-{person}{ending}" if person else name + ending


def program_of(binary):
    """Version and a mark of the very file, since many builds have one version."""
    version = subprocess.run([binary, "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0].strip()
    found = pathlib.Path(shutil.which(binary) or binary).read_bytes()
    return f"{version} ({hashlib.sha256(found).hexdigest()[:10]})"


class Task:
    """One garment on one person."""

    def __init__(self, name, kind, body, garment, fabric, content):
        self.name, self.kind, self.body, self.garment, self.fabric = name, kind, body, garment, fabric
        self.stretched = name.split("@")[0] in STRETCHED
        self.cut = hashlib.sha256("\n".join([re.sub(r'"/[^"]*/', '"', body + garment), fabric, content]).encode()).hexdigest()[:10]

    def is_done(self, row, program, options):
        """Whether a row of a record is of this garment, person, program and settings."""
        same = all(row.get(k) == v for k, v in (("cut", self.cut), ("edge", options.edge), ("budget", options.budget)))
        return same and (options.keep_versions or row.get("program") == program)

    def run(self, options, program, folder):
        """One row: what became of a garment on a person, and why."""
        scenario = folder.with_suffix(".toml")
        scenario.write_text(SCENARIO.format(body=self.body, garment=self.garment, fabric=self.fabric, edge=options.edge, budget=options.budget))
        shutil.rmtree(folder, ignore_errors=True)  # what an earlier run left there is no answer
        code, wall, cpu, _, message = run_process([options.binary, "run", str(scenario), "-o", str(folder), "--quiet", "--no-pictures"], None,
                                                  options.budget + KILL_AFTER)
        row = {"class": self.kind, "worn": False, "settled": False, "certified": False, "worn_as_cut": False, "stretched": self.stretched,
               "wall_seconds": round(wall, 1), "cpu_seconds": round(cpu, 1), "reason": "", "program": program,
               "date": datetime.date.today().isoformat(), "cut": self.cut, "edge": options.edge, "budget": options.budget}
        file = folder / "summary.json"
        if not file.exists():
            return row | {"reason": message.strip().replace(str(folder.parent) + "/", "") or f"exit {code} without a message"}
        return row | figures(json.loads(file.read_text()), self.stretched)


def figures(summary, stretched):
    """What a record keeps of a summary."""
    row = {"worn": bool(summary["worn"]), "settled": bool(summary["settled"])}
    row["certified"] = row["settled"] and row["worn"]
    reasons = list(summary.get("worn_reasons") or [])
    if not row["settled"]:
        reasons.append(f"not settled: {summary['stop_reason']}, residual {summary['residual']:.1e}, intersections {summary['intersections']}")
    load = summary.get("load") or {}
    weights = load.get("force_over_weight")
    if weights is not None:
        row["force_over_weight"] = round(weights, 1)
        if load.get("weight_N"):  # what is squeezed between arms and trunk is no want of ease
            row["squeezed_over_weight"] = round((load.get("between_arm_and_trunk_N") or 0) / load["weight_N"], 1)
    row["strain"] = {k: {"largest": round(d["largest"], 4), "limit": d["limit"], "share_beyond": round(d["share_beyond"] or 0, 5)}
                     for k, d in (summary.get("strain_range") or {}).items() if isinstance(d, dict) and d.get("largest") is not None}
    row["beyond_range"] = round(max([0] + [d["largest"] - d["limit"] for k, d in row["strain"].items() if k != "shear_rad" and d["limit"] is not None]), 4)
    row["held_off"] = (summary.get("settle") or {}).get("held_off_triangles")
    row["warnings"] = list(summary.get("warnings") or [])
    told = [w for w in row["warnings"] if report.is_of_cut(w)]
    heavy = not stretched and weights is not None and weights > report.WEIGHTS
    row["worn_as_cut"] = row["certified"] and not told and not heavy
    return row | {"reason": "; ".join(reasons)}


def export(name, who, body, options, program, folder):
    """Has the program write a draft for somebody as DXF; an error leaves no file, and the run says so."""
    target, file = folder / f"export-{name}-{who}", folder / file_name(name, who)
    mark = target.with_suffix(".program")
    if file.exists() and mark.exists() and mark.read_text() == program:
        return
    file.unlink(missing_ok=True)
    shutil.rmtree(target, ignore_errors=True)
    scenario = target.with_suffix(".toml")
    scenario.write_text(f"[body]\n{body}\n\n[garment]\n{drafts.EXPORTS[name]}\n")
    answer = subprocess.run([options.binary, "pattern", "--scenario", str(scenario), "-o", str(target)], capture_output=True, text=True)
    if answer.returncode:
        print(f"{name}@{who}: {answer.stderr.strip()}", flush=True)
        return
    file.write_text((target / "pattern.dxf").read_text())
    mark.write_text(program)


def tasks(options, program, folder):
    """All pairs, in a fixed order."""
    bodies = {} if options.no_people else {name: (p["body"], p["make"]) for name, p in people.PEOPLE.items()}
    if options.twins:
        import twins
        for name, (who, _) in twins.TWINS.items():
            scan = twins.make(name, folder, options.binary, twins.NOISE, 1)
            bodies[name] = (f'file = "{scan.resolve()}"', people.PEOPLE[who]["make"])
    for file in files(options.bodies, {".obj", ".ply", ".stl"}):
        bodies[file.stem] = (f'file = "{file.resolve()}"', None)
    wanted = []
    for b, (body, make) in bodies.items():
        name_of = lambda garment: f"{garment}@{b}"  # noqa: B023
        for name, (kind, text) in ({} if options.no_own else own_garments(make)).items():
            file = folder / file_name(name, b)
            file.write_text(text)
            seams = SEAMS.get(name, "")
            if seams:
                file.with_suffix(".seams.toml").write_text(seams)
            wanted.append(Task(name_of(name), kind, body, f'pattern = "{file.resolve()}"', drafts.PAPER, text + seams))
        if not options.no_own:
            for name, (garment, fabric) in drafts.DRAFTS.items():
                wanted.append(Task(name_of(name), "draft", body, garment, fabric, ""))
            for name in drafts.EXPORTS:
                file = folder / file_name(name, b)
                if name in SEAMS:
                    file.with_suffix(".seams.toml").write_text(SEAMS[name])
                wanted.append(Task(name_of(name), "draft as DXF", body, f'pattern = "{file.resolve()}"', drafts.PAPER,
                                   drafts.EXPORTS[name] + SEAMS.get(name, "")))
        for file in files(options.patterns, {".json", ".svg", ".dxf"}):
            wanted.append(Task(name_of(file.stem.replace("_specification", "")), "file", body, f'pattern = "{file.resolve()}"', drafts.PAPER,
                               file.read_text(errors="replace")))
    return wanted


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--patterns", nargs="*", default=[])
    parser.add_argument("--bodies", nargs="*", default=[])
    parser.add_argument("--json", nargs="*", default=[], help="the record; several only with --report")
    parser.add_argument("--report", help="write the records as a page, and run nothing")
    parser.add_argument("--csv")
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--edge", type=float, default=0.020)
    parser.add_argument("--budget", type=float, default=120)
    parser.add_argument("--only", nargs="*", help="names of runs (GARMENT@PERSON) must have one of these words in them")
    parser.add_argument("--keep-versions", action="store_true", help="keep results of other programs, as long as garment and person are the same")
    parser.add_argument("--no-own", action="store_true", help="leave out the garments of corpus/")
    parser.add_argument("--no-people", action="store_true", help="leave out the people of corpus/people.py")
    parser.add_argument("--twins", action="store_true", help="also scans made from twins (needs numpy)")
    parser.add_argument("--sample", type=int, default=0, help="people per garment, drawn at random; 0: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out")
    parser.add_argument("--write-patterns", help="only write the garments there")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("-j", type=int, default=1)
    options = parser.parse_args()

    if options.report:
        pathlib.Path(options.report).write_text(report.page([(file, json.loads(pathlib.Path(file).read_text())) for file in options.json]))
        return 0
    if len(options.json) > 1:
        parser.error("--json takes one file, but with --report")
    if options.write_patterns:
        target = pathlib.Path(options.write_patterns)
        target.mkdir(parents=True, exist_ok=True)
        for name, (_, text) in own_garments(None).items():
            (target / file_name(name)).write_text(text)
            if name in SEAMS:
                (target / file_name(name)).with_suffix(".seams.toml").write_text(SEAMS[name])
        return 0
    folder = pathlib.Path(options.out or tempfile.mkdtemp(prefix="corpus-"))
    folder.mkdir(parents=True, exist_ok=True)
    program = program_of(options.binary)
    record = pathlib.Path(options.json[0]) if options.json else None
    rows = json.loads(record.read_text())["runs"] if record and record.exists() else {}
    wanted = tasks(options, program, folder)
    if options.sample:
        draw = random.Random(options.seed)
        by_garment = collections.defaultdict(list)
        for w in wanted:
            by_garment[w.name.split("@")[0]].append(w)
        wanted = [w for of in by_garment.values() for w in draw.sample(of, min(options.sample, len(of)))]
    asked = {w.name for w in wanted}
    if options.only:
        wanted = [w for w in wanted if any(word in w.name for word in options.only)]
    else:
        stale = {w.name for w in wanted if w.name in rows and not w.is_done(rows[w.name], program, options)}
        wanted = [w for w in wanted if w.name not in rows or w.name in stale]
        if stale:
            print(f"{len(stale)} of the record are of another program, cut or setting, and are done again", flush=True)
        if others := [name for name in rows if name not in asked]:
            print(f"{len(others)} of the record were not asked for and stay as they are", flush=True)
    if options.list:
        print("\n".join(w.name for w in wanted))
        return 0
    for w in wanted:
        if w.kind == "draft as DXF":
            export(*w.name.split("@"), w.body, options, program, folder)
    with concurrent.futures.ThreadPoolExecutor(options.j) as pool:
        jobs = {pool.submit(w.run, options, program, folder / w.name.replace("@", "-")): w.name for w in wanted}
        for job in concurrent.futures.as_completed(jobs):
            name, row = jobs[job], job.result()
            rows[name] = row
            told = "ok " if row["worn_as_cut"] else "cut" if row["certified"] else "BAD"
            print(f"{told} {name}  {row['cpu_seconds']} s  {row.get('force_over_weight', '-')} weights  {row['reason'] or report.why_not_as_cut(row)}",
                  flush=True)
            if record:
                partial = record.with_name("." + record.name)
                partial.write_text(json.dumps({"edge": options.edge, "budget": options.budget, "sample": options.sample, "seed": options.seed,
                                               "asked": len(asked), "runs": dict(sorted(rows.items()))}, indent=1))
                partial.replace(record)
    print(report.table(rows))
    if options.csv:
        keys = ("class", "worn", "settled", "certified", "worn_as_cut", "force_over_weight", "beyond_range", "held_off", "wall_seconds", "cpu_seconds",
                "program", "date", "reason")
        with open(options.csv, "w", newline="") as out:
            writer = csv.writer(out)
            writer.writerow(["garment", "person", *keys, "warnings"])
            for name, r in sorted(rows.items()):
                writer.writerow(name.split("@") + [r.get(k, "") for k in keys] + [" | ".join(r.get("warnings", []))])
    return 0 if all(r["certified"] for r in rows.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
