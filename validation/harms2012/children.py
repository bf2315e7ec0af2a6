#!/usr/bin/env python3
"""The study's measure on the 21 drawn children of examples/study-harms2012.toml.

Runs that study with all files of each case (finished cases are not run again), takes the sagittal
inclination error of the five places from the drapes as run_study.py does, and writes children.json
beside this file and the blocks "children" and "children-short" of docs/validation/harms2012.md. The sensors
are sewn at one place of the shirt for all, the mean of where the landmarks of the children lie in it. Needs
python3-numpy; 22 MB of disk a case.

    python3 validation/harms2012/children.py -o out/harms2012-children
    python3 validation/harms2012/children.py --page-only    # the page again, from children.json
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
from statistics_of import ABSOLUTE, CALIBRATED, SURE, order_of, over_donnings, ranking, share, verdict
from tables import NAMES, PAGE, day_of, made_by, span, table

sys.path.insert(0, str(REPOSITORY / "bench"))
from records import json_lines  # noqa: E402

STUDY = REPOSITORY / "examples" / "study-harms2012.toml"
LEFT, RIGHT = "scapula left", "scapula right"  # sites of the study file
PLACES = [LEFT, RIGHT, "upper back", "mid back", "lower back"]
DONNINGS = (1, 2)


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


def made(cases):
    """What made the cases: version and build of the program, and the day of the last one."""
    told = lambda key: ", ".join(sorted({record["versions"].get(key, "not recorded") for _, record, _ in cases}))
    return {"version": told("loosefit"), "build": told("build"),
            "date": max(day_of(folder.parent / "result.json") for *_, folder in cases)}


def by_site(children, value=CALIBRATED):
    """site, named as in cases.py -> one figure per child: the mean of its donnings, and of both blades."""
    names = {"scapula": (LEFT, RIGHT), **{name.replace(" ", "_"): (name,) for name in PLACES[2:]}}
    return {site: [statistics.fmean(d[name][value] for d in c["donnings"] for name in own) for c in children]
            for site, own in names.items()}


def quantile(values, part):
    return float(numpy.quantile(values, part))


def counting(kept):
    return [c for c in kept["children"] if c["donnings"]]


def percent(part):
    """Of draws, with a decimal beside a bound of the verdicts."""
    near = min(abs(part - bound) for bound in (SURE, 1 - SURE)) < 0.005
    return f"{100 * part:.{1 if near else 0}f} %"


def judged(children):
    """(source, what the paper says, share of the draws of children in which it holds)."""
    draws = {value: list(over_donnings(by_site(children, value))) for value in (CALIBRATED, ABSOLUTE)}
    return [(source, words, share(draws[value], holds)) for source, words, value, holds in OF_PLACES]


def places_table(figures):
    """Rows of the places, the least figure first."""
    found = ranking(over_donnings(figures))
    rows = [[str(k + 1), NAMES[site], f"{statistics.median(figures[site]):.1f}",
             span((quantile(figures[site], 0.05), quantile(figures[site], 0.95))),
             f"{statistics.fmean(figures[site]):.1f}", span(found[site]["mean_interval"]),
             span(found[site]["rank_interval"], 0), f"{100 * found[site]['first']:.0f} %"]
            for k, site in enumerate(order_of(figures))]
    return table(["rank", "place", "median [°]", "5 to 95 % of children", "mean", "90 % of the mean",
                  "90 % of the rank", "first"], rows)


def block(kept):
    """Lines of the page."""
    children = counting(kept)
    donnings = sum(len(c["donnings"]) for c in children)
    lines = [f"{len(children)} of {kept['asked']} children and {donnings} of {len(DONNINGS) * kept['asked']} "
             f"donnings count; {kept['minutes']:.0f} core minutes, {made_by([kept])}.", ""]
    errors, whole = by_site(children, CALIBRATED), by_site(children, "coe_rms")
    less = sorted(mean["mid_back"] - mean["scapula"] for mean in over_donnings(errors))
    lines += ["Calibrated error, what the study measured:", ""] + places_table(errors)
    cut = len(less) // 20
    lines += [f"In it the mid back lies {span((less[cut], less[-cut - 1]))}° above the scapula in 90 % of the draws. "
              "By the error of all axes (`coe_rms_deg`) the means are "
              + ", ".join(f"{NAMES[site]} {statistics.fmean(whole[site]):.1f}°" for site in order_of(whole)) + ".", ""]
    lines += ["Angular deviation upright, what the paper simulated; nothing is calibrated:", ""]
    lines += places_table(by_site(children, ABSOLUTE))
    lines += table(["from", "the paper", f"holds in (agrees from {100 * SURE:.0f} % of the draws on)"],
                   [[source, words, f"{verdict(part)}, {percent(part)}"] for source, words, part in judged(children)])
    return lines


def short_block(kept):
    """The statements by verdict."""
    lines = []
    found = judged(counting(kept))
    for words, heading in (("agrees", "We agree"), ("disagrees", "We disagree"),
                           ("cannot tell", "These drapes cannot tell")):
        rows = [f"- {source}: {text} ({percent(part)})" for source, text, part in found if verdict(part) == words]
        lines += [f"**{heading}:**", "", *(rows or ["- in nothing"]), ""]
    return lines


def with_blocks(page, kept):
    """The page with what children.json says between its marks."""
    for name, made in (("children-short", short_block), ("children", block)):
        begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
        head, rest = page.split(begin, 1)
        page = head + begin + "\n" + "\n".join(made(kept)).rstrip() + "\n" + end + rest.split(end, 1)[1]
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("out/harms2012-children"))
    parser.add_argument("--jobs", type=int, default=0, help="cases at a time (default: one per core)")
    parser.add_argument("--page-only", action="store_true", help="only the page, from children.json")
    arguments = parser.parse_args()
    if arguments.page_only:
        kept = json.loads((HERE / "children.json").read_text())
        PAGE.write_text(with_blocks(PAGE.read_text(), kept))
        return
    run = subprocess.run([arguments.binary, "study", "run", str(STUDY), "-o", str(arguments.output),
                          "--keep-output", "--jobs", str(arguments.jobs)], stdout=subprocess.DEVNULL)
    if run.returncode not in (0, 1):
        raise SystemExit("error: the study did not run to its end")
    cases, asked = finished(arguments.output)
    if not cases:
        raise SystemExit(f"error: {arguments.output}: no case has scores")
    places = shirt_places([json.loads((folder / "summary.json").read_text()) for _, _, folder in cases])
    kept = {"asked": asked, "places": places, **made(cases),
            "minutes": round(sum(r["execution"]["seconds"] for _, r, _ in cases) / 60, 1),
            "children": [child(*case, places) for case in cases]}
    (HERE / "children.json").write_text(json_lines(kept) + "\n")
    PAGE.write_text(with_blocks(PAGE.read_text(), kept))


if __name__ == "__main__":
    main()
