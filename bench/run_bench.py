#!/usr/bin/env python3
"""Benchmarks of the whole program, from the numbers in summary.json.

usage: run_bench.py --binary build/bin/loosefit [--rows reference-shirt,matrix] [--runs N]
                    [--jobs N] [--edge-length M] [--bodies A,B] [--pictures]
                    [--out DIR] [--record NOTE]

Rows
  reference-shirt  examples/reference-shirt.toml: seconds per stage, peak memory (best of --runs)
  matrix           four bodies x five chest fits: settled, residual, intersections, seconds, and the
                   hoop strain at the chest, which for a tight garment is near -BGM / (1 + BGM) with
                   the BGM of the cloth that lies at chest level (it is cut wider below the underarm)

Prints tables. With --record, adds the results and the machine to bench/history/<row>.json.
Exit code 1 when a case did not settle.
"""
import argparse
import concurrent.futures
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
STAGES = ("body", "pattern", "garment", "dress", "settle", "maps", "placement", "report")

# Two adults and the two study children: stature, chest, waist, hip in metres.
BODIES = {
    "woman": dict(sex=0, age=30, height=1.68, chest=0.88, waist=0.72, hip=0.97),
    "man": dict(sex=1, age=30, height=1.80, chest=1.00, waist=0.86, hip=1.02),
    "slim child": dict(sex=0.4, age=10, height=1.40, chest=0.63, waist=0.55, hip=0.68),
    "heavy child": dict(sex=0.4, age=10, height=1.40, chest=0.75, waist=0.72, hip=0.80),
}
CHEST_FITS = (-0.05, 0.05, 0.15, 0.30, 0.45)


def matrix_scenario(body, chest, edge_length):
    """The whole shirt scales with the chest fit, as in the paper."""
    return f"""[body]
sex = {float(body['sex'])}
age = {body['age']}
height = {body['height']}
measurements = {{ chest = {body['chest']}, waist = {body['waist']}, hip = {body['hip']} }}
[garment]
fit = {{ chest = {chest}, hip = {chest}, sleeve = {chest}, wrist = {chest} }}
[simulation]
edge_length = {edge_length}
"""


def run(binary, scenario, folder, pictures):
    """Runs one case; returns (exit code, summary or None, last line of its messages)."""
    command = [binary, "run", str(scenario), "-o", str(folder), "--quiet"]
    if not pictures:
        command.append("--no-pictures")
    done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    summary_file = folder / "summary.json"
    summary = json.loads(summary_file.read_text()) if summary_file.exists() else None
    message = (done.stderr.strip().splitlines() or [""])[0]
    return done.returncode, summary, message


def machine():
    model = "unknown processor"
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return {"processor": model, "cores": os.cpu_count(), "system": platform.system(),
            "load": round(os.getloadavg()[0], 2)}


def reference_shirt(options, out):
    best = None
    for number in range(options.runs):
        code, summary, message = run(options.binary, ROOT / "examples/reference-shirt.toml",
                                     out / f"reference-{number}", "DISPLAY" in os.environ)
        if summary is None:
            sys.exit(f"reference-shirt: exit code {code}: {message}")
        if best is None or summary["seconds"]["total"] < best["seconds"]["total"]:
            best = summary
    print(f"reference-shirt: {'settled' if best['settled'] else 'NOT SETTLED'}, "
          f"residual {best['residual']:.1e}, {best['vertices']} vertices, "
          f"peak memory {best['peak_memory_mb']:.0f} MB")
    print("  ".join(f"{stage} {best['seconds'].get(stage, 0):.2f}" for stage in STAGES)
          + f"  total {best['seconds']['total']:.2f} s")
    keys = ("settled", "residual", "intersections", "vertices", "seconds", "peak_memory_mb",
            "settle")
    return best["settled"], {key: best[key] for key in keys}


