"""term.py - make term: the weeks of a term beside each other, from the folders (OUT) that they were marked in.

    term.py, and in the environment: WEEKS, the folder that these lie in

Writes WEEKS/term.html: who handed in, which mistakes come back, who has which function right, everybody's marks; and
WEEKS/term.csv, everybody's marks. Somebody is the same person in all weeks if the list of the class says so; without a
list, if the submissions have one name. Nothing is marked here.

WEEKS/weights.csv, if it is there, says what a week counts (week,weight; 1 where it says nothing; a line 'best,8': only
the best 8 count). Without it each point counts the same.
"""
from __future__ import annotations

import os
import re
import statistics
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from grade.people.history import members
from grade.people.sheets import Sheet, SheetError
from grade.policy import PolicyError, number_in, rounded
from grade.report.figures import by_exercise, handed_in, made_by, percent, scored
from grade.report.files import put, read_record
from grade.report.formats import mark, table as csv_table
from grade.report.html import page, scrolled, table, tag
from grade.report.points import NOTHING, clean_class
from grade.settings import stop
from grade.visible import brief, number, visible, why

MOST_MISTAKES = 20
FIELDS = ("id", "login", "mail", "section")


@dataclass(frozen=True)
class Week:
    name: str
    records: list

    def count_of(self, stem: str) -> int:
        """How many handed in something, if the chapter was judged in this week."""
        return len(handed_in(self.records)) if any(one["stem"] == stem for record in self.records
                                                   for one in record["stems"]) else 0


def in_order(name: str) -> list:
    """So that week-10 comes after week-9."""
    return [(int(part), "") if part.isdecimal() else (-1, part) for part in re.split(r"(\d+)", name)]


def read_week(out: Path) -> Week:
    """Of who handed in nothing there is only the line in the list of the class."""
    records = []
    for folder, member in members(out).items():
        if member["status"] == NOTHING:
            records.append({**member, "folder": folder, "stems": [], "person": member["person"] or {}})
        else:
            records.append(read_record(str(out / folder / "results.json")))
    return Week(out.name, clean_class(records))


def weeks_of(term: Path) -> list[Week]:
    return [read_week(out) for out in sorted(term.iterdir(), key=lambda out: in_order(out.name)) if members(out)]


def weights_of(term: Path, weeks: list[Week]) -> dict | None:
    """Week, and perhaps 'best' -> number; None if each point counts the same. SheetError."""
    if not (term / "weights.csv").exists():
        return None
    sheet = Sheet(term / "weights.csv")
    columns, known, weights = [sheet.column("week"), sheet.column("weight")], [*(week.name for week in weeks), "best"], {}
    if None in columns:
        raise SheetError(f"{sheet.path}:1: not the first line, expected 'week,weight'")
    for row in sheet.rows[1:]:
        name, weight = (sheet.cell(row, column) for column in columns)
        try:
            if name not in known or name in weights:
                raise PolicyError(f"{brief(name)} is {'given twice' if name in weights else 'no week'}, "
                                  f"expected {', '.join(known)}, each once")
            weights[name] = number_in(weight, 0, 1000)
        except PolicyError as error:
            raise SheetError(f"{sheet.path}:{row.line}: {error}") from None
    return weights


def share_of(there: list, weeks: list[Week], weights: dict | None) -> Fraction | None:
    """What somebody has of what could be had, of the weeks that have a score."""
    counted = [(Fraction(str(record["score"])), Fraction(str(record["max"])), week.name)
               for record, week in zip(there, weeks) if record and record["score"] is not None and record["max"]]
    if weights is None:
        parts = [(score, most) for score, most, _ in counted]
    else:
        parts = [(weight * score / most, weight) for score, most, name in counted for weight in [weights.get(name, Fraction(1))]]
        parts = sorted((part for part in parts if part[1]), key=lambda part: -part[0] / part[1])[:int(weights.get("best", len(parts)))]
    most = sum(most for _, most in parts)
    return Fraction(sum(score for score, _ in parts)) / most if most else None


def key_of(record: dict) -> str:
    person = record["person"]
    return next(filter(None, map(person.get, ("id", "login", "mail", "name"))), record["submission"])


def marks_of(weeks: list[Week]) -> list[tuple[dict, list, Fraction, Fraction]]:
    """Of each person: who that is, the record of each week (None: not in that class), and the sums of marks and of what could
    be had, without weeks that have no score."""
    people: dict[str, dict[str, dict]] = {}
    for week in weeks:
        for record in week.records:
            people.setdefault(key_of(record), {})[week.name] = record
    rows = []
    for there in people.values():
        last = list(there.values())[-1]
        counted = [record for record in there.values() if record["score"] is not None]
        sums = [sum((Fraction(str(record[part])) for record in counted), Fraction(0)) for part in ("score", "max")]
        rows.append(({**last["person"], "name": last["submission"]}, [there.get(week.name) for week in weeks], *sums))
    return sorted(rows, key=lambda row: row[0]["name"])


