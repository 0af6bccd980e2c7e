"""crew.py - a process for each submission, so many at a time, and a line about how far they are.

Each has a session of its own, so that all of it can be ended; whatever becomes of it, there is a
result. Of several crews (shards) each does a part, and no two do the same one.
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

from grader import DONE, KEPT, Grader
from settings import stop

MOST_SECONDS = 600  # for one submission, whatever happens


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
            name = record["submission"]
            words = f"{record['status']}, {record['score']:g} of {record['max']:g}"
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


def end_with_parent() -> None:
    """However that ends. What this one starts does the same (bubblewrap, confine.c)."""
    PR_SET_PDEATHSIG = 1
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def start(grader: Grader, submission) -> int:
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child:
        return child
    status = 1
    try:
        end_with_parent()
        os.setsid()
        for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(stopping, signal.SIG_DFL)
        status = grader.mark(submission)
    except BaseException:
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
    for child, (_, began) in running.items():
        if time.monotonic() - began > MOST_SECONDS:
            end(child)


def mark_all(grader: Grader, submissions: list, jobs: int) -> None:
    progress = Progress(len(submissions))
    running: dict[int, tuple] = {}  # process -> submission, when it began
    waiting = submissions[::-1]
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                submission = waiting.pop()
                running[start(grader, submission)] = (submission, time.monotonic())
            child, status = os.waitpid(-1, os.WNOHANG)
            if child == 0:
                end_late_ones(running)
                time.sleep(0.005)
                continue
            submission, began = running.pop(child)
            code = os.waitstatus_to_exitcode(status)
            if code not in (DONE, KEPT) and time.monotonic() - began > MOST_SECONDS:
                grader.give_up_on(submission, "timed out", f"took more than {MOST_SECONDS} s in all")
            elif code == -signal.SIGXCPU:
                grader.give_up_on(submission, "timed out", "takes more than a minute to be read")
            elif code not in (DONE, KEPT):
                grader.give_up_on(submission, "crashed",
                                  f"the grader itself ended early ({code}): please report it")
            progress.say(grader.record(submission), code == KEPT)
    finally:
        for child in running:
            end(child)
            os.waitpid(child, 0)
        progress.end()


# ---- several crews --------------------------------------------------------------------------------

def of_shard(found: list, shard: tuple[int, int] | None) -> list:
    """A submission's part depends on its name alone, not on who else is in the class."""
    if shard is None:
        return found
    part, parts = shard
    return [submission for submission in found
            if int(hashlib.sha256(os.fsencode(submission.folder)).hexdigest(), 16) % parts == part - 1]


def alone(work: Path):
    """Two graders of one shard would do everything twice. Holds until what it gives is closed."""
    work.mkdir(parents=True, exist_ok=True)
    lock = open(work.parent / f"{work.name}.lock", "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        stop(f"another grader is at work here: {work.parent.parent}")
    shutil.rmtree(work, ignore_errors=True)
    return lock
