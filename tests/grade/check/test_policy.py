"""test_policy.py - what an answer is worth, and what a late one loses."""
import os
import time
import unittest
from fractions import Fraction
from datetime import datetime, timezone
from pathlib import Path
from types import SimpleNamespace

from grade import exercises
from grade import policy
from .fixtures import WithFolder

CONTRACTS = Path(__file__).resolve().parents[3] / "exercises"
DUE = int(datetime(2025, 11, 14, 22, 59, tzinfo=timezone.utc).timestamp())
HOUR = 3600
DAILY = "late 10% per day, at most 50%"


def made(stem, count):
    return [exercises.Exercise(stem, f"{'abcdefgh'[i]}_{stem[:2]}", "int f(void)", "slide", "?")
            for i in range(count)]


KNOWN = made("01-one", 3) + made("02-two", 1) + made("12-new", 4)


class Written(WithFolder):
    def setUp(self):
        super().setUp()
        self.file = self.work / "policy"

    def zone(self, name):
        """The time zone of this machine, in this test."""
        was = os.environ.get("TZ")
        self.addCleanup(time.tzset)
        self.addCleanup(os.environ.pop if was is None else os.environ.update,
                        *(("TZ", None) if was is None else ({"TZ": was},)))
        os.environ["TZ"] = name
        time.tzset()

    def load(self, text):
        self.file.write_text(text, encoding="utf-8")
        return policy.load(self.file, KNOWN)

    def refused(self, text, line, *parts):
        with self.assertRaises(policy.PolicyError) as caught:
            self.load(text)
        words = str(caught.exception)
        self.assertTrue(words.startswith(f"{self.file}:{line}: "), words)
        self.assertIn("expected", words)
        for part in parts:
            self.assertIn(part, words)


class TheList(unittest.TestCase):
    def test_the_exercises_are_those_of_the_course_in_order(self):
        known = exercises.read()
        self.assertEqual(exercises.stems(known), sorted(file.stem for file in CONTRACTS.glob("*.h")))
        for exercise in known:
            contract = (CONTRACTS / f"{exercise.stem}.h").read_text(encoding="utf-8")
            self.assertIn(f" {exercise.name}(", contract)
            self.assertIn(f" {exercise.name}(", exercise.prototype)
        self.assertEqual(known[0], exercises.Exercise(
            "01-corners", "upper_left", "vec3 upper_left(Camera c)", "Finding vectors from the eye",
            "Give an expression for the upper left corner."))
        self.assertEqual(known[-1].name, "sphere_rectangle")


class Points(Written):
    def test_the_policy_of_the_house_is_a_hundred_points(self):
        known = exercises.read()
        ours = policy.load(policy.DEFAULT, known)
        each = {"01-corners": 2, "02-cameras": 3, "03-screen": 3, "04-pixel-ray": 5,
                "05-quadratic": 4, "06-ray-casting": 5, "07-shading": 2, "08-fast": 0}
        for exercise in known:
            given = exercise.name == "sphere_roots"  # made of the student's other answers
            self.assertEqual(policy.points(ours, exercise.stem, exercise.name),
                             0 if given else each[exercise.stem])
        self.assertEqual(sum(policy.points(ours, e.stem, e.name) for e in known), 100)
        self.assertIsNone(ours.due)

    def test_a_chapter_s_points_are_shared(self):
        for text, letters, stem, points in (
                ("", "abcd", "12-new", [2.5] * 4),                          # it is not named
                ("points others 8\npoints 02-two 3", "abcd", "12-new", [2] * 4),
                ("points others 8\npoints 02-two 3", "a", "02-two", [3]),
                ("points 01-one 10", "abc", "01-one", [3.34, 3.33, 3.33]),  # what does not divide still adds up
                ("points 01-one 0", "abc", "01-one", [0, 0, 0]),
                ("points 12-new 20\npoints 12-new c_12 6.5", "abcd", "12-new", [4.5, 4.5, 6.5, 4.5]),
                ("points 12-new c_12 6.5\npoints 12-new 20", "abcd", "12-new", [4.5, 4.5, 6.5, 4.5]),
                ("\ufeff#x\r\n  points   01-one\t6 # six\r\n", "abc", "01-one", [2, 2, 2])):
            ours = self.load(text)
            self.assertEqual([policy.points(ours, stem, f"{letter}_{stem[:2]}") for letter in letters], points, text)

    def test_functions_may_not_have_more_than_their_chapter(self):
        self.refused("points 12-new c_12 6\npoints 12-new 5\n\n", 2, "6 points", "5")
        self.refused("points 02-two a_02 6", 1, "6 points", "10")


