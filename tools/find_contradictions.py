#!/usr/bin/env python3
"""Finds what the files of one run say twice and differently.

usage: find_contradictions.py RUN_FOLDER [RUN_FOLDER ...]

Reads report.html, summary.json, sites.csv, ranking-*.csv, ranking-*.json and every drape.vtp of an
output, collects each number with what it is of (quantity, place, sensor), and prints a table of those
that have two values. Numbers of the report count as equal to within their last digit. Exit code 1 when
the table has a row.
"""
import collections
import csv
import html.parser
import json
import math
import pathlib
import re
import struct
import sys
import zlib

# What identifies a place in CSV rows and is no quantity of it.
PLACE_COLUMNS = {"rank", "name", "panel", "region", "footprint", "covered", "why_not_covered", "kind",
                 "tied_with", "limiting_metric", "limiting_reason", "limiting_sample"}
# Of a ranking, not of a sensor at a place.
RANKING_COLUMNS = re.compile(r"^(rank|robust|median)_(low|high)$|^(score_|passing$|tolerance_|to_)")


class Facts:
    """Values by what they are of."""

    def __init__(self):
        self.values = collections.defaultdict(list)  # key -> [(value, slack, source)]

    def add(self, key, value, source, slack=0.0):
        if isinstance(value, bool) or value is None:
            return
        try:
            number = float(value)
        except (TypeError, ValueError):
            return
        if math.isfinite(number):
            self.values[key].append((number, slack, source))

    def contradictions(self):
        rows = []
        for key, told in sorted(self.values.items(), key=lambda entry: str(entry[0])):
            least, most = min(told), max(told)
            room = least[1] + most[1] + 1e-7 * max(1.0, abs(least[0]))
            if most[0] - least[0] > room:
                rows.append((key, least, most))
        return rows

    def shared(self):
        """How many things are told more than once, by different files."""
        return sum(len({source for _, _, source in told}) > 1 for told in self.values.values())


def footprint_words(shape):
    def millimetres(metres):
        return f"{round(1000 * metres, 1):g}"
    if "radius_m" in shape:
        return f"disc of {millimetres(2 * shape['radius_m'])} mm"
    if "size_m" in shape:
        return f"{millimetres(shape['size_m'][0])} x {millimetres(shape['size_m'][1])} mm"
    if "length_m" in shape:
        return f"line of {millimetres(shape['length_m'])} mm"
    return "girth"


def median(values):
    known = sorted(v for v in values if v is not None and math.isfinite(v))
    if not known:
        return None
    middle = len(known) // 2
    return known[middle] if len(known) % 2 else (known[middle - 1] + known[middle]) / 2


class Sites:
    """Keys of what is said of a sensor: its place and footprint."""

    @staticmethod
    def key(name, footprint, quantity):
        return ("site", name.replace("_", " "), footprint, quantity)


def read_summary(folder, facts):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    skipped = {"panel", "position_m", "region", "body_address", "covered", "why_not_covered",
               "footprint", "by_donning"}
    for name, site in summary.get("sites", {}).items():
        words = footprint_words(site["footprint"])
        for quantity, value in site.items():
            if quantity not in skipped:
                facts.add(Sites.key(name, words, quantity), value, "summary.json sites")
        for quantity, values in site.get("by_donning", {}).items():
            facts.add(Sites.key(name, words, quantity), median(values), "summary.json by_donning")
            for k, value in enumerate(values):
                facts.add(("donning", k, *Sites.key(name, words, quantity)), value,
                          "summary.json by_donning")
    for array, entry in summary.get("maps", {}).items():
        for statistic in ("min", "p5", "median", "p95", "max", "area_mean"):
            facts.add(("map", array, statistic), entry.get(statistic), "summary.json maps")
        for region, own in entry.get("regions", {}).items():
            facts.add(("region", region, array), own["median"], "summary.json maps")
    for answer in summary.get("answers", []):
        expected = answer.get("expected")
        site = summary.get("sites", {}).get(answer["site"])
        if expected and site and answer["asked"]:
            facts.add(Sites.key(answer["site"], footprint_words(site["footprint"]), expected["metric"]),
                      expected["median"], "summary.json answers")
    return summary


