"""records.py - records by hand, for the tests of the reports: an ordinary class, drawn from the real exercises, always
the same way; and one in which every string that quotes a student is an attack.
"""
import functools
import os
import random

from grade.exercises import read


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
            "pictures": {}, "stems": stems, "computed": sum(one["score"] for one in stems), "penalty": 0, "adjusted": 0,
            "decided": [], "person": {}, "unlisted": "", "key": "", "files": "", "when": None, **more}


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
    "\\# \\\\",
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
    trap = {"test": text, "law": text, "expected": text, "yours": text, "given": [[text, text], ["ray", text]]}
    known = {"id": text, "formula": text, "why": text, "picture": text}
    quadratic = [
        function("to_object_coordinates"),
        function("object_quadratic", text, text, "wrong", **trap),
        function("world_quadratic", text, text, "wrong", **trap, mistake=known),
        function("quadratic_roots", text, text, "unanswered", **trap),
        function("sphere_roots", text, text, "waiting", waiting_for=[text, text]),
        function("hit_sphere", text, text, "crashed", **trap, how=text),
    ]
    stems = [
        stem("01-corners", state="missing", most=20.0, words=text),
        stem("02-cameras", state="twice", most=20.0, words=text + "\n" + text),
        stem("03-screen", state="does not compile", most=12.0, words=text, file=text),
        stem("04-pixel-ray", state="not judged", most=4.0, words=text, file=text),
        stem("05-quadratic", quadratic, file=text),
    ]
    return record(text, stems, "crashed", words=text, late=text, folder=f"h{place:02}",
                  pictures={"expected": text, "yours": text})


def hostile_class() -> list:
    return [hostile_record(text, place) for place, text in enumerate(HOSTILE)]


# ---- ordinary -----------------------------------------------------------------------------------


@functools.lru_cache(maxsize=None)
def exercises() -> dict:
    """stem -> list of (function, slide, prompt)."""
    found = {}
    for each in read():
        found.setdefault(each.stem, []).append((each.name, each.slide, each.prompt))
    return found


MISTAKE = {"id": "C1", "formula": "d f + w r + h u", "picture": "everything at half its size",
           "why": "The whole width and height. f reaches the middle of the plane, and each edge is only half as far from "
                  "there."}
GIVEN = [["camera", "eye~(2, 2, -4), right~(1, 0, 0), up~(0, 1, 0), forward~(0, 0, 1), d~4, w~2, h~2"],
         ["ray", "origin (1, 2, 3), direction (0, 0, 1)"]]
COMPILER = """05-quadratic.c:31:12: error: expected ';' before 'return'
   31 |     double a = dot(ray.direction, ray.direction)
      |                                                 ^
      |                                                 ;
  help: a statement ends with a semicolon; this one does not."""


def drawn(asked: tuple, skill: float, chance) -> dict:
    """A function as somebody of this skill answers it."""
    told = {"test": "the_example_of_the_deck_comes_out", "expected": "(-1, 1, 4)", "yours": "(-2, 2, 4)", "given": GIVEN}
    kinds = [{"mistake": MISTAKE}, {"mistake": MISTAKE, "partly": True}, {"law": "your direction has length 2"},
             {"hidden": True, "given": [], "law": "your root is at t = 8.1234, and that is not on the sphere"},
             {"state": "unanswered"}, {"state": "timed out", "how": "was still running after 1 s (an endless loop?)"}]
    if chance.random() < skill:
        return function(*asked)
    return function(*asked, **{"state": "wrong", **told, **chance.choice(kinds)})


def ordinary_class(size=12, seed=4) -> list:
    chance = random.Random(seed)
    them = []
    for place in range(size):
        skill = chance.uniform(0.5, 1.05)
        stems = [stem(name, state="missing", most=4.0 * len(asked)) if chance.random() < 0.03
                 else stem(name, [drawn(each, skill, chance) for each in asked]) for name, asked in exercises().items()]
        them.append(record(f"group {place + 1:02}", stems, pictures={"expected": "expected.png", "yours": "yours.png"}))
    if size < 12:
        return them
    them[2]["late"] = "2 days late: 10 of 100 marks less for each"
    missing = [stem(name, state="missing", most=4.0 * len(asked)) for name, asked in exercises().items()]
    them[3].update(record("group 04 (empty).zip", missing, "empty", words="no NN-stem.c in it"))
    them[6]["stems"][4] = stem("05-quadratic", state="does not compile", most=24.0, words=COMPILER)
    them[6].update(status="does not compile", words="05-quadratic.c does not compile")
    them[7]["stems"][1] = stem("02-cameras", state="twice", most=20.0, words="week 3/02-cameras.c\nweek 4/02-cameras.c")
    them[8]["stems"][4] = stem("05-quadratic", [
        *[function(*each) for each in exercises()["05-quadratic"][:4]],
        function("sphere_roots", "Intersecting a ray and a sphere", "Where?", "waiting", waiting_for=["quadratic_roots"]),
        function("hit_sphere", "Ray casting process", "Find the closest.", "crashed", test="a_tangent_ray_hits",
                 how="crashed (segmentation fault)")])
    them[9].update(submission="группа 10, 第十組, a name much longer than any column has room for")
    for one in them:
        one["score"] = sum(each["score"] for each in one["stems"]) - (20 if one["late"] else 0)
    return them
