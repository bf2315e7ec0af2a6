#!/usr/bin/env python3
"""Whatever ends a study, what has finished stays, and nothing counts twice or by half.

usage: kill_test.py BINARY [--kills N] [--seed S]
exit 0 good, 1 something was lost, 77 all is good but that no full disk could be made here

One study of small cases runs undisturbed. Then, in another folder,
  * its runner or one of its workers is killed (SIGKILL) N times at random moments, and it is started again;
  * the disk runs full in the middle, and has room again;
  * a file may not grow beyond a limit (RLIMIT_FSIZE), and then may;
  * a second runner is started beside the first;
  * Ctrl-C (SIGINT) ends it, and it goes on;
  * a smaller plan has run there before.
Each time the rows of the database must be those of the undisturbed run, the database must be sound, no worker may
outlive its runner, and no result that was there once may have been written again.
"""
import argparse
import contextlib
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

STUDY = """
[study]
name = "kills"
modalities = ["imu-uncalibrated", "pressure"]
seed = 1

[scenario.body]
posture = "a-pose"
[scenario.garment]
pattern = "tank-top"
[scenario.donning]
movements = []
[scenario.simulation]
edge_length = 0.05

[[axis]]
name = "person"
people = {{ statistics = "ansur-2012", count = {people} }}

[[axis]]
name = "fit"
key = "garment.fit.chest"
values = {fits}

# One iteration is not enough: cases that are sealed, half a second each.
[[axis]]
name = "iterations"
key = "simulation.max_iterations"
values = [1, 5000]
"""


FITS = [0.02, 0.1]


SKIPPED = 77  # what ctest tells as skipped


class Failed(Exception):
    pass


class Skipped(Exception):
    pass


def check(condition, words):
    if not condition:
        raise Failed(words)


