"""workbench.py - where one submission is worked on, each step in a sandbox of its own.

The steps are shell, so that one sandbox serves all files of a submission. What they are shown of this
project is the kit, which the Makefile makes.
"""
from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

from grade.confine.machine import GraderFailed, check_room
from grade.confine.sandbox import Sandbox, complaint

STEP_SECONDS = 900     # a step of a submission; each of its parts has its own limit, which is far lower
LARGEST_OBJECT = 2 << 20
LARGEST_PROGRAM = 4 << 20

# Each part of a step says how it ended, in a line: NAME STATUS, and what else is to be said. A step whose
# last line is not 'end' did not come to its end.
#
# A compiler that is stopped leaves half a file. What it said is explained as 'make exercises' does; its
# assembler speaks of a file whose name is drawn at random, and whose place is the sandbox's.
COMPILE = """ln -sfn "$KIT/headers/common" common && ln -sfn "$KIT/headers/exercises" exercises &&
    ln -sfn "$KIT/headers/.make" .make || exit 1
for stem; do
    $COMPILE $WATCHED -o "$stem.o" "$stem.c" >/dev/null 2>"$stem.words"
    status=$?
    [ $status -ne 0 ] || [ "$(wc -c <"$stem.o")" -le $LARGEST_OBJECT ] || status=153
    [ $status -eq 0 ] || {
        rm -f "$stem.o"
        sed -i "s|^/.*/cc[[:alnum:]]*\\.s:|$stem.s:|" "$stem.words"
        .make/explain "$stem.c" <"$stem.words" >"$stem.help"
    } >/dev/null 2>&1
    echo "$stem $status"
done; echo end"""
# The kit comes first. It begins with crtbeginT.o, which registers the frames that follow it; if an
# object's frames are before them, a program of gcc 13 or newer crashes at its start.
LINK = """for stem; do
    $LINK -o "$stem.exe" "$KIT/link/$stem.o" "$stem.o" "$KIT/link/blank-$stem.o" $LIBRARIES \
        >/dev/null 2>"$stem.words"
    status=$?
    [ $status -ne 0 ] || [ "$(wc -c <"$stem.exe")" -le $LARGEST_PROGRAM ] || status=153
    [ $status -eq 0 ] || rm -f "$stem.exe"
    echo "$stem $status"
done; echo end"""
# The same without the answer, which cannot fail.
LINK_BLANKS = """for stem; do
    $LINK -o blanks.exe "$KIT/link/$stem.o" "$KIT/link/blank-$stem.o" $LIBRARIES >/dev/null
    echo "$stem $?"
    rm -f blanks.exe
done; echo end"""
JUDGE = """for stem; do
    "$JUDGES/$stem" "$stem.exe" "$stem.d"
    echo "$stem $?"
done; echo end"""
# Which functions of a chapter call which others, and so on.
CALLS = """for stem; do
    objdump -r "$stem.o" >"$stem.relocations" || exit 1
    awk -v table="$stem.states" -v states=any -f "$KIT/calls.awk" "$stem.relocations" >"$stem.calls" || exit 1
    while read -r name others; do
        echo "$name 0 $others"
    done <"$stem.calls"
done; echo end"""
# Which functions that failed call others that failed, and for each a program with those lent.
LEND = """for stem; do
    objdump -r "$stem.o" >"$stem.relocations"
    status=$?
    [ $status -eq 0 ] || echo "$stem.o $status"
    awk -v table="$stem.states" -v states="wrong waiting" -v may="$stem.may" -f "$KIT/calls.awk" \
        "$stem.relocations" >"$stem.calls" || exit 1
    rm -f "$stem.relocations"
    while read -r name others; do
        lent=""
        for other in $others; do lent="$lent --defsym=$other=lent_$other"; done
        $LINK $lent -o "$stem.$name.exe" "$KIT/link/$stem.o" "$stem.o" "$KIT/link/blank-$stem.o" \
            $LIBRARIES >/dev/null 2>"$stem.words"
        status=$?
        [ $status -eq 0 ] || rm -f "$stem.$name.exe"
        echo "$name $status $others"
    done <"$stem.calls"
done; echo end"""
# STEM, then the functions to judge.
JUDGE_LENT = """stem=$1
shift
for name; do
    read -r others <"$name.lent" || exit 1
    asked=$("$JUDGES/$stem" "$stem.$name.exe" --only "$name" $others)
    echo "$name" $? $asked
done; echo end"""
# One process of all chapters, which draws a picture. Chapters that use one name for two helpers do not
# fit into one process, and there is none then.
LINK_ALL = """$LINK -o all.exe "$KIT"/link/all.o "$@" "$KIT"/link/blank-*.o $LIBRARIES >/dev/null 2>&1
echo all $?; echo end"""
DRAW = """"$JUDGES/picture" all.exe "$JUDGES/scene.nff" yours.png "$@" >/dev/null
echo all $?; echo end"""


