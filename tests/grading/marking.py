"""marking - one submission from its files to its record.

Four steps, each a sandbox of its own: compile; link with what asks for answers; judge; and where a
function failed that calls another one that is not right, judge it again with the reference lent for that
other one. What a student made is run and compiled here, but never read, save the compiler's words.
"""
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from sandbox import Sandbox
from visible import visible

COMPILE_SECONDS = 60   # for a submission's files together; each has five of work (confine.c)
JUDGE_SECONDS = 240    # for all its functions; each has one of work a call (judge/call.c)
MOST_WORDS = 2000      # characters that are quoted of a compiler
MOST_LINES = 30

COMPILE = 'for stem; do $COMPILE -o "$stem.o" "$stem.c" 2>"$stem.words"; done; true'
LINK = '''for stem; do
    $LINK -o "$stem.exe" "$stem.o" "$KIT/link/$stem.o" "$KIT/link/blank-$stem.o" $LIBRARIES 2>"$stem.words"
done; true'''
JUDGE = 'for stem; do mkdir -p "$stem.d" && "$JUDGES/$stem" "$stem.exe" "$stem.d"; done; true'
# Which functions that failed call others that are not right, and for each a program with those lent.
LEND = '''for stem; do
    objdump -r "$stem.o" | awk -v table="$stem.d/table" -v states="wrong waiting" -f "$KIT/calls.awk" >"$stem.calls"
    while read -r name others; do
        lent=""
        for other in $others; do lent="$lent --defsym=$other=lent_$other"; done
        $LINK $lent -o "$stem.$name.exe" "$stem.o" "$KIT/link/$stem.o" "$KIT/link/blank-$stem.o" $LIBRARIES
    done <"$stem.calls"
done; true'''
JUDGE_LENT = '''for stem; do
    while read -r name others; do
        "$JUDGES/$stem" "$stem.$name.exe" --only "$name" $others >"$stem.$name.asked" && : >"$stem.$name.passed"
    done <"$stem.calls"
done; true'''
# One process of all chapters, which draws a picture. Chapters that use one name for two helpers do not
# fit into one process, and there is none then.
LINK_ALL = '$LINK -o all.exe "$@" "$KIT"/link/all.o "$KIT"/link/blank-*.o $LIBRARIES'
DRAW = '"$JUDGES/picture" all.exe "$JUDGES/scene.nff" yours.png'


@dataclass(frozen=True)
class Kit:
    """What the sandboxes are shown of this project; the Makefile makes it, and says how to use it."""
    folder: Path
    judges: Path
    commands: dict[str, str]   # COMPILE, LINK, LIBRARIES

    def environment(self) -> dict[str, str]:
        return {**self.commands, "KIT": str(self.folder), "JUDGES": str(self.judges)}


def read_kit(folder: Path) -> Kit:
    lines = (folder / "commands").read_text().splitlines()
    commands = dict(line.split("=", 1) for line in lines)
    return Kit(folder, Path(commands.pop("JUDGES")), commands)


@dataclass(frozen=True)
class Bench:
    """Where one submission is worked on."""
    kit: Kit
    sandbox: Sandbox
    folder: Path
    seed: int

    def _shell(self, script: str, words: list[str]) -> list[str]:
        return ["/bin/sh", "-c", script, "sh", *words]

    def compile(self, script: str, words: list[str]) -> bool:
        headers = [str(self.kit.folder / "headers")]
        return self._confined(script, words, headers)

    def link(self, script: str, words: list[str]) -> bool:
        return self._confined(script, words, [str(self.kit.folder / "link"), str(self.kit.folder / "calls.awk")])

    def _confined(self, script: str, words: list[str], readable: list[str]) -> bool:
        command = self.sandbox.compiler(self.folder, readable, self._shell(script, words))
        return self.sandbox.run(command, self.folder, COMPILE_SECONDS, self.kit.environment())

    def judge(self, script: str, words: list[str]) -> bool:
        readable = [str(self.kit.judges), self.sandbox.confine]
        command = self.sandbox.view(self.folder, readable, self._shell(script, words))
        environment = {**self.kit.environment(), "SEED": str(self.seed)}
        if self.sandbox.confine:
            environment["CONFINE"] = self.sandbox.confine
        return self.sandbox.run(command, self.folder, JUDGE_SECONDS, environment)


# ---- compiling and linking ----------------------------------------------------------------------

