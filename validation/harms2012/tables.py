#!/usr/bin/env python3
"""The tables of docs/validation/harms2012.md from results.json and places.json.

    python3 validation/harms2012/tables.py
"""

import json
import statistics

from cases import HERE, MAIN, REPOSITORY, SIDE, SITES
from statistics_of import deviation, mean_direction, order_text, parts, ranking, samples

PAGE = REPOSITORY / "docs" / "validation" / "harms2012.md"
NAMES = {"scapula": "scapula", "upper_back": "upper back", "mid_back": "mid back",
         "lower_back": "lower back", "scapula_L": "scapula L", "scapula_R": "scapula R",
         "hips": "hips (buttocks, to the hem)"}
TITLES = {"slim-paper-cotton": "slim child, cotton of the paper",
          "heavy-paper-cotton": "heavy child, cotton of the paper",
          "slim-cotton-jersey": "slim child, cotton jersey",
          "heavy-cotton-jersey": "heavy child, cotton jersey"}
VARIANTS = {"base": "14 mm edges, else as above", "arms": "arms 40° aside instead of 25°", "low": "arms 12° aside instead of 25°",
            "lifted": "put on up to 30 mm off", "literal": "cotton with the printed modulus of fibre",
            "knit": "cotton with the tension of a knit", "friction": "friction on skin 0.9, not 0.4",
            "starts": "only the start shaken by 1 mm rms"}
AD = "angular_deviation_deg"
LEVEL, UPRIGHT, PLAIN = 60, 30, 0.2  # [deg], [deg], least coherence that is a direction


def pm(values, digits=1):
    return f"{statistics.fmean(values):.{digits}f} ± {deviation(values):.{digits}f}"


def settled(case):
    return [d for d in case["drapes"] if d["settled"]]


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(row) + " |" for row in rows), ""]


def degrees(value):
    """Whole degrees without a negative zero."""
    return f"{round(value)}°".replace("-", "−")


def words(holds):
    """Verdict of a statement over the two children in the paper's cotton."""
    return {(True, True): "agrees", (False, False): "disagrees"}.get(
        tuple(holds.values()), "; ".join(f"{child}: {'agrees' if ok else 'disagrees'}"
                                         for child, ok in holds.items()))


def main_cases(found):
    """Those that were run: the table of cases tells which were not."""
    return [name for name in MAIN if found.get(name)]


def statements_block(results, _):
    """Each statement of the paper with our figures and a verdict by a fixed rule."""
    cases = {child: results[f"{child}-paper-cotton"] for child in ("slim", "heavy")}
    by_site = {child: samples(case, SITES) for child, case in cases.items()}
    if not all(s["scapula"] for s in by_site.values()):
        return ["No drape settled."]
    order, found = {}, {}
    for child in cases:
        order[child], found[child] = ranking(by_site[child])
    mean = {c: {s: statistics.fmean(v) for s, v in by_site[c].items()} for c in cases}

    def folds(child, test):
        parts, share = [], []
        for region in ("mid_back", "lower_back"):
            seen = [d["wrinkles"][region] for d in settled(cases[child])]
            good = sum(w["coherence"] >= PLAIN and test(abs(w["angle_deg"])) for w in seen)
            share.append(good / len(seen))
            parts.append(f"{NAMES[region]} {degrees(mean_direction(seen))}, coherence "
                         f"{statistics.fmean(w['coherence'] for w in seen):.2f}, in {good} of "
                         f"{len(seen)} donnings")
        return "; ".join(parts), min(share) > 0.5

    def sites(*names):
        return "; ".join(f"{c}: " + ", ".join(f"{NAMES[s]} {mean[c][s]:.1f}°" for s in names)
                         for c in cases)

    upright, slim_ok = folds("slim", lambda a: a <= UPRIGHT)
    level, heavy_ok = folds("heavy", lambda a: a >= LEVEL)
    least = {c: sum(by_site[c]["scapula"][k] == min(v[k] for v in by_site[c].values())
                    for k in range(len(by_site[c]["scapula"]))) for c in cases}
    first = {c: order[c][0] == "scapula" or "scapula" in found[c][order[c][0]]["tied"]
             for c in cases}
    low = {c: max(mean[c]["scapula"], mean[c]["upper_back"])
           < min(mean[c]["mid_back"], mean[c]["lower_back"]) for c in cases}
    spine = {c: min(mean[c]["mid_back"], mean[c]["lower_back"]) > 5 for c in cases}
    second = {c: order[c].index("mid_back") == 1 or
              (order[c].index("mid_back") == 2 and order[c][1] in found[c]["mid_back"]["tied"])
              for c in cases}
    worst = {c: set(order[c][2:]) == {"lower_back", "upper_back"} for c in cases}
    rows = [
        ["simulation, slim child", "vertical drape in middle and lower back (high BGM)",
         "within 30° of the vertical: " + upright, words({"slim": slim_ok, "heavy": slim_ok})],
        ["simulation, child tight at the hip", "horizontal drape above the hip (small BGM)",
         "heavy, beyond 60°: " + level, words({"slim": heavy_ok, "heavy": heavy_ok})],
        ["simulation, both", "low deviations at the upper back and scapula (below mid and lower "
         "back)", sites("scapula", "upper_back", "mid_back", "lower_back"), words(low)],
        ["simulation, both", "orientation errors possible in middle and lower back along the spine "
         "(5° or more)", sites("mid_back", "lower_back"), words(spine)],
        ["study, all 21 children", "the scapula sensor has the smallest error",
         "; ".join(f"{c}: place {order[c].index('scapula') + 1} of 4, least in {least[c]} of "
                   f"{len(by_site[c]['scapula'])} donnings" for c in cases), words(first)],
        ["study", "mid back marginally worse (second)",
         "; ".join(f"{c}: place {order[c].index('mid_back') + 1}, "
                   f"{mean[c]['mid_back'] - mean[c]['scapula']:+.1f}° against the scapula"
                   for c in cases).replace("-", "−"), words(second)],
        ["study", "lower and upper back considerably deflected (the two worst)",
         "; ".join(f"{c}: worst {NAMES[order[c][3]]}, then {NAMES[order[c][2]]}" for c in cases),
         words(worst)]]
    return table(["from", "the paper", "here, cotton of the paper", "verdict"], rows)