STEPS = {"compile": "compiling", "link": "linking", "judge": "judging"}
# The exit statuses that are about what was handed in; all others are about this machine. REFUSED is not
# believed at once (building.py). Beyond 128: a signal, of a program that was started by the shell.
DONE = 0
REFUSED = {1, 90, 93, 94, 132, 134, 136, 139}   # an error, or the compiler crashed on it (confine/tool.h)
LIMITED = {91, 92, 152, 153}                    # SIGXCPU, SIGXFSZ, or a file that is too large
BUILT = {DONE} | REFUSED | LIMITED
EXPECTED = {"compile": BUILT, "link": BUILT, "judge": {DONE, 1}}


@dataclass(frozen=True)
class Kit:
    folder: Path
    judges: Path
    commands: dict[str, str]   # COMPILE, PARTS, LINK, LIBRARIES

    def environment(self) -> dict[str, str]:
        return {**self.commands, "KIT": str(self.folder), "JUDGES": str(self.judges)}


def read_kit(folder: Path) -> Kit:
    lines = (folder / "commands").read_text().splitlines()
    commands = dict(line.split("=", 1) for line in lines)
    return Kit(folder, Path(commands.pop("JUDGES")), commands)


def shell(script: str, words: list[str]) -> list[str]:
    return ["/bin/sh", "-c", script, "sh", *words]


@dataclass(frozen=True)
class Part:
    """How one part of a step ended."""
    status: int
    words: list[str]    # what else it said


@dataclass(frozen=True)
class Workbench:
    kit: Kit
    sandbox: Sandbox
    folder: Path
    seed: int
    seconds: dict[str, float] = field(default_factory=lambda: {"compile": 0.0, "link": 0.0, "judge": 0.0})

    def compile(self, script: str, words: list[str]) -> dict[str, Part]:
        return self._build("compile", script, words, ["headers"])

    def link(self, script: str, words: list[str]) -> dict[str, Part]:
        return self._build("link", script, words, ["link", "calls.awk"])

    def _build(self, step: str, script: str, words: list[str], of_kit: list[str]) -> dict[str, Part]:
        readable = [str(self.kit.folder / name) for name in of_kit]
        command = self.sandbox.compiler(self.folder, readable, shell(script, words))
        environment = {**self.kit.environment(), "LARGEST_OBJECT": str(LARGEST_OBJECT),
                       "LARGEST_PROGRAM": str(LARGEST_PROGRAM), "WATCHED": self.watched()}
        return self._run(step, command, environment)

    def watched(self) -> str:
        """What makes a compiler of several programs say how each of them ended (confine/tool.c)."""
        parts = self.kit.commands["PARTS"]
        return f"{parts} {self.sandbox.confine},tool" if parts and self.sandbox.confine else ""

    def judge(self, script: str, words: list[str]) -> dict[str, Part]:
        command = self.sandbox.judge(self.folder, [str(self.kit.judges)], shell(script, words))
        environment = {**self.kit.environment(), "SEED": str(self.seed)}
        if self.sandbox.confine:
            environment["CONFINE"] = self.sandbox.confine
        return self._run("judge", command, environment)

    def check_room(self) -> None:
        check_room(self.folder, self.sandbox.confine)

    def _run(self, step: str, command: list[str], environment: dict[str, str]) -> dict[str, Part]:
        """By name, how each part ended. A part that was killed, or that our own programs gave up on, is the
        grader's failure."""
        self.check_room()
        began = time.monotonic()
        try:
            said, complaints = self.sandbox.run(command, self.folder, STEP_SECONDS, environment)
        except GraderFailed as error:
            raise GraderFailed(f"{STEPS[step]}: {error}") from None
        self.seconds[step] += time.monotonic() - began
        *lines, end = [line.split() for line in said.splitlines()] or [[]]
        if end != ["end"]:
            raise GraderFailed(f"{STEPS[step]} ended early{complaint(complaints)}")
        parts = {name: Part(int(status), words) for name, status, *words in lines}
        expected = EXPECTED[step] - ({1} if step == "compile" and self.watched() else set())
        for name, part in parts.items():
            if part.status not in expected:
                raise GraderFailed(f"{STEPS[step]} {name} ended with {shell_status(part.status)}"
                                   f"{complaint(complaints)}")
        return parts


def shell_status(status: int) -> str:
    return f"signal {status - 128}" if status > 128 else f"exit status {status}"
