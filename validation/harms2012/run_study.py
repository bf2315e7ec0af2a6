#!/usr/bin/env python3
"""The study of Harms, Amft and Tröster (2012), section 3, again.

One long-sleeve shirt of size 142 on two children of 1.40 m, in two fabrics, each put on eight times, and variants of it.
Drapes that are already in the output folder are not made again. Writes results.json beside this
file, then (needs python3-numpy and python3-matplotlib) places.json, the pictures in docs/images and
the tables of docs/validation/harms2012.md.

    python3 validation/harms2012/run_study.py                 # everything
    python3 validation/harms2012/run_study.py --only slim     # cases whose name begins so
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

from cases import HERE, MAIN, REFERENCE, REPOSITORY, SIDE, scenario_text

sys.path.insert(0, str(REPOSITORY / "bench"))
from records import json_lines  # noqa: E402

SITE_NAMES = ["scapula_L", "scapula_R", "upper_back", "mid_back", "lower_back"]
SITE_VALUES = ["angular_deviation_deg", "angular_deviation_deg_worst", "tilt_sagittal_deg",
               "tilt_lateral_deg", "distance_mm"]
BACK = ["scapula_L", "scapula_R", "upper_back", "mid_back", "lower_back", "hips"]
MAPS = ["angular_deviation_deg", "distance_mm"]


def with_display(command):
    """Pictures need a display; a virtual one does."""
    if os.environ.get("DISPLAY"):
        return command
    if not shutil.which("xvfb-run"):
        raise SystemExit("error: no display and no xvfb-run (package xvfb)")
    return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", *command]


def run(command):
    """Runs loosefit; 1 (not settled) is a result, more is an error."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode > 1:
        raise SystemExit(f"error: {' '.join(map(str, command))}\n{done.stderr.strip()}")


def drape(binary, folder, name, scenario):
    """One case, unless it is there; returns its folder."""
    target = folder / name
    if not (target / "summary.json").exists():
        file = folder / f"{name}.toml"
        file.write_text(scenario)
        run([binary, "run", str(file), "-o", str(target), "-q", "--no-pictures"])
    return target


def draw(binary, target):
    """Its pictures, unless they are there; apart from the drape, which takes much longer."""
    if not (target / "maps" / "angular-deviation-back.png").exists():
        run(with_display([binary, "render", str(target), "-q"]))


def of_drape(state):
    """What is kept of one drape."""
    settled = state.get("counts", state["settled"])  # a state may be left out for other reasons
    kept = {"settled": settled, "residual": state["residual"],
            "stop_reason": state["stop_reason"]}
    if settled and state.get("sites"):
        kept["sites"] = {name: {key: round(state["sites"][name][key], 4) for key in SITE_VALUES}
                         for name in SITE_NAMES}
        kept["regions"] = {region: {key: round(state["maps"][key]["regions"][region]["area_mean"], 4)
                                    for key in MAPS}
                           for region in BACK}
    if settled and state.get("wrinkles"):
        kept["wrinkles"] = {region: {key: round(value, 4)
                                     for key, value in state["wrinkles"][region].items()}
                            for region in BACK}
    return kept


def figures(target, spec):
    """What is kept of one case: every donning, also those that did not settle."""
    summary = json.loads((target / "summary.json").read_text())
    if "postures" in spec:  # the last posture is what is looked at
        drapes = [of_drape(s) for s in summary.get("states", [])
                  if s["posture"] == summary["postures"][-1]]
    else:
        drapes = [of_drape(summary)] + [of_drape(s) for s in summary.get("states", [])]
    for how, kept in zip(summary.get("donnings", []), drapes):
        kept["how"] = {key: how[key] for key in ("shift_m", "twist_deg", "friction")}
    wished = spec["donnings"]
    drapes += [{"settled": False, "residual": None,
                "stop_reason": "not tried: the first drape did not settle"}] * (wished - len(drapes))
    kept = {"case": spec, "vertices": summary["vertices"], "fit": summary["fit"]["measured"],
            "material": summary["material"], "drapes": drapes,
            "seconds": round(summary["seconds"]["total"], 1),
            "position_m": {name: summary["sites"][name]["position_m"] for name in SITE_NAMES
                           if name in summary["sites"]},
            "version": summary["versions"]["loosefit"]}
    if "repeats" in spec:
        kept["repeats"] = {name: summary["repeats"][f"sites.{name}.angular_deviation_deg"]
                           for name in SITE_NAMES} if "repeats" in summary else {}
    return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("-o", "--output", default="out/harms2012", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1, help="drapes at a time (default 1)")
    parser.add_argument("--only", default="", help="cases whose name begins so; the others keep "
                        "their stored results")
    parser.add_argument("--no-page", action="store_true", help="only results.json")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    stored = HERE / "results.json"
    results = json.loads(stored.read_text()) if stored.exists() and arguments.only else {}
    wanted = {name: spec for name, spec in {**MAIN, **SIDE}.items()
              if name.startswith(arguments.only)}
    if not wanted:
        raise SystemExit(f"error: --only: found \"{arguments.only}\", expected the beginning of one "
                         f"of {', '.join([*MAIN, *SIDE])}")
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = {name: pool.submit(drape, arguments.binary, arguments.output, name,
                                  scenario_text(spec))
                for name, spec in wanted.items()}
        for name, done in work.items():
            results[name] = figures(done.result(), wanted[name])
            settled = sum(d["settled"] for d in results[name]["drapes"])
            print(f"{name}: {settled} of {len(results[name]['drapes'])} settled", file=sys.stderr,
                  flush=True)
            ordered = {key: results[key] for key in [*MAIN, *SIDE] if key in results}
            stored.write_text(json_lines(ordered) + "\n")
    if arguments.no_page:
        return
    drape(arguments.binary, arguments.output, "reference", REFERENCE.read_text())
    for name in [*MAIN, "reference", "tight-hip-base", "tight-hip-bent"]:
        draw(arguments.binary, arguments.output / name)
    for script in ("places.py", "pictures.py"):
        subprocess.run([sys.executable, str(HERE / script), str(arguments.output)], check=True)
    subprocess.run([sys.executable, str(HERE / "tables.py")], check=True)


if __name__ == "__main__":
    main()
