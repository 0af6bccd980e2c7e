"""shorthand.py - answers as tests write them: C in which a function is its head, a colon, and its body, on the same line
or indented below it. An exercise's function goes by its name alone.

    static int one(void): return 1;
    upper_left:
        c.distance = one();
        return c.up;
"""
from __future__ import annotations

import re
from collections.abc import Callable

# A function: comments, its name or head, and its body.
FUNCTION = re.compile(r'^((?:/[/*].*\n)*)(\w+|[^\n"#;]*\)):(?: (.+))?\n((?: {4}.*\n)*)', re.M)


def spelled_out(text: str, prototypes: dict, last: Callable[[str], str] = lambda prototype: "") -> str:
    """The same as C. prototypes: function -> head; last: the line that such a function ends with."""
    def definition(match: re.Match) -> str:
        comments, name, line, lines = match.groups()
        head, body = prototypes.get(name), lines if line is None else f"    {line}\n{lines}"
        return f"\n{comments}{head or name}\n{{\n{body}{last(head) if head else ''}}}\n"
    return FUNCTION.sub(definition, text)


def answer(stem: str, text: str, prototypes: dict) -> str:
    """A file that can be handed in."""
    return f'#include "exercises/{stem}.h"\n' + spelled_out(text, prototypes)


def definitions(text: str, prototypes: dict) -> dict:
    """Function -> its definition, as a file has it."""
    return {name: re.search(rf"^{re.escape(head)}\n.*?^}}\n", text, re.M | re.S)[0] for name, head in prototypes.items()}


def blank(prototype: str) -> str:
    result = re.match(r"(.*?)\w+\(", prototype)[1].strip()
    body = "NOT_ANSWERED_YET();" if result == "void" else f"return NOT_ANSWERED({result});"
    return f"\n{prototype}\n{{\n    {body}\n}}\n"


def completed(text: str, prototypes: dict, given: dict) -> str:
    """With what is given, or a blank, for every function that it neither defines nor declares."""
    text += '\n#include "common/answers.h"\n'
    for name, prototype in prototypes.items():
        if not re.search(rf"^\w[^\n;=]*\b{name}\(", text, re.M):
            text += given.get(name) or blank(prototype)
    return text
