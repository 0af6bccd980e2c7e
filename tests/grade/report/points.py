"""points.py - records as reports read them: nothing in them acts, and what has a result is a flat list.

One point per function of a stem that was judged; one for a stem that was not; one for a submission
without stems. So every report counts the same things, and nothing that a student wrote adds one.
"""
from grade.visible import visible
from .comment import function_lines, stem_lines, stem_says, sentence, waiting_words

UNSAFE = "UNSAFE: graded without a sandbox (UNSAFE=1). These marks may be forged."

# Each state as one of the four outcomes that test readers know. A file that was not handed in is skipped,
# since a class need not be past chapter 02; where nothing at all was, that is a failure.
# A waiting function passes if the policy gives it its marks.
OUTCOMES = {
    "right": "passed",
    "wrong": "failure",
    "unanswered": "failure",
    "missing": "skipped",
    "empty": "failure",
}


def outcome(point: dict) -> str:
    if point["state"] == "waiting":
        return "passed" if point["score"] or not point["max"] else "failure"
    return OUTCOMES.get(point["state"], "error")


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
        if stem["state"] == "missing" and not stem["max"]:
            continue  # it was not asked for
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
        point["outcome"] = outcome(point)
        if record["status"] == "empty" and point["state"] == "missing":
            point["outcome"] = "failure"
    return found


def clean(record: dict) -> dict:
    """A copy in which every string is visible."""

    def copy(value, lines=False):
        if isinstance(value, str):
            return visible(value, lines)
        if isinstance(value, dict):
            # Only a compiler has several lines to say, and says them of a stem.
            return {visible(k): copy(v, k == "words" and "stem" in value) for k, v in value.items()}
        if isinstance(value, (list, tuple)):
            return [copy(one) for one in value]
        return value

    return copy(record)


def clean_class(records: list) -> list:
    """In an order that does not depend on who was marked first. Folders are not words, and stay."""
    cleaned = [{**clean(record), "folder": record["folder"]} for record in records]
    return sorted(cleaned, key=lambda record: (record["submission"], record["folder"]))


def any_unsafe(records: list) -> bool:
    return any(record["unsafe"] for record in records)
