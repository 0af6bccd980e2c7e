"""test_grade.py - the whole grader on a small class: what it says, that it is fair, that nothing stops it.

Usage: test_grade.py short|long. Run from the top of the tree; KIT is in the environment.
"""
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

KIT = os.environ.get("KIT", "build/grading")
SEED = "20150929"
passed = failed = 0


def check(sentence: str, good: bool, seen: object = "") -> None:
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print(f"not ok: {sentence}" + (f"\n  saw {str(seen)[:600]}" if seen != "" else ""))


def command(folder: Path, out: Path) -> list[str]:
    return [sys.executable, "-B", "tests/grading/grade.py", KIT, str(folder), "--out", str(out)]


def grade(folder: Path, out: Path, **settings: str) -> subprocess.CompletedProcess:
    environment = {**os.environ, "SEED": SEED, **settings}
    return subprocess.run(command(folder, out), env=environment, capture_output=True, text=True, errors="replace")


def records(out: Path) -> dict[str, dict]:
    """By folder; without what may differ between two runs."""
    found = {}
    for path in sorted(out.glob("*/results.json")):
        record = json.loads(path.read_text())["extra_data"]["record"]
        record.pop("seconds", None)
        found[path.parent.name] = record
    return found


# ---- a class --------------------------------------------------------------------------------------

def right(stem: str) -> str:
    return Path("solutions", f"{stem}.c").read_text()


def definition(text: str, function: str) -> re.Match:
    return re.search(rf"^\w.* {function}\(.*\)\n{{\n", text, re.M)


def but(stem: str, **bodies: str) -> str:
    """The right answers, but for these functions."""
    text = right(stem)
    for function, body in bodies.items():
        start = text.index("// BEGIN SOLUTION", definition(text, function).end())
        text = f"{text[:start]}{body}\n    {text[text.index('// END SOLUTION', start):]}"
    return text


STEMS = sorted(path.stem for path in Path("solutions").glob("*.c"))
TURNED = "return c.distance * c.forward + (s - 0.5) * c.width * c.right - (t - 0.5) * c.height * c.up;"


def build_class(folder: Path) -> None:
    def put(name: str, files: dict[str, str | bytes]) -> None:
        for path, text in files.items():
            place = folder / name / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(text if isinstance(text, bytes) else text.encode())

    put("all right", {f"{stem}.c": right(stem) for stem in STEMS})
    put("deep", {f"week 3/mine/{stem}.c": right(stem) for stem in STEMS[:2]})
    put("from windows", {f"{stem}.c": b"\xef\xbb\xbf" + right(stem).replace("\n", "\r\n").encode() for stem in STEMS[:3]})
    put("blanks", {f"{stem}.c": Path("build/blanks", f"{stem}.c").read_text() for stem in STEMS})
    put("mirrored", {"01-corners.c": but("01-corners", image_plane_vector=TURNED)})
    put("endless", {"01-corners.c": but("01-corners", upper_left="for (;;) { }")})
    put("crash", {"01-corners.c": but("01-corners", upper_left="return *(vec3 *)0;")})
    put("no text", {"01-corners.c": "int x = ;\n", "03-screen.c": right("03-screen")})
    put("one function", {"01-corners.c": right("01-corners")[:definition(right("01-corners"), "upper_right").start()]})
    put("waits", {"01-corners.c": but("01-corners", image_plane_vector=TURNED, upper_left="return image_plane_vector(c, 0, 1);")})
    put("each other", {"01-corners.c": but("01-corners", upper_left="return upper_right(c) - c.width * c.right;",
                                           upper_right="return upper_left(c) + c.width * c.right;")})
    put("two of one name", {"a/01-corners.c": right("01-corners"), "b/01-corners.c": "int x;\n"})
    put("-leading dash 'quote\" newline\n\x1b[31m =ü", {"03-screen.c": right("03-screen")})
    (folder / "nothing").mkdir()
    with zipfile.ZipFile(folder / "zipped.zip", "w") as archive:
        archive.writestr("x/04-pixel-ray.c", right("04-pixel-ray"))
        archive.writestr("../../03-screen.c", right("03-screen"))
    (folder / "broken.tar.gz").write_bytes(b"no archive")
    (folder / "read me.txt").write_text("for the instructor\n")


