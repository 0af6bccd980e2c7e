"""test_environment.py - whatever this machine cannot do is one sentence, and no traceback."""
from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .sentences import Sentences
from .small_class import KIT, command, right


def said(words: list[str], **settings) -> tuple[int, str]:
    stdout = settings.pop("stdout", subprocess.DEVNULL)
    done = subprocess.run(words, env={**os.environ, "SEED": "1", **settings}, stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, text=True, check=False)
    return done.returncode, done.stderr


def with_kit(words: list[str], kit: Path) -> list[str]:
    return [str(kit) if word == KIT else word for word in words]


class Environment(Sentences):
    def is_one_sentence(self, name: str, wanted: str, words: list[str], **settings) -> None:
        status, complaints = said(words, **settings)
        last = complaints.splitlines()[-1:] or [""]
        self.check(f"{name} is one sentence", status == 1 and last[0].startswith("grade: ") and wanted in last[0]
                   and "Traceback" not in complaints and complaints.count("grade: ") == 1, complaints)

    def test_environment(self) -> None:
        with tempfile.TemporaryDirectory() as temporary:
            work = Path(temporary)
            folder, file = work / "class", work / "file"
            (folder / "anna").mkdir(parents=True)
            (folder / "anna" / "03-screen.c").write_text(right("03-screen"))
            file.write_text("x")
            for name, out in {"an OUT that is a file": file, "an OUT in a file": file / "out",
                              "an OUT where nothing can be made": Path("/proc/out")}.items():
                self.is_one_sentence(name, f"OUT={out} cannot be written: ", command(folder, out))
            shut = work / "shut"
            shut.mkdir()
            (shut / ".seed").write_bytes(b"\xff")
            self.is_one_sentence("a seed that is noise", "", command(folder, shut))
            for name, kit in {"no kit": work / "none", "a kit that is a file": file}.items():
                self.is_one_sentence(name, str(kit), with_kit(command(folder, work / "out"), kit))
            self.is_one_sentence("a policy that is a folder", "cannot be read", command(folder, work / "out"),
                                 POLICY=str(work))
            self.is_one_sentence("a class that is a file", "is a file", command(file, work / "out"))
            with open("/dev/full", "w") as full:
                self.is_one_sentence("a full terminal", "its output: No space left", command(folder, work / "out"),
                                     stdout=full)
            self.read_only(folder, work)

    def test_it_starts_from_any_folder(self) -> None:
        words = [sys.executable, str(Path("tests/grade").resolve()), "--help"]
        done = subprocess.run(words, cwd="/", capture_output=True, text=True,
                              env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        self.check("the grader starts from any folder", (done.returncode, done.stdout[:13]) == (0, "usage: grade "),
                   done.stderr)

    def read_only(self, folder: Path, work: Path) -> None:
        view = ["bwrap", "--ro-bind", "/", "/", "--dev", "/dev", "--proc", "/proc"]
        if not shutil.which("bwrap") or said([*view, "true"])[0] != 0:
            self.skip("a file system that is read-only: no bubblewrap here")
            return
        for name in ("new", "old"):
            if name == "old":
                (work / name).mkdir()
            self.is_one_sentence(f"a read-only OUT ({name})", "cannot be written: Read-only file system",
                                 [*view, *command(folder, work / name)], SANDBOX="landlock")
