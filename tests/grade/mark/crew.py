"""crew.py - a process for each submission, a limited number at a time, and a progress line.

Each has a session of its own, so that all of it can be ended. One that does not come to its end, or says
that a step of it did not, leaves a submission without a score. Of several crews (shards) each does a
part, and no two do the same one.
"""
from __future__ import annotations

import ctypes
import fcntl
import hashlib
import os
import shutil
import signal
import sys
import time
import traceback
from pathlib import Path

from grade.confine.machine import GraderFailed
from grade.confine.sandbox import ending
from grade.settings import stop
from grade.visible import score

from .grader import DONE, KEPT, Grader

MOST_SECONDS = 3600  # for one submission; what students wrote has its own limits, which are far lower
MOST_WORDS = 2000    # of a reason


class Progress:
    """A line that is written over where it is a terminal, else a line for each."""

    def __init__(self, total: int):
        self.total, self.done, self.marked, self.began = total, 0, 0, time.monotonic()
        self.terminal = sys.stderr.isatty()

    def say(self, record: dict | None, kept: bool) -> None:
        self.done += 1
        self.marked += not kept
        name, words = "", "no result"
        if record is not None:
            name, words = record["submission"], f"{record['status']}, {score(record)}"
        if self.terminal:
            each = (time.monotonic() - self.began) / max(self.marked, 1)
            left = int(each * (self.total - self.done) + 0.5)
            line = f"{self.done} of {self.total}, {left // 60}:{left % 60:02d} left  {name}: {words}"
            print(f"\r\x1b[K{line[:79]}", end="", file=sys.stderr, flush=True)
        else:
            line = f"{self.done}/{self.total} {name}: {words}{' (kept)' if kept else ''}"
            print(line, file=sys.stderr, flush=True)

    def end(self) -> None:
        if self.terminal and self.total:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def end_with_parent(parent: int) -> None:
    """However the parent ends. The processes started here do the same (confine/confine.c)."""
    PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)     # what loses its parent is ended here
    if os.getppid() != parent:  # it ended before this was asked for
        os._exit(1)


def start(grader: Grader, submission) -> tuple[int, int]:
    """The process, and where it says why it failed."""
    sys.stdout.flush()
    sys.stderr.flush()
    parent = os.getpid()
    reasons, reason = os.pipe()
    try:
        child = os.fork()
    except OSError:
        os.close(reasons)
        raise
    finally:
        if os.getpid() == parent:
            os.close(reason)
    if child:
        return child, reasons
    status = 1
    try:
        end_with_parent(parent)
        os.close(reasons)
        os.setsid()
        for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(stopping, signal.SIG_DFL)
        status = grader.mark(submission)
    except (GraderFailed, OSError, MemoryError) as error:
        os.write(reason, (str(error) or "there is no memory left").encode("utf-8", "replace")[:MOST_WORDS])
    except BaseException as error:
        words = f"{type(error).__name__}: {error} (please report this)"
        os.write(reason, words.encode("utf-8", "replace")[:MOST_WORDS])
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(status)


def end(child: int) -> None:
    for kill in (os.killpg, os.kill):
        try:
            kill(child, signal.SIGKILL)
        except ProcessLookupError:
            pass


def end_late_ones(running: dict[int, tuple]) -> None:
    for child, (_, _, began) in running.items():
        if time.monotonic() - began > MOST_SECONDS:
            end(child)


def mark_all(grader: Grader, submissions: list, jobs: int) -> dict[str, dict]:
    """The records of those that have no score, by folder; all others have written theirs."""
    progress = Progress(len(submissions))
    running: dict[int, tuple] = {}  # process -> submission, where it says why it failed, when it began
    failed: dict[str, dict] = {}
    waiting = submissions[::-1]
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                submission = waiting.pop()
                try:
                    child, reasons = start(grader, submission)
                except OSError as error:
                    if running:     # there may be room when one of them is done
                        waiting.append(submission)
                        break
                    failed[submission.folder] = grader.failed(submission, f"cannot be started: {error.strerror}")
                    progress.say(failed[submission.folder], False)
                    continue
                running[child] = (submission, reasons, time.monotonic())
            child, status = os.waitpid(-1, os.WNOHANG) if running else (0, 0)
            if child == 0:
                end_late_ones(running)
                time.sleep(0.005)
                continue
            submission, reasons, began = running.pop(child)
            reason = os.read(reasons, MOST_WORDS).decode("utf-8", "replace")
            os.close(reasons)
            code = os.waitstatus_to_exitcode(status)
            if code == -signal.SIGXCPU:
                grader.give_up_on(submission, "reading it takes more than a minute of work")
            elif code not in (DONE, KEPT):
                failed[submission.folder] = grader.failed(submission, reason or how_it_ended(code, began))
            progress.say(failed.get(submission.folder) or grader.record(submission), code == KEPT)
    finally:
        for child in running:
            end(child)
            os.waitpid(child, 0)
        progress.end()
    return failed


def how_it_ended(code: int, began: float) -> str:
    if time.monotonic() - began > MOST_SECONDS:
        return f"marking it took more than {MOST_SECONDS} s"
    return f"the process that marks it ended with {ending(code)}"


# ---- several crews --------------------------------------------------------------------------------

def of_shard(found: list, shard: tuple[int, int] | None) -> list:
    """Parts of the same size. Dealt out in an order that has nothing to do with the work that a submission makes."""
    if shard is None:
        return found
    part, parts = shard
    dealt = sorted(found, key=lambda submission: hashlib.sha256(os.fsencode(submission.folder)).digest())
    return dealt[part - 1::parts]


def locked(path: Path):
    lock = open(path, "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        stop(f"another grader is at work here: {path.parent.parent} (part {path.stem})")
    return lock


def alone(work: Path):
    """Two graders of one part of the class would do everything twice, and so would two that split it in different ways.
    Holds until what it gives is closed."""
    work.mkdir(parents=True, exist_ok=True)
    lock = locked(work.parent / f"{work.name}.lock")
    _, _, parts = work.name.rpartition("-")
    for other in work.parent.glob("*.lock"):
        if not other.stem.endswith(f"-of-{parts}"):
            locked(other).close()
    shutil.rmtree(work, ignore_errors=True)
    return lock