class Strict(Written):
    def test_what_is_not_understood_is_an_error_with_its_line(self):
        for line, part in (
                ("weight 01-one 3", "weight is not a setting"), ("points", "CHAPTER"),
                ("points 07-none 3", "no chapter is called 07-none"), ("points 01 3", "01-one"),
                ("points 01-one f 3", "has no function f"), ("points others a_01 3", "others"),
                ("points 01-one a_02 3", "no function a_02"), ("points 01-one -1", "0 to 1000"),
                ("points 01-one 1001", "0 to 1000"), ("points 01-one nan", "nan"),
                ("points 01-one 1e2", "1e2"), ("points 01-one 1.234", "two decimals"),
                ("points 01-one 0x10", "0x10"), ("points 01-one ١", "١"),
                ("points 01-one a_01 3 4", "CHAPTER"), ("due", "2025"),
                ("due tomorrow", "tomorrow"),
                ("due 2025-11-14", "2025-11-14"), ("due 2025-13-14T10:00", "2025-13"),
                ("due 2025-11-14T25:00", "T25"), ("due 2025-11-14T10:00+25:00", "+25"),
                ("due 2025-11-14T10:00 GMT", "GMT"), ("grace", "0 to 10080"), ("grace -1", "-1"),
                ("grace 10081", "10081"), ("grace 5 minutes", "5 minutes"), ("late 10", "late 10"),
                ("late 10% per week, at most 50%", "per hour"),
                ("late 101% per day, at most 50%", "101"),
                ("late 10% per day, at most x%", "x"), ("late 10% per day", "at most"),
                ("times", "CSV"), ("times nowhere.csv", "No such file"),
                ("points\x1b[2J 1", "\\x1b")):
            self.refused(f"# title\n\n{line}\n", 3, part)

    def test_what_is_said_twice_is_an_error(self):
        for line in ("points 01-one 3", "points 01-one a_01 3", "due none", "grace 1",
                     "times files"):
            self.refused(f"{line}\n{line}", 2, "twice")

    def test_a_policy_that_cannot_be_read_is_an_error(self):
        self.assertRaisesRegex(policy.PolicyError, "No such file", policy.load, "/nowhere", KNOWN)
        self.file.write_bytes(b"\xff")
        self.assertRaises(policy.PolicyError, policy.load, self.file, KNOWN)


