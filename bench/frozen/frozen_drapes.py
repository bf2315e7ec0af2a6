#!/usr/bin/env python3
"""Freezes drapes, and tells whether a changed program still makes the same.

    frozen_drapes.py record FILE [--binary B] [--cases NAME ...]   runs the cases, writes FILE
    frozen_drapes.py check FILE [--binary B] [--cases NAME ...]    runs them and compares

A record holds the SHA-256 of every drape.vtp of a run and all numbers of its summary.json but
seconds and memory. Bits are those of one machine and compiler: record with the old program and
check with the new one on the same machine. Exit code 1 when something differs.
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

import frozen_cases

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# What a summary says of the machine, the day or the program, and not of the drape.
NOT_OF_THE_DRAPE = {"seconds", "peak_memory_mb", "versions", "scenario_sha256"}


def leaves(value, path=""):
    """Numbers, words and flags of a JSON value by their path."""
    if isinstance(value, dict):
        for key, child in value.items():
            if key not in NOT_OF_THE_DRAPE:
                yield from leaves(child, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for i, child in enumerate(value):
            yield from leaves(child, f"{path}[{i}]")
    else:
        yield path, value


def run_case(binary, name, text, folder, body):
    patterns = ROOT / "examples" / "patterns"
    scenario = folder / f"{name}.toml"
    scenario.write_text(text.replace("{body}", str(body)).replace("{patterns}", str(patterns)))
    out = folder / name
    made = subprocess.run([binary, "run", scenario, "-o", out, "--no-pictures"],
                          capture_output=True, text=True)
    if not (out / "summary.json").exists():
        return {"error": made.stderr.strip().replace(str(folder), "")}
    drapes = {str(p.relative_to(out)): hashlib.sha256(p.read_bytes()).hexdigest()
              for p in sorted(out.rglob("drape.vtp"))}
    return {"drapes": drapes, "summary": dict(leaves(json.loads((out / "summary.json").read_text())))}


def is_timed(path):
    """Counters of seconds inside a summary, at whatever depth."""
    return "seconds" in path


def differences(old, new):
    for path in sorted(old.get("drapes", {}).keys() | new.get("drapes", {}).keys()):
        if old.get("drapes", {}).get(path) != new.get("drapes", {}).get(path):
            yield f"other bits: {path}"
    a, b = old.get("summary", {}), new.get("summary", {})
    for path in sorted(a.keys() | b.keys()):
        if not is_timed(path) and a.get(path) != b.get(path):
            yield f"{path}: {a.get(path)} -> {b.get(path)}"
    if old.get("error") != new.get("error"):
        yield f"error: {old.get('error')} -> {new.get('error')}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["record", "check"])
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--binary", default=str(ROOT / "build" / "bin" / "loosefit"))
    parser.add_argument("--cases", nargs="*", default=None)
    args = parser.parse_args()
    chosen = {n: t for n, t in frozen_cases.cases().items() if not args.cases or n in args.cases}
    record = json.loads(args.file.read_text()) if args.action == "check" else {}
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        body = folder / "woman"
        w = frozen_cases.WOMAN
        subprocess.run([args.binary, "body", "--sex", str(w["sex"]), "--age", str(w["age"]),
                        "--height", str(w["height"]), "--chest", str(w["chest"]), "--waist",
                        str(w["waist"]), "--hip", str(w["hip"]), "-o", body],
                       check=True, capture_output=True)
        mesh = next(p for p in sorted(body.rglob("*")) if p.suffix in (".obj", ".ply"))
        for name, text in chosen.items():
            made = run_case(args.binary, name, text, folder, mesh)
            if args.action == "record":
                record[name] = made
                print(name, made.get("error") or f"{len(made['drapes'])} drapes", flush=True)
                continue
            found = list(differences(record.get(name, {}), made))
            failed += bool(found)
            print(name, "same" if not found else f"{len(found)} differences", flush=True)
            for line in found[-20:]:
                print("   ", line)
    if args.action == "record":
        args.file.write_text(json.dumps(record, separators=(",", ":")) + "\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
