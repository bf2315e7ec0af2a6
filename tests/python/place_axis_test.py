"""A study that varies where a sensor sits: the same drape, measured at another place."""
import math
import pathlib
import tempfile
import tomllib
import unittest

import loosefit

from cases import PLACE_STUDY, run_study


class PlaceAxis(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.study = loosefit.study(run_study(pathlib.Path(cls.folder.name), PLACE_STUDY))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def rows(self, sql, *values):
        columns = self.study.query(sql, values)
        return list(zip(*columns.values()))

    def site(self, number, name):
        """Panel, place in the pattern and in space."""
        rows = self.rows("SELECT panel, u_m, v_m, x_m, y_m, z_m FROM sites WHERE number = ? AND site = ?", number, name)
        self.assertEqual(len(rows), 1)
        return rows[0][0], rows[0][1:3], rows[0][3:]

    def shift(self, number):
        """What the database says that was drawn."""
        return [self.rows("SELECT value FROM inputs WHERE number = ? AND input = ?", number, key)[0][0]
                for key in ("place.u", "place.v")]

    def test_both_cases_are_measured(self):
        self.assertEqual(self.study.table("cases")["status"], ["done", "done"])
        first, second = self.shift(1), self.shift(2)
        self.assertNotEqual(first, second)
        self.assertLessEqual(max(map(abs, first + second)), 0.020)

    def test_the_drape_is_the_same(self):
        for columns, table in (("residual, vertices, triangles, drapes", "cases"), ("measure, value_m", "body"),
                               ("station, bgm", "fit"), ("quantity, value", "garment"),
                               ("array, statistic, value", "maps")):
            first, second = (self.rows(f"SELECT {columns} FROM {table} WHERE number = ?", number) for number in (1, 2))
            self.assertTrue(first, table)
            self.assertEqual(first, second, table)

    def test_only_the_one_sensor_moves(self):
        others = [self.rows("SELECT site, panel, u_m, v_m, x_m, y_m, z_m FROM sites "
                            "WHERE number = ? AND site != 'moved' ORDER BY site", number) for number in (1, 2)]
        self.assertGreater(len(others[0]), 3)
        self.assertEqual(others[0], others[1])
        metrics = "SELECT site, metric, value FROM metrics WHERE number = ? AND site {} 'moved' ORDER BY site, metric"
        same, moved = metrics.format("!="), metrics.format("=")
        self.assertEqual(self.rows(same, 1), self.rows(same, 2))
        self.assertTrue(self.rows(moved, 1))
        self.assertNotEqual(self.rows(moved, 1), self.rows(moved, 2))

    def test_it_moves_by_its_shift_along_the_cloth(self):
        for number in (1, 2):
            panel, still, at = self.site(number, "still")
            moved_panel, moved, moved_at = self.site(number, "moved")
            self.assertEqual(moved_panel, panel)
            u, v = self.shift(number)
            self.assertAlmostEqual(moved[0] - still[0], u, delta=1e-9)
            self.assertAlmostEqual(moved[1] - still[1], v, delta=1e-9)
            # In space as far as the cloth, which is stretched and bent a little there; warp leads up.
            self.assertAlmostEqual(math.dist(at, moved_at) / math.hypot(u, v), 1, delta=0.15)
            self.assertAlmostEqual(moved_at[2] - at[2], v, delta=0.25 * math.hypot(u, v))

    def test_the_place_is_a_column_of_the_scores(self):
        levels = self.rows("SELECT label FROM levels WHERE axis = 'place' ORDER BY number")
        scores = self.study.scores(site="moved")
        self.assertEqual(scores["number"], [1, 2])
        self.assertEqual(scores["place"], [label for label, in levels])
        for number, label in zip(scores["number"], scores["place"]):
            u, v = (1e3 * x for x in self.shift(number))
            self.assertEqual(label, f"{u:+.1f}, {v:+.1f} mm")

    def test_a_case_says_its_shift_as_any_scenario_does(self):
        address = self.rows("SELECT address FROM cases WHERE number = 1")[0][0]
        case = tomllib.loads((self.study.folder / "cases" / address[:2] / address / "scenario.toml").read_text())
        self.assertEqual([site.get("shift") for site in case["site"]], [None, self.shift(1)])


if __name__ == "__main__":
    unittest.main()
