"""workbench.py - where one submission is worked on, each step in a sandbox of its own.

The steps are shell, so that one sandbox serves all files of a submission. What they are shown of this
project is the kit, which the Makefile makes.
"""
from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

from sandbox import Sandbox

COMPILE_SECONDS = 60   # for a submission's files together; each has five of work (confine/)
JUDGE_SECONDS = 240    # for all its functions; each has one of work a call (judge/call.c)

# A compiler that is stopped leaves half a file. What it said is explained as 'make exercises' does; its
# assembler speaks of a file whose name is drawn at random, and whose place is the sandbox's.
COMPILE = '''ln -s "$KIT/headers/common" "$KIT/headers/exercises" "$KIT/headers/.make" .
for stem; do
    $COMPILE -o "$stem.o" "$stem.c" 2>"$stem.words" || {
        rm -f "$stem.o"
        sed -i "s|^/.*/cc[[:alnum:]]*\\.s:|$stem.s:|" "$stem.words"
        .make/explain "$stem.c" <"$stem.words" >"$stem.help"
    }
done; true'''
# The kit comes first. It begins with crtbeginT.o, which registers the frames that follow it; if an
# object's frames are before them, a program of gcc 13 or newer crashes at its start.
LINK = '''for stem; do
    $LINK -o "$stem.exe" "$KIT/link/$stem.o" "$stem.o" "$KIT/link/blank-$stem.o" $LIBRARIES \\
        2>"$stem.words" || rm -f "$stem.exe"
done; true'''
JUDGE = 'for stem; do "$JUDGES/$stem" "$stem.exe" "$stem.d"; done; true'
# Which functions that failed call others that are not right, and for each a program with those lent.
LEND = '''for stem; do
    objdump -r "$stem.o" |
        awk -v table="$stem.d/table" -v states="wrong waiting" -f "$KIT/calls.awk" >"$stem.calls"
    while read -r name others; do
        lent=""
        for other in $others; do lent="$lent --defsym=$other=lent_$other"; done
        $LINK $lent -o "$stem.$name.exe" "$KIT/link/$stem.o" "$stem.o" "$KIT/link/blank-$stem.o" \\
            $LIBRARIES
    done <"$stem.calls"
done; true'''
JUDGE_LENT = '''for stem; do
    while read -r name others; do
        "$JUDGES/$stem" "$stem.$name.exe" --only "$name" $others >"$stem.$name.asked" &&
            : >"$stem.$name.passed"
    done <"$stem.calls"
done; true'''
# One process of all chapters, which draws a picture. Chapters that use one name for two helpers do not
# fit into one process, and there is none then.
LINK_ALL = '$LINK -o all.exe "$KIT"/link/all.o "$@" "$KIT"/link/blank-*.o $LIBRARIES'
DRAW = '"$JUDGES/picture" all.exe "$JUDGES/scene.nff" yours.png "$@"'


@dataclass(frozen=True)
class Kit:
    folder: Path
    judges: Path
    commands: dict[str, str]   # COMPILE, LINK, LIBRARIES

    def environment(self) -> dict[str, str]:
        return {**self.commands, "KIT": str(self.folder), "JUDGES": str(self.judges)}


def read_kit(folder: Path) -> Kit:
    lines = (folder / "commands").read_text().splitlines()
    commands = dict(line.split("=", 1) for line in lines)
    return Kit(folder, Path(commands.pop("JUDGES")), commands)


def shell(script: str, words: list[str]) -> list[str]:
    return ["/bin/sh", "-c", script, "sh", *words]


@dataclass(frozen=True)
class Workbench:
    kit: Kit
    sandbox: Sandbox
    folder: Path
    seed: int
    seconds: dict[str, float] = field(default_factory=lambda: {"compile": 0.0, "link": 0.0, "judge": 0.0})

    def compile(self, script: str, words: list[str]) -> bool:
        return self._build("compile", script, words, ["headers"])

    def link(self, script: str, words: list[str]) -> bool:
        return self._build("link", script, words, ["link", "calls.awk"])

    def _build(self, step: str, script: str, words: list[str], of_kit: list[str]) -> bool:
        readable = [str(self.kit.folder / name) for name in of_kit]
        command = self.sandbox.compiler(self.folder, readable, shell(script, words))
        return self._run(step, command, COMPILE_SECONDS, self.kit.environment())

    def judge(self, script: str, words: list[str]) -> bool:
        readable = [str(self.kit.judges), self.sandbox.confine]
        command = self.sandbox.view(self.folder, readable, shell(script, words))
        environment = {**self.kit.environment(), "SEED": str(self.seed)}
        if self.sandbox.confine:
            environment["CONFINE"] = self.sandbox.confine
        return self._run("judge", command, JUDGE_SECONDS, environment)

    def _run(self, step: str, command: list[str], most: float, environment: dict[str, str]) -> bool:
        began = time.monotonic()
        done = self.sandbox.run(command, self.folder, most, environment)
        self.seconds[step] += time.monotonic() - began
        return done
