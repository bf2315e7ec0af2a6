#!/usr/bin/env python3
"""How often the difference of two limits of looseness would be marked where there is none.

usage: limit_stars.py [--trials N] [--resamples N] [--seed N]                      needs python3-numpy

`loosefit study compare` gives the difference of the limits of two studies with a bootstrap interval of 90 % over
people, and marks it where the interval is clear of zero; with up to 20 people it marks none. This is why. Each
person's score falls along a straight line with the BGM, by a slope and from a height of his own; each study adds a
normal error of its own to the height. People who are drawn jointly are the same in both studies. The limit of a study is where the robust score,
the 5th percentile over people, falls below what passes. Both limits have one distribution, so of intervals of 90 % a
tenth should be clear of zero. Prints the share that is, for people who are drawn jointly and independently.
"""
import argparse

import numpy

PASS, SHARE, CONFIDENCE = 0.5, 0.05, 0.9
BGM = numpy.linspace(-0.5, 1.0, 31)


def limits(scores, draws):
    """Greatest BGM that passes, of every draw of people; scores: people x BGM, draws: draws x people."""
    rank = max(0, int(numpy.ceil(SHARE * draws.shape[1] - 1e-9)) - 1)
    robust = numpy.partition(scores[draws], rank, axis=1)[:, rank, :]
    found = numpy.empty(len(draws))
    for i, curve in enumerate(robust):
        passing = numpy.flatnonzero(curve >= PASS)
        if not len(passing):
            found[i] = -numpy.inf
        elif passing[-1] + 1 == len(BGM):
            found[i] = numpy.inf
        else:
            k = passing[-1]
            found[i] = BGM[k] + (curve[k] - PASS) / (curve[k] - curve[k + 1]) * (BGM[k + 1] - BGM[k])
    return found


def clear_of_zero(people, jointly, resamples, random):
    """Whether two studies without a difference would be told to differ."""
    def wearers():
        return random.normal(1.0, 0.1, people), random.normal(2.0, 0.2, people)

    same = wearers()
    height, slope = zip(*((same, same) if jointly else (wearers(), wearers())))
    a, b = (height[i][:, None] + random.normal(0, 0.05, people)[:, None] - slope[i][:, None] * BGM for i in range(2))
    draws = random.integers(people, size=(resamples, people))
    others = draws if jointly else random.integers(people, size=(resamples, people))
    difference = numpy.sort(limits(b, others) - limits(a, draws))
    low = difference[int(numpy.ceil((1 - CONFIDENCE) / 2 * resamples)) - 1]
    high = difference[int(numpy.ceil((1 + CONFIDENCE) / 2 * resamples)) - 1]
    return low > 0 or high < 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=300)
    parser.add_argument("--resamples", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    random = numpy.random.default_rng(options.seed)
    print(f"{'people':>7}{'jointly':>9}{'independently':>15}")
    for people in (3, 6, 12, 20, 21, 30, 40, 59, 100):
        shares = [numpy.mean([clear_of_zero(people, jointly, options.resamples, random) for _ in range(options.trials)])
                  for jointly in (True, False)]
        print(f"{people:7}{100 * shares[0]:7.0f} %{100 * shares[1]:13.0f} %", flush=True)


if __name__ == "__main__":
    main()
