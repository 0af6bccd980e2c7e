"""sample_records.py - an ordinary class for the tests of the reports, and to look at them.

Drawn from the real exercises and the real mistakes, always the same way. To look at them:
PYTHONPATH=tests python3 -B -m grade.check.sample_records build/sample
"""
import functools
import pathlib
import random
import re
import sys

from grade.exercises import read
from grade.report.files import write_class, write_submission
from grade.report.text import closing
from .make_records import ball, function, record, stem

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
    for path in sorted(TESTS.glob("[0-9]*/mistakes*.c")):
        for each in re.finditer(
            rf"MISTAKE\({string},\s*(\w+),\s*\w+,\s*{string},\s*{string},\s*{string}\)",
            path.read_text(encoding="utf-8"),
        ):
            name, function, *words = each.groups()
            name, formula, why, picture = [
                "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', part)) for part in [name] + words
            ]
            found.setdefault(function, []).append(
                {"id": name, "formula": formula, "why": why, "picture": picture}
            )
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
                [
                    "camera",
                    "eye (2, 2, -4), right (1, 0, 0), up (0, 1, 0), forward (0, 0, 1), "
                    "d~4, w~2, h~2",
                ],
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
                    functions.append(
                        function(
                            *each,
                            state="timed out",
                            test="a_ray_that_misses",
                            how="was still running after 1 s (an endless loop?)",
                        )
                    )
                else:
                    functions.append(wrong(*each, chance))
            stems.append(stem(name, functions))
        them.append(
            record(
                f"group {place + 1:02}",
                stems,
                pictures={"expected": "expected.png", "yours": "yours.png"},
            )
        )
    if size < 12:
        return them
    all_stems = list(exercises().items())
    them[2]["late"] = "2 days late: 10 of 100 marks less for each"
    them[2]["score"] -= 20
    missing = [stem(name, state="missing", most=4.0 * len(asked)) for name, asked in all_stems]
    them[3].update(record("group 04 (empty).zip", missing, "empty", words="no NN-stem.c in it"))
    them[6]["stems"][4] = stem("05-quadratic", state="does not compile", most=24.0, words=COMPILER)
    them[6].update(status="does not compile", words="05-quadratic.c does not compile")
    them[7]["stems"][1] = stem(
        "02-cameras", state="twice", most=20.0, words="week 3/02-cameras.c\nweek 4/02-cameras.c"
    )
    them[8]["stems"][4]["functions"][4:] = [
        function(
            "sphere_roots",
            "Intersecting a ray and a sphere",
            "Where?",
            "waiting",
            waiting_for=["quadratic_roots"],
        ),
        function(
            "hit_sphere",
            "Ray casting process",
            "Find the closest.",
            "crashed",
            test="a_tangent_ray_hits",
            how="crashed (segmentation fault)",
        ),
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
