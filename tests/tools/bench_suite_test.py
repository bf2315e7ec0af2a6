"""The suite must show what failed or is missing, and ratios must be those of the medians."""
import contextlib
import io
import json
import pathlib
import stat
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "bench"))
import bench_cases  # noqa: E402
import compare  # noqa: E402
import pairs  # noqa: E402
import records  # noqa: E402
import robustness_draw  # noqa: E402
import run_bench  # noqa: E402
import schema_cases  # noqa: E402
import schema_draw  # noqa: E402


def call(program, *arguments):
    printed = io.StringIO()
    with mock.patch.object(sys, "argv", ["program", *map(str, arguments)]), \
            contextlib.redirect_stdout(printed):
        code = program.main()
    return code, printed.getvalue()


def record(**cases):
    return {"date": "2026-01-01", "commit": "abc", "note": "",
            "machine": {"processor": "p", "cores": 2, "load": 0}, "cases": cases}


def runs(*cpu_seconds, settled=True):
    return {"runs": [{"settled": settled, "wall_seconds": 2 * s, "cpu_seconds": s,
                      "peak_memory_mb": 100, "iterations": 10} for s in cpu_seconds]}


class Suite(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_names_and_groups_select(self):
        self.assertEqual([c.name for c in bench_cases.select(["shirt-14mm", "shirt-20mm"])],
                         ["shirt-20mm", "shirt-14mm"])
        self.assertEqual(len(bench_cases.select(["fits"])), 20)
        names = [c.name for c in bench_cases.cases()]
        self.assertEqual(len(names), len(set(names)))
        with self.assertRaises(KeyError):
            bench_cases.select(["shirts"])

    def test_a_failed_and_a_missing_case_are_shown(self):
        program = self.folder / "loosefit"
        program.write_text("#!/bin/sh\necho 'error: no body' >&2\nexit 2\n")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        figures = self.folder / "figures.json"
        suite = [c for c in bench_cases.cases() if c.name == "tight"]
        suite.append(bench_cases.Case("later", ["later"], missing="cannot be written down yet"))
        with mock.patch.object(bench_cases, "cases", lambda: suite):
            code, printed = call(run_bench, "tight", "later", "--binary", program, "--json", figures)
        self.assertEqual(code, 1)
        self.assertRegex(printed, r"tight +failed +exit 2: error: no body")
        self.assertRegex(printed, r"later +missing")
        stored = json.loads(figures.read_text())["cases"]
        self.assertEqual(stored["tight"]["runs"][0]["error"], "error: no body")
        self.assertIn("missing", stored["later"])

    def run_pair(self, seconds):
        """The pairs group with a program that takes so long by the scenario's garment; what it was asked in turn."""
        asked = []

        def run_once(case, options, folder):
            asked.append(case.name)
            return {"exit_code": 0, "vertices": 1, "residual": 0, "intersections": {"body": 0, "self": 0}, **runs(seconds[case.name])["runs"][0]}

        program = self.folder / "loosefit"
        program.write_text("")
        figures = self.folder / "figures.json"
        with mock.patch.object(run_bench, "run_once", run_once):
            code, printed = call(run_bench, "pairs", "--runs", "2", "--binary", program, "--json", figures)
        return code, printed, asked, json.loads(figures.read_text())

    def test_a_pair_is_run_in_turn_and_its_ratio_is_told_and_kept(self):
        code, printed, asked, kept = self.run_pair({"drafted-shirt": 10, "garmentcode-long-sleeve": 15})
        self.assertEqual(code, 0)
        self.assertEqual(asked, ["drafted-shirt", "garmentcode-long-sleeve"] * 2)
        self.assertRegex(printed, r"1\.50 times the processor seconds.*at most 2: holds")
        self.assertEqual(kept["ratios"][pairs.PAIRS[0].name]["cpu_seconds"], 1.5)

    def test_a_pair_that_takes_too_long_fails(self):
        code, printed, _, kept = self.run_pair({"drafted-shirt": 10, "garmentcode-long-sleeve": 20.1})
        self.assertEqual(code, 1)
        self.assertIn("DOES NOT HOLD", printed)
        self.assertFalse(kept["ratios"][pairs.PAIRS[0].name]["holds"])

    def test_history_is_thinned_and_keeps_its_ends(self):
        log = self.folder / "log.jsonl"
        log.write_text("".join(json.dumps({"seconds": i, "event": "progress",
                                           "text": f"1 % level 2 of 3, residual {100 - i}.5"}) + "\n"
                               for i in range(100)))
        history = run_bench.residual_history(log)
        self.assertEqual(len(history), run_bench.HISTORY_SAMPLES)
        self.assertEqual((history[0], history[-1]), ([0, 2, 100.5], [99, 2, 1.5]))

    def compared(self, a, b, *options):
        paths = []
        for name, content in (("a", a), ("b", b)):
            paths.append(self.folder / f"{name}.json")
            paths[-1].write_text(json.dumps(content))
        return call(compare, *paths, *options)

    def test_ratio_of_medians(self):
        code, printed = self.compared(record(x=runs(1, 2, 30)), record(x=runs(1, 3, 4)))
        self.assertEqual(code, 0)
        self.assertRegex(printed, r"x +settled +settled +4.0 +6.0 +1.500 +1.500 +1.000 +1.000")

    def test_worse_fails_on_time_and_on_what_no_longer_settles(self):
        a, b = record(x=runs(1), y=runs(1)), record(x=runs(1.2), y=runs(1, settled=False))
        self.assertEqual(self.compared(a, b, "--worse", "0.3")[0], 1)
        code, printed = self.compared(a, record(x=runs(1.2), y=runs(1)), "--worse", "0.1")
        self.assertEqual(code, 1)
        self.assertIn("worse: x\n", printed)
        self.assertEqual(self.compared(a, record(x=runs(1.2), y=runs(1)), "--worse", "0.3")[0], 0)


def robustness_record():
    """Two cases: one that settled at once, one drawn twice that did not, with a text in it."""
    cases = {}
    for number, redrawn in ((1, []), (2, ["error: fit.chest, too \"tight\"\nline two"])):
        run = runs(1.25)["runs"][0] | {"residual": 3.2e-4, "intersections": {"body": 0, "self": 2},
                                      "stop_reason": "17" if redrawn else "converged"}
        if redrawn:
            run |= {"settled": False, "unsettled": {"why": "a, b"}}
        cases[f"draw-2012-{number:03d}"] = {
            "groups": ["robustness"], "draw": robustness_draw.draw(2012, number, len(redrawn)),
            "redrawn": redrawn, "runs": [run]}
    return record(**cases) | {"seed": 2012, "budget": 120.0}


class Records(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_nothing_is_lost_in_either_form(self):
        for name in ("a.json", "a.csv"):
            written = robustness_record()
            records.write(self.folder / name, written)
            read = records.read(self.folder / name)
            read.pop("fabrics", None)
            self.assertEqual(read, written)
        self.assertEqual(len((self.folder / "a.csv").read_text().splitlines()), 4)
        self.assertNotIn("draw\"", (self.folder / "a.csv").read_text())

    def test_a_case_that_the_seed_does_not_draw_is_not_written(self):
        other = robustness_record()
        other["cases"]["draw-2012-001"]["draw"]["fabric"] = "sackcloth"
        with self.assertRaises(ValueError):
            records.write(self.folder / "a.csv", other)
        self.assertFalse((self.folder / "a.csv").exists())

    def test_figures_outlive_a_change_of_the_draws(self):
        records.write(self.folder / "a.csv", robustness_record())
        with mock.patch.object(robustness_draw, "draw_start", lambda rng: {"shift": 0.01}):
            read = records.read(self.folder / "a.csv")
        entry = read["cases"]["draw-2012-002"]
        self.assertNotIn("draw", entry)
        self.assertEqual(entry["runs"], robustness_record()["cases"]["draw-2012-002"]["runs"])

    def test_fabrics_that_were_added_later_change_no_draw(self):
        records.write(self.folder / "a.csv", robustness_record())
        with mock.patch.object(robustness_draw, "FABRICS", ["sackcloth"]):
            read = records.read(self.folder / "a.csv")
        self.assertEqual(read["cases"], robustness_record()["cases"])

    def test_records_of_robustness_compare(self):
        records.write(self.folder / "a.csv", robustness_record())
        code, printed = call(compare, self.folder / "a.csv", self.folder / "a.csv")
        self.assertEqual(code, 0)
        self.assertRegex(printed, r"draw-2012-001 +settled +settled")

    def test_history_can_be_read(self):
        history = sorted((pathlib.Path(records.__file__).parent / "history").glob("*.*"))
        self.assertTrue(history)
        for path in history:
            with self.subTest(path.name):
                kept = records.read(path)
                self.assertTrue(kept.get("cases") or kept.get("loosefit"))
                self.assertLess(len(path.read_text().splitlines()), 300)


class ScenariosOfTheSchema(unittest.TestCase):
    SCHEMA = {"type": "object", "properties": {
        "body": {"anyOf": [{"type": "object", "properties": {"height": {"type": "number", "minimum": 0.7, "maximum": 2.3,
                                                                         "default": 1.7}}}]},
        "garment": {"anyOf": [{"type": "object", "properties": {"pattern": {"type": "string", "enum": ["shirt", "trousers"]},
                                                                 "length": {"type": "number", "minimum": 1e-3, "maximum": 10}}}]},
        "simulation": {"type": "object", "properties": {"edge_length": {"type": "number", "minimum": 0.001, "maximum": 0.1},
                                                        "seed": {"type": "integer", "minimum": 0, "maximum": 9}}}}}

    def test_draws_keep_to_the_schema_and_follow_from_seed_and_number(self):
        for case in range(200):
            drawn = schema_draw.draw(1, case, self.SCHEMA)
            self.assertEqual(drawn, schema_draw.draw(1, case, self.SCHEMA))
            self.assertLessEqual(set(drawn), set(self.SCHEMA["properties"]) | {"body"})
            self.assertIn(drawn.get("garment", {}).get("pattern", "shirt"), ("shirt", "trousers"))
            height = drawn.get("body", {}).get("height", 1)
            self.assertTrue(0.7 <= height <= 2.3, height)
            self.assertTrue(1e-3 <= drawn.get("garment", {}).get("length", 1) <= 10)
            self.assertNotIn("edge_length", drawn.get("simulation", {}))
            self.assertIsInstance(drawn.get("simulation", {}).get("seed", 0), int)

    def test_an_end_is_good_only_in_words_and_in_time(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch) / "case"

            def end(code, wall=1, words=""):
                return schema_cases.end_of(code, wall, words, folder, 30)
            self.assertEqual(end(0), "certified")
            self.assertEqual(end(1), "unsettled")
            self.assertEqual(end(2, words="error: body.height: found 9"), "refused")
            self.assertEqual(end(2), "wordless")
            self.assertEqual(end(2, words="error: unexpected: x"), "internal")
            self.assertEqual(end(2, words="error: not enough memory"), "memory")
            self.assertEqual(end(-11), "crash")
            self.assertEqual(end(-9, wall=30), "hang")
            (pathlib.Path(scratch) / ".case.writing-1").mkdir()
            self.assertEqual(end(0), "left")

    def test_the_strangest_is_the_one_unlike_the_others(self):
        rows = [{"case": case, "end": "certified", "figures": json.dumps({"strain": 0.1 + 0.001 * case})} for case in range(9)]
        rows.append({"case": 9, "end": "certified", "figures": json.dumps({"strain": 40})})
        rows.append({"case": 10, "end": "refused", "figures": ""})
        order = schema_cases.strangeness(rows)
        self.assertEqual(order[0], 9)
        self.assertEqual(len(order), 10)


if __name__ == "__main__":
    unittest.main()
