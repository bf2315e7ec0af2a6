"""A run: the same bits as the command line, and what it yields."""
import json
import csv
import gc
import pathlib
import tempfile
import threading
import unittest

import numpy as np

import loosefit
from cases import TANK_TOP_TOML, command_line, tank_top, unsettled


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


class SmallRun(unittest.TestCase):
    """One run by the command line and one from a mapping, asked many things."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.root = pathlib.Path(cls.folder.name)
        scenario = cls.root / "case.toml"
        scenario.write_text(TANK_TOP_TOML)
        cls.by_command = cls.root / "by-command"
        command_line("run", scenario, "-o", cls.by_command, "--no-pictures", "-q")
        cls.told = []
        cls.result = loosefit.run(tank_top(), progress=lambda *news: cls.told.append(news))
        cls.loaded = loosefit.load(cls.by_command)

    def test_same_bits_as_the_command_line(self):
        here, there = self.result, self.loaded
        np.testing.assert_array_equal(here.vertices, there.vertices)
        np.testing.assert_array_equal(here.triangles, there.triangles)
        np.testing.assert_array_equal(here.pattern_uv, there.pattern_uv)
        self.assertEqual(list(here.maps), list(there.maps))
        for name in here.maps:
            np.testing.assert_array_equal(here.maps[name].values, there.maps[name].values)

    def test_files_are_those_of_the_command_line(self):
        written = self.root / "written"
        self.result.write(written)
        # Bytes, the summary but for times and for what the linker made: module and program are two.
        for name in ("drape.vtp", "body.vtp", "pattern.json", "scenario.toml", "sites.csv",
                     "ranking-ecg.csv"):
            self.assertEqual((written / name).read_bytes(), (self.by_command / name).read_bytes(),
                             name)
        self.assertIn("<html", (written / "report.html").read_text())
        summaries = [json.loads((folder / "summary.json").read_text())
                     for folder in (written, self.by_command)] + [dict(self.result.summary)]
        for summary in summaries:
            for key in ("seconds", "peak_memory_mb", "settle"):
                del summary[key]
            del summary["versions"]["build"]
        self.assertEqual(summaries[0], summaries[1])
        self.assertEqual(summaries[0], summaries[2])
        with self.assertRaises(loosefit.InputError):
            self.result.write(self.root)  # holds other things

    def test_certificate(self):
        certificate = self.result.certificate
        self.assertTrue(certificate.settled and certificate.worn and certificate.holds)
        self.assertFalse(self.result.sealed)
        self.assertEqual(certificate.intersections_body, 0)
        self.assertEqual(certificate.can_be_put_on, self.result.summary["can_be_put_on"])
        self.assertEqual(certificate.can_be_put_on is False, bool(certificate.can_be_put_on_reasons))
        self.assertEqual(certificate.residual, self.result.summary["residual"])

    def test_shapes_and_frames(self):
        r = self.result
        n, m = len(r.vertices), len(r.triangles)
        self.assertEqual(n, r.summary["vertices"])
        self.assertEqual(m, r.summary["triangles"])
        for array, shape, kind in (
                (r.vertices, (n, 3), np.float64), (r.triangles, (m, 3), np.int32),
                (r.normals, (n, 3), np.float64), (r.pattern_uv, (n, 2), np.float64),
                (r.panel_id, (n,), np.int32), (r.garment.corner_uv, (m, 3, 2), np.float64),
                (r.garment.triangle_panel_id, (m,), np.int32),
                (r.garment.mass_kg, (n,), np.float64),
                (r.garment.body_normal_force_N, (n,), np.float64)):
            self.assertEqual((array.shape, array.dtype), (shape, kind))
            self.assertTrue(np.isfinite(array).all())
            self.assertTrue(array.flags.c_contiguous)
        self.assertEqual(set(np.unique(r.panel_id)), set(range(len(r.panel_names))))
        np.testing.assert_allclose(np.linalg.norm(r.normals, axis=1), 1, atol=1e-12)
        self.assertAlmostEqual(r.garment.mass_kg.sum(), r.summary["garment"]["mass_kg"])
        # Upright, facing -y, on the trunk; normals point away from the wearer.
        self.assertTrue((r.vertices[:, 2] > 0.5).all() and (r.vertices[:, 2] < 1.6).all())
        outward = ((r.vertices - r.vertices.mean(axis=0))[:, :2] * r.normals[:, :2]).sum(axis=1)
        self.assertGreater((outward > 0).mean(), 0.9)
        # The flat area is that of the pattern.
        a, b, c = np.moveaxis(r.garment.corner_uv, 1, 0)
        area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum()
        self.assertAlmostEqual(area, r.summary["garment"]["area_m2"])
        front = r.vertices[np.argmin(r.vertices[:, 1])]
        self.assertGreater(r.body.landmarks["c7"][1], front[1])

    def test_arrays_share_memory_and_are_read_only(self):
        first, again = self.result.vertices, self.result.vertices
        self.assertTrue(np.shares_memory(first, again))
        distance = self.result.maps["distance_mm"].values
        self.assertTrue(np.shares_memory(distance, self.result.maps["distance_mm"].values))
        for array in (first, distance, self.result.body.vertices):
            self.assertFalse(array.flags.owndata)
            with self.assertRaises(ValueError):
                array[0] = 0

    def test_maps(self):
        told = self.result.summary["maps"]
        self.assertEqual(list(self.result.maps), list(told))
        distance = self.result.maps["distance_mm"]
        self.assertEqual((distance.name, distance.unit), ("distance_mm", "mm"))
        self.assertIn("skin", distance.meaning)
        self.assertEqual(distance.values.shape, (len(self.result.vertices),))
        self.assertEqual(distance.statistics["median"], told["distance_mm"]["median"])
        self.assertEqual(distance.regions, told["distance_mm"]["regions"])
        self.assertEqual(np.nanmax(distance.values), told["distance_mm"]["max"])
        self.assertEqual(self.result.maps["strain_warp"].unit, "1")
        self.assertLess(*self.result.maps["strain_warp"].range)
        with self.assertRaises(KeyError) as caught:
            self.result.maps["distance"]
        self.assertIn("distance_mm", str(caught.exception))

    def test_other_maps_of_the_same_drape(self):
        again = self.result.remapped(["pressure"])
        np.testing.assert_array_equal(again.vertices, self.result.vertices)
        self.assertIn("pressure_kPa", again.maps)
        self.assertNotIn("distance_mm", again.maps)
        self.assertIn("distance_mm", self.result.maps)
        with self.assertRaises(loosefit.InputError) as caught:
            self.result.remapped("presure")
        self.assertIn("pressure", caught.exception.hint)

    def test_sites_are_the_rows_of_the_table(self):
        with open(self.by_command / "sites.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        records = self.result.sites
        self.assertEqual([list(record) for record in records], [list(row) for row in rows])
        for record, row in zip(records, rows):
            self.assertIs(record["covered"], row.pop("covered") == "yes")
            for key, text in row.items():
                value = record[key]
                self.assertEqual(text if isinstance(value, str) else number_or_text(text),
                                 "" if value is None else value, key)

    def test_ranking_that_the_scenario_asks_for(self):
        self.assertEqual(self.result.ranking.details,
                         json.loads((self.by_command / "ranking-ecg.json").read_text()))
        self.assertIn("ECG", str(self.result.ranking))

    def test_ranking_is_that_of_the_command_line(self):
        command_line("rank", self.by_command, "-m", "temperature", "--best", "2", "--sites", "-q")
        ranking = loosefit.rank(self.result, "temperature", best=2, sites=True)
        with open(self.by_command / "ranking-temperature.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([list(record) for record in ranking.records],
                         [list(row) for row in rows])
        for record, row in zip(ranking.records, rows):
            self.assertEqual(record["name"], row["name"])
            for key in ("rank", "score_robust", "u_m", "to_edge_mm", "gap_worst_mm"):
                if row[key] == "":
                    self.assertIsNone(record[key], key)
                else:
                    self.assertAlmostEqual(float(row[key]), record[key], places=6, msg=key)
        self.assertEqual(len([r for r in ranking.records if r["name"].startswith("best_")]), 2)
        ranking.write(self.root / "ranking")
        self.assertTrue((self.root / "ranking" / "sewing-plan-temperature.svg").exists())
        with self.assertRaises(loosefit.InputError) as caught:
            loosefit.rank(self.result, "temprature")
        self.assertIn("temperature", str(caught.exception))
        with self.assertRaises(loosefit.InputError) as caught:
            loosefit.rank(self.result, "temperature", spacing_mm=-1)
        self.assertEqual(caught.exception.key, "spacing_mm")

    def test_body(self):
        body = self.result.body
        n = len(body.vertices)
        self.assertEqual(body.normals.shape, (n, 3))
        self.assertEqual(body.segment.shape, (n,))
        self.assertEqual(body.segment_names[body.segment[np.argmax(body.vertices[:, 2])]], "head")
        self.assertAlmostEqual(np.ptp(body.vertices[:, 2]), body.measured["height"], delta=0.02)
        self.assertAlmostEqual(body.vertices[:, 2].min(), 0, delta=1e-6)
        self.assertEqual(body.girths["chest"], self.result.summary["body"]["measured"]["chest"])
        # The wearer's left is +x.
        self.assertGreater(body.vertices[body.side > 0][:, 0].mean(), 0)
        self.assertGreater(body.joints["shoulder_L"][0], body.joints["shoulder_R"][0])

    def test_progress_tells_every_stage_in_order(self):
        stages = list(dict.fromkeys(stage for stage, _ in self.told))
        self.assertEqual(stages, ["body", "pattern", "garment", "dress", "settle", "maps",
                                  "placement"])
        fractions = [fraction for stage, fraction in self.told if stage == "settle"]
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(all(0 <= fraction <= 1 for fraction in fractions))

    def test_two_at_a_time_give_the_same_bits(self):
        results = [None, None]

        def run(i):
            results[i] = loosefit.run(tank_top())

        threads = [threading.Thread(target=run, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result.vertices, self.result.vertices)
            for name, made in self.result.maps.items():
                np.testing.assert_array_equal(result.maps[name].values, made.values)


class SealedRun(unittest.TestCase):
    def test_maps_only_by_name(self):
        result = loosefit.run(unsettled())
        self.assertFalse(result.certificate.settled)
        self.assertTrue(result.sealed)
        for ask in (lambda: result.maps, lambda: result.sites, lambda: result.remapped(),
                    lambda: loosefit.rank(result, "temperature")):
            with self.assertRaises(loosefit.NotSettled) as caught:
                ask()
            self.assertIn("not settled", str(caught.exception))
        self.assertEqual(result.vertices.shape[1], 3)
        opened = result.remapped(allow_unsettled=True)
        self.assertIn("distance_mm", opened.maps)
        self.assertFalse(opened.certificate.settled)
        asked = loosefit.run(unsettled(), allow_unsettled=True)
        np.testing.assert_array_equal(asked.maps["distance_mm"].values,
                                      opened.maps["distance_mm"].values)


class Lifetime(unittest.TestCase):
    def test_arrays_outlive_their_result(self):
        result = loosefit.run(unsettled(), allow_unsettled=True)
        kept = (result.vertices, result.triangles, result.maps["distance_mm"].values,
                result.normals, result.body.vertices, result.pattern.panels["front"].outline,
                result.garment.corner_uv[:, 0])
        copies = [array.copy() for array in kept]
        del result
        gc.collect()
        filler = [np.full(100000, 7.0) for _ in range(50)]  # takes what would have been freed
        for array, copy in zip(kept, copies):
            np.testing.assert_array_equal(array, copy)
        del filler


class Postures(unittest.TestCase):
    def test_states(self):
        scenario = {**tank_top(), "body": {}, "postures": {"list": ["a-pose", "model-standing"]}}
        result = loosefit.run(scenario)
        (state,) = result.states
        self.assertEqual((state.posture, state.donning), ("model-standing", 1))
        self.assertTrue(state.counts and state.certificate.holds)
        self.assertFalse(np.array_equal(state.body.vertices, result.body.vertices))
        self.assertEqual(state.garment.vertices.shape, result.vertices.shape)
        self.assertIn("slip_mm", state.maps)
        told = result.summary["states"][0]["maps"]["slip_mm"]["median"]
        self.assertEqual(state.maps["slip_mm"].statistics["median"], told)
        moved = np.linalg.norm(state.garment.vertices - result.vertices, axis=1)
        self.assertGreater(moved.max(), 0.001)


if __name__ == "__main__":
    unittest.main()
