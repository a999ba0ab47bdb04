#!/usr/bin/env python3
"""Tests of runs/paper/answers: fits of forces that are known, the chart, and the page, without solving anything."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "runs/paper"))

from answering import chart, program, pull_off, rolling  # noqa: E402
from answering.answer import Answer  # noqa: E402


def previews(force_of, rolloff="1.5 um", reach="1 nm"):
    """Means of forces, known to 2 %, at two works of adhesion, as previews.json gives them."""
    groups = []
    for rms in (0.3, 1.5, 2.7):
        for work in (60, 120):
            values = {"Surface": "{:g} nm / {}".format(rms, rolloff), "Work of adhesion": "{} mJ/m^2".format(work), "Adhesion range": reach}
            force = force_of(rms, work) * 1e-6
            groups.append({"values": values, "half_spaces": {"pull_off_force": {"with_finite_elements": {"value": force, "sd_of_mean": 0.02 * force}}}})
    return {"groups": groups}


class PullOff(unittest.TestCase):
    def setUp(self):
        self.law = lambda rms, work: 4 * (work / 77)**(1 + 0.1 * rms) / (1 + rms)
        self.surfaces = pull_off.hypotheses(previews(self.law), 0.0)["1.5 um", "1 nm"]

    def test_forces_between_two_works_are_a_power_of_the_work(self):
        for rms in (0.3, 1.5, 2.7):
            force, error = self.surfaces.force(rms, 90)
            self.assertAlmostEqual(force, self.law(rms, 90), places=6)
            self.assertAlmostEqual(error / force, 0.02, places=6)

    def test_the_work_that_made_the_forces_is_found_and_met_by_what_was_kept_out(self):
        measured = {rms: (self.law(rms, 85), 0.1, 0.1) for rms in (0.3, 1.5, 2.7)}
        work, low, high = self.surfaces.fitted(measured)
        self.assertAlmostEqual(work, 85, delta=0.5)
        self.assertTrue(low < 85 < high)
        alone, held_out = self.surfaces.held_out(measured)
        self.assertAlmostEqual(alone, 85, delta=0.01)
        self.assertLess(held_out, 1e-6)

    def test_the_error_of_the_measured_roughness_counts_by_the_slope_of_the_force(self):
        force, error = self.surfaces.force(1.5, 85)
        slope = (self.law(2.7, 85) - self.law(0.3, 85)) / 2.4
        self.assertAlmostEqual(self.surfaces.apart({1.5: (force + 1, 0.3, 0.4)}, 1.5, 85), 1 / (0.3**2 + error**2 + (0.4 * slope)**2)**0.5, places=6)

    def test_forces_that_fall_otherwise_are_not_met(self):
        measured = {0.3: (3.2, 0.1, 0.01), 1.5: (3.0, 0.1, 0.01), 2.7: (2.8, 0.1, 0.01)}
        self.assertGreater(self.surfaces.chi2(measured, self.surfaces.fitted(measured)[0]), pull_off.POSSIBLE)


    def test_both_methods_are_compared_contact_by_contact(self):
        of = lambda value: {"pull_off_force": {"value": value}}
        both = pull_off.BothMethods({"cases": [{"name": "a", "half_spaces": of(1.0)}, {"name": "b", "half_spaces": of(2.0)}, {"name": "c", "half_spaces": of(9.0)}]},
                                    {"a": {"pull_off_force": {"value": 1.1, "sd": 0.1}}, "b": {"pull_off_force": {"value": 2.0, "sd": 0.1}}})
        self.assertEqual((both.count, both.within), (2, 2))
        self.assertAlmostEqual(both.off(), 0.05)


class Rolling(unittest.TestCase):
    def test_the_published_lines_with_one_force_that_knows_no_load(self):
        # As the search of `diagnose` found for the same lines: 0.61 uN, chi-square 0.26 a row.
        one, adhesion, each, fitted = rolling.reduced(rolling.points())
        self.assertAlmostEqual(fitted[-1], 0.61, delta=0.005)
        self.assertAlmostEqual(each, 0.26, delta=0.005)
        self.assertLess(each, adhesion)
        self.assertLess(adhesion, one)


class Page(unittest.TestCase):
    def test_a_chart_is_well_formed_and_its_points_are_inside(self):
        series = [(chart.RECORDED, "", [(0.3, 3.2, 0.3), (2.7, 1.9, 0.3)]), (chart.AFTER, "a <b> & c", [(0.3, 3, 0.0), (2.7, 2, 0.0)])]
        for logarithmic in (False, True):
            svg = ElementTree.fromstring(chart.drawn("A & B", ("x", "y"), series, logarithmic))
            circles = [(float(c.get("cx")), float(c.get("cy"))) for c in svg.iter("{http://www.w3.org/2000/svg}circle")]
            self.assertGreaterEqual(len(circles), 2)
            for x, y in circles[-2:]:
                self.assertTrue(chart.LEFT <= x <= chart.WIDTH - chart.RIGHT and 0 <= y <= chart.HEIGHT - chart.BOTTOM)

    def test_ticks_are_round_and_within(self):
        ticks = chart.Axis([0, 105], 0, 100).ticks()
        self.assertEqual(ticks, [0, 20, 40, 60, 80, 100])

    def test_an_answer_says_its_verdict_first_and_has_its_table(self):
        page = Answer("x", "Why?", "ambiguous", ["It may be.", "Or not."], ["a"], [["1"]], "<svg/>", "Both", "more data.").markdown("figures")
        self.assertEqual(page.splitlines()[2], "**Ambiguous.** It may be.")
        for part in ("| a |\n| --- |\n| 1 |", "![Both](figures/x.svg)", "What would tell: more data."):
            self.assertIn(part, page)

    def test_means_of_realisations_have_the_error_of_the_mean(self):
        mean, error = program.mean_and_error([1.0, 2.0, 3.0])
        self.assertEqual(mean, 2.0)
        self.assertAlmostEqual(error, 3**-0.5)


def motion_state(motion, resistance, parts=(0.1, 0.2, 0.7)):
    values = dict(zip(("friction", "plastic", "adhesion"), parts))
    return {
        "experiment": motion,
        "load": 1e-4,
        "hertz_radius": 2e-7,
        "contact_area": 0.5 * 3.14159265 * 4e-14,
        "resistance": {"value": resistance, "sd": 0.05 * resistance},
        "parts": {name: {"value": part * resistance, "sd": 0} for name, part in values.items()},
    }


class MotionTables(unittest.TestCase):
    """The tables of docs/results_of_the_paper.md."""

    def setUp(self):
        loader = importlib.machinery.SourceFileLoader("motion_tables", str(ROOT / "runs/paper/motion_tables"))
        self.tables = importlib.util.module_from_spec(importlib.util.spec_from_loader("motion_tables", loader))
        loader.exec_module(self.tables)

    def test_numbers_have_the_digits_that_their_errors_leave(self):
        self.assertEqual(self.tables.with_error(0.40544, 0.0043), "0.4054 ± 0.0043")
        self.assertEqual(self.tables.with_error(41.02, 16.9), "41 ± 17")
        self.assertEqual(self.tables.with_error(0.25, 0.14), "0.25 ± 0.14")
        self.assertEqual(self.tables.with_error(None, None), "-")

    def test_a_contact_is_set_over_its_load_and_over_full_slip(self):
        full_slip = 3 * 3.14159265 / 16 * 0.3 * 1e-4 * 2e-7
        states = [motion_state("sliding", 3e-5), motion_state("rolling", 2e-13), motion_state("torsion", 1.5 * full_slip)]
        contact = {"label": "0.3 nm", "friction_coefficient": 0.3, "states": states}
        row = self.tables.cells(contact, 1e-4)
        self.assertEqual(row, ["0.300 ± 0.015", "0.200 ± 0.010", "10, 20, 70", "1.500 ± 0.075", "0.50 to 0.50"])
        states.pop()
        self.assertEqual(self.tables.cells(contact, 1e-4)[3], "not steady")
        text = self.tables.contacts_table({"contacts": [contact]}, False)
        self.assertIn("| 0.3 nm, 100 uN | 0.300 ± 0.015 |", text)
        self.assertNotIn("0.3 nm", self.tables.contacts_table({"contacts": [contact]}, True))

    def test_rolling_loads_stand_in_a_row_of_each_contact_and_beside_the_measurement(self):
        contact = {"label": "diamond", "states": [{**motion_state("rolling", 2e-13), "load": load} for load in self.tables.LOADS]}
        row = "| diamond, 4 nm | 0.200 ± 0.010 | 0.200 ± 0.010 | 0.200 ± 0.010 | 10, 20, 70 | 10, 20, 70 | 10, 20, 70 | 0.50, 0.50, 0.50 |"
        self.assertIn(row, self.tables.loads_table({"contacts": [contact]}))
        pair = {"simulated": {"value": 4.9e-4, "sd": 2e-5}, "measured": {"value": 7.9e-4, "sd": 3e-5}}
        ratios = [{"contact": "0.3 nm", "ratio": {"value": 0.1 * k, "sd": 0.01}} for k in (1, 4, 5)]
        published = {"laws": [{"contact": "0.3 nm", "coefficient": pair, "offset": pair}], "magnitudes": ratios}
        text = self.tables.mean_with_diamond_table({"published": published})
        self.assertIn("| 0.3 nm | 4.90 ± 0.20 | 7.90 ± 0.30 | 490 ± 20 | 790 ± 30 | 0.100 ± 0.010 | 0.400 ± 0.010 | 0.500 ± 0.010 |", text)

    def test_the_page_has_a_place_for_each_table(self):
        page = (ROOT / "docs/results_of_the_paper.md").read_text()
        for name in ("contacts", "long waves", "meshes", "laws", "rails", "rolling loads", "mean with the diamond"):
            self.assertEqual(page.count(f"<!-- motion_tables: {name} -->"), 1)
            self.assertEqual(page.count(f"<!-- end of {name} -->"), 1)


if __name__ == "__main__":
    unittest.main()
