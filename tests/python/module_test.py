#!/usr/bin/python3
"""module_test.py: the Python module gives what the program and its files give. PYTHONPATH holds the module."""

import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

import asperity

SOURCE = pathlib.Path(__file__).resolve().parents[2]
RADIUS, LOAD = 8.5e-6, 1e-3
MODULUS = 1 / ((1 - 0.17**2) / 71e9 + (1 - 0.25**2) / 179e9)
SMOOTH = """subsection Particle
  set Radius = 8.5 um
  set Young modulus = 71 GPa
  set Poisson ratio = 0.17
end
subsection Substrate
  set Young modulus = 179 GPa
  set Poisson ratio = 0.25
end
subsection Experiment
  set Normal load = 1 mN
end
"""


class InAFolder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def case(self):
        file = self.folder / "case.prm"
        file.write_text(SMOOTH)
        return file


class Surfaces(InAFolder):
    def test_heights_are_a_view_that_outlives_its_name_and_cannot_be_written(self):
        heights = asperity.generate_surface(1.5e-9, 1e-6, 128, seed=3).heights
        self.assertEqual(heights.shape, (128, 128))
        self.assertFalse(heights.flags.owndata)
        self.assertFalse(heights.flags.writeable)
        again = asperity.generate_surface(1.5e-9, 1e-6, 128, seed=3).heights
        self.assertTrue((heights == again).all())
        self.assertFalse((heights == asperity.generate_surface(1.5e-9, 1e-6, 128, seed=4).heights).all())

    def test_of_an_array_is_measured_as_numpy_does(self):
        x = np.arange(64) / 64
        wave = np.tile(2e-9 * np.sin(2 * np.pi * 4 * x), (32, 1))
        surface = asperity.Surface(wave, 6.4e-7)
        self.assertEqual(surface.size, (6.4e-7, 3.2e-7))
        self.assertEqual(surface.spacing, (1e-8, 1e-8))
        measured = asperity.measure_surface(surface, level="mean")
        self.assertAlmostEqual(measured["Sq_m"] / wave.std(), 1, places=9)
        self.assertAlmostEqual(measured["Sz_m"] / np.ptp(wave), 1, places=9)

    def test_is_written_and_read_again_with_its_gaps(self):
        heights = np.array(asperity.generate_surface(1e-9, 1e-6, 64).heights)
        heights[3, 5] = np.nan
        file = self.folder / "map.gsf"
        asperity.write_surface(file, asperity.Surface(heights, 1e-6))
        again = asperity.read_surface(file)
        self.assertTrue(np.isnan(again.heights[3, 5]))
        self.assertLess(np.nanmax(abs(again.heights - heights)), 1e-15)
        self.assertIn("64 x 64", repr(again))

    def test_what_is_none_is_refused_in_a_sentence(self):
        file = self.folder / "notes.txt"
        file.write_text("no scan\n")
        with self.assertRaisesRegex(asperity.InputError, "notes.txt"):
            asperity.read_surface(file)
        with self.assertRaisesRegex(ValueError, "3 dimensions"):
            asperity.Surface(np.zeros((2, 2, 2)), 1e-6)
        with self.assertRaisesRegex(asperity.InputError, "needs pixels"):
            asperity.generate_surface(1e-9, 1e-6, 32, cutoff=20e-9)


