"""Runs the scenarios of schema_draw.py and judges how each ended.

A row a case in a CSV file, written as it ends, so that a study that is cut short goes on: cases in the file are not
run again. `refused` (exit code 2 with words), `unsettled` (1) and `certified` (0) are good ends. `crash`, `hang`,
`internal` (an error that the program itself calls its fault), `memory`, `wordless` and `left` (something stayed
behind) are not.
"""
import concurrent.futures
import csv
import html
import json
import math
import shutil
import subprocess

import schema_draw
from run_bench import run_process

COLUMNS = ["case", "end", "exit_code", "wall_seconds", "peak_memory_mb", "commit", "words", "figures"]
BAD_ENDS = ("crash", "hang", "internal", "memory", "wordless", "left")


def schema_of(binary):
    return json.loads(subprocess.run([binary, "schema"], stdout=subprocess.PIPE, text=True, check=True).stdout)


def figures_of(folder):
    """What a person would look at first in a certified drape."""
    summary = json.loads((folder / "summary.json").read_text())
    maps = summary.get("maps", {})

    def of(array, figure):
        return (maps.get(array) or {}).get(figure)
    return {"strain": of("strain_max", "p95"), "shear_deg": of("shear_angle_deg", "p95"),
            "distance_mm": of("distance_mm", "p95"), "angle_deg": of("angular_deviation_deg", "p95"),
            "pressure_kpa": of("pressure_kPa", "p95"), "area_m2": summary["garment"]["area_m2"],
            "mass_kg": summary["garment"]["mass_kg"], "height_m": summary["body"]["measured"].get("height"),
            "chest_m": summary["body"]["measured"].get("chest"), "residual": summary["residual"]}


def end_of(code, wall, words, folder, limit):
    if code == -9 and wall > limit - 1:
        return "hang"
    if code not in (0, 1, 2):
        return "crash"
    if "unexpected:" in words or "internal error" in words:
        return "internal"
    if "not enough memory" in words:
        return "memory"
    others = [path.name for path in folder.parent.glob(f".{folder.name}*")]
    if others or (code == 2 and folder.exists()):
        return "left"
    if code == 2:
        return "refused" if words.startswith("error: ") and len(words) > 12 else "wordless"
    return "unsettled" if code == 1 else "certified"


def run(number, schema, options, out):
    folder = out / f"schema-{options.seed}-{number:04d}"
    scenario = folder.with_suffix(".toml")
    scenario.write_text(schema_draw.scenario(schema_draw.draw(options.seed, number, schema), options.edge, options.budget))
    for left in (folder, *folder.parent.glob(f".{folder.name}*")):
        shutil.rmtree(left, ignore_errors=True)
    code, wall, _, peak, words = run_process(
        [options.binary, "run", str(scenario), "-o", str(folder), "--quiet", "--no-pictures"], None, options.limit)
    words = next((line for line in words.splitlines() if line.startswith("error: ")), words)
    end = end_of(code, wall, words, folder, options.limit)
    row = {"case": number, "end": end, "exit_code": code, "wall_seconds": round(wall, 2), "peak_memory_mb": round(peak),
           "words": words.replace(str(out) + "/", "")[:300], "figures": ""}
    if end == "certified":
        row["figures"] = json.dumps(figures_of(folder), separators=(",", ":"))
    return row


def strangeness(rows):
    """Rows of certified drapes, the strangest first: by how far their figures are from the median of all, in
    magnitudes of the spread."""
    figures = {row["case"]: json.loads(row["figures"]) for row in rows if row["end"] == "certified" and row["figures"]}
    score = dict.fromkeys(figures, 0.0)
    for name in {name for values in figures.values() for name in values}:
        known = {case: math.log(max(abs(values[name]), 1e-9)) for case, values in figures.items()
                 if isinstance(values.get(name), (int, float)) and math.isfinite(values[name])}
        if len(known) < 4:
            continue
        order = sorted(known.values())
        middle, spread = order[len(order) // 2], max(order[3 * len(order) // 4] - order[len(order) // 4], 0.05)
        for case, value in known.items():
            score[case] += min(abs(value - middle) / spread, 20)
    return sorted(score, key=score.get, reverse=True)


def read_rows(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return [row | {"case": int(row["case"])} for row in csv.DictReader(file)]


def picture_strangest(rows, count, options, out):
    """One picture of each, and a page with the scenario beside it, to be looked at by a person."""
    entries = []
    for case in strangeness(rows)[:count]:
        folder = out / f"schema-{options.seed}-{case:04d}"
        picture = out / f"strange-{case:04d}.png"
        if folder.is_dir() and not picture.exists():
            subprocess.run([options.binary, "render", str(folder), "-o", str(picture), "--view", "front", "--size", "500,700"],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120, check=False)
        figures = next(row["figures"] for row in rows if row["case"] == case)
        text = folder.with_suffix(".toml").read_text() if folder.with_suffix(".toml").exists() else ""
        entries.append(f"<figure><img src='{picture.name}' alt=''><figcaption>{case}<pre>{html.escape(figures)}\n"
                       f"{html.escape(text)}</pre></figcaption></figure>")
    page = out / "strangest.html"
    page.write_text("<!doctype html><meta charset='utf-8'><title>Strangest certified drapes</title>"
                    "<style>figure{display:inline-block;width:30em;vertical-align:top}pre{white-space:pre-wrap}</style>"
                    + "".join(entries))
    return page


def study(options, out, commit):
    """Runs what the file of rows lacks; returns the rows of bad ends."""
    table = options.rows
    known = {row["case"] for row in read_rows(table)}
    wanted = [number for number in (options.cases or range(1, options.count + 1)) if options.cases or number not in known]
    schema = schema_of(options.binary)
    new = not table.exists()
    with table.open("a", newline="") as file, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        if new:
            rows.writeheader()
        running = {pool.submit(run, number, schema, options, out): number for number in wanted}
        for done in concurrent.futures.as_completed(running):
            row = done.result() | {"commit": commit}
            rows.writerow(row)
            file.flush()
            print(f"{row['case']:5d} {row['end']:10} {row['wall_seconds']:6.1f} s  {row['words'][:100]}", flush=True)
    all_rows = list({row["case"]: row for row in read_rows(table)}.values())  # the latest of each
    ends = {}
    for row in all_rows:
        ends[row["end"]] = ends.get(row["end"], 0) + 1
    print(", ".join(f"{count} {end}" for end, count in sorted(ends.items())))
    if options.strangest:
        print("look at", picture_strangest(all_rows, options.strangest, options, out))
    return [row for row in all_rows if row["end"] in BAD_ENDS]
