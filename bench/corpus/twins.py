#!/usr/bin/env python3
"""Scans of people whose measures are known: parametric people in a pose of their own, as a scanner would store them.

usage: twins.py --out DIR [--binary FILE] [--noise METRES] [--seed N]

Each twin is posed by the program, then loses all that tells where it came from: a third of the edges are flipped, vertices slide
along the skin, bumps of two widths are added to it (2 mm in sum), soles, crown and crotch get holes, and vertices are
shuffled, turned, moved and stored in centimetres with y up. Beside NAME.obj lies NAME.json with the measures of the parametric twin.
Needs numpy (python3-numpy).
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import people  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# Who, and how they stand: T-pose, A-pose, arms hanging.
POSES = {
    "t": ["--arm-abduction-deg", "86", "--elbow-extension", "0.9"],
    "a": ["--arm-abduction-deg", "38", "--elbow-extension", "0.5"],
    "relaxed": ["--posture", "standing"],
}
NOISE = 0.002  # metres, root mean square
TWINS = {"twin-woman-a": ("woman", "a"), "twin-man-t": ("man", "t"), "twin-girl-relaxed": ("girl", "relaxed")}


def arguments(person):
    """The [body] section of a person of people.py as options of `loosefit body`."""
    words = person["body"].replace("measurements = {", "").replace("}", "").replace(",", "\n").splitlines()
    pairs = [w.split("=") for w in words if "=" in w]
    return [part for key, value in pairs for part in ("--" + key.strip(), value.strip().strip('"'))]


def read_obj(path):
    points, faces = [], []
    for line in open(path):
        if line.startswith("v "):
            points.append([float(x) for x in line.split()[1:4]])
        elif line.startswith("f "):
            faces.append([int(x.split("/")[0]) - 1 for x in line.split()[1:4]])
    return np.array(points), np.array(faces)


def normals(points, faces):
    face = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    out = np.zeros_like(points)
    for k in range(3):
        np.add.at(out, faces[:, k], face)
    return out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-12)


def flipped(points, faces, share, rng):
    """A share of the edges as the other diagonal of their two triangles, where these stay well shaped."""
    owner = {}
    for t, (a, b, c) in enumerate(faces):
        for u, v, w in ((a, b, c), (b, c, a), (c, a, b)):
            owner[(u, v)] = (t, w)
    faces, busy = faces.copy(), np.zeros(len(faces), bool)
    edges = [e for e in owner if e[0] < e[1]]
    rng.shuffle(edges)
    for u, v in edges[: int(len(edges) * share)]:
        (s, w), (t, x) = owner[(u, v)], owner[(v, u)]
        if busy[s] or busy[t] or (w, x) in owner or (x, w) in owner:
            continue
        old = np.cross(points[v] - points[u], points[w] - points[u])
        one = np.cross(points[x] - points[w], points[u] - points[w])
        two = np.cross(points[w] - points[x], points[v] - points[x])
        if min(one @ old, two @ old) < 0.2 * (old @ old):
            continue
        faces[s], faces[t] = (w, u, x), (x, v, w)
        busy[s] = busy[t] = True
    return faces


def bumps(points, rng, width):
    """A smooth random field over space, of variance one, that changes over `width` metres."""
    waves = rng.normal(size=(64, 3)) / width
    phase = rng.uniform(0, 2 * np.pi, 64)
    return np.cos(points @ waves.T + phase).sum(axis=1) * np.sqrt(2 / 64)


def scanned(points, faces, noise, rng):
    faces = flipped(points, faces, 0.33, rng)
    n = normals(points, faces)
    length = np.linalg.norm(points[faces[:, 0]] - points[faces[:, 1]], axis=1).mean()
    slide = rng.normal(size=points.shape) * 0.08 * length
    points = points + slide - n * (slide * n).sum(axis=1, keepdims=True)
    points = points + n * (noise * (0.5 * bumps(points, rng, 0.05) + 0.7 * bumps(points, rng, 0.012)
                                    + 0.5 * rng.normal(size=len(points))))[:, None]
    # Holes where a scanner sees nothing.
    height = points[:, 2].max() - points[:, 2].min()
    lost = np.zeros(len(points), bool)
    for spot in hidden(points, height):
        lost |= np.linalg.norm(points - spot, axis=1) < 0.005 * height
    faces = faces[~lost[faces].any(axis=1)]
    used = np.zeros(len(points), bool)
    used[faces] = True
    order = np.flatnonzero(used)
    rng.shuffle(order)
    place = np.full(len(points), -1)
    place[order] = np.arange(len(order))
    faces = place[faces]
    rng.shuffle(faces)
    points = points[order]
    turn = rng.uniform(-0.2, 0.2)
    c, s = np.cos(turn), np.sin(turn)
    points = points @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T + rng.uniform(-0.5, 0.5, 3)
    return 100 * points[:, [0, 2, 1]] * [1, 1, -1], faces


def hidden(points, height):
    """Crown, soles and crotch."""
    low = points[:, 2].min()
    yield points[points[:, 2].argmax()]
    for sign in (1, -1):
        foot = points[(points[:, 2] < low + 0.02 * height) & (sign * points[:, 0] > 0)]
        yield foot[np.abs(foot - foot.mean(axis=0)).sum(axis=1).argmin()]
    middle = points[(np.abs(points[:, 0]) < 0.004 * height) & (points[:, 2] > low + 0.4 * height)
                    & (points[:, 2] < low + 0.55 * height)]
    yield middle[middle[:, 2].argmin()]


def make(name, out, binary, noise, seed):
    who, pose = TWINS[name]
    person = people.PEOPLE[who]
    rng = np.random.default_rng(seed + sum(map(ord, name)))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([binary, "body", *arguments(person), *POSES[pose], "-o", folder], check=True, capture_output=True)
        points, faces = read_obj(f"{folder}/body.obj")
        twin = json.loads(pathlib.Path(folder, "body.json").read_text())
    points, faces = scanned(points, faces, noise, rng)
    with open(out / f"{name}.obj", "w") as file:
        file.writelines(f"v {x:.5f} {y:.5f} {z:.5f}\n" for x, y, z in points)
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in faces + 1)
    (out / f"{name}.json").write_text(json.dumps({k: twin[k] for k in ("measured", "landmarks", "joints")}, indent=1))
    return out / f"{name}.obj"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", required=True)
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--noise", type=float, default=NOISE)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    out = pathlib.Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    for name in TWINS:
        print(make(name, out, options.binary, options.noise, options.seed))


if __name__ == "__main__":
    main()
