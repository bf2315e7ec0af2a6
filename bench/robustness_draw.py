"""Draws one case of the robustness study: body, fit, fabric, posture, start and mesh, from a seed.

Bodies follow population figures, so that the measures of one belong together: girths of adults share
a common factor with correlations of about 0.85 (ANSUR II; waists lowered to the natural waist), and
children's chest and hip follow waist and stature (KiGGS statures; waists of German children; size
tables round 142 cm).
"""
import math
import pathlib
import random

ROOT = pathlib.Path(__file__).resolve().parents[1]
FABRICS = sorted(path.stem for path in (ROOT / "data/materials").glob("*.toml"))
STRETCH = ("compression-knit", "cotton-jersey", "cotton-rib", "paper-cotton-knit")
CHILD_STATURE = {8: 1.300, 9: 1.358, 10: 1.414, 11: 1.472, 12: 1.533, 13: 1.593, 14: 1.648}
CHILD_WAIST = {8: 0.555, 9: 0.575, 10: 0.595, 11: 0.615, 12: 0.635, 13: 0.655, 14: 0.670}
# Mean and standard deviation [m].
MAN = dict(height=(1.765, 0.070), chest=(1.030, 0.090), waist=(0.900, 0.110), hip=(1.015, 0.078))
WOMAN = dict(height=(1.640, 0.066), chest=(0.945, 0.086), waist=(0.790, 0.098), hip=(1.015, 0.080))
SIZES = {"child-142": 0.71, "women-36": 0.84, "women-38": 0.88, "women-40": 0.92, "women-42": 0.96,
         "women-44": 1.00, "men-S": 0.90, "men-M": 0.98, "men-L": 1.06, "men-XL": 1.14}  # chest [m]


def clipped_normal(rng, most=2.3):
    """Standard normal without the farthest tails, of which a body model knows nothing."""
    while abs(value := rng.gauss(0, 1)) > most:
        pass
    return value


def draw_child(rng):
    age = rng.uniform(8, 15)
    year = min(14, int(age))
    height = CHILD_STATURE[year] * (1 + 0.045 * clipped_normal(rng))
    share = height / 1.42
    usual = 0.61 * share
    waist = CHILD_WAIST[year] * math.exp(0.105 * clipped_normal(rng) + 0.015)
    waist = min(max(waist, 0.86 * usual), 1.40 * usual)
    chest = 0.71 * share + 0.72 * (waist - usual) + 0.010 * clipped_normal(rng)
    hip = 0.75 * share + 0.89 * (waist - usual) + 0.012 * clipped_normal(rng)
    sex = 0.4 if age < 12 else rng.choice((0.1, 0.4, 0.7))
    return dict(sex=sex, age=age, height=height, chest=chest, waist=waist, hip=hip)


def draw_adult(rng):
    sex = rng.choice((0.0, 0.0, 0.0, 1.0, 1.0, 1.0, rng.random()))
    age = rng.uniform(16, 75)
    stature, build = clipped_normal(rng), clipped_normal(rng)
    body = dict(sex=sex, age=age)
    for name in ("height", "chest", "waist", "hip"):
        own = clipped_normal(rng)
        z = stature if name == "height" else 0.15 * stature + 0.90 * build + 0.40 * own
        mean, deviation = (a + sex * (b - a) for a, b in zip(WOMAN[name], MAN[name]))
        body[name] = mean + deviation * z
    body["waist"] += 0.001 * (age - 40)
    return body


def draw_body(rng):
    body = draw_child(rng) if rng.random() < 0.3 else draw_adult(rng)
    return {key: round(value, 3 if key != "age" else 1) for key, value in body.items()}


def draw_garment(rng, body):
    kind = rng.random()
    if kind < 0.12:  # of a size table: tight on some, wide on others
        near = [name for name, chest in SIZES.items()
                if -0.18 < 1.10 * chest / body["chest"] - 1 < 0.60
                and (name == "child-142") == (body["age"] < 15)]
        if near:
            return {"size": rng.choice(near)}
    if kind < 0.22:
        chest = rng.uniform(-0.30, -0.05)
    elif kind < 0.32:
        chest = rng.uniform(0.45, 1.00)
    else:
        chest = rng.uniform(-0.05, 0.45)
    fit = {"chest": chest, "hip": chest + rng.uniform(-0.08, 0.06),
           "sleeve": chest + rng.uniform(0.0, 0.12)}
    fit["wrist"] = fit["sleeve"] + rng.uniform(0.0, 0.12)
    if rng.random() < 0.35:
        fit["waist"] = chest + rng.uniform(-0.05, 0.10)
    return {"fit": {key: round(min(max(value, -0.30), 1.0), 3) for key, value in fit.items()}}


