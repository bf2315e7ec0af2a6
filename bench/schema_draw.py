"""Draws scenarios from the JSON Schema that `loosefit schema` prints: every key, range and choice that the program
declares, so that a new key is drawn without a change here.

Two thirds of the draws change a few values of an everyday case, which then mostly drapes; the others take every key
by chance, which is mostly refused. Values lie near the default, anywhere in the range (by magnitude where it spans
more than two decades), or at its ends. Texts that are free are names, some of which are hard on the files that
carry them.
"""
import json
import math
import random
import re

#: Panels of drafted garments, so that some attachments and sites find their piece.
PANELS = ("front", "back", "front", "back", "sleeve_L_front", "front_L", "back_R", "hem_band_front")
NAMES = ("wrist", "left arm", "=1+1", "@SUM(A1)", "-2+3", "<script>alert(1)</script>", "a\"b'c", "]]>", "javascript:1",
         "\u202egnp.exe", "a,b;c", "\u00fc\u00df \u4e2d", "x" * 120, "tab\there", "..", "/etc")
#: Texts for the patterns of the schema: postures, edges, pieces, files that are not there.
EXAMPLES = ("standing", "sitting", "arms-forward", "elbow-flexion-90", "front.hem", "back.neck", "front", "back", "own.json",
            "own.toml", "own.svg", "own.obj", "elbow_L")
#: Keys that the harness sets: mesh, time and pictures are a matter of the machine.
FIXED = {("simulation", "edge_length"), ("simulation", "time_budget"), ("simulation", "threads"),
         ("simulation", "max_iterations"), ("output", "width"), ("output", "height"), ("output", "views"),
         ("simulation", "integrator")}
#: Sections that multiply the drapes of a case; taken seldom.
DEAR = ("postures", "donning", "under")
MOST_ITEMS = 2  # of a list that the schema leaves open