def quoted(path: Path, hide: Path) -> str:
    """A compiler's words about a student's text: cut, and harmless on a terminal."""
    try:
        with open(path, "rb") as file:
            raw = file.read(8 * MOST_WORDS)
    except OSError:
        return ""
    text = raw.decode("utf-8", "replace").replace(f"{hide}/headers/", "").replace("‘", "'").replace("’", "'")
    lines = text[:MOST_WORDS].splitlines()
    cut = len(text) > MOST_WORDS or len(lines) > MOST_LINES
    return visible("\n".join(lines[:MOST_LINES] + ["..."] * cut), lines=True)


def compile_words(bench: Bench, stem: str) -> str:
    words = quoted(bench.folder / f"{stem}.words", bench.kit.folder)
    if not words or "signal terminated program" in words or "limit exceeded" in words or "out of memory" in words:
        return ("the compiler was stopped: it needed more than 5 seconds, a gigabyte of memory, or 16 MB of file\n" +
                words).strip()
    return words


def link_words(bench: Bench, stem: str) -> str:
    words = quoted(bench.folder / f"{stem}.words", bench.kit.folder)
    known = [f"{name} is not in this file (or is static)"
             for name in re.findall(r"undefined reference to [`'](\w+)'", words)]
    known += [f"{name} is there already: give yours another name"
              for name in re.findall(r"multiple definition of [`'](\w+)'", words)]
    return "\n".join(dict.fromkeys(known)) or words or "the linker was stopped"


# ---- what the judge found ------------------------------------------------------------------------

def read_report(path: Path) -> dict[str, dict[str, str]]:
    """FUNCTION -> KEY -> value (tests/judge/report.h)."""
    functions: dict[str, dict[str, str]] = {}
    current: dict[str, str] = {}
    try:
        text = path.read_text(encoding="ascii")
    except (OSError, UnicodeDecodeError):
        return {}
    for line in text.splitlines():
        key, _, value = line.partition("\t")
        if key == "function":
            current = functions.setdefault(value, {})
        else:
            current[key] = re.sub(r"\\([nt\\])", lambda m: {"n": "\n", "t": "\t", "\\": "\\"}[m[1]], value)
    return functions


def lend(bench: Bench, reports: dict[str, dict]) -> dict[str, dict[str, list[str]]]:
    """STEM -> FUNCTION -> those of its stem that it asked for, when it passed with them lent."""
    stems = []
    for stem, functions in reports.items():
        states = [function["state"] for function in functions.values() if function["state"] != "right"]
        if len(states) > 1 and set(states) - {"unanswered"}:
            stems.append(stem)
    if not stems or not bench.link(LEND, stems):
        return {}
    bench.judge(JUDGE_LENT, stems)
    passed: dict[str, dict[str, list[str]]] = {}
    for stem in stems:
        for name in reports[stem]:
            if (bench.folder / f"{stem}.{name}.passed").exists():
                asked = (bench.folder / f"{stem}.{name}.asked").read_text().split()
                passed.setdefault(stem, {})[name] = asked
    return passed


def waiting(asked: dict[str, list[str]]) -> dict[str, list[str]]:
    """Those that are right but for others. Two that wait for each other are not: neither is an answer."""
    good: dict[str, list[str]] = {}
    while True:
        more = {name: others for name, others in asked.items() if name not in good and
                all(other not in asked or other in good for other in others)}
        if not more:
            return good
        good.update(more)


def draw(bench: Bench, answered: list[str], stems) -> bool:
    """Whether yours.png is there: what all the answers draw together, the reference where there is none."""
    files = [f"{stem}.o" if stem in answered else str(bench.kit.folder / "link" / f"right-{stem}.o")
             for stem in stems]
    return bench.link(LINK_ALL, files) and bench.judge(DRAW, [])


# ---- the record ----------------------------------------------------------------------------------

