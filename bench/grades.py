#!/usr/bin/env python3
"""How far drapes that end with certificate grade B are from those that go on to grade A.

usage: grades.py [--binary FILE] [--count N] [--json FILE]

Cases: every fabric card, two fits, two edge lengths, standing and bent forward by 30 degrees. Each runs to
grade B and to grade A; both take the same way until the first ends. Prints, for each metric of a site, the
absolute difference over all sites, drapes and cases (median, 95th percentile, largest), and what B
saved. --json keeps the figures, and goes on where an earlier run of the same program was interrupted.
"""
import argparse
import json
import pathlib
import shutil
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FITS = (0.05, 0.25)
EDGES_MM = (14, 20)
BODIES = ({"sex": '"female"', "height": 1.68}, {"sex": '"male"', "height": 1.78})
# Of a site, in its unit; the angle of a tilt or a direction wraps and is left out.
METRICS = ("distance_mm", "gap_mm", "angular_deviation_deg", "rotation_deg", "twist_deg", "coe_rms_deg",
           "strain_warp", "strain_weft", "strain_max", "shear_angle_deg", "pressure_kPa", "slip_mm")


def cases():
    cards = sorted(p.stem for p in (ROOT / "data" / "materials").glob("*.toml"))
    return [(f"{card} fit {fit:g} edge {edge} mm", card, fit, edge, BODIES[(i + j) % 2])
            for edge in EDGES_MM for i, card in enumerate(cards) for j, fit in enumerate(FITS)]


def scenario(card, fit, edge, body, grade):
    return f"""[body]
sex = {body["sex"]}
height = {body["height"]}
[garment]
pattern = "long-sleeve-shirt"
fit = {{ chest = {fit}, hip = {fit}, sleeve = {fit + 0.1:g} }}
[material]
name = "{card}"
[postures]
list = ["standing", "forward-bend-30"]
[donning]
movements = []
[simulation]
edge_length = {edge / 1000:g}
certificate = "{grade}"
[output]
maps = ["strain", "shear", "distance", "angular-deviation", "orientation", "pressure", "gap"]
views = []
"""


def run(binary, text, folder):
    shutil.rmtree(folder / "out", ignore_errors=True)
    case = folder / "case.toml"
    case.write_text(text)
    out = folder / "out"
    subprocess.run([binary, "run", str(case), "-o", str(out), "--no-pictures"],
                   capture_output=True, text=True, check=False)
    path = out / "summary.json"
    if not path.exists():
        raise SystemExit(f"error: {case} wrote no summary")
    summary = json.loads(path.read_text())
    drapes = [summary] + summary.get("states", [])
    if not all(d.get("settled") and d.get("worn") for d in drapes):
        return {"grades": None}
    return {"grades": [d["grade"] for d in drapes],
            "residuals": [d["residual"] for d in drapes],
            "left": [d.get("left_to_go") for d in drapes],
            "seconds": sum(summary["seconds"].get(k, 0) for k in ("dress", "settle", "postures")),
            "sites": [d.get("sites", {}) for d in drapes]}


def differences(b, a):
    found = {}
    for of_b, of_a in zip(b["sites"], a["sites"]):
        for site in of_b.keys() & of_a.keys():
            for metric in METRICS:
                x, y = of_b[site].get(metric), of_a[site].get(metric)
                if isinstance(x, (int, float)) and isinstance(y, (int, float)):
                    found.setdefault(metric, []).append(abs(x - y))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--count", type=int, default=1000, help="only the first so many cases")
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    kept = json.loads(options.json.read_text()) if options.json and options.json.exists() else {}
    with tempfile.TemporaryDirectory() as folder:
        for name, card, fit, edge, body in cases()[:options.count]:
            if name in kept:
                continue
            one = {g: run(options.binary, scenario(card, fit, edge, body, g), pathlib.Path(folder))
                   for g in "BA"}
            if not all(one[g] and one[g]["grades"] for g in "BA"):
                kept[name] = {"failed": True}
            else:
                kept[name] = {"grades": one["B"]["grades"], "residuals": one["B"]["residuals"],
                              "left": one["B"]["left"], "seconds": [one[g]["seconds"] for g in "BA"],
                              "differences": differences(one["B"], one["A"])}
            print(name, kept[name].get("grades", "failed"), flush=True)
            if options.json:
                options.json.write_text(json.dumps(kept, indent=1))
    done = [k for k in kept.values() if "grades" in k]
    drapes = [g for k in done for g in k["grades"]]
    if not done:
        raise SystemExit("error: no case settled in both ways")
    print(f"{len(done)} cases of {len(kept)}, {len(drapes)} drapes, {drapes.count('B')} ended with B; "
          f"seconds B / A: {sum(k['seconds'][0] for k in done) / sum(k['seconds'][1] for k in done):.3f}")
    print(f"{'metric':24}{'values':>8}{'median':>12}{'p95':>12}{'largest':>12}")
    for metric in METRICS:
        values = sorted(v for k in done for v in k["differences"].get(metric, []))
        if not values:
            continue
        print(f"{metric:24}{len(values):8}{statistics.median(values):12.2e}"
              f"{values[int(0.95 * (len(values) - 1))]:12.2e}{values[-1]:12.2e}")


if __name__ == "__main__":
    main()
