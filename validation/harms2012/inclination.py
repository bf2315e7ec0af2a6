"""What the study measured: the sagittal inclination of a sensor on the back against that of the skin
under it, calibrated upright, while the wearer bends forward.

A sensor has three axes, as of an accelerometer that is sewn flat on the cloth: n along the cloth's
normal, a along the grain (up in an upright wearer), s = a × n. Its sagittal inclination is
atan2(n_z, a_z), what its two axes in the sagittal plane make of gravity: 0 upright, θ when the back
leans forward by θ. The skin has such axes too: those of the material partner, the skin nearest to
the cloth upright, a upwards; both are carried along with the skin when the wearer bends
(docs/theory/sensor_metrics.md 1 and 3.1). The error is the difference of the two inclinations less
the same difference upright.
"""

import numpy

from back_panel import unit
from cases import BENDS
from drape_file import DrapeFile

FOOTPRINT = 0.012  # [m]
NEAREST = 4  # vertices of the skin whose triangles are looked at for the nearest point


class SkinPartners:
    """The skin under vertices of the cloth, on the upright body, and its axes on any posture."""

    def __init__(self, body, points, normals):
        triangles = body.triangles
        facing = body["Normals"]
        order = numpy.argsort(triangles.ravel(), kind="stable")
        starts = numpy.searchsorted(triangles.ravel()[order], numpy.arange(len(body.points) + 1))
        low, high = points.min(axis=0) - 0.1, points.max(axis=0) + 0.1
        near = numpy.flatnonzero(((body.points > low) & (body.points < high)).all(axis=1))
        self.corners = numpy.empty((len(points), 3), dtype=int)
        self.shares = numpy.empty((len(points), 3))
        for k, (p, n) in enumerate(zip(points, normals)):
            own = near[facing[near] @ n > 0]  # the back, not the breast behind it
            distance = ((body.points[own] - p) ** 2).sum(axis=1)
            around = own[numpy.argsort(distance)[:NEAREST]]
            candidates = numpy.unique(numpy.concatenate(
                [order[starts[v]:starts[v + 1]] for v in around]) // 3)
            corner = body.points[triangles[candidates]]
            share = nearest_on_triangles(p, corner)
            gap = (((share[:, :, None] * corner).sum(axis=1) - p) ** 2).sum(axis=1)
            best = gap.argmin()
            self.corners[k], self.shares[k] = triangles[candidates[best]], share[best]
        # Upwards along the skin, as a combination of two edges, which move with it.
        normal = self._normals(body)
        up = unit(numpy.array([0.0, 0, 1]) - normal[:, 2:] * normal)
        edges = self._edges(body)
        self.up = numpy.stack([numpy.linalg.lstsq(e.T, u, rcond=None)[0]
                               for e, u in zip(edges, up)])

    def _edges(self, body):
        corner = body.points[self.corners]
        return numpy.stack([corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]], axis=1)

    def _normals(self, body):
        return unit((body["Normals"][self.corners] * self.shares[:, :, None]).sum(axis=1))

    def axes(self, body):
        """Normals and upward directions per vertex of the cloth."""
        normal = self._normals(body)
        up = (self._edges(body) * self.up[:, :, None]).sum(axis=1)
        return normal, unit(up - (up * normal).sum(axis=1)[:, None] * normal)


def nearest_on_triangles(p, corner):
    """Shares of the corners (n, 3) of the point of each triangle (n, 3, 3) that is nearest to p."""
    a, ab, ac = corner[:, 0], corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    dot = lambda x, y: (x * y).sum(axis=1)
    ap = p - a
    gram = dot(ab, ab) * dot(ac, ac) - dot(ab, ac) ** 2
    v = (dot(ac, ac) * dot(ap, ab) - dot(ab, ac) * dot(ap, ac)) / gram
    w = (dot(ab, ab) * dot(ap, ac) - dot(ab, ac) * dot(ap, ab)) / gram
    best = numpy.stack([1 - v - w, v, w], axis=1)
    outside = best.min(axis=1) < 0
    distance = numpy.full(len(corner), numpy.inf)
    for i, j in ((0, 1), (1, 2), (2, 0)):  # the nearest point of the border
        edge = corner[:, j] - corner[:, i]
        t = numpy.clip(dot(p - corner[:, i], edge) / dot(edge, edge), 0, 1)
        off = ((corner[:, i] + t[:, None] * edge - p) ** 2).sum(axis=1)
        better = outside & (off < distance)
        distance[better] = off[better]
        share = numpy.zeros((len(corner), 3))
        share[:, i], share[:, j] = 1 - t, t
        best[better] = share[better]
    return best


