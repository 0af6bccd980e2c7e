#!/usr/bin/env python3
"""record.py - writes into a folder what a built tree of the toolkit says, draws and marks.

Two versions that should look the same to everybody are compared by it: a record of each, then compare.py.

    record.py TREE FOLDER [--only PART,...] [--times]

TREE is a checkout in which 'make all' has run; what is missing there is left out, and said. A part that is
in FOLDER already is not recorded again, unless --only names it. --times: also how long things take, as
ratios, on an idle machine.
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[2] / "house/figures"), str(HERE.parents[2])]
sys.dont_write_bytecode = True
import png  # noqa: E402 - found from there on

SCENE = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 20 10\n"
SCENES = {
    "good.nff": SCENE + "l 3 4 9\nf 1 .5 .2 .7 .3 20 0 0\ns 0 0 0 1\nf .2 .5 1 .7 .3 20 0 0\ns 1.5 0 0 .7\n",
    "empty.nff": "", "no-view.nff": "s 0 0 0 1\n", "radius.nff": SCENE + "s 0 0 0 -1\n",
    "word.nff": SCENE + "sphere 0 0 0 1\n", "short.nff": SCENE + "s 0 0 0\n", "letters.nff": SCENE + "s 0 0 zero 1\n",
    "cone.nff": SCENE + "c\n0 0 0 1\n0 1 0 1\ns 0 0 0 1\n", "twice.nff": SCENE + SCENE, "angle.nff": SCENE.replace("40", "180"),
    "huge.nff": SCENE.replace("20 10", "99999 99999"), "color.nff": SCENE + "f 1 2\ns 0 0 0 1\n",
}
COMMANDS = """
01-corners
01-corners --eye 1,2,3 --distance 2 -s 0.3 -t 0.9
01-corners --right 1,0
01-corners --right 0.7,0.7,0
01-corners --width 1e300
02-cameras
02-cameras --height 2
02-cameras --eye 0,0,0 --at 0,0,0
03-screen
03-screen -p 1,1 -s 10x10
03-screen -p 1
03-screen -s 0x5
04-pixel-ray
04-pixel-ray --width 3
04-pixel-ray --sideways
05-quadratic
05-quadratic -o 0,0,9 -d 0,0,-1 -c 0,0,0 -r 2
05-quadratic -o 0,0,9 -d 0,0,1 -c 0,5,0 -r 2
05-quadratic -r 0
05-quadratic -r 4e261
06-ray-casting -s 64x48 -o image.png
06-ray-casting --order object -s 64x48 -o object.png
06-ray-casting -o good.png good.nff
06-ray-casting --explain 9,4 good.nff
06-ray-casting --explain 99,4 good.nff
06-ray-casting --order sideways good.nff
06-ray-casting -s axb good.nff
06-ray-casting -o nowhere/x.png good.nff
06-ray-casting -o /dev/full good.nff
06-ray-casting good.nff good.nff
06-ray-casting no.nff
06-ray-casting -o
07-shading -s 64x48 -o shaded.png good.nff
07-shading --flat -s 64x48 -o flat.png good.nff
07-shading --term diffuse -s 64x48 -o diffuse.png good.nff
07-shading --explain 9,4 good.nff
07-shading --export pov -o good.pov good.nff
07-shading --export pbrt -o good.pbrt good.nff
07-shading --depth -1 good.nff
07-shading --samples 65 good.nff
08-fast -s 64x48 -o fast.png
08-fast --engine plain -o plain.png good.nff
08-fast --engine bins -t 2 -o bins.png good.nff
08-fast --shaded -o lit.png good.nff
08-fast --rectangles good.nff
08-fast --engine quick good.nff
08-fast --threads 0 good.nff
""".strip().splitlines()
COMMANDS += [f"06-ray-casting -o {name}.png {name}.nff" for name in
             (Path(scene).stem for scene in SCENES) if name != "good"]


class Record:
    """One part while it is written: entries of text, each with a key, and pictures."""

    def __init__(self, args, folder, scratch):
        self.tree, self.folder, self.scratch, self.times = args.tree, folder, scratch, args.times
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
            for line in record.run("build/tests/try_mutants", "-v", stem, "build/tables")[1].splitlines():
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


def programs(record):
    """What the chapters' programs print and exit with, and the pictures they write."""
    room = record.scratch / "programs"
    (room / "build/solutions").mkdir(parents=True)
    (room / "chapters").symlink_to(record.tree / "chapters")
    for path in record.tree.glob("build/solutions/0*"):
        if path.is_file() and os.access(path, os.X_OK):
            shutil.copy2(path, room / "build/solutions")
    for name, text in SCENES.items():
        (room / name).write_text(text)
    asked = COMMANDS + [f"{stem} --help" for stem in stems(record)]
    for line in asked:
        program, *words = line.split()
        before = {path: path.stat().st_mtime_ns for path in room.glob("**/*.p*")}
        status, said = record.run(f"build/solutions/{program}", *words, cwd=room)
        said = re.sub(r"[\d.]+ (ms|s|million)\b", r"N \1", said)
        made = [path for path in sorted(room.glob("**/*.p*")) if before.get(path) != path.stat().st_mtime_ns]
        for path in made:
            if path.suffix == ".png":
                size, raw = png.read(path.read_bytes(), path)
                said += f"{path.name}: {size[0]} x {size[1]}, {hashlib.sha256(raw).hexdigest()[:12]}\n"
            else:
                said += f"{path.name}:\n{path.read_text()}"
        record.say(line, f"{said}exit status {status}")


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