# ---- what must hold -------------------------------------------------------------------------------

def function(record: dict, name: str) -> dict:
    return next(f for stem in record["stems"] for f in stem["functions"] if f["name"] == name)


def score(record: dict, stem: str) -> tuple[float, float]:
    return next((s["score"], s["max"]) for s in record["stems"] if s["stem"] == stem)


def says_what_is_right(found: dict[str, dict]) -> None:
    check("all right: all marks", found["all right"]["score"] == found["all right"]["max"] == 100, found["all right"])
    check("the status of what could be judged is graded", found["all right"]["status"] == "graded")
    check("files are found at any depth", all(score(found["deep"], s)[0] == score(found["deep"], s)[1] > 0 for s in STEMS[:2]))
    windows = found["from windows"]
    check("Windows line ends and a byte-order mark cost nothing",
          all(score(windows, s)[0] == score(windows, s)[1] for s in STEMS[:3]), windows)
    check("blanks earn nothing", found["blanks"]["score"] == 0, found["blanks"]["score"])
    check("a known mistake is named", function(found["mirrored"], "image_plane_vector")["mistake"] is not None)
    check("one mistake costs one function", score(found["mirrored"], "01-corners") == (12, 15), score(found["mirrored"], "01-corners"))
    check("an endless loop is 'timed out'", found["endless"]["status"] == "timed out", found["endless"]["status"])
    check("and costs its function only", score(found["endless"], "01-corners") == (12, 15))
    check("a crash is 'crashed'", found["crash"]["status"] == "crashed", found["crash"]["status"])
    check("what does not compile says so, in the compiler's words",
          found["no text"]["status"] == "does not compile" and "expected expression" in found["no text"]["stems"][0]["words"])
    check("its other chapters have their marks", score(found["no text"], "03-screen") == (12, 12))
    check("functions that are missing are not answered", score(found["one function"], "01-corners") == (3, 15),
          found["one function"]["stems"][0])
    waits = function(found["waits"], "upper_left")
    check("what fails only for another function has its marks", waits["state"] == "waiting" and waits["score"] == 3
          and waits["waiting_for"] == ["image_plane_vector"], waits)
    both = [function(found["each other"], name)["score"] for name in ("upper_left", "upper_right")]
    check("two that wait for each other have none", both == [0, 0], both)
    check("two files of one name are said, not guessed between", found["two of one name"]["stems"][0]["state"] == "twice")
    check("no file: empty", found["nothing"]["status"] == "empty")
    check("a broken archive is a result too", found["broken"]["status"] == "empty" and found["broken"]["words"] != "")
    check("an archive is read; what would escape from it is not",
          (score(found["zipped"], "04-pixel-ray")[0] > 0, score(found["zipped"], "03-screen")[0]) == (True, 0), found["zipped"])


def hidden_inputs_are_not_told(found: dict[str, dict]) -> None:
    everything = [f for record in found.values() for stem in record["stems"] for f in stem["functions"] if f["hidden"]]
    check("values of hidden inputs are in no record",
          all(not (f["given"] or f["expected"] or f["yours"]) for f in everything))


def same_marks(folder: Path, work: Path, found: dict[str, dict]) -> None:
    for name, settings in {"one job": {"JOBS": "1"}, "four jobs": {"JOBS": "4"}}.items():
        grade(folder, work / name, **settings)
        check(f"same seed, same marks with {name}", records(work / name) == found)
    if "bubblewrap" in next(iter(found.values()))["sandbox"]:
        grade(folder, work / "landlock", SANDBOX="landlock")
        theirs = records(work / "landlock")
        check("same marks under Landlock alone", {n: r["stems"] for n, r in theirs.items()} ==
              {n: r["stems"] for n, r in found.items()}, {n: r["status"] for n, r in theirs.items()})


