"""cases.py - reads the attacks in *.txt: what each tries, and what must come of it.

A line that begins with ==== heads a family. Each attack is a section, which is one submission of one file:

    ---- name: what it tries, on as many lines as that takes.
    -> crashed | graded; earns upper_right; says killed | by itself
    static int one(void): return 1;
    upper_left:
        c.distance = one();

After the arrow are the statuses that it may get, then, each only if it is so:

    earns FUNCTIONS     they get their marks, and no others; 'everything': all of its exercise
    perhaps FUNCTIONS   they may get their marks, or be spoilt by its own doing
    also FUNCTIONS      they are right, and get no marks
    wrong FUNCTIONS     they are wrong; how does not matter
    says WORDS | WORDS  one of these is among the verdict's words
    of STEM             the exercise that it is handed in for, if it is not 01-corners
    bare                handed in as it is; else the contract and prelude.h come before it, and after it such
                        answers for the functions named here that it does not have, and blanks for the others
    needs WHAT          without it, the attack is left out

Then comes C as shorthand.py has it; an exercise's function that returns a vector also returns c.up at the end.

A text that includes its contract itself gets no prelude. @TREE@ and the like are replaced by places of this run: an
attacker is taken to have guessed them.
"""
from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from grade.shorthand import completed, definitions, spelled_out

FOLDER = Path(__file__).resolve().parent
STATUSES = {"graded", "does not compile", "empty", "timed out", "crashed", "cannot be read", "partly read"}
KEYS = {"earns", "perhaps", "also", "wrong", "says", "of", "bare", "needs"}
SECTION = "---- "


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
    statuses: set
    head: dict     # KEY -> words
    text: str      # after the head

    @property
    def stem(self) -> str:
        return self.head.get("of", "01-corners")


def case_of(section: str, file: str) -> Case:
    match = re.match(r"([a-z0-9-]+): (?:.*\n)+?-> (.+)\n", section)
    if not match:
        raise ValueError(f"{file}: {section[:99]!r}: expected '{SECTION}name: what it tries', and after '-> ' what it gets")
    statuses, *rest = match[2].split("; ")
    head = {key: words for key, _, words in (part.partition(" ") for part in rest)}
    if not set(statuses.split(" | ")) <= STATUSES or not head.keys() <= KEYS:
        raise ValueError(f"{file}: {match[2]}: expected some of {sorted(STATUSES)}, then of {sorted(KEYS)}")
    return Case(match[1], set(statuses.split(" | ")), head, section[match.end():])


def read(folder: Path = FOLDER) -> dict[str, Case]:
    """All of them: name -> Case."""
    found: dict[str, Case] = {}
    for path in sorted(folder.glob("*.txt")):
        text = re.sub("^==== .*\n", "", path.read_text(encoding="utf-8"), flags=re.M)
        for section in text.split(f"\n{SECTION}")[1:]:
            case = case_of(section, path.name)
            if case.name in found:
                raise ValueError(f"{path.name}: {case.name} is there twice")
            found[case.name] = case
    return found


def named(case: Case, key: str, functions) -> set:
    words = case.head.get(key, "").split()
    if not set(words) <= {*functions, "everything"}:
        raise ValueError(f"{case.name}: {key} {' '.join(words)}: no functions of {case.stem}")
    return set(functions) if words == ["everything"] else set(words)


def expected(case: Case, functions) -> Expected:
    says = case.head["says"].split(" | ") if "says" in case.head else []
    return Expected(case.statuses, named(case, "earns", functions), named(case, "perhaps", functions), says)


def last_line(prototype: str) -> str:
    return "    return c.up;\n" if prototype.startswith("vec3 ") and "Camera c" in prototype else ""


def answers(case: Case, functions: dict, reference: str) -> dict:
    """FUNCTION -> its definition, for those that are said to be right or wrong."""
    right = {name: functions[name] for key in ("earns", "perhaps", "also") for name in named(case, key, functions)}
    return {**{name: f"{functions[name]}\n{{\n    return c.up;\n}}\n" for name in named(case, "wrong", functions)},
            **definitions(reference, right)}


def prelude() -> str:
    """With the judge's messages as they are now."""
    message = (FOLDER.parents[1] / "judge/message.h").read_text(encoding="utf-8")
    header = re.search(r"typedef struct \{\n    uint32_t magic;.*?\} Crash;\n", message, re.S)[0]
    return (FOLDER / "prelude.h").read_text(encoding="utf-8").replace("@MESSAGE@\n", header)


def handed_in(case: Case, functions: dict, reference: str, places: dict) -> bytes:
    text, contract = spelled_out(case.text, functions, last_line), f'#include "exercises/{case.stem}.h"\n'
    if "bare" not in case.head:
        if contract not in text:
            text = contract + prelude() + text
        text = completed(text, functions, answers(case, functions, reference))
    for name, place in places.items():
        text = text.replace(f"@{name}@", str(place))
    return text.encode()


def build(honest: dict, prototypes: dict, places: dict, is_wanted: Callable) -> dict[str, tuple[dict, Expected]]:
    """name -> what is handed in, and what must come of it. honest: stem -> the reference."""
    built = {}
    for case in filter(lambda case: is_wanted(case.name), read().values()):
        functions, reference = prototypes[case.stem], honest[case.stem]
        if "needs" in case.head and os.getpid() != 1:
            print(f"skipped {case.name}: it needs {case.head['needs']}")
        else:
            built[case.name] = ({f"{case.stem}.c": handed_in(case, functions, reference, places)}, expected(case, functions))
    return built
