#!/usr/bin/env python3
"""The tables of docs/validation/harms2012.md from results.json.

    python3 validation/harms2012/tables.py [--into FOLDER]    # FOLDER: of a quick trial
"""

import argparse
import datetime
import json
import pathlib
import statistics

from cases import (BENDS, BOARDS, CHILDREN, EDGE, FOLDS, HERE, JUDGED, MAIN, MOVED, MOVES, REPOSITORY, SIDE,
                   SITES)
from statements import LEVEL, PLAIN, UPRIGHT_FOLD, fold_words, judged, placements
from statistics_of import (ABSOLUTE, CALIBRATED, counted, deviation, mean_direction, order_of,
                           order_text, over_donnings, over_places, parts, ranking, samples, verdict)

PAGE = REPOSITORY / "docs" / "validation" / "harms2012.md"
NAMES = {"scapula": "scapula", "upper_back": "upper back", "mid_back": "mid back",
         "lower_back": "lower back", "scapula_L": "left scapula", "scapula_R": "right scapula",
         "hips": "hips (buttocks, to the hem)"}
CLOTHS = {"paper-cotton": "cotton", "cotton-jersey": "jersey"}
VARIANTS = {"bare": "no boards", "as-put-on": "no movements after putting on",
            "fine": "finer mesh"}
BEYOND = [b for posture, b in BENDS.items() if posture not in JUDGED]
READINGS = {"rms over the judged bends": CALIBRATED, "largest of them": "largest",
            **{f"bent {b}°": lambda site, b=b: abs(site["error"][str(b)]) if str(b) in site["error"] else None
               for b in BEYOND},
            "by the normal alone": "normal_rms", "whole rotation, calibrated": "coe_rms",
            "upright difference, not calibrated": lambda site: abs(site["upright"]),
            "angular deviation upright": ABSOLUTE}


def title(name):
    if name in FOLDS:
        return "tight hip, cotton, no boards"
    child = next(c for c in CHILDREN if name.startswith(c))
    return f"{child}, {CLOTHS[name[len(child) + 1:]]}"


def pm(values, digits=1):
    spread = f" ± {deviation(values):.{digits}f}" if len(values) > 1 else ""
    return f"{statistics.fmean(values):.{digits}f}{spread}".replace("-", "−")


def span(pair, digits=1):
    return "{} … {}".format(*(f"{x:.{digits}f}" for x in pair))


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(row) + " |" for row in rows), ""]


def degrees(value):
    """Whole degrees without a negative zero."""
    return f"{round(value)}°".replace("-", "−")


def percent(part):
    return f"{100 * part:.0f} %"


def day_of(file):
    """The day on which a result was written."""
    return datetime.datetime.fromtimestamp(file.stat().st_mtime, datetime.timezone.utc).date().isoformat()


def made_by(records):
    """Version, build and day of results; older ones have neither build nor day."""
    said = lambda key: sorted({text for r in records for text in (r.get(key) or "not recorded").split(", ")})
    return (f"version {', '.join(said('version'))}, build {', '.join(build[:12] for build in said('build'))}, "
            f"date {', '.join(said('date'))}")


def main_cases(results):
    """Those that were run and have a donning that counts: the table of cases tells of the others."""
    return [name for name in MAIN if name in results and counted(results[name])]


def run_block(results):
    cases = [case for name, case in results.items() if name != "places"]
    edges = sorted({results[name]["case"]["edge_mm"] for name in MAIN if name in results})
    donnings = sorted({results[name]["case"]["donnings"] for name in MAIN if name in results})
    text = (f"Loosefit, {made_by(cases)}; edges of {' and '.join(map(str, edges))} mm, "
            f"{' and '.join(map(str, donnings))} donnings a child and cloth; "
            f"{sum(case['seconds'] for case in cases) / 60:.0f} minutes for all drapes.")
    missing = [name for name in MAIN if name not in main_cases(results)]
    lines = [text, ""]
    if edges != [EDGE] or missing:
        lines = ["**A coarse or incomplete trial of the scripts: not the study.** "
                 + (f"Not there: {', '.join(missing)}. " if missing else "") + text, ""]
    return lines


