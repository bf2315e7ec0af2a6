"""The study of four back sensors: its calibrated error, and its verdicts."""
import json
import math
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "validation" / "harms2012"))
import statistics_of  # noqa: E402
from cases import ALL, BOARDS, MAIN, moved_place, scenario_text  # noqa: E402
from statements import OF_PLACES, order  # noqa: E402

try:
    import numpy
    import children
    import inclination
    import tables
except ImportError:
    numpy = None


class Cases(unittest.TestCase):
    def test_boards_of_both_blades_move_to_the_spine_alike(self):
        left = moved_place("scapula_L", (-0.08, -0.15), (20, 0))
        right = moved_place("scapula_R", (0.08, -0.15), (20, 0))
        self.assertAlmostEqual(left[0], -0.06)
        self.assertAlmostEqual(right[0], 0.06)

    def test_every_board_is_in_the_scenario_with_its_mass(self):
        places = {name: (0.0, -0.1) for name in BOARDS}
        for name in MAIN:
            text = scenario_text(ALL[name], places)
            self.assertEqual(text.count("board = { mass = 0.01 }"), len(BOARDS))


class Verdicts(unittest.TestCase):
    clear = {"scapula": [1.0, 1.1], "mid_back": [2.0, 2.1], "upper_back": [5.0, 5.1],
             "lower_back": [6.0, 6.1]}

    def holds(self, placements):
        draws = list(statistics_of.over_places(placements))
        return [statistics_of.share(draws, test) for source, _, _, test in OF_PLACES
                if source == "study"]

    def test_the_order_of_the_study_agrees_with_the_study(self):
        self.assertEqual(self.holds([self.clear]), [1] * 5)

    def test_the_opposite_order_disagrees(self):
        turned = {s: [10 - x for x in v] for s, v in self.clear.items()}
        self.assertEqual(self.holds([turned]), [0] * 5)

    def test_a_place_that_doubles_within_the_tolerance_leaves_it_open(self):
        beside = {**self.clear, "scapula": [9.0, 9.1]}
        part = self.holds([self.clear, beside])[0]
        self.assertEqual(statistics_of.verdict(part), "cannot tell")

    def test_order_is_by_error(self):
        self.assertEqual(order({"a": 2, "b": 1}), ["b", "a"])


@unittest.skipUnless(numpy, "needs numpy")
class Children(unittest.TestCase):
    """The table of drawn children (validation/harms2012/children.py)."""

    def test_the_blades_are_sewn_alike_and_the_spine_in_the_middle(self):
        site = lambda u, v: {"u_m": u, "v_m": v}
        summaries = [{"sites": {"scapula left": site(0.08, -0.1), "scapula right": site(-0.06, -0.12),
                                "upper back": site(0.004, -0.05), "mid back": site(0, -0.2),
                                "lower back": site(0, v)}} for v in (-0.3, -0.32)]
        places = children.shirt_places(summaries)
        self.assertEqual(places["scapula left"], [0.07, -0.11])
        self.assertEqual(places["scapula right"], [-0.07, -0.11])
        self.assertEqual(places["upper back"], [0, -0.05])
        self.assertEqual(places["lower back"], [0, -0.31])

    def test_a_child_has_the_mean_of_its_donnings_and_of_both_blades(self):
        donning = lambda left, right, back: {"scapula left": {"error_rms": left},
                                             "scapula right": {"error_rms": right},
                                             **{name: {"error_rms": back} for name in children.PLACES[2:]}}
        found = children.by_site([{"donnings": [donning(1, 3, 5), donning(2, 6, 7)]},
                                  {"donnings": [donning(4, 4, 1)]}])
        self.assertEqual(found["scapula"], [3, 4])
        self.assertEqual(found["mid_back"], [6, 1])

    def kept(self):
        """Errors in the order of the study, deviations with the scapula last."""
        site = lambda error, deviation: {"error_rms": error, "deviation": deviation, "coe_rms": 2 * error}
        donning = {"scapula left": site(1.0, 20.0), "scapula right": site(1.0, 20.0), "upper back": site(4.0, 2.0),
                   "mid back": site(2.0, 10.0), "lower back": site(3.0, 12.0)}
        return {"asked": 3, "minutes": 7.0, "version": "1",
                "children": [{"donnings": [donning]}, {"donnings": [donning, donning]}, {"donnings": []}]}

    def test_the_page_tells_both_orders_and_the_statements(self):
        lines = children.block(self.kept())
        self.assertIn("2 of 3 children and 3 of 6 donnings count", lines[0])
        self.assertIn("version 1, build not recorded, date not recorded", lines[0])
        order = [line.split(" | ")[1] for line in lines if line[:3] in ("| 1", "| 2", "| 3", "| 4")]
        self.assertEqual(order, ["scapula", "mid back", "lower back", "upper back",
                                 "upper back", "mid back", "lower back", "scapula"])
        self.assertTrue(any("the scapula sensor has the smallest error | agrees, 100 %" in line for line in lines))
        self.assertTrue(any("low deviation at the scapula: below mid and lower back | disagrees, 0 %" in line
                            for line in lines))

    def test_in_short_the_statements_stand_by_their_verdicts(self):
        lines = children.short_block(self.kept())
        disagree = lines.index("**We disagree:**")
        self.assertLess(lines.index("- simulation: low deviation at the upper back: below mid and lower back (100 %)"),
                        disagree)
        self.assertGreater(lines.index("- simulation: low deviation at the scapula: below mid and lower back (0 %)"),
                           disagree)

    def test_a_share_beside_a_bound_has_a_decimal(self):
        self.assertEqual([children.percent(part) for part in (0.201, 0.26, 0.796, 1.0)],
                         ["20.1 %", "26 %", "79.6 %", "100 %"])

    def test_what_made_the_figures_is_told(self):
        old, new = {"version": "1"}, {"version": "2", "build": "0123456789abcdef", "date": "2026-11-29"}
        self.assertEqual(tables.made_by([new, new]), "version 2, build 0123456789ab, date 2026-11-29")
        self.assertEqual(tables.made_by([old, new]), "version 1, 2, build 0123456789ab, not recorded, "
                                                     "date 2026-11-29, not recorded")

    def test_build_and_day_are_kept_with_the_figures(self):
        with tempfile.TemporaryDirectory() as place:
            case = pathlib.Path(place)
            (case / "result.json").write_text("{}")
            record = lambda build: {"versions": {"loosefit": "3", **build}}
            cases = [(1, record({"build": "ab"}), case / "output"), (2, record({}), case / "output")]
            made = children.made(cases)
        self.assertEqual((made["version"], made["build"]), ("3", "ab, not recorded"))
        self.assertRegex(made["date"], r"^\d{4}-\d\d-\d\d$")

    def test_the_page_says_what_the_stored_figures_say(self):
        page = tables.PAGE.read_text()
        self.assertEqual(children.with_blocks(page, json.loads((children.HERE / "children.json").read_text())), page)


