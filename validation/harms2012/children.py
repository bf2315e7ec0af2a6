#!/usr/bin/env python3
"""The study's measure on the 21 drawn children of examples/study-harms2012.toml.

Runs that study with all files of each case (finished cases are not run again), takes the sagittal
inclination error of the five places from the drapes as run_study.py does, and writes children.json
beside this file and the table "children" of docs/validation/harms2012.md. The sensors are sewn at one
place of the shirt for all, the mean of where the landmarks of the children lie in it. Needs
python3-numpy; 22 MB of disk a case.

    python3 validation/harms2012/children.py -o out/harms2012-children
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

import numpy

from back_panel import BackPanel
from cases import BENDS, HERE, JUDGED, REPOSITORY
from drape_file import DrapeFile
from inclination import FOOTPRINT, bodies, of_donning
from run_study import bends_of, of_site
from statements import OF_PLACES
from statistics_of import CALIBRATED, SURE, order_of, over_donnings, ranking, share, verdict
from tables import NAMES, PAGE, span, table

sys.path.insert(0, str(REPOSITORY / "bench"))
from records import json_lines  # noqa: E402

STUDY = REPOSITORY / "examples" / "study-harms2012.toml"
LEFT, RIGHT = "scapula left", "scapula right"  # sites of the study file
PLACES = [LEFT, RIGHT, "upper back", "mid back", "lower back"]
DONNINGS = (1, 2)
BEGIN, END = "<!-- children: begin -->", "<!-- children: end -->"


def finished(folder):
    """(number, case record, folder of its run) of the cases that have scores, in their order, and how
    many there are in all."""
    plan = json.loads((folder / "plan.json").read_text())
    found = []
    for case in plan["cases"]:
        place = folder / "cases" / case["address"][:2] / case["address"]
        result = place / "result.json"
        if not result.exists():
            raise SystemExit(f"error: {folder}: case {case['number']} is still open")
        record = json.loads(result.read_text())["result"]
        if record["status"] != "done":
            continue
        if not (place / "output" / "summary.json").exists():
            raise SystemExit(f"error: {place}: found no output, expected that of a case that ran with "
                             "--keep-output: choose a new folder")
        found.append((case["number"], record, place / "output"))
    return found, len(plan["cases"])


def shirt_places(summaries):
    """Where the sensors are sewn (u, v) [m]: means over the children, left and right alike."""
    mean = lambda name, key: statistics.fmean(s["sites"][name][key] for s in summaries if name in s["sites"])
    width = statistics.fmean(abs(mean(name, "u_m")) for name in (LEFT, RIGHT))
    height = statistics.fmean(mean(name, "v_m") for name in (LEFT, RIGHT))
    places = {LEFT: (width, height), RIGHT: (-width, height)}
    if mean(LEFT, "u_m") < 0:
        places = {LEFT: (-width, height), RIGHT: (width, height)}
    for name in PLACES[2:]:
        places[name] = (0.0, mean(name, "v_m"))
    return {name: [round(x, 3) for x in place] for name, place in places.items()}


def child(number, record, folder, places):
    """What is kept of one child: the sites of every donning whose bends all count."""
    summary = json.loads((folder / "summary.json").read_text())
    kept = {"number": number, "body_m": {key: round(record["body_m"][key], 3)
                                         for key in ("height", "chest", "waist", "hip")},
            "donnings": []}
    panel, wearer = BackPanel(DrapeFile(folder / "drape.vtp")), bodies(folder)
    weights = panel.disc_weights([places[name] for name in PLACES], FOOTPRINT)
    for donning in DONNINGS:
        good, bad = bends_of(summary.get("states", []), donning, [p for p in BENDS if p in JUDGED])
        if bad:
            continue
        found = of_donning(folder, donning, good, weights, panel, wearer)
        kept["donnings"].append({name: of_site(found, row, good) for row, name in enumerate(PLACES)})
    return kept


def by_site(children, value=CALIBRATED):
    """site, named as in cases.py -> one figure per child: the mean of its donnings, and of both blades."""
    names = {"scapula": (LEFT, RIGHT), **{name.replace(" ", "_"): (name,) for name in PLACES[2:]}}
    return {site: [statistics.fmean(d[name][value] for d in c["donnings"] for name in own) for c in children]
            for site, own in names.items()}


def quantile(values, part):
    return float(numpy.quantile(values, part))


def block(kept):
    """Lines of the page."""
    children = [c for c in kept["children"] if c["donnings"]]
    errors = by_site(children)
    draws = list(over_donnings(errors))
    found = ranking(draws)
    rows = [[str(k + 1), NAMES[site], f"{statistics.median(errors[site]):.1f}",
             span((quantile(errors[site], 0.05), quantile(errors[site], 0.95))),
             f"{statistics.fmean(errors[site]):.1f}", span(found[site]["mean_interval"]),
             span(found[site]["rank_interval"], 0), f"{100 * found[site]['first']:.0f} %"]
            for k, site in enumerate(order_of(errors))]
    donnings = sum(len(c["donnings"]) for c in children)
    lines = [f"{len(children)} of {kept['asked']} children and {donnings} of {len(DONNINGS) * kept['asked']} "
             f"donnings count; {kept['minutes']:.0f} core minutes, version {kept['version']}.", ""]
    lines += table(["rank", "place", "median [°]", "5 to 95 % of children", "mean", "90 % of the mean",
                    "90 % of the rank", "first"], rows)
    lines += table(["the study's statement", f"holds in (agrees from {100 * SURE:.0f} % of the draws on)"],
                   [[words, f"{verdict(share(draws, holds))}, {100 * share(draws, holds):.0f} %"]
                    for source, words, _, holds in OF_PLACES if source == "study"])
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("out/harms2012-children"))
    parser.add_argument("--jobs", type=int, default=0, help="cases at a time (default: one per core)")
    arguments = parser.parse_args()
    run = subprocess.run([arguments.binary, "study", "run", str(STUDY), "-o", str(arguments.output),
                          "--keep-output", "--jobs", str(arguments.jobs)], stdout=subprocess.DEVNULL)
    if run.returncode not in (0, 1):
        raise SystemExit("error: the study did not run to its end")
    cases, asked = finished(arguments.output)
    if not cases:
        raise SystemExit(f"error: {arguments.output}: no case has scores")
    places = shirt_places([json.loads((folder / "summary.json").read_text()) for _, _, folder in cases])
    kept = {"asked": asked, "places": places, "version": cases[0][1]["versions"]["loosefit"],
            "minutes": round(sum(r["execution"]["seconds"] for _, r, _ in cases) / 60, 1),
            "children": [child(*case, places) for case in cases]}
    (HERE / "children.json").write_text(json_lines(kept) + "\n")
    page = PAGE.read_text()
    head, rest = page.split(BEGIN, 1)
    PAGE.write_text(head + BEGIN + "\n" + "\n".join(block(kept)).rstrip() + "\n" + END + rest.split(END, 1)[1])


if __name__ == "__main__":
    main()
