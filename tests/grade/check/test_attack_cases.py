"""test_attack_cases.py - the files of attacks are read as they are meant, and a slip in one is an error."""
import re
import tempfile
import unittest
from pathlib import Path

from grade import exercises
from grade.attacks import cases

GOOD = """// some.c - what they have in common.

// ---- one: tries this,
// and that.
// stem: 01-corners
// expect: crashed | graded
// earns: perhaps upper_left
// says: killed | by itself
#include "exercises/01-corners.h"

int a;

// ---- two: tries @PLACE@.
// stem: 03-screen
// expect: graded
// earns: nothing
// rest: none
int b;
"""


class Sections(unittest.TestCase):
    def refused(self, text, words):
        with self.assertRaisesRegex(ValueError, words):
            cases.sections_of(text, "some.c")

    def test_each_is_a_submission_with_its_own_title(self):
        one, two = cases.sections_of(GOOD, "some.c")
        self.assertEqual((one.name, two.name), ("one", "two"))
        self.assertEqual(two.text, "// two: tries @PLACE@.\n// stem: 03-screen\n// expect: graded\n// earns: nothing\n"
                                   "// rest: none\nint b;\n")
        self.assertTrue(one.text.startswith("// one: tries this,\n// and that.\n// stem:"))
        self.assertTrue(one.text.endswith("\n\nint a;\n"))
        self.assertEqual(one.head, {"stem": "01-corners", "expect": "crashed | graded",
                                    "earns": "perhaps upper_left", "says": "killed | by itself"})

    def test_what_must_come_of_it(self):
        one, two = cases.sections_of(GOOD, "some.c")
        functions = {"upper_left", "upper_right"}
        self.assertEqual(cases.expected(one.head, functions), cases.Expected(
            {"crashed", "graded"}, perhaps={"upper_left"}, says=["killed", "by itself"]))
        self.assertEqual(cases.expected(two.head, functions), cases.Expected({"graded"}))
        self.assertEqual(cases.expected({**two.head, "earns": "everything"}, functions).earns, functions)
        with self.assertRaisesRegex(ValueError, "lower_left: no function of 03-screen"):
            cases.expected({**two.head, "earns": "upper_left lower_left"}, functions)

    def test_a_slip_is_an_error(self):
        self.refused(GOOD.replace("some.c", "other.c"), "some.c: expected '// some.c - ")
        self.refused(GOOD.replace("common.\n", "common.\nint a;\n"), "expected '// some.c - ")
        self.refused(GOOD.replace("---- two: tries", "---- two tries"), "two tries.*expected '// ---- name: ")
        self.refused(GOOD.replace("// expect: graded\n", ""), "some.c, two: expected the lines stem, expect and earns")
        self.refused(GOOD.replace("expect: graded", "expect: passed"), "some.c, two: expect: passed: ")
        self.refused(GOOD[:GOOD.index("// ----")], "no section")

    def test_two_of_one_name_are_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("some.c", "other.c"):
                Path(folder, name).write_text(GOOD.replace("some.c", name))
            with self.assertRaisesRegex(ValueError, "one is there twice"):
                cases.read(Path(folder))


class Attacks(unittest.TestCase):
    def test_all_of_them_are_there_and_ask_for_what_exists(self):
        prototypes = cases.by_stem(exercises.read())
        found = cases.read()
        sections = sum(len(re.findall("^// ---- ", path.read_text(), re.M)) for path in cases.FOLDER.glob("*.c"))
        self.assertEqual(len(found), sections)
        self.assertGreaterEqual(len(found), 223)    # none was lost when they were put into one file for each family
        for case in found.values():
            self.assertIn(case.head["stem"], prototypes, case.name)
            cases.expected(case.head, prototypes[case.head["stem"]])

    def test_blanks_are_added_for_what_is_missing_only(self):
        prototypes = {"upper_left": "vec3 upper_left(Camera c)", "fill": "void fill(int *at)"}
        text = cases.completed("vec3 upper_left(Camera c)\n{\n}\n", prototypes)
        self.assertEqual(text.count("upper_left("), 1)
        self.assertIn("void fill(int *at)\n{\n    NOT_ANSWERED_YET();\n}\n", text)

    def test_places_are_filled_in(self):
        self.assertEqual(cases.filled("@TREE@/x @HOME@", {"TREE": Path("/t")}), b"/t/x @HOME@")
