"""check_verdicts.py - are the judge's verdicts on generated wrong answers true?

    check_verdicts.py STEM [-v]    -v: every answer with its verdict by the graded tables, and nothing else

Each answer is judged like a student's, by the tables that are graded and by those of the same tests with other random
numbers. What depends on the numbers is luck: a failure is false if an answer passes with all others, a pass if it fails
with others, and the name of a mistake if it has another name with others. Any false verdict is a failure, unless
'reviewed' explains it; and so is a plain slip in a solution that no test notices, and less than 90% of the wrong answers
named or described.
"""
import os
import re
import subprocess
import sys
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

BUILD = os.environ.get("BUILD", "build")
TABLES = [f"{BUILD}/tables{of}" for of in ("", "/seed-1", "/seed-2")]  # the graded ones first
FIELDS = "number exercise source change is_plain passed noticed described in_part name test".split()
CRASHED = ["", "1", "1", "", "", ""]


def verdicts_by(tables, stem):
    """Of all answers. try_mutants ends with an answer that crashes or runs for too long, whose line is begun."""
    found, first = [], "0"
    while True:
        done = subprocess.run([f"{BUILD}/tests/try_mutants", stem, first], env={**os.environ, "JUDGE_TABLES": tables},
                              stdout=subprocess.PIPE, text=True, check=False)
        lines = [line.split("\t") for line in done.stdout.splitlines()]
        found += [SimpleNamespace(**dict(zip(FIELDS, line + CRASHED))) for line in lines]
        if not lines or len(lines[-1]) == len(FIELDS):
            if done.returncode:
                sys.exit(f"try_mutants {stem} {first}: exit status {done.returncode}")
            return found
        first = str(int(lines[-1][0]) + 1)


def what_is_false(first, others):
    passed = sum(bool(each.passed) for each in others)
    if first.passed and passed < len(others):
        return "wrong, but passed"
    if not first.passed and passed == len(others):
        return "right, but failed"
    if first.name and not first.in_part and any(each.name not in ("", first.name) for each in others):
        return "named falsely"
    return None


def shown(what, *verdicts):
    first = verdicts[0]
    words = [("passed" if each.passed else each.name or "failed") + (" in part" if each.in_part else "") for each in verdicts]
    return "; ".join([f"{what}: {first.exercise} ({first.source}): {first.change}", *words] + [f"failed {first.test}"] * bool(first.test))


class Reviews:
    """The lines of 'reviewed': EXERCISE | WHAT | PART OF THE CHANGE | WHY"""

    def __init__(self):
        lines = [line.split(" | ", 3) for line in Path(__file__).with_name("reviewed").read_text("utf-8").splitlines() if line[:1] != "#"]
        self.all, self.used = [tuple(line[:3]) for line in lines if len(line) == 4], set()

    def know(self, what, it):
        found = next((each for each in self.all if each[:2] == (it.exercise, what) and each[2] in it.change), None)
        self.used.add(found)
        return found is not None


def plain_slips(verdicts, reviews, exercises, stem):
    """A helper's slip is tried for each exercise that calls it: one must notice it."""
    what, same, problems, reviewed = "no test fails", defaultdict(list), 0, 0
    for each in verdicts:
        if each.is_plain:
            same[each.change].append(each)
    for slips in same.values():
        if not any(each.noticed for each in slips):
            known = reviews.know(what, slips[0])
            reviewed, problems = reviewed + known, problems + (not known)
            if not known:
                print(f"not ok: {what}: {slips[0].exercise}: {slips[0].change}")
    for stale in reviews.all:
        if stale[1] == what and stale[0] in exercises and stale not in reviews.used:
            print(f"not ok: stale: {stale[0]}: {stale[2]}")
            problems += 1
    print(f"+ plain slips in {stem}: {len(same)}, of which no test notices {reviewed}, reviewed")
    return not problems


def main(stem, option=""):
    if option == "-v":
        print("\n".join(shown("right" if each.passed else "wrong", each) for each in verdicts_by(TABLES[0], stem)))
        return 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        first, *others = pool.map(lambda tables: verdicts_by(tables, stem), TABLES)
    exercises = re.findall(rf'EXERCISE\("{stem}", [^,]*, (\w+),', Path("tests/exercises.def").read_text("utf-8"))
    reviews, amiss, reviewed = Reviews(), set(exercises) - {each.exercise for each in first}, 0
    for verdicts in zip(first, *others):
        what = what_is_false(verdicts[0], verdicts[1:])
        known = what is not None and reviews.know(what, verdicts[0])
        reviewed += known
        if what is not None and not known:
            print(shown(f"not ok: {what}", *verdicts))
            amiss.add(verdicts[0].exercise)
    results = [each not in amiss for each in exercises] + [plain_slips(first, reviews, exercises, stem)]
    failed = [each for each in first if not each.passed]
    named = sum(bool(each.name) for each in failed)
    described = sum(bool(each.described and not each.name) for each in failed)
    if 10 * (named + described) < 9 * len(failed):
        print(f"not ok: {stem}: fewer than 90% are named or described")
        results.append(False)
    print(f"{stem:22} {len(first):5} tried: {len(first) - len(failed):4} passed, {len(failed):4} failed, {named} named, {described} "
          f"described, {100 * (named + described) / max(1, len(failed)):.1f}%, {reviewed} reviewed\n+ {len(first)} generated answers")
    print(f"generated: {sum(results)} passed, {results.count(False)} failed")
    return 0 if all(results) else 1


sys.exit(main(*sys.argv[1:]))
