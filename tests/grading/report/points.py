"""points.py - a record as a flat list: what has a result of its own in a report.

One point per function of a stem that was judged; one for a stem that was not; one for a submission
without stems. So every report counts the same things, and nothing that a student wrote adds one.
"""
from .comment import function_lines, stem_lines, stem_says, sentence, waiting_words

UNSAFE = "UNSAFE: graded without a sandbox (UNSAFE=1). These marks may be forged."

# What each state is to a reader that knows four outcomes. A file that was not handed in is skipped,
# since a class need not be past chapter 02; where nothing at all was, that is a failure.
OUTCOMES = {
    "right": "passed",
    "waiting": "passed",
    "wrong": "failure",
    "unanswered": "failure",
    "missing": "skipped",
    "empty": "failure",
}


def message(function: dict) -> str:
    """A point in one line."""
    if function["state"] == "waiting":
        return waiting_words(function)
    if function["state"] == "unanswered":
        return "not answered yet"
    return sentence(function) or function["how"] or function["state"]


def points(record: dict) -> list:
    """Dicts: stem, name, number, state, outcome, message, lines, score, max. Names are unique."""
    found = []
    for place, stem in enumerate(record["stems"], 1):
        number = str(int(stem["stem"][:2])) if stem["stem"][:2].isdecimal() else f"x{place}"
        if stem["state"] != "judged":
            found.append(
                {
                    "stem": stem["stem"],
                    "name": f"{stem['stem']}: {stem['state']}",
                    "number": number,
                    "state": stem["state"],
                    "message": stem_says(stem),
                    "lines": stem_lines(stem),
                    "score": stem["score"],
                    "max": stem["max"],
                }
            )
            continue
        for index, function in enumerate(stem["functions"], 1):
            found.append(
                {
                    "stem": stem["stem"],
                    "name": f"{stem['stem']}: {function['name']}",
                    "number": f"{number}.{index}",
                    "state": function["state"],
                    "message": message(function),
                    "lines": function_lines(stem["stem"], function),
                    "score": function["score"],
                    "max": function["max"],
                }
            )
    if not found:
        found.append(
            {
                "stem": "",
                "name": record["status"],
                "number": "0",
                "state": record["status"],
                "message": record["words"] or record["status"],
                "lines": [],
                "score": record["score"],
                "max": record["max"],
            }
        )
    for point in found:
        point["outcome"] = OUTCOMES.get(point["state"], "error")
        if record["status"] == "empty" and point["state"] == "missing":
            point["outcome"] = "failure"
    return found


def in_order(records: list) -> list:
    """Reports do not depend on who was marked first."""
    return sorted(records, key=lambda record: (record["submission"], record["folder"]))
