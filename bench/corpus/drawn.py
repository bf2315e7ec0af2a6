"""Garments drawn as SVG with named pieces, as they come from a drawing program: no seams, no places. What they are is told by their
pieces, bands in one piece and legs in one piece included."""
import math

STEPS = 100

# Bands that are cut shorter than what they are sewn to, and leggings.
STRETCHED = {"drawn_sweat", "drawn_hoodie", "drawn_leggings", "drawn_joggers"}


def length(a, c1, c2, b):
    points = []
    for i in range(STEPS + 1):
        t = i / STEPS
        points.append([(1 - t) ** 3 * a[k] + 3 * t * (1 - t) ** 2 * c1[k] + 3 * t * t * (1 - t) * c2[k] + t ** 3 * b[k] for k in (0, 1)])
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


class Outline:
    """A closed path in centimetres, y upwards; written in millimetres, y downwards."""

    def __init__(self, start):
        self.start, self.ways = start, []

    def line(self, to):
        self.ways.append((to,))
        return self

    def curve(self, c1, c2, to):
        self.ways.append((c1, c2, to))
        return self

    def mirrored(self):
        """The mirror image, drawn the same way round."""
        points = [self.start] + [way[-1] for way in self.ways]
        image = Outline((-points[-1][0], points[-1][1]))
        for i in range(len(self.ways) - 1, -1, -1):
            way = list(reversed(self.ways[i][:-1])) + [points[i]]
            image.ways.append(tuple((-x, y) for x, y in way))
        return image

    def path(self):
        text = lambda p: f"{10 * p[0]:.3f} {-10 * p[1]:.3f}"
        return (f"M {text(self.start)} " +
                " ".join(("L " if len(way) == 1 else "C ") + " ".join(text(p) for p in way) for way in self.ways) + " Z")


def strip(along, width):
    """Drawn upright, as on a sheet with no room."""
    return Outline((0, 0)).line((width, 0)).line((width, along)).line((0, along)).line((0, 0))


def svg(pieces):
    rows, x = [], 0
    for name, outline in pieces:
        rows.append(f'<path id="{name}" transform="translate({x},0)" d="{outline.path()}"/>')
        x += 1300
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{x + 1300}mm" height="2400mm" viewBox="-700 -1800 {x + 1300} 2400">\n' +
            "\n".join(rows) + "\n</svg>\n")


def hood(neck, tall, centre):
    """Two halves for a neckline of this length, and a strip between them if it has a width."""
    half, deep = (neck - centre) / 2, .74 * tall
    over = ((.98 * half, .15 * tall), (deep, .35 * tall), (deep, .55 * tall)), ((deep, .8 * tall), (.55 * deep, 1.01 * tall), (0, tall))
    drop = math.sqrt(.5 ** 2 - .49 ** 2) * half
    o = Outline((0, 0)).line((.49 * half, -drop)).line((.98 * half, 0)).curve(*over[0]).curve(*over[1]).line((0, 0))
    back = length((.98 * half, 0), *over[0]) + length(over[0][2], *over[1])
    return [("hood_left", o), ("hood_right", o.mirrored())] + ([("hood_center", strip(back, centre))] if centre else [])


