"""Tables of studies, sites and rankings become DataFrames, as docs/studies.md and docs/python.md say."""
import contextlib
import pathlib
import sqlite3
import sys
import tempfile
import unittest

try:
    import pandas
except ImportError:
    print("skipped: no pandas (Debian: python3-pandas)")
    sys.exit(77)  # what ctest tells as skipped

import loosefit

from cases import PLACE_STUDY, command_line, run_study, tank_top


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = run_study(pathlib.Path(cls.place.name), PLACE_STUDY)
        cls.study = loosefit.study(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def test_every_table_is_what_pandas_reads_from_the_database(self):
        with contextlib.closing(sqlite3.connect(self.folder / "study.sqlite")) as connection:
            for name in self.study.tables:
                frame = pandas.DataFrame(self.study.table(name))
                read = pandas.read_sql(f'SELECT * FROM "{name}"', connection)
                self.assertEqual(list(frame.columns), list(read.columns), name)
                # Types of columns without a row differ: there is nothing to tell them by.
                pandas.testing.assert_frame_equal(frame, read, check_dtype=not read.empty, check_index_type=False)
        self.assertIn("samples", self.study.tables)

    def test_every_table_is_what_pandas_reads_from_the_export(self):
        csv = pathlib.Path(self.place.name) / "csv"
        command_line("study", "export", self.folder, "-o", csv)
        for name in self.study.tables:
            frame = pandas.DataFrame(self.study.table(name))
            again = pandas.read_csv(csv / f"{name}.csv", float_precision="round_trip")
            self.assertEqual(list(again.columns), list(frame.columns), name)
            self.assertEqual(len(again), len(frame), name)
            for column in frame.select_dtypes("number"):
                pandas.testing.assert_series_equal(again[column], frame[column], check_dtype=False, check_exact=True,
                                                   check_index=False)

    def test_scores_are_numbers_with_a_column_for_the_axis(self):
        frame = pandas.DataFrame(self.study.scores("imu-uncalibrated", "moved"))
        self.assertEqual(len(frame), 2)
        self.assertTrue(pandas.api.types.is_float_dtype(frame["score"]))
        self.assertTrue(pandas.api.types.is_integer_dtype(frame["number"]))
        self.assertTrue(frame["score"].between(0, 1).all())
        self.assertEqual(frame["place"].nunique(), 2)

    def test_tables_are_joined_by_the_number_of_the_case(self):
        metrics = pandas.DataFrame(self.study.table("metrics"))
        wide = metrics[metrics["site"] == "moved"].pivot_table(index="number", columns="metric", values="value")
        inputs = pandas.DataFrame(self.study.table("inputs")).pivot(index="number", columns="input", values="value")
        both = wide.join(inputs)
        self.assertEqual(list(both.index), [1, 2])
        self.assertEqual(both["place.u"].tolist(), self.study.query(
            "SELECT value FROM inputs WHERE input = 'place.u' ORDER BY number")["value"])
        self.assertIn("rotation_deg", both)

    def test_what_has_no_value_is_missing(self):
        frame = pandas.DataFrame(self.study.query("SELECT number, value FROM levels ORDER BY number"))
        self.assertEqual(frame["value"].isna().tolist(), [True, True])  # places have no order


class Runs(unittest.TestCase):
    def test_sites_and_rankings(self):
        result = loosefit.run(tank_top())
        sites = pandas.DataFrame(result.sites)
        self.assertEqual(len(sites), len(result.sites))
        self.assertTrue(pandas.api.types.is_float_dtype(sites["u_m"]))
        records = loosefit.rank(result, "ecg", partial=True).records
        ranking = pandas.DataFrame(records)
        self.assertEqual(ranking["name"].tolist(), [record["name"] for record in records])


if __name__ == "__main__":
    unittest.main()
