#!/usr/bin/env python3
"""install_test.py BUILD PYTHON: what `cmake --install` leaves works from where it is, without the source and the build."""

import gzip
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BUILD, PYTHON = pathlib.Path(sys.argv.pop(1)), sys.argv.pop(1)


def output_of(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode:
        raise AssertionError(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.held.cleanup)
        cls.prefix = pathlib.Path(cls.held.name) / "prefix"
        output_of("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.program = cls.prefix / "bin" / "asperity"

    def test_the_program_solves_nothing_of_its_build_is_needed(self):
        self.assertRegex(output_of(self.program, "--version"), r"^asperity \d")
        case = pathlib.Path(self.held.name) / "case.prm"
        case.write_text(output_of(self.program, "case-template"))
        # A command of asperity-solver, which lies in libexec.
        self.assertIn("stiffness", output_of(self.program, "preview", case))
        self.assertIn(str(self.prefix / "share" / "asperity" / "runs"), output_of(self.program, "paper", "--help"))
        self.assertTrue((self.prefix / "share" / "asperity" / "challenge").is_dir())

    def test_another_project_finds_the_libraries(self):
        build = pathlib.Path(self.held.name) / "consumer"
        output_of("cmake", "-S", HERE / "consumer", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        output_of("cmake", "--build", build)
        # RMS of the surface as asked for, and Hertz' approach: 28.7 nm at 1 mN.
        self.assertEqual(output_of(build / "consumer"), "1.5 nm 28.7 nm\n")

    def test_every_subcommand_has_a_manual_page_and_is_offered(self):
        pages = {page.name[:-len(".1.gz")] for page in (self.prefix / "share" / "man" / "man1").iterdir()}
        self.assertTrue({"asperity", "asperity-solve", "asperity-surface-measure", "asperity-diagnose"} <= pages)
        solve = gzip.decompress((self.prefix / "share/man/man1/asperity-solve.1.gz").read_bytes()).decode()
        self.assertIn(".SH SYNOPSIS", solve)
        self.assertIn("\\-\\-resume", solve)
        completion = self.prefix / "share" / "bash-completion" / "completions" / "asperity"

        def offered(*words):
            script = (f"source {completion}; COMP_WORDS=({' '.join(words)}); COMP_CWORD={len(words) - 1}; _asperity; "
                      "echo ${COMPREPLY[@]}")
            return output_of("bash", "-c", script).split()

        self.assertEqual(offered("asperity", "diag"), ["diagnose"])
        self.assertEqual(offered("asperity", "surface", "meas"), ["measure"])
        self.assertEqual(offered("asperity", "surface", "measure", "scan.gwy", "--lev"), ["--level"])

    def test_python_finds_the_installed_program(self):
        module = self.prefix / "lib" / "python3" / "dist-packages"
        if not module.is_dir():
            self.skipTest("built without pybind11")
        said = output_of(PYTHON, "-c", "import asperity; print(asperity.program.program())",
                         env={**os.environ, "PYTHONPATH": str(module)})
        self.assertEqual(said.strip(), str(self.program))


if __name__ == "__main__":
    unittest.main()