def short_block(results):
    """The statements by verdict."""
    lines = []
    found = judged(results, main_cases(results))
    for words, heading in (("agrees", "We agree"), ("disagrees", "We disagree"),
                           ("cannot tell", "These drapes cannot tell")):
        rows = []
        for source, text, _, cases in found:
            own = [name for name, (part, _) in cases.items() if verdict(part) == words]
            if own:
                where = ("all cases" if set(own) == set(main_cases(results)) and len(own) > 1
                         else "; ".join(title(n) for n in own))
                rows.append(f"- {source}: {text} ({where})")
        lines += [f"**{heading}:**", "", *(rows or ["- in nothing"]), ""]
    return lines


def statements_block(results):
    cases = main_cases(results)
    found = judged(results, cases)
    cases = cases + [name for name in FOLDS if any(name in by_case for *_, by_case in found)]
    rows = []
    for source, text, measure, by_case in found:
        cells = []
        for name in cases:
            if name not in by_case:
                cells.append("–")
                continue
            part, itself = by_case[name]
            cells.append(f"{verdict(part)}, {percent(part)}"
                         + ("" if itself is None else f" ({percent(itself)})"))
        rows.append([source, text, measure, *cells])
    lines = table(["from", "the paper", "here by", *(title(n) for n in cases)], rows)
    return lines + [f"- Folds, {title(name)}: {fold_words(results[name])}." for name in cases] + [""]


def fit_block(results):
    rows = []
    for name, child in [("slim-paper-cotton", "slim"), ("heavy-paper-cotton", "heavy"),
                        ("tight-hip-upright", "tight hip")]:
        if name in results:
            fit = results[name]["fit"]
            rows.append([child] + [f"{100 * fit[k]:+.0f} %".replace("-", "−") for k in
                                   ("chest", "waist", "hip", "sleeve", "wrist")])
    return table(["child", "chest", "waist", "hip", "sleeve", "wrist"], rows)


def places_block(results):
    places = results["places"]
    return table(["place", *(NAMES[n] for n in BOARDS)],
                 [["across, from the middle of the back [mm]",
                   *(f"{1000 * places[n][0]:.0f}".replace("-", "−") for n in BOARDS)],
                  ["down from the highest point of the shoulder seam [mm]",
                   *(f"{-1000 * places[n][1]:.0f}" for n in BOARDS)]])


def counts_block(results):
    rows, left = [], []

    def add(label, names):
        found = [results[n] for n in names if n in results]
        if not found:
            rows.append([label, "–", "–", "**not run**", "–"])
            return
        drapes = [d for case in found for d in case["drapes"]]
        good = sum("sites" in d or d["settled"] and "left_out" not in d for d in drapes)
        wished = sum(case["case"]["donnings"] for case in found)
        rows.append([label, f"{found[0]['case']['edge_mm']} mm", str(found[0]["vertices"]),
                     f"{good} of {wished}", f"{sum(c['seconds'] for c in found) / 60:.0f}"])
        for case in found:
            if case["start_perturbation"]:
                left.append(f"{label}: its first drape settled only with the start shaken by "
                            f"{1000 * case['start_perturbation']:g} mm rms")
            for k, d in enumerate(case["drapes"]):
                why = d.get("left_out", {} if d["settled"] else {"upright": d["stop_reason"]})
                if why:
                    left.append(f"{label}, donning {k + 1}: "
                                + ", ".join(f"{posture} ({reason})" for posture, reason in why.items()))

    for name in MAIN:
        add(title(name), [name])
        add(f"{title(name)}, boards beside their places", [m for m in MOVED if m.startswith(name)])
    for name in SIDE:
        child = name.split("-")[0]
        add(f"{child}, cotton, {VARIANTS[name[len(child) + 1:]]}", [name])
    for name in FOLDS:
        add(title(name), [name])
    return table(["case", "edges", "vertices", "donnings that count", "minutes"], rows) + [
        "Left out, or of note: " + ("; ".join(left) if left else "none") + ".", ""]


