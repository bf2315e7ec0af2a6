#!/usr/bin/env python3
"""Tables and plot of docs/accuracy.md from results.json.

    python3 validation/convergence/tables.py          # needs python3-matplotlib
"""

import json
import math
import pathlib
import statistics

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "loosefit"
import matplotlib.pyplot as plot

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parent.parent
PAGE = REPOSITORY / "docs" / "accuracy.md"
PICTURE = REPOSITORY / "docs" / "images" / "convergence.svg"
# Title, scale, unit, statistic of a region: yarn strains have either sign, their means say little.
MAPS = {"strain_warp": ("strain of warp, 95th percentile", 100, "%", "p95"),
        "strain_weft": ("strain of weft, 95th percentile", 100, "%", "p95"),
        "shear_angle_deg": ("trellis shear, 95th percentile", 1, "°", "p95"),
        "strain_max": ("strain, largest principal, mean", 100, "%", "area_mean"),
        "distance_mm": ("distance, mean", 1, "mm", "area_mean"),
        "angular_deviation_deg": ("angular deviation, mean", 1, "°", "area_mean"),
        "angular_deviation_total_deg": ("angular deviation with crimp, mean", 1, "°", "area_mean")}
LIMIT = 0.10


def samples(results, edge, name, region):
    """The figure of every settled drape at this edge length."""
    statistic = MAPS[name][3]
    return [r["maps"][name][region][statistic] for r in results[edge].values() if r["settled"]]


def mean_and_deviation(values):
    return statistics.fmean(values), statistics.stdev(values) if len(values) > 1 else 0.0


def regions(results):
    first = next(r for r in results["20"].values() if r["settled"])
    return [r for r in first["maps"]["distance_mm"]]


def change(results, edge, finest, name, region):
    """Relative difference of the means from the finest mesh."""
    a, _ = mean_and_deviation(samples(results, edge, name, region))
    b, _ = mean_and_deviation(samples(results, finest, name, region))
    return abs(a - b) / abs(b)


def coarsest(edges, good):
    """The longest edge from which on every finer mesh is good too."""
    enough = None
    for edge in reversed(edges):
        if not good[edge]:
            break
        enough = edge
    return f"{enough} mm" if enough else f"below {edges[-1]} mm"


def region_table(results, name, edges):
    title, scale, unit, _ = MAPS[name]
    lines = [f"**{title}** ({unit}) ± standard deviation over the starts", "",
             "| region | " + " | ".join(f"{e} mm" for e in edges) + " | spread at 10 mm |",
             "|---|" + "---|" * (len(edges) + 1)]
    for region in regions(results):
        cells = []
        for edge in edges:
            m, d = mean_and_deviation(samples(results, edge, name, region))
            cells.append(f"{m * scale:.3g} ± {d * scale:.2g}")
        m, d = mean_and_deviation(samples(results, "10", name, region))
        lines.append(f"| {region.replace('_', ' ')} | " + " | ".join(cells) + f" | {d / abs(m):.0%} |")
    return lines + [""]


def need_table(results, edges):
    finest = edges[-1]
    lines = [f"Difference from the {finest} mm mesh, over the {len(regions(results)) - 1} regions:", "",
             "| map | " + " | ".join(f"{e} mm: median, worst" for e in edges[:-1])
             + f" | edge length for {LIMIT:.0%} in the median region, in nine regions of ten |",
             "|---|" + "---|" * len(edges)]
    for name, (title, *_) in MAPS.items():
        cells, median_ok, most_ok = [], {}, {}
        for edge in edges[:-1]:
            errors = sorted(change(results, edge, finest, name, r)
                            for r in regions(results) if r != "whole")
            cells.append(f"{statistics.median(errors):.0%}, {errors[-1]:.0%}")
            median_ok[edge] = statistics.median(errors) <= LIMIT
            most_ok[edge] = errors[math.ceil(0.9 * len(errors)) - 1] <= LIMIT
        need = coarsest(edges[:-1], median_ok) + ", " + coarsest(edges[:-1], most_ok)
        lines.append(f"| {title} | " + " | ".join(cells) + f" | {need} |")
    return lines + [""]


def load_table(results, edges):
    """Force over weight by mesh, mean and standard deviation over the starts."""
    lines = ["| edges | drapes | normal force over weight | of it squeezed between arms and trunk | free of them |",
             "|---|---|---|---|---|"]
    for edge in edges:
        loads = [r["load"] for r in results[edge].values() if r["settled"]]
        kinds = ([r["force_over_weight"] for r in loads], [r["squeezed"] for r in loads],
                 [r["force_over_weight"] - r["squeezed"] for r in loads])
        cells = ["{:.1f} ± {:.1f}".format(*mean_and_deviation(values)) for values in kinds]
        lines.append(f"| {edge} mm | {len(loads)} | " + " | ".join(cells) + " |")
    return lines


def put(page, mark, lines):
    """The page with these lines between the marks of that name."""
    begin, end = f"<!-- {mark}: begin -->", f"<!-- {mark}: end -->"
    if begin not in page or end not in page:
        raise SystemExit(f"error: {PAGE}: found no place for a table, expected {begin} … {end}")
    head, rest = page.split(begin, 1)
    return head + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end, 1)[1]


def draw(results, edges):
    figure, axes = plot.subplots(2, 3, figsize=(11, 7))
    for axis, (name, (title, scale, unit, _)) in zip(axes.flat, MAPS.items()):
        for region in ["whole", "scapula_L", "upper_back", "mid_back", "lower_back", "chest"]:
            values = [mean_and_deviation(samples(results, e, name, region)) for e in edges]
            axis.errorbar([float(e) for e in edges], [m * scale for m, _ in values],
                          [d * scale for _, d in values], marker="o", markersize=3, capsize=2,
                          linewidth=1, label=region.replace("_", " "))
        axis.set_xlabel("edge length [mm]")
        axis.set_title(f"{title} [{unit}]", fontsize=10)
        axis.set_xlim(0, 22)
        if not name.startswith("strain_w"):
            axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
    axes[0, 0].legend(fontsize=7, frameon=False)
    figure.tight_layout()
    PICTURE.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(PICTURE, metadata={"Date": None})


def main():
    results = json.loads((HERE / "results.json").read_text())
    missing = [m for m in MAPS for runs in results.values() for r in runs.values()
               if r["settled"] and m not in r["maps"]]
    if missing:
        raise SystemExit(f"error: {HERE / 'results.json'}: found no {missing[0]}, expected all of "
                         f"{', '.join(MAPS)}; run run.py again")
    edges = [e for e in sorted(results, key=float, reverse=True)
             if any(r["settled"] for r in results[e].values())]
    lines = []
    count = {e: sum(r["settled"] for r in results[e].values()) for e in edges}
    lines.append("Drapes settled: " + ", ".join(f"{e} mm {count[e]} of {len(results[e])}"
                                               for e in edges) + ".")
    lines.append("")
    lines += need_table(results, edges)
    for name in MAPS:
        lines += region_table(results, name, edges)
    draw(results, edges)
    page = put(PAGE.read_text(), "convergence", lines[:-1])  # they end with an empty line
    PAGE.write_text(put(page, "load by mesh", load_table(results, edges)))


if __name__ == "__main__":
    main()
