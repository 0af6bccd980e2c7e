"""commands.py - every program that is run for a submission, as a list of arguments.

A step is some of them, one after the other in one sandbox, run by a shell. Their folder is the submission's, which
they name by STEM.c, STEM.o and so on; of this project they are shown the kit, which the Makefile makes.
"""
from __future__ import annotations

import shlex
from dataclasses import dataclass, replace
from pathlib import Path

from grade.confine.machine import CRASHES, LIMITS, statuses_of

LARGEST_OBJECT = 2 << 20
LARGEST_PROGRAM = 4 << 20

# The exit statuses that are about what was handed in, after a second look (confine/machine.py); all others are about
# this machine.
DONE = 0
REFUSED = {1, 90, 93, 94} | statuses_of(CRASHES)    # an error, or the compiler crashed on it (confine/confine.c)
LIMITED = {91, 92} | statuses_of(LIMITS)            # too much work, or a file that is too large
BUILT = frozenset({DONE} | REFUSED | LIMITED)
JUDGED = frozenset({DONE, 1})
EXPLAINED = frozenset(range(126)) | BUILT

# The commands that compile, link and judge answers, from the folder of the kit.
HEADERS, LINKED = "headers", "link"
# Files of something right, which the steps must accept, begin with these words: the chapter's blank, and
# the reference.
BLANK, RIGHT = "blank-", "right-"


@dataclass(frozen=True)
class Command:
    name: str                       # of the part of the step, which may be a stem or a function
    words: list[str]
    expected: frozenset[int]        # exit statuses that do not mean a failure of this machine
    reads: str = "/dev/null"
    writes: str = "/dev/null"       # what it prints
    complaints: str = ""            # what it prints on stderr; '': it is the grader's to say
    makes: str = ""                 # a file
    most: int = 0                   # bytes of it

    def shell(self) -> str:
        """A line of a step's script."""
        files = [("<", self.reads), (">", self.writes), ("2>", self.complaints)]
        redirected = " ".join(sign + shlex.quote(file) for sign, file in files if file)
        return f'{shlex.join(self.words)} {redirected}; echo {shlex.quote(self.name)} "$?"\n'


def script(commands: list[Command]) -> list[str]:
    """What runs these. It prints NAME STATUS for each, as a shell counts: 128 and more is a signal. The last line is
    'end'; without it, the step did not come to its end."""
    return ["/bin/sh", "-c", "".join(command.shell() for command in commands) + "echo end"]


@dataclass(frozen=True)
class Kit:
    folder: Path
    judge_program: str
    record_program: str             # what makes the judge's tables
    picture: Path                   # the folder of what draws a picture
    layouts: list[str]              # of the judge's figures
    compiler: list[str]
    parts_of_compiler: list[str]    # what makes a compiler of several programs run each by another one
    linker: list[str]
    libraries: list[str]

    def of_link(self, name: str) -> str:
        return str(self.folder / LINKED / name)

    def compile(self, stem: str, tool: str) -> Command:
        """tool: what says how each program of the compiler ended (confine/confine.c); '' if there is nothing."""
        watched = [*self.parts_of_compiler, f"{tool},tool"] if tool and self.parts_of_compiler else []
        return Command(stem, [*self.compiler, *watched, "-o", f"{stem}.o", f"{stem}.c"],
                       BUILT - {1} if watched else BUILT, complaints=f"{stem}.words",
                       makes=f"{stem}.o", most=LARGEST_OBJECT)

    @property
    def explainer(self) -> str:
        return str(self.folder / "explain")

    def explain(self, stem: str, *option: str) -> Command:
        """The words of the compiler (or, with --linker, of the linker) as 'make exercises' shows them; their
        own words if this fails."""
        return Command(stem, [self.explainer, *option, f"{stem}.c"], EXPLAINED, reads=f"{stem}.words",
                       writes=f"{stem}.help", complaints="/dev/null")

    def blank(self, stem: str) -> str:
        return (self.folder / "blanks" / f"{stem}.c").read_text()

    def link(self, stem: str, whose: str = "") -> Command:
        return self._link(stem, stem, f"{whose}{stem}.exe", f"{whose}{stem}.o")

    def link_lent(self, stem: str, name: str, others: list[str]) -> Command:
        """The program in which the judge answers for the others."""
        return self._link(name, stem, f"{stem}.{name}.exe", *(f"--defsym={other}=lent_{other}" for other in others),
                          f"{stem}.o")

    def link_blanks(self, stem: str) -> Command:
        """The same without the answer, which is right."""
        return replace(self._link(stem, stem, "blanks.exe"), complaints="")

    def _link(self, part: str, stem: str, program: str, *answer: str) -> Command:
        # The kit comes first. It begins with crtbeginT.o, which registers the frames that follow it; if an
        # object's frames are before them, a program of gcc 13 or newer crashes at its start.
        words = [*self.linker, "-o", program, self.of_link(f"{stem}.o"), *answer,
                 self.of_link(f"blank-{stem}.o"), *self.libraries]
        return Command(part, words, BUILT, complaints=f"{stem}.words", makes=program, most=LARGEST_PROGRAM)

    def link_all(self, objects: list[str]) -> Command:
        """One process of all chapters, which draws a picture. Chapters that use one name for two helpers do not
        fit into one process, and there is none then."""
        blanks = [str(path) for path in sorted((self.folder / LINKED).glob("blank-*.o"))]
        words = [*self.linker, "-o", "all.exe", self.of_link("all.o"), *objects, *blanks, *self.libraries]
        return Command("all", words, BUILT, complaints="/dev/null")

    def judge(self, stem: str, whose: str = "", figures: tuple[str, ...] = ()) -> Command:
        """figures: the folder that they are drawn into, if they are."""
        return Command(stem, [self.judge_program, stem, f"{whose}{stem}.exe", f"{whose}{stem}.d", *figures], JUDGED)

    def judge_lent(self, stem: str, name: str, others: list[str]) -> Command:
        """NAME.asked will have the names of those that it asked for."""
        return Command(name, [self.judge_program, stem, f"{stem}.{name}.exe", "--only", name, *others], JUDGED,
                       writes=f"{name}.asked")

    def draw(self, answered: list[str]) -> Command:
        return Command("all", [str(self.picture / "draw"), "all.exe", str(self.picture / "scene.nff"), "yours.png",
                               *answered], JUDGED)


def read_kit(folder: Path) -> Kit:
    lines = (folder / "commands").read_text().splitlines()
    commands = {key: words.split() for key, words in (line.split("=", 1) for line in lines)}
    return Kit(folder, *commands["JUDGE"], *commands["RECORD"], Path(*commands["PICTURE"]), commands["LAYOUTS"],
               commands["COMPILE"], commands["PARTS"], commands["LINK"], commands["LIBRARIES"])
