"""gradescope.py - results.json of one submission, as Gradescope's autograder reads it.

Same record, same bytes. All tests are visible: one hidden test would hide the student's total. The
whole record lies in extra_data, and class reports are made from it.
"""
import json

from grade.visible import number
from .points import UNSAFE, clean, points


def summary(record: dict) -> str:
    """The text above all tests."""
    score = "no score" if record["score"] is None else f"{number(record['score'])} of {number(record['max'])}"
    lines = [UNSAFE] if record["unsafe"] else []
    lines.append(f"{record['status']}: {score}")
    lines += [line for line in (record["words"], record["late"]) if line]
    if any(stem["functions"] for stem in record["stems"]):
        lines.append("'make exercises' says the same of your files, but for the random inputs of this run.")
    return "\n".join(lines)


def test(point: dict) -> dict:
    output = "\n".join(point["lines"])
    score = {} if point["score"] is None else {"score": point["score"]}
    return {
        **score,
        "max_score": point["max"],
        "status": "passed" if point["outcome"] == "passed" else "failed",
        "name": point["name"],
        "number": point["number"],
        "output": output or ("right" if point["outcome"] == "passed" else point["message"]),
        "output_format": "text",
    }


def results_json(record: dict) -> str:
    record = clean(record)
    # Without a score Gradescope says that the autograder failed, which is so.
    score = {} if record["score"] is None else {"score": record["score"]}
    results = {
        **score,
        "execution_time": record["seconds"],
        "output": summary(record),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": [test(point) for point in points(record)],
        "extra_data": {"record": record},
    }
    # No NaN: it is no JSON, and a mark that is none should stop here and not in a grade book.
    return json.dumps(results, ensure_ascii=True, allow_nan=False, indent=1) + "\n"
