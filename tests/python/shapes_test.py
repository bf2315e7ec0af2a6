"""Bodies and patterns by themselves."""
import pathlib
import tempfile
import unittest

import numpy as np

import loosefit
from cases import command_line


def length(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


class Bodies(unittest.TestCase):
    def test_keys_are_those_of_the_scenario(self):
        body = loosefit.body(sex="male", height=1.80, posture="a-pose")
        self.assertAlmostEqual(body.measured["height"], 1.80, delta=0.005)
        same = loosefit.body({"body": {"sex": "male", "height": 1.80, "posture": "a-pose"}})
        np.testing.assert_array_equal(body.vertices, same.vertices)
        self.assertEqual(body.asked[0]["name"], "height")
        # A closed surface: its volume is the one that is told.
        a, b, c = (body.vertices[body.triangles[:, i]] for i in range(3))
        volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
        self.assertAlmostEqual(volume, body.measured["volume"], delta=0.02 * volume)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "body"
            body = loosefit.body(posture="a-pose")
            body.write(out)
            self.assertEqual(sorted(p.name for p in out.glob("[!.]*")),
                             ["body.json", "body.obj", "body.vtp"])
            again = loosefit.body(file=out / "body.obj", units="m", up="z")
            self.assertEqual(len(again.vertices), len(body.vertices))


class Patterns(unittest.TestCase):
    def test_panels_and_seams(self):
        pattern = loosefit.pattern(pattern="t-shirt", fit={"chest": 0.2}, body={"posture": "a-pose"})
        self.assertEqual(pattern.kind, "t-shirt")
        front = pattern.panels["front"]
        u, v = front.outline.T
        area = 0.5 * (u * np.roll(v, -1) - v * np.roll(u, -1)).sum()
        self.assertAlmostEqual(area, front.area_m2)
        for edge in front.edges.values():
            self.assertEqual(edge.shape, (65, 2))
        chest = next(row for row in pattern.fit if row["level"] == "chest")
        self.assertAlmostEqual(chest["mobility"], 0.2, places=3)
        self.assertAlmostEqual(chest["garment_m"] / chest["body_m"] - 1, chest["mobility"])

    def test_sides_of_a_seam_meet(self):
        pattern = loosefit.pattern(pattern="tank-top", body={"posture": "a-pose"})
        self.assertGreater(len(pattern.seams), 3)
        for seam in pattern.seams:
            edge = pattern.panels[seam.first_panel].edges[seam.first_edge]
            np.testing.assert_array_equal(seam.first, edge)
            other = pattern.panels[seam.second_panel].edges[seam.second_edge]
            self.assertTrue(np.array_equal(seam.second, other)
                            or np.array_equal(seam.second, other[::-1]))
            self.assertAlmostEqual(length(seam.first), seam.first_length_m, delta=1e-4)
            # As the pattern places them, ends that are sewn lie nearer than ends that are not.
            ends = []
            for panel, points in ((seam.first_panel, seam.first), (seam.second_panel, seam.second)):
                piece = pattern.panels[panel]
                flat = np.column_stack([points[[0, -1]], np.zeros(2)])
                ends.append(flat @ piece.rotation.T + piece.translation)
            sewn = np.linalg.norm(ends[0] - ends[1], axis=1).sum()
            crossed = np.linalg.norm(ends[0] - ends[1][::-1], axis=1).sum()
            self.assertLess(sewn, crossed, seam.name)

    def test_files_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            here, there = pathlib.Path(folder) / "here", pathlib.Path(folder) / "there"
            loosefit.pattern(pattern="long-sleeve-shirt", size="women-38").write(here)
            command_line("pattern", "--size", "women-38", "-o", there)
            for name in ("pattern.json", "pattern.svg"):
                self.assertEqual((here / name).read_bytes(), (there / name).read_bytes())


if __name__ == "__main__":
    unittest.main()
