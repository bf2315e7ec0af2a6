#!/usr/bin/env python3
"""A study that may only be read can be looked at, and told elsewhere; nothing is written by half.

usage: read_only_test.py BINARY      exit 0 good, 1 not

One small study runs. Then its folder, or its database alone, loses the leave to be written, and the commands run
as a user without any privilege (as nobody when this is root).
"""
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BINARY = ""
NOBODY = 65534
STUDY = """
[study]
name = "read only"
modalities = ["imu-uncalibrated"]
[scenario.garment]
pattern = "tank-top"
[scenario.donning]
movements = []
[scenario.simulation]
edge_length = 0.05
[[axis]]
name = "fit"
key = "garment.fit.chest"
values = [0.02, 0.1]
"""


def program(*arguments, privileged=False):
    user = {} if privileged or os.geteuid() != 0 else {"user": NOBODY, "group": NOBODY, "extra_groups": []}
    return subprocess.run([BINARY, "study", *map(str, arguments)], capture_output=True, text=True, **user)


def content(folder):
    return {str(file.relative_to(folder)): (hashlib.sha256(file.read_bytes()).hexdigest(), file.stat().st_mtime_ns)
            for file in sorted(folder.rglob("*")) if file.is_file()}


class ReadOnly(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory(prefix="loosefit-read-only-")
        cls.base = pathlib.Path(cls.place.name)
        (cls.base / "study.toml").write_text(STUDY)
        cls.study = cls.base / "study"
        run = program("run", cls.base / "study.toml", "-o", cls.study, "--json", privileged=True)
        assert run.returncode == 0, run.stderr
        said = json.loads(run.stdout)
        assert said["done"] == 2, said
        cls.sha256, cls.headlines = said["content_sha256"], said["headlines"]
        cls.out = cls.base / "out"
        cls.out.mkdir()
        if os.geteuid() == 0:
            for path in (cls.base, cls.out, cls.study, *cls.study.rglob("*")):
                os.chown(path, NOBODY, NOBODY)
        cls.before = content(cls.study)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def setUp(self):
        self.locked = []

    def tearDown(self):
        for path, mode in reversed(self.locked):
            path.chmod(mode)
        self.assertEqual(content(self.study), self.before, "the study was changed")
        self.assertEqual([f.name for f in self.out.rglob(".*writing*")], [])

    def lock(self, *paths, bits=0o222):
        for path in paths:
            mode = path.stat().st_mode & 0o777
            self.locked.append((path, mode))
            path.chmod(mode & ~bits)

    def lock_all(self):
        self.lock(self.study, *self.study.rglob("*"))

    def refused(self, run, *words):
        self.assertEqual(run.returncode, 2, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_in_its_place_it_is_refused_with_a_way_out(self):
        self.lock_all()
        for command in ("report", "export"):
            self.refused(program(command, self.study), str(self.study), "may only be read", "-o")

    def test_of_a_read_only_folder_report_and_export_go_elsewhere(self):
        self.lock_all()
        self.elsewhere("whole")

    def test_a_read_only_database_in_a_folder_that_may_be_written(self):
        self.lock(self.study / "study.sqlite")
        self.refused(program("report", self.study), "study.sqlite", "-o")
        self.refused(program("export", self.study), "study.sqlite", "-o")
        self.elsewhere("database")

    def test_a_lock_of_somebody_else_is_told_by_its_name(self):
        self.lock(self.study / ".lock")
        self.refused(program("report", self.study), ".lock", "may only be read", "-o")
        self.elsewhere("lock")

    def elsewhere(self, name):
        page, tables = self.out / f"{name}-page", self.out / f"{name}-tables"
        for _ in range(2):  # an earlier one is replaced
            report = program("report", self.study, "-o", page, "--json")
            self.assertEqual(report.returncode, 0, report.stderr)
            self.assertEqual(json.loads(report.stdout)["headlines"], self.headlines)
            export = program("export", self.study, "-o", tables, "--json")
            self.assertEqual(export.returncode, 0, export.stderr)
            self.assertEqual(json.loads(export.stdout)["content_sha256"], self.sha256)
        for file in ("study-report.json", "study-report.html"):
            self.assertEqual((page / file).read_text(), (self.study / file).read_text())
        self.assertEqual({f.name for f in page.iterdir() if not f.name.startswith(".")},
                         {"study-report.html", "study-report.json", "study.sqlite"})
        self.assertIn("cases.csv", {f.name for f in tables.iterdir()})

    def test_status_and_comparison_only_read(self):
        self.lock_all()
        for run in (program("status", self.study), program("compare", self.study, self.study),
                    program("compare", self.study, self.study, "-o", self.out / "compared.csv")):
            self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_run_is_refused(self):
        self.lock_all()
        self.refused(program("run", self.base / "study.toml", "-o", self.study), str(self.study), "ermission denied")

    def test_a_result_that_may_not_be_read_is_told_and_nothing_is_written(self):
        result = next(self.study.glob("cases/*/*/result.json"))
        self.lock_all()
        self.lock(result, bits=0o777)
        for command in ("report", "export"):
            self.refused(program(command, self.study, "-o", self.out / "nothing"), "result.json")
            self.assertFalse((self.out / "nothing").exists())

    def test_an_output_that_may_not_be_written_is_told(self):
        closed = self.out / "closed"
        closed.mkdir(exist_ok=True)
        self.lock_all()
        self.lock(closed)
        for command in ("report", "export"):
            self.refused(program(command, self.study, "-o", closed / "here"), str(closed))
        self.assertEqual(list(closed.iterdir()), [])

    def test_files_of_ones_own_stay(self):
        mine = self.out / "mine"
        mine.mkdir()
        (mine / "study.sqlite").write_text("my own")
        self.refused(program("report", self.study, "-o", mine), "study.sqlite")
        self.assertEqual([f.name for f in mine.iterdir()], ["study.sqlite"])


if __name__ == "__main__":
    BINARY = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