def read_sites(folder, facts):
    file = folder / "sites.csv"
    if not file.exists():
        return
    with file.open(newline="", encoding="utf-8") as stream:
        for row in csv.DictReader(stream):
            for quantity, value in row.items():
                if quantity not in PLACE_COLUMNS and value:
                    facts.add(Sites.key(row["name"], row["footprint"], quantity), value, "sites.csv",
                              1e-7)


def read_rankings(folder, facts):
    for file in sorted(folder.glob("ranking-*.csv")):
        with file.open(newline="", encoding="utf-8") as stream:
            for row in csv.DictReader(stream):
                for quantity, value in row.items():
                    if quantity in PLACE_COLUMNS or not value:
                        continue
                    key = Sites.key(row["name"], row["footprint"], quantity)
                    if RANKING_COLUMNS.match(quantity):
                        key = (file.stem, *key)
                    facts.add(key, value, file.name, 1e-7)
    for file in sorted(folder.glob("ranking-*.json")):
        ranking = json.loads(file.read_text(encoding="utf-8"))
        for site in ranking["sites"]:
            words = footprint_words(site["footprint"])
            for quantity, values in site["metrics"].items():
                facts.add(Sites.key(site["name"], words, quantity), median(values), file.name)
                for k, value in enumerate(values):
                    facts.add(("donning", k, *Sites.key(site["name"], words, quantity)), value,
                              file.name)
            for quantity in ("score_robust", "score_median"):
                facts.add((file.stem, *Sites.key(site["name"], words, quantity)), site[quantity],
                          file.name)


class ReportTables(html.parser.HTMLParser):
    """Cells of the columns that are told to hold a quantity: (row attributes, quantity, text)."""

    def __init__(self):
        super().__init__()
        self.cells, self.columns, self.row, self.text, self.heads = [], {}, {}, None, []
        self.is_head, self.column, self.name = False, -1, ""

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if tag == "table":
            self.columns, self.heads, self.name = {}, [], given.get("data-name", "")
        elif tag == "tr":
            self.row = {key[5:]: value for key, value in given.items() if key.startswith("data-")}
            self.row["table"] = self.name
            self.column = -1
        elif tag in ("th", "td"):
            self.column += 1
            self.text = ""
            self.is_head = given.get("scope") == "col"
            if self.is_head:
                self.heads.append("")
                if "data-quantity" in given:
                    self.columns[self.column] = given["data-quantity"]

    def handle_endtag(self, tag):
        if tag not in ("th", "td") or self.text is None:
            return
        words, self.text = self.text.strip(), None
        if self.is_head:
            self.heads[self.column] = words
            return
        if self.column == 0:
            self.row["title"] = words
        if self.column in self.columns:
            self.cells.append((dict(self.row), self.columns[self.column], self.heads[self.column],
                               words))
        if self.column < len(self.heads) and self.heads[self.column] == "sensor":
            self.row["footprint"] = words

    def handle_data(self, data):
        if self.text is not None:
            self.text += data


def shown(text):
    """Value and half of the last digit of a cell; strains may be in percent."""
    plain = text.replace("\u2212", "-").replace("\u00a0", " ")
    found = re.match(r"[+]?(-?\d+(?:\.(\d+))?)", plain)
    if not found:
        return None
    return float(found.group(1)), 0.51 * 10 ** -len(found.group(2) or "")


