#!/usr/bin/env python3
"""Whether drapes that were put on in two ways agree in region means, within the spread of donnings.

usage: wear_in.py [--binary FILE] [--edge-mm 14] [--donnings 6] [--out DIR] [--json FILE]

The reference shirt on the woman of the suite, with the movements of [donning] and without. Ways: put on
with the arms at 40 degrees (a-pose) and at 55, or with the start shifted by up to 20 mm to each side and
nothing else drawn. Spread: sample standard deviation over donnings of the first way, the first
included. Prints, for each map, the root mean square over regions of the difference of two ways, of the
spread, and their ratio (1 where two ways differ as two donnings do: the difference is divided by
sqrt(2) spreads), and what the movements cost.
"""
import argparse
import datetime
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import bench_cases
import records

ROOT = pathlib.Path(__file__).resolve().parents[1]
MAPS = ("distance_mm", "angular_deviation_deg")
REGIONS = ("upper_back", "mid_back", "lower_back", "chest", "abdomen", "hips", "upper_sleeve_L",
           "upper_sleeve_R", "forearm_sleeve_L", "forearm_sleeve_R")


def run(options, folder, name, movements, dress, donning=""):
    text = bench_cases.scenario(
        bench_cases.REFERENCE_FIT, edge_mm=options.edge_mm,
        posture=f'posture = "standing"\ndress_posture = {dress}',
        extra=f"[output]\npreset_sites = false\n[donning]\nmovements = {movements}\n{donning}")
    case = folder / f"{name}.toml"
    case.write_text(text)
    out = folder / name
    found = subprocess.run([options.binary, "run", str(case), "-o", str(out), "--no-pictures"],
                           capture_output=True, text=True)
    if not (out / "summary.json").exists():
        sys.exit(f"error: {name}: {found.stderr.strip()}")
    return json.loads((out / "summary.json").read_text())


def means(entry):
    """{(map, region): mean} of a summary or of one of its states."""
    return {(m, r): entry["maps"][m]["regions"][r]["area_mean"] for m in MAPS
            for r in entry["maps"].get(m, {}).get("regions", {}) if r in REGIONS}


def spread_of(samples):
    keys = set.intersection(*(set(s) for s in samples))
    found = {}
    for key in keys:
        values = [s[key] for s in samples]
        mean = sum(values) / len(values)
        found[key] = math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))
    return found


def rms(values):
    return math.sqrt(sum(v * v for v in values) / max(1, len(values)))


def study(options, folder, label, movements):
    wide = "{ arm_abduction_deg = 55, elbow_extension = 0, relaxed_arms = 0 }"
    base = run(options, folder, f"{label}-a-pose", movements, '"a-pose"',
               f"repeats = {options.donnings}")
    donnings = [means(base)] + [means(s) for s in base["states"] if s["counts"]]
    spread = spread_of(donnings)
    wider = means(run(options, folder, f"{label}-wide", movements, wide))
    shifted = run(options, folder, f"{label}-shifted", movements, '"a-pose"',
                  f"repeats = {options.donnings}\nshift = 0.02\ntwist_deg = 0\n"
                  "friction_spread = 0\nmovement_spread = 0")
    starts = spread_of([means(shifted)] + [means(s) for s in shifted["states"] if s["counts"]])
    # Two draws of one spread differ by sqrt(2) of it.
    differences = {"a-pose or 55 degrees": {k: means(base)[k] - v for k, v in wider.items()},
                   "start shifted by 20 mm": {k: math.sqrt(2) * v for k, v in starts.items()}}
    table = []
    for way, difference in differences.items():
        for m in MAPS:
            keys = [k for k in spread if k[0] == m and k in difference]
            apart, spreads = rms([difference[k] for k in keys]), rms([spread[k] for k in keys])
            table.append({"movements": label, "ways": way, "map": m, "regions": len(keys),
                          "difference": apart, "spread": spreads,
                          "ratio": apart / (math.sqrt(2) * spreads)})
    seconds = base["seconds"]["dress"] + base["seconds"]["settle"]
    return {"table": table, "seconds": seconds, "iterations": base["settle"]["iterations"],
            "donnings": len(donnings)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", default=str(ROOT / "build/bin/loosefit"))
    parser.add_argument("--edge-mm", type=float, default=14)
    parser.add_argument("--donnings", type=int, default=6)
    parser.add_argument("--out", help="keep the outputs in this folder")
    parser.add_argument("--json", metavar="FILE")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.out or scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        found = {"none": study(options, folder, "none", "[]"),
                 "usual": study(options, folder, "usual", '["arm-raise", "breath", "hem-pull", "fidget"]')}
    print(f"{'movements':10} {'ways':22} {'map':22} {'difference':>10} {'spread':>8} {'ratio':>6}")
    for part in found.values():
        for row in part["table"]:
            print(f"{row['movements']:10} {row['ways']:22} {row['map']:22} "
                  f"{row['difference']:10.2f} {row['spread']:8.2f} {row['ratio']:6.2f}")
    print(f"dress and settle: {found['none']['seconds']:.1f} s without, "
          f"{found['usual']['seconds']:.1f} s with movements "
          f"({found['usual']['seconds'] / found['none']['seconds']:.2f}); iterations "
          f"{found['none']['iterations']}, {found['usual']['iterations']}")
    if options.json:
        record = {"date": datetime.date.today().isoformat(), "cases": found}
        pathlib.Path(options.json).write_text(records.json_lines(record, 3) + "\n")


if __name__ == "__main__":
    main()
