"""odd_files.py - the hostile submissions that are not a single text file: links, pipes, folders, and
bytes that are not text.

Each function makes one below the class's folder, from the honest answers (stem -> text), and returns
what must come of it. The sentence above its body says what it tries.
"""
from __future__ import annotations

import os
import random
import socket
from pathlib import Path

from .cases import Expected, completed, read

CORNERS, SCREEN = "01-corners.c", "03-screen.c"
LOOP = """
__attribute__((constructor)) static void begin(void)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}
"""
ANY = {"graded", "does not compile", "empty", "timed out", "crashed"}
NOTHING_THERE = {"empty", "graded", "does not compile"}


def folder(room: Path, name: str) -> Path:
    path = room / name
    path.mkdir(parents=True)
    return path


# ---- links, and files that are none ----------------------------------------------------------------

def links_to_solutions(room, honest, prototypes, places):
    """Every answer a symbolic link to the reference."""
    path = folder(room, "links-to-solutions")
    for stem in honest:
        (path / f"{stem}.c").symlink_to(f"{places['TREE']}/solutions/{stem}.c")
    return Expected(NOTHING_THERE)


def link_to_a_folder(room, honest, prototypes, places):
    """A folder that is a link to all the references."""
    (folder(room, "link-to-a-folder") / "week 1").symlink_to(f"{places['TREE']}/solutions")
    return Expected(NOTHING_THERE)


def link_to_a_classmate(room, honest, prototypes, places):
    """A link to what the next student wrote."""
    (folder(room, "link-to-a-classmate") / CORNERS).symlink_to(f"../honest/{CORNERS}")
    return Expected(NOTHING_THERE)


def link_as_submission(room, honest, prototypes, places):
    """The submission itself is a link to a classmate's."""
    (room / "link-as-submission").symlink_to("honest")
    return Expected(NOTHING_THERE)


def link_to_itself(room, honest, prototypes, places):
    """A folder in which it lies itself, for whoever goes down."""
    path = folder(room, "link-to-itself")
    (path / "again").symlink_to(".")
    (path / CORNERS).symlink_to(CORNERS)
    return Expected(NOTHING_THERE)


def link_to_zeros(room, honest, prototypes, places):
    """A file without end."""
    (folder(room, "link-to-zeros") / CORNERS).symlink_to("/dev/zero")
    return Expected(NOTHING_THERE)


def pipe(room, honest, prototypes, places):
    """A pipe, at which a reader waits for ever."""
    os.mkfifo(folder(room, "pipe") / CORNERS)
    return Expected(NOTHING_THERE)


def no_files(room, honest, prototypes, places):
    """A folder and a socket that go by the names of answers."""
    path = folder(room, "no-files")
    (path / CORNERS).mkdir()
    with socket.socket(socket.AF_UNIX) as door:
        os.chdir(path)
        door.bind(SCREEN)
        os.chdir("/")
    return Expected(NOTHING_THERE)


def huge(room, honest, prototypes, places):
    """A gigabyte that takes no room on the disk."""
    with open(folder(room, "huge") / CORNERS, "wb") as file:
        file.truncate(1 << 30)
    return Expected(NOTHING_THERE)


def deep(room, honest, prototypes, places):
    """An answer below three hundred folders."""
    path = folder(room, "deep" + "/d" * 300)
    (path / SCREEN).write_text(honest["03-screen"])
    return Expected(ANY, perhaps=set(prototypes["03-screen"]))


def many(room, honest, prototypes, places):
    """Five thousand files, and an answer among them."""
    path = folder(room, "many")
    for i in range(5000):
        (path / f"{i}.c").touch()
    (path / SCREEN).write_text(honest["03-screen"])
    return Expected({"graded"}, set(prototypes["03-screen"]))


def twice(room, honest, prototypes, places):
    """Two answers of one name: the marks of whichever is better."""
    (folder(room, "twice/old") / SCREEN).write_text(honest["03-screen"])
    (folder(room, "twice/new") / SCREEN).write_text(honest["03-screen"] + "\n// another\n")
    return Expected({"graded", "empty"}, says=["two", "twice", "2 "])


def headers_of_its_own(room, honest, prototypes, places):
    """Brings headers under the names of those that it includes."""
    path = folder(room, "headers-of-its-own")
    (path / CORNERS).write_text('#include "exercises/01-corners.h"\n#include "own.h"\n')
    for name in ("exercises/01-corners.h", "common/vec3.h", "own.h", "math.h"):
        (path / name).parent.mkdir(exist_ok=True)
        (path / name).write_text(f"#include \"{places['TREE']}/solutions/01-corners.c\"\n")
    return Expected(NOTHING_THERE)


