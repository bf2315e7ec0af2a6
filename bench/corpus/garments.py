"""Garments written anew in GarmentCode's grammar: tops, dresses, skirts, trousers, with what its programs offer.

Every garment is made for a body (MAKE, centimetres: an average adult) and placed as GarmentCode places its panels: flat before and
behind, sleeves turned with the arm.
"""
import math

from pieces import Arc, Pattern, Piece, bezier_length, relative

MAKE = {"bust": 100.5, "waist": 87.5, "hip": 104.0, "neck": 41.0, "neck_w": 12.5, "shoulder_w": 37.0, "slope": .42, "trunk": 46.0, "scye": 22.5,
        "arm": 51.5, "elbow_at": 28.5, "biceps": 31.5, "elbow": 24.5, "forearm": 23.5, "wrist": 15.5, "rise": 24.0, "drop": 17.5,
        "thigh": 58.0, "waist_y": 104.0, "arm_deg": 48.0, "floor": 3.0}
MAKE_HEIGHT = 172.0
LENGTHS = ("trunk", "scye", "arm", "elbow_at", "rise", "drop", "waist_y", "floor")

# Meant to be stretched, by a rib, a waistband without an opening or by the whole garment: these press with more than what a garment weighs.
STRETCHED = {"sweat", "rib_tee", "hoodie_rib", "top_long_snug", "strapless_straight", "strapless_circle", "joggers", "pants_gathered"}


def cut_for(make):
    """MAKE for somebody with these girths and this height [cm]; widths and lengths that `make` does not give go with them."""
    tall = make["height"] / MAKE_HEIGHT if make else 1.0
    body = {k: v * (tall if k in LENGTHS else 1) for k, v in MAKE.items()}
    if make:
        for k in ("neck", "neck_w", "shoulder_w", "biceps", "elbow", "forearm", "wrist", "thigh"):
            girth = "hip" if k == "thigh" else "bust"
            body[k] = MAKE[k] * (make[girth] / MAKE[girth] + tall) / 2
        body |= {k: v for k, v in make.items() if k in MAKE}
    body |= {"tall": tall, "hps": body["waist_y"] + body["trunk"], "crotch_y": body["waist_y"] - body["rise"]}
    return body


def neckline(b, kind):
    """Where the shoulder seam begins beside the middle, and how far below it the front lies: as long as the neck's base and 8 % more."""
    x = b["neck_w"] / 2 + (4 if kind == "boat" else 1.2)
    drop = {"round": 7, "vee": 16, "boat": 4}[kind] * b["tall"]
    length = lambda deep: bezier_length((x, deep), (0, 0), neck_curve(x, deep, deep))
    while kind != "vee" and 2 * (length(drop) + length(BACK_NECK)) < 1.08 * b["neck"]:
        drop += .1
    return x, drop


def neck_curve(x, y, drop):
    """From the shoulder at (x, y) to the middle, `drop` lower, where it lies level."""
    return relative((x, y), (0, y - drop), (.93 * x, y - .62 * drop), (.55 * x, y - drop))


BACK_NECK = 2.5
SCYE_EASE = 5.0  # underarm below the armpit: the cap is then high enough for arms that hang
ARMHOLE = [(.30, .30), (.72, .18)]


