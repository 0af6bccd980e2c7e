"""ledger.py - what the instructor decides: ledger.csv, one decision a line, edited by hand or by 'make grade-set'.

    who,chapter,what,value,comment,by,when
    anna,,extra days,2,ill,MK,2025-11-14
    anna,03,excused,,transferred from another course,MK,2025-11-14

who is anything that fits one person: an id, a login, an address, a name. chapter is 03 or 03-screen; empty: all of them.

    extra days N    the due time is N days later
    excused         the chapter does not count; without a chapter, nobody has to hand in anything
    mark N          of the chapter, or of all, instead of what was computed
    points N        added (or, if negative, taken), from 0 up to what the chapter, or all, can have
    credit N        added, also beyond that
    comment         for the student to read; nothing changes

It is only read here; it survives whatever is marked again. A line that fits nobody or contradicts another one is an error.
"""
from __future__ import annotations

import fcntl
import re
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Callable

from grade.policy import rounded
from grade.report.files import put
from grade.visible import brief, number
from .sheets import Row, Sheet, SheetError, as_meant

HEADING = ["who", "chapter", "what", "value", "comment", "by", "when"]
KINDS = ("extra days", "excused", "mark", "points", "credit", "comment")
NUMBER = re.compile(r"[+-]?\d{1,5}(\.\d{1,2})?", re.ASCII)


@dataclass(frozen=True)
class Decision:
    line: int
    who: str
    stem: str           # '': all
    what: str
    value: Fraction
    comment: str
    by: str
    when: str

    def words(self) -> str:
        """As the student reads it."""
        about = f"{self.stem}: " if self.stem else ""
        value = f" {number(float(self.value))}" if self.what not in ("excused", "comment") else ""
        sign = "+" if self.what in ("points", "credit") and self.value > 0 else ""
        what = f"{self.what}{value.replace(' ', ' ' + sign)}" if self.what != "comment" else ""
        return about + ": ".join(part for part in (what, self.comment) if part)


@dataclass
class Decided:
    """For one person."""
    all: list = field(default_factory=list)

    def of(self, what: str, stem: str | None = None) -> list:
        return [one for one in self.all if one.what == what and (stem is None or one.stem == stem)]

    @property
    def extra_days(self) -> Fraction:
        return sum((one.value for one in self.of("extra days")), Fraction(0))

    @property
    def excused(self) -> bool:
        return bool(self.of("excused", ""))


def stem_named(text: str, stems: list) -> str | None:
    """01, 1 or 01-corners."""
    return next((stem for stem in stems if text in (stem, stem[:2], stem[:2].lstrip("0"))), None)


def decision_in(sheet: Sheet, row: Row, columns: dict, stems: list) -> Decision:
    cells = {name: as_meant(sheet.cell(row, columns[name])) for name in HEADING}
    where = f"{sheet.path}:{row.line}"
    what, value = cells["what"].casefold().replace("-", " "), re.sub(r"(?<=\d),(?=\d)", ".", cells["value"].replace("\N{MINUS SIGN}", "-"))
    stem = stem_named(cells["chapter"], stems) if cells["chapter"] else ""
    if not cells["who"]:
        raise SheetError(f"{where}: nobody is named, expected an id, a login, an address or a name")
    if stem is None:
        raise SheetError(f"{where}: no chapter is called {brief(cells['chapter'])}, expected {', '.join(stems)}, or nothing")
    if what not in KINDS:
        raise SheetError(f"{where}: {brief(cells['what']) or 'nothing'} is not decided here, expected {', '.join(KINDS)}")
    if what in ("excused", "comment"):
        if value:
            raise SheetError(f"{where}: {what} has the value {brief(value)}, expected none")
        value = "0"
    elif not NUMBER.fullmatch(value) or (value[0] == "-" and what != "points"):
        least = "a number" if what == "points" else "a number from 0"
        raise SheetError(f"{where}: {what} {brief(value) or 'without a value'}, expected {least} with at most two decimals")
    if what == "comment" and not cells["comment"]:
        raise SheetError(f"{where}: a comment without words, expected what the student is to read")
    if what == "extra days" and stem:
        raise SheetError(f"{where}: extra days for {stem} alone, expected no chapter: all are due together")
    return Decision(row.line, cells["who"], stem, what, Fraction(value), cells["comment"], cells["by"], cells["when"])


def contradicts(one: Decision, other: Decision) -> bool:
    """Two decisions on the same person, of which only one can hold."""
    if "comment" in (one.what, other.what) or (one.stem != other.stem and one.stem and other.stem):
        return False
    whole = {one.what for one in (one, other) if not one.stem}
    if one.stem != other.stem:     # one of all, one of a chapter
        return bool(whole & {"mark", "excused"})
    if one.what == other.what:
        return one.what not in ("points", "credit")     # these add up
    return bool({one.what, other.what} & {"mark", "excused"} and
                                          "extra days" not in (one.what, other.what))


