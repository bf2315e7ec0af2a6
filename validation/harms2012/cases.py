"""The cases of the study: which child in which shirt of which cloth, with what sewn on where."""

import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parent.parent

# Girths in metres. Slim and heavy are the study's two; the shirt is tight on the hip of the last
# one by construction, as the paper says of its right child. All are 1.40 m tall.
BODIES = {
    "slim": {"chest": 0.63, "waist": 0.55, "hip": 0.68},
    "heavy": {"chest": 0.75, "waist": 0.72, "hip": 0.80},
    "tight hip": {"chest": 0.75, "waist": 0.72, "hip": 0.92},
}
CHILDREN = ("slim", "heavy")
MATERIALS = ("paper-cotton", "cotton-jersey")
# The paper's four places; the scapula is the mean of left and right.
SITES = ["scapula", "upper_back", "mid_back", "lower_back"]
BOARDS = ["scapula_L", "scapula_R", *SITES[1:]]
BOARD_MASS = 0.010  # [kg]
UPRIGHT = "standing"  # where the sensors are calibrated
BENDS = {"forward-bend-15": 15, "forward-bend-30": 30, "forward-bend-45": 45}  # [deg]
# Those that are judged. Farther down cloth is caught between arm and breast on some donnings of a heavy
# child, and a donning that lacks one of these is lost; so the last bend is only told beside them.
JUDGED = ("forward-bend-15", "forward-bend-30")
EDGE, FINE_EDGE, QUICK_EDGE = 14, 10, 20  # [mm]
DONNINGS, MOVED_DONNINGS, SIDE_DONNINGS, FOLD_DONNINGS, QUICK_DONNINGS = 12, 2, 3, 8, 2
# A first drape that does not settle would take all donnings with it: tried again, shaken so [m rms].
SHAKES = [0.0, 0.0005, 0.001]
# Boards off their places [mm]: towards the spine (on the spine: to the wearer's right), and up.
MOVES = [(20, 0), (-20, 0), (0, 20), (0, -20)]


def case(body, material="paper-cotton", donnings=SIDE_DONNINGS, **more):
    return {"body": body, "material": material, "edge_mm": EDGE, "donnings": donnings,
            "postures": [UPRIGHT, *JUDGED], "boards": True, **more}


# Where the sensors are sewn on the one shirt, from the landmarks of both children.
ADDRESSES = {f"{body}-address": case(body, donnings=1, postures=[], boards=False)
             for body in CHILDREN}
# The study itself, and once more with the boards beside their places. The draws of donnings are
# the same on both children; those of the moved boards are others, so as to add to them.
MAIN, MOVED = {}, {}
for _material in MATERIALS:
    for _body in CHILDREN:
        MAIN[f"{_body}-{_material}"] = case(_body, _material, DONNINGS, postures=[UPRIGHT, *BENDS])
        for _k, _move in enumerate(MOVES):
            MOVED[f"{_body}-{_material}-moved-{_k + 1}"] = case(
                _body, _material, MOVED_DONNINGS, move_mm=_move, seed=2 + _k)
# One thing changed at a time, in the paper's cotton.
SIDE = {}
for _body in CHILDREN:
    SIDE[f"{_body}-bare"] = case(_body, boards=False)
    SIDE[f"{_body}-as-put-on"] = case(_body, movements="[]")
SIDE["heavy-fine"] = case("heavy", donnings=2, edge_mm=FINE_EDGE)
# Level folds: a child on whose hip the shirt is tight.
FOLDS = {"tight-hip-upright": case("tight hip", donnings=FOLD_DONNINGS, postures=[], boards=False)}
ALL = {**ADDRESSES, **MAIN, **MOVED, **SIDE, **FOLDS}

# The reference garment of the paper's Figure 3.
REFERENCE = REPOSITORY / "examples" / "reference-shirt.toml"


def quick(specs):
    """A few of them, on a coarse mesh with few donnings: tries the scripts, shows nothing."""
    coarse = {FINE_EDGE: EDGE, EDGE: QUICK_EDGE}
    return {name: {**spec, "edge_mm": coarse[spec["edge_mm"]],
                   "donnings": QUICK_DONNINGS if name in MAIN else 1}
            for name, spec in specs.items()
            if spec["material"] == MATERIALS[0] and spec.get("move_mm", MOVES[0]) == MOVES[0]}


def moved_place(name, place, move_mm):
    """A board's place (u, v) [m] moved by (to the spine, up) [mm]."""
    u, v = place
    to_spine = -math.copysign(1, u) if name.startswith("scapula") else 1
    return u + to_spine * move_mm[0] / 1000, v + move_mm[1] / 1000


def scenario_text(spec, places=None, shake=0.0):
    """The scenario file of one case; `places` of the boards in the back panel: name -> (u, v) [m];
    `shake`: rms shift of the start [m]."""
    body = ", ".join(f"{name} = {girth:.2f}" for name, girth in BODIES[spec["body"]].items())
    lines = [
        "[body]", "sex = 0.4", "age = 10", "height = 1.40", f"measurements = {{ {body} }}", "",
        "[garment]", 'size = "child-142"', "",
        "[material]", f'name = "{spec["material"]}"', ""]
    for name, place in (places or {}).items():
        u, v = moved_place(name, place, spec.get("move_mm", (0, 0)))
        lines += ["[[site]]", f'name = "{name}"', 'panel = "back"', f"at = [{u:.4f}, {v:.4f}]",
                  *([f"board = {{ mass = {BOARD_MASS} }}"] if spec["boards"] else []), ""]
    lines += [
        "[simulation]", f"edge_length = {spec['edge_mm'] / 1000}", f"seed = {spec.get('seed', 1)}",
        "time_budget = 3600",  # wall time: a busy machine is no reason not to settle
        *([f"start_perturbation = {shake}"] if shake else []), ""]
    lines += ["[donning]", f"repeats = {spec['donnings']}",
              *([f"movements = {spec['movements']}"] if "movements" in spec else []), ""]
    if spec["postures"]:
        lines += ["[postures]", "list = [" + ", ".join(f'"{p}"' for p in spec["postures"]) + "]", ""]
    lines += ["[output]", 'maps = ["strain", "distance", "angular-deviation", "orientation"]',
              'views = ["back", "front"]', "width = 900", "height = 1000",
              *(["preset_sites = false"] if places else []), ""]
    return "\n".join(lines)
