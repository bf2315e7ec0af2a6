#!/usr/bin/env python3
"""The pictures of docs/validation/harms2012.md from the pictures and figures of the runs.

    python3 validation/harms2012/pictures.py out/harms2012 [--into FOLDER]    # FOLDER: of a quick trial
"""

import argparse
import json
import pathlib

import matplotlib

matplotlib.use("agg")
matplotlib.rcParams["svg.hashsalt"] = "loosefit"
import matplotlib.patheffects
import matplotlib.pyplot as plot
import numpy
from PIL import Image

from cases import CHILDREN, HERE, MATERIALS, REPOSITORY
from drape_file import DrapeFile

LETTERS = {"scapula_L": "S", "scapula_R": "S", "upper_back": "U", "mid_back": "M",
           "lower_back": "L"}
NAMES = {"scapula": "scapula", "upper_back": "upper back", "mid_back": "mid back",
         "lower_back": "lower back"}
COLOURS = {"slim": "#1f5fa8", "heavy": "#c2570c"}
MARGIN = 1.06            # of render/scene.cpp: frame over the garment's extent
FOOT = 1 / 7             # share of a map's picture that is the legend


def back_projection(drape, width, height):
    """Pixel of a point in the back view (parallel, centred on the garment)."""
    low, high = drape.points.min(axis=0), drape.points.max(axis=0)
    centre, size = (low + high) / 2, high - low
    scale = 0.5 * MARGIN * max(size[2], max(size[0], size[1]) * height / width)
    per_metre = height / 2 / scale
    return lambda p: (width / 2 - (p[0] - centre[0]) * per_metre,
                      height / 2 - (p[2] - centre[2]) * per_metre)


def save(figure, target):
    """As small as a PNG goes without fewer colours, which would show in maps and legends."""
    figure.savefig(target)
    plot.close(figure)
    Image.open(target).convert("RGB").save(target, optimize=True)


def scene_and_legend(picture):
    image = plot.imread(picture)
    foot = round(image.shape[0] * FOOT)
    return image[:-foot], image[-foot:]


def frame(axis):
    axis.set_xticks([])
    axis.set_yticks([])
    for side in axis.spines.values():
        side.set_visible(False)


def mark_sites(axis, folder, shape):
    summary = json.loads((folder / "summary.json").read_text())
    pixel = back_projection(DrapeFile(folder / "drape.vtp"), shape[1], shape[0])
    for name, letter in LETTERS.items():
        x, y = pixel(summary["sites"][name]["position_m"])
        axis.plot(x, y, "o", markersize=8, markerfacecolor="none", markeredgecolor="black",
                  markeredgewidth=3)
        axis.plot(x, y, "o", markersize=8, markerfacecolor="none", markeredgecolor="white",
                  markeredgewidth=1.4)
        axis.annotate(letter, (x, y), (8, 4), textcoords="offset points", color="white",
                      fontsize=12, fontweight="bold",
                      path_effects=[matplotlib.patheffects.withStroke(linewidth=2.5,
                                                                      foreground="black")])


def title_of(folder, child):
    fit = json.loads((folder / "summary.json").read_text())["fit"]["measured"]
    return (f"{child} child: BGM chest {100 * fit['chest']:+.0f} %, waist "
            f"{100 * fit['waist']:+.0f} %, hip {100 * fit['hip']:+.0f} %")


def figure4(out, images, material):
    """Both children from behind in one shirt: how it hangs, and its angular deviation."""
    if not any((out / f"{child}-{material}" / "maps").exists() for child in CHILDREN):
        return
    figure = plot.figure(figsize=(9, 9.2), dpi=92)
    for column, child in enumerate(CHILDREN):
        folder = out / f"{child}-{material}"
        if not (folder / "maps").exists():
            continue
        axis = figure.add_axes([0.5 * column, 0.53, 0.5, 0.44])
        axis.imshow(plot.imread(folder / "maps" / "drape-back.png"))
        axis.set_title(title_of(folder, child), fontsize=10.5)
        frame(axis)
        axis = figure.add_axes([0.5 * column, 0.085, 0.5, 0.44])
        scene, legend = scene_and_legend(folder / "maps" / "angular-deviation-back.png")
        axis.imshow(scene)
        mark_sites(axis, folder, scene.shape)
        frame(axis)
    axis = figure.add_axes([0.28, 0.0, 0.44, 0.085])
    axis.imshow(legend)
    frame(axis)
    save(figure, images / f"harms2012-back-{material}.png")


