#!/usr/bin/env python3
"""Does the order of the four places depend on where exactly they are, or how large? -> places.json

Reads every settled drape of the main cases and samples the angular deviation on the back panel,
where the sensors are sewn: means over discs of several radii, discs shifted off the four places,
lines across the back and down the spine, and the wrinkle direction from the tilts against the body
instead of against the smoothed cloth.

    python3 validation/harms2012/places.py out/harms2012
"""

import json
import math
import pathlib
import sys

import numpy

from cases import HERE, MAIN, SITES
from drape_file import DrapeFile

RADII = [0.005, 0.012, 0.025, 0.040]                        # [m]
SHIFTS = [-0.03, -0.02, -0.01, 0.0, 0.01, 0.02, 0.03]       # [m]
FOOTPRINT = 0.012
WIDTHS = [0.015, 0.030, 0.060]                              # of the smoothing [m]
STEP = 0.005
AD = "angular_deviation_deg"


def drape_files(folder, summary):
    """The drapes that settled, the first donning first."""
    files = [folder / "drape.vtp"] if summary["settled"] else []
    for state in summary.get("states", []):
        if state["counts"]:
            files.append(folder / "donnings" / str(state["donning"]) / "reference" / "drape.vtp")
    return [DrapeFile(file) for file in files]


class BackPanel:
    """Linear interpolation on the flat back panel, the same for all donnings of a case."""

    def __init__(self, drape):
        uv, triangles = drape.panel("back")
        used, index = numpy.unique(triangles, return_inverse=True)
        self.used, self.triangles = used, index.reshape(-1, 3)
        self.uv = uv[used]

    def sampler(self, points):
        """Function from a vertex array of the garment to values at points (n, 2); NaN outside."""
        points = numpy.asarray(points, dtype=float)[:, None]
        a, b, c = (self.uv[self.triangles[:, k]][None] for k in range(3))
        cross = lambda p, q: p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0]
        whole = cross(b - a, c - a)
        second, third = cross(points - a, c - a) / whole, cross(b - a, points - a) / whole
        weights = numpy.stack([1 - second - third, second, third], axis=2)
        least = weights.min(axis=2)
        found = least.argmax(axis=1)
        rows = numpy.arange(len(found))
        weights, inside = weights[rows, found], least[rows, found] >= -1e-9
        corner = self.triangles[found]

        def sample(values):
            result = (values[self.used][corner] * weights).sum(axis=1)
            return numpy.where(inside, result, numpy.nan)
        return sample

    def mean_over_disc(self, centre, radius, fields):
        """Mean of each field over a disc, from 61 points of equal area."""
        rings = [(0.0, 1)] + [((k + 0.5) / 5, 6 * (k + 1)) for k in range(4)]
        points = [(centre[0] + radius * r * math.cos(2 * math.pi * i / n),
                   centre[1] + radius * r * math.sin(2 * math.pi * i / n))
                  for r, n in rings for i in range(n)]
        sample = self.sampler(points)
        return [float(numpy.nanmean(sample(field))) for field in fields]


def centres(summary, site):
    """Pattern places of a site: two for the scapula."""
    names = ["scapula_L", "scapula_R"] if site == "scapula" else [site]
    return [(summary["sites"][n]["u_m"], summary["sites"][n]["v_m"]) for n in names]


def site_means(panel, summary, site, fields, radius=FOOTPRINT, across=0.0, up=0.0):
    """Per donning; `across` points to the spine for the scapulae, to the wearer's right else."""
    means = []
    for u, v in centres(summary, site):
        inwards = -math.copysign(1, u) if site == "scapula" else 1
        means.append(panel.mean_over_disc((u + inwards * across, v + up), radius, fields))
    return numpy.mean(means, axis=0)


def tensor_of_tilts(panel, drape, v_from, v_to, half_width=0.08):
    """Angle to the vertical [deg] and coherence of the cloth's tilt against the body, less its mean,
    in a window of the pattern: a check that does not smooth the cloth."""
    u, v = panel.uv.T
    inside = (abs(u) <= half_width) & (v >= v_from) & (v <= v_to)
    tilt = numpy.stack([drape["tilt_lateral_deg"][panel.used][inside],
                        -drape["tilt_sagittal_deg"][panel.used][inside]], axis=1)
    tilt = tilt[numpy.isfinite(tilt).all(axis=1)]
    tensor = numpy.cov(tilt.T)
    across, shear = tensor[0, 0] - tensor[1, 1], 2 * tensor[0, 1]
    return [0.5 * math.degrees(math.atan2(shear, across)),
            math.hypot(across, shear) / (tensor[0, 0] + tensor[1, 1])]