def top(p, body, sleeve="long", ease=1.10, length=66, open_front=False, neck="round", collar=None, cuff=None,
        hem_band=False, labels=True, flare=1.0, wide=1.25, arcs=False, dart=0):
    """Trunk, sleeves and what is sewn to them; returns the hem's half width for what follows below. dart: taken in at the bust [cm]."""
    b = body
    length *= b["tall"]
    half, hem = b["bust"] * ease / 4, max(b["hip"] * 1.08, b["waist"] * 1.08, b["bust"] * ease) / 4 * flare
    if length < 50 * b["tall"]:
        hem = max(half, b["waist"] * 1.12 / 4) if flare == 1.0 else half * flare
    tip = b["shoulder_w"] / 2 - (1.5 if sleeve == "none" else 0)
    under = length - b["scye"] - (1.5 if sleeve == "none" else SCYE_EASE)
    hps_x, drop = neckline(b, neck)
    label = "body" if labels else ""

    def trunk(name, neck_drop, z, taken=0):
        corners = [(0, 0, "hem"), (hem, 0, "side")]
        if taken:  # the side is longer by the dart, whose legs are equal
            x, y = half + (hem - half) * .25, under * .75
            corners += [(x, y, "dart_low"), (.62 * half, y + taken / 2 + 1, "dart_high"), (x, y + taken, "side_up")]
        elif dart:
            corners += [(half + (hem - half) * .25, under * .75, "side_up")]
        up = length + taken
        corners += [(half, under + taken, "armhole", Arc(.17) if arcs else ARMHOLE), (tip, up - b["slope"] * (tip - hps_x), "shoulder"),
                    (hps_x, up, "neck", None if neck == "vee" and z > 0 else Arc(.16) if arcs else neck_curve(hps_x, up, neck_drop)), (0, up - neck_drop, "centre")]
        return Piece(name, corners, label, (0, b["hps"] - up, z))

    lf = p.add(trunk("left_ftorso", drop, 26, dart))
    rf = p.add(lf.mirrored("right_ftorso"))
    lb = p.add(trunk("back", BACK_NECK, -21).turned("left_btorso"))
    rb = p.add(lb.mirrored("right_btorso"))
    for s in ("left", "right"):
        p.sew(f"{s}_ftorso", "side", f"{s}_btorso", "side")
        if dart:
            p.sew(f"{s}_ftorso", "side_up", f"{s}_btorso", "side_up")
            p.sew(f"{s}_ftorso", "dart_low", f"{s}_ftorso", "dart_high")
        p.sew(f"{s}_ftorso", "shoulder", f"{s}_btorso", "shoulder")
    p.sew("left_btorso", "centre", "right_btorso", "centre")
    if not open_front:
        p.sew("left_ftorso", "centre", "right_ftorso", "centre")
    if sleeve != "none":
        sleeves(p, b, sleeve, lf.length("armhole"), lb.length("armhole"), cuff, labels, wide)
    if collar == "turtle":
        for s, torso, z in (("f", "ftorso", 22), ("b", "btorso", -17)):
            w = p.pieces[f"left_{torso}"].length("neck")
            piece = Piece(f"left_collar_{s}", [(0, 0, "low"), (w, 0, "side"), (w, 6, "top"), (0, 6, "centre")], label,
                          (0, b["hps"] - 1, z))
            piece = piece if s == "f" else piece.turned("left_collar_b")
            p.add(piece, piece.mirrored(f"right_collar_{s}"))
            for side in ("left", "right"):
                p.sew(f"{side}_collar_{s}", "low", f"{side}_{torso}", "neck")
            if s == "b" or not open_front:
                p.sew(f"left_collar_{s}", "centre", f"right_collar_{s}", "centre")
        for side in ("left", "right"):
            p.sew(f"{side}_collar_f", "side", f"{side}_collar_b", "side")
    if collar == "lapel":  # turned over: its right side lies on the front's wrong side
        f, w, wide_collar = lf.length("neck"), lb.length("neck"), 7
        front = p.add(Piece("left_collar_front", [(0, 0, "end"), (-wide_collar, 0, "neck"), (-wide_collar, -f, "free", [(.7, -.2)])], label,
                            (hps_x + wide_collar, b["hps"] + 3, 34)))
        back = p.add(Piece("left_collar_back", [(0, 0, "neck"), (-w, 0, "centre"), (-w, wide_collar, "free"), (0, wide_collar, "end")], label,
                           (w, b["hps"] + 1, -12)))
        p.add(front.mirrored("right_collar_front"), back.mirrored("right_collar_back"))
        for s in ("left", "right"):
            p.sew(f"{s}_collar_front", "neck", f"{s}_ftorso", "neck", wrong=True)
            p.sew(f"{s}_collar_front", "end", f"{s}_collar_back", "end", wrong=True)
            p.sew(f"{s}_collar_back", "neck", f"{s}_btorso", "neck")
        p.sew("left_collar_back", "centre", "right_collar_back", "centre")
    if collar == "hood":
        front, back, tall = lf.length("neck"), lb.length("neck"), b["tall"]
        # Seen from the side: x to the face. Outside of the left half to +x of the wearer.
        hood = Piece("left_hood", [(0, 0, "back_neck", [(.5, -.05)]), (back, -1.5, "front_neck"),
                                   (back + front * .9, -4, "face"), (back + front * .9, 34 * tall, "crown", [(.35, .12), (.75, .25)]),
                                   (-4, 18 * tall, "nape", [(.5, .05)])], label, (11, b["hps"] - 1, -11), (0, 90, 0))
        # After the turn by 90 degrees about y its x runs to -z: mirrored so that the face looks to +z.
        corners = [(-x, y, e, c) for x, y, e, c in hood.corners]
        hood = Piece("left_hood", corners, label, hood.translation, hood.rotation).turned("left_hood")
        p.add(hood, hood.mirrored("right_hood"))
        for s in ("left", "right"):
            p.sew(f"{s}_hood", "front_neck", f"{s}_ftorso", "neck")
            p.sew(f"{s}_hood", "back_neck", f"{s}_btorso", "neck")
        p.sew("left_hood", "crown", "right_hood", "crown")
        p.sew("left_hood", "nape", "right_hood", "nape")
    if hem_band:
        band(p, [("left_ftorso", 1, 26), ("left_btorso", -1, -21)], "hem", hem * .92, 6, b["hps"] - length, "rib", label,
             open_front)
    return hem


