#!/usr/bin/env python3
"""Tests of check_headers, with small headers that lack something."""

import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent / "check_headers"


def header(body, opening="// What holds a contact."):
    return f"{opening}\n#pragma once\n\nnamespace asperity {{\n\n{body}\n}}  // namespace asperity\n"


class Headers(unittest.TestCase):
    def said(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            run = subprocess.run([SCRIPT, root], capture_output=True, text=True)
            self.assertEqual(run.returncode == 0, run.stderr == "", run.stderr)
            return run.stderr

    def test_a_header_that_says_everything_passes(self):
        body = """/// One contact.
struct Contact {
  double radius = 0;  ///< R [m]
  enum class Control { force, displacement } control = Control::force;
  double x = 0, y = 0;  ///< place
                        ///< [m]
  bool is_open() const { return radius == 0; }
  /// Its area [m^2].
  double area() const { return radius * radius; }
  double half_area() const { return area() / 2; }
};

/// Throws InputError for a radius below 0. radius [m]
Contact contact_of(double radius);
template <class T>
T of_the_same_group(const T& contact, double radius = 0);
"""
        self.assertEqual(self.said({"core/a.h": header(body), "core/a.cc": 'Contact contact_of(double r) { throw InputError("no"); }'}), "")

    def test_a_header_without_an_opening_comment_is_named(self):
        self.assertIn("core/a.h:1: opening", self.said({"core/a.h": "#pragma once\n\n/// One.\nint one();\n"}))

    def test_types_functions_and_methods_without_docstring_are_named(self):
        body = "class Loop {\n public:\n  void run();\n  bool open() const { return open_; }\n\n private:\n  void step();\n  bool open_;\n};\n\nint turn(int by);\n"
        said = self.said({"core/a.h": header(body)})
        for line, name in ((6, "Loop"), (8, "Loop::run"), (16, "turn")):
            self.assertIn(f"core/a.h:{line}: doc: {name} has no docstring", said)
        self.assertEqual(said.count(": doc: "), 3, said)

    def test_the_opening_comment_stands_for_what_the_header_is_named_after(self):
        body = "struct Loop {};\n\nLoop loop();\n"
        self.assertEqual(self.said({"core/loop.h": header(body)}), "")
        self.assertEqual(self.said({"core/other.h": header(body)}).count(": doc: "), 2)

    def test_an_empty_line_ends_a_group(self):
        self.assertIn("core/a.h:9: doc: two", self.said({"core/a.h": header("/// One.\nint one();\n\nint two();\n")}))

    def test_doubles_without_unit_are_named(self):
        body = "/// A sphere.\nstruct Sphere {\n  double radius = 0;  ///< of the sphere\n};\n\n/// Its volume.\ndouble volume(double radius);\n"
        said = self.said({"core/a.h": header(body)})
        self.assertIn("core/a.h:8: unit: 'double radius = 0' has no unit", said)
        self.assertIn("core/a.h:12: unit: volume", said)
        self.assertEqual(self.said({"core/a.h": header(body, "// Spheres. SI units.")}), "")

    def test_errors_that_a_definition_throws_are_asked_for(self):
        files = {"core/a.h": header("/// Reads.\nint read();\n\n/// One.\nint one();\n"),
                 "core/a.cc": 'int read() { throw InputError("no"); }\nnamespace {\nint one() { throw WorkError("no"); }\n}\n'}
        said = self.said(files)
        self.assertIn("core/a.h:7: throws: read", said)
        self.assertNotIn("one throws", said)

    def test_laws_name_author_and_year(self):
        law = "/// Coulomb friction.\ninline const Registered<FrictionLawDeclaration> coulomb{{}};\n"
        self.assertIn("fem/a.h:1: source", self.said({"fem/a.h": header(law)}))
        self.assertEqual(self.said({"fem/a.h": header(law, "// |t| <= mu p. Coulomb (1785).")}), "")

    def test_methods_of_an_interface_are_described_there_once(self):
        files = {"core/any.h": header("/// Any law.\nstruct Any {\n  /// What all do.\n  class Interface {\n   public:\n    /// The next force [N].\n"
                                      "    virtual double advance(double x) = 0;\n  };\n};\n"),
                 "core/one.h": header("/// One law.\nstruct One {\n  double advance(double x) const { return 2 * x; }\n};\n")}
        self.assertEqual(self.said(files), "")


if __name__ == "__main__":
    unittest.main()