def still_open(there: list) -> int:
    """Weeks without a score that nobody has decided on: what was handed in could not be read, say."""
    return sum(record is not None and record["score"] is None and not record["decided"] for record in there)


def percent_text(there: list, weeks: list[Week], weights: dict | None) -> str:
    share = share_of(there, weeks, weights)
    return "" if share is None else number(rounded(100 * share))


def term_csv(weeks: list[Week], weights: dict | None = None) -> str:
    rows = marks_of(weeks)
    known = [field for field in FIELDS if any(person.get(field) for person, *_ in rows)]
    return csv_table([["name", *known, *(week.name for week in weeks), "sum", "of", "percent", "open"]] + [
        [person["name"], *(person.get(field, "") for field in known), *(mark(record and record["score"]) for record in there),
         mark(rounded(total)), mark(rounded(most)), percent_text(there, weeks, weights), str(still_open(there))] for person, there, total, most in rows])


# ---- the page -----------------------------------------------------------------------------------


def part(title: str, heads: list, rows: list):
    return tag("section", tag("h2", title), scrolled(title, table(heads, rows)))


def week_by_week(weeks: list[Week]):
    rows = []
    for week in weeks:
        percents = [percent(record) for record in scored(week.records)]
        rows.append([week.name, str(len(handed_in(week.records))), str(len(week.records) - len(handed_in(week.records))),
                     number(round(statistics.median(percents))) if percents else "-"])
    return part("Week by week", ["week", "handed in", "nothing", "median, %"], rows)


def mistakes(weeks: list[Week]):
    """Those that most people made, of all weeks together; how many of how many in each."""
    found = [made_by(week.records) for week in weeks]
    all_of_them = {key: made for week in reversed(found) for key, made in week.items()}
    order = sorted(all_of_them, key=lambda key: (-sum(len(week[key]["who"]) for week in found if key in week), key))
    rows = []
    for key in order[:MOST_MISTAKES]:
        made = all_of_them[key]
        cells = [f"{len(there[key]['who']) if key in there else 0} of {week.count_of(made['stem'])}"
                 if week.count_of(made["stem"]) else "" for week, there in zip(weeks, found)]
        rows.append([tag("td", f"{made['stem']} ", tag("code", made["function"]), tag("div", made["sentence"], class_="quiet")),
                     *cells])
    return part("Mistakes over the weeks", ["mistake", *(week.name for week in weeks)], rows) if rows else None


def exercises(weeks: list[Week]):
    found = [{(stem, name): groups[0] for stem, name, groups in by_exercise(week.records)} for week in weeks]
    rows = [[tag("td", f"{stem} ", tag("code", name)),
             *["{} of {}".format(*week[stem, name]) if (stem, name) in week else "" for week in found]]
            for stem, name in sorted(dict.fromkeys(key for week in found for key in week), key=lambda key: key[0])]
    return part("Who has it right", ["exercise", *(week.name for week in weeks)], rows) if rows else None


def everybody(weeks: list[Week], weights: dict | None):
    """What a week counts is in its heading."""
    heads = [f"{week.name} (x {number(float(weights.get(week.name, 1)))})" if weights else week.name for week in weeks]
    rows = [[tag("td", tag("bdi", person["name"]), tag("div", person.get("section", ""), class_="quiet")),
             *["" if record is None else number(record["score"]) for record in there],
             f"{number(rounded(total))} of {number(rounded(most))}" + (f", {still_open(there)} open" if still_open(there) else ""),
             percent_text(there, weeks, weights)]
            for person, there, total, most in marks_of(weeks)]
    best = f", of the best {number(float(weights['best']))}" if weights and "best" in weights else ""
    return part("Everybody", ["name", *heads, "sum", "%" + best], rows)


def term_page(weeks: list[Week], weights: dict | None = None) -> str:
    return page("The term", tag("header", tag("h1", "The term"), tag("p", tag("a", "term.csv", href="./term.csv"))),
                tag("main", week_by_week(weeks), mistakes(weeks), exercises(weeks), everybody(weeks, weights)))


def main() -> None:
    term = Path(os.environ.get("WEEKS") or "marks")
    try:
        weeks = weeks_of(term) if term.is_dir() else []
        if not weeks:
            stop(f"WEEKS={term}: expected a folder that the OUT of each week lies in, such as {term}/week-1")
        weights = weights_of(term, weeks)
        put(str(term), "term.csv", term_csv(weeks, weights))
        put(str(term), "term.html", term_page(weeks, weights))
    except SheetError as error:
        stop(str(error))
    except (OSError, ValueError) as error:
        stop(f"{visible(str(getattr(error, 'filename', None) or term))}: {why(error)}")
    print(f"{len(weeks)} week{'s' * (len(weeks) != 1)}: {', '.join(visible(week.name) for week in weeks)}. {term}/term.html")


if __name__ == "__main__":
    main()
