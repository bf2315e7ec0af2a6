#!/usr/bin/env python3
"""Whether drapes that were put on in two ways agree in region means, within the spread of donnings.

usage: wear_in.py [--binary FILE] [--edge-mm 14] [--donnings 6] [--out DIR] [--json FILE]

The reference shirt on the woman of the suite, with the movements of [donning] and without. Ways: put on
with the arms at 40 degrees (a-pose) and at 55; the arms raised last instead of first, or once where there
are no movements; the start shifted by up to 20 mm to each side and nothing else drawn. Of the first two
each donning is held against the same donning of the usual way, which draws the same. Spread: sample
standard deviation over donnings of the usual way, the first included. Prints, for each map, over all
regions and over the shoulder blades alone, the root mean square of the difference of two ways, of the
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
GROUPS = {"all": None, "scapulae": ("scapula_L", "scapula_R")}  # regions; None: each that there is


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
            for r in entry["maps"].get(m, {}).get("regions", {})}


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


def donnings_of(summary):
    """Means of each donning that counts, by its number."""
    return {1: means(summary),
            **{e["donning"]: means(e) for e in summary["states"] if e["counts"]}}


def differences(one, other):
    """{(map, region): root mean square over the donnings that both ways have}"""
    common = [n for n in one if n in other]
    keys = set.intersection(*(set(way[n]) for way in (one, other) for n in common))
    return {key: rms([one[n][key] - other[n][key] for n in common]) for key in keys}


def study(options, folder, label, movements, raised):
    wide = "{ arm_abduction_deg = 55, elbow_extension = 0, relaxed_arms = 0 }"
    base = run(options, folder, f"{label}-a-pose", movements, '"a-pose"',
               f"repeats = {options.donnings}")
    donnings = donnings_of(base)
    spread = spread_of(list(donnings.values()))
    few = f"repeats = {min(options.donnings, 4)}"
    wider = donnings_of(run(options, folder, f"{label}-wide", movements, wide, few))
    last = donnings_of(run(options, folder, f"{label}-raised", raised, '"a-pose"', few))
    shifted = run(options, folder, f"{label}-shifted", movements, '"a-pose"',
                  f"repeats = {options.donnings}\nshift = 0.02\ntwist_deg = 0\n"
                  "friction_spread = 0\nmovement_spread = 0")
    starts = spread_of(list(donnings_of(shifted).values()))
    # Two draws of one spread differ by sqrt(2) of it.
    ways = {"a-pose or 55 degrees": differences(donnings, wider),
            "arms raised last": differences(donnings, last),
            "start shifted by 20 mm": {k: math.sqrt(2) * v for k, v in starts.items()}}
    table = []
    for way, difference in ways.items():
        for m in MAPS:
            for group, regions in GROUPS.items():
                keys = [k for k in spread if k[0] == m and k in difference
                        and (regions is None or k[1] in regions)]
                apart, spreads = rms([difference[k] for k in keys]), rms([spread[k] for k in keys])
                table.append({"movements": label, "ways": way, "map": m, "of": group,
                              "regions": len(keys), "difference": apart, "spread": spreads,
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
        found = {"none": study(options, folder, "none", "[]", '["arm-raise"]'),
                 "usual": study(options, folder, "usual", '["arm-raise", "breath", "hem-pull", "fidget"]',
                                '["breath", "hem-pull", "fidget", "arm-raise"]')}
    print(f"{'movements':10} {'ways':22} {'map':22} {'of':9} {'difference':>10} {'spread':>8} {'ratio':>6}")
    for part in found.values():
        for row in part["table"]:
            print(f"{row['movements']:10} {row['ways']:22} {row['map']:22} {row['of']:9} "
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
