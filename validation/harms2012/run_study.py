#!/usr/bin/env python3
"""The study of Harms, Amft and Tröster (2012), section 3, again.

One long-sleeve shirt of size 142 with boards on its back, on two children of 1.40 m, in two fabrics:
put on twelve times, worn in, calibrated upright, then bent forward. Drapes that are already in the
output folder with the same scenario are not made again. Writes results.json beside this file, the
pictures in docs/images and the tables of docs/validation/harms2012.md; needs python3-numpy and
python3-matplotlib.

    python3 validation/harms2012/run_study.py                 # everything
    python3 validation/harms2012/run_study.py --only slim     # cases whose name begins so
    python3 validation/harms2012/run_study.py --quick         # coarse, few donnings, to try the scripts
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import threading

import numpy

from back_panel import BackPanel
from cases import (ADDRESSES, ALL, BENDS, BOARDS, FOLDS, HERE, JUDGED, MAIN, REFERENCE, REPOSITORY, SHAKES,
                   UPRIGHT, moved_place, quick, scenario_text)
from drape_file import DrapeFile
from inclination import FOOTPRINT, bodies, of_donning
from tables import day_of

sys.path.insert(0, str(REPOSITORY / "bench"))
from records import json_lines  # noqa: E402

BACK = ["scapula_L", "scapula_R", "upper_back", "mid_back", "lower_back", "hips"]
STEP = 0.005  # along the lines of the picture [m]
says = threading.Lock()


def run(command):
    """Runs loosefit; 1 (not settled) is a result, more is an error."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode > 1:
        raise SystemExit(f"error: {' '.join(map(str, command))}\n{done.stderr.strip()}")


def drape(binary, folder, name, scenarios):
    """One case, unless it is there with one of these scenarios: the first of them whose first drape
    settles, else the last; returns its folder."""
    target, file = folder / name, folder / f"{name}.toml"
    done = (target / "summary.json").exists() and file.exists() and file.read_text() in scenarios
    for scenario in scenarios[scenarios.index(file.read_text()) if done else 0:]:
        if not done:
            file.write_text(scenario)
            run([binary, "run", str(file), "-o", str(target), "-q", "--no-pictures"])
        done, summary = False, summary_of(target)
        if summary["settled"] and summary["worn"]:
            break
        with says:
            print(f"{name}: not settled: {summary['stop_reason']}", file=sys.stderr, flush=True)
    with says:
        print(f"{name}: {summary['seconds']['total']:.0f} s", file=sys.stderr, flush=True)
    return target


def summary_of(target):
    return json.loads((target / "summary.json").read_text())


def draw(binary, target):
    """Its pictures, unless they are newer than its drapes; apart, since drapes take much longer."""
    picture = target / "maps" / "angular-deviation-back.png"
    if not picture.exists() or picture.stat().st_mtime < (target / "drape.vtp").stat().st_mtime:
        run([binary, "render", str(target), "-q"])


def places_of(targets):
    """Where the boards are sewn on the one shirt: means of the places of the landmarks on both
    children, left and right alike, the spine in the middle, rounded to 1 mm."""
    found = [summary_of(t)["sites"] for t in targets]
    mean = lambda name, key: numpy.mean([sites[name][key] for sites in found])
    width = numpy.mean([abs(mean(f"scapula_{s}", "u_m")) for s in "LR"])
    height = numpy.mean([mean(f"scapula_{s}", "v_m") for s in "LR"])
    places = {}
    for name in BOARDS:
        if name.startswith("scapula"):
            u, v = numpy.copysign(width, mean(name, "u_m")), height
        else:
            u, v = 0.0, mean(name, "v_m")
        places[name] = [round(float(u), 3), round(float(v), 3)]
    return places


def lines_of(places):
    """The lines of the picture: across the back at the shoulder blades, and down the spine [m]."""
    level = places["scapula_L"][1]
    across = [(u, level) for u in numpy.arange(-0.14, 0.1401, STEP)]
    return {"across": across, "spine": [(0.0, v) for v in numpy.arange(-0.06, -0.3901, -STEP)]}


def of_state(state):
    """What is kept of one upright drape."""
    settled = state.get("counts", state["settled"])  # a state may be left out for other reasons
    kept = {"settled": settled, "stop_reason": state["stop_reason"]}
    if settled and state.get("wrinkles"):
        kept["wrinkles"] = {region: {key: round(value, 4)
                                     for key, value in state["wrinkles"][region].items()}
                            for region in BACK}
    return kept


def shake_of(target):
    """How much the start was shaken until the first drape settled [m rms]."""
    found = re.search(r"^start_perturbation = (.*)$", target.with_suffix(".toml").read_text(), re.M)
    return float(found.group(1)) if found else 0.0


def bends_of(states, donning, asked):
    """Bends of a donning whose drapes count, and the others with the reason."""
    of = {s["posture"]: s for s in states if s["donning"] == donning}
    good = [posture for posture in asked if of.get(posture, {}).get("counts")]
    return good, {posture: of[posture]["stop_reason"] if posture in of else "not tried"
                  for posture in asked if posture not in good}


def of_site(found, row, postures):
    """What is kept of one board: by bend, and over those that are judged, which come first."""
    site = {key: {str(BENDS[posture]): round(float(x), 2) for posture, x in zip(postures, found[key][row])}
            for key in ("error", "normal", "coe", "skin")}
    judged = {key: found[key][row][:len(JUDGED)] for key in ("error", "normal", "coe")}
    site.update({f"{key}_rms": round(float(numpy.sqrt((values ** 2).mean())), 3)
                 for key, values in judged.items()})
    site["largest"] = round(float(abs(judged["error"]).max()), 3)
    site.update({key: round(float(found[key][row]), 3) for key in ("upright", "deviation")})
    return site


