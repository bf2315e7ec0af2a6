"""Patterns as CAD programs store them: DXF-AAMA with half pieces and mirror lines, inches, notches, grain lines, quantities and texts.

No file says what is sewn to what: known garments are sewn by what their pieces are, the others have a side file. Their cut is that
of drawn.py and garments.py.
"""
import math

import garments
from pieces import bezier_length, relative

INCH = 2.54  # centimetres
LAYERS = {"boundary": 1, "turn": 2, "curve": 3, "notch": 4, "mirror": 6, "grain": 7, "sew": 14}


def along(a, b, curve=None, steps=24):
    """Points of an edge from a to b with relative control points, without its end."""
    if not curve:
        return [a]
    dx, dy = b[0] - a[0], b[1] - a[1]
    points = [a] + [(a[0] + u * dx - v * dy, a[1] + u * dy + v * dx) for u, v in curve] + [b]
    found = []
    for i in range(steps):
        t, level = i / steps, points
        while len(level) > 1:
            level = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]) for p, q in zip(level, level[1:])]
        found.append(level[0])
    return found


class File:
    """One style in one size; lengths are given in centimetres and written in inches or millimetres."""

    def __init__(self, style, inches=True, sideways=False, open_lines=False):
        self.scale = 1 / INCH if inches else 10
        self.units = "ENGLISH" if inches else "METRIC"
        self.style, self.sideways, self.open_lines = style, sideways, open_lines
        self.lines = []
        self._put(0, "SECTION", 2, "HEADER", 0, "ENDSEC", 0, "SECTION", 2, "BLOCKS")

    def _put(self, *pairs):
        self.lines += [f"{code:>3}\n{value}" for code, value in zip(pairs[::2], pairs[1::2])]

    def _at(self, p, code=10):
        x, y = (p[1], -p[0]) if self.sideways else p
        self._put(code, f"{x * self.scale:.5f}", code + 10, f"{y * self.scale:.5f}")

    def _note(self, words):
        self._put(0, "TEXT", 8, "1")
        self._at((1, 1))
        self._put(40, "0.25", 1, words)

    def _polyline(self, points, layer, closed):
        self._put(0, "POLYLINE", 8, layer, 66, 1, 70, int(closed))
        for p in points:
            self._put(0, "VERTEX", 8, layer)
            self._at(p)
        self._put(0, "SEQEND", 8, layer)

    def _line(self, layer, a, b):
        self._put(0, "LINE", 8, layer)
        self._at(a)
        self._at(b, 11)

    def _point(self, layer, p):
        self._put(0, "POINT", 8, layer)
        self._at(p)

    def piece(self, name, corners, quantity="1", fold=False, notches=()):
        """corners: (x, y[, control points of the edge to the next]); fold: the last edge is the mirror line; notches: edge and share."""
        n = len(corners)
        edges = []
        for i, c in enumerate(corners):
            a, b = c[:2], corners[(i + 1) % n][:2]
            edges.append(along(a, b, c[2] if len(c) > 2 else None))
        self._put(0, "BLOCK", 8, "0", 2, name, 70, 64)
        self._at((0, 0))
        for words in (f"Piece Name: {name}", "Size: M", f"Quantity: {quantity}", "Material: Self"):
            self._note(words)
        if self.open_lines:  # as Gerber does: a line from turn point to turn point
            for i, e in enumerate(edges):
                self._polyline(e + [corners[(i + 1) % n][:2]], LAYERS["boundary"], False)
        else:
            self._polyline([p for e in edges for p in e], LAYERS["boundary"], True)
        for c in corners:
            self._point(LAYERS["turn"], c[:2])
        for edge, share in notches:
            e = edges[edge] + [corners[(edge + 1) % n][:2]]
            at = share * (len(e) - 1)
            i = min(int(at), len(e) - 2)
            f = at - i
            self._point(LAYERS["notch"], tuple((1 - f) * e[i][k] + f * e[i + 1][k] for k in (0, 1)))
        if fold:
            self._line(LAYERS["mirror"], corners[-1][:2], corners[0][:2])
        low, high = min(c[1] for c in corners), max(c[1] for c in corners)
        middle = sum(c[0] for c in corners) / n
        self._line(LAYERS["grain"], (middle, low + .25 * (high - low)), (middle, low + .75 * (high - low)))
        self._put(0, "ENDBLK")

    def text(self):
        self._put(0, "ENDSEC", 0, "SECTION", 2, "ENTITIES")
        for words in (f"Style Name: {self.style}", "Sample Size: M", f"Units: {self.units}"):
            self._note(words)
        self._put(0, "ENDSEC", 0, "EOF")
        return "\n".join(self.lines) + "\n"


def half_trunk(b, back, ease, length, sleeve, open_front=False):
    """Half a front or back, its middle the last edge."""
    half, hem = b["bust"] * ease / 4, max(b["hip"] * 1.08, b["waist"] * 1.08, b["bust"] * ease) / 4
    tip = b["shoulder_w"] / 2 - (0 if sleeve else 1.5)
    under = length - b["scye"] - (garments.SCYE_EASE if sleeve else 1.5)
    x, drop = garments.neckline(b, "vee" if open_front else "round")
    drop = garments.BACK_NECK if back else drop
    neck = garments.neck_curve(x, length, drop)
    return [(0, 0), (hem, 0), (half, under, garments.ARMHOLE), (tip, length - b["slope"] * (tip - x)), (x, length, neck), (0, length - drop)]


def hole(corners):
    return bezier_length(corners[2][:2], corners[3][:2], corners[2][2])