def shirt(b, ease=1.10, sleeve=True, neckband=None, cuff=None, hemband=None, binding=None, long=62, hooded=None):
    """Front and back, sleeves in one piece or none; bands as shares of what they are sewn to."""
    w, s = b["chest"] * ease / 4, b["shoulder"]
    depth = 0.235 * b["chest"]
    under, tip, n = long - depth, long - 4.5, 0.086 * b["chest"] + 0.5
    def trunk(neck, pitch):
        o = Outline((-w, 0)).line((w, 0)).line((w - 1, under)).curve((w - 5, under), (pitch, under + 6), (s, tip)).line((n, long - .8))
        o.curve((.9 * n, long - .5 * neck), (.5 * n, long - neck), (0, long - neck))
        o.curve((-.5 * n, long - neck), (-.9 * n, long - .5 * neck), (-n, long - .8)).line((-s, tip))
        return o.curve((-pitch, under + 6), (-w + 5, under), (-w + 1, under)).line((-w, 0))
    hole = sum(length((w - 1, under), (w - 5, under), (p, under + 6), (s, tip)) for p in (s - 3.5, s - 2.5))
    neck = sum(2 * length((n, long - .8), (.9 * n, long - .5 * d), (.5 * n, long - d), (0, long - d)) for d in (10, 3))
    pieces = [("front", trunk(10, s - 3.5)), ("back", trunk(3, s - 2.5))]
    if sleeve:
        half, down = b["arm"] / 2, 15
        cap = lambda h: (length((half, 0), (.7 * half, 0), (.55 * half, h), (0, h)) +
                         length((0, h), (-.58 * half, h), (-.78 * half, 0), (-half, 0)))
        low, high = 1, 30
        for _ in range(50):
            h = (low + high) / 2
            low, high = (h, high) if cap(h) < hole else (low, h)
        o = Outline((-.9 * half, -down)).line((.9 * half, -down)).line((half, 0)).curve((.7 * half, 0), (.55 * half, high), (0, high))
        o.curve((-.58 * half, high), (-.78 * half, 0), (-half, 0)).line((-.9 * half, -down))
        pieces += [("sleeve_right", o), ("sleeve_left", o.mirrored())]
        if cuff:
            pieces += [(f"cuff_{side}", strip(1.8 * half * cuff, 4)) for side in ("left", "right")]
    elif binding:
        pieces += [(f"armhole_{side}", strip(hole * binding, 2.5)) for side in ("left", "right")]
    if hooded is not None:
        pieces += hood(neck, .19 * b["height"], hooded)
    if neckband:
        pieces.append(("neckband", strip(neck * neckband, 2.5)))
    if hemband:
        pieces.append(("hemband", strip(4 * w * hemband, 6)))
    return svg(pieces)


def whole_legs(b, ease, inseam, hem, waistband=None):
    w, h, fork, rise = b["waist"] * 1.03 / 4, b["hip"] * ease / 4, 0.072 * b["hip"], b["rise"]
    left = Outline((-hem / 2, 0)).line((hem / 2, 0)).line((h + fork, inseam))
    left.curve((h, inseam + 2), (h, inseam + 10), (w, inseam + rise + 3)).line((-w, inseam + rise))
    left.curve((-h, inseam + 10), (-h, inseam + 2), (-h - fork, inseam)).line((-hem / 2, 0))
    pieces = [("leg_left", left), ("leg_right", left.mirrored())]
    if waistband:
        pieces.append(("waistband", strip(4 * w * waistband, 4)))
    return svg(pieces)


def skirt(b, flare, long, waistband):
    w = b["waist"] * 1.02 / 4
    hip, down = max(b["hip"] * 1.06 / 4, w), 0.75 * b["rise"]
    hem, low = hip * flare, long - down
    o = Outline((-hem, 0)).line((hem, 0)).line((hip, low)).curve((hip - .5, long - .5 * down), (w + 1, long - 4), (w, long))
    o.line((-w, long)).curve((-w - 1, long - 4), (-hip + .5, long - .5 * down), (-hip, low)).line((-hem, 0))
    return svg([("front skirt", o), ("back skirt", o), ("waistband", strip(4 * w * waistband, 4))])


def build(make_for=None):
    """name → (class, SVG text); make_for as in garments.build."""
    m = make_for or {"height": 172, "bust": 92, "waist": 76, "hip": 98}
    b = {"chest": m["bust"], "waist": m["waist"], "hip": m["hip"], "shoulder": 0.0553 * m["height"] + 0.107 * m["bust"],
         "arm": 1.25 * m["biceps"] if "biceps" in m else 0.33 * m["bust"] + 2, "rise": 0.155 * m["height"], "height": m["height"]}
    long, inseam = 0.36 * m["height"], 0.39 * m["height"]
    kind = "drawn, without seams or places"
    return {
        "drawn_tee": (kind, shirt(b, long=long)),
        "drawn_tee_neckband": (kind, shirt(b, neckband=.9, long=long)),
        "drawn_sweat": (kind, shirt(b, ease=1.16, neckband=.88, cuff=.85, hemband=.88, long=long)),
        "drawn_hoodie": (kind, shirt(b, ease=1.16, cuff=.85, hemband=.88, long=long, hooded=0)),
        "drawn_hoodie_3": (kind, shirt(b, ease=1.16, long=long, hooded=9)),
        "drawn_tank": (kind, shirt(b, sleeve=False, neckband=.92, binding=.93, long=long)),
        "drawn_leggings": (kind, whole_legs(b, .97, inseam, .235 * m["hip"] + 1, waistband=.95)),
        "drawn_joggers": (kind, whole_legs(b, 1.10, .95 * inseam, .36 * m["hip"], waistband=.97)),
        "drawn_skirt_band": (kind, skirt(b, 1.25, .33 * m["height"], .98)),
    }
