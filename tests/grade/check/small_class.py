"""small_class.py - a class of everything that people hand in, and the grader run on it.

Run from the top of the tree; KIT is in the environment.
"""
from __future__ import annotations

import contextlib
import csv
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from grade import exercises
from grade.shorthand import answer, completed, definitions
from .fixtures import lay, locked, zipped

KIT = os.environ.get("KIT", "build/grading")
SEED = "20150929"
STEMS = sorted(path.stem for path in Path("solutions").glob("*.c"))
PROTOTYPES = exercises.prototypes(exercises.read())
MIRRORED = "return c.distance * c.forward + (s - 0.5) * c.width * c.right - (t - 0.5) * c.height * c.up;"
WAITS = """
upper_left: return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
upper_right: return upper_left(c) + c.width * c.right;
"""


def command(folder: Path, out: Path, kit: Path | str = KIT) -> list[str]:
    return [sys.executable, "-B", "tests/grade", str(kit), str(folder), "--out", str(out)]


def grade(folder: Path, out: Path, *before: str, kit: Path | str = KIT, **settings: str) -> subprocess.CompletedProcess:
    """before: a command that runs the grader."""
    return subprocess.run([*before, *command(folder, out, kit)], env={**os.environ, "SEED": SEED, **settings},
                          capture_output=True, text=True, errors="replace")


def started(folder: Path, out: Path, kit: Path | str = KIT, **settings: str) -> subprocess.Popen:
    return subprocess.Popen(command(folder, out, kit), env={**os.environ, "SEED": SEED, **settings},
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


@dataclass(frozen=True)
class Process:
    number: int
    words: list[str]
    folder: str

    def status(self) -> dict[str, str]:
        """As the kernel lists it; nothing if it has ended."""
        with contextlib.suppress(OSError):
            lines = Path(f"/proc/{self.number}/status").read_text().splitlines()
            return dict(line.split(":\t", 1) for line in lines if ":\t" in line)
        return {}


def processes() -> Iterator[Process]:
    for place in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):      # it may have ended
            words = (place / "cmdline").read_bytes().decode(errors="replace").split("\0")
            yield Process(int(place.name), words, os.readlink(place / "cwd"))


def at_work_in(folder: Path) -> list[str]:
    """The processes that have to do with this folder."""
    return [" ".join(one.words) for one in processes()
            if str(folder) in " ".join(one.words) or one.folder.startswith(str(folder))]


def gone(out: Path) -> bool:
    """A killed process takes a moment to go; one that survives would stay for a quarter of an hour."""
    until = time.monotonic() + 600  # however busy the machine is
    while at_work_in(out) and time.monotonic() < until:
        time.sleep(0.02)
    return not at_work_in(out)


def records(out: Path) -> dict[str, dict]:
    """By folder; without what may differ between two runs."""
    found = {}
    for path in sorted(out.glob("*/results.json")):
        record = json.loads(path.read_text())["extra_data"]["record"]
        record.pop("seconds", None)
        record.pop("steps", None)
        found[path.parent.name] = record
    return found


def rows(out: Path) -> dict[str, dict]:
    """Of grades.csv, by the submission's name."""
    with open(out / "grades.csv", encoding="utf-8-sig", newline="") as file:
        return {row["submission"]: row for row in csv.DictReader(file)}


# ---- what people hand in --------------------------------------------------------------------------

def right(stem: str) -> str:
    return Path("solutions", f"{stem}.c").read_text()


def but(stem: str, text: str) -> str:
    """The right answers, but for these functions, in shorthand."""
    return completed(answer(stem, text, PROTOTYPES[stem]), PROTOTYPES[stem], definitions(right(stem), PROTOTYPES[stem]))


def build_class(folder: Path) -> None:
    files = {
        **{f"all right/{stem}.c": right(stem) for stem in STEMS},
        "mirrored/01-corners.c": but("01-corners", f"image_plane_vector: {MIRRORED}\nupper_left: return image_plane_vector(c, 0, 1);\n"),
        "waits/01-corners.c": but("01-corners", WAITS),
        "no text/01-corners.c": '#include "common/vec3.h"\ndouble x(vec3 v)\n{\n    return v.x;\n}\n',
        "no text/03-screen.c": right("03-screen"),
        "no assembler/01-corners.c": '__asm__("no instruction");\n',
        "-leading dash 'quote\" newline\n\x1b[31m =ü/03-screen.c": right("03-screen"),
    }
    first, last = (zipped(("01-corners.c", text)) for text in (but("01-corners", WAITS), right("01-corners")))
    lay(folder, {path: text.encode() for path, text in files.items()} | {
        "nothing/": b"", "broken.tar.gz": b"no archive", "=1+1<b>.pdf": b"%PDF-1.7\n", "xaver.zip": locked(first),
        "zipped.zip": zipped(("x/04-pixel-ray.c", right("04-pixel-ray")), ("../../03-screen.c", right("03-screen"))),
        "zoe_506_9039_submission.zip": first, "zoe_LATE_506_9040_submission-1.zip": last, "read me.txt": b"for the instructor\n"})