def frames(weights, normals, ups):
    """Axes [s a n] as columns (k, 3, 3) of flat sensors, each on the mean of its footprint."""
    n = unit(weights @ normals)
    a = weights @ ups
    a = unit(a - (a * n).sum(axis=1)[:, None] * n)
    return numpy.stack([numpy.cross(a, n), a, n], axis=2)


def inclination(axes):
    """Sagittal inclination by the two axes in the sagittal plane [deg]."""
    return numpy.degrees(numpy.arctan2(axes[:, 2, 2], axes[:, 2, 1]))


def inclination_of_normal(axes):
    """The same by the normal alone [deg]."""
    return numpy.degrees(numpy.arcsin(numpy.clip(axes[:, 2, 2], -1, 1)))


def rotation_angle(r):
    sine = numpy.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]])
    return numpy.degrees(numpy.arctan2(numpy.linalg.norm(sine, axis=0),
                                       numpy.trace(r, axis1=1, axis2=2) - 1))


def donning_files(folder, donning):
    """Drapes of one donning by posture, the upright one under ""; some may be missing."""
    if donning == 1:
        files = {"": folder / "drape.vtp"}
        files.update({p: folder / "postures" / p / "drape.vtp" for p in BENDS})
    else:
        inside = folder / "donnings" / str(donning)
        upright = inside / "standing"
        files = {"": (upright if upright.exists() else inside / "reference") / "drape.vtp"}
        files.update({p: inside / p / "drape.vtp" for p in BENDS})
    return files


def bodies(folder):
    """The wearer upright ("") and bent."""
    found = {"": DrapeFile(folder / "body.vtp")}
    for posture in BENDS:
        file = folder / "postures" / posture / "body.vtp"
        if file.exists():
            found[posture] = DrapeFile(file)
    return found


def of_donning(folder, donning, postures, weights, panel, wearer):
    """Errors of all places of one donning: arrays, a row a place and a column a posture.

    error: by two axes; normal: by the normal alone; coe: angle of the whole calibrated rotation;
    skin: how much the skin's inclination has changed, to which the error adds; and of the upright
    drape, one column: deviation, the mean angular deviation of the footprint; upright, the difference
    of the two inclinations that calibrating takes out.
    """
    files = donning_files(folder, donning)
    upright = DrapeFile(files[""])
    cloth = lambda drape: frames(weights, drape["Normals"][panel.used], panel.warp(drape.points))
    near = numpy.flatnonzero(weights.any(axis=0))  # vertices under the places
    skin = SkinPartners(wearer[""], upright.points[panel.used[near]],
                        upright["Normals"][panel.used[near]])
    under = lambda posture: frames(weights[:, near], *skin.axes(wearer[posture]))
    g0, b0 = cloth(upright), under("")
    calibrated = numpy.swapaxes(b0, 1, 2) @ g0
    found = {key: [] for key in ("error", "normal", "coe", "skin")}
    for posture in postures:
        g, b = cloth(DrapeFile(files[posture])), under(posture)
        for key, angle in (("error", inclination), ("normal", inclination_of_normal)):
            found[key].append((angle(g) - angle(b)) - (angle(g0) - angle(b0)))
        found["skin"].append(inclination(b) - inclination(b0))
        found["coe"].append(rotation_angle((numpy.swapaxes(b, 1, 2) @ g)
                                           @ numpy.swapaxes(calibrated, 1, 2)))
    result = {key: numpy.stack(value, axis=1) for key, value in found.items()}
    result["upright"] = inclination(g0) - inclination(b0)
    result["deviation"] = weights @ upright["angular_deviation_deg"][panel.used]
    return result
