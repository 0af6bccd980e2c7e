"""workbench.py - where one submission is worked on, each step in a sandbox of its own."""
from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

from grade.confine.machine import GraderFailed, check_room
from grade.confine.sandbox import Sandbox, complaint

from .commands import HEADERS, LINKED, Command, Kit
from .judge_report import read_report

STEP_SECONDS = 900     # a step of a submission; each of its parts has its own limit, which is far lower
STEPS = {"compile": "compiling", "link": "linking", "judge": "judging"}


@dataclass(frozen=True)
class Workbench:
    kit: Kit
    sandbox: Sandbox
    folder: Path
    seed: int
    seconds: dict[str, float] = field(default_factory=lambda: dict.fromkeys(STEPS, 0.0))

    def compile(self, commands: list[Command]) -> dict[str, int]:
        return self._build("compile", [HEADERS], commands)

    def link(self, commands: list[Command]) -> dict[str, int]:
        return self._build("link", [LINKED], commands)

    def _build(self, step: str, of_kit: list[str], commands: list[Command]) -> dict[str, int]:
        readable = [self.kit.parts, self.kit.explainer, *(str(self.kit.folder / name) for name in of_kit)]
        return self._run(step, commands, lambda words: self.sandbox.compiler(self.folder, readable, words), {})

    def judge(self, commands: list[Command]) -> dict[str, int]:
        environment = {"SEED": str(self.seed)}
        if self.sandbox.confine:
            environment["CONFINE"] = self.sandbox.confine
        readable = [self.kit.parts, self.kit.judge_program, str(self.kit.picture)]
        return self._run("judge", commands, lambda words: self.sandbox.judge(self.folder, readable, words), environment)

    def report(self, stem: str, names: list[str]) -> dict[str, dict[str, str]]:
        """The judge's findings on these functions: FUNCTION -> KEY -> value."""
        return read_report(self.folder / f"{stem}.d" / "report", names)

    def check_room(self) -> None:
        check_room(self.folder, self.sandbox.confine)

    def _run(self, step: str, commands: list[Command], confined, environment: dict[str, str]) -> dict[str, int]:
        """By name, the exit status of each part. A part that was killed, or that our own programs gave up on, is
        the grader's failure."""
        self.check_room()
        began = time.monotonic()
        words = [self.kit.parts, *(word for command in commands for word in command.arguments())]
        try:
            said, complaints = self.sandbox.run(confined(words), self.folder, STEP_SECONDS, environment)
        except GraderFailed as error:
            raise GraderFailed(f"{STEPS[step]}: {error}") from None
        self.seconds[step] += time.monotonic() - began
        lines = said.splitlines()
        ended = [line.split() for line in lines[:-1]]
        if lines[-1:] != ["end"] or [name for name, _ in ended] != [command.name for command in commands]:
            raise GraderFailed(f"{STEPS[step]} ended early{complaint(complaints)}")
        for command, (name, status) in zip(commands, ended):
            if int(status) not in command.expected:
                raise GraderFailed(f"{STEPS[step]} {name} ended with {spelled_status(int(status))}"
                                   f"{complaint(complaints)}")
        return {name: int(status) for name, status in ended}


def spelled_status(status: int) -> str:
    return f"signal {status - 128}" if status > 128 else f"exit status {status}"
