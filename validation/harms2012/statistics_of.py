"""Means, bootstrap intervals, ranks, shares and directions of the study's samples."""

import cmath
import math
import random
import statistics

RESAMPLES = 2000
SURE = 0.8  # a statement that holds in this share of the draws is taken as shown
CALIBRATED, ABSOLUTE = "error_rms", "deviation"


def counted(case):
    return [d for d in case["drapes"] if "sites" in d]


def samples(case, sites, value=CALIBRATED):
    """site -> one figure per donning that counts and has it (a bend beyond those that are judged may
    be missing); the scapula is the mean of left and right."""
    names = {s: (["scapula_L", "scapula_R"] if s == "scapula" else [s]) for s in sites}
    pick = value if callable(value) else lambda site: site[value]
    return {s: [statistics.fmean(pick(d["sites"][n]) for n in names[s]) for d in counted(case)
                if pick(d["sites"][names[s][0]]) is not None] for s in sites}


def deviation(values):
    return statistics.stdev(values) if len(values) > 1 else 0.0


def over_donnings(by_site):
    """Means over resampled donnings, the same donnings for all sites."""
    return over_places([by_site])


def over_places(placements):
    """Means over resampled donnings, each site at one of the placements drawn for it alone: nobody
    knows where the study's sensors were, and each of them may have been off by itself."""
    placements = [p for p in placements if next(iter(p.values()))]
    source = random.Random(2012)
    for _ in range(RESAMPLES):
        means = []
        for by_site in placements:
            count = len(next(iter(by_site.values())))
            pick = [source.randrange(count) for _ in range(count)]
            means.append({s: statistics.fmean(v[i] for i in pick) for s, v in by_site.items()})
        yield {site: source.choice(means)[site] for site in placements[0]}


def ranking(draws):
    """Per site intervals (90 %) of mean and rank, the share of draws in which it is first, and what it
    ties with: either order is likelier than 1 - SURE."""
    draws = list(draws)
    sites = list(draws[0])
    means, ranks = {s: [] for s in sites}, {s: [] for s in sites}
    before = {(a, b): 0 for a in sites for b in sites if a != b}
    for mean in draws:
        now = sorted(sites, key=mean.get)
        for place, site in enumerate(now):
            means[site].append(mean[site])
            ranks[site].append(place + 1)
            for other in now[place + 1:]:
                before[site, other] += 1
    cut = len(draws) // 20
    interval = lambda values: (sorted(values)[cut], sorted(values)[-cut - 1])
    return {s: {"mean_interval": interval(means[s]), "rank_interval": interval(ranks[s]),
                "first": ranks[s].count(1) / len(draws),
                "tied": [o for o in sites if o != s and 1 - SURE < before[s, o] / len(draws) < SURE]}
            for s in sites}


def order_of(by_site):
    return sorted(by_site, key=lambda s: statistics.fmean(by_site[s]))


def order_text(by_site, names):
    """scapula 4.1 < mid back 5.0 ≈ upper back 5.2: neighbours that tie are joined by ≈."""
    order, found = order_of(by_site), ranking(over_donnings(by_site))
    text = ""
    for place, site in enumerate(order):
        if place:
            text += " ≈ " if order[place - 1] in found[site]["tied"] else " < "
        text += f"{names[site]} {statistics.fmean(by_site[site]):.1f}"
    return text


def share(draws, holds):
    """Share of the draws in which a statement holds."""
    draws = list(draws)
    return sum(map(holds, draws)) / len(draws)


def verdict(part):
    return "agrees" if part >= SURE else "disagrees" if part <= 1 - SURE else "cannot tell"


def mean_direction(wrinkles):
    """Mean angle of directions (a and a + 180° are the same), weighted by coherence [deg]."""
    whole = sum(w["coherence"] * cmath.exp(2j * math.radians(w["angle_deg"])) for w in wrinkles)
    return math.degrees(cmath.phase(whole)) / 2


def parts(wrinkle):
    """Rms slope of the upright and of the level part of the folds [deg]."""
    lean = wrinkle["coherence"] * math.cos(2 * math.radians(wrinkle["angle_deg"]))
    return [wrinkle["slope_rms_deg"] * math.sqrt((1 + sign * lean) / 2) for sign in (1, -1)]