class Late(Written):
    HEAD = "due 2025-11-14T23:59+01:00\ngrace 15\n"

    def late(self, after, score=80.0, how=DAILY):
        return policy.late(self.load(self.HEAD + how), DUE + after, score)

    def test_a_day_or_an_hour_that_has_begun_counts(self):
        for after, score, how, left in (
                (-10 ** 6, 80, DAILY, 80), (0, 80, DAILY, 80), (15 * 60, 80, DAILY, 80),    # in time
                (15 * 60 + 1, 80, DAILY, 72), (24 * HOUR, 80, DAILY, 72), (24 * HOUR + 1, 80, DAILY, 64),
                (96 * HOUR + 1, 80, DAILY, 40), (10 ** 9, 80, DAILY, 40),
                (3 * HOUR + 1, 80, "late 1.5% per hour, at most 100%", 75.2),
                (HOUR, 0.05, DAILY, 0.05), (HOUR, 33.33, DAILY, 30)):   # 0.045, 29.997: half up to hundredths
            marks, words = self.late(after, score, how)
            self.assertEqual((marks, words != ""), (left, after > 15 * 60), (after, words))

    def test_the_words_tell_when_and_how_much(self):
        self.assertEqual(self.late(25 * HOUR + 180)[1],
                         "due 2025-11-14 23:59 +0100, 1 d 1 h 3 min late: 20% off, 80 became 64")

    def test_extra_days_make_the_due_time_later(self):
        ours = self.load(self.HEAD + DAILY)
        for after, extra, left in ((48 * HOUR, 2, 80), (48 * HOUR, 1, 72), (48 * HOUR + 3600, Fraction(1, 2), 64)):
            self.assertEqual(policy.late(ours, DUE + after, 80.0, Fraction(extra))[0], left)
        self.assertIn("due 2025-11-15 23:59", policy.late(ours, DUE + 48 * HOUR, 80.0, Fraction(1))[1])

    def test_late_none_is_said_and_costs_nothing(self):
        left, words = self.late(HOUR, how="late none")
        self.assertEqual(left, 80)
        self.assertIn("1 h late: that costs nothing", words)

    def test_marks_are_rounded_half_up(self):
        self.assertEqual(policy.rounded(1.005), 1.01)
        self.assertEqual(policy.rounded(0.1 + 0.2), 0.3)

    def test_without_a_due_time_nothing_is_late(self):
        ours = self.load(DAILY)
        self.assertEqual(policy.late(ours, 10 ** 12, 80.0), (80, ""))

    def test_who_came_in_at_no_known_time_is_on_time(self):
        left, words = policy.late(self.load(self.HEAD), None, 80.0)
        self.assertEqual(left, 80)
        self.assertIn("not known", words)

    def test_any_time_of_a_file_is_a_time(self):
        for when in (-2 ** 63, 2 ** 63, 0):
            policy.late(self.load(self.HEAD), when, 80.0)

    def test_a_time_without_an_offset_is_that_of_this_machine(self):
        self.zone("EST+5")
        self.assertEqual(self.load("due 2025-11-14 17:59").due.timestamp(), DUE)

    def test_offsets_are_read(self):
        for text in ("2025-11-14T22:59Z", "2025-11-14T22:59:00+00:00", "2025-11-14T17:29-05:30"):
            self.assertEqual(self.load("due " + text).due.timestamp(), DUE)


class CameIn(Written):
    def came_in(self, text, name="a\\nb", folder="a\nb"):
        (self.file.parent / "came in.csv").write_text(text, encoding="utf-8")
        ours = self.load("times came in.csv")
        return policy.came_in(ours, SimpleNamespace(name=name, folder=folder, claims=[SimpleNamespace(number="123")], person=None),
                              SimpleNamespace(when=7))

    def test_files_tell_by_default(self):
        self.assertEqual(policy.came_in(self.load(""), None, SimpleNamespace(when=7)), 7)

    def test_a_csv_file_tells_by_name_or_folder(self):
        for name in ("a\\nb", '"a\nb"'):
            self.assertEqual(self.came_in(f"submission,time\r\n{name},2025-11-14T22:59Z\r\n"), DUE)
        self.assertIsNone(self.came_in("submission,time\n"))

    def test_moodle_s_worksheet_tells_by_the_participant(self):
        self.zone("UTC")
        for when in ("Friday, 14 November 2025, 10:59 PM", "Friday, November 14, 2025, 10:59 PM", "Friday, 14 November 2025, 22:59"):
            text = ('Identifier,"Full name",Grade,"Last modified (submission)"\n"Participant 12","Al B",,-\n'
                    f'"Participant 123","Jo ""J"" Li",,"{when}"\n')
            self.assertEqual(self.came_in(text), DUE)
        self.assertIsNone(self.came_in(text.replace("123", "124")))
        with self.assertRaisesRegex(policy.PolicyError, "csv:3: .*Freitag.* is not a time"):
            self.came_in(text.replace("Friday, 14 November", "Freitag, 14. November"))

    def test_a_csv_file_that_is_not_understood_is_an_error_with_both_lines(self):
        for text, line in (("", 1), ("name,time\n", 1), ("submission,time\nanna\n", 2),
                           ("submission,time\n\nanna,noon\n", 3),
                           ("submission,time\na,2025-11-14T22:59Z\na,2025-11-14T22:59Z\n", 3)):
            with self.assertRaises(policy.PolicyError) as caught:
                self.came_in(text)
            self.assertRegex(str(caught.exception), f":1: .*came in.csv:{line}: .*expected")
