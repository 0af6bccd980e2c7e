#!/usr/bin/env python3
"""check_cases.py - tests of what a student reads of a compiler's and a linker's words.

    check_cases.py EXPLAIN [--record]

Expected: the cases in cases.txt. Each is an answer, what compilers (or ld) said of it, and what a
student reads. A case that changes is a change for students. --record asks each of COMPILERS that is installed (as
gcc-12) and writes its words, if they are other ones than those of the case, and what a student reads now.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

CASES = Path(__file__).parent / "cases.txt"
COMPILERS = [f"gcc {version}" for version in range(12, 16)] + [f"clang {version}" for version in range(14, 20)]
FLAGS = ["-std=c11", "-D_DEFAULT_SOURCE", "-Wno-psabi", "-I.", "-c", "-o", os.devnull,
         *re.search(r"^FOR_STUDENTS := ((.*\\\n)*.*)", Path("Makefile").read_text(encoding="utf-8"), re.M)[1].replace("\\\n", "").split()]


def cases(text):
    """Title, name of the answer, its text, and of each tool what it says and what a student reads."""
    for case in re.split(r"^== ", text, flags=re.M)[1:]:
        title, source, answer, *parts = re.split(r"^-- (.*)\n", case, flags=re.M)
        yield title, source, answer, {tool: (words, said) for tool, words, said in zip(parts[::4], parts[1::4], parts[3::4])}


def asked(compiler, source, folder):
    """What an installed compiler says; or None."""
    program = shutil.which(compiler.replace(" ", "-"))
    return program and subprocess.run([program, *FLAGS, source], cwd=folder, env={**os.environ, "LC_ALL": "C"}, check=False,
                                      stdin=subprocess.DEVNULL, capture_output=True).stderr.decode()


def explained(explain, folder, source, tool, words):
    option = ["--linker"] if tool == "ld" else []
    run = subprocess.run([explain, *option, source], cwd=folder, input=words.encode(), stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, check=False)
    return run.stdout.decode() + (f"exit status {run.returncode}\n" if run.returncode else "")


def main():
    explain, record, passed, failed = os.path.abspath(sys.argv[1]), "--record" in sys.argv, 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for headers in ("exercises", "common"):
            (folder / headers).symlink_to(Path(headers).absolute())
        now = ""
        for title, source, answer, tools in cases(CASES.read_text(encoding="utf-8")):
            line_end = b"\r\n" if "Windows" in title else b"\n"
            (folder / source).write_bytes(answer.encode().replace(b"\n", line_end))
            for compiler in COMPILERS if record and not {"invented", "ld"} & set(tools) else ():
                words = asked(compiler, source, folder)
                if words and (compiler in tools or words not in [said for said, _ in tools.values()]):
                    tools[compiler] = words, tools.get(compiler, ("", ""))[1]
            now += f"== {title}-- {source}\n{answer}"
            for tool, (words, expected) in tools.items():
                said = explained(explain, folder, source, tool, words)
                passed, failed = passed + (said == expected), failed + (said != expected)
                if said != expected:
                    print(f"not ok: {title.strip()}, {tool}\n{said}instead of\n{expected}")
                now += f"-- {tool}\n{words}-- said\n{said}"
        if record:
            CASES.write_text(now, encoding="utf-8")
    print(f"what a student reads of the compiler's words: {passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
