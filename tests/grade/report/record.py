"""record.py - the record of a submission as reports read it: nothing in it acts, and its reason fits into a cell."""
from grade.visible import visible

FAILED = "grader failed"
NOTHING = "nothing handed in"     # the status of somebody on the list of the class who did not
UNSAFE = "UNSAFE: graded without a sandbox (UNSAFE=1). These marks may be forged."


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
