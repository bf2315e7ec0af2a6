"""Means over small discs of the flat back panel, where the sensors are sewn."""

import math

import numpy


class BackPanel:
    """Linear interpolation on the flat back panel, the same for all drapes of a case."""

    def __init__(self, drape):
        uv, triangles = drape.panel("back")
        used, index = numpy.unique(triangles, return_inverse=True)
        self.used, self.triangles = used, index.reshape(-1, 3)
        self.uv = uv[used]

    def weights(self, points):
        """Rows of weights of the panel's vertices for points (n, 2); zero outside the panel."""
        points = numpy.asarray(points, dtype=float)[:, None]
        a, b, c = (self.uv[self.triangles[:, k]][None] for k in range(3))
        cross = lambda p, q: p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0]
        whole = cross(b - a, c - a)
        second, third = cross(points - a, c - a) / whole, cross(b - a, points - a) / whole
        share = numpy.stack([1 - second - third, second, third], axis=2)
        least = share.min(axis=2)
        found = least.argmax(axis=1)
        rows = numpy.arange(len(found))
        inside = least[rows, found] >= -1e-9
        matrix = numpy.zeros((len(found), len(self.used)))
        for k in range(3):
            matrix[rows, self.triangles[found, k]] += share[rows, found, k] * inside
        return matrix

    def disc_weights(self, centres, radius):
        """Row-wise means over discs round the centres (n, 2), from 61 points of equal area each."""
        rings = [(0.0, 1)] + [((k + 0.5) / 5, 6 * (k + 1)) for k in range(4)]
        disc = numpy.array([(radius * r * math.cos(2 * math.pi * i / n),
                             radius * r * math.sin(2 * math.pi * i / n))
                            for r, n in rings for i in range(n)])
        points = (numpy.asarray(centres)[:, None] + disc[None]).reshape(-1, 2)
        matrix = self.weights(points).reshape(len(centres), len(disc), -1).sum(axis=1)
        return matrix / matrix.sum(axis=1, keepdims=True)

    def warp(self, points):
        """Where the grain points at every vertex of the panel (k, 3), from its own triangles."""
        uv, x = self.uv[self.triangles], points[self.used][self.triangles]
        d1, d2 = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
        twice_area = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
        # |area| times the image of v under the linear map of the triangle
        image = (d1[:, :1] * (x[:, 2] - x[:, 0]) - d2[:, :1] * (x[:, 1] - x[:, 0])) \
            * numpy.sign(twice_area)[:, None]
        total = numpy.zeros((len(self.used), 3))
        for k in range(3):
            numpy.add.at(total, self.triangles[:, k], image)
        return unit(total)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)