def settled_block(results, places):
    rows = []
    for name, case in results.items():
        if "repeats" in case:
            values = next(iter(case["repeats"].values()), {"count": 0})
            count, wished = values["count"], case["case"]["repeats"]
        else:
            count, wished = len(settled(case)), len(case["drapes"])
        moved = places.get(name, {}).get("moved_mm") if places.get(name) else None
        rows.append([name, case["case"]["material"], f"{case['case']['edge_mm']} mm",
                     str(case["vertices"]), f"{count} of {wished}",
                     f"{min(moved):.1f} … {max(moved):.1f}" if moved else "–"])
    left = [f"{name}: donning {k + 1}, {d['stop_reason']}"
            + (f" at a residual of {d['residual']:.2e}" if d["residual"] else "") for name, case in results.items()
            for k, d in enumerate(case["drapes"]) if not d["settled"]]
    for name, spec in {**MAIN, **SIDE}.items():
        if name not in results:
            rows.append([name, spec["material"], f"{spec['edge_mm']} mm", "–", "**not run**", "–"])
    return table(["case", "material", "edges", "vertices", "settled",
                  "cloth moved against the first donning [mm rms]"], rows) + [
        "Not settled, and left out of all figures: " + ("; ".join(left) if left else "none") + ".", ""]


def fit_block(results, _):
    rows = []
    for name, child in [("slim-paper-cotton", "slim"), ("heavy-paper-cotton", "heavy"),
                        ("stocky-base", "stocky"), ("tight-hip-base", "tight hip")]:
        if name in results:
            fit = results[name]["fit"]
            rows.append([child] + [f"{100 * fit[k]:+.0f} %".replace("-", "−") for k in
                                   ("chest", "waist", "hip", "sleeve", "wrist")])
    return table(["child", "chest", "waist", "hip", "sleeve", "wrist"], rows)


def ranking_block(results, _):
    lines = []
    for name in main_cases(results):
        by_site = samples(results[name], SITES)
        if not by_site["scapula"]:
            lines += [f"**{TITLES[name]}**: no drape settled.", ""]
            continue
        count = len(by_site["scapula"])
        worst = samples(results[name], SITES, AD + "_worst")
        least = {s: sum(by_site[s][k] == min(v[k] for v in by_site.values()) for k in range(count))
                 for s in SITES}
        order, found = ranking(by_site)
        lines += [f"**{TITLES[name]}**, {count} donnings", ""]
        lines += table(
            ["rank", "site", "mean ± deviation [°]", "90 % of the mean [°]", "least … greatest [°]",
             "worst 5 % of the disc [°]", "90 % of the rank", "tied with", "least in"],
            [[str(place + 1), NAMES[s], pm(by_site[s]),
              "{:.1f} … {:.1f}".format(*found[s]["mean_interval"]),
              f"{min(by_site[s]):.1f} … {max(by_site[s]):.1f}", f"{statistics.fmean(worst[s]):.1f}",
              "{} … {}".format(*found[s]["rank_interval"]),
              ", ".join(NAMES[o] for o in found[s]["tied"]) or "–", f"{least[s]} of {count}"]
             for place, s in enumerate(order)])
        sides = samples(results[name], ["scapula_L", "scapula_R"])
        greater = sum(a > b for a, b in zip(sides["scapula_L"], sides["scapula_R"]))
        lines += [f"Left shoulder blade {pm(sides['scapula_L'])}°, right {pm(sides['scapula_R'])}°; "
                  f"the left one is the greater in {greater} of {count} donnings.", ""]
    return lines


