#!/usr/bin/env python3
"""Mesh convergence and repeatability of the performance maps.

Drapes the reference shirt at several edge lengths, several times each from perturbed starts (folds
are not unique, one drape is one sample), and keeps the statistics per region in results.json beside
this file. Drapes that are already in the output folder are not run again.

    python3 validation/convergence/run.py --binary build/bin/loosefit -o out/convergence
    python3 validation/convergence/run.py --garments  # others at two edge lengths: garments.json
    python3 validation/convergence/tables.py          # table and plot of docs/accuracy.md
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parent.parent
sys.path.insert(0, str(REPOSITORY / "bench"))
from records import json_lines  # noqa: E402

# Edge length [mm] -> number of drapes.
PLAN = {20: 8, 14: 8, 10: 8, 7: 4, 5: 3}
GARMENTS_PLAN = {14: 4, 5: 3}
# Name in the tables -> example it starts from and what is replaced in it.
GARMENTS = {
    "shirt, cotton-shirting": ("reference-shirt", {"name": "cotton-shirting"}),
    "shirt, cotton-jersey": ("reference-shirt", {"name": "cotton-jersey"}),
    "shirt, denim": ("reference-shirt", {"name": "denim"}),
    "trousers, denim": ("trousers", {"name": "denim"}),
    "T-shirt, compression-knit": ("reference-shirt", {
        "name": "compression-knit", "pattern": "t-shirt",
        "fit": "{ chest = -0.12, waist = -0.10, hip = -0.12, sleeve = -0.10 }"}),
}
MAPS = ["strain_warp", "strain_weft", "shear_angle_deg", "strain_max", "distance_mm", "angular_deviation_deg",
        "angular_deviation_total_deg"]
STATISTICS = ["area_mean", "median", "p95"]


def scenario_text(edge_mm, seed, garment=None):
    """The reference scenario, or that of a garment, with this edge length, seed and a perturbed start."""
    example, replaced = GARMENTS[garment] if garment else ("reference-shirt", {})
    text = (REPOSITORY / "examples" / f"{example}.toml").read_text()
    text = re.sub(r"(?ms)^\[(simulation|output)\].*?(?=^\[|\Z)", "", text)
    for key, value in replaced.items():
        value = value if value.startswith("{") else f'"{value}"'
        text, changed = re.subn(rf"(?m)^{key} = .*$", f"{key} = {value}", text)
        if changed != 1:
            raise SystemExit(f"error: examples/{example}.toml: found {changed} keys {key}, expected one")
    return text + (f"[simulation]\nedge_length = {edge_mm / 1000}\nseed = {seed}\n"
                   "start_perturbation = 0.001\nthreads = 1\n[output]\n"
                   'maps = ["crimp", "strain", "shear", "distance", "angular-deviation"]\n')


def drape(binary, folder, edge_mm, seed, garment=None):
    """Runs one drape unless it is there; returns its folder."""
    name = (re.sub(r"\W+", "-", garment) + "-" if garment else "") + f"{edge_mm}mm-{seed}"
    target = folder / name
    if not (target / "summary.json").exists():
        scenario = folder / f"{name}.toml"
        scenario.write_text(scenario_text(edge_mm, seed, garment))
        run = subprocess.run(
            [binary, "run", str(scenario), "-o", str(target), "--no-pictures", "-q"],
            capture_output=True, text=True)
        if run.returncode > 1:
            raise SystemExit(run.stderr.strip())
    return target


def load(summary):
    """Normal force over weight, and how much of it is squeezed between arms and trunk."""
    of_all = summary["load"]["force_over_weight"]
    share = summary["load"]["between_arm_and_trunk_N"] / summary["pressure"]["normal_force_N"]
    return {"force_over_weight": of_all, "squeezed": share * of_all}


def figures(target):
    """What is kept of one drape: per map and region the statistics."""
    summary = json.loads((target / "summary.json").read_text())
    kept = {"settled": summary["settled"], "residual": summary["residual"],
            "vertices": summary["vertices"], "load": load(summary), "maps": {}}
    for name in MAPS if summary["settled"] else []:
        whole = summary["maps"][name]
        parts = {"whole": whole, **whole["regions"]}
        kept["maps"][name] = {region: {s: values[s] for s in STATISTICS}
                              for region, values in parts.items()}
    return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("-o", "--output", default="out/convergence", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--garments", action="store_true", help="other garments and fabrics")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    plan = GARMENTS_PLAN if arguments.garments else PLAN
    cases = [(edge, seed, garment) for garment in (GARMENTS if arguments.garments else [None])
             for edge, count in plan.items() for seed in range(1, count + 1)]
    results = {}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = {case: pool.submit(drape, arguments.binary, arguments.output, *case)
                for case in cases}
        for (edge, seed, garment), done in work.items():
            of_garment = results.setdefault(garment, {})
            of_garment.setdefault(str(edge), {})[str(seed)] = kept = figures(done.result())
            print(f"{garment or 'reference shirt'}, {edge} mm, start {seed}: settled {kept['settled']}",
                  file=sys.stderr, flush=True)
    if arguments.garments:
        (HERE / "garments.json").write_text(json_lines(results) + "\n")
    else:
        (HERE / "results.json").write_text(json_lines(results[None]) + "\n")


if __name__ == "__main__":
    main()