class Ledger:
    """decisions: by the key that find gives."""

    def __init__(self, sheet: Sheet | None, stems: list, find: Callable[[str], list], fits: Callable[[str], str]):
        """find: the keys of those whom a word fits; fits: what is said of one that does not fit one person. SheetError with a line,
        then, and if two decisions contradict each other."""
        self.decisions: dict[str, Decided] = {}
        if sheet is None:
            return
        path = sheet.path
        columns = {name: sheet.column(name) for name in HEADING}
        if missing := [name for name in HEADING[:4] if columns[name] is None]:
            raise SheetError(f"{path}:1: no column is called {missing[0]}, expected {','.join(HEADING)}")
        for row in sheet.rows[1:]:
            if not any(cell.strip() for cell in row.cells()):
                continue
            one = decision_in(sheet, row, columns, stems)
            keys = find(one.who)
            if len(keys) != 1:
                raise SheetError(f"{path}:{row.line}: {brief(one.who)} {fits(one.who)}")
            decided = self.decisions.setdefault(keys[0], Decided())
            for other in decided.all:
                if contradicts(one, other):
                    raise SheetError(f"{path}:{row.line}: {one.what} contradicts {other.what} in line {other.line}, expected one "
                                     "of them")
            decided.all.append(one)

    def of(self, key: str) -> Decided:
        return self.decisions.get(key, Decided())


def check_marks(path: Path, ledger: Ledger, most_of: dict[str, Fraction]) -> None:
    """most_of: stem -> its points. SheetError for a mark that is more than there are: a slip of the pen, or a credit."""
    for one in (one for decided in ledger.decisions.values() for one in decided.of("mark")):
        most = most_of[one.stem] if one.stem else sum(most_of.values(), Fraction(0))
        if one.value > most:
            raise SheetError(f"{path}:{one.line}: mark {number(float(one.value))}, expected at most {number(float(most))}, the points of "
                             f"{one.stem or 'all chapters'}; what is beyond is a credit")


def read_ledger(path: Path, stems: list, find: Callable[[str], list], fits: Callable[[str], str]) -> Ledger:
    """An empty one, if there is no such file."""
    return Ledger(Sheet(path) if path.exists() else None, stems, find, fits)


def add_decision(path: Path, cells: list, stems: list, find: Callable[[str], list], fits: Callable[[str], str]) -> int:
    """Adds a line, and gives its number. SheetError, and the file as it was, if the ledger would not hold."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path.with_name(f".{path.name}.lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)    # two assistants at once
        sheet = Sheet(path) if path.exists() else Sheet(path, (",".join(HEADING) + "\n").encode())
        columns = [sheet.column(name) for name in HEADING]
        if None in columns:
            raise SheetError(f"{path}:1: no column is called {HEADING[columns.index(None)]}, expected {','.join(HEADING)}")
        row = [""] * len(sheet.heading())
        for column, text in zip(columns, cells):
            row[column] = text
        sheet.add(row)
        new = Sheet(path, sheet.bytes())
        Ledger(new, stems, find, fits)
        put(str(path.parent), path.name, sheet.bytes())
        return new.rows[-1].line


# ---- what it does to marks -----------------------------------------------------------------------


def between(least: Fraction, value: Fraction, most: Fraction) -> Fraction:
    return max(least, min(value, most))


def exact(marks: float | None) -> Fraction:
    return Fraction(str(marks or 0))


def chapter_after(stem: dict, decided: Decided) -> tuple:
    """What the chapter has in the end, and the most that it can have."""
    name, most, earned = stem["stem"], exact(stem["max"]), exact(stem["score"])
    if decided.of("excused", name):
        return Fraction(0), Fraction(0)
    for one in decided.of("mark", name):
        earned = one.value
    for one in decided.of("points", name):
        earned = between(Fraction(0), earned + one.value, most)
    return earned + sum(one.value for one in decided.of("credit", name)), most


def decide(record: dict, decided: Decided, most_of: dict, lost: Callable[[Fraction], Fraction]) -> None:
    """computed + late + adjusted = score. most_of: stem -> the most points, also of chapters that the record lacks.
    lost: what lateness takes of so many points, in hundredths. A record without a score has one only if a mark is set."""
    chapters = {stem["stem"]: stem for stem in record["stems"]}
    everything = [chapters.get(name, {"stem": name, "score": 0, "max": most}) for name, most in most_of.items()]
    after = [chapter_after(stem, decided) for stem in everything]
    for stem, (earned, worth) in zip(everything, after):
        stem["decided"] = "" if (earned, worth) == (exact(stem["score"]), exact(stem["max"])) else \
            "excused" if decided.of("excused", stem["stem"]) else f"{number(rounded(earned))} of {number(rounded(worth))}"
    computed = sum((exact(stem["score"]) for stem in record["stems"]), Fraction(0))
    late = lost(computed)
    most = sum((most for _, most in after), Fraction(0))
    final = sum((earned for earned, _ in after), Fraction(0))
    final -= lost(final)
    has_mark = record["score"] is not None
    for one in decided.of("mark", ""):
        final, has_mark = one.value, True
    for one in decided.of("points", ""):
        final = between(Fraction(0), final + one.value, max(most, final))
    final += sum(one.value for one in decided.of("credit", ""))
    has_mark = has_mark or any(decided.of("mark", stem["stem"]) for stem in everything)
    record["max"] = rounded(most)
    record["computed"] = rounded(computed) if record["score"] is not None else None
    record["penalty"] = rounded(-late) if record["score"] is not None else None
    record["score"] = None if decided.excused or not has_mark else rounded(final)
    record["adjusted"] = None if record["score"] is None else rounded(final - computed + late)
    record["decided"] = [one.words() for one in decided.all]