def tight_hip(out, images):
    """The heavy child and the one on whose hip the shirt is tight."""
    figure = plot.figure(figsize=(9, 4.7), dpi=92)
    for column, (name, child) in enumerate(((f"heavy-{MATERIALS[0]}", "heavy"), ("tight-hip-upright", "tight hip"))):
        axis = figure.add_axes([0.5 * column, 0, 0.5, 0.93])
        axis.imshow(plot.imread(out / name / "maps" / "drape-back.png"))
        axis.set_title(title_of(out / name, child), fontsize=10.5)
        frame(axis)
    save(figure, images / "harms2012-tight-hip.png")


def figure3(out, images):
    """The paper's four panels of the reference garment."""
    panels = [("drape", "(a) reference garment"), ("strain", "(b) vertical strain"),
              ("distance", "(c) body-garment distance"),
              ("angular-deviation", "(d) angular deviation")]
    figure = plot.figure(figsize=(12, 4.1), dpi=110)
    for column, (name, title) in enumerate(panels):
        image = plot.imread(out / "reference" / "maps" / f"{name}-front.png")
        axis = figure.add_axes([0.25 * column + 0.01, 0.0, 0.23, 0.93])
        if name == "drape":  # no legend: keep the scale of the others
            blank = numpy.ones((round(image.shape[0] * FOOT / (1 - FOOT)), *image.shape[1:]))
            image = numpy.concatenate([image, blank.astype(image.dtype)])
        axis.imshow(image)
        axis.set_title(title, fontsize=11)
        frame(axis)
    save(figure, images / "harms2012-reference.png")


def profile(axis, x, values, colour, label):
    ok = [i for i, v in enumerate(values["mean"]) if v is not None]
    x = numpy.array([x[i] for i in ok])
    mean, spread = (numpy.array([values[key][i] for i in ok]) for key in ("mean", "deviation"))
    axis.plot(x, mean, color=colour, linewidth=1.6, label=label)
    axis.fill_between(x, mean - spread, mean + spread, color=colour, alpha=0.2, linewidth=0)


def lines(results, images):
    """Calibrated error and angular deviation across the back at the shoulder blades and down the spine."""
    figure, axes = plot.subplots(2, 2, figsize=(11, 7), dpi=110, sharex="col")
    for row, (key, words) in enumerate((("error_rms", "calibrated error, rms [°]"),
                                        ("angular_deviation", "angular deviation upright [°]"))):
        for column, (line, axis_of) in enumerate((("across", 0), ("spine", 1))):
            axis, sign = axes[row][column], 1 - 2 * axis_of
            for child in CHILDREN:
                case = results.get(f"{child}-{MATERIALS[0]}", {}).get("profiles")
                if case:
                    profile(axis, [sign * at[axis_of] for at in case[line]["at_mm"]], case[line][key],
                            COLOURS[child], f"{child} child")
            for name, (u, v) in results["places"].items():
                if name.startswith("scapula") == (line == "across"):
                    axis.axvline(1000 * (u if line == "across" else -v), color="grey", linestyle=":")
                    axis.annotate(NAMES[name.removesuffix("_L").removesuffix("_R")],
                                  (1000 * (u if line == "across" else -v), 0.97), (-3, 0),
                                  xycoords=("data", "axes fraction"), textcoords="offset points",
                                  rotation=90, fontsize=8.5, ha="right", va="top")
            axis.set_ylim(bottom=0)
            axis.grid(alpha=0.3)
        axes[row][0].set_ylabel(words)
    axes[1][0].set_xlabel("across the back panel at the shoulder blades [mm], 0 = spine")
    axes[1][1].set_xlabel("down the spine on the back panel [mm]")
    axes[0][0].legend(frameon=False, fontsize=9, loc="upper center")
    figure.tight_layout()
    save(figure, images / "harms2012-lines.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--into", type=pathlib.Path, help="folder of a quick trial: reads its results.json "
                        "and draws there")
    arguments = parser.parse_args()
    images = arguments.into / "images" if arguments.into else REPOSITORY / "docs" / "images"
    images.mkdir(parents=True, exist_ok=True)
    for material in MATERIALS:
        figure4(arguments.out, images, material)
    figure3(arguments.out, images)
    tight_hip(arguments.out, images)
    lines(json.loads(((arguments.into or HERE) / "results.json").read_text()), images)


if __name__ == "__main__":
    main()
