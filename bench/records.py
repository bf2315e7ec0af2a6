"""Reads and writes records of measurements: JSON with one line a case, or CSV for robustness studies.

A JSON record is plain JSON for any reader; only its lines are chosen, so that a file is short and
differences can be read. A CSV record holds one row a case of `robustness.py`; its first line is a
comment with everything else as JSON. The draw of a case is not stored: it follows from the seed, the
number and how many draws were refused before it (robustness_draw.py), with the list of fabrics that
the record names; a digest tells when the program has come to draw other cases.
"""
import csv
import hashlib
import io
import json
import pathlib

import robustness_draw

CASE_COLUMNS = ["case", "redrawn"]


def compact(value):
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def json_lines(value, depth=2):
    """JSON text of a table with a line for every entry down to `depth`, and lists of tables likewise."""
    if depth and isinstance(value, dict) and value:
        body = ",\n".join(f"{compact(key)}:{json_lines(entry, depth - 1)}" for key, entry in value.items())
        return "{\n" + body + "\n}"
    if depth and isinstance(value, list) and value and all(isinstance(v, dict) for v in value):
        return "[\n" + ",\n".join(map(compact, value)) + "\n]"
    return compact(value)


def cell(value):
    """Text of a value in a CSV file: JSON, but strings that JSON would not read are bare."""
    if isinstance(value, str):
        try:
            json.loads(value)
        except ValueError:
            return value if value else '""'
    return compact(value)


def value_of(text):
    try:
        return json.loads(text)
    except ValueError:
        return text


def case_number(name):
    return int(name.rpartition("-")[2])


def draws_of(seed, cases, fabrics):
    """Draw of each case, in order."""
    return [robustness_draw.draw(seed, case_number(name), len(entry["redrawn"]), fabrics)
            for name, entry in cases.items()]


def digest(draws):
    return hashlib.sha256(compact(draws).encode()).hexdigest()[:16]


def csv_text(record):
    cases = record["cases"]
    head = {key: value for key, value in record.items() if key != "cases"}
    head["fabrics"] = record.get("fabrics", robustness_draw.FABRICS)
    draws = draws_of(record["seed"], cases, head["fabrics"])
    for name, entry, draw in zip(cases, cases.values(), draws):
        if entry.get("draw") != draw or entry["groups"] != ["robustness"] or len(entry["runs"]) != 1:
            raise ValueError(f"{name}: not a case of seed {record['seed']}")
    head["draws"] = digest(draws)
    columns = list(dict.fromkeys(key for entry in cases.values() for key in entry["runs"][0]))
    out = io.StringIO()
    out.write("# " + compact(head) + "\n")
    rows = csv.writer(out, lineterminator="\n")
    rows.writerow(CASE_COLUMNS + columns)
    for name, entry in cases.items():
        run = entry["runs"][0]
        rows.writerow([name, compact(entry["redrawn"]) if entry["redrawn"] else ""] +
                      [cell(run[key]) if key in run else "" for key in columns])
    return out.getvalue()


def read_csv(text):
    first, _, table = text.partition("\n")
    if not first.startswith("# {"):
        raise ValueError("found no comment with the record's data in line 1")
    record = json.loads(first[2:])
    wanted = record.pop("draws", None)
    rows = list(csv.reader(io.StringIO(table)))
    columns = rows[0][len(CASE_COLUMNS):] if rows else []
    cases = {}
    for row in rows[1:]:
        run = {key: value_of(text) for key, text in zip(columns, row[len(CASE_COLUMNS):]) if text}
        cases[row[0]] = {"groups": ["robustness"], "redrawn": json.loads(row[1] or "[]"), "runs": [run]}
    draws = draws_of(record["seed"], cases, record["fabrics"])
    if digest(draws) == wanted:  # otherwise these were other cases: the figures stay, unnamed
        for entry, draw in zip(cases.values(), draws):
            entry["draw"] = draw
    return record | {"cases": cases}


def read(path):
    """The record in a file. OSError, or ValueError for a file that holds none."""
    path = pathlib.Path(path)
    text = path.read_text()
    record = read_csv(text) if path.suffix == ".csv" else json.loads(text)
    if not isinstance(record, dict):
        raise ValueError("found no record")
    return record


def write(path, record):
    """All of it or nothing; the form follows from the ending."""
    path = pathlib.Path(path)
    text = csv_text(record) if path.suffix == ".csv" else json_lines(record) + "\n"
    temporary = path.with_name("." + path.name)
    temporary.write_text(text)
    temporary.replace(path)
