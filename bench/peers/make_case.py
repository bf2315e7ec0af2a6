#!/usr/bin/env python3
"""Writes the case that other cloth programs can run too: a sleeveless two-panel shirt on a torso.

usage: make_case.py DIR

DIR/torso.obj    closed lofted torso, metres, z up, facing -y
DIR/shirt.json   front and back, GarmentCode specification in centimetres, placed before and behind
"""
import json
import math
import pathlib
import sys

# Height, half width, half depth of elliptic sections [m]; chest girth 0.91, waist 0.73, hip 0.94.
SECTIONS = [(0.55, 0.165, 0.115), (0.75, 0.172, 0.118), (0.85, 0.175, 0.120), (1.00, 0.135, 0.095),
            (1.15, 0.155, 0.112), (1.25, 0.168, 0.120), (1.33, 0.172, 0.106), (1.38, 0.160, 0.086),
            (1.42, 0.116, 0.068), (1.45, 0.077, 0.060), (1.49, 0.060, 0.056), (1.62, 0.055, 0.055)]
SECTORS, RINGS = 128, 220


def monotone(xs, ys):
    """Cubic through the points without overshoot (Fritsch and Carlson 1980)."""
    h = [b - a for a, b in zip(xs, xs[1:])]
    d = [(b - a) / s for a, b, s in zip(ys, ys[1:], h)]
    m = [d[0]] + [0 if a * b <= 0 else 2 * a * b / (a + b) for a, b in zip(d, d[1:])] + [d[-1]]

    def at(x):
        i = max(k for k in range(len(h)) if xs[k] <= x or k == 0)
        t = (x - xs[i]) / h[i]
        return (ys[i] * (1 + 2 * t) * (1 - t) ** 2 + ys[i + 1] * t * t * (3 - 2 * t)
                + h[i] * (m[i] * t * (1 - t) ** 2 - m[i + 1] * t * t * (1 - t)))
    return at


def torso():
    z = [s[0] for s in SECTIONS]
    half_width, half_depth = monotone(z, [s[1] for s in SECTIONS]), monotone(z, [s[2] for s in SECTIONS])
    points, faces = [], []
    for ring in range(RINGS + 1):
        height = z[0] + (z[-1] - z[0]) * ring / RINGS
        for k in range(SECTORS):
            angle = 2 * math.pi * k / SECTORS
            points.append((half_width(height) * math.cos(angle), half_depth(height) * math.sin(angle), height))
    for ring in range(RINGS):
        for k in range(SECTORS):
            a, b = ring * SECTORS + k, ring * SECTORS + (k + 1) % SECTORS
            faces += [(a, b, b + SECTORS), (a, b + SECTORS, a + SECTORS)]
    bottom, top, last = len(points), len(points) + 1, RINGS * SECTORS
    points += [(0, 0, z[0]), (0, 0, z[-1])]
    for k in range(SECTORS):
        n = (k + 1) % SECTORS
        faces += [(bottom, n, k), (top, last + k, last + n)]
    return points, faces


def panel(neck_depth, translation, rotation):
    """Counter-clockwise from the left of the hem, seen from outside; girth 1.00 m, length 0.62 m."""
    def curve(along, side):
        return {"type": "quadratic", "params": [[along, side]]}
    return {
        "label": "body", "translation": translation, "rotation": rotation,
        "vertices": [[-25, -62], [25, -62], [25, -24], [17, -3.5], [8, 0], [-8, 0], [-17, -3.5], [-25, -24]],
        "edges": [
            {"endpoints": [0, 1], "name": "hem"},
            {"endpoints": [1, 2], "name": "side_L"},
            {"endpoints": [2, 3], "name": "armhole_L", "curvature": curve(0.35, 0.25)},
            {"endpoints": [3, 4], "name": "shoulder_L"},
            {"endpoints": [4, 5], "name": "neck", "curvature": curve(0.5, 2 * neck_depth / 16)},
            {"endpoints": [5, 6], "name": "shoulder_R"},
            {"endpoints": [6, 7], "name": "armhole_R", "curvature": curve(0.65, 0.25)},
            {"endpoints": [7, 0], "name": "side_R"}]}


def shirt():
    def seam(front, back):
        return [{"panel": "front", "edge": front}, {"panel": "back", "edge": back}]
    return {
        "pattern": {
            "panels": {"front": panel(8, [0, 151, 17], [0, 0, 0]),
                       "back": panel(3, [0, 151, -17], [0, 180, 0])},
            "stitches": [seam(1, 7), seam(7, 1), seam(3, 5), seam(5, 3)],
            "panel_order": ["front", "back"]},
        "parameters": {}, "parameter_order": [],
        "properties": {"curvature_coords": "relative", "normalize_panel_translation": False,
                       "normalized_edge_loops": True, "units_in_meter": 100}}


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    points, faces = torso()
    with open(folder / "torso.obj", "w") as file:
        file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points)
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)
    (folder / "shirt.json").write_text(json.dumps(shirt(), indent=1) + "\n")
    print(f"torso of {len(faces)} triangles, shirt of two panels: {folder}")


if __name__ == "__main__":
    main()
