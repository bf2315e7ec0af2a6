#!/usr/bin/env python3
"""The JSON Schema of scenarios and the program agree: on every example, and on scenarios with one key changed.

usage: scenario_schema_test.py LOOSEFIT
"""
import json
import random
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from jsonschema import Draft202012Validator

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import schema_draw  # noqa: E402
from schema_draw import alternatives, document  # noqa: E402

LOOSEFIT = sys.argv[1]
ANY_TEXT, PATTERN_FILE = "any text", "own.json"  # both are files that exist


def scenarios_of(folder):
    """Files that are scenarios and not study files, which have a format of their own."""
    return [file for file in folder.glob("*.toml") if "study" not in tomllib.loads(file.read_text())]


def smallest(schema):
    """A value that the schema takes."""
    schema = alternatives(schema)[0]
    if "const" in schema:
        return schema["const"]
    if "enum" in schema:
        return schema["enum"][0]
    kind = schema["type"]
    if kind == "object":
        return {k: smallest(schema["properties"][k]) for k in schema.get("required", [])}
    if kind == "array":
        return [smallest(schema["items"]) for _ in range(schema.get("minItems", 0))]
    if kind == "boolean":
        return True
    if kind == "string":
        return PATTERN_FILE if "pattern" in schema else ANY_TEXT
    return schema.get("minimum", 0)


def wrong_values(schema):
    """Values that none of the alternatives takes, one of each sort."""
    forms = alternatives(schema)
    kinds = {"boolean" if "const" in f else f["type"] for f in forms}
    wrong = [] if "boolean" in kinds else [True]
    if kinds & {"number", "integer"}:
        top = max(f["maximum"] for f in forms if f["type"] in ("number", "integer") and "maximum" in f)
        low = min(f["minimum"] for f in forms if f["type"] in ("number", "integer") and "minimum" in f)
        wrong += [top + 1 + abs(top) * 1e-3, low - 1 - abs(low) * 1e-3]
    else:
        wrong.append(12345)
    if "string" not in kinds:
        wrong.append("seven")
    elif not any(f.get("type") == "string" and not ({"enum", "pattern"} & f.keys()) for f in forms):
        wrong.append("no-such-name")
    if "object" in kinds:
        wrong.append({"no_such_key": 1})
    else:
        wrong.append({})
    if "array" in kinds:
        array = next(f for f in forms if f["type"] == "array")
        wrong += [[value] for value in wrong_values(array["items"])[:2]]
        if array.get("minItems", 0) > 1:
            wrong.append([smallest(array["items"])])
    else:
        wrong.append([])
    if kinds == {"integer"}:
        wrong.append(forms[0]["minimum"] + 0.5)
    return wrong


def keys_of(schema, way=()):
    """Every key with the path to it (a list item counts as the step 0), its schema, and a scenario that
    has the tables on the way."""
    for form in alternatives(schema):
        if form.get("type") == "array" and alternatives(form["items"])[0].get("type") == "object":
            for item in alternatives(form["items"]):
                yield from keys_of(item, way + (0,))
        if form.get("type") != "object":
            continue
        for key, below in form["properties"].items():
            yield way + ((form, key),), below
            yield from keys_of(below, way + ((form, key),))


def scenario_with(way, value):
    """The smallest scenario that has this value at this place."""
    for step in reversed(way):
        if step == 0:
            value = [value]
            continue
        form, key = step
        table = {k: smallest(form["properties"][k]) for k in form.get("required", []) if k != key}
        for other in form.get("dependentRequired", {}).get(key, []):
            table.setdefault(other, smallest(form["properties"][other]))
        # What makes the table this alternative of several.
        table[key] = value
        value = table
    return value


def accepted_by_program(scenarios):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name in (ANY_TEXT, PATTERN_FILE):
            (Path(folder) / name).touch()
        for i, scenario in enumerate(scenarios):
            files.append(Path(folder) / f"{i}.toml")
            files[-1].write_text(document(scenario))
        answer = []
        for start in range(0, len(files), 500):
            run = subprocess.run([LOOSEFIT, "schema", "--json", "--check", *files[start:start + 500]],
                                 stdout=subprocess.PIPE, text=True)
            assert run.returncode in (0, 2), run.returncode
            answer += json.loads(run.stdout)["scenarios"]
        return answer


