#!/usr/bin/env python3
"""How far measures of scans are off those of the people they are made from.

usage: twin_measures.py WHO:POSE [WHO:POSE ...] [--noise METRES] [--draws N] [--binary FILE] [--out DIR]

WHO is a person of people.py, POSE one of twins.py. Prints, for each scan, how far the model and the skin are off and the girths, lengths
and levels that are more than 5 mm off, and over all scans their root mean square, how many are more than 10.5 mm off (tapes are read to a
millimetre), and means of measures beyond 2.5 mm. Needs numpy (python3-numpy).
"""
import argparse
import collections
import json
import pathlib
import statistics
import subprocess

import twins

LEFT_OUT = ("mass", "volume", "shoulder_slope")


def errors(scan, out, binary):
    """{measure: millimetres off}, and what the program says of the fit; None where it refuses the scan."""
    folder = out / (scan.stem + "_body")
    subprocess.run(["rm", "-rf", str(folder)], check=True)
    run = subprocess.run([binary, "body", "--file", str(scan), "-o", str(folder)], capture_output=True, text=True)
    if run.returncode:
        return None, run.stderr.strip().splitlines()[-1]
    known = json.loads(scan.with_suffix(".json").read_text())["measured"]
    found = json.loads((folder / "body.json").read_text())["measured"]
    said = [line for line in run.stderr.splitlines() if "lies on the scan" in line]
    return {k: 1e3 * (found[k] - known[k]) for k in known if k in found and k not in LEFT_OUT}, said[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scans", nargs="+")
    parser.add_argument("--noise", type=float, default=twins.NOISE)
    parser.add_argument("--draws", type=int, default=1)
    parser.add_argument("--binary", default=str(twins.ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--out", default="out/twins", type=pathlib.Path)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    by_measure = collections.defaultdict(list)
    for spec in options.scans:
        who, pose = spec.split(":")
        for draw in range(1, options.draws + 1):
            name = f"{who}-{pose}-{draw}"
            twins.TWINS[name] = (who, pose)
            off, said = errors(twins.make(name, options.out, options.binary, options.noise, draw), options.out, options.binary)
            if off is None:
                print(f"{name}: refused: {said}")
                continue
            for key, value in off.items():
                by_measure[key].append(value)
            worst = sorted(off.items(), key=lambda t: -abs(t[1]))
            print(f"{name}: " + ", ".join(f"{k} {v:+.0f}" for k, v in worst if abs(v) > 5) + f" ({said.strip()})", flush=True)
    every = [abs(v) for values in by_measure.values() for v in values]
    if every:
        print(f"rms {statistics.fmean(v * v for v in every) ** 0.5:.1f} mm; {sum(v > 10.5 for v in every)} of {len(every)} are more than "
              f"10.5 mm off")
        print("mean: " + ", ".join(f"{k} {statistics.fmean(v):+.1f}" for k, v in by_measure.items() if abs(statistics.fmean(v)) > 2.5))


if __name__ == "__main__":
    main()
