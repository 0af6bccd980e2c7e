"""building.py - a submission's answers become programs, or words about why not.

The words are the compiler's: cut, harmless on a terminal, and without the places of this machine.
"""
from __future__ import annotations

import re

from workbench import COMPILE, LINK, Workbench
from visible import visible

MOST_WORDS = 2000      # characters that are quoted of a compiler
MOST_LINES = 30
CUT_SHORT = ("signal terminated program", "limit exceeded", "out of memory")


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


def compile_words(bench: Workbench, stem: str) -> str:
    words = quoted(bench, f"{stem}.words")
    if words and not any(sign in words for sign in CUT_SHORT):
        return quoted(bench, f"{stem}.help") or words
    return ("the compiler was stopped: it needed more than 5 seconds, a gigabyte of memory, "
            f"or 16 MB of file\n{words}").strip()


def link_words(bench: Workbench, stem: str) -> str:
    words = quoted(bench, f"{stem}.words")
    known = [f"{name} is not in this file (or is static)"
             for name in re.findall(r"undefined reference to [`'](\w+)'", words)]
    known += ["leave main out: the tests have one" if name == "main" else
              f"{name} is there already: give yours another name"
              for name in re.findall(r"multiple definition of [`'](\w+)'", words)]
    return "\n".join(dict.fromkeys(known)) or words or "the linker was stopped"


def build(bench: Workbench, answers: dict) -> tuple[list[str], dict[str, tuple[str, str]]]:
    """The stems that became programs; and of those that did not, the state and the words."""
    there = [stem for stem, answer in answers.items() if answer.state == "found"]
    for stem in there:
        (bench.folder / f"{stem}.c").write_bytes(answers[stem].text)
        (bench.folder / f"{stem}.d").mkdir()
    if there:
        bench.compile(COMPILE, there)
    compiled = [stem for stem in there if (bench.folder / f"{stem}.o").exists()]
    if compiled:
        bench.link(LINK, compiled)
    linked = [stem for stem in compiled if (bench.folder / f"{stem}.exe").exists()]
    trouble = {}
    for stem in there:
        if stem not in compiled:
            trouble[stem] = ("does not compile", compile_words(bench, stem))
        elif stem not in linked:
            trouble[stem] = ("cannot be linked", link_words(bench, stem))
    return linked, trouble
