#!/usr/bin/env python3
"""Mesh convergence and repeatability of the performance maps.

Drapes the reference shirt at several edge lengths, several times each from perturbed starts (folds
are not unique, one drape is one sample), and keeps the statistics per region in results.json beside
this file. Drapes that are already in the output folder are not run again.

    python3 validation/convergence/run.py --binary build/bin/loosefit -o out/convergence
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
MAPS = ["strain_warp", "strain_weft", "shear_angle_deg", "strain_max", "distance_mm", "angular_deviation_deg",
        "angular_deviation_total_deg"]
STATISTICS = ["area_mean", "median", "p95"]


def scenario_text(edge_mm, seed):
    """The reference scenario with this edge length, seed and a perturbed start."""
    text = (REPOSITORY / "examples" / "reference-shirt.toml").read_text()
    text, changed = re.subn(r"edge_length = \S+", f"edge_length = {edge_mm / 1000}", text)
    text, seeded = re.subn(r"seed = \d+", f"seed = {seed}\nstart_perturbation = 0.001\nthreads = 1",
                           text)
    text, mapped = re.subn(r"maps = \[", 'maps = ["crimp", ', text)
    if changed != 1 or seeded != 1 or mapped != 1:
        raise SystemExit("error: examples/reference-shirt.toml: found no edge_length, no seed or no maps")
    return text


def drape(binary, folder, edge_mm, seed):
    """Runs one drape unless it is there; returns its folder."""
    target = folder / f"{edge_mm}mm-{seed}"
    if not (target / "summary.json").exists():
        scenario = folder / f"{edge_mm}mm-{seed}.toml"
        scenario.write_text(scenario_text(edge_mm, seed))
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
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    cases = [(edge, seed) for edge, count in PLAN.items() for seed in range(1, count + 1)]
    results = {}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = {case: pool.submit(drape, arguments.binary, arguments.output, *case)
                for case in cases}
        for (edge, seed), done in work.items():
            results.setdefault(str(edge), {})[str(seed)] = figures(done.result())
            print(f"{edge} mm, start {seed}: settled {results[str(edge)][str(seed)]['settled']}",
                  file=sys.stderr, flush=True)
    (HERE / "results.json").write_text(json_lines(results) + "\n")


if __name__ == "__main__":
    main()
