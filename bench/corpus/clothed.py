#!/usr/bin/env python3
"""Scans of people in clothes, and whether the program refuses them.

usage: clothed.py --out DIR [--binary FILE]

People are dressed by the program; what a scanner sees of body and clothes is the border of all places that can be reached from
outside without coming nearer than 8 mm, moved back by 8 mm, on a grid of 5 mm. Each scan lies in DIR as NAME.obj. The last row is a bare
person made in the same way. Exit code 1 when clothes are taken for skin or skin for clothes. Needs numpy, scipy and VTK for Python.
"""
import argparse
import pathlib
import re
import subprocess
import sys

import numpy as np
import vtk
from scipy import ndimage
from scipy.spatial import cKDTree
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
GRID, PROBE = 0.005, 0.008  # metres
TROUSERS = '[[under]]\npattern = "trousers"\n'
PEOPLE = {  # body, garment, what is under it
    "shirt": ('sex = "female"', "long-sleeve-shirt", TROUSERS),
    "tee": ('sex = "male"\nheight = 1.80', "t-shirt", TROUSERS),
    "tee-stout": ('sex = "female"\nage = 40\nmeasurements = { chest = 1.1, waist = 0.95, hip = 1.12 }', "t-shirt", TROUSERS),
    "tank-leggings": ('sex = "female"', "tank-top", '[[under]]\npattern = "leggings"\n'),
    "hoodie": ('sex = "male"\nheight = 1.75', "hoodie", TROUSERS),
    "tee-only": ('sex = "female"', "t-shirt", ""),
    "trousers-only": ('sex = "male"', "trousers", ""),
}
SCENARIO = """[body]
{body}
posture = "a-pose"
[garment]
pattern = "{garment}"
{under}[simulation]
edge_length = 0.02
[donning]
movements = []
[output]
maps = ["distance"]
preset_sites = false
"""


def surface_points(path):
    """Points spread over a surface, one on every 4 mm²."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
    faces = vtk_to_numpy(reader.GetOutput().GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    a, b, c = (points[faces[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    face = np.repeat(np.arange(len(faces)), np.maximum(1, np.ceil(area / 4e-6).astype(int)))
    u, v = np.random.default_rng(1).random((2, len(face)))
    over = u + v > 1
    u[over], v[over] = 1 - u[over], 1 - v[over]
    return a[face] + u[:, None] * (b - a)[face] + v[:, None] * (c - a)[face]


def scan(surfaces, path):
    points = np.vstack([surface_points(s) for s in surfaces])
    low = points.min(0) - 10 * GRID
    shape = tuple(np.ceil((points.max(0) + 10 * GRID - low) / GRID).astype(int))
    grid = np.stack(np.meshgrid(*[np.arange(n) for n in shape], indexing="ij"), -1).reshape(-1, 3) * GRID + low
    distance = np.minimum(cKDTree(points).query(grid, distance_upper_bound=0.03)[0], 0.03).reshape(shape)
    regions, _ = ndimage.label(distance >= PROBE)
    reached = regions == regions[0, 0, 0]
    field = ndimage.distance_transform_edt(reached) - ndimage.distance_transform_edt(~reached)
    # Between grid points where the distance to the samples tells.
    told = (reached & (field < 2)) | (~reached & (distance < PROBE) & ndimage.binary_dilation(reached, iterations=2))
    field = np.where(told, (distance - PROBE) / GRID, field)
    image = vtk.vtkImageData()
    image.SetDimensions(*shape)
    image.SetSpacing(GRID, GRID, GRID)
    image.SetOrigin(*low)
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(order="F"), deep=True))
    border = vtk.vtkFlyingEdges3D()
    border.SetInputData(image)
    border.SetValue(0, 0.0)
    smooth = vtk.vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(border.GetOutputPort())
    smooth.SetNumberOfIterations(15)
    smooth.SetPassBand(0.1)
    smooth.NormalizeCoordinatesOn()
    largest = vtk.vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(smooth.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(largest.GetOutputPort())
    clean.Update()
    skin = vtk_to_numpy(clean.GetOutput().GetPoints().GetData()).astype(float)
    faces = vtk_to_numpy(clean.GetOutput().GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    face = np.cross(skin[faces[:, 1]] - skin[faces[:, 0]], skin[faces[:, 2]] - skin[faces[:, 0]])
    if (face * (skin[faces].mean(1) - skin.mean(0))).sum() < 0:
        faces, face = faces[:, ::-1], -face
    normal = np.zeros_like(skin)
    for k in range(3):
        np.add.at(normal, faces[:, k], face)
    skin -= PROBE * normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    with open(path, "w") as out:
        out.writelines("v %.5f %.5f %.5f\n" % tuple(p) for p in skin)
        out.writelines("f %d %d %d\n" % tuple(f) for f in faces + 1)


def judged(binary, path):
    ran = subprocess.run([binary, "body", "--file", str(path)], capture_output=True, text=True, check=False)
    said = ran.stdout + ran.stderr
    found = re.search(r"(\d+) % of neck, trunk, arms and legs lie more than 10 mm outside", said)
    clothes = ran.returncode == 2 and "clothes or hair" in said
    return clothes, f"{found[1]} %" if found else "", said.strip().splitlines()[-1] if ran.returncode and not clothes else ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    scans = []
    for name, (body, garment, under) in PEOPLE.items():
        run = options.out / name
        if not (run / "drape.vtp").exists():
            scenario = options.out / f"{name}.toml"
            scenario.write_text(SCENARIO.format(body=body, garment=garment, under=under))
            subprocess.run([options.binary, "run", scenario, "-o", run, "--quiet"], check=False)
        cloth = [run / "drape.vtp", *sorted(run.glob("under/*/drape.vtp"))]
        scans.append((name, True, [run / "body.vtp", *cloth]))
    scans.append(("bare", False, [options.out / "shirt" / "body.vtp"]))
    wrong = 0
    for name, clothed, surfaces in scans:
        path = options.out / f"{name}.obj"
        scan(surfaces, path)
        refused, share, why = judged(options.binary, path)
        wrong += refused != clothed
        print(f"{name:16}{'clothes' if refused else 'skin':10}{share:8}{why}", flush=True)
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
