#!/usr/bin/env python3
"""Times whole runs of the program and keeps the figures.

usage: run_bench.py [CASE|GROUP ...] [--binary FILE] [--runs N] [--pictures] [--out DIR]
                    [--json FILE] [--record NOTE] [--list]

Without names all cases run, which takes hours: `quick` is a minute. Each case is a process of its
own; wall and processor seconds and peak memory are those of the whole process. Prints a table;
--json writes the figures to a file, --record to bench/history/<date>-<commit>.json. Compare two
such files with compare.py. Cases of a pair are run in turn and followed by their ratio. Exit code 1 when
a case failed, did not settle or took more of another's time than the pair allows, 0 otherwise; cases that
cannot be run yet are listed as missing.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import threading
import time

import bench_cases
import pairs
from records import write

ROOT = pathlib.Path(__file__).resolve().parents[1]
HISTORY_SAMPLES = 40  # kept of each residual history
KILL_AFTER = 600  # seconds beyond the case's own time budget


def residual_history(log):
    """[[seconds, level, residual], …] from log.jsonl, thinned evenly; its progress notes carry it."""
    samples = []
    pattern = re.compile(r"level (\d+) of \d+, residual ([-+.\deEinfa]+)")
    for line in log.read_text().splitlines() if log.exists() else []:
        entry = json.loads(line)
        if entry["event"] == "progress" and (found := pattern.search(entry["text"])):
            samples.append([round(entry["seconds"], 2), int(found[1]), float(found[2])])
    if len(samples) > HISTORY_SAMPLES:
        step = (len(samples) - 1) / (HISTORY_SAMPLES - 1)
        samples = [samples[round(i * step)] for i in range(HISTORY_SAMPLES)]
    return samples


def run_process(command, cores, limit):
    """(exit code, wall s, cpu s, peak MB, first line of stderr) of a whole process."""
    def pin():
        if cores:
            os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:cores])
    with tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=errors, preexec_fn=pin)
        timer = threading.Timer(limit, child.kill)
        timer.start()
        _, status, usage = os.wait4(child.pid, 0)
        timer.cancel()
        wall = time.monotonic() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        message = (errors.read().decode(errors="replace").strip().splitlines() or [""])[0]
    cpu = usage.ru_utime + usage.ru_stime
    return child.returncode, wall, cpu, usage.ru_maxrss * 1024 / 1e6, message


def run_once(case, options, folder):
    scenario = folder.with_suffix(".toml")
    scenario.write_text(case.scenario)
    for name, text in case.files.items():
        (folder.parent / name).write_text(text)
    budget = float(re.search(r"time_budget = (\S+)", case.scenario)[1])
    command = [options.binary, "run", str(scenario), "-o", str(folder), "--quiet"]
    if not options.pictures:
        command.append("--no-pictures")
    code, wall, cpu, peak, message = run_process(command, case.cores, budget + KILL_AFTER)
    row = {"exit_code": code, "wall_seconds": round(wall, 3), "cpu_seconds": round(cpu, 3),
           "peak_memory_mb": round(peak, 1), "settled": False}
    file = folder / "summary.json"
    if not file.exists():
        # No paths of this machine in what is stored.
        return row | {"error": message.replace(str(folder.parent) + "/", "")}
    summary = json.loads(file.read_text())
    row |= {key: summary.get(key) for key in
            ("settled", "stop_reason", "residual", "intersections", "vertices", "settle")}
    row["iterations"] = summary["settle"]["iterations"]
    row["factorisations"] = summary["settle"]["factorisations"]
    row["seconds"] = {key: round(value, 3) for key, value in summary["seconds"].items()}
    row["history"] = residual_history(folder / "log.jsonl")
    # A tight garment strains round the chest by about −BGM / (1 + BGM) of the cloth at that level.
    cut = summary["fit"].get("chest_cut", {})
    row["hoop_strain"] = cut.get("hoop_strain")
    chest = summary["body"]["measured"]["chest"]
    if cut.get("flat") and cut["draped"] > 0.98 * chest:
        row["bgm_at_chest_level"] = cut["flat"] / chest - 1
    row["distance_median_mm"] = summary["maps"].get("distance_mm", {}).get("median")
    if summary.get("states"):
        row["postures"] = posture_costs(summary)
    row["versions"] = summary["versions"]
    return row


def posture_costs(summary):
    """Wall seconds of the stage "postures" per posture against those of the first drape, since they are
    followed side by side; of each while others run beside it; and of maps and scores (stages maps and
    placement) against all drapes. Iterations on the finest level alike."""
    seconds, states = summary["seconds"], summary["states"]
    first = seconds["dress"] + seconds["settle"]
    finest = max(part["level"] for part in summary["settle"]["parts"])

    def fine_iterations(parts):
        return sum(part["iterations"] for part in parts if part["level"] == finest)
    drapes = first + seconds.get("postures", 0) + seconds.get("donnings", 0)
    followed = [state for state in states if state["donning"] == 1]
    return {"first_drape_seconds": round(first, 2),
            "first_drape_fine_iterations": fine_iterations(summary["settle"]["parts"]),
            "share_of_first_drape_each": round(seconds.get("postures", 0) / max(len(followed), 1) / first, 3),
            "maps_and_scores_share": round((seconds["maps"] + seconds["placement"]) / drapes, 4),
            "changes": [{"posture": state["posture"], "counts": state["counts"],
                         "stop_reason": state["stop_reason"],
                         "share_of_first_drape": round(state["seconds"] / first, 3),
                         "fine_iterations": fine_iterations(state.get("parts", []))}
                        for state in followed]}


def median(values):
    values = sorted(v for v in values if v is not None)
    if not values:
        return None
    middle = len(values) // 2
    return values[middle] if len(values) % 2 else 0.5 * (values[middle - 1] + values[middle])


def status(entry):
    if "missing" in entry:
        return "missing"
    if any("error" in run for run in entry["runs"]):
        return "failed"
    return "settled" if all(run["settled"] for run in entry["runs"]) else "NOT SETTLED"


def print_row(name, entry):
    state = status(entry)
    if "missing" in entry:
        print(f"{name:22} {state:12} {entry['missing']}", flush=True)
        return
    runs = entry["runs"]
    if state == "failed":
        error = next(run["error"] for run in runs if "error" in run)
        print(f"{name:22} {state:12} exit {runs[0]['exit_code']}: {error}", flush=True)
        return
    middle = {key: median([run[key] for run in runs]) for key in
              ("wall_seconds", "cpu_seconds", "peak_memory_mb", "iterations", "residual")}
    cuts = max(run["intersections"]["body"] + run["intersections"]["self"] for run in runs)
    print(f"{name:22} {state:12} {runs[0]['vertices']:8d} {middle['wall_seconds']:8.1f} "
          f"{middle['cpu_seconds']:8.1f} {middle['peak_memory_mb']:8.0f} "
          f"{middle['iterations']:6.0f} {middle['residual']:9.1e} {cuts:5d}", flush=True)
    print_postures(runs)


def print_postures(runs):
    costs = [run["postures"] for run in runs if "postures" in run]
    for i, change in enumerate(costs[0]["changes"] if costs else []):
        share = median([cost["changes"][i]["share_of_first_drape"] for cost in costs])
        counts = all(cost["changes"][i]["counts"] for cost in costs)
        print(f"  {change['posture']:20} {'counts' if counts else 'LEFT OUT':12} "
              f"{100 * share:4.0f} % of the first drape beside others, {change['fine_iterations']} "
              f"iterations on the finest level for {costs[0]['first_drape_fine_iterations']}" +
              ("" if counts else f": {change['stop_reason']}"), flush=True)
    if costs:
        share = median([cost["maps_and_scores_share"] for cost in costs])
        print(f"  maps and scores      {100 * share:17.1f} % of the drapes", flush=True)
        each = median([cost["share_of_first_drape_each"] for cost in costs])
        print(f"  each posture         {100 * each:17.0f} % of the first drape, side by side",
              flush=True)


def machine():
    model = "unknown processor"
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    try:
        system = platform.freedesktop_os_release()["PRETTY_NAME"]
    except OSError:
        system = platform.system()
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9
    return {"processor": model, "cores": len(os.sched_getaffinity(0)),
            "memory_gb": round(memory, 1), "system": system,
            "load": round(os.getloadavg()[0], 2)}


def git(*words):
    return subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True,
                          text=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="CASE|GROUP", help="only these; see --list")
    parser.add_argument("--binary", default=str(ROOT / "build/bin/loosefit"))
    parser.add_argument("--runs", type=int, default=1, help="repeats of each case")
    parser.add_argument("--pictures", action="store_true", help="draw the maps too")
    parser.add_argument("--out", help="keep the outputs in this folder")
    parser.add_argument("--json", metavar="FILE", help="write the figures there")
    parser.add_argument("--record", metavar="NOTE", help="add to bench/history, with a note")
    parser.add_argument("--list", action="store_true", help="names and groups, nothing is run")
    options = parser.parse_args()
    try:
        chosen = bench_cases.select(options.names)
    except KeyError as unknown:
        parser.error(f"unknown case or group {unknown}; see --list")
    if options.list:
        for case in chosen:
            print(f"{case.name:22} {', '.join(case.groups):16} {case.missing or ''}".rstrip())
        return 0
    if options.runs < 1:
        parser.error("--runs: at least 1")
    if not pathlib.Path(options.binary).is_file():
        parser.error(f"{options.binary}: no such program; build it or give --binary")

    commit = git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "-uno") else "")
    date = datetime.date.today().isoformat()
    record = {"date": date, "commit": commit, "note": options.record or "", "machine": machine(),
              "versions": {}, "pictures": options.pictures, "cases": {}}
    targets = [pathlib.Path(options.json)] if options.json else []
    if options.record is not None:
        stem, number = ROOT / "bench/history" / f"{date}-{commit.rstrip('+')}", 1
        path = stem.with_name(stem.name + ".json")
        while path.exists():
            number += 1
            path = stem.with_name(f"{stem.name}-{number}.json")
        targets.append(path)
    print(f"{'case':22} {'state':12} {'vertices':>8} {'wall s':>8} {'cpu s':>8} {'peak MB':>8} "
          f"{'iter':>6} {'residual':>9} {'cuts':>5}", flush=True)
    good = True
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(options.out or scratch).resolve()
        out.mkdir(parents=True, exist_ok=True)
        for group in pairs.turns(chosen):
            runs = {case.name: [] for case in group}
            for number in range(options.runs):
                for case in group:
                    if not case.missing:
                        runs[case.name].append(run_once(case, options, out / f"{case.name}-{number}"))
            for case in group:
                entry = {"missing": case.missing} if case.missing else {"groups": case.groups, "runs": runs[case.name]}
                for run in runs[case.name]:
                    record["versions"] |= run.pop("versions", {})
                good = good and (bool(case.missing) or status(entry) == "settled")
                record["cases"][case.name] = entry
                print_row(case.name, entry)
            for path in targets:  # after every case: a suite that is cut short keeps what it has
                write(path, record)
    ratios = {pair.name: found for pair in pairs.PAIRS if (found := pair.ratio(record["cases"], median))}
    if ratios:
        pairs.print_ratios(ratios)
        record["ratios"] = ratios
        good = good and all(found["holds"] for found in ratios.values())
    for path in targets:
        write(path, record)
        print(f"written: {path.relative_to(ROOT) if path.is_relative_to(ROOT) else path}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
