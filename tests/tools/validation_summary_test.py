"""Figures in documents are those of the results, and a stale one is found."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "validation"))
import summary  # noqa: E402


def finding(what, obtained, verdict, known=None, limit=0.01, gate="relative"):
    error = abs(obtained - 2) / 2
    return {"what": what, "unit": "N", "expected": 2.0, "obtained": obtained, "error": error,
            "gate": gate, "limit": limit, "share_of_gate": error / 0.01, "verdict": verdict,
            "known_miss": known, "mesh": "", "pass": verdict == "pass"}


def benchmark(identity, *findings, verdict="pass"):
    return {"id": identity, "title": "Strip", "verdict": verdict, "error": None, "seconds": 1.5,
            "findings": list(findings), "notes": [], "plots": []}


class Repository(unittest.TestCase):
    def test_documents_say_what_the_results_say(self):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = summary.main(["summary.py", "--check"])
        self.assertEqual(code, 0, printed.getvalue())


class Summary(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        (self.root / "docs").mkdir()
        (self.root / "validation").mkdir()
        self.page = self.root / "docs" / "accuracy.md"
        self.page.write_text(f"Head.\n{summary.BEGIN}\nold\n{summary.END}\n"
                             'It is off by <!-- figure M3 "50 mm" error -->9 %<!-- end -->.\n')

    def call(self, *arguments):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = summary.main(["summary.py", *map(str, arguments)], self.root)
        return code, printed.getvalue()

    def validated(self, *benchmarks, effort="full", version="0.3.0", build=""):
        path = self.root / "validation.json"
        path.write_text(json.dumps({"effort": effort, "benchmarks": benchmarks,
                                    "versions": {"loosefit": version, "build": build, "compiler": "g++"}}))
        return path

    def test_tables_figures_and_reasons_are_written_and_then_hold(self):
        known = {"most": 0.03, "reason": "few triangles"}
        self.call(self.validated(benchmark(
            "M3", finding("strip 100 mm wide", 2.01, "pass"),
            finding("strip 50 mm wide", 2.046, "known miss", known), verdict="known miss")))
        text = self.page.read_text()
        self.assertIn('off by <!-- figure M3 "50 mm" error -->2.3 %<!-- end -->.', text)
        self.assertIn("| M3 | Strip | 2 | strip 50 mm wide | 2 | 2.046 | 2.3 % | 1 % | **known miss** |",
                      text)
        self.assertIn("few triangles", text)
        self.assertNotIn("old", text)
        self.assertEqual(self.call("--check")[0], 0)
        self.page.write_text(text.replace("2.3 %<!-- end", "1.3 %<!-- end"))
        code, printed = self.call("--check")
        self.assertEqual(code, 1)
        self.assertIn("docs/accuracy.md", printed)

    def test_some_benchmarks_replace_those_of_their_id(self):
        self.page.write_text(f"{summary.BEGIN}\n{summary.END}\n")
        self.call(self.validated(benchmark("B1", finding("a", 2.0, "pass")),
                                 benchmark("C1", finding("b", 2.0, "pass"))))
        self.call(self.validated(benchmark("B1", finding("a", 3.0, "MISS"), verdict="MISS")))
        stored = json.loads((self.root / "validation" / "results.json").read_text())
        self.assertEqual([b["id"] for b in stored], ["B1", "C1"])
        self.assertIn("**MISS** | not known |", self.page.read_text())

    def test_every_result_tells_the_version_that_found_it(self):
        self.page.write_text(f"{summary.BEGIN}\n{summary.END}\n")
        self.call(self.validated(benchmark("B1", finding("a", 2.0, "pass")),
                                 benchmark("C1", finding("b", 2.0, "pass"))))
        self.assertIn("Found by version 0.3.0 of the program.", self.page.read_text())
        self.call(self.validated(benchmark("C1", finding("b", 2.0, "pass")), version="0.4.0"))
        stored = json.loads((self.root / "validation" / "results.json").read_text())
        self.assertEqual({b["id"]: b["version"] for b in stored}, {"B1": "0.3.0", "C1": "0.4.0"})
        self.assertIn("0.3.0: B1; 0.4.0: C1.", self.page.read_text())
        self.call(self.validated(benchmark("C1", finding("b", 2.0, "pass")), build="0123456789abcdef"))
        self.assertIn("0.3.0: B1; 0.3.0 (build 01234567): C1.", self.page.read_text())

    def test_a_figure_of_no_or_several_findings_and_the_quick_subset_are_refused(self):
        with self.assertRaises(SystemExit):
            self.call(self.validated(benchmark("B1", finding("a", 2.0, "pass"))))
        with self.assertRaises(SystemExit):
            self.call(self.validated(benchmark("M3", finding("50 mm", 2.0, "pass")), effort="quick"))

    def test_ranges_tell_their_ends(self):
        self.page.write_text(f"{summary.BEGIN}\n{summary.END}\n")
        self.call(self.validated(benchmark(
            "AG", finding("ratio", 3.0, "pass", limit=[2, None], gate="range"))))
        self.assertIn("| at least 2 |", self.page.read_text())


if __name__ == "__main__":
    unittest.main()