def explained(record):
    """What a student reads of compilers' and linkers' words, of the cases in the tree."""
    room = record.scratch / "explained"
    room.mkdir()
    for name in ("exercises", "common"):
        (room / name).symlink_to(record.tree / name)
    if not record.make("build/explain"):
        return
    for path in sorted(record.tree.glob("tests/explain/**/*.txt")):
        for case in path.read_text(encoding="utf-8", errors="surrogateescape").split("\n== ")[0:]:
            name, *parts = re.split(r"^-- (.*)\n", case, flags=re.M)
            name, source = name.strip().removeprefix("== "), None
            for what, text in zip(parts[::2], parts[1::2]):
                if what.endswith(".c"):
                    source = what
                    (room / source).write_text(text, encoding="utf-8", errors="surrogateescape")
                elif what != "said" and source:
                    option = ["--linker"] if "link" in what or what.startswith("ld") else []
                    said = record.run(record.tree / "build/explain", *option, source, cwd=room, given=text)[1]
                    record.say(f"{name}, {what}", said)


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


def seconds(command, cwd):
    begin = time.perf_counter()
    subprocess.run([str(word) for word in command], cwd=cwd, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "MAKEFLAGS": ""})
    return time.perf_counter() - begin


def times(record):
    """Each in turns with a bare compile of the same answer, and the engines with the plain one."""
    own = record.scratch / "timed"
    own.mkdir()
    source = own / "05-quadratic.c"
    text = (record.tree / "solutions/05-quadratic.c").read_text()
    compiling = ["cc", "-std=c11", "-D_DEFAULT_SOURCE", "-Wno-psabi", "-I.", "-c", "-o", own / "x.o", source]
    verdict = ["make", "-s", "exercises", "EX=05", f"ANSWERS={own}"]
    took = {"compile": [], "verdict": []}
    for turn in range(9):
        source.write_text(f"{text}// {turn}\n")
        took["verdict"].append(seconds(verdict, record.tree))
        took["compile"].append(seconds(compiling, record.tree))
    bare = statistics.median(took["compile"][1:])
    record.say("a verdict", f"{statistics.median(took['verdict'][1:]) / bare:.2f} x a bare compile ({1000 * bare:.0f} ms)")
    shutil.rmtree(record.tree / "build" / str(own)[1:], ignore_errors=True)
    grade = ["make", "-s", "grade", "SUBMISSIONS=build/example-class", f"OUT={record.scratch / 'out'}"]
    record.say("grading the example class", f"{seconds(grade, record.tree) / bare:.0f} x a bare compile")
    for scene in ("sphereflake-7381", "sunflower"):
        names = ["plain", "object", "bvh", "packet", "tiles", "bins"]
        took = {name: [] for name in names}
        for _ in range(5):
            for name in names:
                took[name].append(seconds(["build/solutions/08-fast", "-e", name, "-o", own / "x.png",
                                           f"build/scenes/{scene}.nff"], record.tree))
        for name in names[1:]:
            ratio = statistics.median(took["plain"]) / statistics.median(took[name])
            record.say(f"{scene} by {name}", f"{ratio:.1f} x as fast as plain")
    record.say("make check", f"{seconds(['make', '-s', 'check'], record.tree) / bare:.0f} x a bare compile")


PARTS = [verdicts, programs, pictures, figures, explained, built, handout, answers, grades, attacks, generated, times]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tree", type=lambda path: Path(path).resolve())
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="parts: " + ", ".join(part.__name__ for part in PARTS))
    parser.add_argument("--times", action="store_true")
    args = parser.parse_args()
    only = args.only.split(",") if args.only else []
    if set(only) - {part.__name__ for part in PARTS}:
        parser.error(f"--only {args.only}: expected some of {', '.join(part.__name__ for part in PARTS)}")
    for part in PARTS:
        place = args.folder / part.__name__
        wanted = part.__name__ in only if only else not place.exists() and (part is not times or args.times)
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
