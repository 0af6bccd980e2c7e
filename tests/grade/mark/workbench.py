"""workbench.py - where one submission is worked on, each step in a sandbox of its own."""
from __future__ import annotations

import re
import signal
import time
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Callable

from grade.confine.machine import GraderFailed, check_processes, check_room
from grade.confine.sandbox import Sandbox, complaint, ending

from .commands import HEADERS, LINKED, Command, Kit, script

ESCAPES = {"n": "\n", "t": "\t", "\\": "\\"}  # what is not printable stays an escape: \x1b


def read_report(path: Path, names: list[str]) -> dict[str, dict[str, str]]:
    """FUNCTION -> KEY -> value (tests/judge/judge.c). A report without one of these functions is invalid."""
    functions: dict[str, dict[str, str]] = {}
    current: dict[str, str] = {}
    try:
        text = path.read_text(encoding="ascii")
    except (OSError, UnicodeDecodeError) as error:
        raise GraderFailed(f"the judge's report cannot be read: {error}") from None
    for line in text.splitlines():
        key, _, value = line.partition("\t")
        if key == "function":
            current = functions.setdefault(value, {})
        else:
            current[key] = re.sub(r"\\([nt\\])", lambda m: ESCAPES[m[1]], value)
    lacking = [name for name in names if not functions.get(name, {}).get("state")]
    if lacking:
        raise GraderFailed(f"the judge's report says nothing of {lacking[0]}")
    return functions


STEP_SECONDS = 900     # a step of a submission; each of its parts has its own limit, which is far lower
TOO_LARGE = 128 + signal.SIGXFSZ
STEPS = {"compile": "compiling", "link": "linking", "judge": "judging"}


@dataclass(frozen=True)
class Workbench:
    kit: Kit
    sandbox: Sandbox
    folder: Path
    tables: Path                # what the judge asks (tests/judge/table.h)
    seed: int
    right: dict[str, bytes]     # STEM -> the reference's object file
    seconds: dict[str, float] = field(default_factory=lambda: dict.fromkeys(STEPS, 0.0))

    def compile(self, commands: list[Command]) -> dict[str, int]:
        return self._build("compile", [HEADERS], commands)

    def link(self, commands: list[Command]) -> dict[str, int]:
        return self._build("link", [LINKED], commands)

    def _build(self, step: str, of_kit: list[str], commands: list[Command]) -> dict[str, int]:
        readable = [self.kit.explainer, *(str(self.kit.folder / name) for name in of_kit)]
        return self._run(step, commands, lambda words: self.sandbox.compiler(self.folder, readable, words), {})

    def judge(self, commands: list[Command], layouts: list[str] = ()) -> dict[str, int]:
        """layouts: what figures are made with."""
        environment = {"JUDGE_TABLES": str(self.tables)}
        if self.sandbox.confine:
            environment["CONFINE"] = self.sandbox.confine
        readable = [self.kit.judge_program, str(self.kit.picture), str(self.tables), *layouts]
        return self._run("judge", commands, lambda words: self.sandbox.judge(self.folder, readable, words), environment)

    def sandwich(self, step: Callable, right: Command, doubtful: Command) -> int:
        """The exit status of a command between two runs of one that is right and must work, in one sandbox."""
        check_processes(self.sandbox.confine)
        ended = step([replace(right, name="before"), doubtful, replace(right, name="after")])
        if ended["before"] or ended["after"]:
            raise GraderFailed(f"{STEPS[step.__name__]} something right also fails "
                               f"({ending(ended['before'] or ended['after'])})")
        return ended[doubtful.name]

    def report(self, stem: str, names: list[str]) -> dict[str, dict[str, str]]:
        """The judge's findings on these functions: FUNCTION -> KEY -> value."""
        found = read_report(self.folder / f"{stem}.d" / "report", names)
        return {name: found[name] for name in names}

    def _made(self, command: Command, status: int) -> int:
        """The status. What was not made, or is too large, counts as SIGXFSZ; what failed leaves no file."""
        path = self.folder / command.makes
        if status == 0 and not (path.exists() and path.stat().st_size <= command.most):
            status = TOO_LARGE
        if status != 0:
            path.unlink(missing_ok=True)
        return status

    def _run(self, step: str, commands: list[Command], confined, environment: dict[str, str]) -> dict[str, int]:
        """By name, the exit status of each part. A part that was killed, or that our own programs gave up on, is
        the grader's failure."""
        check_room(self.folder)
        began = time.monotonic()
        try:
            said, complaints = self.sandbox.run(confined(script(commands)), self.folder, STEP_SECONDS, environment)
        except GraderFailed as error:
            raise GraderFailed(f"{STEPS[step]}: {error}") from None
        self.seconds[step] += time.monotonic() - began
        lines = said.splitlines()
        ended = [line.split() for line in lines[:-1]]
        if lines[-1:] != ["end"] or [name for name, _ in ended] != [command.name for command in commands]:
            raise GraderFailed(f"{STEPS[step]} ended early{complaint(complaints)}")
        statuses = [self._made(command, int(status)) if command.makes else int(status)
                    for command, (_, status) in zip(commands, ended)]
        for command, status in zip(commands, statuses):
            if status not in command.expected:
                raise GraderFailed(f"{STEPS[step]} {command.name} ended with {ending(status)}"
                                   f"{complaint(complaints)}")
        return {command.name: status for command, status in zip(commands, statuses)}
