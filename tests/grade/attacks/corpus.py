"""corpus.py - reads tests/grade/attacks/*.c: what each tries, and what must come of it.

The first lines of a file say it:

    // name: what it tries, on as many lines as that takes.
    // stem: 01-corners             the exercise that it is handed in for
    // expect: crashed | graded     the statuses that it may get
    // earns: upper_right           the functions whose marks it gets: no others; nothing; everything;
                                    'perhaps' before those that may be spoilt by its own doing
    // says: killed | by itself     one of these stands in the verdict's words
    // rest: none                   what it leaves out stays out; else blanks are added
    // needs: a process namespace   where there is none it is left out

@TREE@ and the like stand for places of this run: an attacker is taken to have guessed them.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
STATUSES = {"graded", "does not compile", "empty", "timed out", "crashed"}
KEYS = {"stem", "expect", "earns", "says", "rest", "needs"}


@dataclass
class Expected:
    """What must come of one submission. Functions have names that no two chapters share."""
    statuses: set
    earns: set = field(default_factory=set)
    perhaps: set = field(default_factory=set)
    says: list = field(default_factory=list)


def exercises(tree: Path) -> dict:
    """stem -> function -> prototype"""
    table: dict = {}
    for line in (tree / "tests/exercises.table").read_text().splitlines():
        if line and not line.startswith("#"):
            stem, prototype = line.split(" | ")[:2]
            table.setdefault(stem, {})[re.match(r".*?(\w+)\(", prototype)[1]] = prototype
    return table


def head_of(text: str, name: str) -> dict:
    """KEY -> words. What is not understood is a mistake in the corpus."""
    head: dict = {}
    lines = text.splitlines()
    if not lines[0].startswith(f"// {name}: "):
        raise ValueError(f"{name}.c:1: expected '// {name}: what it tries'")
    for number, line in enumerate(lines[1:], 2):
        match = re.match(r"// (\w+): (.+)", line)
        if match and match[1] in KEYS:
            head[match[1]] = match[2]
        elif not line.startswith("// ") or head:
            break
    if not {"stem", "expect", "earns"} <= head.keys():
        raise ValueError(f"{name}.c: expected the lines stem, expect and earns")
    if not set(head["expect"].split(" | ")) <= STATUSES:
        raise ValueError(f"{name}.c: expect: {head['expect']}: expected some of {sorted(STATUSES)}")
    return head


def expected(head: dict, functions) -> Expected:
    statuses = set(head["expect"].split(" | "))
    says = head["says"].split(" | ") if "says" in head else []
    words = head["earns"].split()
    if words == ["nothing"]:
        return Expected(statuses, says=says)
    if words == ["everything"]:
        return Expected(statuses, set(functions), says=says)
    if words[0] == "perhaps":
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


def build(submissions: Path, table: dict, places: dict, has_namespace: bool) -> dict:
    """A folder for every file of the corpus: name -> Expected."""
    built = {}
    for path in sorted(FOLDER.glob("*.c")):
        text = path.read_text(encoding="utf-8")
        head = head_of(text, path.stem)
        if "needs" in head and not has_namespace:
            print(f"skipped {path.stem}: it needs {head['needs']}")
            continue
        functions = table[head["stem"]]
        if head.get("rest") != "none":
            text = completed(text, functions)
        folder = submissions / path.stem
        folder.mkdir()
        (folder / f"{head['stem']}.c").write_bytes(filled(text, places))
        built[path.stem] = expected(head, functions)
    return built