def figures(target, spec, places):
    """What is kept of one case: every donning, also those that are left out."""
    summary = summary_of(target)
    states = summary.get("states", [])
    kept = {"case": spec, "vertices": summary["vertices"], "fit": summary["fit"]["measured"],
            "mass_kg": summary["garment"]["mass_kg"], "start_perturbation": shake_of(target), "seconds": round(summary["seconds"]["total"]),
            "version": summary["versions"]["loosefit"], "build": summary["versions"].get("build"),
            "date": day_of(target / "summary.json")}
    upright = [summary] + [s for s in states if s["posture"] in (UPRIGHT, "reference")]
    kept["drapes"] = [of_state(state) for state in upright]
    for how, one in zip(summary.get("donnings", []), kept["drapes"]):
        one["how"] = {key: how[key] for key in ("shift_m", "twist_deg", "friction")}
    if not spec["postures"]:
        return kept
    panel, wearer = BackPanel(DrapeFile(target / "drape.vtp")), bodies(target)
    points = [moved_place(name, places[name], spec.get("move_mm", (0, 0))) for name in BOARDS]
    weights = [panel.disc_weights(points, FOOTPRINT)]
    lines = lines_of(places) if "move_mm" not in spec and spec["boards"] else {}
    weights += [panel.disc_weights(line, FOOTPRINT) for line in lines.values()]
    profiles = {name: [] for name in lines}
    for k, one in enumerate(kept["drapes"]):
        asked = [posture for posture in spec["postures"] if posture in BENDS]
        good, bad = bends_of(states, k + 1, asked)
        one["left_out"] = bad if one["settled"] else {UPRIGHT: one["stop_reason"]}
        if not one["settled"] or any(posture in bad for posture in JUDGED):
            continue
        found = of_donning(target, k + 1, good, numpy.concatenate(weights), panel, wearer)
        one["sites"] = {name: of_site(found, row, good) for row, name in enumerate(BOARDS)}
        first = len(BOARDS)
        for name, line in lines.items():
            rows = slice(first, first + len(line))
            profiles[name].append([numpy.sqrt((found["error"][rows, :len(JUDGED)] ** 2).mean(axis=1)),
                                   found["deviation"][rows]])
            first += len(line)
    for name, samples in profiles.items():
        if samples:
            kept.setdefault("profiles", {})[name] = profile(lines[name], numpy.array(samples))
    return kept


def profile(line, samples):
    """Mean and sample deviation over the donnings along a line, None outside the panel."""
    spread = samples.std(axis=0, ddof=1) if len(samples) > 1 else 0 * samples[0]
    rounded = lambda values: [None if numpy.isnan(x) else round(float(x), 2) for x in values]
    return {"at_mm": [[round(1000 * float(x)) for x in point] for point in line],
            **{key: {"mean": rounded(samples.mean(axis=0)[k]), "deviation": rounded(spread[k])}
               for k, key in enumerate(("error_rms", "angular_deviation"))}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("-o", "--output", type=pathlib.Path,
                        help="default out/harms2012, with --quick out/harms2012-quick")
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time (default 1); donnings of "
                        "one case share all cores anyway")
    parser.add_argument("--only", default="", help="cases whose name begins so; the others keep "
                        "their stored results")
    parser.add_argument("--quick", action="store_true", help="coarse meshes and few donnings; results, "
                        "pictures and page go to the output folder and are of no other use")
    parser.add_argument("--no-page", action="store_true", help="only results.json")
    arguments = parser.parse_args()
    out = arguments.output or pathlib.Path("out/harms2012-quick" if arguments.quick else "out/harms2012")
    out.mkdir(parents=True, exist_ok=True)
    specs = quick(ALL) if arguments.quick else ALL
    stored = (out if arguments.quick else HERE) / "results.json"
    results = json.loads(stored.read_text()) if stored.exists() and arguments.only else {}
    wanted = [name for name in specs if name.startswith(arguments.only) and name not in ADDRESSES]
    if not wanted:
        raise SystemExit(f"error: --only: found \"{arguments.only}\", expected the beginning of one "
                         f"of {', '.join(ALL)}")
    places = places_of([drape(arguments.binary, out, name, [scenario_text(specs[name])])
                        for name in ADDRESSES])

    def scenarios(name):
        own = places if specs[name]["postures"] and name not in FOLDS else None
        return [scenario_text(specs[name], own, shake) for shake in SHAKES]

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = {name: pool.submit(drape, arguments.binary, out, name, scenarios(name))
                for name in wanted}
        for name, done in work.items():
            if done.exception():
                pool.shutdown(cancel_futures=True)
            results[name] = figures(done.result(), specs[name], places)
            counted = sum("sites" in d or d["settled"] and "left_out" not in d
                          for d in results[name]["drapes"])
            print(f"{name}: {counted} of {specs[name]['donnings']} donnings count", file=sys.stderr,
                  flush=True)
    # At the end: half a study is none, and drapes are kept in the output folder anyway.
    ordered = {key: results[key] for key in ALL if key in results}
    half = stored.with_suffix(".half")
    half.write_text(json_lines({"places": places, **ordered}) + "\n")
    half.replace(stored)
    if arguments.no_page:
        return
    drape(arguments.binary, out, "reference", [REFERENCE.read_text()])
    for name in [*(m for m in MAIN if m in specs), "reference", *FOLDS]:
        draw(arguments.binary, out / name)
    into = ["--into", str(out)] if arguments.quick else []
    for script in (["pictures.py", str(out)], ["tables.py"]):
        subprocess.run([sys.executable, str(HERE / script[0]), *script[1:], *into], check=True)


if __name__ == "__main__":
    main()