def one_shoulder(p, body, length=62, ease=1.08):
    """Hangs on the left shoulder alone; below the right arm its edge runs from there to the underarm."""
    b = body
    length *= b["tall"]
    half, hem = b["bust"] * ease / 4, max(b["hip"] * 1.08, b["bust"] * ease) / 4
    tip, under = b["shoulder_w"] / 2 - 1.5, length - b["scye"] - 1.5
    hps_x, _ = neckline(b, "round")

    def piece(name, sag, z):
        return Piece(name, [(-hem, 0, "hem"), (hem, 0, "left_side"), (half, under, "armhole", ARMHOLE),
                            (tip, length - b["slope"] * (tip - hps_x), "shoulder"), (hps_x, length, "slant", [(.45, sag)]), (-half, under, "right_side")],
                     "body", (0, b["hps"] - length, z))

    front, back = p.add(piece("front", .12, 26), piece("back", .08, -21).turned("back"))
    front.edge_labels = back.edge_labels = {"armhole": "left_armhole"}
    for edge in ("left_side", "shoulder", "right_side"):
        p.sew("front", edge, "back", edge)


def arm_girth(b, x):
    """Of the arm `x` below the shoulder point."""
    at = [(0, b["biceps"]), (.3 * b["arm"], b["biceps"]), (b["elbow_at"], b["elbow"]), (b["elbow_at"] + .1 * b["arm"], b["forearm"]), (b["arm"], b["wrist"])]
    for (x0, g0), (x1, g1) in zip(at, at[1:]):
        if x <= x1:
            return g0 + (g1 - g0) * (x - x0) / (x1 - x0)
    return at[-1][1]


SLEEVE_EASE = 1.20  # at elbow, forearm and wrist


def cap_curve(h, width):
    """From the shoulder, square to the top of the sleeve, to the underarm, square to its seam."""
    return relative((0, 0), (h, -width), (0, -.5 * width), (h, -.55 * width))


