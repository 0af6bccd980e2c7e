"""sandbox.py - the sandbox between hostile code and this machine.

Compiling and linking: in a file system that shows the compiler and one folder (bubblewrap), and under
Landlock, seccomp and limits (confine/). Judging: the judge in a file system of its own, the answers
under confine. Where user namespaces are not to be had, confine alone does it.
"""
from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from grade.confine.machine import GraderFailed
from grade.visible import visible

# The system files that a compiler needs; no files of users.
SYSTEM = ["/usr/bin", "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libexec", "/usr/include", "/bin", "/lib",
          "/lib32", "/lib64", "/etc/alternatives", "/etc/ld.so.cache"]
ENVIRONMENT = {"PATH": "/usr/bin:/bin", "LC_ALL": "C", "TMPDIR": "/tmp"}


@dataclass(frozen=True)
class Sandbox:
    name: str          # as the reports say it
    bubblewrap: bool
    confine: str       # the program; '' where there is none
    unsafe: bool = False

    def compiler(self, folder: Path, readable: list[str], command: list[str]) -> list[str]:
        """The command, that can write to the folder, and read it and what is readable."""
        if self.confine:
            # /tmp is the sandbox's own there; without bubblewrap the folder has to do (run sets TMPDIR).
            writable = [str(folder), "/tmp"] if self.bubblewrap else [str(folder)]
            command = [self.confine, "compile", *writable, "-", *readable, self.confine, *SYSTEM, "--", *command]
        return self.watched(self.view(folder, [*readable, self.confine], command))

    def judge(self, folder: Path, readable: list[str], command: list[str]) -> list[str]:
        """The same for the judge, which sees how far the processes are that it started."""
        readable = [*readable, self.confine]
        if self.confine and not self.bubblewrap:
            command = [self.confine, "judge", str(folder), "-", *readable, *SYSTEM, "/proc", "--", *command]
        return self.watched(self.view(folder, readable, command))

    def watched(self, command: list[str]) -> list[str]:
        """Nothing of it outlives it, or this process."""
        return [self.confine, "watch", str(os.getpid()), "--", *command] if self.confine else command

    def view(self, folder: Path, readable: list[str], command: list[str]) -> list[str]:
        """The command in a file system that has only the folder and what is readable."""
        if not self.bubblewrap:
            return command
        view = ["bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL",
                "--hostname", "sandbox", "--dev", "/dev", "--proc", "/proc", "--size", str(64 << 20),
                "--tmpfs", "/tmp"]
        for place in SYSTEM:
            if os.path.islink(place) and os.path.isdir(place):
                view += ["--symlink", os.readlink(place), place]
            elif os.path.exists(place):
                view += ["--ro-bind", place, place]
        for place in readable:
            if place:
                view += ["--ro-bind", place, place]
        return [*view, "--bind", str(folder), str(folder), "--chdir", str(folder), "--", *command]

    def run(self, command: list[str], folder: Path, seconds: float, environment: dict[str, str]) -> tuple[str, str]:
        """Its output, and what our own programs complain about. GraderFailed if it did not end by itself, and
        well. No process of it is left."""
        there = {**ENVIRONMENT, **environment}
        if not self.bubblewrap:
            there["TMPDIR"] = there["TEMP"] = str(folder)   # the latter is Check's
        try:
            process = subprocess.Popen(command, cwd=folder, env=there, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                       encoding="ascii", errors="replace")
        except OSError as error:
            raise GraderFailed(f"the sandbox could not be started: {error.strerror}") from None
        try:
            said, words = output(process, seconds)
        finally:
            end_all(process)
        if process.returncode != 0:
            raise GraderFailed(f"it ended with {ending(process.returncode)}{complaint(words)}")
        return said, words


def output(process: subprocess.Popen, seconds: float) -> tuple[str, str]:
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        has_ended = process.poll() is not None
        try:
            return process.communicate(timeout=5)
        except subprocess.TimeoutExpired:
            if has_ended:   # and something that it started still holds its output
                raise GraderFailed(f"it ended with {ending(process.returncode)}") from None
    raise GraderFailed(f"it was not done after {seconds:g} s")


def end_all(process: subprocess.Popen) -> None:
    """Also ends the processes that it left running; of those that have lost their parent, this one is it (crew.py)."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()
    process.stdout.close()
    process.stderr.close()
    try:
        left = Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()
    except OSError:
        left = []
    for child in left:
        os.kill(int(child), signal.SIGKILL)
        os.waitpid(int(child), 0)


def ending(code: int) -> str:
    """As Python counts, or as a shell does."""
    return f"signal {-code}" if code < 0 else f"signal {code - 128}" if code > 128 else f"exit status {code}"


def complaint(words: str) -> str:
    lines = words.strip().splitlines()
    return f": {visible(lines[-1][:200])}" if lines else ""


def says(command: list[str]) -> str | None:
    """Its output, if it works."""
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=20, text=True)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None


def choose(confine: Path, wanted: str, unsafe: bool) -> Sandbox:
    """The best that this machine has; with a name, that one or none. SystemExit where there is none."""
    kernel = (says([str(confine), "probe"]) or "").split() if confine.exists() else []
    bubblewrap = shutil.which("bwrap") is not None and says(
        ["bwrap", "--unshare-all", "--ro-bind", "/", "/", "true"]) is not None
    if wanted not in ("", "bubblewrap", "landlock", "none"):
        raise SystemExit(f"grade: SANDBOX={wanted}: expected bubblewrap or landlock")
    if "seccomp" in kernel and bubblewrap and wanted in ("", "bubblewrap"):
        also = ", Landlock" if "landlock" in kernel else ""
        return Sandbox(f"bubblewrap{also}, seccomp", True, str(confine))
    if "seccomp" in kernel and "landlock" in kernel and wanted in ("", "landlock"):
        return Sandbox("Landlock, seccomp", False, str(confine))
    if unsafe and wanted in ("", "none"):
        return Sandbox("none", False, "", True)
    there = {"bubblewrap": bubblewrap, "Landlock": "landlock" in kernel, "seccomp": "seccomp" in kernel}
    kind = f" of the kind SANDBOX={wanted}" if wanted else ""
    raise SystemExit(
        f"grade: no sandbox here{kind}. It takes seccomp, and bubblewrap or Landlock; missing:\n"
        f"  {', '.join(name for name in there if not there[name])}\n"
        "  'make setup FOR=instructor' installs what can be installed. UNSAFE=1 runs what students wrote\n"
        "  as you, with all that you may do; every report will say so.")
