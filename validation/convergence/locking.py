#!/usr/bin/env python3
"""How much of the strain on the default mesh is the mesh's own (locking).

Flat triangles cannot bend. Laid along the shape that the cloth takes on a finer mesh their edges are
chords of its folds, so that they are shorter than the cloth they stand for: cloth which is as stiff
in compression as in tension cannot take that shape and shears and stretches elsewhere instead. This
measures, place by place on the pattern, the strain of the vertices of the coarse mesh (the mean over
their triangles, what the energy of decision 12 sees) at its own rest and laid along the fine shape,
beside that of the fine mesh at its rest. And it drapes cloth of four times the stiffness in the plane: a
strain that bears load falls to a quarter, one that the mesh asks for stays. Reads drapes that run.py has
made; writes the tables "locking" and "stiff" of docs/accuracy.md.

    python3 validation/convergence/locking.py out/convergence
"""

import argparse
import json
import pathlib
import re
import subprocess

import numpy as np
import vtk
from run import scenario_text
from vtk.util.numpy_support import vtk_to_numpy

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = REPOSITORY / "docs" / "accuracy.md"
COARSE, FINE = 10, 5        # edge lengths [mm]
STIFFER = 4
LEAST = 2e-4                # strains of less have no share that means anything
STIFFNESS = ["stiffness_warp", "stiffness_weft", "stiffness_shear"]
KEPT = {"strain_max": ("principal strain, mean", "area_mean"),
        "strain_weft": ("weft, 95th percentile", "p95")}
SIDE = 0.7                  # of half a panel's width: beyond it is the side
APART = 10.0                # of panels from each other, for one search in all of them [m]


class Drape:
    """A drape: corners of its triangles on the pattern and in space [m], and panels."""

    def __init__(self, folder):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(folder / "drape.vtp"))
        reader.Update()
        mesh = reader.GetOutput()
        cells = mesh.GetCellData()
        names = mesh.GetFieldData().GetAbstractArray("panel_names")
        self.names = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
        self.x = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        self.triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.panel = vtk_to_numpy(cells.GetArray("panel_id")).astype(int)
        self.uv = vtk_to_numpy(cells.GetArray("corner_uv")).reshape(-1, 3, 2).astype(float)
        self.corners = self.x[self.triangles]

    def flat(self):
        """The pattern as a surface in space, panels apart, three points to each triangle."""
        height = np.repeat(APART * self.panel[:, None, None], 3, axis=1)
        points = np.concatenate([self.uv, height], axis=2).reshape(-1, 3)
        surface, places, polygons = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
        places.SetDataTypeToDouble()
        for p in points:
            places.InsertNextPoint(p)
        for t in range(len(self.uv)):
            polygons.InsertNextCell(3, (3 * t, 3 * t + 1, 3 * t + 2))
        surface.SetPoints(places)
        surface.SetPolys(polygons)
        return surface

    def strains(self, corners):
        """Warp and weft elongation and shear angle [rad] of each vertex of each panel: the mean of
        the deformation over its triangles. With the place on the pattern, the panel and the area."""
        edges = np.stack([self.uv[:, 1] - self.uv[:, 0], self.uv[:, 2] - self.uv[:, 0]], axis=2)
        moved = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
        deformed = moved @ np.linalg.inv(edges)                     # 3 x 2: along weft u, warp v
        area = 0.5 * np.abs(np.linalg.det(edges))
        length = np.linalg.norm(deformed, axis=1)
        sine = np.einsum("ti,ti->t", deformed[:, :, 0], deformed[:, :, 1]) / length.prod(axis=1)
        of_triangle = np.stack([length[:, 1] - 1, length[:, 0] - 1, np.arcsin(sine)], axis=1)
        keys = self.panel.repeat(3) * len(self.x) + self.triangles.reshape(-1)
        _, vertex = np.unique(keys, return_inverse=True)
        weight = np.bincount(vertex, area.repeat(3) / 3)
        mean = lambda values: np.bincount(vertex, (area / 3).repeat(3) * values) / weight
        strains = np.stack([mean(of_triangle[:, k].repeat(3)) for k in range(3)], axis=1)
        place = np.stack([mean(self.uv.reshape(-1, 2)[:, k]) for k in range(2)], axis=1)
        return strains, place, mean(self.panel.repeat(3)).round().astype(int), weight