def builds_itself(room, honest, prototypes, places):
    """Whatever a careless grader would run: a Makefile, a hook, a compiler of its own."""
    path = folder(room, "builds-itself")
    touch = f"touch {places['SCRATCH']}/hostile-was-here /tmp/hostile-was-here"
    for name in ("Makefile", "GNUmakefile", ".envrc", "configure", "cc", "gcc", "as", "ld", "specs"):
        (path / name).write_text(f"#!/bin/sh\nall:\n\t{touch}\n{touch}\n")
        (path / name).chmod(0o755)
    (path / "sitecustomize.py").write_text(f"import os; os.system({touch!r})\n")
    (path / SCREEN).write_text(honest["03-screen"])
    return Expected({"graded"}, set(prototypes["03-screen"]))


def loops_everywhere(room, honest, prototypes, places):
    """Every process of every chapter runs for ever, before it is asked anything."""
    path = folder(room, "loops-everywhere")
    for stem, functions in prototypes.items():
        (path / f"{stem}.c").write_text(completed(f'#include "exercises/{stem}.h"\n{LOOP}', functions))
    return Expected({"timed out"}, says=["still running"])


def bombs_everywhere(room, honest, prototypes, places):
    """Every chapter takes the compiler as long as it may."""
    path = folder(room, "bombs-everywhere")
    for stem in prototypes:
        (path / f"{stem}.c").write_text(read()["bomb-braces"].text)
    return Expected({"does not compile", "timed out"})


# ---- bytes that are not text -----------------------------------------------------------------------

def raw(room, name: str, content: bytes) -> None:
    (folder(room, name) / CORNERS).write_bytes(content)


def empty_file(room, honest, prototypes, places):
    """A file of no bytes."""
    raw(room, "empty-file", b"")
    return Expected(NOTHING_THERE)


def empty_folder(room, honest, prototypes, places):
    """Nothing at all."""
    folder(room, "empty-folder/week 1")
    return Expected({"empty"})


def zero_bytes(room, honest, prototypes, places):
    """NUL bytes in an answer, after which readers of strings see nothing."""
    raw(room, "zero-bytes", honest["01-corners"].replace("\n\n", "\n// \0 \0\n\n").encode())
    return Expected({"graded", "does not compile"}, perhaps=set(prototypes["01-corners"]))


def no_utf_8(room, honest, prototypes, places):
    """Bytes that are no UTF-8 in what the compiler quotes."""
    raw(room, "no-utf-8", b"int \xff\xfe\x80 = \"\xc0\xaf\xed\xa0\x80\x1b[2J\x9b2J\x07\";\n#error \xff\x1b[2J\n")
    return Expected({"does not compile"})


def utf_16(room, honest, prototypes, places):
    """The answers as one editor writes them."""
    raw(room, "utf-16", honest["01-corners"].encode("utf-16"))
    return Expected({"does not compile", "graded"}, perhaps=set(prototypes["01-corners"]))


def a_program(room, honest, prototypes, places):
    """A compiled program instead of a source."""
    with open("/bin/sh", "rb") as file:
        raw(room, "a-program", file.read(100_000))
    return Expected(NOTHING_THERE)


def noise(room, honest, prototypes, places):
    """A hundred thousand bytes at random."""
    raw(room, "noise", random.Random(4).randbytes(100_000))
    return Expected(NOTHING_THERE)


def long_line(room, honest, prototypes, places):
    """A line of a quarter of a megabyte, with an error at its end."""
    raw(room, "long-line", b"int a[] = {" + b"1," * 120_000 + b"x \"};\n")
    return Expected({"does not compile"})


def deep_comment(room, honest, prototypes, places):
    """A quarter of a megabyte of conditionals, none of which ends."""
    raw(room, "deep-comment", b"#if 1\n" * 40_000)
    return Expected({"does not compile", "timed out"})


MAKERS = [links_to_solutions, link_to_a_folder, link_to_a_classmate, link_as_submission, link_to_itself,
          link_to_zeros, pipe, no_files, huge, deep, many, twice, headers_of_its_own, builds_itself,
          loops_everywhere, bombs_everywhere,
          empty_file, empty_folder, zero_bytes, no_utf_8, utf_16, a_program, noise, long_line, deep_comment]


def build(makers: list, room: Path, honest: dict, prototypes: dict, places: dict) -> dict:
    """All of them: name -> Expected."""
    built = {}
    for make in makers:
        before = set(os.listdir(room))
        wanted = make(room, honest, prototypes, places)
        (name,) = set(os.listdir(room)) - before
        built[name] = wanted
    return built