def sleeve(b, armhole, reach, wide=1.25):
    """In one piece, the front to +x: cut out a little more than the back."""
    width = b["biceps"] * wide / 2
    end = max(.5 * garments.SLEEVE_EASE * garments.arm_girth(b, reach), .42 * b["biceps"])
    curves = lambda h: (relative((width, 0), (0, h), (.50 * width, .02 * h), (.55 * width, h)), relative((0, h), (-width, 0), (-.60 * width, h), (-.55 * width, 0)))
    low, high = 1, 40
    for _ in range(50):
        h = (low + high) / 2
        front, back = curves(h)
        low, high = (h, high) if bezier_length((width, 0), (0, h), front) + bezier_length((0, h), (-width, 0), back) < armhole else (low, h)
    front, back = curves(h)
    return [(-end, h - reach), (end, h - reach), (width, 0, front), (0, h, back), (-width, 0)]


def shirt(b, style, long, ease=1.10, **file):
    f = File(style, **file)
    length = 66 * b["tall"]
    front, back = (half_trunk(b, k, ease, length, long > 0) for k in (False, True))
    f.piece("FRONT", front, fold=True, notches=[(2, .45)])
    f.piece("BACK", back, fold=True, notches=[(2, .40), (2, .47)])
    if long:
        f.piece("SLEEVE", sleeve(b, hole(front) + hole(back), long * b["arm"]), "1,1", notches=[(3, 0)])
    return f.text()


def trousers(b, style, ease=1.10, **file):
    f = File(style, **file)
    rise, inseam = b["rise"] + 3, b["waist_y"] - b["rise"] - 10
    hip = b["hip"] * ease / 4
    end = b["thigh"] * .44
    for name, share in (("FRONT LEG", .22), ("BACK LEG", .42)):
        fork, waist, top, hip_y = hip * share, max(b["waist"] * 1.02 / 4, hip - 5), inseam + rise, inseam + rise - b["drop"]
        middle = (hip - fork) / 2
        at = max(hip, waist)
        # The side is one edge from hem to waist, as it is drawn: it runs through the hip.
        side = relative((middle + end / 2, 0), (waist, top), (at + 1, .45 * top), (at + 3.5, top - .55 * b["drop"]))
        # The inseams of front and back are equally long to 2 mm: the back's fork lies a little lower.
        f.piece(name, [(middle - end / 2, 0), (middle + end / 2, 0, side), (waist, top), (0, top, [(.55, .02), (.95, .22)]),
                       (-fork, inseam - drop_of_fork(middle, end, fork, hip, inseam))], "1,1", notches=[(1, .5)])
    return f.text()


def drop_of_fork(middle, end, fork, hip, inseam):
    """How much lower a fork of this reach lies for an inseam as long as that of the front."""
    front = hip * .22
    m = (hip - front) / 2
    wanted = math.hypot(m - end / 2 + front, inseam)
    return inseam - math.sqrt(max(1.0, wanted ** 2 - (middle - end / 2 + fork) ** 2))


def skirt(b, style, **file):
    """Half pieces at the fold and a waistband in one piece."""
    f = File(style, **file)
    long, w, hip = 58 * b["tall"], b["waist"] * 1.02 / 4, b["hip"] * 1.06 / 4
    hip = max(hip, w)
    hem = hip * 1.2
    side = relative((hem, 0), (w, long), (hip + .3 * (hem - hip), .55 * (long - b["drop"])), (hip + 1.2, long - .45 * b["drop"]))
    for name in ("FRONT SKIRT", "BACK SKIRT"):
        f.piece(name, [(0, 0), (hem, 0, side), (w, long), (0, long)], fold=True, notches=[(1, .6)])
    f.piece("WAISTBAND", [(0, 0), (4 * w * .99, 0), (4 * w * .99, 4), (0, 4)])
    return f.text()


def waistcoat(b, style, **file):
    """Open in front, with a V neck: two fronts of one hand each, a back at the fold. Sewn by the side file."""
    f = File(style, **file)
    length = 60 * b["tall"]
    front, back = (half_trunk(b, k, 1.15, length, False, open_front=True) for k in (False, True))
    front[4] = front[4][:2]
    f.piece("FRONT", front, "1,1", notches=[(2, .5)])
    f.piece("BACK", back, fold=True)
    return f.text()


def built(make_for):
    b = garments.cut_for(make_for)
    return {
        "dxf_tee": shirt(b, "TEE 100", .42),
        "dxf_shirt": shirt(b, "SHIRT 200", 1.05, inches=False, sideways=True, open_lines=True),
        "dxf_tank": shirt(b, "TANK 300", 0, 1.06, inches=False),
        "dxf_trousers": trousers(b, "TROUSERS 400", open_lines=True),
        "dxf_skirt": skirt(b, "SKIRT 500", open_lines=True),
        "dxf_waistcoat": waistcoat(b, "WAISTCOAT 600", open_lines=True),
    }


def side_file(seams):
    """As somebody confirms it who has looked at the picture of the proposal."""
    return "confirmed = true\n" + "".join(f'\n[[seam]]\nname = "{name}"\nfirst = "{first}"\nsecond = "{second}"\n' for name, first, second in seams)


# Of the eight seams that --propose-seams proposes for the waistcoat these four are right.
SEAMS = {
    "dxf_waistcoat": side_file([("side_L", "FRONT.e2", "BACK.e7"), ("shoulder_L", "FRONT.e4", "BACK.e5"),
                                ("side_R", "FRONT_mirrored.e2", "BACK.e1"), ("shoulder_R", "FRONT_mirrored.e4", "BACK.e3")]),
}


def build(make_for=None):
    """name → (class, DXF text); make_for as in garments.build."""
    return {name: ("DXF as of CAD", text) for name, text in built(make_for).items()}