def sleeves(p, b, kind, arm_f, arm_b, cuff, labels, wide):
    """Sleeves in two halves; cuff: (girth over that of the arm, gathering of the sleeve into it)."""
    cuff_long = 7 * b["tall"] if cuff and kind != "puff" else 4
    reach = {"cap": .24, "short": .45, "three": .75, "long": 1.05, "puff": .45}[kind] * b["arm"]
    if cuff and kind != "puff":
        reach -= cuff_long - 1  # a little to blouse
    width = b["biceps"] * wide / 2 * (1.2 if kind == "puff" else 1)
    deg = b["arm_deg"]
    root = (b["shoulder_w"] / 2 + 4, b["hps"] - 6)
    more = 1.3 if kind == "puff" else 1.0

    def cap_height(target):  # the cap is as long as its armhole, a puff a third longer
        low, high = 1.0, 40.0
        for _ in range(50):
            h = (low + high) / 2
            low, high = (h, high) if bezier_length((0, 0), (h, -width), cap_curve(h, width)) < target else (low, h)
        return h

    if cuff:
        end = arm_girth(b, reach) * cuff[0] * cuff[1] / 2
    else:  # straight from the underarm to the end, nowhere tighter than asked for
        h = cap_height(arm_f)
        end = max(.5 * SLEEVE_EASE * arm_girth(b, reach), .45 * b["biceps"] if kind == "long" else 0)
        for x in (b["elbow_at"], b["elbow_at"] + .1 * b["arm"]):
            if h < x < reach:
                need, t = .5 * SLEEVE_EASE * arm_girth(b, x), (x - h) / (reach - h)
                end = max(end, width + (need - width) / t)
    end = min(end, width) if kind in ("cap", "short", "three", "long") and not cuff else end

    def half(name, target, z):
        h = min(cap_height(target), reach - 2)
        return Piece(name, [(0, 0, "cap", cap_curve(h, width)), (h, -width, "under"), (reach, -end, "cuff"), (reach, 0, "top")],
                     "arm" if labels else "", (root[0], root[1], z), (0, 0, -deg))

    f = p.add(half("left_sleeve_f", arm_f * more, 18))
    back = p.add(half("left_sleeve_b", arm_b * more, -13).turned("left_sleeve_b"))
    p.add(f.mirrored("right_sleeve_f"), back.mirrored("right_sleeve_b"))
    for s in ("left", "right"):
        p.sew(f"{s}_sleeve_f", "top", f"{s}_sleeve_b", "top")
        p.sew(f"{s}_sleeve_f", "under", f"{s}_sleeve_b", "under")
        p.sew(f"{s}_sleeve_f", "cap", f"{s}_ftorso", "armhole")
        p.sew(f"{s}_sleeve_b", "cap", f"{s}_btorso", "armhole")
    if cuff:  # a band narrower than the sleeve, which is gathered into it
        w = f.length("cuff") / cuff[1]
        long = math.radians(-deg)
        far = f.corners[2][0] + 2
        at = (root[0] + far * math.cos(long), root[1] + far * math.sin(long))
        for s, z in (("f", 18), ("b", -13)):
            piece = Piece(f"left_cuff_{s}", [(0, 0, "arm"), (0, -w, "under"), (cuff_long, -w, "cuff"), (cuff_long, 0, "top")],
                          "arm" if labels else "", (at[0], at[1], z), (0, 0, -deg))
            piece = piece if s == "f" else piece.turned(piece.name)
            p.add(piece, piece.mirrored(f"right_cuff_{s}"))
            for side in ("left", "right"):
                p.sew(f"{side}_cuff_{s}", "arm", f"{side}_sleeve_{s}", "cuff")
        for side in ("left", "right"):
            p.sew(f"{side}_cuff_f", "top", f"{side}_cuff_b", "top")
            p.sew(f"{side}_cuff_f", "under", f"{side}_cuff_b", "under")


def band(p, over, edge, half, height, y, name, label, open_front=False, below=True):
    """A band in four pieces at an edge of the halves `over`, which is gathered into it."""
    for piece, sign, z in over:
        kind = "f" if sign > 0 else "b"
        low = y - height if below else y
        strip = Piece(f"left_{name}_{kind}", [(0, 0, "low"), (half, 0, "side"), (half, height, "high"), (0, height, "centre")],
                      label, (0, low - (1 if below else -1), z))
        strip = strip if sign > 0 else strip.turned(strip.name)
        p.add(strip, strip.mirrored(f"right_{name}_{kind}"))
        for s in ("left", "right"):
            p.sew(f"{s}_{name}_{kind}", "high" if below else "low", piece.replace("left", s), edge)
        if sign < 0 or not open_front:
            p.sew(f"left_{name}_{kind}", "centre", f"right_{name}_{kind}", "centre")
    for s in ("left", "right"):
        p.sew(f"{s}_{name}_f", "side", f"{s}_{name}_b", "side")


HIP_EASE = 1.07


