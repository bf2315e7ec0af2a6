#!/usr/bin/env python3
"""Write docs/scenario-keys.md from the schema of scenarios, which is made of their readers.

usage: scenario_keys.py --binary build/bin/loosefit [--check]
  --check   write nothing; exit code 1 when the page is not what the schema says
"""
import argparse
import json
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "scenario-keys.md"
GUIDE = PAGE.parent / "scenario.md"
HEAD = f"""# Keys of a scenario

Every key with its type, range, unit, default and meaning. This page is written by `tools/scenario_keys.py` from `loosefit schema`, which is
made of the readers of scenarios; a test compares the two. [{GUIDE.name}]({GUIDE.name}) explains them with examples. A table that can be
written in several ways (a person or a scan, a drafted garment or a file) lists the keys of all of them together.
"""


def number(value):
    return f"{value:g}" if abs(value) < 1e9 else f"{value:.0e}"


def kind(schema):
    """What a value may be, in words."""
    if "anyOf" in schema:
        kinds = []
        for option in schema["anyOf"]:
            word = kind(option)
            if word not in kinds:
                kinds.append(word)
        return " or ".join(kinds)
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    if "enum" in schema:
        return ", ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
    of = schema.get("type", "")
    if of == "array":
        low, high = schema.get("minItems"), schema.get("maxItems")
        count = "" if low is None and high is None else (
            f"{low} " if low == high else f"{low or 0} or more " if high is None
            else f"{low or 0} to {high} ")
        item = kind(schema["items"]) if "items" in schema else ""
        return f"list of {count}{item}".strip() if item else "list"
    if of == "object":
        return "table"
    if of == "string":
        return "text"
    if of == "boolean":
        return "`true`, `false`"
    low = schema.get("minimum", schema.get("exclusiveMinimum"))
    high = schema.get("maximum", schema.get("exclusiveMaximum"))
    word = "whole number" if of == "integer" else "number"
    if low is not None and high is not None:
        word += f" {number(low)} … {number(high)}"
    elif low is not None:
        word += f" from {number(low)}"
    elif high is not None:
        word += f" up to {number(high)}"
    return word


def merged(schemas):
    """One schema of several ways to write a key."""
    different = []
    for schema in schemas:
        if schema not in different:
            different.append(schema)
    if len(different) == 1:
        return different[0]
    one = {"anyOf": different}
    for key in ("description", "unit", "default"):
        values = []
        for schema in different:
            if key in schema and schema[key] not in values:
                values.append(schema[key])
        if values and (key != "default" or len(values) == 1):
            one[key] = "; ".join(map(str, values)) if key != "default" else values[0]
    return one


def tables(schema):
    """The objects that a value may be, however deep they stand among its options."""
    if schema.get("type") == "object" and "properties" in schema:
        return [schema]
    return [table for option in schema.get("anyOf", []) for table in tables(option)]


def keys_of(schema):
    """Name of a key → schema, of all tables that a value may be."""
    found = {}
    for table in tables(schema):
        for name, value in table["properties"].items():
            found.setdefault(name, []).append(value)
    return {name: merged(values) for name, values in found.items()}


def unit(schema):
    """Unit of a value, or of the numbers in a list."""
    if "unit" in schema:
        return schema["unit"]
    inner = schema.get("anyOf", []) + ([schema["items"]] if schema.get("type") == "array" and "items" in schema else [])
    return "; ".join(dict.fromkeys(found for found in map(unit, inner) if found))


def text(value):
    return str(value).replace("|", "\\|").replace("\n", " ")


def lines(title, schema, out):
    """A table of keys, then the tables in it."""
    out.append(f"\n## {title}\n")
    if schema.get("description"):
        out.append(schema["description"][0].upper() + schema["description"][1:] + ".\n")
    out.append("| key | value | unit | default | meaning |\n|---|---|---|---|---|")
    inner = []
    for name, value in keys_of(schema).items():
        default = f"`{json.dumps(value['default'], ensure_ascii=False)}`" if "default" in value else ""
        out.append(f"| `{name}` | {text(kind(value))} | {text(unit(value))} | {text(default)} | "
                   f"{text(value.get('description', ''))} |")
        listed = value.get("items", {}) if value.get("type") == "array" else value
        if keys_of(listed):
            inner.append((name, {**listed, "description": value.get("description", "")}))
    plain = title.strip("[]")
    for name, value in inner:
        lines(f"{plain}.{name}", value, out)


def page(schema):
    out = [HEAD]
    for name, section in schema["properties"].items():
        listed = section.get("type") == "array"
        entry = {**section["items"], "description": section.get("description", "")} if listed else section
        lines(f"[[{name}]]" if listed else f"[{name}]", entry, out)
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--binary", required=True)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    schema = json.loads(subprocess.run([arguments.binary, "schema"], check=True,
                                       stdout=subprocess.PIPE).stdout)
    written = page(schema)
    if not arguments.check:
        PAGE.write_text(written, encoding="utf-8")
        return 0
    if PAGE.is_file() and PAGE.read_text(encoding="utf-8") == written:
        return 0
    print(f"error: {PAGE}: found another page than the schema makes\n"
          f"hint: tools/scenario_keys.py --binary {arguments.binary}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
