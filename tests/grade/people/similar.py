"""similar.py - make similar: which submissions of a class agree in an unusual way, chapter by chapter.

    similar.py, and in the environment: OUT, where the class has been marked; JPLAG

Taken out first is what everybody was given: the lines of the blanks, of the solutions and of the headers. Of the rest
these are compared. Words: comments, and names of helpers and variables; slips: a mistake that the judge knows by name, or
the same wrong result; each is the more unusual the fewer people have it. Text: how much of one is in the other, by sim_c
(Debian's similarity-tester), or by JPlag, if JPLAG names its jar. The page is OUT/similar.html.
"""
from __future__ import annotations

import csv
import math
import os
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

from grade import exercises
from grade.people.history import members
from grade.report.files import answers_of, put, read_record
from grade.report.html import page, tag
from grade.settings import stop
from grade.visible import visible, why

TOP = Path(__file__).resolve().parents[3]
WORD = re.compile(r"[A-Za-z_]\w{2,}")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
RUN = 12            # tokens that count as the same text
LEAST_PERCENT = 50  # of the same text
MOST_PAIRS = 60
FEW = 0.1           # of the class: what more people have is not unusual
MOST_LINES = 200    # of an answer, that are shown
KNOWN, ODD = "mistake in ", "wrong result of "  # before slips; the tests know the former by name, so it is not so unusual
WEIGHTS = {"// ": 3, ODD: 2}


@dataclass(frozen=True)
class Answer:
    who: str
    stem: str
    text: str           # as it was handed in
    own: str            # without what everybody was given
    words: frozenset    # comments and names that nobody was given, and slips


def plain(line: str) -> str:
    return "".join(line.split())


def given(stems: list) -> tuple:
    """Lines, without blanks, and words that everybody has."""
    paths = [TOP / "solutions" / f"{stem}.c" for stem in stems] + [TOP / "build/blanks" / f"{stem}.c" for stem in stems] + \
        sorted([*(TOP / "common").glob("*.h"), *(TOP / "exercises").glob("*.h")])
    text = "\n".join(path.read_text() for path in paths if path.exists())
    return {plain(line) for line in text.splitlines()}, set(WORD.findall(text)) | set("for while double float int".split())


def comments(text: str) -> list:
    """Each in lower case, without what marks it; those of three words and more."""
    found = (" ".join(re.sub(r"^[/*\s]+|[*/\s]+$|\n\s*\*", " ", comment).lower().split()) for comment in COMMENT.findall(text))
    return [comment for comment in found if comment.count(" ") >= 2]


def slips(functions: list) -> set:
    """What went wrong in a function, as far as two can have it in common: not a blank, a crash or a loop."""
    return {f"{KNOWN}{one['name']}: {one['mistake']['formula']}" if one["mistake"] else f"{ODD}{one['name']}: {one['yours']}"
            for one in functions if one["state"] == "wrong" and (one["mistake"] or one["yours"])}


def answer_of(who: str, stem: str, text: str, lines: set, words: set, functions: list = ()) -> Answer:
    own = "\n".join(line for line in text.splitlines() if plain(line) not in lines)
    names = set(WORD.findall(COMMENT.sub(" ", own))) - words
    return Answer(who, stem, text, own, frozenset({f"// {comment}" for comment in comments(own)} | names | slips(functions)))


def by_sim(folder: str, names: list) -> list:
    done = subprocess.run(["sim_c", "-p", "-s", "-r", str(RUN), "-t", str(LEAST_PERCENT), *names], cwd=folder,
                          capture_output=True, text=True, errors="replace")
    return re.findall(r"^(\d+)\.c consists for (\d+) % of (\d+)\.c material", done.stdout, re.MULTILINE)


def by_jplag(folder: str, jar: str) -> list:
    """As its options are since version 5; each file is a submission."""
    done = subprocess.run(["java", "-jar", os.path.abspath(jar), "--mode", "RUN", "--language", "c", "--min-tokens", str(RUN),
                           "--csv-export", "--result-file", "result", "."], cwd=folder, capture_output=True, text=True, errors="replace")
    table = next(Path(folder).rglob("results.csv"), None)
    if table is None:
        stop(f"JPLAG={jar} wrote no results.csv: {visible((done.stderr or done.stdout)[-300:])}")
    rows = csv.reader(table.read_text(encoding="utf-8").splitlines()[1:])
    return [(one.removesuffix(".c"), round(100 * float(most)), other.removesuffix(".c"))
            for one, other, _, most in rows if 100 * float(most) >= LEAST_PERCENT]


def percents(answers: list) -> dict:
    """Two numbers of answers -> how many percent of the smaller one are in the other, if many."""
    jar = os.environ.get("JPLAG")
    found: dict = {}
    with tempfile.TemporaryDirectory() as folder:
        for number, answer in enumerate(answers):
            Path(folder, f"{number}.c").write_text(answer.own + "\n")
        lines = by_jplag(folder, jar) if jar else by_sim(folder, [f"{number}.c" for number in range(len(answers))])
    for one, percent, other in lines:
        pair = tuple(sorted((int(one), int(other))))
        found[pair] = max(found.get(pair, 0), int(percent))
    return found