def toml(value):
    """A value as inline TOML; JSON is a good start for everything but tables."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    return json.dumps(value)


def document(value):
    return "".join(f"{json.dumps(k)} = {toml(v)}\n" for k, v in value.items())


def alternatives(schema):
    return schema.get("anyOf", [schema])


def number(rng, schema, usual):
    low, high = schema.get("minimum", -1e3), schema.get("maximum", 1e3)
    kind = rng.random()
    if isinstance(usual, (int, float)) and not isinstance(usual, bool) and kind < 0.5:
        value = usual * math.exp(rng.gauss(0, 0.3)) + (0 if usual else 0.02 * rng.gauss(0, 1) * (high - low))
    elif kind < 0.6:
        value = rng.choice((low, high))
    elif low > 0 and high / low > 100:
        value = math.exp(rng.uniform(math.log(low), math.log(high)))
    else:
        value = rng.uniform(low, high)
    value = min(max(value, low), high)
    return round(value) if schema["type"] == "integer" else float(f"{value:.4g}") if low < value < high else value


def text(rng, schema, key):
    if "enum" in schema:
        return rng.choice(schema["enum"])
    if key == "panel":
        return rng.choice(PANELS)
    if "pattern" in schema:
        return next(example for example in rng.sample(EXAMPLES, len(EXAMPLES)) if re.search(schema["pattern"], example))
    return rng.choice(NAMES)


def array(rng, schema, key, chance):
    if key in ("at", "shift") and rng.random() < 0.8:  # somewhere on a piece, mostly
        return [round(rng.gauss(0, 0.12), 3) for _ in range(2)]
    least, most = schema.get("minItems", 0), schema.get("maxItems", MOST_ITEMS)
    count = rng.randint(least, max(least, min(most, MOST_ITEMS)))
    items = [value(rng, schema["items"], key, chance) for _ in range(count)]
    if schema.get("uniqueItems"):
        items = [item for i, item in enumerate(items) if item not in items[:i]]
    return items


def table(rng, schema, chance, way=()):
    drawn = {}
    for key, below in schema["properties"].items():
        if way + (key,) in FIXED:
            continue
        share = chance * (0.4 if not way and key in DEAR else 1)
        if key in schema.get("required", []) or rng.random() < share:
            drawn[key] = value(rng, below, key, chance, way + (key,))
    for key, others in schema.get("dependentRequired", {}).items():
        for other in others if key in drawn else ():
            if other not in drawn:
                drawn[other] = value(rng, schema["properties"][other], other, chance, way + (other,))
    for both in schema.get("allOf", []):
        first, second = both["not"]["required"]
        if first in drawn and second in drawn:
            del drawn[rng.choice([key for key in (first, second) if key not in schema.get("required", [])] or [second])]
    return drawn


def value(rng, schema, key, chance, way=()):
    forms = alternatives(schema)
    if len(forms) > 1 and rng.random() < 0.9:  # a file that is not there is soon told
        forms = [form for form in forms if "toml" not in form.get("pattern", "")] or forms
    form = rng.choice(forms)
    if "const" in form:
        return form["const"]
    kind = form["type"]
    if kind == "object":
        return table(rng, form, chance, way)
    if kind == "array":
        return array(rng, form, key, chance)
    if kind == "boolean":
        return rng.random() < 0.5
    if kind == "string":
        return text(rng, form, key)
    return number(rng, form, schema.get("default"))


def everyday(rng, schema):
    """A drafted garment on an adult in a fabric of ours, in which a few values are others."""
    forms = [form for form in alternatives(schema["properties"]["garment"])
             if "enum" in form["properties"]["pattern"] or "const" in form["properties"]["pattern"]]
    garment = rng.choice(forms)
    case = {"body": {"sex": rng.choice(("female", "male")), "age": rng.randint(18, 70), "height": round(rng.uniform(1.5, 1.95), 2)},
            "garment": {"pattern": text(rng, garment["properties"]["pattern"], "pattern")}}
    for _ in range(rng.randint(1, 4)):
        section = rng.choice([name for name in schema["properties"] if name not in DEAR or rng.random() < 0.3])
        forms = alternatives(schema["properties"][section])
        form = garment if section == "garment" else forms[0]
        if form["type"] == "array":
            case[section] = [value(rng, form["items"], section, 0.1)]
            continue
        keys = [key for key in form["properties"] if (section, key) not in FIXED and key not in ("file", "kes", "curve")]
        key = rng.choice(keys)
        if key in ("pattern",) and section == "garment":
            continue
        case.setdefault(section, {})[key] = value(rng, form["properties"][key], key, 0.3, (section, key))
    return case


def with_few_drapes(case):
    """Repeats and postures are the same work over and over: a few of them stand for many."""
    for section in ("simulation", "donning"):
        if isinstance(case.get(section, {}).get("repeats"), int):
            case[section]["repeats"] = 1 + case[section]["repeats"] % 3
    sweep = case.get("postures", {}).get("sweep") if isinstance(case.get("postures"), dict) else None
    if isinstance(sweep, dict) and all(isinstance(sweep.get(key), (int, float)) for key in ("from", "to", "step")):
        sweep["step"] = round(max(sweep["step"], abs(sweep["to"] - sweep["from"]) / 3), 2)
    return case


def draw(seed, case, schema):
    """Case number `case` of a seed, as plain values. The same for the same schema."""
    rng = random.Random(f"schema {seed} {case}")
    drawn = everyday(rng, schema) if rng.random() < 2 / 3 else table(rng, schema, rng.choice((0.05, 0.15, 0.4)))
    return with_few_drapes(drawn)


def scenario(drawn, edge, budget):
    """Text of a drawn case with this edge length [m] and wall seconds of each drape."""
    whole = dict(drawn)
    whole["simulation"] = dict(drawn.get("simulation", {}), edge_length=edge, time_budget=budget, threads=1)
    whole["output"] = dict(drawn.get("output", {}), views=["front"])
    return document(whole)
