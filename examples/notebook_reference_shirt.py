# %% [markdown]
# # The reference shirt: three maps, front and back
#
# The figure of Harms, Amft and Troester (2012): strain, distance from the body and angular deviation
# of a shirt, from the front and from the back. Open this file as a notebook (Jupyter with Jupytext,
# VS Code, Spyder), or run it:
#
#     PYTHONPATH=build/python python3 examples/notebook_reference_shirt.py --output figure.png

# %%
import argparse
import pathlib
import tomllib

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import loosefit

HERE = pathlib.Path(__file__).parent if "__file__" in globals() else pathlib.Path("examples")
MAPS = ("strain_vertical", "distance_mm", "angular_deviation_deg")
MANNEQUIN = np.array([0.80, 0.80, 0.80])


# %% [markdown]
# ## Run
#
# A scenario is a dict with the keys of the file, so a notebook changes what it likes.

# %%
def reference_shirt(edge_length):
    scenario = tomllib.loads((HERE / "reference-shirt.toml").read_text())
    scenario["simulation"]["edge_length"] = edge_length
    return scenario


shown = []


def show_progress(stage, fraction):
    text = f"\r{stage:12} {fraction:4.0%}"
    if [text] != shown:  # only news
        shown[:] = [text]
        print(text, end="", flush=True)


# %% [markdown]
# ## Draw
#
# Parallel projection along y. Triangles are painted from the farthest to the nearest; the skin lies
# a little behind where it is, for cloth of flat triangles cuts through it in places. Colours are
# those of the values alone, no light falls on the cloth; its seams, hems and outlines are drawn as
# lines where they can be seen.

# %%
def projected(points, back):
    """(n, 2) picture plane and (n,) distance from the viewer, m; from the front x runs to the right."""
    side = -1 if back else 1
    return np.column_stack([side * points[:, 0], points[:, 2]]), side * points[:, 1]


def shaded_skin(body, triangles, back):
    """Grey of each triangle of the mannequin: lighter where it faces the viewer."""
    towards = -body.normals[:, 1] * (-1 if back else 1)
    facing = np.clip(towards[triangles].mean(axis=1), 0, 1)
    return np.outer(0.62 + 0.38 * facing, MANNEQUIN)


def lines_of(garment, flat):
    """Vertex pairs: hems, seams, and outlines where the surface turns away from the viewer."""
    triangles = garment.triangles
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, owner = edges[order], owner[order]
    a, b, c = flat[triangles[:, 0]], flat[triangles[:, 1]], flat[triangles[:, 2]]
    facing = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] > 0
    same = (edges[1:] == edges[:-1]).all(axis=1)
    twin = np.flatnonzero(same)  # edges of two triangles: one is followed by the other
    single = np.setdiff1d(np.arange(len(edges)), np.concatenate([twin, twin + 1]))
    panels = garment.triangle_panel_id
    first, second = owner[twin], owner[twin + 1]
    seam = twin[(panels[first] != panels[second]) & (facing[first] | facing[second])]
    outline = twin[facing[first] != facing[second]]
    return np.concatenate([edges[single], edges[seam], edges[outline]])


def nearest_depth(surfaces, cell=0.004):
    """A function of places in the picture: depth of what is seen there, from samples of triangles."""
    steps = np.linspace(0, 1, 6)
    weights = np.array([(u, v, 1 - u - v) for u in steps for v in steps if u + v <= 1 + 1e-9])
    samples = np.concatenate([
        np.einsum("kc,mcd->mkd", weights, np.column_stack([flat, depth])[triangles]).reshape(-1, 3)
        for flat, depth, triangles in surfaces])
    low = samples[:, :2].min(axis=0)

    def cells(flat):
        return tuple(((flat - low) / cell).round().astype(int).T)

    seen = np.full(np.add(tuple(map(max, cells(samples[:, :2]))), 1), np.inf)
    np.minimum.at(seen, cells(samples[:, :2]), samples[:, 2])
    return lambda flat: seen[cells(flat)]


def form_triangles(result):
    """Those of the body that serve as a form for the shirt: up to the neck, and within the hem."""
    middle = result.body.vertices[result.body.triangles].mean(axis=1)
    cloth = result.vertices
    low, high = cloth[:, 2].min(), cloth[:, 2].max()
    hips = np.abs(cloth[cloth[:, 2] < low + 0.02, 0]).max()
    legs = (middle[:, 2] < low + 0.02) & (np.abs(middle[:, 0]) < hips)
    return result.body.triangles[(middle[:, 2] < high + 0.02) & ~legs]


