"""records.py - records by hand, for the tests of the reports: an ordinary class, drawn from the real exercises and the
real mistakes, always the same way; and one in which every string that quotes a student is an attack.

To look at the reports: PYTHONPATH=tests python3 -B -m grade.check.records build/sample
"""
import functools
import os
import pathlib
import random
import re
import struct
import sys
import zlib

from grade.exercises import read
from grade.report.files import write_class, write_submission
from grade.report.text import closing


def function(name, slide="", prompt="", state="right", most=4.0, **more) -> dict:
    return {"name": name, "slide": slide, "prompt": prompt, "state": state,
            "score": most if state in ("right", "waiting") else 0.0, "max": most, "test": "", "hidden": False,
            "given": [], "expected": "", "yours": "", "how": "", "waiting_for": [], "mistake": None, "partly": False,
            "law": "", **more}


def stem(name, functions=(), state="judged", most=0.0, **more) -> dict:
    return {"stem": name, "file": name + ".c" if state not in ("missing", "twice") else "", "state": state,
            "words": "", "score": sum(one["score"] for one in functions),
            "max": most or sum(one["max"] for one in functions), "functions": list(functions), **more}


def record(name, stems, status="graded", **more) -> dict:
    return {"submission": name, "folder": name, "status": status, "words": "",
            "score": sum(one["score"] for one in stems), "max": sum(one["max"] for one in stems), "late": "",
            "seed": 123456, "sandbox": "bubblewrap, Landlock, seccomp", "unsafe": False, "seconds": 0.41,
            "pictures": {}, "stems": stems, **more}


def png(columns, rows, shade) -> bytes:
    """A small picture: shade(x, y) gives three bytes, x and y from -1 to 1."""
    lines = b"".join(
        b"\0" + b"".join(bytes(shade(2 * (x + 0.5) / columns - 1, 2 * (y + 0.5) / rows - 1)) for x in range(columns))
        for y in range(rows)
    )

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(lines))
        + chunk(b"IEND", b"")
    )


def ball(radius: float) -> bytes:
    def shade(x, y):
        depth = radius * radius - x * x - y * y
        return (0, 0, 0) if depth < 0 else (int(250 * depth**0.5 / radius), int(120 * radius), 90)

    return png(96, 72, shade)


# ---- hostile ------------------------------------------------------------------------------------


# Strings that a student might put into a name, a file name or a compiler message; some raw, though the
# grader should have escaped them by then.
HOSTILE = [
    "\"quotes\" 'both' `ticks`",
    "two\nlines",
    "two\r\nwindows lines",
    "\x1b[2J\x1b]0;title\x07",
    "]]>",
    "<![CDATA[",
    "</script><script>alert(1)</script>",
    "</style><img src=x onerror=alert(1)>",
    '" onmouseover="alert(1)',
    "--><!--",
    "<?xml version='1.0'?><!DOCTYPE x [<!ENTITY y 'z'>]>&y;",
    "=cmd|' /C calc'!A0",
    "+1+1",
    "-2+3",
    "@SUM(1+1)",
    "\t=1+1",
    "\r=1+1",
    " =1+1",
    "＝1+1",
    "a;=1+1;b",
    'a,"b",c',
    "nul\0inside",
    os.fsdecode(b"caf\xe9 \xff\xfe"),
    "\ud800 \udfff",
    "line\u2028separator\u2029paragraph",
    "\u202egnp.exe",
    "\u2066isolate\u200b\ufeff",
    "\ufffe\uffff",
    "x" * 30_000,
    "not ok 1 - forged",
    "\nok 99 - forged\n1..1\nBail out! forged",
    "# SKIP forged",
    "x # TODO forged",
    "\\# \\\\",
    "  ---\n  forged: true\n  ...",
    "...",
    "%s%n%d {0} {name}",
    "\\u0000 \\x1b",
    "[[ATTACHMENT|/etc/passwd]]",
    "javascript:alert(1)",
    "../../up",
    "-rf --help",
    "&amp;&lt;&#0;",
    "\U0001f600 \U000e0041 \U0010ffff",
    "e" + "\u0301" * 50,
    "",
    " ",
    "~",
    "$(id) `id`",
]


def hostile_record(text: str, place: int) -> dict:
    """Every string that might quote a student is the same hostile one. Ten points, always."""
    trap = {
        "test": text,
        "how": "",
        "law": text,
        "expected": text,
        "yours": text,
        "given": [[text, text], ["ray", text]],
        "mistake": None,
    }
    known = {"id": text, "formula": text, "why": text, "picture": text}
    quadratic = [
        function("to_object_coordinates"),
        function("object_quadratic", text, text, "wrong", **trap),
        function("world_quadratic", text, text, "wrong", **{**trap, "mistake": known}),
        function("quadratic_roots", text, text, "unanswered", **trap),
        function("sphere_roots", text, text, "waiting", waiting_for=[text, text]),
        function("hit_sphere", text, text, "crashed", **{**trap, "how": text}),
    ]
    stems = [
        stem("01-corners", state="missing", most=20.0, words=text),
        stem("02-cameras", state="twice", most=20.0, words=text + "\n" + text),
        stem("03-screen", state="does not compile", most=12.0, words=text, file=text),
        stem("04-pixel-ray", state="not judged", most=4.0, words=text, file=text),
        stem("05-quadratic", quadratic, file=text),
    ]
    return record(
        text, stems, "crashed", words=text, late=text, folder=f"h{place:02}", pictures={"expected": text, "yours": text}
    )


