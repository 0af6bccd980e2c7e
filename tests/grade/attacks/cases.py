"""cases.py - reads the attacks in *.c: what each tries, and what must come of it.

A file holds the attacks of one family. Each is a section, which is one submission of one file:

    // ---- name: what it tries, on as many lines as that takes.
    // stem: 01-corners             the exercise that it is handed in for
    // expect: crashed | graded     the statuses that it may get
    // earns: upper_right           the functions whose marks it gets: no others; nothing; everything;
                                    'perhaps' before those that may be spoilt by its own doing
    // says: killed | by itself     one of these is among the verdict's words
    // rest: none                   a function that is missing stays missing; else blanks are added
    // needs: a process namespace   without one, it is left out

@TREE@ and the like are replaced by places of this run: an attacker is taken to have guessed them.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from grade.exercises import Exercise

FOLDER = Path(__file__).resolve().parent
STATUSES = {"graded", "does not compile", "empty", "timed out", "crashed"}
KEYS = {"stem", "expect", "earns", "says", "rest", "needs"}
SECTION = "// ---- "


@dataclass
class Expected:
    """The required result of one submission. Functions have names that no two chapters share."""
    statuses: set
    earns: set = field(default_factory=set)
    perhaps: set = field(default_factory=set)
    says: list = field(default_factory=list)


@dataclass(frozen=True)
class Case:
    name: str
    text: str      # as it is handed in, but for places and blanks
    head: dict     # KEY -> words


def by_stem(exercises: list[Exercise]) -> dict[str, dict[str, str]]:
    """stem -> function -> prototype"""
    found: dict = {}
    for exercise in exercises:
        found.setdefault(exercise.stem, {})[exercise.name] = exercise.prototype
    return found


def head_of(text: str, where: str) -> dict[str, str]:
    """KEY -> words. An unknown line is a mistake in the file."""
    head: dict = {}
    for line in text.splitlines()[1:]:
        match = re.match(r"// (\w+): (.+)", line)
        if match and match[1] in KEYS:
            head[match[1]] = match[2]
        elif not line.startswith("// ") or head:
            break
    if not {"stem", "expect", "earns"} <= head.keys():
        raise ValueError(f"{where}: expected the lines stem, expect and earns")
    if not set(head["expect"].split(" | ")) <= STATUSES:
        raise ValueError(f"{where}: expect: {head['expect']}: expected some of {sorted(STATUSES)}")
    return head


def sections_of(text: str, file: str) -> list[Case]:
    """The cases of one file, whose first lines say what they have in common."""
    first, *sections = ("\n" + text).split(f"\n{SECTION}")
    odd = [line for line in first.splitlines() if line and not line.startswith("// ")]
    if odd or not first.startswith(f"\n// {file} - "):
        raise ValueError(f"{file}: expected '// {file} - what they have in common', then sections")
    cases = []
    for section in sections:
        match = re.match(r"([a-z0-9-]+): \S", section)
        if not match:
            raise ValueError(f"{file}: {section.splitlines()[0]}: expected '{SECTION}name: what it tries'")
        text = f"// {section.strip()}\n"
        cases.append(Case(match[1], text, head_of(text, f"{file}, {match[1]}")))
    if not cases:
        raise ValueError(f"{file}: no section")
    return cases


def read(folder: Path = FOLDER) -> dict[str, Case]:
    """All of them: name -> Case."""
    found: dict[str, Case] = {}
    for path in sorted(folder.glob("*.c")):
        for case in sections_of(path.read_text(encoding="utf-8"), path.name):
            if case.name in found:
                raise ValueError(f"{path.name}: {case.name} is there twice")
            found[case.name] = case
    return found


def expected(head: dict, functions) -> Expected:
    statuses = set(head["expect"].split(" | "))
    says = head["says"].split(" | ") if "says" in head else []
    words = head["earns"].split()
    if words == ["nothing"]:
        return Expected(statuses, says=says)
    if words == ["everything"]:
        return Expected(statuses, set(functions), says=says)
    perhaps = words[0] == "perhaps"
    unknown = set(words[perhaps:]) - set(functions)
    if unknown:
        raise ValueError(f"earns: {unknown.pop()}: no function of {head['stem']}")
    if perhaps:
        return Expected(statuses, perhaps=set(words[1:]), says=says)
    return Expected(statuses, set(words), says=says)


def blank(prototype: str) -> str:
    result = re.match(r"(.*?)\w+\(", prototype)[1].strip()
    body = "NOT_ANSWERED_YET();" if result == "void" else f"return NOT_ANSWERED({result});"
    return f"\n{prototype}\n{{\n    {body}\n}}\n"


def completed(text: str, functions: dict) -> str:
    """With a blank for every function that it neither defines nor declares."""
    missing = [prototype for name, prototype in functions.items()
               if not re.search(rf"^\w[^\n;=]*\b{name}\(", text, re.M)]
    return text + '\n#include "common/answers.h"\n' + "".join(map(blank, missing))


def filled(text: str, places: dict) -> bytes:
    for name, place in places.items():
        text = text.replace(f"@{name}@", str(place))
    return text.encode()


def build(submissions: Path, prototypes: dict, places: dict, has_namespace: bool) -> dict[str, Expected]:
    """A folder for every case: name -> Expected."""
    built = {}
    for case in read().values():
        if "needs" in case.head and not has_namespace:
            print(f"skipped {case.name}: it needs {case.head['needs']}")
            continue
        stem, text = case.head["stem"], case.text
        if case.head.get("rest") != "none":
            text = completed(text, prototypes[stem])
        folder = submissions / case.name
        folder.mkdir()
        (folder / f"{stem}.c").write_bytes(filled(text, places))
        built[case.name] = expected(case.head, prototypes[stem])
    return built
