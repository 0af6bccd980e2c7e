"""test_policy_change.py - a change of the policy alone marks nothing again, and counts at once."""
from __future__ import annotations

import csv
import os
import tempfile
from pathlib import Path

from .sentences import check
from .small_class import grade, right

JUNE = 1748779200  # 2025-06-01 12:00 UTC


def rows(out: Path) -> dict[str, tuple[str, str]]:
    """submission -> score, max"""
    with open(out / "grades.csv", encoding="utf-8-sig", newline="") as file:
        return {row["submission"]: (row["score"], row["max"]) for row in csv.DictReader(file)}


def test_policy_change() -> None:
    with tempfile.TemporaryDirectory() as work:
        folder, out, policy = Path(work, "class"), Path(work, "out"), Path(work, "policy")
        for name, text in (("anna", right("03-screen")), ("ben", "int x = ;\n")):
            (folder / name).mkdir(parents=True)
            (folder / name / "03-screen.c").write_text(text)
            os.utime(folder / name / "03-screen.c", (JUNE, JUNE))

        def marked(*lines: str) -> tuple[int, dict]:
            policy.write_text("".join(f"{line}\n" for line in lines))
            done = grade(folder, out, POLICY=str(policy))
            check(f"{lines} is graded", done.returncode == 0, done.stderr)
            return done.stderr.count("(kept)"), rows(out)

        first = ("points others 0", "points 03-screen 8")
        check("each is marked once", marked(*first) == (0, {"anna": ("8", "8"), "ben": ("0", "8")}))
        told = (out / "anna" / "results.json").read_bytes()
        check("a change of points marks nothing again, and counts",
              marked("points others 0", "points 03-screen 20") == (2, {"anna": ("20", "20"), "ben": ("0", "20")}))
        check("the student's page has the new marks", b"20 of 20" in (out / "anna" / "index.html").read_bytes())
        # Ten hours late, begun days count: one of them, a quarter.
        check("so does lateness", marked("points others 0", "points 03-screen 20", "due 2025-06-01T02:00Z",
                                         "late 25% per day, at most 50%")
              == (2, {"anna": ("15", "20"), "ben": ("0", "20")}))
        check("and back again", marked(*first) == (2, {"anna": ("8", "8"), "ben": ("0", "8")}))
        check("with the same bytes", (out / "anna" / "results.json").read_bytes() == told)


TESTS = [test_policy_change]
