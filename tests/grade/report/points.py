"""points.py - records as reports read them: nothing in them acts, and what has a result is a flat list.

One point per function of a stem that was judged; one for a stem that was not; one for a submission
without stems, or that was not read to its end. So every report counts the same things, and nothing
that a student wrote adds one.
"""
from grade.collect.answers import PARTLY
from grade.visible import visible
from .comment import function_lines, stem_lines, stem_says, sentence, waiting_words

FAILED = "grader failed"
NOTHING = "nothing handed in"     # the status of somebody on the list of the class who did not
UNSAFE = "UNSAFE: graded without a sandbox (UNSAFE=1). These marks may be forged."

# Each state as one of the four outcomes that test readers know. A file that was not handed in is skipped,
# since a class need not be past chapter 02; where nothing at all was, that is a failure.
# A waiting function passes if the policy gives it its marks.
OUTCOMES = {"right": "passed", "wrong": "failure", "unanswered": "failure", "missing": "skipped", "empty": "failure"}


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


def point(stem: str, number: str, part: dict, message: str, lines: list, name: str = "") -> dict:
    """part: what has a state and marks. name: a function's."""
    what = name or part["state"]
    return {"stem": stem, "name": f"{stem}: {what}" if stem else what, "number": number, "state": part["state"],
            "message": message, "lines": lines, "score": part["score"], "max": part["max"]}


def points(record: dict) -> list:
    """Dicts: stem, name, number, state, outcome, message, lines, score, max. Names are unique."""
    found = []
    for place, stem in enumerate(record["stems"], 1):
        if stem["state"] == "missing" and not stem["max"]:
            continue  # it was not asked for
        name = stem["stem"]
        number = str(int(name[:2])) if name[:2].isdecimal() else f"x{place}"
        if stem["state"] != "judged":
            found.append(point(name, number, stem, stem_says(stem), stem_lines(stem)))
            continue
        found += [point(name, f"{number}.{index}", function, message(function), function_lines(name, function),
                        function["name"])
                  for index, function in enumerate(stem["functions"], 1)]
    if not found or record["status"] == PARTLY:
        marks = {"score": 0, "max": 0} if found else record
        whole = {"state": record["status"], "score": marks["score"], "max": marks["max"]}
        found.insert(0, point("", "0", whole, record["words"] or record["status"], []))
    for one in found:
        one["outcome"] = outcome(one)
        if record["status"] == "empty" and one["state"] == "missing":
            one["outcome"] = "failure"
    return found


def reason(record: dict) -> str:
    """Why a mark is what it is, in one cell."""
    return "; ".join(filter(None, (record["unlisted"], record["words"], record["late"], *record["decided"])))


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