@unittest.skipUnless(numpy, "needs numpy")
class Inclination(unittest.TestCase):
    def frames_bent(self, bend, tilt_deg):
        """Axes of a sensor on an upright back, tilted down by `tilt_deg`, after a bend about x."""
        lean, tilt = math.radians(bend), math.radians(tilt_deg)
        angle = lean - tilt
        # The wearer faces -y: the normal of the back is +y, and a bend turns it up.
        n = numpy.array([[0, math.cos(angle), math.sin(angle)]])
        a = numpy.array([[0, -math.sin(angle), math.cos(angle)]])
        return inclination.frames(numpy.eye(1), n, a)

    def test_upright_is_zero_and_a_bend_reads_its_angle(self):
        for bend in (0, 15, 45):
            self.assertAlmostEqual(inclination.inclination(self.frames_bent(bend, 0))[0], bend)
            self.assertAlmostEqual(inclination.inclination_of_normal(self.frames_bent(bend, 0))[0], bend)

    def test_a_normal_that_leans_down_reads_less(self):
        self.assertAlmostEqual(inclination.inclination(self.frames_bent(30, 10))[0], 20)

    def test_turning_about_the_normal_leaves_the_reading_of_the_normal(self):
        frame = self.frames_bent(30, 0)
        about = math.radians(20)
        s, a, n = frame[0].T
        turned = numpy.stack([math.cos(about) * s + math.sin(about) * a,
                              math.cos(about) * a - math.sin(about) * s, n], axis=1)[None]
        self.assertAlmostEqual(inclination.inclination_of_normal(turned)[0], 30)
        relative = numpy.swapaxes(frame, 1, 2) @ turned
        self.assertAlmostEqual(inclination.rotation_angle(relative)[0], 20)

    def test_the_nearest_point_of_a_triangle_is_inside_on_an_edge_or_a_corner(self):
        corner = numpy.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]])
        for p, expected in (((0.2, 0.3, 1), (0.5, 0.2, 0.3)), ((0.5, -1, 0), (0.5, 0.5, 0)),
                            ((-1, -1, 0), (1, 0, 0)), ((2, 2, 0), (0, 0.5, 0.5))):
            share = inclination.nearest_on_triangles(numpy.array(p), corner)[0]
            numpy.testing.assert_allclose(share, expected, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