def draw(axes, result, quantity, back, colours):
    """The form in grey and the garment in the colours of one map."""
    skin, skin_depth = projected(result.body.vertices, back)
    form = form_triangles(result)
    cloth, cloth_depth = projected(result.vertices, back)
    values = quantity.values[result.triangles].mean(axis=1)  # NaN: not defined, stays grey
    polygons = [skin[form], cloth[result.triangles]]
    depths = [skin_depth[form].mean(axis=1) + 0.012,
              cloth_depth[result.triangles].mean(axis=1)]
    faces = [np.column_stack([shaded_skin(result.body, form, back), np.ones(len(polygons[0]))]),
             colours.to_rgba(values)]
    order = np.argsort(-np.concatenate(depths), kind="stable")
    faces = np.concatenate(faces)[order]
    axes.add_collection(PolyCollection(np.concatenate(polygons)[order], facecolors=faces,
                                       edgecolors=faces, linewidths=0.3, rasterized=True))
    lines = lines_of(result.garment, cloth)
    seen = nearest_depth([(skin, skin_depth + 0.012, form),
                          (cloth, cloth_depth, result.triangles)])
    ends = cloth[lines]
    visible = cloth_depth[lines].mean(axis=1) < seen(ends.mean(axis=1)) + 0.030
    axes.add_collection(LineCollection(ends[visible], colors="0.15", linewidths=0.5, alpha=0.6))
    low, high = result.vertices[:, 2].min(), result.vertices[:, 2].max()
    axes.set(xlim=(-0.50, 0.50), ylim=(low - 0.11, high + 0.06), aspect="equal")
    axes.set_axis_off()


# %%
def figure(result):
    """Three maps from the front (above) and from the back, one legend each."""
    height = 0.37 + np.ptp(result.vertices[:, 2])
    picture, grid = plt.subplots(2, len(MAPS), figsize=(9.6, 2 * 3.0 * height + 0.9),
                                 layout="constrained")
    for column, name in enumerate(MAPS):
        quantity = result.maps[name]
        table = matplotlib.colormaps["RdBu_r" if quantity.diverging else "viridis"].copy()
        table.set_bad("#e8e8e8")
        colours = plt.cm.ScalarMappable(matplotlib.colors.Normalize(*quantity.range), table)
        for row, back in enumerate((False, True)):
            draw(grid[row, column], result, quantity, back, colours)
        unit = "" if quantity.unit == "1" else f" [{quantity.unit}]"
        grid[0, column].set_title(quantity.title, fontsize=11)
        picture.colorbar(colours, ax=grid[:, column], location="bottom", shrink=0.85, pad=0.01,
                         extend="both" if quantity.diverging else "max", label=f"{name}{unit}")
    grid[0, 0].text(0, 0.5, "front", transform=grid[0, 0].transAxes, rotation=90, va="center")
    grid[1, 0].text(0, 0.5, "back", transform=grid[1, 0].transAxes, rotation=90, va="center")
    return picture


# %% [markdown]
# ## Numbers
#
# `pandas.DataFrame(result.sites)` is a table of what a sensor would meet at each place.

# %%
def table_of_sites(result):
    for site in result.sites:
        if site["panel"] and site["angular_deviation_deg"] is not None:  # a girth has no one turn
            print(f"{site['name']:16} {site['region']:14} gap {site['distance_mm']:6.1f} mm, "
                  f"{site['angular_deviation_deg']:5.1f} deg off the body")


# %%
def main():
    arguments = argparse.ArgumentParser(description="three maps of the reference shirt")
    arguments.add_argument("--output", default="reference-shirt.png", help="picture to write")
    arguments.add_argument("--edge-length", type=float, default=0.010, help="of the mesh, m")
    options, _ = arguments.parse_known_args()
    result = loosefit.run(reference_shirt(options.edge_length), progress=show_progress)
    print("\rsettled and worn    " if result.certificate.holds else f"\r{result!r}")
    table_of_sites(result)
    figure(result).savefig(options.output, dpi=150)
    print("written:", options.output)


if __name__ == "__main__":
    main()