def regions_block(results, _):
    regions = ["scapula_L", "scapula_R", "upper_back", "mid_back", "lower_back", "hips"]
    rows = []
    for region in regions:
        cells = []
        for name in main_cases(results):
            values = [d["regions"][region][AD] for d in settled(results[name]) if "regions" in d]
            cells.append(pm(values) if values else "–")
        rows.append([NAMES[region], *cells])
    return table(["region", *(TITLES[n] for n in main_cases(results))], rows)


def direction_row(case, region, tensor):
    found = [d["wrinkles"][region] for d in settled(case) if "wrinkles" in d]
    if not found:
        return ["–"] * 7
    plain = [w for w in found if w["coherence"] >= PLAIN]
    upright = sum(abs(w["angle_deg"]) <= UPRIGHT for w in plain)
    level = sum(abs(w["angle_deg"]) >= LEVEL for w in plain)
    check = "–"
    if tensor:
        mean = mean_direction([{"angle_deg": a, "coherence": c} for a, c in tensor])
        check = f"{degrees(mean)}, {statistics.fmean(c for _, c in tensor):.2f}"
    return [degrees(mean_direction(found)), pm([w["coherence"] for w in found], 2),
            pm([parts(w)[0] for w in found]), pm([parts(w)[1] for w in found]), f"{upright} of {len(found)}",
            f"{level} of {len(found)}", check]


def wrinkles_block(results, places):
    rows = []
    extra = [n for n in ("stocky-base", "tight-hip-base") if n in results]
    for name in [*main_cases(results), *extra]:
        for region in ("mid_back", "lower_back", "hips"):
            tensor = (places.get(name) or {}).get("tilt_tensor", {}).get(region)
            rows.append([TITLES.get(name, name.replace("-base", " child, 14 mm edges")),
                         NAMES[region], *direction_row(results[name], region, tensor)])
    return table(["case", "region", "fold direction to the vertical", "coherence",
                  "slope of upright folds [° rms]", "of level folds",
                  "upright in", "level in", "check: direction, coherence"], rows)


def width_block(_, places):
    rows = []
    for name in main_cases(places):
        for width, regions in places[name]["wrinkle_width"].items():
            cells = []
            for region in ("mid_back", "lower_back"):
                found = [{"angle_deg": a, "coherence": c} for a, c, _ in regions[region]]
                slopes = [slope for _, _, slope in regions[region]]
                cells += [degrees(mean_direction(found)),
                          f"{statistics.fmean(w['coherence'] for w in found):.2f}", pm(slopes)]
            rows.append([TITLES[name], f"{width} mm", *cells])
    return table(["case", "smoothed over", "mid back: direction", "coherence", "slope [° rms]",
                  "lower back: direction", "coherence", "slope [° rms]"], rows)


def lifted_block(results, _):
    how = {"base": "as put on", "lifted": "put on up to 30 mm off", "bent": "after a bend of 30°"}
    rows = []

    def add(child, what, drapes):
        seen = [[parts(d["wrinkles"][r]) for d in drapes]
                for r in ("mid_back", "lower_back", "hips")]
        rows.append([child, what, str(len(drapes)),
                     *(pm([p[k] for p in region]) if len(region) > 1 else f"{region[0][k]:.1f}"
                       for region in seen for k in (0, 1))])

    for child in ("heavy", "tight-hip"):
        for variant, words_of in how.items():
            drapes = [d for d in results.get(f"{child}-{variant}", {"drapes": []})["drapes"]
                      if "wrinkles" in d]
            if not drapes:
                continue
            name = child.replace("-", " ")
            add(name, words_of, drapes)
            if variant == "lifted":
                top = max(drapes, key=lambda d: d["how"]["shift_m"][2])
                add(name, f"… {1000 * top['how']['shift_m'][2]:.0f} mm too high", [top])
    return table(["child", "", "drapes", "mid back: upright [° rms]", "level", "lower back: upright",
                  "level", "hips: upright", "level"], rows)


