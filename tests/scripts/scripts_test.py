#!/usr/bin/env python3
"""Tests of the scripts that check tags and the verification page, make tables and mutants and run the nightly tests, with programs that only look like tests."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path += [str(TESTS.parent / "benchmarks"), str(TESTS / "mutation")]

import places  # noqa: E402
import readme_tables  # noqa: E402

# A program that lists and runs tests as Google Test does.
PROGRAM = """#!/bin/sh
case "$*" in
  *--gtest_list_tests*) printf '%s\\n' {listed} ;;
  *good*) printf 'topic,quantity,source,asked,measured,met,test\\n"Hertz","force, a/h 12","Hertz","1 %%","+0.5 %%","yes","X_analytic.good"\\n' \\
          > "$ASPERITY_VERIFICATION/good.csv"; echo '[  PASSED  ] 1 test.' ;;
  *wrong*) echo 'it was wrong'; exit 1 ;;
  *crash*) kill -SEGV $$ ;;
esac
"""


def program(folder, name, *listed):
    path = pathlib.Path(folder) / name
    path.write_text(PROGRAM.format(listed=" ".join(f"'{line}'" for line in listed)))
    path.chmod(0o755)
    return path


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True)


class Folders(unittest.TestCase):
    def check(self, files, lists=""):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in "core results surfaces half_space engines dem_compare paper diagnosis meshing fem report app".split():
                (root / name).mkdir()
                (root / name / "CMakeLists.txt").write_text(lists if name == "dem_compare" else "")
            for file, included in files.items():
                (root / file).parent.mkdir(exist_ok=True)
                place = included[1:] if included.startswith("!") else f"{file.split('/')[0]}/{included}"
                (root / file).write_text(f'#include "{place}"\n')
            return run(TESTS / "scripts/check_folders", root)

    def test_circles_between_folders_and_subfolders_are_found(self):
        self.assertEqual(self.check({"fem/contact/c.h": "solver/s.h"}).returncode, 0)
        circle = {"dem_compare/derive/a.h": "compare/b.h", "dem_compare/compare/b.cc": "derive/a.h"}
        inside = self.check(circle)
        self.assertEqual(inside.returncode, 1)
        self.assertIn("circle in dem_compare: compare, derive\n", inside.stdout)
        between = self.check({"core/a.h": "!report/b.h", "report/b.h": "!core/a.h"})
        self.assertIn("circle between folders: core, report\n", between.stdout)

    def test_an_include_beyond_the_linked_libraries_is_found(self):
        lists = "asperity_subfolder(laws)\nasperity_subfolder(motion LIBS laws numbers)\n"
        files = {"dem_compare/laws/a.cc": "numbers/n.h", "dem_compare/motion/m.cc": "laws/l.h"}
        found = self.check(files, lists)
        self.assertIn("laws/a.cc includes dem_compare/numbers, which laws does not link\n", found.stdout)
        self.assertIn("dem_compare/motion links numbers and includes nothing of it\n", found.stdout)


class Lengths(unittest.TestCase):
    def check(self, text, file="core/a.cc"):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text(text)
            return [line for line in run(TESTS / "scripts/check_lengths", folder).stdout.splitlines() if line.startswith(file)]

    @staticmethod
    def function(head, lines, foot="}"):
        """A function of so many lines between its first and its last."""
        return head + "\n" + "  ++i;\n" * lines + foot + "\n"

    def test_a_function_counts_from_its_first_line_to_its_closing_one(self):
        self.assertEqual(self.check(self.function("void f(int& i) {", 58)), [])
        self.assertEqual(self.check(self.function("void f(int& i) {", 59)), ["core/a.cc:1: f has 61 lines, more than 60"])
        self.assertEqual(self.check("namespace n::m {\n" + self.function("void f(int& i) {", 59)),
                         ["core/a.cc:2: f has 61 lines, more than 60"])
        self.assertEqual(self.check("\n" + self.function("void A::f(int& i,\n          int j) {", 58)),
                         ["core/a.cc:2: A::f has 61 lines, more than 60"])

    def test_methods_templates_constructors_and_operators_are_functions(self):
        long = 70
        for head, name in (("  void f(int& i) const override {", "f"), ("  template <class T>\n  T g(T& i) {", "g"),
                           ("  explicit A(int i) : i_{i}, j_(i) {", "A"), ("  bool operator<(const A& i) const {", "operator<"),
                           ("  auto h(int i) -> int {", "h")):
            found = self.check(f"namespace n::m {{\n\nclass A {{\n public:\n{self.function(head, long, '  }')}}};\n\n}}\n")
            self.assertEqual(len(found), 1, head)
            self.assertIn(f": {name} has ", found[0])

    def test_what_is_in_a_function_is_part_of_it_and_what_is_none_is_not_counted(self):
        inner = "  const auto g = [&](int k) {\n" + "    ++k;\n" * 57 + "  };\n"
        self.assertEqual(self.check("void f(int& i) {\n" + inner + "}\n"), ["core/a.cc:1: f has 61 lines, more than 60"])
        for text in ("const int table[] = {\n" + "    1,\n" * 70 + "};\n", "namespace n {\n" + "int f();\n" * 70 + "}\n",
                     "struct A {\n" + "  int a = 0;  // ) {\n" * 70 + "};\n",
                     'const char* const text = R"(void f(int i) {\n' + "++i;\n" * 70 + '})";\n'):
            self.assertEqual(self.check(text), [], text[:30])

    def test_a_file_has_300_lines(self):
        self.assertEqual(self.check("int f();\n" * 300), [])
        self.assertEqual(self.check("int f();\n" * 301), ["core/a.cc: 301 lines, more than 300"])
        self.assertEqual(self.check("int f();\n" * 301, "tests/core/a.cc"), [])

    def test_an_exception_that_is_none_is_named(self):
        source = (TESTS / "scripts/check_lengths").read_text()
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "check"
            script.write_text(source.replace("EXCEPTIONS = {", 'EXCEPTIONS = {"core/gone.cc: f": "it was long",', 1))
            found = run(sys.executable, script, folder)
            self.assertEqual(found.returncode, 1)
            self.assertIn("core/gone.cc: f: no longer too long, or gone", found.stdout)


class Tags(unittest.TestCase):
    def test_a_test_without_a_tag_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            found = run(TESTS / "scripts/check_tags", program(folder, "a", "Hertz_analytic.", "  force", "Csv.", "  reads_rows"))
            self.assertEqual(found.returncode, 1)
            self.assertIn("Csv.reads_rows", found.stderr)
            self.assertNotIn("Hertz", found.stderr)

    def test_tags_of_suites_tests_and_parametrised_tests_count(self):
        with tempfile.TemporaryDirectory() as folder:
            found = run(TESTS / "scripts/check_tags", program(folder, "a", "Hertz_analytic.", "  force", "Folder.", "  reads_rows_behaviour",
                                                              "All/OwnLaw_regression.", "  comes_back/first  # GetParam() = 1"))
            self.assertEqual((found.returncode, found.stdout.strip()), (0, "3 tests, each tagged"))


class Table(unittest.TestCase):
    HEADER = "topic,quantity,source,asked,measured,met,test\n"

    HERTZ = '"Hertz","force, a/h 12","Hertz (1882)","1 %","-0.67 %","yes","Hertz_analytic.silicon"'

    def files(self, folder, *rows, nightly=()):
        root = pathlib.Path(folder)
        for name, text in (("run/a.csv", self.HEADER + "".join(row + "\n" for row in rows)),
                           ("kept/b.csv", self.HEADER.strip() + ",date,commit\n" + "".join(row + "\n" for row in nightly)),
                           ("notes.md", "Of which this is not shown.\n\n## Sliding\n\nRings.\n\n## Hertz\n\nSmooth bodies.\n")):
            (root / name).parent.mkdir(exist_ok=True)
            (root / name).write_text(text)
        return root, ["--nightly", root / "kept", "--notes", root / "notes.md"]

    def table(self, *rows, nightly=()):
        with tempfile.TemporaryDirectory() as folder:
            root, options = self.files(folder, *rows, nightly=nightly)
            return run(TESTS / "verification/table", root / "run", *options)

    def test_rows_stand_under_their_topic_with_tag_and_commit(self):
        made = self.table(self.HERTZ)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn("## Hertz\n\nSmooth bodies.\n\n| quantity |", made.stdout)
        self.assertIn("| force, a/h 12 | analytic | Hertz (1882) | 1 % | -0.67 % | `Hertz_analytic.silicon` | 20", made.stdout)
        self.assertLess(made.stdout.index("## Sliding\n\nRings."), made.stdout.index("## Hertz"))
        self.assertNotIn("not shown", made.stdout)
        self.assertRegex(made.stdout, r"Written on \d{4}-\d\d-\d\d, commit \S+")

    def test_tests_that_did_not_run_have_the_rows_of_their_last_run(self):
        kept = ['"Hertz","force, a/h 24","Hertz (1882)","1 %","+0.2 %","yes","HertzNightly_analytic.fine","2026-11-20","abc"',
                self.HERTZ.replace("-0.67", "-0.9") + ',"2026-11-20","abc"']
        made = self.table(self.HERTZ, nightly=kept)
        self.assertIn("| force, a/h 24 | analytic | Hertz (1882) | 1 % | +0.2 % | `HertzNightly_analytic.fine` | nightly, 2026-11-20 |", made.stdout)
        self.assertNotIn("-0.9 %", made.stdout)

    def test_a_run_of_some_tests_leaves_the_others_rows_on_the_page(self):
        other = '"Sliding","force | shear","Cattaneo (1938)","2 %","+3 %","no","Mindlin_analytic.shift"'
        gone = other.replace("shift", "renamed")
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(self.table(self.HERTZ, other, gone).stdout.replace("`Mindlin_analytic.shift` | 20", "`Mindlin_analytic.shift` | 19"))
            root, options = self.files(folder, self.HERTZ.replace("-0.67", "-0.5"))
            (root / "a_test.cc").write_text("TEST(Mindlin_analytic, shift) {")
            made = run(TESTS / "verification/table", root / "run", "--onto", page, "--tests", root, *options)
        self.assertEqual(made.returncode, 0, made.stderr)  # what is not met is none of this run's
        self.assertIn("| force \\| shear | analytic | Cattaneo (1938) | 2 % | **+3 %, not met** | `Mindlin_analytic.shift` | 19", made.stdout)
        self.assertNotIn("renamed", made.stdout)
        self.assertIn("| -0.5 % | `Hertz_analytic.silicon`", made.stdout)
        self.assertNotIn("-0.67 %", made.stdout)

    def test_nightly_tests_without_rows_are_named(self):
        self.assertIn("## Nightly tests without a recorded run\n", self.table(self.HERTZ).stdout)

    def check(self, folder, *rows, said, options=()):
        root, places = self.files(folder, *rows)
        (root / "page.md").write_text(said)
        return run(TESTS / "verification/check", root / "run", "--page", root / "page.md", *places, *options)

    def test_a_page_that_asks_something_else_is_found(self):
        said = self.table(self.HERTZ, self.HERTZ.replace("a/h 12", "a | h 6")).stdout
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.check(folder, self.HERTZ, said=said).returncode, 0)
            whole = self.check(folder, self.HERTZ, said=said, options=["--all"])
            self.assertEqual(whole.returncode, 1)
            self.assertIn("the page has 'force, a | h 6' (asked: 1 %); Hertz_analytic.silicon asserts no such thing", whole.stderr)
            other = self.check(folder, self.HERTZ.replace("1 %", "2 %"), said=said)
            self.assertEqual(other.returncode, 1)
            self.assertIn("Hertz_analytic.silicon asserts 'force, a/h 12' (asked: 2 %); the page does not say so", other.stderr)
            moved = self.check(folder, self.HERTZ.replace("-0.67", "-0.66"), said=said)
            self.assertEqual(moved.returncode, 0, moved.stderr)

    def test_topics_without_a_heading_and_tables_by_hand_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root, options = self.files(folder)
            (root / "a_test.cc").write_text('test::Verified{"Hertz", what};\nVerified rolls(const char* what) {\n  return {"Rollling", what};\n}\n')
            with (root / "notes.md").open("a") as notes:
                notes.write("\n| quantity | asked |\n")
            found = run(TESTS / "verification/check", "--tests", root, *options)
            self.assertEqual(found.returncode, 1)
            self.assertIn("a_test.cc: the topic 'Rollling' has no heading", found.stderr)
            self.assertIn("Hertz: a table written by hand", found.stderr)
            self.assertNotIn("the topic 'Hertz'", found.stderr)

    def test_what_is_not_met_is_said_and_fails(self):
        made = self.table('"Hertz","force","Hertz","1 %","+2 %","no","Hertz_analytic.silicon"')
        self.assertEqual(made.returncode, 1)
        self.assertIn("**+2 %, not met**", made.stdout)

    def test_no_rows_and_no_tag_are_refused(self):
        self.assertEqual(self.table().returncode, 1)
        self.assertIn("does not say where", self.table('"Hertz","force","Hertz","1 %","0 %","yes","Hertz.silicon"').stderr)


class Format(unittest.TestCase):
    def check(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.cc"
            (pathlib.Path(folder) / ".clang-format").write_text("BasedOnStyle: Google\nColumnLimit: 110\n")
            file.write_text(text)
            return run(TESTS / "scripts/check_format", file)

    def test_files_that_are_not_formatted_and_long_lines_are_named(self):
        self.assertEqual(self.check("int a = 1;\n").returncode, 0)
        spaced = self.check("int  a = 1;\n")
        self.assertEqual(spaced.returncode, 1)
        self.assertRegex(spaced.stderr, r"a\.cc: clang-format -i ")
        long = self.check('const char* a = R"(' + 100 * "x" + ')";\n')
        self.assertEqual(long.returncode, 1)
        self.assertRegex(long.stderr, r"a\.cc:1: more than 110 characters")


class Nightly(unittest.TestCase):
    def record(self, *listed):
        with tempfile.TemporaryDirectory() as folder:
            program(folder, "core_tests", *listed)
            page, rows = pathlib.Path(folder) / "deep" / "page.md", pathlib.Path(folder) / "rows"
            done = run(TESTS / "nightly/run", "--build", folder, "--record", page, "--rows", rows)
            self.kept = {path.name: path.read_text() for path in rows.glob("*.csv")}
            return done.returncode, page.read_text() if page.exists() else ""

    def test_the_record_has_commit_outcome_time_and_what_was_measured(self):
        status, page = self.record("XNightly_analytic.", "  good")
        self.assertEqual(status, 0)
        self.assertRegex(page, r"# Nightly tests of \d{4}-\d\d-\d\d")
        self.assertRegex(page, r"Commit \S+")
        self.assertIn("| `XNightly_analytic.good` | passed | 0 s |", page)
        self.assertIn("| Hertz | force, a/h 12 | Hertz | 1 % | +0.5 % |", page)
        self.assertIn("`fem_tests` is not built", page)
        self.assertRegex(self.kept["good.csv"], r'"yes","X_analytic.good","\d{4}-\d\d-\d\d","[^"]+"\n')

    def test_failures_and_crashes_are_in_the_record_and_in_the_status(self):
        status, page = self.record("XNightly_analytic.", "  good", "  wrong", "  crash")
        self.assertEqual(status, 1)
        self.assertIn("3 tests: 1 passed, 2 failed", page)
        self.assertIn("| `XNightly_analytic.wrong` | **FAILED** |", page)
        self.assertIn("| `XNightly_analytic.crash` | **FAILED: signal 11** |", page)

    def test_no_test_at_all_is_a_failure(self):
        self.assertEqual(self.record("")[0], 1)


class Benchmarks(unittest.TestCase):
    SIZE = {"spacing": "20 nm", "unknowns": 130638, "contact_nodes": 1, "steps": 20, "wall_time": 35.2, "newton_per_step": 8.0, "most_newton_in_a_step": 10,
            "cg_per_step": 41, "cg_per_newton": 5.13, "peak_memory": 2 ** 28, "bytes_per_unknown": 1600, "contact_area_at_largest_load": 1.64e-13}
    REPORT = {"machine": {"processor": "A", "cores": 2, "load": [1.0, 1, 1], "time": "2026-11-23T12:00:00Z"}, "threads": 2,
              "run": {"commit": "abc1234", "load_after": 2.0}, "sizes": [SIZE]}

    def test_the_table_has_commit_date_unknowns_and_iterations_of_the_run(self):
        text = readme_tables.rough_contact(self.REPORT)
        self.assertIn("Commit abc1234, 2026-11-23, A, 2 cores, 2 threads, load before and after 1.0, 2.0.", text)
        self.assertIn("| 20 nm | 130 638 | 20 | 35 s | 8.0 (10) | 41 | 5.1 | 0.25 GiB | 1.60 kB | 0.1640 um^2 |", text)

    def test_a_table_replaces_the_one_of_its_name_alone(self):
        page = "a\n" + readme_tables.block("x", "old\n") + "\nb\n" + readme_tables.block("y", "kept\n")
        self.assertEqual(readme_tables.replaced(page, "x", "new\n"), page.replace("old", "new"))
        self.assertRaises(ValueError, readme_tables.replaced, page, "z", "new\n")

    def test_the_page_has_a_place_for_every_table(self):
        page = (TESTS.parent / "benchmarks" / "README.md").read_text()
        for name in readme_tables.TABLES:
            readme_tables.replaced(page, name, "")


class Mutants(unittest.TestCase):
    def of(self, line):
        return {operator: places.schema(line, 7, begin, end, mutated) for operator, begin, end, mutated in places.places_in(line)}

    def test_a_change_is_put_beside_the_whole_expression_it_stands_in(self):
        made = self.of("  const double x = f(a + b, 2 * c), y = a;")
        self.assertEqual(made["plus and minus"], "  const double x = f((asperity_mutant(7) ? (a - b) : (a + b)), 2 * c), y = a;")
        self.assertEqual(made["integer plus one"], "  const double x = f(a + b, (asperity_mutant(7) ? (3) : (2)) * c), y = a;")
        self.assertEqual(self.of("  return a + b * c;")["times and over"], "  return (asperity_mutant(7) ? (a + b / c) : (a + b * c));")
        self.assertEqual(self.of("  y = 1 / std::sqrt(1 + x);")["root dropped"], "  y = 1 / (asperity_mutant(7) ? ((1 + x)) : (std::sqrt(1 + x)));")

    def test_what_is_no_code_or_goes_on_in_another_line_is_left_alone(self):
        for line in ("// a + b", '  say("a + b");', "  constexpr double x = 2.5;", "  const double x = a +", "      a + b *", '  text = name + " is";'):
            self.assertEqual(self.of(line), {}, line)

    def test_every_room_is_mutated_or_left_out_for_a_reason(self):
        self.assertEqual(list(places.unnamed(TESTS.parent)), [])

    def test_a_folder_that_no_list_names_and_a_name_without_code_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "CMakeLists.txt").write_text("add_subdirectory(core)\nadd_subdirectory(fem)\nadd_subdirectory(wear)\nadd_subdirectory(tests)\n")
            for file in ("core/a.cc", "fem/a.cc", "fem/lubrication/a.h", "wear/a.cc", "tests/core/a.cc"):
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).touch()
            found = list(places.unnamed(root))
        for name in ("wear", "fem/lubrication"):
            self.assertIn(f"{name} has code, but neither FOLDERS nor LEFT_OUT names it", found)
        self.assertIn("paper is named, but no room of the build has code there", found)
        self.assertFalse([line for line in found if line.startswith(("core ", "fem ", "tests"))])


if __name__ == "__main__":
    unittest.main()
