#!/usr/bin/env python3
"""How many drapes an hour a study yields on this machine, and what a second worker brings.

usage: throughput.py [--binary FILE] [--people N] [--edges-mm 14 10] [--json FILE]

Shirts in two postures after two donnings, worn in, on people of the shipped statistics: a study with one
worker and one thread, then the same with a worker per core (as `study run` does). Drapes that do not
settle count as failed, not as drapes. Take people enough that the last case, with one worker idle, is a
small part. Core seconds hardly change when other work runs beside; the rest needs a quiet machine.
"""
import argparse
import datetime
import os
import pathlib
import resource
import sqlite3
import subprocess
import tempfile
import time

import records

ROOT = pathlib.Path(__file__).resolve().parents[1]


def study(people, edge_mm):
    return f"""[study]
name = "throughput"
seed = 5
modalities = ["imu-inclination"]
[scenario.garment]
pattern = "long-sleeve-shirt"
fit = {{ chest = 0.12, hip = 0.12, sleeve = 0.2 }}
[scenario.material]
name = "cotton-jersey"
[scenario.postures]
list = ["standing", "forward-bend-15"]
[scenario.donning]
repeats = 2
[scenario.simulation]
edge_length = {edge_mm / 1000:g}
[[axis]]
name = "person"
people = {{ statistics = "ansur-2012", sex = "both", count = {people} }}
"""


def core_seconds():
    """Processor time of all processes that have ended, their children included."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(binary, text, jobs):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "study.toml"
        file.write_text(text)
        begun, used = time.monotonic(), core_seconds()
        subprocess.run([binary, "study", "run", str(file), "-o", f"{folder}/out", "--jobs", str(jobs)],
                       check=True, capture_output=True)
        seconds = time.monotonic() - begun
        database = sqlite3.connect(f"{folder}/out/study.sqlite")
        asked, counted = database.execute(
            "SELECT SUM(drapes), SUM(COALESCE(drapes_counted, 0)) FROM cases").fetchone()
        if not counted:
            raise SystemExit(f"no drape settled of {asked}")
        return {"jobs": jobs, "seconds": seconds, "asked": asked, "drapes": counted,
                "per_hour": 3600 * counted / seconds,
                "core_seconds_a_drape": (core_seconds() - used) / counted}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--people", type=int, default=8)
    parser.add_argument("--edges-mm", type=float, nargs="+", default=[14, 10])
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    cores = len(os.sched_getaffinity(0))
    rows = []
    print(f"{'edge mm':>8}{'workers':>9}{'drapes':>8}{'of':>5}{'seconds':>9}{'an hour':>9}{'scaling':>9}{'core s':>8}")
    for edge in options.edges_mm:
        alone = None
        for jobs in sorted({1, cores}):
            row = timed(options.binary, study(options.people, edge), jobs)
            alone = alone or row["per_hour"]
            row |= {"edge_mm": edge, "scaling": row["per_hour"] / alone}
            rows.append(row)
            print(f"{edge:8g}{jobs:9}{row['drapes']:8}{row['asked']:5}{row['seconds']:9.0f}"
                  f"{row['per_hour']:9.0f}{row['scaling']:9.2f}{row['core_seconds_a_drape']:8.1f}", flush=True)
    if options.json:
        record = {"date": datetime.date.today().isoformat(), "cases": rows}
        options.json.write_text(records.json_lines(record) + "\n")


if __name__ == "__main__":
    main()