def laid_along(coarse, fine):
    """Corners of the coarse triangles where the same places of the cloth are on the fine mesh."""
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet(fine.flat())
    locator.BuildLocator()
    corners = np.empty_like(coarse.corners)
    cell, sub, near, off = vtk.vtkGenericCell(), vtk.reference(0), [0.0] * 3, vtk.reference(0.0)
    found = vtk.reference(0)
    panel = [fine.names.index(coarse.names[p]) for p in coarse.panel]
    for t, uv in enumerate(coarse.uv):
        for k in range(3):
            locator.FindClosestPoint([*uv[k], APART * panel[t]], near, cell, found, sub, off)
            f = int(found)
            a, b, c = fine.uv[f]
            share = np.linalg.solve(np.stack([b - a, c - a], axis=1), np.array(near[:2]) - a)
            corners[t, k] = np.array([1 - share.sum(), *share]) @ fine.corners[f]
    return corners


def places(drape, place, panel):
    """Places of the pattern by name: masks over vertices."""
    found = {}
    for name in ("front", "back"):
        here = panel == drape.names.index(name)
        u, v = place[:, 0], place[:, 1]
        half, middle = np.ptp(u[here]) / 2, (u[here].min() + u[here].max()) / 2
        at_side = np.abs(u - middle) > SIDE * half
        # The side seam reaches up to the underarm: the highest place as far out as the hem.
        underarm = v[here & (np.abs(u - middle) > 0.9 * half)].max()
        found[f"{name}, above the underarms"] = here & (v > underarm)
        found[f"{name}, sides"] = here & (v <= underarm) & at_side
        found[f"{name}, middle"] = here & (v <= underarm) & ~at_side
    sleeve = np.isin(panel, [i for i, n in enumerate(drape.names) if n.startswith("sleeve")])
    v = place[:, 1]
    cuts = np.median(v[sleeve])
    found["sleeves, upper half"] = sleeve & (v > cuts)
    found["sleeves, lower half"] = sleeve & (v <= cuts)
    return found


def figures(drape, corners):
    """Per place: 5th and 95th percentiles of warp and weft, 95th of the shear angle's size."""
    strains, place, panel, area = drape.strains(corners)

    def at(values, weights, share):
        order = np.argsort(values)
        total = np.cumsum(weights[order])
        return values[order][np.searchsorted(total, share * total[-1])]

    rows = {}
    for name, here in places(drape, place, panel).items():
        warp, weft = strains[here, 0], strains[here, 1]
        shear = np.degrees(np.abs(strains[here, 2]))
        w = area[here]
        rows[name] = [100 * at(warp, w, 0.05), 100 * at(warp, w, 0.95), 100 * at(weft, w, 0.05),
                      100 * at(weft, w, 0.95), at(shear, w, 0.95)]
    return rows


def stiff(binary, folder, seed):
    """The summary of the coarse drape of this start in stiffer cloth, which is made if it is not there."""
    target = folder / f"stiff-{COARSE}mm-{seed}"
    if not (target / "summary.json").exists():
        text = scenario_text(COARSE, seed)
        named = re.search(r'\[material\]\nname = "(.*)"\n', text)
        if not named:
            raise SystemExit("error: examples/reference-shirt.toml: found no name of a material")
        card = subprocess.run([binary, "material", "show", named[1]], check=True, capture_output=True, text=True)
        for key in STIFFNESS:
            value = float(re.search(rf"^{key} = (.*)$", card.stdout, re.M)[1])
            text = text.replace(named[0], f"{named[0]}{key} = {STIFFER * value:g}\n")
        target.with_suffix(".toml").write_text(text)
        subprocess.run([binary, "run", str(target.with_suffix(".toml")), "-o", str(target), "--no-pictures",
                        "-q"], check=True)
    return json.loads((target / "summary.json").read_text())


