"""The cases of the study: which child in which shirt of which cloth, and how it is put on."""

import pathlib

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parent.parent

# Girths in metres. Slim and heavy are the study's two; the stocky one is nearer to a hip that the
# shirt is tight on, the last one is tight there by construction. All are 1.40 m tall.
BODIES = {
    "slim": {"chest": 0.63, "waist": 0.55, "hip": 0.68},
    "heavy": {"chest": 0.75, "waist": 0.72, "hip": 0.80},
    "stocky": {"chest": 0.79, "waist": 0.74, "hip": 0.85},
    "tight hip": {"chest": 0.75, "waist": 0.72, "hip": 0.92},
}
# The paper's four places; the scapula is the mean of left and right.
SITES = ["scapula", "upper_back", "mid_back", "lower_back"]
MAIN_EDGE, SIDE_EDGE = 10, 14  # [mm]
MAIN_DONNINGS, SIDE_DONNINGS = 8, 4


def case(body, material="paper-cotton", edge=SIDE_EDGE, donnings=SIDE_DONNINGS, **more):
    return {"body": body, "material": material, "edge_mm": edge, "donnings": donnings, **more}


# The study itself.
MAIN = {f"{body}-{material}": case(body, material, MAIN_EDGE, MAIN_DONNINGS)
        for material in ("paper-cotton", "cotton-jersey") for body in ("slim", "heavy")}

# One thing changed at a time, on a coarser mesh; "base" is what to compare with.
SIDE = {}
for _body in ("slim", "heavy"):
    SIDE[f"{_body}-base"] = case(_body, donnings=MAIN_DONNINGS)
SIDE["stocky-base"] = case("stocky")
SIDE["tight-hip-base"] = case("tight hip")
for _body in ("heavy", "tight hip"):
    # Put on up to 30 mm too high or low, to see whether a hem that stays up makes level folds.
    SIDE[f"{_body.replace(' ', '-')}-lifted"] = case(_body, donnings=6, shift=0.03)
for _body in ("heavy", "tight hip"):
    # The child has bent forward and stands up again: cloth pulled over the back may stay there.
    SIDE[f"{_body.replace(' ', '-')}-bent"] = case(
        _body, donnings=3, postures='["forward-bend-30", "standing"]')
# The slim child, whose order is farthest from the paper's.
SIDE["slim-low"] = case("slim", posture="{ arm_abduction_deg = 12 }")
SIDE["slim-arms"] = case("slim", posture="{ arm_abduction_deg = 40 }")
SIDE["slim-literal"] = case("slim", "paper-cotton-literal")
SIDE["slim-knit"] = case("slim", "paper-cotton-knit")
SIDE["slim-friction"] = case("slim", material_keys={"friction_body": 0.9})
# The shirt starts 1 mm rms off instead of being put on anew.
SIDE["slim-starts"] = case("slim", donnings=1, repeats=SIDE_DONNINGS)

# The reference garment of the paper's Figure 3.
REFERENCE = REPOSITORY / "examples" / "reference-shirt.toml"


def scenario_text(spec):
    """The scenario file of one case."""
    body = ", ".join(f"{name} = {girth:.2f}" for name, girth in BODIES[spec["body"]].items())
    lines = [
        "[body]", "sex = 0.4", "age = 10", "height = 1.40", f"measurements = {{ {body} }}",
        *([] if "postures" in spec
          else [f"posture = {spec.get('posture', chr(34) + 'standing' + chr(34))}"]), "",
        "[garment]", 'size = "child-142"', "",
        "[material]", f'name = "{spec["material"]}"',
        *(f"{key} = {value}" for key, value in spec.get("material_keys", {}).items()), "",
        "[simulation]", f"edge_length = {spec['edge_mm'] / 1000}", "seed = 1",
        "time_budget = 3600",  # wall time: a busy machine is no reason not to settle
        *([f"repeats = {spec['repeats']}"] if "repeats" in spec else []), "",
        *(["[donning]", f"repeats = {spec['donnings']}",
           *([f"shift = {spec['shift']}"] if "shift" in spec else []), ""]
          if spec["donnings"] > 1 else []),
        *(["[postures]", f"list = {spec['postures']}", ""] if "postures" in spec else []),
        "[output]", 'maps = ["strain", "distance", "angular-deviation", "orientation"]',
        'views = ["back", "front"]', "width = 900", "height = 1000", ""]
    return "\n".join(lines)
