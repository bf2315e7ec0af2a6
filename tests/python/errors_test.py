"""Bad input ends in an exception with place, found and expected."""
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import loosefit
from loosefit import _core
from cases import tank_top


def toml_of(scenario):
    return _core.Scenario.of_mapping(scenario).toml()


class BadScenario(unittest.TestCase):
    def refused(self, scenario, kind=loosefit.InputError):
        with self.assertRaises(kind) as caught:
            loosefit.run(scenario)
        return caught.exception

    def test_wrong_unit(self):
        error = self.refused({"body": {"height": 168}})
        self.assertEqual(error.place, "body.height")
        self.assertEqual((error.file, error.line, error.key), ("", 0, "body.height"))
        self.assertEqual(error.found, "168")
        self.assertIn("metres", error.expected)
        self.assertIn("168 cm is 1.68", error.hint)
        self.assertIn(error.hint, str(error))
        self.assertIsInstance(error, ValueError)

    def test_unknown_key_with_a_suggestion(self):
        error = self.refused({"simulation": {"edge_lenght": 0.02}})
        self.assertEqual(error.key, "simulation.edge_lenght")
        self.assertIn("edge_length", error.hint)

    def test_toml_text_names_the_line(self):
        error = self.refused("[body]\nheight = 168\n")
        self.assertEqual((error.line, error.key), (2, "body.height"))

    def test_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "case.toml"
            path.write_text("[body]\n\nheight = 168\n")
            for given in (path, str(path)):
                error = self.refused(given)
                self.assertEqual((error.file, error.line), (str(path), 3))

    def test_file_that_is_not_there(self):
        self.assertIsInstance(self.refused("no-such.toml", loosefit.IoError), OSError)

    def test_paths_that_are_not_utf8(self):
        name = os.fsdecode(b"top\xff.dxf")
        for pattern in (name, pathlib.Path(name)):
            error = self.refused({"garment": {"pattern": pattern}})
            self.assertEqual(error.key, "garment.pattern")
            self.assertIn("UTF-8", error.expected)
        self.assertIn("UTF-8", self.refused({name: 1}).expected)
        missing = self.refused(pathlib.Path(os.fsdecode(b"/nowhere/\xff.toml")), loosefit.IoError)
        self.assertIn("\ufffd.toml", str(missing))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / os.fsdecode(b"\xff.toml")
            path.write_text("[body]\nheight = 168\n")
            self.assertEqual(pathlib.Path(self.refused(path).file), path)

    def test_values_without_a_place_in_toml(self):
        for value, found in ((None, "None"), ({1, 2}, "a set"), (1j, "a complex"),
                             (2**70, "an integer beyond 64 bits"), (float("nan"), "nan")):
            error = self.refused({"body": {"age": value}})
            self.assertEqual(error.key, "body.age")
            self.assertEqual(error.found, found)
        self.assertIn("the key 3", self.refused({"body": {3: 1}}).found)
        nested = {}
        nested["body"] = nested
        self.assertIn("32", self.refused(nested).found)

    def test_what_is_no_scenario(self):
        self.assertEqual(self.refused(17).found, "a int")

    def test_later_stages_name_the_key(self):
        error = self.refused({**tank_top(), "body": {"measurements": {"chest": 1.9}}})
        self.assertEqual(error.key, "body.measurements.chest")

    def test_functions_refuse_both_ways_at_once(self):
        with self.assertRaises(TypeError):
            loosefit.body({}, sex="male")
        with self.assertRaises(TypeError):
            loosefit.pattern({}, size="women-38")

    def test_errors_survive_pickling(self):
        error = pickle.loads(pickle.dumps(self.refused({"body": {"height": 168}})))
        self.assertEqual((error.key, error.found), ("body.height", "168"))
        self.assertEqual(str(error), str(self.refused({"body": {"height": 168}})))


class ScenarioOfMapping(unittest.TestCase):
    def test_same_as_the_text(self):
        text = """
            [body]
            sex = 0.5
            measurements = { chest = 0.9 }
            [garment]
            fit = { chest = 0.1 }
            [[site]]
            name = "mine"
            panel = "front"
            at = [0.01, 0.1]
            [output]
            maps = ["strain", "distance"]
            """
        mapping = {
            "body": {"sex": np.float32(0.5), "measurements": {"chest": np.float64(0.9)}},
            "garment": {"fit": {"chest": 0.1}},
            "site": [{"name": "mine", "panel": "front", "at": np.array([0.01, 0.1])}],
            "output": {"maps": ("strain", "distance")},
        }
        self.assertEqual(toml_of(mapping), _core.Scenario.of_text(text).toml())

    def test_whole_numbers_of_numpy(self):
        self.assertEqual(toml_of({"simulation": {"seed": np.int64(7)}}),
                         toml_of({"simulation": {"seed": 7}}))

    def test_paths(self):
        pattern = pathlib.Path(__file__)  # no pattern, but a file that exists
        self.assertIn(str(pattern), toml_of({"garment": {"pattern": pattern}}))


class DataFolder(unittest.TestCase):
    def test_one_folder_a_process(self):
        """In a process of its own, which has not loaded any yet."""
        code = """
import sys, loosefit
try:
    loosefit.body(data_dir=sys.argv[1])
except loosefit.IoError as error:
    assert sys.argv[1] in str(error), error
else:
    raise AssertionError("there are no data in this folder")
loosefit.body(posture="a-pose")  # what failed may be put right
try:
    loosefit.body(data_dir=sys.argv[1])
except loosefit.InputError as error:
    assert error.key == "data_dir", error
else:
    raise AssertionError("the data are loaded")
"""
        with tempfile.TemporaryDirectory() as empty:
            done = subprocess.run([sys.executable, "-c", code, empty], capture_output=True,
                                  text=True)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
