#!/usr/bin/env python3
"""A disk that runs full in the middle of a run: one error that says so, nothing half-written, the earlier output whole.

usage: full_disk_test.py BINARY [--seed S]
exit 0 good, 1 not, 77 no file system of our own can be mounted here

File systems of memory, of drawn sizes, take the output of a run; and that of a second run over a first one, where the
room left for it is drawn. Last, somebody else fills the disk while it drapes; and only the cache has no room.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

CASE = """
[garment]
pattern = "tank-top"
[donning]
movements = []
[simulation]
edge_length = 0.05
max_iterations = 2
[output]
maps = ["distance"]
views = ["front"]
preset_sites = false
"""
WITHIN = "--within"  # this script, in a mount namespace of its own


def mount(folder, kilobytes):
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "loosefit-test", str(folder)], check=True)


def files(folder):
    return {str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}


class Trial:
    def __init__(self, binary, base):
        self.binary, self.base, self.failures = binary, base, []
        self.disk, self.case, self.at = base / "disk", base / "case.toml", ""
        self.disk.mkdir()
        self.case.write_text(CASE)

    def command(self):
        return [self.binary, "run", str(self.case), "-o", str(self.disk / "out"), "--allow-unsettled", "--json", "-q"]

    def expect(self, good, words):
        if not good:
            self.failures.append(f"{self.at}: {words}")

    def expect_full(self, code, said):
        error = json.loads(said)["error"]["message"]
        self.expect(code == 2, f"exit code {code}")
        self.expect("No space left on device" in error, f"it says {error!r}")

    def expect_whole(self, code):
        self.expect(code in (0, 1), f"exit code {code}")
        self.expect({"drape.vtp", "summary.json"} <= set(files(self.disk / "out")), "output is missing")

    def unmount(self):
        subprocess.run(["umount", str(self.disk)], check=True)

    def new_outputs(self, draws, whole):
        for size in (16, int(draws.uniform(40, 0.4 * whole)), int(draws.uniform(0.4, 0.9) * whole), 4 * whole):
            self.at = f"disk of {size} kB"
            mount(self.disk, size)
            run = subprocess.run(self.command(), capture_output=True, text=True)
            if size > whole:
                self.expect_whole(run.returncode)
            else:
                self.expect_full(run.returncode, run.stdout)
                self.expect(not list(self.disk.iterdir()), f"left: {list(self.disk.iterdir())}")
            self.unmount()

    def over_an_earlier_one(self, draws, whole):
        mount(self.disk, 8 * whole)
        subprocess.run(self.command(), capture_output=True)
        before = files(self.disk)
        used = os.statvfs(self.disk)
        used = (used.f_blocks - used.f_bfree) * used.f_frsize // 1024
        for room in (0, int(draws.uniform(8, 0.9 * whole))):
            self.at = f"room of {room} kB beside an earlier output"
            subprocess.run(["mount", "-o", f"remount,size={used + room}k", str(self.disk)], check=True)
            run = subprocess.run(self.command(), capture_output=True, text=True)
            self.expect_full(run.returncode, run.stdout)
            self.expect(files(self.disk) == before, "the earlier output is another, or something lies beside it")
        self.unmount()

    def filled_meanwhile(self, whole):
        self.at = "disk that somebody fills meanwhile"
        mount(self.disk, 2 * whole)
        run = subprocess.Popen(self.command(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        with open(self.disk / "filler", "wb", buffering=0) as filler:
            try:
                while True:
                    filler.write(bytes(4096))
            except OSError:
                pass
        said, _ = run.communicate()
        self.expect_full(run.returncode, said)
        self.expect([f.name for f in self.disk.iterdir()] == ["filler"], f"left: {list(self.disk.iterdir())}")
        self.unmount()

    def full_cache(self):
        self.at = "cache without room"
        cache = self.base / "cache"
        cache.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "loosefit-test", str(cache)], check=True)
        run = subprocess.run(self.command(), capture_output=True, env=os.environ | {"LOOSEFIT_CACHE": str(cache)})
        self.expect_whole(run.returncode)
        subprocess.run(["umount", str(cache)], check=True)


def within(binary, seed):
    draws = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="loosefit-full-disk-") as place:
        trial = Trial(binary, pathlib.Path(place))
        trial.at = "disk with room"
        mount(trial.disk, 100000)
        run = subprocess.run(trial.command(), capture_output=True)
        trial.expect_whole(run.returncode)
        used = os.statvfs(trial.disk)
        whole = (used.f_blocks - used.f_bfree) * used.f_frsize // 1024  # [kB]
        trial.unmount()
        trial.new_outputs(draws, whole)
        trial.over_an_earlier_one(draws, whole)
        trial.filled_meanwhile(whole)
        trial.full_cache()
    print(f"an output takes {whole} kB")
    for failure in trial.failures:
        print("FAILED", failure)
    return 1 if trial.failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary")
    parser.add_argument("--seed", type=int, default=61)
    parser.add_argument(WITHIN, action="store_true")
    options = parser.parse_args()
    binary = str(pathlib.Path(options.binary).resolve())
    if options.within:
        return within(binary, options.seed)
    apart = ["unshare", "-rm"]
    try:
        subprocess.run([*apart, "mount", "-t", "tmpfs", "loosefit-test", "/mnt"], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        print("skipped: no file system of our own can be mounted here")
        return 77
    return subprocess.run([*apart, sys.executable, __file__, binary, "--seed", str(options.seed), WITHIN]).returncode


if __name__ == "__main__":
    sys.exit(main())