def skirt(p, body, cut="straight", length=55, waistband=True, gather=1.0, flare=1.0, y=None, half=None, to=None, godets=0,
          labels=True, ease=1.0, arcs=False, dart=0):
    """A skirt below the waist, or below the hem of a top (`to`: its pieces, `half`: half of their width)."""
    b = body
    length *= b["tall"]
    waist_y = b["waist_y"] if y is None else y
    half = half or b["waist"] * ease / 4
    label = "leg" if labels else ""
    hip = max(b["hip"] * HIP_EASE / 4, half)
    if cut == "panels":  # front, back and two sides, as GarmentCode's skirt of several panels
        w = half / 2
        low = max(w * flare, w + (1.04 * hip / 2 - w) * length / b["drop"])  # straight, and with room for belly and hip
        out = b["hip"] / math.pi / 2 + 14

        def gore(name, t, rot):
            piece = Piece(name, [(-low, 0, "hem"), (low, 0, "right"), (w, length, "top"), (-w, length, "left")], label, t, rot)
            return piece

        p.add(gore("front", (0, waist_y - length, 24), (0, 0, 0)), gore("back", (0, waist_y - length, -24), (0, 180, 0)),
              gore("left", (out, waist_y - length, 0), (0, 90, 0)), gore("right", (-out, waist_y - length, 0), (0, -90, 0)))
        for a, c in (("front", "left"), ("left", "back"), ("back", "right"), ("right", "front")):
            p.sew(a, "right", c, "left")
        return
    top_w = half * gather
    hips = cut not in ("circle", "wide")
    if cut == "circle":
        # A quarter ring: r inner so that its arc is the half waist.
        r = top_w / (math.pi / 4)
        far = r + length
        c = math.sqrt(.5)
        ring = (lambda rise: Arc(rise)) if arcs else (lambda rise: arc(math.copysign(math.pi / 4, -rise)))
        rise = .5 * math.tan(math.pi / 16)
        corners = [(0, -far, "hem", ring(-rise)), (far * c, -far * c, "side"), (r * c, -r * c, "top", ring(rise)), (0, -r, "centre")]
        left = Piece("left_skirt_f", corners, label, (0, waist_y + r, 22))
    elif cut == "wide":
        low = top_w * 1.05 * flare
        left = Piece("left_skirt_f", [(0, 0, "hem"), (low, 0, "side"), (top_w, length, "top"), (0, length, "centre")], label, (0, waist_y - length, 22))
    else:  # from the hem to the hip, and curved from there to the waist
        low = {"straight": hip, "a": hip * 1.25, "pencil": hip * .92}[cut] * flare
        at_hip, at_waist = (hip, length - b["drop"]), (top_w, length)
        curve = relative(at_hip, at_waist, (hip, length - .6 * b["drop"]), (hip, length - .25 * b["drop"]))
        corners = [(0, 0, "hem"), (low, 0, "side"), (*at_hip, "hipside", curve)]
        if dart:
            corners += [(top_w + dart, length, "top"), (.55 * top_w + dart, length, "dart_a"), (.55 * top_w + dart / 2, length - 10 * b["tall"], "dart_b"),
                        (.55 * top_w, length, "top_in"), (0, length, "centre")]
            corners[2] = (*at_hip, "hipside", relative(at_hip, (top_w + dart, length), (hip, length - .5 * b["drop"])))
        else:
            corners += [(*at_waist, "top"), (0, length, "centre")]
        left = Piece("left_skirt_f", corners, label, (0, waist_y - length, 22))
    back = left.turned("left_skirt_b", (left.translation[0], left.translation[1], -22))
    p.add(left, left.mirrored("right_skirt_f"), back, back.mirrored("right_skirt_b"))
    p.sew("left_skirt_f", "centre", "right_skirt_f", "centre")
    p.sew("left_skirt_b", "centre", "right_skirt_b", "centre")
    if dart:
        for name in ("left_skirt_f", "left_skirt_b", "right_skirt_f", "right_skirt_b"):
            p.sew(name, "dart_a", name, "dart_b")
    if godets:
        side_godets(p, left, godets * b["tall"], label)
    else:
        for s in ("left", "right"):
            p.sew(f"{s}_skirt_f", "side", f"{s}_skirt_b", "side")
    if hips:
        for s in ("left", "right"):
            p.sew(f"{s}_skirt_f", "hipside", f"{s}_skirt_b", "hipside")
    if to:
        for s in ("left", "right"):
            for k, piece in (("f", to[0]), ("b", to[1])):
                p.sew(f"{s}_skirt_{k}", "top", piece.replace("left", s), "hem")
    elif waistband:
        band(p, [("left_skirt_f", 1, 22), ("left_skirt_b", -1, -22)], "top", half, 4, waist_y, "wb", "body" if labels else "", below=False)


def arc(angle):
    """Relative control points of a circular arc that turns by `angle` (left is positive)."""
    k = 4 / 3 * math.tan(abs(angle) / 4)
    r = .5 / math.sin(abs(angle) / 2)
    h = abs(angle) / 2
    u, v = k * r * math.cos(h), k * r * math.sin(h)
    v = -v if angle > 0 else v
    return [(u, v), (1 - u, v)]


