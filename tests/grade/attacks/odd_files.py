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

from grade.check.records import HOSTILE
from grade.shorthand import blank
from .cases import Expected, handed_in, read

CORNERS, SCREEN = "01-corners.c", "03-screen.c"
NOTHING_THERE = Expected({"empty", "cannot be read", "partly read", "graded", "does not compile"})
# As bytes: a file system takes any but / and NUL.
ODD_NAMES = [name for text in HOSTILE if not re.match(r"\s*$|\.|.*[/\0]|.{250}", text, re.DOTALL)
             and (name := text.encode("utf-8", "surrogatepass"))] + [
    b"honest ", b"-", b"<script>alert(1)<", b"ok 1 - forged-mark", b"$(touch hostile-was-here)",
    b"; touch hostile-was-here", b"`touch hostile-was-here`", b"*", b"?", "e\u0301".encode(), "\u00e9".encode(), b"a" * 200,
    b"grades.csv", b"index.html", b"junit.xml", b"results.json", b"odd", b"ODD", b"NUL", b"seed",
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


def honest_ones(honest: dict, prototypes: dict, canary: str) -> dict:
    """name -> what is handed in, and what must come of it. canary: a secret in the file of 'honest'."""
    def files(change: Callable) -> dict:
        return {f"{stem}.c": change(text) for stem, text in honest.items()}

    everything, nothing = Expected({"graded"}, {name for functions in prototypes.values() for name in functions}), Expected({"graded"})
    blanks = {f"{stem}.c": (f'#include "exercises/{stem}.h"\n#include "common/answers.h"\n'
                            + "".join(map(blank, functions.values()))).encode() for stem, functions in prototypes.items()}
    return {
        "honest": (files(lambda text: with_canary(text, canary).encode()), everything),
        "honest-printf": (files(lambda text: with_printf(text).encode()), everything),
        "honest-latin-1": (files(lambda text: text.encode() + b"// Z\xfcrich, na\xefve"), everything),
        "honest-blanks": (blanks, nothing),
    }


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
    """name -> what is handed in, and what must come of it."""
    solutions, scratch = f"{places['TREE']}/solutions", places["SCRATCH"]
    screen = {SCREEN: honest["03-screen"].encode()}
    right_screen = Expected({"graded"}, set(prototypes["03-screen"]))
    refused, refused_or_late = Expected({"does not compile"}), Expected({"does not compile", "timed out"})
    touch = f"touch {scratch}/hostile-was-here /tmp/hostile-was-here"
    reference = f'#include "{solutions}/01-corners.c"\n'.encode()
    return {
        # Every answer is a symbolic link to the reference.
        "links-to-solutions": ({f"{stem}.c": lambda place: place.symlink_to(f"{solutions}/{place.name}") for stem in honest}, NOTHING_THERE),
        # Brings headers under the names of those that it includes.
        "headers-of-its-own": ({CORNERS: b'#include "exercises/01-corners.h"\n#include "own.h"\n', **dict.fromkeys(
            ("exercises/01-corners.h", "common/vec3.h", "own.h", "math.h"), reference)}, NOTHING_THERE),
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