class Diffusion:
    """Smoothing of vertex vectors over the flat, sewn cloth, by explicit steps: the wrinkle metric
    of maps/wrinkle_direction.h once more and otherwise, for other widths."""

    def __init__(self, drape):
        uv, corner = drape["corner_uv"].reshape(-1, 3, 2), drape.triangles
        cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
        twice_area = abs(cross(uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]))
        count = len(drape.points)
        self.mass = numpy.zeros(count)
        parts = []
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            numpy.add.at(self.mass, corner[:, k], twice_area / 6)
            a, b = uv[:, i] - uv[:, k], uv[:, j] - uv[:, k]
            parts.append((corner[:, i], corner[:, j], 0.5 * (a * b).sum(axis=1) / twice_area))
        self.i, self.j, self.weight = (numpy.concatenate(column) for column in zip(*parts))
        rows = numpy.bincount(self.i, abs(self.weight), count) \
            + numpy.bincount(self.j, abs(self.weight), count)
        self.step = 0.9 / (2 * rows / self.mass).max()

    def smooth(self, normals, width):
        steps = math.ceil(0.5 * width ** 2 / self.step)
        time, field = 0.5 * width ** 2 / steps, normals.copy()
        for _ in range(steps):
            flow = self.weight[:, None] * (field[self.j] - field[self.i])
            for axis in range(3):
                field[:, axis] += time / self.mass * (
                    numpy.bincount(self.i, flow[:, axis], len(field))
                    - numpy.bincount(self.j, flow[:, axis], len(field)))
        return field / numpy.linalg.norm(field, axis=1)[:, None]


def wrinkle_windows(panel, diffusion, drape, width, windows, half_width=0.08):
    """[angle to the vertical in degrees, coherence, rms slope in degrees] per window of the back."""
    normals = drape["Normals"]
    smooth = diffusion.smooth(normals, width)
    up = numpy.array([0.0, 0, 1]) - smooth[:, 2:] * smooth
    up /= numpy.linalg.norm(up, axis=1)[:, None]
    across = numpy.cross(up, smooth)
    parts = numpy.stack([(normals * f).sum(axis=1) for f in (across, up, smooth)], axis=1)
    sine = numpy.hypot(parts[:, 0], parts[:, 1])
    slopes = parts[:, :2] * (numpy.arctan2(sine, parts[:, 2]) / numpy.maximum(sine, 1e-12))[:, None]
    u, v = panel.uv.T
    found = {}
    for name, (low, high) in windows.items():
        inside = panel.used[(abs(u) <= half_width) & (v >= low) & (v <= high)]
        weight = diffusion.mass[inside]
        tensor = (slopes[inside].T * weight) @ slopes[inside] / weight.sum()
        difference, shear = tensor[0, 0] - tensor[1, 1], 2 * tensor[0, 1]
        found[name] = [0.5 * math.degrees(math.atan2(shear, difference)),
                       math.hypot(difference, shear) / numpy.trace(tensor),
                       math.degrees(math.sqrt(numpy.trace(tensor)))]
    return found


def line(panel, points, fields):
    """Mean and sample deviation over the donnings along a line."""
    sample = panel.sampler(points)
    values = numpy.array([sample(field) for field in fields])
    spread = values.std(axis=0, ddof=1) if len(values) > 1 else numpy.zeros(values.shape[1])
    keep = numpy.isfinite(values).all(axis=0)
    return [[round(float(m), 3), round(float(s), 3)] if ok else None
            for m, s, ok in zip(values.mean(axis=0), spread, keep)]


def of_case(folder):
    summary = json.loads((folder / "summary.json").read_text())
    drapes = drape_files(folder, summary)
    if not drapes:
        return None
    panel = BackPanel(drapes[0])
    fields = [drape[AD] for drape in drapes]
    rounded = lambda values: [round(float(x), 3) for x in values]
    kept = {"drapes": len(drapes), "centres": {s: centres(summary, s) for s in SITES}}
    kept["radius"] = {s: {f"{1000 * r:g}": rounded(site_means(panel, summary, s, fields, r))
                          for r in RADII} for s in SITES}
    kept["shift"] = {s: {f"{1000 * a:g},{1000 * b:g}":
                         rounded(site_means(panel, summary, s, fields, FOOTPRINT, a, b))
                         for a in SHIFTS for b in SHIFTS} for s in SITES}
    level = numpy.mean([v for _, v in kept["centres"]["scapula"]])
    across = numpy.arange(-0.15, 0.1501, STEP)
    down = numpy.arange(panel.uv[:, 1].max(), panel.uv[:, 1].min(), -STEP)
    kept["across"] = {"u_m": rounded(across), "v_m": round(float(level), 4),
                      AD: line(panel, [(u, level) for u in across], fields)}
    kept["spine"] = {"v_m": rounded(down), AD: line(panel, [(0.0, v) for v in down], fields)}
    windows = {name: (kept["centres"][name][0][1] - 0.06, kept["centres"][name][0][1] + 0.06)
               for name in ("mid_back", "lower_back")}
    kept["tilt_tensor"] = {name: [rounded(tensor_of_tilts(panel, d, *window)) for d in drapes]
                           for name, window in windows.items()}
    diffusion = Diffusion(drapes[0])
    kept["wrinkle_width"] = {}
    for width in WIDTHS:
        found = [wrinkle_windows(panel, diffusion, d, width, windows) for d in drapes]
        kept["wrinkle_width"][f"{1000 * width:g}"] = {
            name: [rounded(f[name]) for f in found] for name in windows}
    first = drapes[0].points
    kept["moved_mm"] = rounded([1000 * numpy.sqrt(((d.points - first) ** 2).sum(axis=1).mean())
                                for d in drapes[1:]])
    return kept


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    out = pathlib.Path(sys.argv[1])
    places = {name: of_case(out / name) for name in MAIN if (out / name / "summary.json").exists()}
    (HERE / "places.json").write_text(json.dumps(places) + "\n")


if __name__ == "__main__":
    main()
