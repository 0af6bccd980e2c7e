"""room.py - where the hostile class is graded: limits and a process namespace round the grader,
so that the machine survives a failure of the test itself, and eyes for what it leaves behind.
"""
from __future__ import annotations

import contextlib
import ctypes
import hashlib
import os
import resource
import select
import shutil
import signal
import socket
import stat
import subprocess
import sys
import time
from pathlib import Path

PR_SET_CHILD_SUBREAPER = 36
GIGABYTE = 1 << 30
LIMITS = {resource.RLIMIT_AS: 3 * GIGABYTE, resource.RLIMIT_FSIZE: GIGABYTE // 2, resource.RLIMIT_CPU: 900,
          resource.RLIMIT_CORE: 0, resource.RLIMIT_NPROC: 4096}
NAMESPACE = ["--pid", "--fork", "--kill-child", "--mount-proc"]


def enter() -> None:
    """Starts this program again in a process namespace of its own, unless it is in one already, or there is none to be
    had."""
    for user in ([], ["--user", "--map-root-user"]):
        command = ["unshare", *user, *NAMESPACE]
        if os.environ.get("HOSTILE_ROOM") or shutil.which("unshare") is None:
            break
        if subprocess.run([*command, "true"], capture_output=True).returncode == 0:
            os.environ["HOSTILE_ROOM"] = "entered"
            os.execvp(command[0], [*command, sys.executable, "-B", *sys.argv])


def adopt_orphans() -> None:
    """A process that outlives its parent becomes a child of this one, which sees it."""
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def limit() -> None:
    for what, most in LIMITS.items():
        hard = resource.getrlimit(what)[1]
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (most, most))


def processes() -> dict:
    """pid -> (parent, name) of all that are alive."""
    found = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = Path("/proc", pid, "stat").read_text(errors="replace")
        except OSError:
            continue
        name, rest = words[words.index("(") + 1:words.rindex(")")], words[words.rindex(")") + 2:].split()
        if rest[0] not in "ZX":
            found[int(pid)] = (int(rest[1]), name)
    return found


def descendants() -> dict:
    """pid -> name of what this process, or anything that it started, has left running."""
    alive = processes()
    if os.getpid() == 1:  # of a namespace, where all are
        return {pid: name for pid, (_, name) in alive.items() if pid != 1}
    mine, more = set(), {os.getpid()}
    while more:
        more = {pid for pid, (parent, _) in alive.items() if parent in more and pid not in mine}
        mine |= more
    return {pid: alive[pid][1] for pid in mine}


def reap() -> None:
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0] > 0:
            pass


def end_all() -> None:
    calm = 0
    for _ in range(200):
        left = descendants()
        calm = 0 if left else calm + 1
        if calm == 3:  # none, and none that was just being born
            break
        for pid in left:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.05)
        reap()


def run(command: list, folder: Path, environment: dict, seconds: float, log: Path) -> dict:
    """The result of a command: its status (None: it took too long), words, and the processes that it left."""
    began = time.monotonic()
    with open(log, "wb") as file:
        process = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT, start_new_session=True, preexec_fn=limit)
        try:
            status = process.wait(seconds)
        except subprocess.TimeoutExpired:
            status = None
    took = time.monotonic() - began
    for _ in range(20):  # the kernel takes a moment to end what lived in namespaces
        reap()
        left = descendants() if status is not None else {}
        if not left:
            break
        time.sleep(0.05)
    end_all()
    return {"status": status, "words": log.read_bytes(), "left": sorted(set(left.values())), "seconds": took}


def picture_of(tops: list, busy: Path | None = None) -> dict:
    """path -> what there is to know of it, of every file in these folders, but for a folder where others work."""
    seen = {}
    for top in tops:
        for place, folders, files in os.walk(os.fsencode(top)):
            if b".git" in folders:
                folders.remove(b".git")
            folders[:] = [name for name in folders if os.fsdecode(os.path.join(place, name)) != str(busy)]
            for name in [b".", *folders, *files]:
                path = os.path.join(place, name)
                about = os.lstat(path)
                facts = [about.st_mode, about.st_size, about.st_uid, about.st_nlink]
                if not stat.S_ISDIR(about.st_mode):
                    facts.append(about.st_mtime_ns)
                if stat.S_ISREG(about.st_mode) and about.st_size < 10 << 20:
                    with open(path, "rb") as file:
                        facts.append(hashlib.sha256(file.read()).hexdigest())
                seen[path] = facts
    return seen


def doors() -> tuple:
    """A number, and sockets of that number which nobody may come to."""
    stream = socket.socket()
    stream.bind(("127.0.0.1", 0))
    port = stream.getsockname()[1]
    packets = socket.socket(type=socket.SOCK_DGRAM)
    packets.bind(("127.0.0.1", port))
    name = socket.socket(socket.AF_UNIX)
    name.bind(f"\0hostile-{port}")
    stream.listen()
    name.listen()
    return port, [stream, packets, name]


def came_in(sockets: list) -> bool:
    return bool(select.select(sockets, [], [], 0)[0])
