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

    def test_cmake_differs(self):
        self.assert_caught("maps: layers.toml and CMakeLists.txt differ in render", {},
                           cmake=CMAKE.replace("maps USES base)", "maps USES base render)"))

    def test_cycle(self):
        self.assert_caught("cycle: ", {},
                           layers=LAYERS.replace('maps = ["base"]', 'maps = ["base", "render"]'),
                           cmake=CMAKE.replace("maps USES base)", "maps USES base render)"))

    def test_long_file(self):
        self.assert_caught("501 lines", {"src/loosefit/base/b.cpp": "\n" * 501})

    def test_unreadable_rules(self):
        code, text = self.run_on({}, layers="[uses\n")
        self.assertEqual(code, 2, text)


if __name__ == "__main__":
    unittest.main()