def killed_and_started_again(folder: Path, work: Path, found: dict[str, dict]) -> None:
    chance = random.Random(7)
    out = work / "killed"
    for kill in (signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGKILL, signal.SIGKILL, signal.SIGKILL):
        grader = subprocess.Popen(command(folder, out), env={**os.environ, "SEED": SEED, "JOBS": "2"},
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        time.sleep(chance.uniform(0.2, 1.6))
        grader.send_signal(kill)
        grader.communicate()
        whole = records(out)    # json.loads fails on half a file
        check("what is there after a kill is whole", all(whole[name] == found[name] for name in whole))
    before = {path: path.stat().st_mtime_ns for path in out.glob("*/results.json")}
    done = grade(folder, out)
    check("started again, it does what is left", done.returncode == 0 and records(out) == found, done.stderr[-500:])
    check("and nothing twice", all(path.stat().st_mtime_ns == at for path, at in before.items())
          and done.stderr.count("(kept)") == len(before), done.stderr)
    check("no half of a file is left", not list(out.glob("*/.*.new")) and not list((out / ".work").glob("*-of-*/*")))
    again = grade(folder, out)
    check("a third time there is nothing to do", again.stderr.count("(kept)") == len(found), again.stderr)


def what_has_changed_is_marked_again(folder: Path, work: Path) -> None:
    copy = work / "changing"
    shutil.copytree(folder, copy)
    grade(copy, work / "changed")
    (copy / "nothing" / "03-screen.c").write_text(right("03-screen"))
    done = grade(copy, work / "changed")
    check("only what was handed in again is marked again", done.stderr.count("(kept)") == len(records(work / "changed")) - 1)
    check("and has its new marks", records(work / "changed")["nothing"]["score"] == 12)
    other = grade(copy, work / "changed", SEED="1")
    check("another seed marks all again", "(kept)" not in other.stderr)


def shards_share_the_work(folder: Path, work: Path, found: dict[str, dict]) -> None:
    out = work / "shards"
    if shutil.which("parallel") is None:
        print("skipped: sharing the work: no GNU parallel (make setup FOR=contributor)")
        return
    shards = ["1/3", "2/3", "3/3"]
    parallel = subprocess.run(["parallel", "--will-cite", "-j3", f"SHARD={{}} {' '.join(command(folder, out))}", ":::", *shards],
                              env={**os.environ, "SEED": SEED, "JOBS": "1"}, capture_output=True, text=True)
    check("three shards under GNU parallel end well", parallel.returncode == 0, parallel.stderr[-500:])
    check("together they have done all, with the same marks", records(out) == found)
    merged = grade(folder, out)
    check("once more merges: nothing is marked again", merged.stderr.count("(kept)") == len(found) and merged.returncode == 0)
    check("and the class's reports are there", (out / "grades.csv").exists())


def main() -> None:
    kind = sys.argv[1]
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        folder = work / "class"
        build_class(folder)
        first = grade(folder, work / "out")
        found = records(work / "out")
        check("every submission has one result", len(found) == len(list(folder.iterdir())) - 1 and first.returncode == 0,
              first.stderr[-800:])
        check("what is no submission is mentioned", "read me.txt" in first.stderr)
        check("nothing acts on the terminal", "\x1b" not in first.stdout + first.stderr)
        if kind == "short":
            says_what_is_right(found)
            hidden_inputs_are_not_told(found)
        else:
            same_marks(folder, work, found)
            killed_and_started_again(folder, work, found)
            what_has_changed_is_marked_again(folder, work)
            shards_share_the_work(folder, work, found)
    print(f"grading, {kind}: {passed} passed, {failed} failed")
    sys.exit(failed != 0)


main()
