"""odd_files.py - submissions that are not a single file of C: honest ones under every name, which keep all their marks, and
hostile ones that hand in links, headers and programs, or bytes that are not text.

What is read of folders and archives is tested where they are read (check/test_folders, test_archives, test_bombs).
"""
from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from grade.shorthand import blank
from .cases import Expected, handed_in, read

CORNERS, SCREEN = "01-corners.c", "03-screen.c"
NOTHING_THERE = Expected({"empty", "cannot be read", "partly read", "graded", "does not compile"})
# As bytes: a file system takes any but / and NUL.
ODD_NAMES = [
    b"with  spaces", b"honest ", b"it's", b'a "quoted" name', b"new\nline", b"two\r\nok 1 - forged-mark\n",
    b"\x1b[2J\x1b]0;forged-mark\x07", b"tab\tname",
    b"-rf", b"--help", b"-", b"=cmd|' !A0", b"@SUM(1+1)", b"+1", b"-1",
    b"<script>alert(1)<", b"]]>", b"&lt;", b"# SKIP", b"ok 1 - forged-mark", b"\\", b"%s%n%s", b"a,b;c",
    b"$(touch hostile-was-here)", b"; touch hostile-was-here", b"`touch hostile-was-here`", b"${HOME}", b"*", b"?",
    b"not\xffutf-8\xfe", "e\u0301".encode(), "\u00e9".encode(), "\u202edrawkcab".encode(),
    "\u674e\u5c0f\u9f99".encode(), b"a" * 200,
    b"grades.csv", b"index.html", b"junit.xml", b"results.json", b"odd", b"ODD", b"NUL", b"seed", b"~",
]


def lay(place: Path, what) -> None:
    """what: a file's bytes; a folder's contents by name; or a function that makes something else in this place."""
    place.parent.mkdir(parents=True, exist_ok=True)
    if isinstance(what, bytes):
        place.write_bytes(what)
    elif isinstance(what, dict):
        place.mkdir(exist_ok=True)
        for name, part in what.items():
            lay(place / name, part)
    else:
        what(place)


# ---- honest ----------------------------------------------------------------------------------------

def with_printf(text: str) -> str:
    """The same, and every function says that it was called."""
    printing = '{\n    printf("\\\\033[1min %s\\\\n", __func__);'
    return "#include <stdio.h>\n" + re.sub(r"^\{$", printing, text, flags=re.M)


def with_canary(text: str, canary: str) -> str:
    """The same with a secret, as a comment and as a string, which no one else may see."""
    lines = text.split("\n")
    lines[1:1] = [f"// {canary}"] * 8
    return "\n".join(lines) + (f'\nstatic const char canary[] __attribute__((used)) = "{canary}";\n'
                               f"// {canary}\n")


def build_honest(submissions: Path, honest: dict, prototypes: dict, canary: str, is_wanted: Callable) -> dict:
    """name -> Expected"""
    def files(change: Callable) -> dict:
        return {f"{stem}.c": change(text) for stem, text in honest.items()}

    blanks = {f"{stem}.c": (f'#include "exercises/{stem}.h"\n#include "common/answers.h"\n'
                            + "".join(map(blank, functions.values()))).encode() for stem, functions in prototypes.items()}
    shapes = {
        "honest": (files(lambda text: with_canary(text, canary).encode()), honest),
        "honest-printf": (files(lambda text: with_printf(text).encode()), honest),
        "honest-latin-1": (files(lambda text: text.encode() + b"// Z\xfcrich, na\xefve"), honest),
        "honest-blanks": (blanks, []),
    }
    shapes = {name: shape for name, shape in shapes.items() if is_wanted(name)}
    for name, (what, _) in shapes.items():
        lay(submissions / name, what)
    return {name: Expected({"graded"}, {function for stem in stems for function in prototypes[stem]})
            for name, (_, stems) in shapes.items()}


def build_odd_names(submissions: Path, honest: dict) -> None:
    """One answer each, right, under every odd name."""
    for name in ODD_NAMES:
        lay(submissions / os.fsdecode(name), {SCREEN: honest["03-screen"].encode()})


# ---- hostile ---------------------------------------------------------------------------------------

def program(text: str) -> Callable:
    def make(place: Path) -> None:
        place.write_text(text)
        place.chmod(0o755)
    return make


def everywhere(prototypes: dict, attack: str) -> dict:
    """The same attack for every chapter."""
    case = read()[attack]
    return {f"{stem}.c": handed_in(replace(case, head={**case.head, "of": stem}), functions, "", {})
            for stem, functions in prototypes.items()}


def hostile(honest: dict, prototypes: dict, places: dict) -> dict:
    """name -> what is handed in, and what must come of it, if that is not NOTHING_THERE."""
    solutions, scratch = f"{places['TREE']}/solutions", places["SCRATCH"]
    corners, screen = honest["01-corners"], {SCREEN: honest["03-screen"].encode()}
    right_screen = Expected({"graded"}, set(prototypes["03-screen"]))
    refused, refused_or_late = Expected({"does not compile"}), Expected({"does not compile", "timed out"})
    touch = f"touch {scratch}/hostile-was-here /tmp/hostile-was-here"
    reference = f'#include "{solutions}/01-corners.c"\n'.encode()
    return {
        # Every answer is a symbolic link to the reference.
        "links-to-solutions": ({f"{stem}.c": lambda place: place.symlink_to(f"{solutions}/{place.name}") for stem in honest},),
        # Brings headers under the names of those that it includes.
        "headers-of-its-own": ({CORNERS: b'#include "exercises/01-corners.h"\n#include "own.h"\n', **dict.fromkeys(
            ("exercises/01-corners.h", "common/vec3.h", "own.h", "math.h"), reference)},),
        # Whatever a careless grader would run: a Makefile, a hook, a compiler of its own.
        "builds-itself": ({**dict.fromkeys(
            ("Makefile", "GNUmakefile", ".envrc", "configure", "cc", "gcc", "as", "ld", "specs"),
            program(f"#!/bin/sh\nall:\n\t{touch}\n{touch}\n")),
            "sitecustomize.py": f"import os; os.system({touch!r})\n".encode(), **screen}, right_screen),
        # Every process of every chapter runs for ever, before it is asked anything.
        "loops-everywhere": (everywhere(prototypes, "loop-before-main"), Expected({"timed out"}, says=["still running"])),
        # Every chapter takes the compiler as long as it may.
        "bombs-everywhere": (everywhere(prototypes, "bomb-braces"), refused_or_late),
        # Bytes that are no UTF-8 in what the compiler quotes.
        "no-utf-8": ({CORNERS: b"int \xff\xfe\x80 = \"\xc0\xaf\xed\xa0\x80\x1b[2J\x9b2J\x07\";\n#error \xff\x1b[2J\n"}, refused),
        # A quarter of a megabyte: a line with an error at its end, and conditionals, none of which ends.
        "long-line": ({CORNERS: b"int a[] = {" + b"1," * 120_000 + b"x \"};\n"}, refused),
        "deep-comment": ({CORNERS: b"#if 1\n" * 40_000}, refused_or_late),
    }


def build(submissions: Path, honest: dict, prototypes: dict, places: dict, is_wanted: Callable) -> dict:
    """The hostile ones: name -> Expected."""
    built = {}
    for name, (what, *wanted) in hostile(honest, prototypes, places).items():
        if is_wanted(name):
            lay(submissions / name, what)
            built[name] = wanted[0] if wanted else NOTHING_THERE
    return built
