"""odd_files.py - submissions that are not a single text file: honest ones in every shape, which keep all their marks,
and hostile ones: links, pipes, folders, archives, and bytes that are not text.

Each hostile one is a function below, whose name is the submission's and whose sentence says what it tries. It makes a
part of the class, from the honest answers, and gives what must come of it, if that is not NOTHING_THERE.
"""
from __future__ import annotations

import gzip
import os
import random
import re
import socket
import struct
import tarfile
import zipfile
from dataclasses import dataclass, replace
from pathlib import Path

from grade.check.fixtures import member, tarred, zipped

from .cases import Expected, blank, handed_in, read

CORNERS, SCREEN = "01-corners.c", "03-screen.c"
NOTHING_THERE = {"empty", "cannot be read", "partly read", "graded", "does not compile"}
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


@dataclass(frozen=True)
class Room:
    """What a submission is made from, and where."""
    submissions: Path
    honest: dict        # stem -> text
    prototypes: dict    # stem -> function -> prototype
    places: dict

    def folder(self, name: str) -> Path:
        path = self.submissions / name
        path.mkdir(parents=True)
        return path

    def right_screen(self) -> Expected:
        return Expected({"graded"}, set(self.prototypes["03-screen"]))

    def raw(self, name: str, content: bytes) -> None:
        (self.folder(name) / CORNERS).write_bytes(content)

    def archive(self, name: str, content: bytes) -> None:
        (self.submissions / name).write_bytes(content)


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


def put(room: Path, name, honest: dict, change=lambda text: text.encode()) -> None:
    folder = os.path.join(os.fsencode(room), os.fsencode(name))
    os.makedirs(folder)
    for stem, text in honest.items():
        with open(os.path.join(folder, os.fsencode(f"{stem}.c")), "wb") as file:
            file.write(change(text))