class Study:
    def __init__(self, binary, file, folder):
        self.binary, self.file, self.folder = binary, file, folder
        self.seen = {}

    def command(self):
        return [self.binary, "study", "run", str(self.file), "-o", str(self.folder), "--jobs", "2", "--json"]

    def start(self):
        # Whoever runs this in the background has had Ctrl-C ignored for it and its children.
        heed = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)
        return subprocess.Popen(self.command(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                preexec_fn=heed)

    def run(self, **options):
        return subprocess.run(self.command(), capture_output=True, text=True, **options)

    def finished(self):
        """Cases that need not run again."""
        said = json.loads(subprocess.run([self.binary, "study", "status", str(self.folder), "--json"], check=True,
                                         capture_output=True, text=True).stdout)
        return said["done"] + said["sealed"] + said["failed"]

    def look(self):
        """No whole result may change once it is there."""
        for file in self.folder.glob("cases/*/*/result.json"):
            stat = file.stat()
            now = (stat.st_ino, stat.st_mtime_ns, stat.st_size)
            if self.seen.get(file) == now:
                continue
            json.loads(file.read_text())
            check(file not in self.seen, f"{file} was written twice")
            self.seen[file] = now

    def finish(self, content):
        """Runs to the end and compares."""
        end = self.run()
        check(end.returncode == 0, f"exit code {end.returncode}: {end.stderr}")
        said = json.loads(end.stdout)
        self.look()
        check(said["content_sha256"] == content, "the database differs from that of the undisturbed run")
        check(said["open"] == 0, "cases are open")
        check(said["done"] + said["sealed"] + said["failed"] == said["cases"], f"cases are lost or doubled: {said}")
        with contextlib.closing(sqlite3.connect(self.folder / "study.sqlite")) as database:
            sound = database.execute("PRAGMA integrity_check").fetchall()
            numbers = [row[0] for row in database.execute("SELECT number FROM cases ORDER BY number")]
        check(sound == [("ok",)], f"the database is damaged: {sound}")
        check(numbers == list(range(1, said["cases"] + 1)), f"cases of the database: {numbers}")
        left = [f.name for f in self.folder.rglob(".*writing*")]
        check(not left, f"half-written files are left: {left}")
        return said


def workers_of(runner):
    try:
        text = pathlib.Path(f"/proc/{runner}/task/{runner}/children").read_text()
    except OSError:
        return []
    return [int(word) for word in text.split()]


def end_with_runner(workers):
    """A worker that lived on could write beside that of the next runner."""
    until = time.time() + 5
    while time.time() < until and any(is_worker(one) for one in workers):
        time.sleep(0.02)
    alive = [one for one in workers if is_worker(one)]
    check(not alive, f"workers live on without their runner: {alive}")


def is_worker(process):
    try:
        return b"study\0work" in pathlib.Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return False


def kill(process):
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass


def kills(study, content, count, draws):
    """Runner or worker, at random moments; the study may finish in between and is then begun anew."""
    runners = done = whole = 0
    longest = 2.5
    while done < count:
        runner = study.start()
        ended = False
        while done < count and not ended:
            time.sleep(draws.uniform(0.01, draws.choice((0.1, longest))))  # also while the plan is written
            ended = runner.poll() is not None
            if ended:
                break
            workers = workers_of(runner.pid)
            done += 1
            if workers and draws.random() < 0.6:
                kill(draws.choice(workers))
            else:
                runners += 1
                kill(runner.pid)
                runner.wait()
                end_with_runner(workers)
                ended = True
        runner.communicate()
        study.look()
        if ended and runner.returncode == 0 and done < count:
            study.finish(content)
            whole += 1
            shutil.rmtree(study.folder)
            study.seen = {}
    said = study.finish(content)
    return (f"{count} kills, {runners} of them of the runner, in {whole + 1} runs of the study; "
            f"{said['ran']} cases were left at the end")


def full_disk(study, content, cases):
    """In a file system of memory of our own, without leave of anybody."""
    study.folder.mkdir()
    mount = f"mount -t tmpfs -o size=180k loosefit-test {study.folder}"
    try:
        subprocess.run(["unshare", "-rm", *mount.split()], check=True, capture_output=True, text=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise Skipped(f"no file system of our own can be mounted here: {getattr(error, 'stderr', '') or error}")
    script = f"""
set -e
{mount}
code=0; {' '.join(study.command())} > /dev/null 2> {study.folder}.errors || code=$?
echo "$code"; {study.binary} study status {study.folder} --json
mount -o remount,size=50m {study.folder}
{' '.join(study.command())} > {study.folder}.json
"""
    end = subprocess.run(["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True)
    check(end.returncode == 0, end.stderr)
    code, state = end.stdout.split("\n", 1)
    code, state = int(code), json.loads(state)
    finished = state["done"] + state["sealed"] + state["failed"]
    errors = pathlib.Path(f"{study.folder}.errors").read_text()
    check(code == 2, f"exit code {code} on a full disk: {errors}")
    check(finished < cases, "the disk was full too late: all cases had finished")
    check("error: " in errors, f"no error line: {errors}")
    said = json.loads(pathlib.Path(f"{study.folder}.json").read_text())
    check(said["content_sha256"] == content, "the database differs after a full disk")
    check(said["ran"] + finished == said["cases"], f"{finished} cases had finished, {said['ran']} ran again")
    return f"full after {finished} of {said['cases']} cases; {errors.splitlines()[-1]}"


def no_growth(study, content):
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (90000, resource.RLIM_INFINITY))
    end = study.run(preexec_fn=limit)
    check(end.returncode == 2, f"exit code {end.returncode} with a limit: {end.stderr}")
    study.look()
    finished = study.finished()
    said = study.finish(content)
    check(said["ran"] + finished == said["cases"], "a finished case ran again")
    return f"limit met after {finished} of {said['cases']} cases"


def second_runner(study, content):
    first = study.start()
    while not workers_of(first.pid):
        time.sleep(0.02)
        check(first.poll() is None, "the first runner ended at once")
    second = study.run()
    check(second.returncode == 2, f"the second runner ended with {second.returncode}")
    check(f"process {first.pid}" in second.stderr, f"the second runner said {second.stderr}")
    first.communicate()
    check(first.returncode == 0, "the first runner failed")
    study.finish(content)
    return "the second was told of the first"


def interrupted(study, content):
    runner = study.start()
    while not workers_of(runner.pid):
        time.sleep(0.02)
    time.sleep(1)
    workers = workers_of(runner.pid)
    runner.send_signal(signal.SIGINT)
    said, errors = runner.communicate()
    check(runner.returncode == 130, f"exit code {runner.returncode} after Ctrl-C: {errors}")
    for text in (errors, json.loads(said)["error"]["message"]):
        check("finished cases stay" in text, f"after Ctrl-C it said {text}")
    alive = [w for w in workers if os.path.exists(f"/proc/{w}")]
    check(not alive, f"workers live on: {alive}")
    study.look()
    said = study.finish(content)
    return f"{said['cases'] - said['ran']} cases had finished at Ctrl-C"


def grown(study, content, smaller):
    whole = study.file
    study.file = smaller
    end = study.run()
    check(end.returncode == 0, f"the smaller plan: {end.stderr}")
    before = json.loads(end.stdout)["cases"]
    study.look()
    study.file = whole
    said = study.finish(content)
    return f"{before} of {said['cases']} cases had run for a smaller plan"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary")
    parser.add_argument("--kills", type=int, default=4)
    parser.add_argument("--people", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    draws = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory(prefix="loosefit-kills-") as place:
        base = pathlib.Path(place)
        file, smaller = base / "kills.toml", base / "smaller" / "kills.toml"
        smaller.parent.mkdir()
        file.write_text(STUDY.format(people=arguments.people, fits=FITS))
        smaller.write_text(STUDY.format(people=arguments.people, fits=FITS[:1]))

        def study(name):
            return Study(arguments.binary, file, base / name)

        begin = time.time()
        end = study("undisturbed").run()
        if end.returncode != 0:
            print(f"error: undisturbed run: {end.stderr}", file=sys.stderr)
            return 1
        said = json.loads(end.stdout)
        content = said["content_sha256"]
        print(f"undisturbed: {said['cases']} cases, {said['done']} with scores, {said['sealed']} sealed, "
              f"{time.time() - begin:.0f} s")
        if said["done"] == 0:
            print("error: the undisturbed run has no cases with scores", file=sys.stderr)
            return 1
        failed = skipped = 0
        for name, act in (("kills", lambda s: kills(s, content, arguments.kills, draws)),
                          ("full disk", lambda s: full_disk(s, content, said["cases"])),
                          ("no growth", lambda s: no_growth(s, content)),
                          ("second runner", lambda s: second_runner(s, content)),
                          ("interrupted", lambda s: interrupted(s, content)),
                          ("grown", lambda s: grown(s, content, smaller))):
            begin = time.time()
            try:
                words = act(study(name.replace(" ", "-")))
                print(f"{name}: {words} ({time.time() - begin:.0f} s)")
            except Skipped as why:
                skipped += 1
                print(f"{name}: skipped: {why}")
            except Failed as error:
                failed += 1
                print(f"error: {name}: {error}", file=sys.stderr)
        return 1 if failed else SKIPPED if skipped else 0


if __name__ == "__main__":
    sys.exit(main())