def shares_kept(binary, folder, drapes):
    """Rows: what the strain of a region keeps of itself in stiffer cloth [%], mean over the drapes."""
    rows = {}
    for drape in drapes:
        seed = drape.name.rpartition("-")[2]
        soft, hard = json.loads((drape / "summary.json").read_text()), stiff(binary, folder, seed)
        for region in soft["maps"]["strain_max"]["regions"]:
            value = lambda s, array, of: s["maps"][array]["regions"][region][of]
            share = lambda a, of: 100 * value(hard, a, of) / value(soft, a, of)
            rows.setdefault(region, []).append([share(a, of) if value(soft, a, of) > LEAST else np.nan
                                                for a, (_, of) in KEPT.items()])
    return {region: np.mean(found, axis=0) for region, found in rows.items()}


def write_between(page, name, text):
    """The text between the markers of this name, where the page has them."""
    written, count = re.subn(rf"(<!-- {name}: begin -->\n).*?(<!-- {name}: end -->)",
                             lambda m: m[1] + text + "\n" + m[2], page.read_text(), flags=re.S)
    if count == 1:
        page.write_text(written)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="what run.py wrote")
    parser.add_argument("--binary", default=str(REPOSITORY / "build" / "bin" / "loosefit"))
    parser.add_argument("--page", type=pathlib.Path, default=PAGE)
    arguments = parser.parse_args()
    coarse = sorted(arguments.folder.glob(f"{COARSE}mm-*/drape.vtp"))
    fine = sorted(arguments.folder.glob(f"{FINE}mm-*/drape.vtp"))
    pairs = list(zip(coarse, fine))
    if not pairs:
        raise SystemExit(f"error: {arguments.folder}: no drapes of {COARSE} and {FINE} mm")
    samples = {}
    for a, b in pairs:
        here, there = Drape(a.parent), Drape(b.parent)
        for state, rows in (("own", figures(here, here.corners)),
                            ("laid", figures(here, laid_along(here, there))),
                            ("fine", figures(there, there.corners))):
            for name, row in rows.items():
                samples.setdefault(name, {}).setdefault(state, []).append(row)
    titles = {"own": f"{COARSE} mm, at rest", "laid": f"{COARSE} mm, laid along it",
              "fine": f"{FINE} mm, at rest"}
    table = ["| place on the pattern | mesh | warp, 5th and 95th percentile (%) | weft (%) | shear, 95th (°) |",
             "|---|---|---|---|---|"]
    for name, states in samples.items():
        for state in ("fine", "laid", "own"):
            m = np.mean(states[state], axis=0)
            table.append(f"| {name if state == 'fine' else ''} | {titles[state]} | {m[0]:.2f}, {m[1]:.2f} | "
                         f"{m[2]:.2f}, {m[3]:.2f} | {m[4]:.2f} |")
    of = "One pair of drapes." if len(pairs) == 1 else f"Means of {len(pairs)} pairs of drapes."
    text = of + "\n\n" + "\n".join(table)
    kept = shares_kept(arguments.binary, arguments.folder, [a.parent for a, _ in pairs])
    second = ["| of itself in cloth of four times the stiffness | " + " | ".join(t for t, _ in KEPT.values()) + " |",
              "|---" * (1 + len(KEPT)) + "|"]
    second += [f"| {region.replace('_', ' ')} | " + " | ".join("–" if np.isnan(share) else f"{share:.0f} %" for share in shares) + " |"
               for region, shares in kept.items()]
    print(text, *second, sep="\n")
    write_between(arguments.page, "locking", text)
    write_between(arguments.page, "stiff", "\n".join(second))


if __name__ == "__main__":
    main()