def matrix_case(options, out, name, chest):
    folder = out / f"{name.replace(' ', '-')}-{chest:+.2f}"
    scenario = folder.with_name(folder.name + ".toml")
    scenario.write_text(matrix_scenario(BODIES[name], chest, options.edge_length))
    start = time.monotonic()
    code, summary, message = run(options.binary, scenario, folder, options.pictures)
    row = {"body": name, "chest_fit": chest, "exit_code": code,
           "wall_seconds": round(time.monotonic() - start, 1), "settled": False}
    if summary is None:
        return row | {"error": message}
    row |= {key: summary[key] for key in ("settled", "residual", "intersections", "vertices",
                                          "stop_reason", "peak_memory_mb")}
    row["seconds"] = {key: round(value, 2) for key, value in summary["seconds"].items()}
    cut = summary["fit"].get("chest_cut", {})
    row["hoop_strain"] = cut.get("hoop_strain")
    # Where the armholes reach below chest level the cut does not go all round: nothing to compare.
    if cut.get("flat") and cut["draped"] > 0.98 * summary["body"]["measured"]["chest"]:
        row["bgm_at_chest_level"] = cut["flat"] / summary["body"]["measured"]["chest"] - 1
    row["distance_median_mm"] = summary["maps"].get("distance_mm", {}).get("median")
    return row


def matrix(options, out):
    cases = [(name, chest) for name in BODIES for chest in CHEST_FITS
             if not options.bodies or name in options.bodies.split(",")]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda case: matrix_case(options, out, *case), cases))
    print(f"{'body':12} {'chest':>6} {'settled':>8} {'residual':>9} {'body':>5} {'self':>5} "
          f"{'dress s':>8} {'settle s':>8} {'hoop':>8} {'tight':>8} {'gap mm':>7}")
    for row in rows:
        if "error" in row:
            print(f"{row['body']:12} {row['chest_fit']:+6.2f} {'error':>8} {row['error']}")
            continue
        hoop, gap = row["hoop_strain"], row["distance_median_mm"]
        bgm = row.get("bgm_at_chest_level", 0)
        tight = -bgm / (1 + bgm)
        print(f"{row['body']:12} {row['chest_fit']:+6.2f} {str(row['settled']):>8} "
              f"{row['residual']:9.1e} {row['intersections']['body']:5d} "
              f"{row['intersections']['self']:5d} {row['seconds'].get('dress', 0):8.1f} "
              f"{row['seconds'].get('settle', 0):8.1f} "
              f"{'' if hoop is None else format(hoop, '+.4f'):>8} "
              f"{format(tight, '+.4f') if tight > 0 else '':>8} "
              f"{'' if gap is None else format(gap, '.1f'):>7}")
    settled = sum(row["settled"] for row in rows)
    print(f"{settled} of {len(rows)} settled")
    return settled == len(rows), rows


def record(row, note, result):
    path = ROOT / "bench" / "history" / f"{row}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    history = json.loads(path.read_text()) if path.exists() else []
    commit = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True).stdout.strip()
    history.append({"date": datetime.date.today().isoformat(), "commit": commit, "note": note,
                    "machine": machine(), "result": result})
    path.write_text(json.dumps(history, indent=1) + "\n")
    print(f"recorded in {path.relative_to(ROOT)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", default=str(ROOT / "build/bin/loosefit"))
    parser.add_argument("--rows", default="reference-shirt,matrix")
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="cases of the matrix at the same time")
    parser.add_argument("--edge-length", type=float, default=0.010, help="of the matrix [m]")
    parser.add_argument("--bodies", help="only these of the matrix: " + ", ".join(BODIES))
    parser.add_argument("--pictures", action="store_true", help="draw the matrix too")
    parser.add_argument("--out", help="keep the outputs in this folder")
    parser.add_argument("--record", metavar="NOTE", help="add to bench/history")
    options = parser.parse_args()
    rows = {"reference-shirt": reference_shirt, "matrix": matrix}
    wanted = options.rows.split(",")
    if unknown := [name for name in wanted if name not in rows]:
        parser.error(f"unknown row {unknown[0]}; known: {', '.join(rows)}")
    good = True
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(options.out or scratch)
        out.mkdir(parents=True, exist_ok=True)
        for name in wanted:
            settled, result = rows[name](options, out)
            good = good and settled
            if options.record is not None:
                record(name, options.record, result)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
