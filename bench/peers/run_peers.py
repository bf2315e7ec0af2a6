#!/usr/bin/env python3
"""Runs the peer case with Loosefit and with Blender in turn, and writes the ratio.

usage: run_peers.py [--program build/bin/loosefit_peer] [--blender blender] [--size 10k|31k]
                    [--cores N] [--runs N] [--out DIR] [--record NOTE]

Seconds are those of whole processes, start-up included. Without Blender only Loosefit runs.
"""
import argparse
import datetime
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from records import write  # noqa: E402
from run_bench import git, machine, median, run_process  # noqa: E402

EDGES = {"10k": 0.0109, "31k": 0.0061}  # metres
LIMIT = 3600  # seconds per process


def timed(command, folder, cores):
    code, wall, cpu, peak, message = run_process(command, cores, LIMIT)
    message = message.replace(str(folder) + "/", "")  # no places of this machine in what is stored
    return {"exit_code": code, "wall_seconds": round(wall, 2), "cpu_seconds": round(cpu, 2),
            "peak_memory_mb": round(peak, 1)} | ({"error": message} if code not in (0, 1) else {})


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(HERE.parents[1] / "build/bin/loosefit_peer"))
    parser.add_argument("--blender", default="blender")
    parser.add_argument("--size", choices=EDGES, default="10k")
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--cores", type=int, help="hold both programs to so many cores")
    parser.add_argument("--out", help="keep meshes and figures in this folder")
    parser.add_argument("--record", metavar="NOTE", help="add to bench/history")
    options = parser.parse_args()
    if not pathlib.Path(options.program).is_file():
        parser.error(f"{options.program}: no such program; make bench-kernels builds it")
    blender = shutil.which(options.blender)
    if not blender:
        print(f"{options.blender}: not installed, Loosefit alone is run")
    record = {"date": datetime.date.today().isoformat(),
              "commit": git("rev-parse", "--short", "HEAD")
              + ("+" if git("status", "--porcelain", "-uno") else ""),
              "note": options.record or "", "machine": machine(), "size": options.size, "cores_used": options.cores,
              "loosefit": [], "blender": []}
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(options.out or scratch).resolve()
        subprocess.run([sys.executable, str(HERE / "make_case.py"), str(out)], check=True)
        case = [options.program, str(out / "shirt.json"), str(out / "torso.obj"),
                "--edge-length", str(EDGES[options.size])]
        panels = out / f"panels-{options.size}.json"
        subprocess.run([*case, "--panels", str(panels)], check=True)
        for _ in range(options.runs):
            figures = out / "loosefit.json"
            row = timed([*case, "--json", str(figures), "--mesh", str(out / "loosefit.obj")], out, options.cores)
            if figures.exists():
                row |= {"program": json.loads(figures.read_text())}
                figures.unlink()
            record["loosefit"].append(row)
            print("loosefit", row, flush=True)
            if not blender:
                continue
            figures = out / "blender.json"
            row = timed([blender, "-b", "--factory-startup", "-P", str(HERE / "blender_cloth.py"), "--",
                         str(panels), str(out / "torso.obj"), str(figures),
                         "--mesh", str(out / "blender.obj")], out, options.cores)
            if figures.exists():
                row |= {"program": json.loads(figures.read_text())}
                figures.unlink()
            record["blender"].append(row)
            print("blender", {k: v for k, v in row.items() if k != "program"}, flush=True)
    for key in ("wall_seconds", "cpu_seconds"):
        values = [median([row[key] for row in record[name]]) for name in ("loosefit", "blender")]
        if all(values):
            record[f"ratio_{key}"] = round(values[1] / values[0], 2)
            print(f"{key}: Loosefit {values[0]}, Blender {values[1]}: Blender / Loosefit "
                  f"{record[f'ratio_{key}']}")
    if options.record is not None:
        path = HERE.parent / "history" / (
            f"peers-{record['date']}-{record['commit'].rstrip('+')}-{options.size}"
            + (f"-{options.cores}-core" if options.cores else "") + ".json")
        write(path, record)
        print(f"written: bench/history/{path.name}")
    return 0 if all(row["exit_code"] == 0 for row in record["loosefit"]) else 1


if __name__ == "__main__":
    sys.exit(main())