def ranking_block(results):
    lines = []
    for name in main_cases(results):
        sets = placements(results, name, CALIBRATED)
        by_site, count = sets[0], len(sets[0]["scapula"])
        absolute = samples(results[name], SITES, ABSOLUTE)
        own, all_places = ranking(over_donnings(by_site)), ranking(over_places(sets))
        least = {s: sum(by_site[s][k] == min(v[k] for v in by_site.values()) for k in range(count))
                 for s in SITES}
        beside = {s: [statistics.fmean(p[s]) for p in sets if p[s]] for s in SITES}
        rows = []
        for place, s in enumerate(order_of(by_site)):
            rows.append([
                str(place + 1), NAMES[s], pm(by_site[s]), span(own[s]["mean_interval"]),
                span((min(beside[s]), max(beside[s]))), span(own[s]["rank_interval"], 0),
                span(all_places[s]["rank_interval"], 0), f"{least[s]} of {count}",
                percent(all_places[s]["first"]), pm(absolute[s]),
                str(order_of(absolute).index(s) + 1)])
        lines += [f"**{title(name)}**, {count} donnings; places beside: {len(sets) - 1}, "
                  f"{sum(len(p['scapula']) for p in sets[1:])} donnings", ""]
        lines += table(["rank", "place", "calibrated error [°]", "90 % of its mean", "means, boards moved",
                        "90 % of the rank", "with places", "least in", "first, with places",
                        "angular deviation upright [°]", "its rank"], rows)
        sides = samples(results[name], ["scapula_L", "scapula_R"])
        greater = sum(a > b for a, b in zip(sides["scapula_L"], sides["scapula_R"]))
        lines += [f"Left shoulder blade {pm(sides['scapula_L'])}°, right {pm(sides['scapula_R'])}°; "
                  f"the left one errs more in {greater} of {count} donnings.", ""]
    return lines


def bends_block(results):
    rows = []
    for name in main_cases(results):
        for s in SITES:
            at = {b: {key: samples(results[name], [s], lambda site: site[key].get(str(b)))[s]
                      for key in ("skin", "error")} for b in BENDS.values()}
            skin = " / ".join(f"{statistics.fmean(v['skin']):.0f}" if v["skin"] else "–" for v in at.values())
            rows.append([title(name), NAMES[s], skin, pm(samples(results[name], [s], "upright")[s]),
                         *(f"{pm(v['error'])} ({len(v['error'])})" if v["error"] else "–"
                           for v in at.values())])
    return table(["case", "place", f"skin leans by, bent {' / '.join(map(str, BENDS.values()))}° [°]",
                  "upright, sensor less skin [°]",
                  *(f"error, bent {b}° [°] (donnings)" for b in BENDS.values())], rows)


def readings_block(results):
    rows = []
    for name in main_cases(results):
        for words, value in READINGS.items():
            by_site = samples(results[name], SITES, value)
            if by_site["scapula"]:
                rows.append([title(name), words, order_text(by_site, NAMES)])
    return table(["case", "reading", "order [°], ≈ tied"], rows)


def moved_block(results):
    rows = []
    for name in main_cases(results):
        for k, (across, up) in enumerate([(0, 0), *MOVES]):
            case = results.get(f"{name}-moved-{k}" if k else name)
            if not case or not counted(case):
                continue
            where = ("as addressed" if not k else
                     f"{abs(up)} mm {'up' if up > 0 else 'down'}" if up else
                     f"{abs(across)} mm {'to the spine' if across > 0 else 'outwards'} "
                     f"(on the spine: {'right' if across > 0 else 'left'})")
            by_site = samples(case, SITES)
            rows.append([title(name), where, str(len(by_site["scapula"])),
                         *(pm(by_site[s]) for s in SITES)])
    return table(["case", "boards", "donnings", *(f"{NAMES[s]} [°]" for s in SITES)], rows)