def tilt_block(results, _):
    lines = []
    for name in main_cases(results):
        signed = samples(results[name], SITES, "tilt_sagittal_deg")
        if not signed["scapula"]:
            continue
        sizes = {s: [abs(v) for v in signed[s]] for s in SITES}
        lines.append([TITLES[name], *(pm(signed[s]).replace("-", "−") for s in SITES), order_text(sizes, NAMES),
                      " < ".join(f"{NAMES[s]} {deviation(signed[s]):.1f}" for s in
                                 sorted(SITES, key=lambda s: deviation(signed[s])))])
    return table(["case", *(NAMES[s] + " [°]" for s in SITES), "order by size",
                  "order by deviation over donnings"], lines)


def address_block(_, places):
    rows = []
    for across in (-20, -10, 0, 10, 20, 30):
        where = (f"{abs(across)} mm {'towards the spine' if across > 0 else 'outwards'}"
                 if across else "as addressed")
        cells = []
        for name in main_cases(places):
            case = places[name]
            by_site = {s: case["shift"][s]["0,0"] for s in SITES}
            by_site["scapula"] = case["shift"]["scapula"][f"{across},0"]
            order, found = ranking(by_site)
            place = order.index("scapula") + 1
            ties = found["scapula"]["tied"]
            cells.append(f"{statistics.fmean(by_site['scapula']):.1f}°, place {place}"
                         + (" (tied)" if ties else ""))
        rows.append([where, *cells])
    lines = table(["scapula site", *(TITLES[n] for n in main_cases(places))], rows)
    rows = []
    for site in SITES:
        cells = []
        for name in main_cases(places):
            case = places[name]
            means = [statistics.fmean(v) for k, v in case["shift"][site].items()
                     if max(abs(float(x)) for x in k.split(",")) <= 20]
            cells.append(f"{statistics.fmean(case['shift'][site]['0,0']):.1f} "
                         f"({min(means):.1f} … {max(means):.1f})")
        rows.append([NAMES[site], *cells])
    return lines + table(["site [°], and over places up to 20 mm off along and across",
                          *(TITLES[n] for n in main_cases(places))], rows)


def radius_block(_, places):
    rows = []
    for name in main_cases(places):
        for radius in ("5", "12", "25", "40"):
            by_site = {s: places[name]["radius"][s][radius] for s in SITES}
            rows.append([TITLES[name], f"{radius} mm", order_text(by_site, NAMES)])
    return table(["case", "disc radius", "order [°], ≈ tied"], rows)


def variants_block(results, _):
    rows = []
    for name in SIDE:
        if name not in results or "postures" in SIDE[name]:
            continue
        case, (child, _, variant) = results[name], name.rpartition("-")
        if "repeats" in case:
            if not case["repeats"]:
                continue
            mean = {s: case["repeats"][s]["mean"] for s in SITES[1:]}
            mean["scapula"] = statistics.fmean(case["repeats"][s]["mean"]
                                               for s in ("scapula_L", "scapula_R"))
            text = " < ".join(f"{NAMES[s]} {mean[s]:.1f}" for s in sorted(mean, key=mean.get))
            count = case["repeats"]["mid_back"]["count"]
            spread = ", ".join(f"{NAMES[s]} {case['repeats'][s]['deviation']:.1f}"
                               for s in case["repeats"])
            rows.append([f"{child} child, {VARIANTS[variant]}", str(count),
                         f"{text} (no ties known; deviations {spread})"])
            continue
        by_site = samples(case, SITES)
        count = len(by_site["scapula"])
        rows.append([f"{child.replace('-', ' ')} child, {VARIANTS[variant]}", str(count),
                     order_text(by_site, NAMES) if count else "none settled"])
    return table(["variant", "donnings", "order [°], ≈ tied"], rows)


BLOCKS = {"statements": statements_block, "settled": settled_block, "fit": fit_block, "ranking": ranking_block,
          "regions": regions_block, "wrinkles": wrinkles_block, "tilt": tilt_block,
          "address": address_block, "radius": radius_block, "variants": variants_block, "width": width_block,
          "lifted": lifted_block}


def main():
    results = json.loads((HERE / "results.json").read_text())
    places = json.loads((HERE / "places.json").read_text())
    if not {"slim-paper-cotton", "heavy-paper-cotton"} <= set(results):
        raise SystemExit("error: results.json: found not both children in the paper's cotton, "
                         "expected at least these: run run_study.py")
    page = PAGE.read_text()
    for name, block in BLOCKS.items():
        begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
        if begin not in page or end not in page:
            raise SystemExit(f"error: {PAGE}: found no place for a table, expected {begin} … {end}")
        head, rest = page.split(begin, 1)
        page = head + begin + "\n" + "\n".join(block(results, places)).rstrip() + "\n" + end \
            + rest.split(end, 1)[1]
    PAGE.write_text(page)


if __name__ == "__main__":
    main()
