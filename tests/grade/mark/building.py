"""building.py - a submission's answers become programs, or words about why not.

The words are the compiler's: cut, harmless on a terminal, and without the places of this machine.
"""
from __future__ import annotations

import re
import struct
from typing import Callable

from grade.confine.machine import believed
from grade.visible import visible

from .commands import BLANK, DONE, HEADERS, LIMITED, Command
from .workbench import Workbench

MOST_WORDS = 2000      # characters that are quoted of a compiler
MOST_LINES = 30
MOST_EXPLAINED = 1 << 20    # bytes of what it said
CUT_SHORT = ("signal terminated program", "limit exceeded", "out of memory")
MOST_MEMORY = 400 << 20     # that a program may take before it does anything; confine/ allows 512 MB in all
# Headers that an answer may include and its blank may not; every C compiler has them.
C_HEADERS = ("assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdarg stdbool "
             "stddef stdint stdio stdlib string tgmath time wchar wctype").split()


def quoted(bench: Workbench, name: str) -> str:
    try:
        with open(bench.folder / name, "rb") as file:
            raw = file.read(8 * MOST_WORDS)
    except OSError:
        return ""
    text = raw.decode("utf-8", "replace").replace("‘", "'").replace("’", "'")
    text = text.replace(f"{bench.kit.folder}/headers/", "")
    lines = text[:MOST_WORDS].splitlines()
    cut = len(text) > MOST_WORDS or len(lines) > MOST_LINES
    return visible("\n".join(lines[:MOST_LINES] + ["..."] * cut), lines=True)


def compile_words(bench: Workbench, stem: str, status: int) -> str:
    words = quoted(bench, f"{stem}.words")
    if words and status not in LIMITED and not any(sign in words for sign in CUT_SHORT):
        return quoted(bench, f"{stem}.help") or words
    return ("the compiler was stopped: it needed more than 5 seconds, a gigabyte of memory, "
            f"or a file of 16 MB; or the object file has more than 2 MB\n{words}").strip()


def link_words(bench: Workbench, stem: str, status: int) -> str:
    if status in LIMITED:
        return "the linker was stopped: it needed more than 5 seconds, or the program has more than 4 MB"
    words = quoted(bench, f"{stem}.help") or quoted(bench, f"{stem}.words") or "the linker was stopped"
    return "\n".join(line.removeprefix("  ") for line in words.splitlines())


def is_refused(status: int) -> bool:
    return status != DONE


def compiled(bench: Workbench, stems: list[str]) -> dict[str, int]:
    def compiling(name: str) -> Command:
        return bench.kit.compile(name, bench.sandbox.confine)

    def again(stem: str) -> int:
        headers = "".join(f"#include <{name}.h>\n" for name in C_HEADERS)
        (bench.folder / f"{BLANK}{stem}.c").write_text(bench.kit.blank(stem) + headers)
        return bench.sandwich(bench.compile, compiling(f"{BLANK}{stem}"), compiling(stem))

    # Here the explainer of compiler messages looks up the functions that an answer may use.
    for name in ("common", "exercises"):
        (bench.folder / name).symlink_to(bench.kit.folder / HEADERS / name)
    statuses = believed(bench.compile([compiling(stem) for stem in stems]), is_refused, again)
    refused = [stem for stem, status in statuses.items() if is_refused(status)]
    for stem in refused:
        name_the_assembler_s_file(bench, stem)
    if refused:
        bench.compile([bench.kit.explain(stem) for stem in refused])
    return statuses


def name_the_assembler_s_file(bench: Workbench, stem: str) -> None:
    """It speaks of a file whose name is drawn at random, and whose place is the sandbox's."""
    path = bench.folder / f"{stem}.words"
    words = path.read_bytes()[:MOST_EXPLAINED]
    path.write_bytes(re.sub(rb"(?m)^/.*/cc[A-Za-z0-9]*\.s:", f"{stem}.s:".encode(), words))


def linked(bench: Workbench, commands: dict[str, Command], right: Callable[[str], Command]) -> dict[str, int]:
    """By the name of each command. right: one that cannot fail, for a name."""
    return believed(bench.link(list(commands.values())), is_refused,
                    lambda name: bench.sandwich(bench.link, right(name), commands[name]))


def memory_of(program: bytes) -> int:
    """The memory of its segments. The kernel kills a program that has no room for them, and it would do the same
    if the machine had no memory left. A file that is not a program takes nothing."""
    try:
        start, = struct.unpack_from("<Q", program, 32)
        size, count = struct.unpack_from("<HH", program, 54)
        return sum(memory for kind, memory in
                   ((struct.unpack_from("<I", program, at)[0], struct.unpack_from("<Q", program, at + 40)[0])
                    for at in range(start, start + size * count, size)) if kind == 1)
    except (struct.error, ValueError):
        return 0


def build(bench: Workbench, answers: dict) -> tuple[list[str], dict[str, tuple[str, str]]]:
    """The stems that became programs; and of those that did not, the state and the words."""
    there = [stem for stem, answer in answers.items() if answer.state == "found"]
    for stem in there:
        (bench.folder / f"{stem}.c").write_bytes(answers[stem].text)
        (bench.folder / f"{stem}.d").mkdir()
    objects = compiled(bench, there) if there else {}
    good = [stem for stem, status in objects.items() if not is_refused(status)]
    programs = linked(bench, {stem: bench.kit.link(stem) for stem in good}, bench.kit.link_blanks) if good else {}
    unlinked = [stem for stem, status in programs.items() if is_refused(status)]
    if unlinked:
        bench.link([bench.kit.explain(stem, "--linker") for stem in unlinked])
    ready, trouble = [], {}
    for stem in there:
        if stem not in good:
            trouble[stem] = ("does not compile", compile_words(bench, stem, objects[stem]))
        elif stem in unlinked:
            trouble[stem] = ("cannot be linked", link_words(bench, stem, programs[stem]))
        elif memory_of((bench.folder / f"{stem}.exe").read_bytes()) > MOST_MEMORY:
            trouble[stem] = ("cannot be linked", "its variables take more than 400 MB of memory")
        else:
            ready.append(stem)
    return ready, trouble