def read_report(folder, facts):
    file = folder / "report.html"
    if not file.exists():
        return
    tables = ReportTables()
    tables.feed(file.read_text(encoding="utf-8"))
    ranking = next((f.stem for f in folder.glob("ranking-*.csv")), "")
    for row, quantity, head, text in tables.cells:
        number = shown(text)
        if number is None:
            continue
        value, slack = number
        percent = "[%]" in head or "[%]" in row.get("title", "")
        if row["table"] == "maps":
            key = ("map", row["map"], quantity)
        elif row["table"] == "regions":
            key = ("region", row["region"], quantity)
        elif row["table"] == "sites":
            key = Sites.key(row["site"], row.get("footprint", ""), quantity)
        elif row["table"] == "ranking":
            key = (ranking, "ranking", row["place"], quantity)
        else:
            continue
        yield key, value, slack, percent


VTK_TYPES = {"Float64": ("d", 8), "Int32": ("i", 4), "Int64": ("q", 8), "UInt8": ("B", 1)}


def read_vtp(file):
    """Point arrays with one component, by name."""
    data = file.read_bytes()
    start = data.index(b"<AppendedData")
    head = data[:start].decode("utf-8", "replace")
    begin = data.index(b"_", start) + 1
    points = head[head.index("<PointData"):head.index("</PointData>")]
    arrays = {}
    for tag in re.findall(r"<DataArray[^>]*>", points):
        given = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        if given.get("NumberOfComponents", "1") != "1" or given["type"] not in VTK_TYPES:
            continue
        at = begin + int(given["offset"])
        blocks, _, _ = struct.unpack_from("<3Q", data, at)
        sizes = struct.unpack_from(f"<{blocks}Q", data, at + 24)
        at += 24 + 8 * blocks
        raw = b""
        for size in sizes:
            raw += zlib.decompress(data[at:at + size])
            at += size
        letter, width = VTK_TYPES[given["type"]]
        arrays[given["Name"]] = struct.unpack(f"<{len(raw) // width}{letter}", raw)
    return arrays


def read_drapes(folder, summary, facts):
    def take(file, maps, where):
        arrays = read_vtp(file)
        for array, entry in maps.items():
            known = [v for v in arrays.get(array, ()) if not math.isnan(v)]
            for statistic, value in (("min", min(known, default=None)),
                                     ("max", max(known, default=None))):
                facts.add((*where, array, statistic), value, str(file.name))
                facts.add((*where, array, statistic), entry.get(statistic), "summary.json")
    if (folder / "drape.vtp").exists():
        take(folder / "drape.vtp", summary.get("maps", {}), ("map",))
    for state in summary.get("states", []):
        donning = state["donning"]
        place = (f"postures/{state['posture']}" if donning == 1
                 else f"donnings/{donning}/{state['posture']}")
        if (folder / place / "drape.vtp").exists() and state["counts"]:
            take(folder / place / "drape.vtp", state.get("maps", {}), (place,))


def facts_of(folder):
    facts = Facts()
    summary = read_summary(folder, facts)
    read_sites(folder, facts)
    read_rankings(folder, facts)
    read_drapes(folder, summary, facts)
    for key, value, slack, percent in read_report(folder, facts):
        if key[0] and len(key) > 1 and key[1] == "ranking":  # the row of that name, whatever its sensor
            full = [k for k in facts.values if k[0] == key[0] and k[2:3] == (key[2].replace("_", " "),)
                    and k[-1] == key[3]]
            for one in full:
                facts.add(one, value, "report.html", slack)
            continue
        scale = 100 if percent else 1
        facts.add(key, value / scale, "report.html", slack / scale)
    return facts


def main(folders):
    found = 0
    for folder in folders:
        facts = facts_of(pathlib.Path(folder))
        rows = facts.contradictions()
        found += len(rows)
        for key, least, most in rows:
            print(f"{folder}: {' | '.join(map(str, key))}: {least[0]:.6g} ({least[2]}), "
                  f"{most[0]:.6g} ({most[2]})")
        print(f"{folder}: {facts.shared()} numbers are told by two files or more, "
              f"{len(rows)} contradictions")
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