def side_godets(p, left, depth, label):
    """Splits the side seams: the upper part is sewn, a wedge of cloth goes into the lower one."""
    for name in ("left_skirt_f", "left_skirt_b", "right_skirt_f", "right_skirt_b"):
        piece = p.pieces[name]
        corners, n = [], len(piece.corners)
        for i, (x, y, e, c) in enumerate(piece.corners):
            if e != "side":
                corners.append((x, y, e, c))
                continue
            x1, y1 = piece.corners[(i + 1) % n][:2]
            length = math.dist((x, y), (x1, y1))
            t = depth / length if y < y1 else 1 - depth / length
            corners.append((x, y, "slit" if y < y1 else "side", None))
            corners.append((x + t * (x1 - x), y + t * (y1 - y), "side" if y < y1 else "slit", None))
        piece.corners = corners
    cut = p.pieces["left_skirt_f"].length("slit")
    x, y, _ = left.translation
    far = max(c[0] for c in left.corners)
    for s, sign in (("left", 1), ("right", -1)):
        w = 9
        h = math.sqrt(cut * cut - w * w)
        p.add(Piece(f"{s}_godet", [(-w, 0, "hem"), (w, 0, "one"), (0, h, "two")], label, (sign * (far + 6), y, 0), (0, 90 * sign, 0)))
        front, back = ("two", "one") if s == "left" else ("one", "two")
        p.sew(f"{s}_godet", front, f"{s}_skirt_f", "slit")
        p.sew(f"{s}_godet", back, f"{s}_skirt_b", "slit")
        p.sew(f"{s}_skirt_f", "side", f"{s}_skirt_b", "side")


def trousers(p, body, length=1.0, leg="straight", waistband=True, cuff=None, ease=1.06, labels=True, to=None, half=None, ratio=1.0):
    b = body
    rise = b["rise"] + 3
    crotch = b["waist_y"] - rise
    inseam = (crotch - b["floor"] - 4) * length
    hip = b["hip"] * ease / 4
    # Seams can take in so much above the hip; the rest is gathered into the waistband.
    waist = half or max(b["waist"] * 1.04 / 4 * ratio, (hip - 5) * (waistband or ratio > 1), b["waist"] * 1.02 / 4)
    fork_f, fork_b = hip * .22, hip * .42
    thigh = b["thigh"] * 1.08
    end = {"straight": .40, "wide": .60, "flare": .50, "tapered": .30, "legging": .20}[leg] * thigh
    if length < .6:
        end = max(end, thigh * .48)
    label = "leg" if labels else ""

    def half_leg(name, fork, z):
        # x = 0 at the centre front; the leg hangs in the middle of crotch and side.
        middle, top_y, hip_y = (hip - fork) / 2, inseam + rise, inseam + rise - b["drop"]
        start, at_hip, at_waist = (middle + end / 2, 0), (max(hip, waist), hip_y), (waist, top_y)
        corners = [(middle - end / 2, 0, "hem"), (*start, "side", relative(start, at_hip, (start[0] + .5 * (at_hip[0] - start[0]), .5 * hip_y),
                                                                           (at_hip[0], hip_y - .25 * inseam))),
                   (*at_hip, "hipside", relative(at_hip, at_waist, (at_hip[0], hip_y + .45 * b["drop"]), ((2 * at_hip[0] + waist) / 3, top_y - .25 * b["drop"]))),
                   (*at_waist, "top"), (0, top_y, "rise", [(.55, .02), (.95, .22)]), (-fork, inseam, "inseam", [(.4, .03), (.7, .02)])]
        return Piece(name, corners, label, (1, crotch - inseam, z))

    f = p.add(half_leg("left_pant_f", fork_f, 20))
    back = p.add(half_leg("back", fork_b, -20).turned("left_pant_b"))
    p.add(f.mirrored("right_pant_f"), back.mirrored("right_pant_b"))
    for s in ("left", "right"):
        p.sew(f"{s}_pant_f", "side", f"{s}_pant_b", "side")
        p.sew(f"{s}_pant_f", "hipside", f"{s}_pant_b", "hipside")
        p.sew(f"{s}_pant_f", "inseam", f"{s}_pant_b", "inseam")
    p.sew("left_pant_f", "rise", "right_pant_f", "rise")
    p.sew("left_pant_b", "rise", "right_pant_b", "rise")
    if to:
        for s in ("left", "right"):
            for k, piece in (("f", to[0]), ("b", to[1])):
                p.sew(f"{s}_pant_{k}", "top", piece.replace("left", s), "hem")
    elif waistband:
        band(p, [("left_pant_f", 1, 20), ("left_pant_b", -1, -20)], "top", b["waist"] * 1.0 / 4, 4, b["waist_y"], "wb",
             "body" if labels else "", below=False)
    if cuff:
        for s in ("f", "b"):
            piece = p.pieces[f"left_pant_{s}"]
            w = piece.length("hem") / cuff
            x = min(c[0] for c in piece.corners if c[2] == "hem" or c[1] == 0) + piece.length("hem") * (1 - 1 / cuff) / 2 + 1
            strip = Piece(f"left_legcuff_{s}", [(x, -7, "hem"), (x + w, -7, "out"), (x + w, 0, "leg"), (x, 0, "in")], label,
                          (0, piece.translation[1] - 1, piece.translation[2]))
            strip = strip if s == "f" else strip.turned(strip.name)
            p.add(strip, strip.mirrored(f"right_legcuff_{s}"))
            for side in ("left", "right"):
                p.sew(f"{side}_legcuff_{s}", "leg", f"{side}_pant_{s}", "hem")
        for side in ("left", "right"):
            p.sew(f"{side}_legcuff_f", "out", f"{side}_legcuff_b", "out")
            p.sew(f"{side}_legcuff_f", "in", f"{side}_legcuff_b", "in")


