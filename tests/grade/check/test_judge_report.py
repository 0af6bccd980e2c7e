"""test_judge_report.py - the judge's report is read whole, or the grader has failed."""
import tempfile
import unittest
from pathlib import Path

from grade.confine.machine import GraderFailed
from grade.mark.judge_report import read_report

REPORT = """function\tupper_left
state\twrong
given\tcamera\\teye (1, 2, 3)\\nray\\tt~1
yours\tback\\\\slash \\x1b \\n
function\tupper_right
state\tright
"""


class Report(unittest.TestCase):
    def read(self, text, *names):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "report")
            if text is not None:
                path.write_bytes(text.encode("latin-1"))
            return read_report(path, names)

    def test_each_function_has_its_values(self):
        self.assertEqual(self.read(REPORT, "upper_right", "upper_left"), {
            "upper_left": {"state": "wrong", "given": "camera\teye (1, 2, 3)\nray\tt~1", "yours": "back\\slash \\x1b \n"},
            "upper_right": {"state": "right"}})

    def test_a_function_that_is_missing_is_the_grader_s_failure(self):
        for text in (None, "", REPORT.replace("right\n", "\n"), REPORT[:40], REPORT + "yours\t\xe9\n"):
            with self.assertRaises(GraderFailed):
                self.read(text, "upper_left", "upper_right")
