#!/usr/bin/env python3
"""Eight garments on eight people: the picture of the README, docs/images/eight-garments.png.

usage: eight.py [--binary FILE] [--out DIR] [--picture FILE]

Six garments of the program's own drafts, a dress and a jumpsuit written in GarmentCode's grammar (garments.py), 14 mm
edges, worn in. Runs that are in DIR already are not made again. Ends with an error where one is not settled and worn.
All people are drawn to one scale; bands of the picture in which nothing stands are made narrow. Needs numpy and matplotlib.
"""
import argparse
import json
import pathlib
import subprocess
import sys

import matplotlib.image
import numpy as np

import garments

ROOT = pathlib.Path(__file__).resolve().parents[2]


def person(sex, age, height, chest, waist, hip):
    who = {"male": "boy man", "female": "girl woman"}[sex].split()[age >= 16]
    return (f"{who} of {age}", f'sex = "{sex}"\nage = {age}\nheight = {height}\n'
            f'measurements = {{ chest = {chest}, waist = {waist}, hip = {hip} }}\n',
            {"bust": 100 * chest, "waist": 100 * waist, "hip": 100 * hip, "height": 100 * height})


# Name, what it is, on whom, of what.
EIGHT = [
    ("shirt", 'pattern = "long-sleeve-shirt"\nfit = { chest = 0.15, hip = 0.12, cuff_width = 0.05 }',
     person("female", 30, 1.68, 0.90, 0.72, 0.97), "cotton-broad"),
    ("t-shirt", 'pattern = "t-shirt"\nfit = { chest = 0.12, hip = 0.1, neckband_width = 0.02 }',
     person("male", 35, 1.80, 1.00, 0.86, 1.02), "cotton-jersey"),
    ("tank top", 'pattern = "tank-top"', person("male", 22, 1.86, 0.94, 0.78, 0.96), "cotton-jersey"),
    ("hoodie", 'pattern = "hoodie"', person("female", 25, 1.74, 0.84, 0.66, 0.92), "cotton-jersey"),
    ("trousers", 'pattern = "trousers"', person("male", 60, 1.72, 1.06, 1.00, 1.06), "wool-tropical"),
    ("leggings", 'pattern = "leggings"', person("female", 11, 1.45, 0.72, 0.62, 0.77), "compression-knit"),
    ("dress_a", None, person("female", 45, 1.64, 1.02, 0.86, 1.06), "paper-cotton"),
    ("jumpsuit", None, person("female", 70, 1.60, 0.98, 0.86, 1.02), "paper-cotton"),
]


def narrow_empty_bands(file, most=40):
    """Leaves `most` rows of pixels of every white band of a picture."""
    picture = matplotlib.image.imread(file)[..., :3]
    empty = (picture > 0.999).all(axis=(1, 2))
    run, keep = 0, np.ones(len(empty), bool)
    for i, nothing in enumerate(empty):
        run = run + 1 if nothing else 0
        keep[i] = run <= most
    matplotlib.image.imsave(file, picture[keep])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "eight")
    parser.add_argument("--picture", type=pathlib.Path, default=ROOT / "docs" / "images" / "eight-garments.png")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    folders = []
    for name, garment, (_, body, girths), fabric in EIGHT:
        folder = options.out / name.replace(" ", "-")
        if garment is None:
            file = options.out / f"{name}_specification.json"
            file.write_text(garments.build(girths)[name][1])
            garment = f'pattern = "{file.name}"'
        scenario = folder.with_suffix(".toml")
        text = (f'[body]\n{body}\n[garment]\n{garment}\n\n[material]\nname = "{fabric}"\n\n'
                "[simulation]\nedge_length = 0.014\ntime_budget = 3600\n\n[output]\npreset_sites = false\n")
        if not (folder / "summary.json").exists() or scenario.read_text() != text:
            scenario.write_text(text)
            subprocess.run([options.binary, "run", str(scenario), "-o", str(folder), "-q", "--no-pictures"])
        summary = json.loads((folder / "summary.json").read_text())
        if not (summary["settled"] and summary["worn"]):
            sys.exit(f"error: {name}: {summary['stop_reason']}, worn {summary['worn']}: {summary.get('worn_reasons')}")
        print(f"{name}: {summary['seconds']['total']:.0f} s", flush=True)
        folders.append(str(folder))
    labels = [arg for name, _, (who, *_), _ in EIGHT
              for arg in ("--label", f"{name.replace('_a', '')}, {who}")]
    subprocess.run([options.binary, "render", *folders, *labels, "--map", "drape", "--view", "30,5", "--size", "420,640",
                    "--columns", "4", "-o", str(options.picture), "--overwrite", "-q"], check=True)
    narrow_empty_bands(options.picture)


if __name__ == "__main__":
    main()