def strapless(p, body, labels=True):
    """A tube from above the bust to the waist."""
    b = body
    length = b["trunk"] - b["scye"] - 1
    half, low = b["bust"] * .98 / 4, b["waist"] * 1.03 / 4
    piece = Piece("left_ftube", [(0, 0, "hem"), (low, 0, "side"), (half, length, "top"), (0, length, "centre")], "body" if labels else "",
                  (0, b["waist_y"], 24))
    piece.edge_labels = {"top": "strapless_top"}
    back = piece.turned("left_btube", (0, b["waist_y"], -20))
    back.edge_labels = dict(piece.edge_labels)
    p.add(piece, piece.mirrored("right_ftube"), back, back.mirrored("right_btube"))
    for s in ("left", "right"):
        p.sew(f"{s}_ftube", "side", f"{s}_btube", "side")
    p.sew("left_ftube", "centre", "right_ftube", "centre")
    p.sew("left_btube", "centre", "right_btube", "centre")
    return low


def build(make_for=None):
    """name → (class, specification text), in a fixed order. make_for: girths and height [cm] that they are cut to; placed they are as
    for somebody of MAKE_HEIGHT."""
    made = {}
    b = cut_for(make_for)
    lift = 0.85 * (MAKE_HEIGHT - make_for["height"]) if make_for else 0

    def make(name, kind, build_it):
        p = Pattern()
        build_it(p)
        for piece in p.pieces.values():
            x, y, z = piece.translation
            piece.translation = (x, y + lift, z)
        made[name] = (kind, p.text())

    tops = {
        "tee_short": dict(sleeve="short"), "tee_cap": dict(sleeve="cap", ease=1.06), "tee_wide": dict(sleeve="short", ease=1.25, wide=1.5),
        "top_three": dict(sleeve="three", neck="boat"), "top_long": dict(sleeve="long"), "top_long_snug": dict(sleeve="long", ease=1.02, wide=1.15),
        "top_long_vee": dict(sleeve="long", neck="vee"), "top_none": dict(sleeve="none"), "top_none_vee": dict(sleeve="none", neck="vee", ease=1.05),
        "top_long_unlabelled": dict(sleeve="long", labels=False), "tee_crop": dict(sleeve="short", length=44),
        "tunic": dict(sleeve="three", length=88, flare=1.15), "tee_arcs": dict(sleeve="short", arcs=True), "top_dart": dict(sleeve="long", dart=3),
        "vest_dart": dict(sleeve="none", dart=3)}
    for name, options in tops.items():
        make(name, "sleeveless top" if options["sleeve"] == "none" else "sleeved top", lambda p, o=options: top(p, b, **o))
    make("one_shoulder", "sleeveless top", lambda p: one_shoulder(p, b))
    for name, options in {
            "sweat": dict(sleeve="long", cuff=(1.15, 1.35), hem_band=True, ease=1.16, wide=1.4), "turtleneck": dict(sleeve="long", collar="turtle"),
            "turtle_short": dict(sleeve="short", collar="turtle"), "puff": dict(sleeve="puff", cuff=(1.2, 1.5)), "blouse": dict(sleeve="long", cuff=(1.2, 1.5), collar="turtle", wide=1.4),
            "rib_tee": dict(sleeve="short", hem_band=True)}.items():
        make(name, "cuff, band or collar", lambda p, o=options: top(p, b, **o))
    for name, options in {
            "hoodie": dict(sleeve="long", collar="hood", ease=1.18, wide=1.4),
            "hoodie_rib": dict(sleeve="long", collar="hood", ease=1.18, wide=1.4, cuff=(1.15, 1.3), hem_band=True),
            "hood_none": dict(sleeve="none", collar="hood", ease=1.15), "hood_short": dict(sleeve="short", collar="hood", ease=1.12)}.items():
        make(name, "hood", lambda p, o=options: top(p, b, **o))
    for name, options in {
            "jacket": dict(sleeve="long", open_front=True, ease=1.2, wide=1.45), "vest": dict(sleeve="none", open_front=True, ease=1.15),
            "jacket_hood": dict(sleeve="long", open_front=True, collar="hood", ease=1.2, wide=1.45),
            "cardigan": dict(sleeve="three", open_front=True, neck="vee", length=72, ease=1.15, wide=1.35),
            "jacket_lapel": dict(sleeve="long", open_front=True, neck="vee", collar="lapel", ease=1.2, wide=1.45)}.items():
        make(name, "open front", lambda p, o=options: top(p, b, **o))

    def dress(p, over, **below):
        half = top(p, b, length=b["trunk"] / b["tall"], **over)
        skirt(p, b, y=b["waist_y"], half=half, to=("left_ftorso", "left_btorso"), waistband=False, **below)

    for name, (over, below) in {
            "dress_straight": (dict(sleeve="short"), dict(cut="straight")), "dress_a": (dict(sleeve="three"), dict(cut="a", length=60)),
            "dress_gather": (dict(sleeve="short"), dict(cut="wide", gather=1.6, length=55)), "dress_gather2": (dict(sleeve="none"), dict(cut="wide", gather=2.0, length=50)),
            "dress_circle": (dict(sleeve="none"), dict(cut="circle", length=50)), "dress_long": (dict(sleeve="long"), dict(cut="a", length=85)),
            "dress_godet": (dict(sleeve="short"), dict(cut="straight", length=65, godets=30))}.items():
        make(name, "dress", lambda p, o=over, s=below: dress(p, o, **s))

    def tube_dress(p, **below):
        half = strapless(p, b)
        skirt(p, b, half=half, to=("left_ftube", "left_btube"), waistband=False, **below)

    make("strapless_straight", "dress", lambda p: tube_dress(p, cut="straight"))
    make("strapless_circle", "dress", lambda p: tube_dress(p, cut="circle", length=45))
    for name, options in {
            "skirt_straight": dict(cut="straight"), "skirt_a": dict(cut="a", length=60), "skirt_pencil": dict(cut="pencil", length=58),
            "skirt_gather": dict(cut="wide", gather=1.5), "skirt_gather2": dict(cut="wide", gather=2.0, length=50), "skirt_circle": dict(cut="circle", length=50),
            "skirt_circle_long": dict(cut="circle", length=70), "skirt_godet": dict(cut="straight", length=62, godets=28), "skirt_4": dict(cut="panels", flare=1.5, waistband=False),
            "skirt_4_wide": dict(cut="panels", flare=2.0, waistband=False, length=45), "skirt_noband": dict(cut="a", waistband=False), "skirt_long": dict(cut="a", length=90),
            "skirt_unlabelled": dict(cut="a", labels=False), "skirt_arcs": dict(cut="circle", length=55, arcs=True),
            "skirt_dart": dict(cut="straight", waistband=False, dart=2.5)}.items():
        make(name, "skirt", lambda p, o=options: skirt(p, b, **o))
    for name, options in {
            "pants_straight": {}, "pants_wide": dict(leg="wide"), "pants_flare": dict(leg="flare"), "pants_tapered": dict(leg="tapered"), "shorts": dict(length=.35, leg="wide"),
            "capri": dict(length=.7, leg="tapered"), "joggers": dict(cuff=1.4, leg="straight", ease=1.12), "pants_noband": dict(waistband=False),
            "pants_loose": dict(ease=1.2, leg="wide"), "pants_unlabelled": dict(labels=False), "pants_gathered": dict(ratio=1.3, ease=1.15)}.items():
        make(name, "trousers", lambda p, o=options: trousers(p, b, **o))

    def jumpsuit(p, over, **below):
        half = top(p, b, length=b["trunk"] / b["tall"], **over)
        trousers(p, b, half=half, to=("left_ftorso", "left_btorso"), **below)

    make("jumpsuit", "jumpsuit", lambda p: jumpsuit(p, dict(sleeve="long", ease=1.12)))
    make("romper", "jumpsuit", lambda p: jumpsuit(p, dict(sleeve="none"), length=.35, leg="wide"))
    make("overall_short", "jumpsuit", lambda p: jumpsuit(p, dict(sleeve="short", ease=1.12), leg="tapered"))
    return made