def across_block(results):
    """Calibrated error across the blades, mean of left and right, by the distance from the spine."""
    rows = []
    for name in main_cases(results):
        line = results[name].get("profiles", {}).get("across")
        if line:
            at = {round(x): mean for (x, _), mean in zip(line["at_mm"], line["error_rms"]["mean"])}
            pairs = [(at.get(x), at.get(-x)) for x in ACROSS]
            rows.append([title(name), *("–" if None in pair else f"{statistics.fmean(pair):.1f}"
                                        for pair in pairs)])
    return table(["from the spine [mm]", *map(str, ACROSS)], rows)


def variants_block(results):
    rows = []
    for child in CHILDREN:
        for name, words in [(f"{child}-paper-cotton", "the study"),
                            *((f"{child}-{v}", text) for v, text in VARIANTS.items())]:
            if name not in results or not counted(results[name]):
                continue
            case = results[name]
            rows.append([child, f"{words}, {case['case']['edge_mm']} mm edges", str(len(counted(case))),
                         *(order_text(samples(case, SITES, v), NAMES) for v in (CALIBRATED, ABSOLUTE))])
    return table(["child", "variant", "donnings", "calibrated error [°], ≈ tied",
                  "angular deviation upright [°]"], rows)


def wrinkles_block(results):
    titles = {**{name: title(name) for name in MAIN},
              **{f"{c}-bare": f"{c}, cotton, no boards" for c in CHILDREN},
              **{name: title(name) for name in FOLDS}}
    rows = []
    for name, words in titles.items():
        for region in ("mid_back", "lower_back", "hips"):
            found = [d["wrinkles"][region] for d in results.get(name, {"drapes": []})["drapes"]
                     if "wrinkles" in d]
            if not found:
                continue
            plain = [w for w in found if w["coherence"] >= PLAIN]
            rows.append([words, NAMES[region], degrees(mean_direction(found)),
                         pm([w["coherence"] for w in found], 2), pm([parts(w)[0] for w in found]),
                         pm([parts(w)[1] for w in found]),
                         f"{sum(abs(w['angle_deg']) <= UPRIGHT_FOLD for w in plain)} of {len(found)}",
                         f"{sum(abs(w['angle_deg']) >= LEVEL for w in plain)} of {len(found)}"])
    return table(["case", "region", "fold direction to the vertical", "coherence",
                  "slope of upright folds [° rms]", "of level folds", "upright in", "level in"], rows)


ACROSS = range(0, 121, 20)  # [mm]
BLOCKS = {"run": run_block, "short": short_block, "statements": statements_block, "fit": fit_block,
          "places": places_block, "counts": counts_block, "ranking": ranking_block, "bends": bends_block,
          "readings": readings_block, "moved": moved_block, "across": across_block, "variants": variants_block,
          "wrinkles": wrinkles_block}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--into", type=pathlib.Path, help="folder of a quick trial: reads its results.json "
                        "and writes the page there")
    into = parser.parse_args().into
    results = json.loads(((into or HERE) / "results.json").read_text())
    if not main_cases(results):
        raise SystemExit("error: results.json: found no donning that counts, expected at least one of "
                         f"{', '.join(MAIN)}: run run_study.py")
    page = PAGE.read_text()
    for name, block in BLOCKS.items():
        begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
        if begin not in page or end not in page:
            raise SystemExit(f"error: {PAGE}: found no place for a table, expected {begin} … {end}")
        head, rest = page.split(begin, 1)
        page = head + begin + "\n" + "\n".join(block(results)).rstrip() + "\n" + end \
            + rest.split(end, 1)[1]
    (into / PAGE.name if into else PAGE).write_text(page)


if __name__ == "__main__":
    main()
