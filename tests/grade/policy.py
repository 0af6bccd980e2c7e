"""policy.py - reads the policy: what each answer is worth, and what a late one loses.

Points and marks are counted in hundredths, as whole numbers, so that they add up and come out
the same everywhere. The file 'policy' beside this one says what can be set.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from decimal import ROUND_HALF_UP, Decimal
from fractions import Fraction
from pathlib import Path
from typing import Optional

from grade import exercises as table
from grade.people.sheets import Sheet, SheetError
from grade.visible import brief, number, why

DEFAULT = Path(__file__).resolve().parent / "policy"
NUMBER = re.compile(r"\d{1,5}(\.\d{1,2})?", re.ASCII)
TIME = re.compile(r"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d)?(Z|[+-]\d\d:\d\d)?", re.ASCII)
LATE = re.compile(r"(\S+)% per (day|hour), at most (\S+)%")
A_TIME = "a time such as 2025-11-14T23:59+01:00"
OWN_TABLE = ("submission", "time")
WORKSHEET = ("Identifier", "Last modified (submission)")    # Moodle's, in English
MOODLE_S = ("%A, %d %B %Y, %I:%M %p", "%A, %B %d, %Y, %I:%M %p", "%A, %d %B %Y, %H:%M")
SECONDS = {"day": 86400, "hour": 3600}


class PolicyError(SheetError):
    """FILE:LINE: what is wrong, expected what."""


@dataclass
class Policy:
    shares: dict = field(default_factory=dict)  # (stem, function) -> hundredths of a point
    due: Optional[datetime] = None
    grace: int = 0                              # seconds
    percent: Fraction = Fraction(0)             # lost for each unit begun
    unit: str = "day"
    most: Fraction = Fraction(0)
    times: Optional[dict] = None                # submission, or Moodle's participant -> seconds since 1970
    waiting: bool = True                        # whether a function that waits has its marks
    judges_all: bool = False                    # also chapters that are worth nothing


def rounded(marks) -> float:
    """To 0.01; the only place where marks are rounded."""
    if isinstance(marks, Fraction):
        marks = Decimal(marks.numerator) / Decimal(marks.denominator)
    return float(Decimal(str(marks)).quantize(Decimal("0.01"), ROUND_HALF_UP))


# ---- reading ----------------------------------------------------------------------------------

def number_in(text: str, least, most) -> Fraction:
    if not NUMBER.fullmatch(text) or not least <= Fraction(text) <= most:
        raise PolicyError(f"{brief(text)}, expected a number from {least} to {most} "
                          "with at most two decimals")
    return Fraction(text)


def time_in(text: str) -> datetime:
    try:
        if not TIME.fullmatch(text):
            raise ValueError
        when = datetime.fromisoformat(text.replace("Z", "+00:00"))
        return when if when.tzinfo else when.astimezone()
    except (ValueError, OverflowError, OSError):
        raise PolicyError(f"{brief(text) or 'nothing'} is not a time, expected {A_TIME}") \
            from None


def moodle_s(text: str) -> Optional[datetime]:
    """Friday, 14 November 2025, 11:59 PM; of the time zone of this machine."""
    for form in MOODLE_S:
        try:
            return datetime.strptime(text, form).astimezone()
        except ValueError:
            pass
    return None


def times_in(path: Path) -> dict:
    """When each submission came in, as a table says: one's own, or Moodle's grading worksheet."""
    times: dict = {}
    sheet = Sheet(path)
    pair = next((pair for pair in (OWN_TABLE, WORKSHEET) if None not in map(sheet.column, pair)), None)
    if pair is None:
        raise SheetError(f"{path}:1: not the first line, expected 'submission,time', or Moodle's grading worksheet")
    for row in sheet.rows[1:]:
        who, when = (sheet.cell(row, sheet.column(name)) for name in pair)
        if pair == WORKSHEET and when in ("", "-"):
            continue    # nothing handed in
        try:
            if who in times:
                raise PolicyError(f"{brief(who)} is here twice, expected once")
            times[who] = int((moodle_s(when) or time_in(when)).timestamp())
        except PolicyError as error:
            raise PolicyError(f"{path}:{row.line}: {error}") from None
    return times


def points_line(words: list, known: list, weights: dict) -> None:
    """points STEM [FUNCTION] NUMBER"""
    stems = table.stems(known)
    if len(words) not in (2, 3):
        raise PolicyError("expected 'points CHAPTER NUMBER' or 'points CHAPTER FUNCTION NUMBER'")
    stem, function = words[0], words[1] if len(words) == 3 else ""
    if stem not in [*stems, "others"] or (stem == "others" and function):
        raise PolicyError(f"no chapter is called {brief(stem)}, "
                          f"expected {', '.join(stems)}, or 'others' and a number")
    functions = [exercise.name for exercise in known if exercise.stem == stem]
    if function and function not in functions:
        raise PolicyError(f"{stem} has no function {brief(function)}, "
                          f"expected {', '.join(functions)}")
    if (stem, function) in weights:
        raise PolicyError(f"points of {' '.join(words[:-1])} are given twice, expected once")
    weights[stem, function] = int(number_in(words[-1], 0, 1000) * 100)


def line_into(policy: Policy, words: list, known: list, weights: dict, folder: Path) -> None:
    setting, rest = words[0], " ".join(words[1:])
    if setting == "points":
        points_line(words[1:], known, weights)
    elif setting == "due":
        policy.due = None if rest == "none" else time_in(rest)
    elif setting == "grace":
        policy.grace = int(number_in(rest, 0, 10080) * 60)
    elif setting == "late":
        match = LATE.fullmatch(rest)
        if rest != "none":
            if not match:
                raise PolicyError(f"late {brief(rest)}: expected 'late none' or "
                                  "'late 10% per day, at most 50%' (or per hour)")
            policy.percent = number_in(match[1], 0, 100)
            policy.unit = match[2]
            policy.most = number_in(match[3], 0, 100)
    elif setting == "times":
        if not rest:
            raise PolicyError("times of what, expected 'files' or the name of a CSV file")
        policy.times = None if rest == "files" else times_in(folder / rest)
    elif setting == "waiting":
        if rest not in ("full", "none"):
            raise PolicyError(f"waiting {brief(rest)}: expected 'waiting full' or 'waiting none'")
        policy.waiting = rest == "full"
    elif setting == "judge":
        if rest not in ("points", "all"):
            raise PolicyError(f"judge {brief(rest)}: expected 'judge points' or 'judge all'")
        policy.judges_all = rest == "all"
    else:
        raise PolicyError(f"{brief(setting)} is not a setting, "
                          "expected points, judge, due, grace, late, times or waiting")


def shared(known: list, weights: dict, at: dict) -> dict:
    """The points of each function. A remainder goes to the first ones, 0.01 each.
    at: the line that spoke of a chapter last."""
    shares = {}
    for stem in table.stems(known):
        left = weights.get((stem, ""), weights.get(("others", ""), 1000))
        functions = [exercise.name for exercise in known if exercise.stem == stem]
        equal = [name for name in functions if (stem, name) not in weights]
        own = sum(weights.get((stem, name), 0) for name in functions)
        if own > left or (not equal and own != left):
            raise PolicyError(f"{at[stem]}: functions of {stem} have {number(own / 100)} points, "
                              f"expected {'at most ' if equal else ''}{number(left / 100)}, "
                              "the chapter's")
        left -= own
        for name in functions:
            shares[stem, name] = weights.get((stem, name), 0)
        for i, name in enumerate(equal):
            shares[stem, name] = left // len(equal) + (i < left % len(equal))
    return shares


def load(path, known: list) -> Policy:
    """known: the exercises, from exercises.read()."""
    path = Path(path)
    try:
        lines = path.read_text(encoding="utf-8-sig").split("\n")
    except (OSError, UnicodeError) as error:
        raise PolicyError(f"{path}: cannot be read: {why(error)}, expected a policy") from None
    policy, weights, given, at = Policy(), {}, set(), {}
    for place, line in enumerate(lines, 1):
        words = line.split("#")[0].split()
        try:
            if words and words[0] in given and words[0] != "points":
                raise PolicyError(f"{words[0]} is given twice, expected once")
            if words:
                line_into(policy, words, known, weights, path.parent)
                given.add(words[0])
                at[words[1] if len(words) > 1 else ""] = place
        except SheetError as error:
            # A mistake in another file is reported with the line of that file.
            raise PolicyError(f"{path}:{place}: {error}") from None
    try:
        policy.shares = shared(known, weights, at)
    except PolicyError as error:
        raise PolicyError(f"{path}:{error}") from None
    return policy


# ---- asking -----------------------------------------------------------------------------------

def points(policy: Policy, stem: str, function: str) -> float:
    return policy.shares[stem, function] / 100


def judged(policy: Policy, stems: list) -> list:
    """The chapters that are judged: those that have points, unless none has."""
    paid = [stem for stem in stems if any(share for (chapter, _), share in policy.shares.items() if chapter == stem)]
    return stems if policy.judges_all or not paid else paid


def names_in_times(submission) -> list:
    """What it is called in a file of times."""
    numbers = [claim.number for claim in submission.claims] + [submission.person.number if submission.person else ""]
    return [submission.name, submission.folder, *(f"Participant {number}" for number in numbers if number)]


def came_in(policy: Policy, submission, collected) -> Optional[int]:
    """When, in seconds since 1970; None where nobody knows."""
    if policy.times is None:
        return collected.when
    return next((policy.times[name] for name in names_in_times(submission) if name in policy.times), None)


def duration(seconds: int) -> str:
    days, seconds = divmod(seconds, 86400)
    hours, seconds = divmod(seconds, 3600)
    parts = [(days, "d"), (hours, "h"), (seconds // 60, "min")]
    return " ".join(f"{count} {unit}" for count, unit in parts if count) or f"{seconds} s"


def late(policy: Policy, when: Optional[int], score: float, extra_days: Fraction = Fraction(0)) -> tuple:
    """The rest of a score, and words; no words if the submission was on time."""
    if policy.due is None:
        return rounded(score), ""
    if when is None:
        return rounded(score), "it is not known when this came in; taken as on time"
    due = policy.due + timedelta(seconds=float(extra_days * SECONDS["day"]))
    after = int(when) - int(due.timestamp())
    if after <= policy.grace:
        return rounded(score), ""
    begun = -(-after // SECONDS[policy.unit])
    percent = min(begun * policy.percent, policy.most)
    left = rounded(Fraction(str(score)) * (100 - percent) / 100)
    words = f"due {due:%Y-%m-%d %H:%M %z}, {duration(after)} late: "
    if not percent:
        return left, words + "that costs nothing"
    return left, words + (f"{number(float(percent))}% off, "
                          f"{number(rounded(score))} became {number(left)}")
