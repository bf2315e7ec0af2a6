"""One quantity has one name and one value in all that a case gives."""
import csv
import importlib.util
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cases
import loosefit

CASE = """
[body]
posture = "a-pose"
[garment]
pattern = "tank-top"
[simulation]
edge_length = 0.05
[postures]
list = ["a-pose", "forward-bend-30"]
[donning]
repeats = 2
movements = []
[ranking]
modality = "imu-inclination"
best = 1
[output]
maps = ["strain", "distance", "angular-deviation", "orientation", "gap", "pressure"]
[[site]]
name = "board"
landmark = "upper_back"
footprint = { size = [0.040, 0.030] }
angle_deg = 20
"""
SCRIPT = cases.SOURCE / "tools" / "find_contradictions.py"


def contradictions(folder):
    return subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True)


class OneCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.root = pathlib.Path(cls.place.name)
        (cls.root / "case.toml").write_text(CASE)
        cls.output = cls.root / "out"
        cls.printed = cases.command_line("run", cls.root / "case.toml", "-o", cls.output,
                                         "--no-pictures")
        cls.summary = json.loads((cls.output / "summary.json").read_text())
        cls.result = loosefit.load(cls.output)

    def test_files_of_one_run_do_not_contradict_each_other(self):
        found = contradictions(self.output)
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)
        told = int(found.stdout.split(": ")[-1].split()[0])
        self.assertGreater(told, 500, found.stdout)

    def test_a_changed_figure_is_found(self):
        name = "sites.csv"
        text = (self.output / name).read_text()
        with (self.output / name).open(newline="") as stream:
            row = next(r for r in csv.DictReader(stream) if r["name"] == "board")
        try:
            (self.output / name).write_text(text.replace(row["gap_mm"], "99", 1))
            found = contradictions(self.output)
            self.assertEqual(found.returncode, 1)
            self.assertIn("gap_mm", found.stdout)
        finally:
            (self.output / name).write_text(text)

    def test_the_sites_own_footprint_is_used_everywhere(self):
        ranked = next(r for r in self.result.ranking.records if r["name"] == "board")
        site = next(s for s in self.result.sites if s["name"] == "board")
        for row in (ranked, site):
            self.assertEqual(row["footprint"], "40 x 30 mm")
            self.assertAlmostEqual(row["sensor_diameter_mm"], 40)

    def test_python_says_what_the_files_say(self):
        with (self.output / "sites.csv").open(newline="") as stream:
            rows = {row["name"]: row for row in csv.DictReader(stream)}
        ranked = {row["name"]: row for row in self.result.ranking.records}
        compared = 0
        for site in self.result.sites:
            if not site["covered"]:
                continue
            self.assertEqual(list(site), list(rows[site["name"]]))
            for key, value in site.items():
                if not isinstance(value, float):
                    continue
                self.assertAlmostEqual(float(rows[site["name"]][key]), value, places=9)
                other = ranked.get(site["name"], {}).get(key)
                if isinstance(other, float) and ranked[site["name"]]["footprint"] == site["footprint"]:
                    self.assertAlmostEqual(other, value, places=6, msg=key)
                    compared += 1
        self.assertGreater(compared, 100)

    def test_the_turn_of_a_sensor_has_signs_that_add_up_to_its_size(self):
        for site in self.result.sites:
            if not site["covered"] or site.get("coe_across_deg") is None:
                continue
            by = self.summary["sites"][site["name"]]["by_donning"]
            for k in range(2):  # one posture beside the reference: its turn is the error
                turn = [by[f"coe_{axis}_deg"][k] for axis in ("across", "along", "normal")]
                self.assertAlmostEqual(math.hypot(*turn), by["coe_rms_deg"][k], places=6)

    def test_every_state_has_all_maps_and_all_sites(self):
        names = set(self.summary["sites"])
        self.assertEqual(len(self.summary["states"]), 3)
        for state, told in zip(self.result.states, self.summary["states"]):
            self.assertEqual(set(told["sites"]), names)
            self.assertTrue({"gap_mm", "contact_ratio", "pressure_kPa", "rotation_deg"} <=
                            set(told["sites"]["board"]))
            for array in ("distance_mm", "gap_mm", "contact", "strain_warp", "pressure_kPa"):
                self.assertIn(array, state.maps)
                self.assertIn("panels", told["maps"][array])
                self.assertIn("regions", told["maps"][array])
            if told["posture"] == "a-pose":
                continue
            for axis in ("across", "along", "normal"):
                here = told["sites"]["board"][f"coe_{axis}_deg"]
                donning = self.summary["sites"]["board"]["by_donning"][f"coe_{axis}_deg"]
                self.assertAlmostEqual(here, donning[told["donning"] - 1], places=9)

    def test_drapes_tell_the_region_under_every_point(self):
        spec = importlib.util.spec_from_file_location("find_contradictions", SCRIPT)
        script = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(script)
        drapes = sorted(self.output.rglob("drape.vtp"))
        self.assertEqual(len(drapes), 4)
        for drape in drapes:
            arrays = script.read_vtp(drape)
            self.assertIn(b"region_names", drape.read_bytes())
            self.assertEqual(len(arrays["region_id"]), len(arrays["distance_mm"]))
            self.assertGreater(len(set(arrays["region_id"])), 4)
        # The medians of a map by region are those of the points that the file puts there.
        told = self.summary["maps"]["distance_mm"]["regions"]
        self.assertEqual(len(told), len(set(script.read_vtp(self.output / "drape.vtp")["region_id"])))

    def test_answers_are_the_same_on_terminal_page_and_in_the_summary(self):
        page = (self.output / "report.html").read_text(encoding="utf-8")
        self.assertEqual(len(self.summary["answers"]), 2)  # the best place, and the board
        for answer in self.summary["answers"]:
            self.assertIn(answer["text"], self.printed)
            for key in ("place", "expectation", "pass_mark"):
                self.assertTrue(answer[key])
                self.assertIn(answer[key].replace("'", "&#39;"), page.replace("&apos;", "&#39;"))
        self.assertLess(page.index(self.summary["answers"][0]["place"][:20]), page.index("id=\"viewer\""))
        best, board = self.summary["answers"]
        self.assertIn("cm from", best["place"])
        ranked = next(r for r in self.result.ranking.records if r["name"] == "board")
        self.assertAlmostEqual(board["expected"]["median"], ranked["coe_rms_deg"])
        self.assertEqual(board["passing"], round(ranked["passing"] * 2))


class NothingAskedFor(unittest.TestCase):
    def test_the_usual_sensors_are_answered(self):
        scenario = cases.tank_top()
        del scenario["ranking"]
        result = loosefit.run(scenario)
        answers = result.summary["answers"]
        self.assertEqual([a["modality"] for a in answers],
                         ["imu-uncalibrated", "ecg", "ppg", "strain-respiration"])
        for answer in answers:
            self.assertFalse(answer["asked"])
            self.assertTrue(answer["pass_mark"].startswith("Pass mark: "))
            self.assertIn(answer["site"], {s["name"] for s in result.sites})


if __name__ == "__main__":
    unittest.main()
