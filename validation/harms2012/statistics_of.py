"""Means, bootstrap intervals, ranks and directions of the study's samples."""

import cmath
import math
import random
import statistics

RESAMPLES = 2000
TIE = 0.2  # either order at least this likely: tied


def samples(case, sites, value="angular_deviation_deg"):
    """site -> one figure per settled donning; the scapula is the mean of left and right."""
    drapes = [d for d in case["drapes"] if "sites" in d]
    names = {s: (["scapula_L", "scapula_R"] if s == "scapula" else [s]) for s in sites}
    return {s: [statistics.fmean(d["sites"][n][value] for n in names[s]) for d in drapes]
            for s in sites}


def deviation(values):
    return statistics.stdev(values) if len(values) > 1 else 0.0


def resampled(by_site):
    """Means over resampled donnings, the same donnings for all sites."""
    count = len(next(iter(by_site.values())))
    source = random.Random(2012)
    for _ in range(RESAMPLES):
        pick = [source.randrange(count) for _ in range(count)]
        yield {site: statistics.fmean(values[i] for i in pick) for site, values in by_site.items()}


def ranking(by_site):
    """Sites by mean; per site interval of the mean, interval of the rank, and what it ties with."""
    order = sorted(by_site, key=lambda s: statistics.fmean(by_site[s]))
    means = {s: [] for s in order}
    ranks = {s: [] for s in order}
    before = {(a, b): 0 for a in order for b in order if a != b}
    for mean in resampled(by_site):
        now = sorted(order, key=mean.get)
        for place, site in enumerate(now):
            means[site].append(mean[site])
            ranks[site].append(place + 1)
            for other in now[place + 1:]:
                before[site, other] += 1
    cut = RESAMPLES // 20
    interval = lambda values: (sorted(values)[cut], sorted(values)[-cut - 1])
    tied = {s: [o for o in order if o != s
                and TIE < before[s, o] / RESAMPLES < 1 - TIE] for s in order}
    return order, {s: {"mean_interval": interval(means[s]), "rank_interval": interval(ranks[s]),
                       "tied": tied[s]} for s in order}


def order_text(by_site, names):
    """scapula 4.1 < mid back 5.0 ≈ upper back 5.2: neighbours that tie are joined by ≈."""
    order, found = ranking(by_site)
    text = ""
    for place, site in enumerate(order):
        if place:
            text += " ≈ " if order[place - 1] in found[site]["tied"] else " < "
        text += f"{names[site]} {statistics.fmean(by_site[site]):.1f}"
    return text


def mean_direction(wrinkles):
    """Mean angle of directions (a and a + 180° are the same), weighted by coherence [deg]."""
    whole = sum(w["coherence"] * cmath.exp(2j * math.radians(w["angle_deg"])) for w in wrinkles)
    return math.degrees(cmath.phase(whole)) / 2


def parts(wrinkle):
    """Rms slope of the upright and of the level part of the folds [deg]."""
    lean = wrinkle["coherence"] * math.cos(2 * math.radians(wrinkle["angle_deg"]))
    return [wrinkle["slope_rms_deg"] * math.sqrt((1 + sign * lean) / 2) for sign in (1, -1)]
