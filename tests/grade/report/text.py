"""text.py - the terminal at the end: the table, the scores, what to explain again.

80 columns. A long class is shortened to who needs a look: those without an ordinary result, and the
lowest scores; everybody is in grades.csv.
"""
from grade.collect.answers import PARTLY, UNREADABLE
from grade.visible import number
from .comment import COLUMNS, fitted, wrapped
from .figures import bins, circumstances, handed_in, how_many, most_made, not_answered, quartiles, scored, stems_of
from .points import FAILED, UNSAFE, any_unsafe, clean_class

LONG_CLASS = 40  # a class up to this size is shown in full
MOST_LATE = 12  # that are named
SHOWN_OF_LONG = 12  # of each kind, else


def who_is_shown(records: list) -> list:
    if len(records) <= LONG_CLASS:
        return records
    odd = [record for record in handed_in(records) if record["status"] != "graded"]
    odd = sorted(odd, key=lambda record: record["score"] is not None)[:SHOWN_OF_LONG]
    rest = [record for record in records if record["status"] == "graded" and record["score"] is not None]
    low = sorted(rest, key=lambda record: record["score"])[:SHOWN_OF_LONG]
    chosen = {id(record) for record in odd + low}
    return [record for record in records if id(record) in chosen]


def stems_that_count(records: list) -> list:
    """Without the chapters that are worth nothing; all, if none is worth anything."""
    counting = {stem["stem"] for record in records for stem in record["stems"] if stem["max"] > 0}
    return [stem for stem in stems_of(records) if not counting or stem in counting]


def table(records: list) -> list:
    stems, shown = stems_that_count(records), who_is_shown(records)
    column = 6 if len(stems) <= 6 else 5
    status = max([6] + [len(record["status"]) for record in shown])
    name = COLUMNS - (1 + status) - 7 - column * len(stems)
    rows = [("submission", "status", "score", [stem[:2] for stem in stems])]
    for record in shown:
        marks = {stem["stem"]: number(stem["score"]) for stem in record["stems"]}
        rows.append((record["submission"], record["status"], number(record["score"]),
                     [marks.get(stem, "") for stem in stems]))
    lines = [f"{fitted(who, name)} {fitted(what, status)}{score:>7}" + "".join(mark.rjust(column) for mark in marks)
             for who, what, score, marks in rows]
    if len(shown) < len(records):
        lines += [f"... and {len(records) - len(shown)} more; above are those without an ordinary result and the "
                  "lowest.", "Everybody is in grades.csv and index.html."]
    return lines


def distribution(records: list) -> list:
    counted = bins(records)
    unit = max(1, max(count for _, count in counted) / 50)
    lines = ["Scores, in percent of what could be had"]
    for ends, count in reversed(counted):
        bar = "#" * max(round(count / unit), 1 if count else 0)
        lines.append(f"  {ends:>6}  {bar + (' ' if bar else '')}{count or ''}".rstrip())
    low, middle, high = quartiles(records)
    most = number(max(record["max"] for record in records))
    if not scored(records):
        return ["Nobody has a score."]
    lines.append(f"  median {number(middle)} of {most}, the middle half from {number(low)} to {number(high)}")
    return lines


def mistakes(records: list) -> list:
    lines = []
    for made in most_made(records):
        lines += [f"  {len(made['who']):>3} of {len(handed_in(records))}  {made['stem']}  {made['function']}"]
        lines += wrapped("", made["sentence"], 6)
    if lines:
        lines = ["Made most: what to explain again next week"] + lines
    blanks = not_answered(records)
    if blanks:
        lines += ["Not answered, or no file"] + wrapped("", ", ".join(blanks), 6)
    return lines


def late(records: list) -> list:
    those = [record["submission"] for record in records if record["late"]]
    if not those:
        return []
    named = ", ".join(fitted(name, 24).rstrip() for name in those[:MOST_LATE])
    named += " and more" if len(those) > MOST_LATE else ""
    return [f"Late, or nobody knows when: {len(those)}"] + wrapped("", named, 6)


def reasons(records: list, reason: str = "words") -> list:
    lines = []
    for record in records:
        lines += wrapped("", f"{record['submission']}: {record[reason]}", 2)
    return lines


def odd_ones(records: list) -> list:
    """Whose work cannot be read, and whose owner is not on the list of the class, or not known; and why."""
    unread = [record for record in records if record["status"] in (UNREADABLE, PARTLY)]
    unlisted = [record for record in records if record["unlisted"]]
    return [[f"{title}: {len(those)}"] + reasons(those, reason) for title, those, reason in (
        ("Cannot be read, or only partly", unread, "words"), ("Of nobody on the list", unlisted, "unlisted")) if those]


def failures(records: list) -> str:
    """Whom the grader failed on, and why; '' if it did not."""
    those = [record for record in clean_class([r for r in records if r])
             if record["status"] == FAILED]
    if not those:
        return ""
    lines = [f"The grader failed on {len(those)} of {len(records)}. "
             "They have no score, and the next run marks them again:"]
    return "\n".join(lines + reasons(those)) + "\n"


def closing(records: list) -> str:
    records = clean_class(records)
    if not records:
        return "No submissions.\n"
    (_, seeds), (_, boxes) = circumstances(records)
    loud = [UNSAFE] if any_unsafe(records) else []
    blocks = [
        loud,
        table(records),
        distribution(records),
        mistakes(records),
        late(records),
        *odd_ones(records),
        failures(records).splitlines(),
        wrapped("", f"{how_many(records)} Seed {seeds}. Sandbox: {boxes}.", 0),
        loud,
    ]
    return "\n\n".join("\n".join(block) for block in blocks if block) + "\n"
