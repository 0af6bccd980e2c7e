"""files.py - writes every report that is a file, each whole or not at all.

A file is written beside its place and then renamed, so a reader, or a grader that was killed, finds
the older one or the new one and nothing between. results.json comes last: where it is, all is.
"""
import contextlib
import json
import os
import secrets
import time

from .formats import grades_csv, junit_xml, results_json
from .html import class_page, submission_page

STALE = 3600  # seconds; what is older was left by a grader that was killed


def clear(folder: str) -> None:
    """Away with what a killed grader left of files."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:   # another grader may be there first
        for entry in entries:
            if (entry.name.startswith(".") and entry.name.endswith(".new")
                    and time.time() - entry.stat(follow_symlinks=False).st_mtime > STALE):
                os.unlink(entry.path)


def put(folder: str, name: str, content) -> None:
    data = content if isinstance(content, bytes) else content.encode("utf-8")
    new = os.path.join(folder, f".{name}.{secrets.token_hex(6)}.new")
    try:
        with open(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666), "wb") as file:
            file.write(data)
        os.replace(new, os.path.join(folder, name))
    except BaseException:
        if os.path.lexists(new):
            os.unlink(new)
        raise


def write_submission(record: dict, folder_path: str) -> None:
    """index.html and results.json, in the folder that already holds the record's pictures."""
    os.makedirs(folder_path, exist_ok=True)
    clear(folder_path)
    page, results = submission_page(record, folder_path), results_json(record)
    put(folder_path, "index.html", page)
    put(folder_path, "results.json", results)


ANSWERS = ".answers"     # what was marked, for who wants to compare


def keep_answers(texts: dict, out_path: str, folder: str) -> None:
    """texts: STEM -> what is compiled."""
    os.makedirs(os.path.join(out_path, ANSWERS), exist_ok=True)
    words = {stem: text.decode("utf-8", "replace") for stem, text in texts.items()}
    put(os.path.join(out_path, ANSWERS), f"{folder}.json", json.dumps(words))


def answers_of(out_path: str, folder: str) -> dict:
    try:
        with open(os.path.join(out_path, ANSWERS, f"{folder}.json"), encoding="utf-8") as file:
            return {str(stem): str(text) for stem, text in json.load(file).items()}
    except (OSError, ValueError, AttributeError):
        return {}


def write_class(records: list, out_path: str, history=(), figures=()) -> None:
    """history: the changes of marks, the oldest first. figures: files in the folder 'figures', '' or one for each of
    most_made(records)."""
    os.makedirs(out_path, exist_ok=True)
    clear(out_path)
    put(out_path, "grades.csv", grades_csv(records))
    put(out_path, "junit.xml", junit_xml(records))
    put(out_path, "index.html", class_page(records, history, figures))


def read_record(results_json_path: str) -> dict:
    """The record that write_submission kept; ValueError where the file is none of ours."""
    with open(results_json_path, encoding="utf-8") as file:
        results = json.load(file)
    try:
        record = dict(results["extra_data"]["record"])
        record["submission"], record["stems"]
    except (KeyError, TypeError) as error:
        raise ValueError(f"{results_json_path} holds no record") from error
    # Links lead to where it lies, whatever it was called when it was written.
    record["folder"] = os.path.basename(os.path.dirname(os.path.abspath(results_json_path)))
    return record
