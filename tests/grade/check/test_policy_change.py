"""test_policy_change.py - a change of the policy alone marks nothing again, and counts at once."""
from __future__ import annotations

import csv
import os
import tempfile
from pathlib import Path
from xml.etree import ElementTree

from .sentences import Sentences
from .small_class import UPSIDE_DOWN, but, grade, records, right

JUNE = 1748779200  # 2025-06-01 12:00 UTC


def rows(out: Path) -> dict[str, tuple[str, str]]:
    """submission -> score, max"""
    with open(out / "grades.csv", encoding="utf-8-sig", newline="") as file:
        return {row["submission"]: (row["score"], row["max"]) for row in csv.DictReader(file)}


def upper_right_of(out: Path) -> tuple[str, float, bool]:
    """The state and score of what waits, and whether JUnit calls it failed."""
    functions = records(out)["carla"]["stems"][0]["functions"]
    found = next(one for one in functions if one["name"] == "upper_right")
    suite = ElementTree.parse(out / "junit.xml")
    failed = [case.get("name") for case in suite.iter("testcase") if case.find("failure") is not None]
    return found["state"], found["score"], any("upper_right" in name for name in failed)


class PolicyChange(Sentences):
    def test_policy_change(self) -> None:
        with tempfile.TemporaryDirectory() as work:
            folder, out, policy = Path(work, "class"), Path(work, "out"), Path(work, "policy")
            for name, text in (("anna", right("03-screen")), ("ben", "int x = ;\n")):
                (folder / name).mkdir(parents=True)
                (folder / name / "03-screen.c").write_text(text)
                os.utime(folder / name / "03-screen.c", (JUNE, JUNE))

            def marked(*lines: str) -> tuple[int, dict]:
                policy.write_text("".join(f"{line}\n" for line in lines))
                done = grade(folder, out, POLICY=str(policy))
                self.check(f"{lines} is graded", done.returncode == 0, done.stderr)
                return done.stderr.count("(kept)"), rows(out)

            first = ("points others 0", "points 03-screen 8")
            self.check("each is marked once", marked(*first) == (0, {"anna": ("8", "8"), "ben": ("0", "8")}))
            told = (out / "anna" / "results.json").read_bytes()
            self.check("a change of points marks nothing again, and counts",
                       marked("points others 0", "points 03-screen 20") == (2,
                                                                            {"anna": ("20", "20"), "ben": ("0", "20")}))
            self.check("the student's page has the new marks",
                       b"20 of 20" in (out / "anna" / "index.html").read_bytes())
            # Ten hours late, begun days count: one of them, a quarter.
            self.check("so does lateness", marked("points others 0", "points 03-screen 20", "due 2025-06-01T02:00Z",
                                                  "late 25% per day, at most 50%")
                       == (2, {"anna": ("15", "20"), "ben": ("0", "20")}))
            self.check("and back again", marked(*first) == (2, {"anna": ("8", "8"), "ben": ("0", "8")}))
            self.check("with the same bytes", (out / "anna" / "results.json").read_bytes() == told)

    def test_waiting_is_switched_off(self) -> None:
        with tempfile.TemporaryDirectory() as work:
            folder, out, policy = Path(work, "class"), Path(work, "out"), Path(work, "policy")
            (folder / "carla").mkdir(parents=True)
            (folder / "carla" / "01-corners.c").write_text(
                but("01-corners", upper_left=UPSIDE_DOWN, upper_right="return upper_left(c) + c.width * c.right;"))

            def marked(line: str) -> tuple[str, float, bool]:
                policy.write_text(f"points others 0\npoints 01-corners 10\n{line}\n")
                done = grade(folder, out, POLICY=str(policy))
                self.check(f"'{line}' is graded", done.returncode == 0, done.stderr)
                return upper_right_of(out)

            full = marked("waiting full")
            self.check("what waits has its marks", full == ("waiting", 2, False), full)
            none = marked("waiting none")
            self.check("with 'waiting none' it has none, and does not pass", none == ("waiting", 0, True), none)
