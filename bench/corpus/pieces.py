"""Flat pieces in the grammar of GarmentCode specification files: centimetres, y up, facing +z, the wearer's left at +x.

A piece is a closed loop of corners, each with the name of the edge to the next corner and its curve in coordinates relative to that
edge. Counter-clockwise loops have their outside towards +z, clockwise ones towards -z.
"""
import json
import math


class Arc:
    """A circular arc of less than half a circle; `rise` is its height over the chord, positive to the left of the edge."""

    def __init__(self, rise):
        self.rise = rise

    def radius(self, chord):
        return chord * (self.rise ** 2 + .25) / (2 * abs(self.rise))

    def spec(self, chord):
        return {"type": "circle", "params": [self.radius(chord), 0, int(self.rise < 0)]}


def relative(a, b, *points):
    """Control points given as places, in coordinates relative to the edge from a to b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    return [(((x - a[0]) * dx + (y - a[1]) * dy) / square, ((y - a[1]) * dx - (x - a[0]) * dy) / square) for x, y in points]


def reversed_curve(curve, mirrored):
    """That of the edge walked the other way, and seen in a mirror."""
    sign = 1 if mirrored else -1
    if isinstance(curve, Arc):
        return Arc(sign * curve.rise)
    return [(1 - u, sign * v) for u, v in reversed(curve)] if curve else None


def bezier_length(a, b, curve, chords=60):
    """Length of an edge from a to b with relative control points (none: straight), or of the arc of an Arc."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    if isinstance(curve, Arc):
        radius = curve.radius(math.hypot(dx, dy))
        return 2 * radius * math.asin(min(1.0, math.hypot(dx, dy) / (2 * radius)))
    points = [a] + [(a[0] + u * dx - v * dy, a[1] + u * dy + v * dx) for u, v in curve or []] + [b]
    total, last = 0.0, a
    for i in range(1, chords + 1):
        t, level = i / chords, points
        while len(level) > 1:
            level = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]) for p, q in zip(level, level[1:])]
        total += math.dist(last, level[0])
        last = level[0]
    return total


class Piece:
    def __init__(self, name, corners, label="", translation=(0, 0, 0), rotation=(0, 0, 0)):
        """corners: (x, y, edge to the next corner[, control points of that edge])."""
        self.name, self.label = name, label
        self.corners = [(c[0], c[1], c[2], (c[3] if isinstance(c[3], Arc) else list(c[3])) if len(c) > 3 and c[3] else None) for c in corners]
        self.translation, self.rotation = translation, rotation
        self.edge_labels = {}

    def turned(self, name, translation=None):
        """The same outline seen from behind: a back piece of the same cut."""
        n, corners = len(self.corners), []
        for i in range(n, 0, -1):
            x, y = self.corners[i % n][:2]
            _, _, edge, curve = self.corners[i - 1]
            corners.append((x, y, edge, reversed_curve(curve, False)))
        return Piece(name, corners, self.label, translation or self.translation, self.rotation)

    def mirrored(self, name):
        """The other side's piece: mirrored at x = 0, turning round as before."""
        n, corners = len(self.corners), []
        for i in range(n, 0, -1):
            x, y = self.corners[i % n][:2]
            _, _, edge, curve = self.corners[i - 1]
            corners.append((-x, y, edge, reversed_curve(curve, True)))
        x, y, z = self.translation
        a, b, c = self.rotation
        piece = Piece(name, corners, self.label, (-x, y, z), (a, -b, -c))
        piece.edge_labels = dict(self.edge_labels)
        return piece

    def length(self, edge):
        n = len(self.corners)
        for i, (x, y, name, curve) in enumerate(self.corners):
            if name == edge:
                return bezier_length((x, y), self.corners[(i + 1) % n][:2], curve)
        raise KeyError(f"{self.name}.{edge}")

    def index(self, edge):
        return [c[2] for c in self.corners].index(edge)

    def spec(self):
        edges = []
        n = len(self.corners)
        for i, (x, y, name, curve) in enumerate(self.corners):
            edge = {"endpoints": [i, (i + 1) % n]}
            if isinstance(curve, Arc):
                edge["curvature"] = curve.spec(math.dist((x, y), self.corners[(i + 1) % n][:2]))
            elif curve:
                edge["curvature"] = {"type": "quadratic" if len(curve) == 1 else "cubic",
                                     "params": [list(p) for p in curve]}
            if name in self.edge_labels:
                edge["label"] = self.edge_labels[name]
            edges.append(edge)
        return {"vertices": [[x, y] for x, y, _, _ in self.corners], "edges": edges,
                "translation": list(self.translation), "rotation": list(self.rotation), "label": self.label}


class Pattern:
    def __init__(self):
        self.pieces, self.seams = {}, []

    def add(self, *pieces):
        for piece in pieces:
            self.pieces[piece.name] = piece
        return pieces[0] if len(pieces) == 1 else pieces

    def sew(self, a, edge_a, b, edge_b, wrong=False):
        """wrong: the right side of one lies on the wrong side of the other, as of a collar that is turned over."""
        self.seams.append(((a, edge_a), (b, edge_b), wrong))

    def text(self):
        sides = [[{"panel": p, "edge": self.pieces[p].index(e)} for p, e in seam[:2]] + ["right_wrong"] * seam[2]
                 for seam in self.seams]
        return json.dumps({
            "pattern": {"panels": {n: p.spec() for n, p in self.pieces.items()}, "stitches": sides,
                        "panel_order": list(self.pieces)},
            "properties": {"curvature_coords": "relative", "normalize_panel_translation": False,
                           "normalized_edge_loops": True, "units_in_meter": 100}})
