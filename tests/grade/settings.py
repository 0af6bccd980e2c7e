"""settings.py - the settings of the grader: from its arguments, from make's variables, from earlier runs."""
from __future__ import annotations

import argparse
import json
import os
import re
import secrets
import sys
from pathlib import Path

from grade import policy
from grade.report.files import put

LARGEST_SEED = 2**63 - 1


def stop(words: str) -> None:
    raise SystemExit(f"grade: {words}")


def number(name: str, text: str, least: int, most: int) -> int:
    if not (text.isascii() and text.isdigit()) or not least <= int(text) <= most:
        stop(f"{name}={text}: expected a whole number from {least} to {most}")
    return int(text)


def shard(text: str) -> tuple[int, int]:
    """Which part of the class, of how many."""
    part, _, parts = text.partition("/")
    if not re.fullmatch(r"[0-9]{1,5}/[0-9]{1,5}", text, re.ASCII) or not 1 <= int(part) <= int(parts) <= 10000:
        stop(f"SHARD={text}: expected i/n, such as 1/4, with i from 1 to n, and n at most 10000")
    return int(part), int(parts)


# ---- settings that OUT remembers -----------------------------------------------------------------

REMEMBERED = ("policy", "class", "submissions")    # files and a folder, of the last time that all was marked


def remembered(out: Path) -> dict[str, Path]:
    try:
        found = json.loads((out / ".settings.json").read_text(encoding="utf-8"))
        return {name: Path(found[name]) for name in REMEMBERED if found.get(name)}
    except (OSError, ValueError, TypeError, AttributeError):
        return {}


def remember(given: argparse.Namespace) -> None:
    files = {"policy": given.policy, "class": given.roster, "submissions": given.submissions}
    words = {name: str(path.resolve()) for name, path in files.items() if path is not None}
    put(str(given.out), ".settings.json", json.dumps(words))


def as_last_time(out: Path, name: str, given: Path | None) -> Path | None:
    """A file that this run was not given, but the last one was. It is said, so that nobody wonders."""
    path = remembered(out).get(name)
    if given is not None or path is None or path == policy.DEFAULT:
        return given
    if not path.exists():
        stop(f"{name.upper()}={path}, of the last time, is gone: say {name.upper()}=file")
    print(f"As the last time: {name.upper()}={path}", file=sys.stderr)
    return path


def arguments() -> argparse.Namespace:
    there = os.environ.get
    parser = argparse.ArgumentParser(prog="grade", description="Marks a folder of submissions.")
    parser.add_argument("kit", type=Path)
    parser.add_argument("submissions", type=Path, nargs="?", default=there("SUBMISSIONS") or None)
    parser.add_argument("--class", dest="roster", type=Path, default=there("CLASS") or None)
    parser.add_argument("--ledger", type=Path, default=there("LEDGER") or None)
    parser.add_argument("--only", default=there("ONLY", ""))
    parser.add_argument("--ex", default=there("EX", ""))
    parser.add_argument("--out", type=Path, default=there("OUT", "build/grades"))
    parser.add_argument("--policy", type=Path, default=there("POLICY") or None)
    parser.add_argument("--seed", default=there("SEED", ""))
    parser.add_argument("--jobs", default=there("JOBS", ""))
    parser.add_argument("--shard", default=there("SHARD", ""))
    parser.add_argument("--sandbox", default=there("SANDBOX", ""))
    parser.add_argument("--unsafe", action="store_true", default=there("UNSAFE", "") not in ("", "0"))
    given = parser.parse_args()
    # Two for each processor: while a sandbox is made, or a pipe is empty, one waits.
    processors = len(os.sched_getaffinity(0))
    given.jobs = number("JOBS", given.jobs, 1, 1024) if given.jobs else 2 * processors
    given.shard = shard(given.shard) if given.shard else None
    given.seed = number("SEED", given.seed, 0, LARGEST_SEED) if given.seed else None
    given.ledger = given.ledger or given.out / "ledger.csv"
    given.policy = as_last_time(given.out, "policy", given.policy) or policy.DEFAULT
    given.roster = as_last_time(given.out, "class", given.roster)
    if given.submissions is None:
        stop("grade what? Say: make grade SUBMISSIONS=folder")
    if not given.submissions.is_dir():
        what = "is a file: name the folder that it lies in" if given.submissions.exists() else "no such folder"
        stop(f"SUBMISSIONS={given.submissions}: {what}")
    if given.submissions.resolve() in [given.out.resolve(), *given.out.resolve().parents]:
        stop(f"OUT={given.out} lies in SUBMISSIONS={given.submissions}, where each folder is a submission")
    return given


def seed_of_class(out: Path, wanted: int | None) -> int:
    """The first grader draws it, and all others, later or elsewhere, take it."""
    path = out / ".seed"
    if wanted is None and path.exists():
        return number(str(path), path.read_text().strip(), 0, LARGEST_SEED)
    seed = secrets.randbelow(LARGEST_SEED + 1) if wanted is None else wanted
    if path.exists() and (before := path.read_text().strip()) != str(seed):
        print(f"The seed of {out} was {before} and is {seed} now: all is marked again.", file=sys.stderr)
    new = path.with_suffix(f".{secrets.token_hex(6)}")
    new.write_text(f"{seed}\n")
    try:
        if wanted is None:
            os.link(new, path)      # fails where another was first
        else:
            os.replace(new, path)
    except FileExistsError:
        return seed_of_class(out, None)
    finally:
        new.unlink(missing_ok=True)
    return seed