def hostile_class() -> list:
    return [hostile_record(text, place) for place, text in enumerate(HOSTILE)]


# ---- ordinary -----------------------------------------------------------------------------------


TESTS = pathlib.Path(__file__).resolve().parents[2]


def exercises() -> dict:
    """stem -> list of (function, slide, prompt)."""
    found = {}
    for each in read():
        found.setdefault(each.stem, []).append((each.name, each.slide, each.prompt))
    return found


@functools.lru_cache(maxsize=None)
def mistakes() -> dict:
    """function -> list of mistakes, from the C that knows them."""
    found = {}
    string = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
    for path in sorted(TESTS.glob("[0-9]*/wrong.c")):
        for each in re.finditer(rf"WRONG(?:_LINE)?\((\w+),\s*{string},\s*{string},\s*{string},\s*{string}[,)]",
                                path.read_text(encoding="utf-8")):
            function, name, *words = each.groups()
            name, formula, why, picture = ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', part)) for part in [name] + words]
            found.setdefault(function, []).append({"id": name, "formula": formula, "why": why, "picture": picture})
    return found


def wrong(name, slide, prompt, chance) -> dict:
    known = mistakes().get(name, [])
    how = {}
    kind = chance.random()
    if kind < 0.6 and known:
        how = {"mistake": known[chance.randrange(min(3, len(known)))], "partly": kind < 0.1}
    elif kind < 0.7:
        how = {"hidden": True, "law": "your root is at t = 8.1234, and that is not on the sphere"}
    else:
        how = {"law": "your direction has length 2, and one was asked for"}
    if not how.get("hidden"):
        how |= {
            "expected": "(-1, 1, 4)",
            "yours": "(-2, 2, 4)",
            "given": [
                ["camera", "eye (2, 2, -4), right (1, 0, 0), up (0, 1, 0), forward (0, 0, 1), " "d~4, w~2, h~2"],
                ["ray", "origin (1, 2, 3), direction (0, 0, 1)"],
            ],
        }
    return function(name, slide, prompt, "wrong", test="the_example_of_the_deck_comes_out", **how)


COMPILER = """05-quadratic.c:31:12: error: expected ';' before 'return'
   31 |     double a = dot(ray.direction, ray.direction)
      |                                                 ^
      |                                                 ;
  help: a statement ends with a semicolon; this one does not."""


def ordinary_class(size=12, seed=4) -> list:
    chance = random.Random(seed)
    them = []
    for place in range(size):
        skill, stems = chance.uniform(0.5, 1.05), []
        for name, asked in exercises().items():
            if chance.random() < 0.03:
                stems.append(stem(name, state="missing", most=4.0 * len(asked)))
                continue
            functions = []
            for each in asked:
                if chance.random() < skill:
                    functions.append(function(*each))
                elif chance.random() < 0.2:
                    functions.append(function(*each, state="unanswered"))
                elif chance.random() < 0.1:
                    functions.append(function(*each, state="timed out", test="a_ray_that_misses",
                                              how="was still running after 1 s (an endless loop?)"))
                else:
                    functions.append(wrong(*each, chance))
            stems.append(stem(name, functions))
        them.append(record(f"group {place + 1:02}", stems, pictures={"expected": "expected.png", "yours": "yours.png"}))
    if size < 12:
        return them
    all_stems = list(exercises().items())
    them[2]["late"] = "2 days late: 10 of 100 marks less for each"
    them[2]["score"] -= 20
    missing = [stem(name, state="missing", most=4.0 * len(asked)) for name, asked in all_stems]
    them[3].update(record("group 04 (empty).zip", missing, "empty", words="no NN-stem.c in it"))
    them[6]["stems"][4] = stem("05-quadratic", state="does not compile", most=24.0, words=COMPILER)
    them[6].update(status="does not compile", words="05-quadratic.c does not compile")
    them[7]["stems"][1] = stem("02-cameras", state="twice", most=20.0, words="week 3/02-cameras.c\nweek 4/02-cameras.c")
    them[8]["stems"][4]["functions"][4:] = [
        function(
            "sphere_roots", "Intersecting a ray and a sphere", "Where?", "waiting", waiting_for=["quadratic_roots"]
        ),
        function("hit_sphere", "Ray casting process", "Find the closest.", "crashed",
                 test="a_tangent_ray_hits", how="crashed (segmentation fault)"),
    ]
    them[9].update(submission="группа 10, 第十組, a name much longer than any column has room for")
    for one in them:
        one["score"] = sum(each["score"] for each in one["stems"]) - (20 if one["late"] else 0)
    return them


def write_sample(out: str) -> None:
    them = ordinary_class()
    for place, one in enumerate(them):
        folder = pathlib.Path(out, one["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        if one["pictures"]:
            (folder / "expected.png").write_bytes(ball(0.8))
            (folder / "yours.png").write_bytes(ball(0.8 if place % 3 else 0.4))
        write_submission(one, str(folder))
    write_class(them, out)


if __name__ == "__main__":
    write_sample(sys.argv[1])
    sys.stdout.write(closing(ordinary_class()))