@dataclass(frozen=True)
class Pair:
    one: Answer
    other: Answer
    shared: list        # the most unusual first
    weight: float       # how unusual that is
    percent: int        # of the same text


def pairs_of(answers: list) -> list:
    """Of one chapter."""
    having = defaultdict(list)
    for number, answer in enumerate(answers):
        for word in answer.words:
            having[word].append(number)
    most = max(2, int(FEW * len(answers)))
    shared = defaultdict(list)
    for word, numbers in having.items():
        if 2 <= len(numbers) <= most:
            weight = math.log(len(answers) / len(numbers) + 1) * next((WEIGHTS[kind] for kind in WEIGHTS if word.startswith(kind)), 1)
            for pair in combinations(numbers, 2):
                shared[pair].append((weight, word))
    same = percents(answers)
    return [Pair(answers[one], answers[other], [word for _, word in sorted(shared[one, other], reverse=True)],
                 sum(weight for weight, _ in shared[one, other]), same.get((one, other), 0))
            for one, other in shared.keys() | same.keys()]


def functions_of(place: Path) -> dict:
    """STEM -> the verdicts on its functions."""
    try:
        return {stem["stem"]: stem["functions"] for stem in read_record(str(place / "results.json"))["stems"]}
    except (OSError, ValueError):
        return {}


def answers_in(out: Path, stems: list) -> dict:
    """STEM -> answers, as they were marked."""
    lines, words = given(stems)
    answers = defaultdict(list)
    for folder, one in sorted(members(out).items()):
        functions = functions_of(out / folder)
        for stem, text in answers_of(out, folder).items():
            made = answer_of(one["submission"], stem, text, lines, words, functions.get(stem, []))
            if made.own.strip():
                answers[stem].append(made)
    return answers


# ---- the page -----------------------------------------------------------------------------------

CAUTION = ("A number here proves nothing. In a function of three lines the same formula means nothing: there is hardly "
           "another way to write it, and the deck and the hints give the same names to all. Two who learn together write alike. "
           "An unusual comment, helper or slip that two share is a reason to ask both, separately, to explain their code; "
           "only what they say then counts. Whoever copies well is not found here.")


def side(answer: Answer):
    lines = answer.text.splitlines()
    text = "\n".join(lines[:MOST_LINES] + ["..."] * (len(lines) > MOST_LINES))
    return tag("figure", tag("figcaption", tag("bdi", visible(answer.who))), tag("pre", visible(text, lines=True)))


def section(pair: Pair):
    words = [tag("code", visible(word)[:200]) for word in pair.shared[:12]]
    listed = [part for word in words for part in (" ", word)]
    return tag("section",
               tag("h2", tag("span", f"{pair.one.stem}: ", tag("bdi", visible(pair.one.who)), " and ",
                             tag("bdi", visible(pair.other.who))),
                   tag("span", f"{pair.percent} % of the same text" if pair.percent else "", class_="marks"), class_="head"),
               tag("p", f"Only few have {len(pair.shared)} of their comments, names and slips:", *listed) if words else None,
               tag("details", tag("summary", "both"), tag("div", side(pair.one), side(pair.other), class_="pair")))


def counted(pairs: int) -> str:
    return f"{pairs} pair{'' if pairs == 1 else 's'}"


def report(pairs: list, many: int) -> str:
    pairs = sorted(pairs, key=lambda pair: (-pair.weight, -pair.percent, pair.one.who, pair.other.who))
    shown = pairs[:MOST_PAIRS]
    more = f", of which these {len(shown)} are the most unusual" if len(shown) < len(pairs) else ""
    title = "Who worked together"
    head = tag("header", tag("h1", title), tag("p", f"{many} answers, {counted(len(pairs))}{more}."), tag("p", CAUTION))
    return page(title, head, tag("main", *map(section, shown)))


def main() -> None:
    out = Path(os.environ.get("OUT") or "build/grades")
    if not members(out):
        stop(f"OUT={out} holds no marks: run 'make grade' first, with the same OUT")
    try:
        answers = answers_in(out, exercises.stems(exercises.read()))
        pairs = []
        for stem, them in sorted(answers.items()):
            print(f"  {stem}: {len(them)} answers", file=sys.stderr, flush=True)
            pairs += pairs_of(them)
        put(str(out), "similar.html", report(pairs, sum(map(len, answers.values()))))
    except FileNotFoundError as error:
        stop("sim_c is missing: 'make setup FOR=instructor' installs it" if error.filename == "sim_c"
             else "java is missing, which JPlag needs" if error.filename == "java" else f"{error.filename}: {why(error)}")
    except OSError as error:
        stop(f"{error.filename}: {why(error)}")
    print(f"{counted(len(pairs))} with something unusual in common: {out}/similar.html")


if __name__ == "__main__":
    main()
