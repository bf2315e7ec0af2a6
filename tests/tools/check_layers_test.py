"""The layer check must let a clean tree pass and catch each kind of offence."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).parents[2] / "tools" / "check_layers.py"

LAYERS = """
[uses]
base = []
maps = ["base"]
render = ["base", "maps"]
[[external]]
name = "VTK"
prefixes = ["vtk"]
places = ["render/*"]
"""
CMAKE = """
loosefit_module(base LIBRARIES fmt::fmt)
loosefit_module(maps USES base) # comment (with brackets)
loosefit_module(render USES base maps LIBRARIES vtk)
"""


class CheckLayers(unittest.TestCase):
    def run_on(self, files, layers=LAYERS, cmake=CMAKE):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "apps").mkdir()
            for module in ("base", "maps", "render"):
                (root / "src/loosefit" / module).mkdir(parents=True)
            (root / "layers.toml").write_text(layers)
            (root / "CMakeLists.txt").write_text(cmake)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            done = subprocess.run([sys.executable, CHECK, root], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

    def assert_caught(self, phrase, *args, **kwargs):
        code, text = self.run_on(*args, **kwargs)
        self.assertEqual(code, 1, text)
        self.assertIn(phrase, text)

    def test_clean_tree_passes(self):
        code, text = self.run_on({
            "src/loosefit/maps/a.h": '#include "loosefit/base/b.h"\n#include <vector>\n',
            "src/loosefit/render/r.h": "",
            "src/loosefit/render/r.cpp": '#include <vtkActor.h>\n#include "loosefit/maps/a.h"\n'})
        self.assertEqual(code, 0, text)

    def test_upward_include(self):
        self.assert_caught("base must not include loosefit/maps/a.h",
                           {"src/loosefit/base/b.cpp": '  #  include "loosefit/maps/a.h"\n'})

    def test_unknown_module(self):
        self.assert_caught("nowhere is not a module",
                           {"src/loosefit/base/b.cpp": '#include "loosefit/nowhere/a.h"\n'})

    def test_vtk_outside_render(self):
        self.assert_caught("VTK belongs into render/*",
                           {"src/loosefit/maps/m.h": "#include <vtkPolyData.h>\n"})
        self.assert_caught("VTK belongs into", {"apps/x/main.cpp": "#include <vtkPolyData.h>\n"})

    def test_place_of_a_client(self):
        binding = {"python/src/module.cpp": "#include <vtkPolyData.h>\n"}
        self.assert_caught("VTK belongs into", binding)
        allowed = LAYERS.replace('places = ["render/*"]', 'places = ["render/*", "python/src/*"]')
        self.assertNotEqual(allowed, LAYERS)
        self.assertEqual(self.run_on(binding, layers=allowed)[0], 0)

    def test_cmake_differs(self):
        self.assert_caught("maps: layers.toml and CMakeLists.txt differ in render", {},
                           cmake=CMAKE.replace("maps USES base)", "maps USES base render)"))

    def test_cycle(self):
        self.assert_caught("cycle: ", {},
                           layers=LAYERS.replace('maps = ["base"]', 'maps = ["base", "render"]'),
                           cmake=CMAKE.replace("maps USES base)", "maps USES base render)"))

    def test_long_file(self):
        self.assert_caught("501 lines", {"src/loosefit/base/b.cpp": "\n" * 501})

    # Of a clean tree with one arrow turned round, one header taken away, ...
    PAIRS = {
        "src/loosefit/base/a.h": "",
        "src/loosefit/base/a.cpp": '#include "loosefit/base/a.h"\n#include "loosefit/base/b.h"\n',
        "src/loosefit/base/b.h": '#include "loosefit/base/deep/c.h"\n',
        "src/loosefit/base/b.cpp": '#include "loosefit/base/b.h"\n',
        "src/loosefit/base/deep/c.h": "",
        "src/loosefit/base/deep/c.cpp": '#include "loosefit/base/deep/c.h"\n'}
    CIRCLE = {"src/loosefit/base/deep/c.cpp": '#include "loosefit/base/a.h"\n'}
    CYCLE = '[[cycle]]\nfiles = ["base/a", "base/b", "base/deep/*"]\nreason = "one idea"\n'
    HEADLESS = '[[without_header]]\nfiles = ["base/deep/lone*.cpp"]\nreason = "declared in a.h"\n'

    def test_file_pairs_in_line_pass(self):
        code, text = self.run_on(self.PAIRS)
        self.assertEqual(code, 0, text)

    def test_circle_of_includes_within_a_module(self):
        for name in ("deep/c.cpp", "deep/c.h"):
            with self.subTest(name):
                self.assert_caught(
                    "includes in a circle: base/a -> base/b, base/b -> base/deep/c, "
                    "base/deep/c -> base/a",
                    self.PAIRS | {f"src/loosefit/base/{name}": '#include "loosefit/base/a.h"\n'})

    def test_two_headers_that_include_each_other(self):
        self.assert_caught("base/x -> base/y, base/y -> base/x", {
            "src/loosefit/base/x.h": '#include "loosefit/base/y.h"\n',
            "src/loosefit/base/y.h": '#include "loosefit/base/x.h"\n'})

    def test_excused_circle_passes(self):
        code, text = self.run_on(self.PAIRS | self.CIRCLE, layers=LAYERS + self.CYCLE)
        self.assertEqual(code, 0, text)

    def test_excuse_of_another_circle_does_not_count(self):
        self.assert_caught("includes in a circle", self.PAIRS | self.CIRCLE,
                           layers=LAYERS + self.CYCLE.replace('"base/b", ', ""))

    def test_source_without_header(self):
        lone = {"src/loosefit/base/deep/lone.cpp": ""}
        self.assert_caught("lone.cpp: no header of its own name", lone)
        code, text = self.run_on(lone, layers=LAYERS + self.HEADLESS)
        self.assertEqual(code, 0, text)

    def test_header_elsewhere_does_not_count(self):
        self.assert_caught("lone.cpp: no header of its own name",
                           {"src/loosefit/base/deep/lone.cpp": "", "src/loosefit/base/lone.h": ""})

    def test_exception_without_reason(self):
        for reason in ("", 'reason = " "\n'):
            with self.subTest(reason):
                self.assert_caught(
                    "without a reason", {"src/loosefit/base/deep/lone.cpp": ""},
                    layers=LAYERS + self.HEADLESS.replace('reason = "declared in a.h"\n', reason))

    def test_exception_that_is_not_needed(self):
        self.assert_caught("exception not needed", self.PAIRS, layers=LAYERS + self.CYCLE)
        self.assert_caught("exception not needed", self.PAIRS, layers=LAYERS + self.HEADLESS)
        self.assert_caught("base/old: exception not needed", self.PAIRS | self.CIRCLE,
                           layers=LAYERS + self.CYCLE.replace('"base/a"', '"base/old", "base/a"'))
        self.assert_caught("(no files)", self.PAIRS,
                           layers=LAYERS + '[[cycle]]\nreason = "of nothing"\n')

    def test_unreadable_rules(self):
        code, text = self.run_on({}, layers="[uses\n")
        self.assertEqual(code, 2, text)


if __name__ == "__main__":
    unittest.main()
