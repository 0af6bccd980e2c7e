"""machine.py - the rule for faults of this machine: they are never a mark.

A step that did not come to its end says nothing about a submission. Whoever works on one raises
GraderFailed then, and the crew lists it. A step that did come to its end, and found something wrong, is
believed only if the same step works on something right just before and after (believed). Before each step there must be
room for it (check_room).
"""
from __future__ import annotations

import errno
import os
import resource
import signal
import subprocess
from pathlib import Path
from typing import Callable

# The disk space of one submission in OUT: its objects, its programs, and the judge's output (mark/building.py).
DISK = 128 << 20
FILES = 1000
MEMORY = 256 << 20
COMMITTED = 1 << 30     # what a compiler may ask for (confine/), if the kernel promises no more than it has
PROCESSES = 12          # of one submission at a time, and some more
CONTROL_GROUP = Path("/sys/fs/cgroup")


# The signals by which a program can end because of the file that it was given. Any other came from outside.
CRASHES = {signal.SIGILL, signal.SIGABRT, signal.SIGFPE, signal.SIGSEGV}
LIMITS = {signal.SIGXCPU, signal.SIGXFSZ}
# The errors of system calls that are not about the file that is read or written.
NO_ROOM = {errno.EAGAIN, errno.EIO, errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.ENOSPC, errno.EDQUOT, errno.ESTALE,
           errno.ETIMEDOUT}


class GraderFailed(BaseException):
    """The reason for a missing mark, in words for the instructor. Not an Exception: whoever reads something odd of a
    submission's must not take this for one more odd thing."""


def must_be_its_own(error: OSError) -> None:
    """The error of a file of the submission's."""
    if error.errno in NO_ROOM:
        raise GraderFailed(f"a file cannot be read: {error.strerror}") from None


def believed(first: dict, is_doubtful: Callable, again: Callable) -> dict:
    """What a step found, by name. Something that counts against the submission (is_doubtful) is believed only if a
    second look finds it as well (again: a name to what it found), just before and just after which the same step
    worked on something right, or GraderFailed is raised. While second looks find something else, there is a third."""
    found = dict(first)
    doubtful = [name for name in found if is_doubtful(found[name])]
    while doubtful:
        found.update({name: again(name) for name in doubtful})
        before, doubtful = doubtful, [name for name in doubtful if is_doubtful(found[name])]
        if doubtful == before:
            break
    return found


def statuses_of(signals: set) -> set[int]:
    """The exit statuses of a program that another one has run, if these signals ended it."""
    return {128 + number for number in signals}


def limit(what: int, most: int) -> None:
    """A soft limit; the hard one may be lower already."""
    hard = resource.getrlimit(what)[1]
    resource.setrlimit(what, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))


def megabytes(size: int) -> str:
    return f"{max(size, 0) >> 20} MB"


def memory_facts() -> dict[str, int]:
    try:
        lines = Path("/proc/meminfo").read_text().splitlines()
        return {line.split(":")[0]: int(line.split()[1]) << 10 for line in lines}
    except (OSError, ValueError, IndexError):
        return {}


def left_in_control_group() -> int | None:
    """The memory that a container may still take; None if it has no limit."""
    try:
        most = (CONTROL_GROUP / "memory.max").read_text().strip()
        if most == "max":
            return None
        taken = int((CONTROL_GROUP / "memory.current").read_text())
        facts = dict(line.split() for line in (CONTROL_GROUP / "memory.stat").read_text().splitlines())
        return int(most) - taken + int(facts.get("inactive_file", 0))
    except (OSError, ValueError):
        return None


def check_memory() -> None:
    facts = memory_facts()
    left = [size for size in (facts.get("MemAvailable"), left_in_control_group()) if size is not None]
    if left and min(left) < MEMORY:
        raise GraderFailed(f"{megabytes(min(left))} of memory are left, a submission needs {megabytes(MEMORY)}")
    try:
        strict = Path("/proc/sys/vm/overcommit_memory").read_text().strip() == "2"
    except OSError:
        strict = False
    if strict and facts.get("CommitLimit", COMMITTED) - facts.get("Committed_AS", 0) < COMMITTED:
        raise GraderFailed(f"the kernel has promised all its memory: a compiler may need {megabytes(COMMITTED)}")


def check_disk(folder: Path) -> None:
    there = os.statvfs(folder)
    if there.f_bavail * there.f_frsize < DISK:
        raise GraderFailed(f"{megabytes(there.f_bavail * there.f_frsize)} of disk are left for OUT, "
                           f"a submission needs {megabytes(DISK)}")
    if there.f_files > 0 and there.f_favail < FILES:
        raise GraderFailed(f"OUT has room for {there.f_favail} more files, a submission needs {FILES}")


def check_processes(confine: str) -> None:
    """confine: '' if there is none. Costs as much as a small step does: once for a submission, and before a second look, which
    a lack of processes since then would lead to."""
    if not confine:
        return
    try:
        done = subprocess.run([confine, "room", str(PROCESSES)], stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise GraderFailed(f"no process can be started: {error}") from None
    if done.returncode != 0:
        raise GraderFailed(done.stderr.strip() or f"no process can be started ({done.returncode})")


def check_room(folder: Path) -> None:
    """Before each step, so that what then fails does not fail for want of room."""
    try:
        check_disk(folder)
    except OSError as error:
        raise GraderFailed(f"OUT cannot be used: {error.strerror}") from None
    check_memory()