def main():
    schema = json.loads(subprocess.run([LOOSEFIT, "schema"], stdout=subprocess.PIPE, text=True, check=True).stdout)
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    failures = []

    for file in sorted(scenarios_of(ROOT / "examples")) + sorted((ROOT / "validation").rglob("case*.toml")):
        for error in validator.iter_errors(tomllib.loads(file.read_text())):
            failures.append(f"{file}: {error.message[:200]}")

    keys = list(keys_of(schema))
    assert len(keys) > 150, len(keys)
    for way, below in keys:
        if "description" not in below:
            failures.append("no description: " + ".".join(s[1] for s in way if s))

    # Every key once, then as many again by chance: a wrong value, or a key that nobody knows.
    chance = random.Random(20261124)
    changed = []
    for way, below in keys + chance.sample(keys, len(keys) // 2):
        wrong = wrong_values(below)
        changed.append((way, scenario_with(way, chance.choice(wrong))))
    for way, below in chance.sample(keys, 60):
        form, key = way[-1]
        changed.append((way, scenario_with(way[:-1] + ((form, key + "_"),), 1)))
    scenarios = [scenario for _, scenario in changed]
    for (way, scenario), answer in zip(changed, accepted_by_program(scenarios)):
        here = validator.is_valid(tomllib.loads(document(scenario)))
        if here or answer["accepted"]:
            failures.append(f"taken by {'the schema' if here else ''} {'the program' if answer['accepted'] else ''}: "
                            + document(scenario))

    # Values that the schema takes, at the ends of their ranges.
    good = []
    for way, below in keys:
        for form in alternatives(below):
            if form.get("type") in ("number", "integer"):
                for end in ("minimum", "maximum"):
                    if end in form:
                        good.append(scenario_with(way, form[end]))
            for text in form.get("enum", [])[:3]:
                good.append(scenario_with(way, text))
            if form.get("type") == "boolean":
                good += [scenario_with(way, False), scenario_with(way, True)]
    agreed = 0
    for scenario, answer in zip(good, accepted_by_program(good)):
        here = validator.is_valid(tomllib.loads(document(scenario)))
        if not here:
            failures.append("refused by the schema: " + document(scenario))
        elif answer["accepted"]:
            agreed += 1
        elif not beyond_the_schema(answer["error"]):
            failures.append("refused by the program: " + document(scenario) + answer["error"]["message"])
    # Every number at its limits, a hair and a whole share beyond, and where it may be: one answer of both.
    limits = []
    for way, below in keys:
        for form in alternatives(below):
            if form.get("type") not in ("number", "integer"):
                continue
            low, high = form["minimum"], form["maximum"]
            whole = form["type"] == "integer"
            beyond = (1 if whole else 1e-9 * max(abs(low), 1e-12), 1 if whole else 1e-9 * max(abs(high), 1e-12))
            share = chance.random()
            inner = low + share * (high - low) if low <= 0 else low * (high / low) ** share
            limits += [(way, v) for v in (low - beyond[0], high + beyond[1], round(inner) if whole else inner)]
    scenarios = [scenario_with(way, value) for way, value in limits]
    for (way, value), scenario, answer in zip(limits, scenarios, accepted_by_program(scenarios)):
        here = validator.is_valid(tomllib.loads(document(scenario)))
        if here != answer["accepted"] and not (here and beyond_the_schema(answer["error"])):
            failures.append(f"taken by {'the schema' if here else 'the program'} alone: " + document(scenario))

    # Whole scenarios, drawn from the schema: what it takes the program takes, but for what is beyond it.
    drawn = [schema_draw.draw(61, case, schema) for case in range(300)]
    told_beyond = 0
    for scenario, answer in zip(drawn, accepted_by_program(drawn)):
        here = validator.is_valid(tomllib.loads(document(scenario)))
        told_beyond += here and not answer["accepted"]
        if not here and answer["accepted"]:
            failures.append("taken by the program alone: " + document(scenario))
    print(f"{len(limits)} numbers at and beyond their limits; of {len(drawn)} drawn scenarios {told_beyond} refused "
          "for what the schema does not say")
    print(f"{len(keys)} keys, {len(changed)} changed scenarios refused by both, {agreed} of {len(good)} taken by both")
    for failure in failures[:40]:
        print("FAILED", failure)
    return 1 if failures else 0


def beyond_the_schema(error):
    """What the schema does not claim to say: files, the physics of several constants, other sections."""
    message = error["message"]
    return error["place"]["key"] == "postures.reference" or any(words in message for words in (
        "a file that exists", "E h from", "which is kes.", "a slope from", "every point"))


if __name__ == "__main__":
    sys.exit(main())