class Contacts(InAFolder):
    def test_preview_of_a_smooth_sphere_is_hertz(self):
        contact = asperity.preview(self.case(), {"Experiment/Normal load": "1 mN"})
        approach = (3 * LOAD / (4 * MODULUS * math.sqrt(RADIUS)))**(2 / 3)
        self.assertAlmostEqual(contact.approach / approach, 1, delta=0.01)
        self.assertAlmostEqual(contact.stiffness / (2 * MODULUS * math.sqrt(RADIUS * approach)), 1, delta=0.01)
        self.assertAlmostEqual(contact.pressure.sum() * contact.spacing**2 / LOAD, 1, places=6)
        with self.assertRaisesRegex(asperity.InputError, "did you mean 'Normal load'"):
            asperity.preview(self.case(), {"Experiment/Normal loads": "1 mN"})

    def test_a_case_is_solved_with_progress_read_and_derived(self):
        lines = []
        solved = asperity.solve(self.case(), self.folder / "solved", {"Experiment/Load steps": 3, "Experiment/Unload": "false"},
                                progress=lines.append)
        self.assertTrue(any(line.startswith("step 1/3") for line in lines), lines)
        self.assertTrue(solved.finished)
        self.assertEqual(solved.entries["Experiment/Load steps"], "3")
        force = solved.history["normal_force"]
        self.assertAlmostEqual(force[-1] / LOAD, 1, places=6)
        self.assertTrue((force == solved.history["normal_force [N]"]).all())
        with self.assertRaises(KeyError):
            solved.history["normal_farce"]
        frame = solved.history.to_frame()
        self.assertEqual(list(frame.columns), solved.history.names)
        self.assertEqual(len(frame), 3)
        stiffness = solved.effective["normal_stiffness"]
        self.assertEqual(stiffness.unit, "N/m")
        self.assertAlmostEqual(stiffness.value / (2 * MODULUS * solved.history["contact_radius"][-1]), 1, delta=0.05)
        parameters = asperity.derive(self.folder / "solved", self.folder / "parameters.json")
        self.assertEqual(parameters[0], json.loads((self.folder / "parameters.json").read_text()))

    def test_a_solution_is_not_overwritten_unasked(self):
        (self.folder / "solved").mkdir()
        (self.folder / "solved" / "result.json").write_text("{}")
        with self.assertRaises(asperity.InputError):
            asperity.solve(self.case(), self.folder / "solved")
        self.assertEqual((self.folder / "solved" / "result.json").read_text(), "{}")

    def test_ctrl_c_ends_the_program_and_what_was_solved_is_gone_on_with(self):
        script = ("import asperity, sys\n"
                  "asperity.solve(sys.argv[1], sys.argv[2], progress=lambda line: print(line, flush=True))\n")
        person = subprocess.Popen([sys.executable, "-c", script, self.case(), self.folder / "solved"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        for line in person.stdout:
            if line.startswith("step 2/"):
                break
        person.send_signal(signal.SIGINT)
        _, said = person.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", said)
        history = self.folder / "solved" / "history.csv"
        written = history.stat().st_mtime_ns
        time.sleep(1)
        self.assertEqual(history.stat().st_mtime_ns, written)  # nothing goes on by itself
        self.assertFalse(asperity.read_case(self.folder / "solved").finished)
        self.assertTrue(asperity.solve(self.case(), self.folder / "solved", resume=True).finished)


class Diagnoses(InAFolder):
    def recording(self):
        """Hertz' contact behind a spring, forth and back."""
        rows = ["time [s],normal_displacement [m],normal_force [N],segment"]
        dice = np.random.default_rng(1)
        for i in range(200):
            depth = 40e-9 * (i if i < 100 else 199 - i) / 99
            force = 4 / 3 * MODULUS * math.sqrt(RADIUS) * depth**1.5
            rows.append(f"{0.1 * i},{depth + 8e-6 * force},{force + 5e-6 * dice.standard_normal()},"
                        f"{'load' if i < 100 else 'unload'}")
        folder = self.folder / "recording"
        folder.mkdir()
        (folder / "pressed.csv").write_text("\n".join(rows) + "\n")
        glass = {"material": "borosilicate", "youngs_modulus": "71 GPa", "poissons_ratio": 0.17, "radius": "8.5 um"}
        wafer = {"material": "silicon", "youngs_modulus": "179 GPa", "poissons_ratio": 0.25}
        table = {"file": "pressed.csv", "kind": "trace", "control": ["normal_displacement"], "response": "normal_force"}
        (folder / "recording.json").write_text(json.dumps({
            "format": "asperity-recording/1", "title": "pressed", "mode": "normal", "particle": glass, "substrate": wafer,
            "tables": [table]}))
        return folder

    def test_in_this_process_and_by_the_program_are_the_same(self):
        steps = []
        recording = self.recording()
        here = asperity.diagnose(recording, progress=steps.append)
        self.assertEqual(here.verdict, "explained", here.in_words)
        self.assertEqual(list(here.left_out), ["instrument_compliance"])
        low, high = here.left_out["instrument_compliance"]["parameters"]["compliance"]["ci95"]
        self.assertTrue(low < 8e-6 < high)
        self.assertTrue(steps)
        frame = here.to_frame()
        self.assertEqual(len(frame), 200)
        left = frame["normal_force"] - frame["simulated_after"]
        self.assertAlmostEqual(math.sqrt((left**2).mean()) / here.document["improved"]["rms"]["normal_force"]["value"], 1, places=6)
        there = asperity.diagnose(recording, output=self.folder / "diagnosis")
        self.assertEqual(there.document, here.document)
        self.assertEqual(there.tables[0]["file"], "pressed.csv")
        for name, values in here.tables[0]["columns"].items():
            np.testing.assert_allclose(there.tables[0]["columns"][name], values, rtol=1e-9)

    def test_ctrl_c_in_a_callback_ends_it(self):
        def stop(_):
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            asperity.diagnose(self.recording(), progress=stop)

    def test_a_case_needs_a_folder_for_its_solutions(self):
        with self.assertRaisesRegex(asperity.InputError, "pass output="):
            asperity.diagnose(self.recording(), case=self.case())


class Examples(InAFolder):
    def test_run_as_they_stand(self):
        for example in sorted((SOURCE / "python" / "examples").glob("*.py")):
            with self.subTest(example=example.name):
                done = subprocess.run([sys.executable, example], cwd=self.folder, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                # What an example prints stands at its end.
                expected = [line[2:] for line in example.read_text().splitlines() if line.startswith("# prints: ")]
                for line in expected:
                    self.assertIn(line[len("prints: "):], done.stdout)
                self.assertTrue(expected)


class Module(unittest.TestCase):
    def test_says_the_programs_version_and_describes_all_it_offers(self):
        self.assertRegex(asperity.__version__, r"^\d+\.\d+\.\d+$")
        for name in asperity.__all__:
            self.assertTrue((getattr(asperity, name).__doc__ or "").strip(), name)


if __name__ == "__main__":
    unittest.main()