def draw_fabric(rng, garment, fabrics):
    """Tighter than the body by over 5 %: a fabric that can be stretched over it."""
    tight = garment.get("fit", {}).get("chest", 0) < -0.05
    return rng.choice(STRETCH if tight else fabrics)


def draw_posture(rng):
    kind = rng.random()
    if kind < 0.30:
        return "standing"
    if kind < 0.55:
        return rng.choice(("a-pose", "arms-forward", "arms-overhead", "forward-bend",
                           "forward-bend-15", "forward-bend-30", "forward-bend-45", "sitting",
                           "slouch"))
    if kind < 0.70:  # pinched armpits
        return {"arm_abduction_deg": round(rng.uniform(5, 18), 1)}
    if kind < 0.80:  # pinched groins
        return {"sitting": round(rng.uniform(0.4, 1.0), 2),
                "arm_abduction_deg": round(rng.uniform(12, 45), 1),
                "forward_bend_deg": round(rng.uniform(0, 30), 1)}
    if kind < 0.90:
        bend = round(rng.uniform(-10, 55), 1)
        return {"forward_bend_deg": bend, "arm_flexion_deg": round(max(bend, 0), 1),
                "arm_abduction_deg": round(rng.uniform(10, 40), 1)}
    return {"arm_flexion_deg": round(rng.uniform(20, 165), 1),
            "arm_abduction_deg": round(rng.uniform(10, 60), 1),
            "elbow_extension": round(rng.random(), 2)}


def draw_start(rng):
    kind = rng.random()
    if kind < 0.55:
        return {}
    if kind < 0.80:
        return {"start_perturbation": round(rng.uniform(0.001, 0.005), 4),
                "seed": rng.randrange(1, 10**6)}
    return {"shift": round(rng.uniform(0.005, 0.03), 3), "twist_deg": round(rng.uniform(2, 15), 1),
            "seed": rng.randrange(1, 10**6)}


def draw(seed, number, attempt=0, fabrics=FABRICS):
    """The case as a table of plain values. `attempt`: counts draws that named no body or shirt."""
    rng = random.Random(f"loosefit {seed} {number} {attempt}")
    case = {"body": draw_body(rng)}
    case["garment"] = draw_garment(rng, case["body"])
    case["fabric"] = draw_fabric(rng, case["garment"], fabrics)
    case["posture"] = draw_posture(rng)
    case["start"] = draw_start(rng)
    case["edge_mm"] = 14 if rng.random() < 0.15 else 20
    return case


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(v)}" for key, v in value.items()) + " }"
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"


def scenario(case, budget):
    """Its scenario; `budget`: wall seconds of each drape."""
    body, start = case["body"], case["start"]
    girths = {key: body[key] for key in ("chest", "waist", "hip")}
    lines = ["[body]", *(f"{key} = {body[key]:g}" for key in ("sex", "age", "height")),
             f"measurements = {toml(girths)}", f"posture = {toml(case['posture'])}", "[garment]",
             *(f"{key} = {toml(value)}" for key, value in case["garment"].items()), "[material]",
             f'name = "{case["fabric"]}"', "[simulation]",
             f"edge_length = {case['edge_mm'] / 1000:g}", f"time_budget = {budget:g}"]
    if "start_perturbation" in start:
        lines += [f"start_perturbation = {start['start_perturbation']}", f"seed = {start['seed']}"]
    if "shift" in start:  # put on straight, then once more askew: both have to settle
        lines += ["[donning]", "repeats = 2", f"seed = {start['seed']}", f"shift = {start['shift']}",
                  f"twist_deg = {start['twist_deg']}", "friction_spread = 0"]
    return "\n".join(lines) + "\n"


def in_words(case):
    body, garment, start = case["body"], case["garment"], case["start"]
    fit = garment.get("size") or f"chest {garment['fit']['chest']:+.2f}"
    posture = case["posture"]
    if isinstance(posture, dict):
        posture = " ".join(f"{key.removesuffix('_deg')} {value:g}" for key, value in posture.items())
    words = [f"age {body['age']:.0f} sex {body['sex']:.1f} {body['height']:.2f} m "
             f"{100 * body['chest']:.0f}/{100 * body['waist']:.0f}/{100 * body['hip']:.0f}",
             fit, case["fabric"], posture, f"{case['edge_mm']} mm"]
    if "shift" in start:
        words.append(f"askew {1000 * start['shift']:.0f} mm {start['twist_deg']:g} deg")
    elif start:
        words.append(f"perturbed {1000 * start['start_perturbation']:.1f} mm")
    return ", ".join(words)
