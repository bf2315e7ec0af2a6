#!/usr/bin/env python3
"""Tests of tools/paper_claims.py: README and the table of claims belong together; misses are seen."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import paper_claims  # noqa: E402

# Figures of the README that state nothing to be measured, with what stands round them.
NO_CLAIMS = [
    r"Debian 12", r"\(2012\)", r"GPL-3\.0", r"x86-64", r"1:1", r"C\+\+20", r"Python 3",
    r"f3d", r"3-D", r"harms2012",
]
FIGURE = re.compile(r"\d+(?:\.\d+)?|\b(?:thousandth|hundredth|tenth|forty|thirty|twenty|ten|five|"
                    r"Five)\b")


def prose(text):
    """README's text on one line, without code blocks, code words, links and pictures."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"`[^`]*`", "", text)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    return " ".join(text.split())


class Claims(unittest.TestCase):
    def setUp(self):
        self.readme = prose((ROOT / "README.md").read_text())

    def test_every_claim_stands_in_the_readme(self):
        for claim in paper_claims.CLAIMS:
            self.assertIn(claim.quote, self.readme)

    def test_every_figure_of_the_readme_is_run_again(self):
        rest = self.readme
        for claim in paper_claims.CLAIMS:
            rest = rest.replace(claim.quote, " ")
        for known in NO_CLAIMS:
            rest = re.sub(known, " ", rest)
        figures = [rest[max(0, m.start() - 30):m.end() + 30] for m in FIGURE.finditer(rest)]
        self.assertEqual(figures, [], "a claim in tools/paper_claims.py, or a reason here")

    def test_a_miss_is_seen_and_said(self):
        lines = []
        claims = [paper_claims.Claim("good", lambda _: ("1", True)),
                  paper_claims.Claim("bad", lambda _: ("2", False))]
        self.assertFalse(paper_claims.examine(claims, None, lines.append))
        self.assertIn("DOES NOT HOLD  bad", lines[1])
        self.assertTrue(paper_claims.examine(claims[:1], None, lines.append))

    def test_what_was_not_run_is_said_and_is_no_miss(self):
        def not_run(_):
            raise paper_claims.NotRun("no network")
        lines = []
        self.assertTrue(paper_claims.examine([paper_claims.Claim("c", not_run)], None, lines.append))
        self.assertIn("not run again: no network", lines[0])

    def test_residual_and_intersections_are_judged(self):
        context = paper_claims.Context(pathlib.Path("/nowhere"), pathlib.Path("/nowhere"))
        for residual, cuts in ((5e-4, 0), (2e-3, 1)):
            context.summary = lambda r=residual, c=cuts: {
                "residual": r, "intersections": {"body": 0, "self": c}}
            self.assertEqual(paper_claims.demo_balance(context)[1], residual < 1e-3)
            self.assertEqual(paper_claims.demo_intersections(context)[1], cuts == 0)

    def test_size_of_packages_follows_dependencies(self):
        status = "\n\n".join(
            f"Package: {name}\nStatus: install ok installed\nInstalled-Size: {size}\nDepends: {on}"
            for name, size, on in (("a", 1, "b (>= 2), virtual | d"), ("b", 10, "a"),
                                   ("e", 1000, "a")))
        status += ("\n\nPackage: c\nStatus: install ok installed\nInstalled-Size: 100\n"
                   "Provides: virtual (= 1)")
        self.assertEqual(paper_claims.closure(["a"], status), {"a": 1, "b": 10, "c": 100})


if __name__ == "__main__":
    unittest.main()