def build_honest(submissions: Path, honest: dict, prototypes: dict, canary: str) -> dict:
    """name -> Expected"""
    put(submissions, "honest", honest, lambda text: with_canary(text, canary).encode())
    put(submissions, "honest-printf", honest, lambda text: with_printf(text).encode())
    put(submissions, "honest-windows", honest, lambda text: b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    put(submissions, "honest-latin-1", honest, lambda text: text.encode() + b"// Z\xfcrich, na\xefve")
    put(submissions, "honest-below/week 3/answers (final)", honest)
    room = Room(submissions, honest, prototypes, {})
    room.archive("honest-zip.zip", zipped(*[(f"week 1/{stem}.c", text) for stem, text in honest.items()]))
    room.archive("honest-tar.tar.gz",
                 gzip.compress(tarred(*[(f"./{stem}.c", text.encode()) for stem, text in honest.items()])))
    everything = {name for functions in prototypes.values() for name in functions}
    built = {name: Expected({"graded"}, everything) for name in os.listdir(submissions)}
    put(submissions, "honest-blanks", {
        stem: f'#include "exercises/{stem}.h"\n#include "common/answers.h"\n' + "".join(map(blank, functions.values()))
        for stem, functions in prototypes.items()})
    built["honest-blanks"] = Expected({"graded"})
    return built


def build_odd_names(submissions: Path, honest: dict) -> None:
    """One answer each, right, under every odd name."""
    for name in ODD_NAMES:
        put(submissions, name, {"03-screen": honest["03-screen"]})


# ---- links, and files that are none ----------------------------------------------------------------

def links_to_solutions(room: Room):
    """Every answer a symbolic link to the reference."""
    path = room.folder("links-to-solutions")
    for stem in room.honest:
        (path / f"{stem}.c").symlink_to(f"{room.places['TREE']}/solutions/{stem}.c")


def link_to_a_folder(room: Room):
    """A folder that is a link to all the references."""
    (room.folder("link-to-a-folder") / "week 1").symlink_to(f"{room.places['TREE']}/solutions")


def link_to_a_classmate(room: Room):
    """A link to what the next student wrote."""
    (room.folder("link-to-a-classmate") / CORNERS).symlink_to(f"../honest/{CORNERS}")


def link_as_submission(room: Room):
    """The submission itself is a link to a classmate's."""
    (room.submissions / "link-as-submission").symlink_to("honest")


def link_to_zeros(room: Room):
    """A file without end."""
    (room.folder("link-to-zeros") / CORNERS).symlink_to("/dev/zero")


def no_files(room: Room):
    """A folder, a socket, and a pipe at which a reader waits for ever, by the names of answers."""
    path = room.folder("no-files")
    (path / CORNERS).mkdir()
    os.mkfifo(path / "02-cameras.c")
    with socket.socket(socket.AF_UNIX) as door:
        os.chdir(path)
        door.bind(SCREEN)
        os.chdir("/")


def many(room: Room):
    """Five thousand files, and an answer among them."""
    path = room.folder("many")
    for i in range(5000):
        (path / f"{i}.c").touch()
    (path / SCREEN).write_text(room.honest["03-screen"])
    return room.right_screen()


def headers_of_its_own(room: Room):
    """Brings headers under the names of those that it includes."""
    path = room.folder("headers-of-its-own")
    (path / CORNERS).write_text('#include "exercises/01-corners.h"\n#include "own.h"\n')
    for name in ("exercises/01-corners.h", "common/vec3.h", "own.h", "math.h"):
        (path / name).parent.mkdir(exist_ok=True)
        (path / name).write_text(f"#include \"{room.places['TREE']}/solutions/01-corners.c\"\n")


def builds_itself(room: Room):
    """Whatever a careless grader would run: a Makefile, a hook, a compiler of its own."""
    path = room.folder("builds-itself")
    touch = f"touch {room.places['SCRATCH']}/hostile-was-here /tmp/hostile-was-here"
    for name in ("Makefile", "GNUmakefile", ".envrc", "configure", "cc", "gcc", "as", "ld", "specs"):
        (path / name).write_text(f"#!/bin/sh\nall:\n\t{touch}\n{touch}\n")
        (path / name).chmod(0o755)
    (path / "sitecustomize.py").write_text(f"import os; os.system({touch!r})\n")
    (path / SCREEN).write_text(room.honest["03-screen"])
    return room.right_screen()


def everywhere(room: Room, name: str, attack: str) -> None:
    """Hands in the same attack for every chapter."""
    path, case = room.folder(name), read()[attack]
    for stem, functions in room.prototypes.items():
        (path / f"{stem}.c").write_bytes(handed_in(replace(case, head={**case.head, "of": stem}), functions, "", {}))


def loops_everywhere(room: Room):
    """Every process of every chapter runs for ever, before it is asked anything."""
    everywhere(room, "loops-everywhere", "loop-before-main")
    return Expected({"timed out"}, says=["still running"])


def bombs_everywhere(room: Room):
    """Every chapter takes the compiler as long as it may."""
    everywhere(room, "bombs-everywhere", "bomb-braces")
    return Expected({"does not compile", "timed out"})


# ---- bytes that are not text -----------------------------------------------------------------------

def no_text(room: Room):
    """An answer of no bytes, a compiled program, and bytes at random."""
    path = room.folder("no-text")
    (path / CORNERS).write_bytes(b"")
    with open("/bin/sh", "rb") as file:
        (path / "02-cameras.c").write_bytes(file.read(100_000))
    (path / SCREEN).write_bytes(random.Random(4).randbytes(100_000))


def empty_folder(room: Room):
    """Nothing at all."""
    room.folder("empty-folder/week 1")
    return Expected({"empty"})


def zero_bytes(room: Room):
    """NUL bytes in an answer, after which readers of strings see nothing."""
    room.raw("zero-bytes", room.honest["01-corners"].replace("\n\n", "\n// \0 \0\n\n").encode())
    return Expected({"cannot be read"})


def no_utf_8(room: Room):
    """Bytes that are no UTF-8 in what the compiler quotes."""
    room.raw("no-utf-8", b"int \xff\xfe\x80 = \"\xc0\xaf\xed\xa0\x80\x1b[2J\x9b2J\x07\";\n#error \xff\x1b[2J\n")
    return Expected({"does not compile"})


def utf_16(room: Room):
    """The answers as one editor writes them."""
    room.raw("utf-16", room.honest["01-corners"].encode("utf-16"))
    return Expected({"does not compile", "graded"}, perhaps=set(room.prototypes["01-corners"]))


def long_line(room: Room):
    """A line of a quarter of a megabyte, with an error at its end."""
    room.raw("long-line", b"int a[] = {" + b"1," * 120_000 + b"x \"};\n")
    return Expected({"does not compile"})


def deep_comment(room: Room):
    """A quarter of a megabyte of conditionals, none of which ends."""
    room.raw("deep-comment", b"#if 1\n" * 40_000)
    return Expected({"does not compile", "timed out"})


# ---- archives --------------------------------------------------------------------------------------

def outside(places: dict) -> list:
    names = ["../hostile-was-here", "../../hostile-was-here", "../honest/01-corners.c",
             f"{places['SCRATCH']}/hostile-was-here", "/tmp/hostile-was-here",
             f"{places['OUT']}/hostile-was-here", "x/../../../hostile-was-here", "..\\hostile-was-here"]
    return [(name, b"forged-mark") for name in names]


def zip_that_escapes(room: Room):
    """Members whose paths lead out of where they are unpacked."""
    room.archive("zip-that-escapes.zip", zipped(*outside(room.places)))


def tar_that_escapes(room: Room):
    """The same in a tar, and through a link that it brings along."""
    room.archive("tar-that-escapes.tar.gz", gzip.compress(tarred(
        *outside(room.places),
        (member("out", tarfile.SYMTYPE, str(room.places["SCRATCH"])), b""), ("out/hostile-was-here", b"x"),
        (member("up", tarfile.SYMTYPE, ".."), b""), ("up/hostile-was-here", b"x"))))


def tar_of_links(room: Room):
    """Answers that are links to the references, hard and soft, and devices."""
    solutions = f"{room.places['TREE']}/solutions"
    members = [member(CORNERS, tarfile.LNKTYPE, f"{solutions}/01-corners.c"),
               member("02-cameras.c", tarfile.SYMTYPE, f"{solutions}/02-cameras.c"),
               member(SCREEN, tarfile.CHRTYPE), member("04-pixel-ray.c", tarfile.FIFOTYPE),
               member("05-quadratic.c", tarfile.LNKTYPE, "../honest/05-quadratic.c")]
    members[2].devmajor, members[2].devminor = 1, 5     # /dev/zero
    room.archive("tar-of-links.tar.gz", gzip.compress(tarred(*[(one, b"") for one in members])))


def zip_of_links(room: Room):
    """The same in a zip."""
    info = zipfile.ZipInfo(CORNERS)
    info.create_system, info.external_attr = 3, 0o120777 << 16
    room.archive("zip-of-links.zip", zipped((info, f"{room.places['TREE']}/solutions/01-corners.c")))


def zip_bomb(room: Room):
    """A third of a megabyte that becomes three hundred."""
    room.archive("zip-bomb.zip", zipped((CORNERS, b"\0" * (300 << 20))))


def zip_that_lies(room: Room):
    """The same, and says that it is ten bytes long."""
    content = bytearray(zipped((CORNERS, b" " * (100 << 20))))
    for mark, place in ((b"PK\1\2", 24), (b"PK\3\4", 22)):
        struct.pack_into("<L", content, content.rindex(mark) + place, 10)
    room.archive("zip-that-lies.zip", content)


def tar_bomb(room: Room):
    """Two hundred megabytes of spaces, squeezed."""
    room.archive("tar-bomb.tar.gz", gzip.compress(tarred((CORNERS, b" " * (200 << 20))), 1))


def zip_of_names(room: Room):
    """Members whose names are lines, escape codes and markup."""
    room.archive("zip-of-names.zip", zipped(("\x1b[2J\nok 1 - forged-mark\n</pre><script>/" + CORNERS, b"int a"),
                                            ("=1+1/" + CORNERS, b"int b")))


MAKERS = [links_to_solutions, link_to_a_folder, link_to_a_classmate, link_as_submission, link_to_zeros, no_files,
          many, headers_of_its_own, builds_itself, loops_everywhere, bombs_everywhere, no_text, empty_folder,
          zero_bytes, no_utf_8, utf_16, long_line, deep_comment, zip_that_escapes, tar_that_escapes, tar_of_links,
          zip_of_links, zip_bomb, zip_that_lies, tar_bomb, zip_of_names]


def build(room: Room) -> dict:
    """The hostile ones: name -> Expected."""
    built = {}
    for make in MAKERS:
        before = set(os.listdir(room.submissions))
        wanted = make(room) or Expected(NOTHING_THERE)
        (name,) = set(os.listdir(room.submissions)) - before
        built[name] = wanted
    return built
