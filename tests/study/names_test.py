#!/usr/bin/env python3
"""Names that people give reach every file of a study and of a run as text: no page runs them, no spreadsheet computes
them, no terminal or reader is turned by them.

usage: names_test.py BINARY [--seed S]
"""
import argparse
import csv
import html.parser
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unicodedata

PARTS = ["<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "' onmouseover='alert(1)", "]]>", "-->", "</style>",
         "javascript:alert(1)", "&lt;", "=1+1", "@SUM(A1)", "+cmd|'/C calc'!A0", "-2+3", "\u202e", "\u061c", "\u2066", "\u200b",
         "\x1b[31m", "\t", ";", ",", "\"", "ü", "中"]
SIGNS = "=+-@\t\r＝＋－＠"


def drawn_name(rng):
    return "".join(rng.sample(PARTS, rng.randint(1, 4)))


class Page(html.parser.HTMLParser):
    """What a browser would run that a name has brought."""

    def __init__(self):
        super().__init__()
        self.found, self.within_script = [], False

    def handle_starttag(self, tag, attributes):
        self.within_script = tag == "script"
        for key, value in attributes:
            if key.startswith("on") or (value or "").strip().lower().startswith("javascript:"):
                self.found.append((tag, key, value))
            if tag == "img" and key == "src" and value == "x":
                self.found.append((tag, key, value))

    def handle_endtag(self, tag):
        self.within_script = False

    def handle_data(self, data):
        # Data for the page's own script are JSON and base64; a script of a name is bare.
        if self.within_script and data.strip().startswith("alert("):
            self.found.append(("script", data[:40]))


def turning(text):
    """Control and format characters of a text, line ends apart."""
    return sorted({f"U+{ord(c):04X}" for c in text if unicodedata.category(c) in ("Cc", "Cf") and c not in "\n\r\u00ad"})


def is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def formulas(path):
    with path.open(newline="", encoding="utf-8") as file:
        return [cell for row in csv.reader(file) for cell in row
                if cell.lstrip(" ")[:1] and cell.lstrip(" ")[0] in SIGNS and not is_number(cell)]


def check(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".html":
        text = text.replace("\t", " ")  # of no effect there
    failures = [f"{path.name}: raw {turning(text)}"] if turning(text) else []
    if path.suffix == ".html":
        page = Page()
        page.feed(text)
        failures += [f"{path.name}: runs {found}" for found in page.found]
    if path.suffix == ".csv":
        failures += [f"{path.name}: computes {cell!r}" for cell in formulas(path)]
    return failures


def write_inputs(folder, rng):
    text = json.dumps  # a JSON string is a TOML string
    names = {}
    while len(names) < 3:
        names[drawn_name(rng)] = None
    names = list(names)
    (folder / "base.toml").write_text(
        "[garment]\npattern = \"tank-top\"\n[donning]\nmovements = []\n[simulation]\nedge_length = 0.05\n"
        "max_iterations = 2\n[output]\nviews = [\"front\"]\n"
        + "".join(f"[[site]]\nname = {text(name)}\nlandmark = \"{place}\"\n"
                  for name, place in zip(names, ("c7", "xiphoid", "mid_back"))))
    people = folder / "people.csv"
    with people.open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([["name", "height", "sex"], ["'=HYPERLINK(1)", "1.7", "female"], [names[0].strip(), "1.75", "male"]])
    (folder / "study.toml").write_text(
        f"[study]\nname = {text(drawn_name(rng))}\nbase = \"base.toml\"\nmodalities = [\"pressure\"]\n"
        f"[[axis]]\nname = {text('p' + drawn_name(rng))}\npeople = {{ file = \"people.csv\" }}\n"
        f"[[axis]]\nname = {text('f' + drawn_name(rng))}\nlevels = [\n"
        f"  {{ label = {text(names[1])}, value = 1, set = {{ material = {{ name = \"cotton-jersey\" }} }} }},\n"
        f"  {{ label = {text(names[2])}, value = 2, set = {{ material = {{ name = \"paper-cotton\" }} }} }},\n]\n")
    return names


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("--seed", type=int, default=21)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    binary = pathlib.Path(options.binary).resolve()
    failures, looked = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        names = write_inputs(folder, rng)

        def loosefit(*arguments, good=(0, 1)):
            run = subprocess.run([binary, *arguments], cwd=folder, capture_output=True, timeout=300)
            for stream in (run.stdout, run.stderr):
                if turning(stream.decode()):
                    failures.append(f"{arguments}: says raw {turning(stream.decode())}")
            if run.returncode not in good:
                failures.append(f"{arguments}: exit code {run.returncode}: {run.stderr.decode()[:300]}")
            return run.stdout.decode()
        loosefit("run", "base.toml", "-o", "run", "--allow-unsettled", "--no-pictures")
        loosefit("study", "run", "study.toml", "-o", "study", "-q")
        loosefit("study", "export", "study", "-o", "tables")
        loosefit("study", "status", "study", "--json")
        for part in ("run", "study", "tables"):
            for path in sorted((folder / part).rglob("*")):
                if path.suffix in (".html", ".json", ".jsonl", ".csv", ".svg", ".toml", ".dxf") and path.name != "study.toml":
                    looked += 1
                    failures += check(path)
        sites = json.loads((folder / "run/summary.json").read_text()).get("sites", {})
        for name in names:
            if sites and name not in sites:
                failures.append(f"summary.json: {name!r} is not told as it is")
    print(f"{looked} files")
    for failure in failures[:40]:
        print("FAILED", failure)
    return 1 if failures or looked < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