def function_part(exercise, found: dict[str, str], waits_for: list[str] | None) -> dict:
    """One function's part of the record, but for its marks."""
    state = found.get("state", "timed out")
    part = {"name": exercise.name, "slide": exercise.slide, "prompt": exercise.prompt, "state": state,
            "test": found.get("test", "").replace("_", " "), "hidden": found.get("hidden") == "yes", "given": [],
            "expected": "", "yours": "", "how": found.get("how", ""), "waiting_for": [], "mistake": None,
            "partly": found.get("partly") == "yes", "law": ""}
    if not found:
        part["how"] = "was not judged: the whole chapter took too long"
    if waits_for:
        part.update(state="waiting", waiting_for=waits_for, partly=False)
        return part
    if state == "waiting":
        part.update(state="wrong", how=f"calls {found['missing']}, which is not answered; with the right answer in its "
                                       "place it does not pass, either")
    if "mistake" in found:
        part["mistake"] = {key: found.get(key, "") for key in ("formula", "why", "picture")}
        part["mistake"]["id"] = found["mistake"]
    if not part["hidden"]:
        part.update(expected=found.get("expected", ""), yours=found.get("yours", ""), law=found.get("law", ""),
                    given=[line.replace("~", " ").split("\t", 1)
                           for line in found.get("given", "").splitlines() if "\t" in line])
    return part


def stem_parts(bench: Bench, answers: dict, exercises: list) -> tuple[list[dict], bool]:
    """Each stem's part of the record, but for its marks; and whether there is a picture."""
    for stem, answer in answers.items():
        if answer.state == "found":
            (bench.folder / f"{stem}.c").write_bytes(answer.text)
    there = [stem for stem, answer in answers.items() if answer.state == "found"]
    if there:
        bench.compile(COMPILE, there)
    compiled = [stem for stem in there if (bench.folder / f"{stem}.o").exists()]
    trouble = {stem: ("does not compile", compile_words(bench, stem)) for stem in there if stem not in compiled}
    if compiled:
        bench.link(LINK, compiled)
    linked = [stem for stem in compiled if (bench.folder / f"{stem}.exe").exists()]
    trouble.update({stem: ("cannot be linked", link_words(bench, stem)) for stem in compiled if stem not in linked})
    if linked:
        bench.judge(JUDGE, linked)
    reports = {stem: read_report(bench.folder / f"{stem}.d" / "report") for stem in linked}
    passed = {stem: waiting(asked) for stem, asked in lend(bench, reports).items()}

    parts = []
    for stem, answer in answers.items():
        state, words = trouble.get(stem, ("judged" if stem in linked else answer.state, answer.words))
        if state == "unreadable":
            state = "not judged"
        functions = []
        if state == "judged":
            functions = [function_part(exercise, reports[stem].get(exercise.name, {}),
                                       passed.get(stem, {}).get(exercise.name))
                         for exercise in exercises if exercise.stem == stem]
        parts.append({"stem": stem, "file": answer.file, "state": state, "words": words, "functions": functions})
    right = all(part["functions"] and all(function["state"] == "right" for function in part["functions"])
                for part in parts)
    return parts, bool(linked) and not right and draw(bench, linked, answers)


def status_of(stems: list[dict]) -> tuple[str, str]:
    """The gravest thing that happened, and where."""
    for stem in stems:
        if stem["state"] in ("does not compile", "cannot be linked"):
            return "does not compile", f"{stem['stem']} {stem['state']}"
    for state in ("timed out", "crashed"):
        for stem in stems:
            for function in stem["functions"]:
                if function["state"] == state:
                    return state, f"{stem['stem']}: {function['name']} {function['how']}"
    return "graded", ""


def mark(bench: Bench, collected, exercises: list, points) -> dict:
    """The record, but for names and lateness. points(stem, function): what it is worth."""
    shutil.rmtree(bench.folder, ignore_errors=True)
    bench.folder.mkdir(parents=True)
    stems, is_drawn = stem_parts(bench, collected.answers, exercises)
    for stem in stems:
        stem["max"] = sum(points(stem["stem"], exercise.name) for exercise in exercises if exercise.stem == stem["stem"])
        for function in stem["functions"]:
            function["max"] = points(stem["stem"], function["name"])
            function["score"] = function["max"] if function["state"] in ("right", "waiting") else 0
        stem["score"] = sum(function["score"] for function in stem["functions"])
    status, words = ("empty", collected.words) if collected.empty else status_of(stems)
    return {"status": status, "words": words or collected.words, "stems": stems,
            "score": sum(stem["score"] for stem in stems), "max": sum(stem["max"] for stem in stems),
            "pictures": {"expected": "expected.png", "yours": "yours.png"} if is_drawn else {},
            "seed": bench.seed, "sandbox": bench.sandbox.name, "unsafe": bench.sandbox.unsafe}
