#!/usr/bin/env python3
"""check.py - tests of what a student reads of a compiler's and a linker's words.

    check.py EXPLAIN [--record]

Expected: the cases in the text files beside it. Each is an answer, what compilers (or ld) said of it, and what a
student reads. A case that changes is a change for students; --record writes the new words.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PART = re.compile(r"^(==|--) (.*)\n", re.MULTILINE)


def said(explain, folder, source, tool, words):
    option = ["--linker"] if tool == "ld" else []
    run = subprocess.run([explain, *option, source], cwd=folder, input=words.encode(), stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, check=False)
    return run.stdout.decode() + (f"exit status {run.returncode}\n" if run.returncode else "")


def check(path, explain, folder):
    """The file's text, as it is and as it should be; and how many words were explained, and how many wrongly."""
    text = path.read_text(encoding="utf-8")
    marks = list(PART.finditer(text))
    now, passed, failed, title, source, tool, words = [text[:marks[0].start()]], 0, 0, "", "", "", ""
    for mark, end in zip(marks, [*(mark.start() for mark in marks[1:]), len(text)]):
        kind, name, part = mark[1], mark[2], text[mark.end():end]
        if kind == "==":
            title = name
        elif name.endswith(".c"):
            source = name
            (folder / source).write_text(part, encoding="utf-8")
        elif name == "said":
            new = said(explain, folder, source, tool, words)
            passed, failed = passed + (new == part), failed + (new != part)
            if new != part:
                print(f"not ok: {path.name}: {title}, {tool}\n{new}instead of\n{part}")
            part = new
        else:
            tool, words = name, part
        now += [mark[0], part]
    return text, "".join(now), passed, failed


def main():
    explain, record, passed, failed = os.path.abspath(sys.argv[1]), "--record" in sys.argv, 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for headers in ("exercises", "common"):
            (folder / headers).symlink_to(Path(headers).absolute())
        for path in sorted(Path(__file__).parent.glob("*.txt")):
            text, now, right, wrong = check(path, explain, folder)
            passed, failed = passed + right, failed + wrong
            if record and now != text:
                path.write_text(now, encoding="utf-8")
    print(f"what a student reads of the compiler's words: {passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
