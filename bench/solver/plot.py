#!/usr/bin/env python3
"""Draws residual over processor time and prints the table of one or several bakeoff.json.

usage: plot.py BAKEOFF.json … [-o FIGURE.svg]     (python3-matplotlib; without -o only the table)
"""
import argparse
import json
import sys


def problems_of(paths):
    for path in paths:
        with open(path) as file:
            record = json.load(file)
        for problem in record["problems"]:
            yield problem | {"limit": record["cpu_limit"], "tolerance": record["tolerance"]}


def table(problems):
    print("| start | method | reached | processor s | iterations | factorisations | best residual |")
    print("|---|---|---|---|---|---|---|")
    for problem in problems:
        for race in problem["races"]:
            reached = "yes" if race["reason"] == "converged" else race["reason"]
            print(f"| {problem['problem']} | {race['method']} | {reached} | {race['cpu_seconds']:.1f} "
                  f"| {race['iterations']} | {race['factorisations']} | {race['best_residual']:.1e} |")


def draw(problems, path):
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "loosefit"  # the same file from the same figures
    import matplotlib.pyplot as plt
    columns = 2
    rows = (len(problems) + 1) // columns
    figure, axes = plt.subplots(rows, columns, figsize=(10, 3.6 * rows), squeeze=False)
    names = list(dict.fromkeys(race["method"] for p in problems for race in p["races"]))
    for axis, problem in zip(axes.flat, problems):
        for race in problem["races"]:
            cpu = [s[1] for s in race["samples"]]
            residual = [s[4] for s in race["samples"]]
            step = max(1, len(cpu) // 250)  # a vector picture need not hold thousands of points
            axis.loglog(cpu[:-1:step] + cpu[-1:], residual[:-1:step] + residual[-1:],
                        color=f"C{names.index(race['method'])}", lw=1.2, label=race["method"],
                        ls="-" if race["reason"] == "converged" else "--")
        axis.axhline(problem["tolerance"], color="0.6", lw=0.8)
        axis.set_title(f"{problem['problem']}, {problem['vertices']} vertices", fontsize=10)
        axis.set_xlabel("processor time [s]")
        axis.set_ylabel("residual ‖F‖/‖W‖")
    for axis in list(axes.flat)[len(problems):]:
        axis.axis("off")
    handles, labels = max((a.get_legend_handles_labels() for a in axes.flat), key=lambda h: len(h[1]))
    figure.legend(handles, labels, loc="lower center", ncol=5, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.09 / rows * 2, 1, 1))
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", dest="figure")
    options = parser.parse_args()
    problems = list(problems_of(options.files))
    table(problems)
    if options.figure:
        draw(problems, options.figure)
    return 0


if __name__ == "__main__":
    sys.exit(main())
