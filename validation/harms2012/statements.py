"""What the paper says (section 3), as tests on our figures, with a verdict for each case.

A statement about places is tried on every draw of donnings and places (statistics_of.over_places),
one about folds on every donning. The share of draws in which it holds is the verdict: agrees from
80 %, disagrees to 20 %, cannot tell between. The statements of the simulation are about the angular
deviation of the upright drape, those of the study about the calibrated error of inclination.
"""

import statistics

from cases import FOLDS, MOVED, SITES
from statistics_of import (ABSOLUTE, CALIBRATED, mean_direction, over_donnings, over_places, samples,
                           share)

LEVEL, UPRIGHT_FOLD, PLAIN = 60, 30, 0.2  # [deg], [deg], least coherence that is a direction
NOTABLE = 5  # a deviation that "could result in orientation errors" [deg]; the paper has no figure

order = lambda mean: sorted(mean, key=mean.get)
# source, what the paper says, in what it is measured here, test on the means of the four places
OF_PLACES = [
    ("simulation", "low deviation at the upper back: below mid and lower back", ABSOLUTE,
     lambda m: m["upper_back"] < min(m["mid_back"], m["lower_back"])),
    ("simulation", "low deviation at the scapula: below mid and lower back", ABSOLUTE,
     lambda m: m["scapula"] < min(m["mid_back"], m["lower_back"])),
    ("simulation", f"orientation errors possible in middle and lower back: both above {NOTABLE}°", ABSOLUTE,
     lambda m: min(m["mid_back"], m["lower_back"]) > NOTABLE),
    ("study", "the scapula sensor has the smallest error", CALIBRATED,
     lambda m: order(m)[0] == "scapula"),
    ("study", "the mid back is marginally worse: second", CALIBRATED,
     lambda m: order(m)[1] == "mid_back"),
    ("study", "lower and upper back are the two worst", CALIBRATED,
     lambda m: set(order(m)[2:]) == {"lower_back", "upper_back"}),
    # The paper explains its upper back by hair, which ours do not have.
    ("study", "without the upper back: the scapula has the smallest error", CALIBRATED,
     lambda m: m["scapula"] < min(m["mid_back"], m["lower_back"])),
    ("study", "without the upper back: the mid back errs less than the lower back", CALIBRATED,
     lambda m: m["mid_back"] < m["lower_back"]),
]
OF_FOLDS = [
    ("simulation", "loose child: vertical folds in middle and lower back", ["slim"],
     ("mid_back", "lower_back"), lambda angle: abs(angle) <= UPRIGHT_FOLD),
    ("simulation", "child tight at the hip: horizontal folds above it", ["heavy", "tight-hip"],
     ("lower_back",), lambda angle: abs(angle) >= LEVEL),
]
MEASURES = {ABSOLUTE: "angular deviation upright", CALIBRATED: "calibrated error"}


def placements(results, name, value):
    """Samples at the places themselves, then beside them."""
    found = [results[name]] + [results[m] for m in MOVED if m.startswith(f"{name}-moved") and m in results]
    return [samples(case, SITES, value) for case in found]


def fold_share(case, regions, holds):
    """Share of the donnings with plain folds of that direction in all the regions."""
    seen = [d["wrinkles"] for d in case["drapes"] if "wrinkles" in d]
    good = [all(w[r]["coherence"] >= PLAIN and holds(w[r]["angle_deg"]) for r in regions) for w in seen]
    return sum(good) / len(good) if good else None


def fold_words(case):
    seen = [d["wrinkles"] for d in case["drapes"] if "wrinkles" in d]
    return ", ".join(f"{r.replace('_', ' ')} {abs(mean_direction([w[r] for w in seen])):.0f}° off the vertical, "
                     f"coherence {statistics.fmean(w[r]['coherence'] for w in seen):.2f}"
                     for r in ("mid_back", "lower_back"))


def judged(results, cases):
    """One entry a statement: source, text, measure, case -> (share, share at the places themselves)."""
    found = []
    for source, text, children, regions, holds in OF_FOLDS:
        parts = {}
        for name in [*cases, *(f for f in FOLDS if f in results)]:
            part = (fold_share(results[name], regions, holds)
                    if any(name.startswith(child) for child in children) else None)
            if part is not None:
                parts[name] = (part, None)
        found.append((source, text, "folds of the upright drape", parts))
    for source, text, value, holds in OF_PLACES:
        parts = {}
        for name in cases:
            sets = placements(results, name, value)
            if sets[0]["scapula"]:
                parts[name] = (share(over_places(sets), holds), share(over_donnings(sets[0]), holds))
        found.append((source, text, MEASURES[value], parts))
    return found
