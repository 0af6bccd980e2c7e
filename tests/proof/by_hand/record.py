#!/usr/bin/env python3
"""record.py - writes into a folder what a built tree of the toolkit says, draws and marks.

Two versions that should look the same to everybody are compared by it: a record of each, then diff -rU0 -F '^== '.
Of two pictures that differ, tests/house/figures/png.py says in how many pixels.

    record.py TREE FOLDER [--only PART,...]

TREE is a checkout in which 'make all' has run; what is missing there is left out, and said. A part that is
in FOLDER already is not recorded again, unless --only names it.
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[2] / "house/runner"), str(HERE.parents[2])]
sys.dont_write_bytecode = True
import transcript  # noqa: E402 - found from there on


class Record:
    """One part while it is written: entries of text, each with a key, and pictures."""

    def __init__(self, args, folder, scratch):
        self.tree, self.folder, self.scratch = args.tree, folder, scratch
        self.entries = []

    def say(self, key, body):
        self.entries.append((key, self.plain(body).rstrip()))

    def picture(self, name, data):
        (self.folder / f"{name}.png").write_bytes(data)

    def plain(self, text):
        """Without names that are of this run alone."""
        for path, word in ((self.scratch, "SCRATCH"), (self.tree, "TREE")):
            text = text.replace(str(path), word).replace(str(path)[1:], word)
        return text

    def run(self, *command, cwd=None, given=None, **variables):
        """Exit status and output, both streams as they are shown."""
        environment = {**os.environ, "MAKEFLAGS": "", "LC_ALL": "C.UTF-8", "COLUMNS": "80", **variables}
        done = subprocess.run([str(word) for word in command], cwd=cwd or self.tree, env=environment, check=False,
                              input=given or "", stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", errors="surrogateescape")
        return done.returncode, done.stdout

    def make(self, *words):
        status, said = self.run("make", "-s", "--no-print-directory", *words)
        if status != 0:
            print(f"  make {' '.join(words)}: exit status {status}\n{said[-2000:]}", flush=True)
        return status == 0

    def write(self):
        text = "".join(f"== {key}\n{body}\n" for key, body in self.entries)
        (self.folder / "entries.txt").write_text(text, encoding="utf-8", errors="backslashreplace")


def stems(record):
    return sorted(path.stem for path in (record.tree / "exercises").glob("*.h"))


def verdicts(record):
    """On each known mistake, right variant and unknown answer."""
    if record.make("build/tests/matrix"):
        for stem in stems(record):
            for line in record.run("build/tests/matrix", stem, "--verdicts")[1].splitlines():
                answer, _, verdict = line.partition(": ")
                record.say(answer, verdict)


def generated(record):
    """On each generated answer."""
    if record.make("build/tests/try_mutants"):
        for stem in stems(record):
            for line in record.run("python3", "-B", "tests/proof/generated/check_verdicts.py", stem, "-v")[1].splitlines():
                answer, _, verdict = line.partition("; ")
                record.say(answer, verdict)


def figures(record):
    """Each as it looks on a light and on a dark page, and its words."""
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    drawn = {"lesson": "chapters/[0-9]*/**/*.svg", "made": "build/solutions/figures/*/*.svg"}
    for where, pattern in drawn.items():
        for path in sorted(record.tree.glob(pattern)):
            if path.stem.endswith("-dark"):
                continue
            text = path.read_text(encoding="utf-8")
            said = [re.search(f"<{tag}[^>]*>(.*?)</{tag}>", text, re.S) for tag in ("title", "desc")]
            record.say(f"{where} {path.stem}", "\n".join(match[1].strip() if match else "no words" for match in said))
            if browser is None:
                continue
            size = ",".join(re.search(rf'<svg[^>]* {word}="(\d+)', text)[1] for word in ("width", "height"))
            for number, scheme in enumerate(("dark", "light")):
                own = path.with_name(path.stem + "-dark.svg")
                subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--window-size={size}",
                                f"--blink-settings=preferredColorScheme={number}",
                                f"--screenshot={record.folder / f'{where}-{path.stem}-{scheme}.png'}",
                                (own if scheme == "dark" and own.exists() else path).as_uri()], capture_output=True, check=True)
    if browser is None:
        print("  without Chromium figures are not rendered", flush=True)


def pictures(record):
    """Those that 'make' casts and those that the lessons show."""
    for where, pattern in {"cast": "build/solutions/gallery/*.png", "lesson": "chapters/*/*.png"}.items():
        for path in sorted(record.tree.glob(pattern)):
            record.picture(f"{where}-{path.stem}", path.read_bytes())


def transcripts(record):
    """What each command of the transcripts prints, to every letter."""
    for text in sorted((record.tree / "tests/house").glob("*.txt")):
        asked = [block for block in transcript.blocks(text.read_text(encoding="utf-8")) if block[0][0].startswith("$ ")]
        for (lines, _), found in zip(asked, transcript.run(asked, record.tree)):
            said = re.sub(r"[\d.]+ (ms|s|million)\b", r"N \1", re.sub(r"/tmp/tmp[^/ ]+", "SCRATCH", "\n".join(found)))
            record.say(f"{text.stem}: {' '.join(lines)}", said)


def answers(record):
    """What a student reads from make: of right, wrong and missing answers."""
    for words in (["help"], ["exercises", "EX=99"], ["exercises", "ANSWERS=nowhere"], ["figures", "FIGURE=none"],
                  ["debug"], ["reset", "EX=1", "ANSWERS=solutions"], ["setup", "FOR=nobody"]):
        status, said = record.run("make", "--no-print-directory", *words)
        record.say("make " + " ".join(words), f"{said}exit status {status}")
    record.make("build/example-class")
    folders = sorted(path for path in (record.tree / "build/example-class").iterdir() if path.is_dir())
    for folder in [record.tree / "solutions", *folders]:
        own = record.scratch / "answers" / folder.name
        own.mkdir(parents=True)
        for source in folder.glob("**/*.c"):
            shutil.copy(source, own)
        for words in (["exercises"], ["exercises", "ALL=1"], ["hint"], ["status"]):
            status, said = record.run("make", "--no-print-directory", *words, f"ANSWERS={own}")
            record.say(f"{folder.name}: make {' '.join(words)}", f"{said}exit status {status}")
        shutil.rmtree(record.tree / "build" / str(own)[1:], ignore_errors=True)


def grades(record):
    """The example class: what the grader prints, the grades and each report."""
    out = record.scratch / "grades"
    status, said = record.run("make", "-s", "--no-print-directory", "grade", "SUBMISSIONS=build/example-class",
                              "POLICY=tests/grade/example/policy", f"OUT={out}", SEED="2015")
    said = "\n".join(line.split("\r")[-1] for line in said.splitlines() if not line.startswith("Took"))
    record.say("make grade", re.sub(r"\d+(\.\d+)? s\b", "N s", f"{said}\nexit status {status}"))
    for path in sorted(out.glob("**/*")):
        if path.is_file() and not any(part.startswith(".") for part in path.relative_to(out).parts):
            if path.suffix == ".json":
                from grade.attacks import reports
                record.say(str(path.relative_to(out)), json.dumps(reports.without_times(json.loads(path.read_text())), indent=1))
            elif path.suffix in (".txt", ".csv"):
                record.say(str(path.relative_to(out)), re.sub(r"\d+\.\d+ s\b", "N s", path.read_text()))
            else:
                record.say(str(path.relative_to(out)), "is there")


def attacks(record):
    """The status and the score of each hostile submission, in one sandbox."""
    kept = record.scratch / "attacks"
    record.make("build/list_exercises")
    status, said = record.run("python3", "-B", "tests/grade/attacks", "bubblewrap", KEEP=str(kept))
    record.say("the class of attacks", re.sub(r", \d+ s$", "", said, flags=re.M) + f"exit status {status}")
    for path in sorted(kept.glob("out/*/results.json")):
        it = json.loads(path.read_text())["extra_data"]["record"]
        states = " ".join(f"{function['name']}={function['state']}" for stem in it["stems"] for function in stem["functions"]
                          if function["state"] not in ("unanswered", "empty"))
        record.say(it["submission"].encode("ascii", "backslashreplace").decode(), f"{it['status']}, {it['score']}\n{states}")


def handout(record):
    """The files of the students' archive."""
    if not record.make("handout"):
        return
    room = record.scratch / "handout"
    shutil.unpack_archive(record.tree / "build/handout.tar.gz", room)
    for path in sorted(room.glob("*/**/*")):
        if path.is_file():
            data = path.read_bytes()
            record.say("/".join(path.relative_to(room).parts[1:]),
                       f"{data.count(10)} lines, {hashlib.sha256(data).hexdigest()[:12]}")


