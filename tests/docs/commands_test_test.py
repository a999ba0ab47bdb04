#!/usr/bin/env python3
"""Tests of commands_test: it takes apart pages as it should, and finds output that is not as shown."""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

import commands_test as tested  # noqa: E402


class Pages(unittest.TestCase):
    def test_blocks_of_commands_and_of_what_they_print_are_taken_and_no_others(self):
        page = "a\n```sh\nls\n```\nb\n```text\nx\n```\n```\nnone\n```\n"
        self.assertEqual(tested.blocks(page), [("sh", "ls\n"), ("text", "x\n")])

    def test_lines_are_joined_behind_a_backslash_and_within_a_document(self):
        script = "a \\\n   b\n\ncat > f <<'END'\nline\n\nb \\\nEND\nc\n"
        self.assertEqual(tested.lines_of(script), ["a b", "cat > f <<'END'\nline\n\nb \\\nEND", "c"])

    def test_a_long_command_is_made_lighter_and_what_needs_it_left_out(self):
        self.assertEqual(tested.lighter("ls"), ("ls", False))
        code, changed = tested.lighter("build/asperity solve film.prm --output film   # slow")
        self.assertTrue(changed)
        self.assertEqual(code, "build/asperity solve film.prm --output film " + tested.COARSE)
        self.assertEqual(tested.lighter("cat characterised/contact.lammps"), ("", True))


class Output(unittest.TestCase):
    def test_numbers_agree_within_two_percent_and_words_as_they_are(self):
        self.assertTrue(tested.agrees("area 0.159 um^2", "step 4  area 0.1601 um^2  p_max 3"))
        self.assertFalse(tested.agrees("area 0.159 um^2", "area 0.165 um^2"))
        self.assertFalse(tested.agrees("area 0.159 um^2", "aera 0.159 um^2"))
        self.assertFalse(tested.agrees("-1e-9 m", "1e-9 m"))

    def test_dots_stand_for_anything(self):
        self.assertTrue(tested.agrees("falls from ... to 1.03 ..., which is noise", "falls from 4e3 to 1.03 (kept out: 5), which is noise."))
        self.assertFalse(tested.agrees("falls from ... to 1.03", "to 1.03 falls from 2"))

    def test_lines_are_asked_for_in_their_order(self):
        self.assertIsNone(tested.missing("a 1\n...\nc 3\n", "a 1\nb 2\nc 3\n"))
        self.assertEqual(tested.missing("c 3\na 1\n", "a 1\nb 2\nc 3\n"), "a 1")


if __name__ == "__main__":
    unittest.main()
