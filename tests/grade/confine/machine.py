"""machine.py - whether this machine has room for a step, and what it means that a step failed.

A step that did not come to its end says nothing about a submission: it is the grader's failure, and
never a mark. Whoever judges a submission raises GraderFailed then, and the crew lists it.
"""
from __future__ import annotations

import os
import subprocess
from pathlib import Path

# The disk space of one submission in OUT: its objects, its programs, and the judge's output (mark/building.py).
DISK = 128 << 20
FILES = 1000
MEMORY = 256 << 20
COMMITTED = 1 << 30     # what a compiler may ask for (confine/), if the kernel promises no more than it has
PROCESSES = 12          # of one submission at a time, and some more
CONTROL_GROUP = Path("/sys/fs/cgroup")


class GraderFailed(Exception):
    """The reason for a missing mark, in words for the instructor."""


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
    try:
        done = subprocess.run([confine, "room", str(PROCESSES)], stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise GraderFailed(f"no process can be started: {error}") from None
    if done.returncode != 0:
        raise GraderFailed(done.stderr.strip() or f"no process can be started ({done.returncode})")


def check_room(folder: Path, confine: str) -> None:
    """Before each step, so that what then fails does not fail for want of room. confine: '' if there is none."""
    try:
        check_disk(folder)
    except OSError as error:
        raise GraderFailed(f"OUT cannot be used: {error.strerror}") from None
    check_memory()
    if confine:
        check_processes(confine)
