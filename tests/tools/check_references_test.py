"""The reference check must let sound references pass and catch each kind that leads nowhere."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).parents[2] / "tools" / "check_references.py"

PAGE = "docs/theory/gap_map.md"
SOUND = {
    "docs/references.bib": "@article{Moller1997,\n  author = {M}}\n@book{Nobody2001,\n}\n",
    PAGE: "# Gap\n\n## 1 Distance\n\n### 1.2 Contact\n",
    "docs/decisions/0003-folders.md": "# 3\n",
    "src/loosefit/maps/gap.h": f"/// As in {PAGE} 1.2 and 1; Möller and Trumbore\n/// 1997. Decision 3.\n"
                               "double gap_of(double distance);  // the gap\n",
}


class CheckReferences(unittest.TestCase):
    def run_on(self, changed):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**SOUND, **changed}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            done = subprocess.run([sys.executable, CHECK, root], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def assert_caught(self, phrase, changed):
        code, text = self.run_on(changed)
        self.assertEqual(code, 1, text)
        self.assertIn(phrase, text)

    def test_sound_tree_passes(self):
        code, text = self.run_on({})
        self.assertEqual(code, 0, text)

    def test_document_that_is_not_there(self):
        self.assert_caught("src/a.h:2: no document docs/theory/strain.md",
                           {"src/a.h": "\n// docs/theory/strain.md\n"})

    def test_document_named_without_its_folder(self):
        self.assert_caught("no document gap_map.md", {"src/a.h": "// gap_map.md\n"})

    def test_page_named_by_words(self):
        self.assert_caught("write docs/theory/gap_map.md", {"src/a.h": "// (gap-map 1.2)\n"})

    def test_section_that_is_not_there(self):
        self.assert_caught("has no section 1.3", {"src/a.h": f"// {PAGE} 1.3\n"})

    def test_last_section_of_a_list_over_two_lines(self):
        self.assert_caught("has no section 2", {"src/a.cpp": f"/// {PAGE} 1.2,\n/// 2.\n"})

    def test_section_in_a_string_over_two_lines(self):
        self.assert_caught("has no section 7", {"src/a.cpp": f'f("see {PAGE} "\n  "7");\n'})

    def test_decision_that_is_not_there(self):
        self.assert_caught("no decision 4", {"docs/a.md": "(decision 4)\n"})

    def test_decision_of_more_than_a_page(self):
        self.assert_caught("at most a page", {"docs/decisions/0003-folders.md": "x\n" * 61})

    def test_file_that_is_not_there(self):
        self.assert_caught("src/a.h:1: no file maps/map.h", {"src/a.h": "int i;  // see maps/map.h\n"})
        self.assert_caught("no file maps/map.h", {"docs/a.md": "`maps/map.h`\n"})
        code, text = self.run_on({"docs/a.md": "`maps/gap.h`\n", "bench/reports/a.md": "`maps/map.h`\n",
                                  "src/a.cpp": 'write("maps/map.h");\n'})
        self.assertEqual(code, 0, text)

    def test_author_and_year(self):
        self.assert_caught('"Li et al. 2020" is not in', {"src/a.h": "// after Li et al.\n// 2020\n"})
        self.assert_caught("(key Kabsch1976)", {"data/a.toml": 'source = "Kabsch 1976"\n'})

    def test_cited_key(self):
        self.assert_caught("moller97 is not in", {"src/a.h": "// \\cite moller97\n"})

    def test_year_of_another_work_of_the_author(self):
        self.assert_caught("is not in", {"src/a.h": "// Möller and Trumbore 1998\n"})

    def test_link(self):
        self.assert_caught("leads nowhere", {"docs/a.md": "[x](missing.md)\n"})
        self.assert_caught("no heading #2-none", {"docs/a.md": "[x](theory/gap_map.md#2-none)\n"})
        code, text = self.run_on({"docs/a.md": "[x](theory/gap_map.md#1-distance)\n"})
        self.assertEqual(code, 0, text)

    def test_vocabulary(self):
        row = "| term | meaning | name in code |\n|---|---|---|\n| gap | cloth to skin | `{}` |\n"
        page = "docs/vocabulary.md"
        self.assert_caught("`gap_from` is not in src", {page: row.format("gap_from")})
        self.assert_caught('no file of src speaks of "air gap"',
                           {page: row.replace("| gap", "| air gap").format("gap_of")})
        own = row.replace("| term", "| notion").replace("| gap", "| air under cloth")
        code, text = self.run_on({page: own.format("gap_of")})
        self.assertEqual(code, 0, text)
        for name in ("gap_of", "maps/gap.h"):
            code, text = self.run_on({page: row.format(name)})
            self.assertEqual(code, 0, text)

    def test_no_list_of_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
