"""A study of two small cases, run by the program and read by the package."""
import contextlib
import csv
import os
import pathlib
import re
import sqlite3
import subprocess
import tempfile
import unittest

import cases
import loosefit

STUDY = cases.small_study("two fits", """
[[axis]]
name = "person"
people = { statistics = "ansur-2012", sex = "female", count = 1 }

[[axis]]
name = "fit"
keys = ["garment.fit.chest", "garment.fit.hip"]
values = [0.05, 0.20]
""")
MANUAL = (cases.SOURCE / "docs" / "studies.md").read_text(encoding="utf-8")


def documented_columns(manual):
    """Table -> its columns, as section 4 of docs/studies.md lists them: "| `table` | `column`, `column` | …"."""
    section = re.search(r"^## 4 .*?(?=^## )", manual, re.M | re.S).group(0)
    return {name: re.findall(r"`(\w+)`", columns)
            for name, columns in re.findall(r"^\| `(\w+)` \| ([^|]*) \|", section, re.M)}


def columns_of(database):
    """The same of a database."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        tables = [name for name, in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        return {table: [row[1] for row in connection.execute(f'PRAGMA table_info("{table}")')] for table in tables}


class AStudy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = cases.run_study(pathlib.Path(cls.place.name), STUDY, "--keep-output")
        cls.study = loosefit.study(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def test_has_a_row_per_case(self):
        cases = self.study.table("cases")
        self.assertEqual(cases["number"], [1, 2])
        self.assertEqual(cases["status"], ["done", "done"])
        self.assertEqual(self.study.facts["name"], "two fits")

    def test_the_manual_lists_every_table_and_column_of_the_database(self):
        self.assertEqual(documented_columns(MANUAL), columns_of(self.folder / "study.sqlite"))

    def test_a_column_that_the_manual_lacks_is_noticed(self):
        for there, lacking in (("`text` | a sentence", " | a sentence"), ("| `versions` |", "| |")):
            lacking = MANUAL.replace(there, lacking)
            self.assertNotEqual(lacking, MANUAL)
            self.assertNotEqual(documented_columns(lacking), columns_of(self.folder / "study.sqlite"))

    def test_the_manual_explains_what_stands_in_the_rows(self):
        explained = set(re.findall(r"`([^`]+)`", re.search(r"^## 4 .*?(?=^## )", MANUAL, re.M | re.S).group(0)))
        for column, table in (("key", "study"), ("kind", "axes"), ("status", "cases"), ("quantity", "garment"),
                              ("statistic", "maps"), ("kind", "notes")):
            for name in self.study.query(f"SELECT DISTINCT {column} FROM {table}")[column]:
                name = re.sub("^not told of .*", "not told of MODALITY", name)
                self.assertIn(name, explained, f"{table}.{column}")

    def test_page_has_a_gallery_of_kept_outputs(self):
        page = (self.folder / "study-report.html").read_text(encoding="utf-8")
        self.assertIn("drapes of 2 cases", page)
        self.assertIn("data:image/png;base64,iVBOR", page)

    def test_body_is_the_one_asked_for(self):
        asked = self.study.query("SELECT value FROM inputs WHERE number = 1 AND input = 'person.chest'")["value"]
        body = self.study.query("SELECT value_m FROM body WHERE number = 1 AND measure = 'chest'")["value_m"]
        self.assertAlmostEqual(asked[0], body[0], delta=0.01)

    def test_fit_as_cut_is_the_one_asked_for(self):
        fit = self.study.query("SELECT bgm FROM fit WHERE station = 'chest' ORDER BY number")["bgm"]
        self.assertAlmostEqual(fit[0], 0.05, places=6)
        self.assertAlmostEqual(fit[1], 0.20, places=6)

    def test_scores_bear_the_labels_of_the_axes(self):
        scores = self.study.scores(site="scapula_L")
        self.assertEqual(scores["fit"], ["0.05", "0.2"])
        self.assertEqual(scores["person"], ["person 1", "person 1"])
        for score in scores["score"]:
            self.assertTrue(0 <= score <= 1)

    def test_the_export_says_the_same(self):
        subprocess.run([os.environ["LOOSEFIT_BINARY"], "study", "export", str(self.folder)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(self.folder / "csv" / "metrics.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        values = self.study.table("metrics")["value"]
        self.assertEqual([float(row["value"]) if row["value"] else None for row in rows], values)

    def test_a_second_run_has_nothing_to_do(self):
        again = subprocess.run([os.environ["LOOSEFIT_BINARY"], "study", "run", str(self.folder / "study.toml"), "-o",
                                str(self.folder)], check=True, capture_output=True, text=True)
        self.assertIn("0 of 2 cases ran", again.stdout)

    def test_an_axis_called_as_a_column_replaces_none(self):
        with tempfile.TemporaryDirectory() as place:
            base = pathlib.Path(place)
            (base / "study.toml").write_text(STUDY.replace('name = "fit"', 'name = "site"'))
            subprocess.run([os.environ["LOOSEFIT_BINARY"], "study", "run", str(base / "study.toml"), "-o",
                            str(base / "out"), "--quiet"], check=True)
            study = loosefit.study(base / "out")
            scores = study.scores(site="scapula_L")
            self.assertEqual(set(scores["site"]), {"scapula_L"})
            self.assertEqual(set(scores["axis site"]), {"0.05", "0.2"})
            report = base / "out" / "study-report.json"
            self.assertTrue(study.headlines)
            # As it stays beside a new database when a run of the changed study is interrupted.
            report.write_text(report.read_text().replace('"plan_sha256": "', '"plan_sha256": "another'))
            with self.assertRaisesRegex(loosefit.IoError, "another plan"):
                study.headlines
            report.write_text("half of a rep")
            with self.assertRaises(loosefit.IoError):
                study.headlines

    def test_headline_is_in_the_report(self):
        for sentence, start in zip(self.study.headlines[:2], ("imu-uncalibrated: ", "comfort: "), strict=True):
            self.assertTrue(sentence.startswith(start), sentence)

    def test_what_is_not_there_is_refused(self):
        with self.assertRaises(loosefit.InputError):
            loosefit.study(self.place.name)
        with self.assertRaises(loosefit.InputError):
            self.study.table("colours")
        with self.assertRaisesRegex(loosefit.InputError, "did you mean 'scapula_L'"):
            self.study.scores(site="scapla_L")
        with self.assertRaisesRegex(loosefit.InputError, "modality: found 'ecgg'"):
            self.study.scores(modality="ecgg")
        with self.assertRaises(loosefit.IoError):
            self.study.query("SELECT nothing FROM nowhere")


if __name__ == "__main__":
    unittest.main()