def built(record):
    """Names of what 'make' leaves for its users, and sizes to two digits."""
    for path in sorted([*record.tree.glob("build/*"), *record.tree.glob("build/solutions/**/*")]):
        if path.is_file() and path.suffix not in (".o", ".d", ".a"):
            record.say(str(path.relative_to(record.tree)), f"about {float(f'{path.stat().st_size:.1e}'):.0f} bytes")


PARTS = [verdicts, transcripts, pictures, figures, built, handout, answers, grades, attacks, generated]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tree", type=lambda path: Path(path).resolve())
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="parts: " + ", ".join(part.__name__ for part in PARTS))
    args = parser.parse_args()
    only = args.only.split(",") if args.only else []
    if set(only) - {part.__name__ for part in PARTS}:
        parser.error(f"--only {args.only}: expected some of {', '.join(part.__name__ for part in PARTS)}")
    for part in PARTS:
        place = args.folder / part.__name__
        wanted = part.__name__ in only if only else not place.exists()
        if not wanted:
            continue
        print(f"{part.__name__}: {part.__doc__.splitlines()[0]}", flush=True)
        begin = time.perf_counter()
        new = args.folder / f".{part.__name__}.new"
        shutil.rmtree(new, ignore_errors=True)
        new.mkdir(parents=True)
        scratch = Path(tempfile.mkdtemp(prefix="record-"))
        try:
            record = Record(args, new, scratch)
            part(record)
            record.write()
        finally:
            shutil.rmtree(scratch, ignore_errors=True)
        shutil.rmtree(place, ignore_errors=True)
        new.rename(place)
        pictures_made = len(list(place.glob("*.png")))
        print(f"  {len(record.entries)} texts, {pictures_made} pictures, {time.perf_counter() - begin:.0f} s", flush=True)


if __name__ == "__main__":
    main()
