"""attacks - a class of nothing but attacks, with honest answers among them: no mark that was not
earned, no byte leaked, no process left, no honest mark changed, and every verdict in words.

    attacks [SANDBOX | PART-OF-A-NAME]...    bubblewrap and landlock, and all submissions, unless some
                                     are named: then these, and one honest one, in one class. With 'none'
                                     it shows that the attacks are real, and that the machine survives them

Works on a copy of the tree in which solutions, tests and a classmate's file carry secrets; with HERE=1
on the tree itself, which is quicker and holds no secrets: for attacks that change nothing.
"""
from __future__ import annotations

import os
import secrets as chance
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # there the package is found

from grade import exercises  # noqa: E402 - found from there on
from grade.attacks import cases, odd_files, reports, room  # noqa: E402

TREE = Path(__file__).resolve().parents[3]
SEED = "20151104"
SECONDS = 3600  # for the whole class, once, however busy the machine is
KINDS = ["bubblewrap", "landlock"]
FLAGS = ["CC", "CFLAGS", "CPPFLAGS", "LDFLAGS", "WERROR", "CI"]  # with others, all would be built again
NOT_BUILT_FOR_GRADING = shutil.ignore_patterns("replay", "generated", "tmp", "work", "log", "sanitize-*", "*.gz",
                                               "*.zip")
NO_SANDBOX = b"no sandbox here"
counts = {"passed": 0, "failed": 0}


def check(sentence: str, complaints: list) -> None:
    counts["failed" if complaints else "passed"] += 1
    if complaints:
        print(f"not ok: {sentence}")
        for complaint in complaints[:8]:
            print(f"    {complaint}"[:600].encode("ascii", "backslashreplace").decode())
        sys.stdout.flush()


def copy_of_the_tree(tree: Path, secrets: dict) -> None:
    """As its users have it, but for secrets in what no student may see."""
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=TREE,
                           capture_output=True, check=True).stdout
    for name in filter(None, names.decode().split("\0")):
        if (TREE / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(TREE / name, tree / name)
    # With what is built already: make builds again what the secrets change.
    if (TREE / "build").is_dir():
        shutil.copytree(TREE / "build", tree / "build", symlinks=True, ignore=NOT_BUILT_FOR_GRADING)
        (tree / "build/grading/commands").unlink(missing_ok=True)   # it names places of the other tree
    for part in ("solutions", "tests"):
        for path in (tree / part).glob("0*.c"):
            path.write_text(odd_files.with_canary(path.read_text(), secrets[part]))


def grade(places: dict, kind: str, home_secret: str) -> dict:
    """Runs the grader on what is in the class's folder now."""
    shutil.rmtree(places["OUT"], ignore_errors=True)
    environment = {"PATH": os.environ["PATH"], "HOME": str(places["HOME"]), "LANG": "C.UTF-8", "SANDBOX": kind,
                   "HOSTILE_CANARY": home_secret}
    if kind == "none":
        environment["UNSAFE"] = "1"
    environment.update({name: os.environ[name] for name in FLAGS if name in os.environ})
    command = ["make", "--no-print-directory", "grade", f"SUBMISSIONS={places['SUBMISSIONS']}", f"OUT={places['OUT']}",
               f"SEED={SEED}", f"POLICY={places['SCRATCH'] / 'policy'}"]
    policy = (TREE / "tests/grade/policy").read_text().replace("judge points", "judge all")  # also what earns nothing
    (places["SCRATCH"] / "policy").write_text(policy)
    return room.run(command, places["TREE"], environment, SECONDS, places["SCRATCH"] / "log")


def check_run(kind: str, done: dict, places: dict, count: int, secrets: dict) -> bool:
    out = places["OUT"]
    check(f"{kind}: the grader comes to its end, and says that all is done",
          [] if done["status"] == 0 else [f"status {done['status']}", done["words"][-900:].decode("utf-8", "replace")])
    check(f"{kind}: no process is left", [f"left: {', '.join(done['left'])}"] if done["left"] else [])
    check(f"{kind}: no secret, and no byte that acts, is in anything written or printed",
          reports.leaked(out, done["words"], secrets))
    check(f"{kind}: no line of the output is a student's", reports.forged_lines(done["words"]))
    there = len(reports.results(out))
    check(f"{kind}: exactly one result per submission", [] if there == count else [f"{there} results of {count}"])
    if done["status"] == 0:
        check(f"{kind}: every report is read as it is meant", reports.forged(out, count))
    return there > 0


def check_records(kind: str, out: Path, wanted: dict, odd: int, prototypes: dict) -> None:
    results = {reports.record_of(result)["submission"]: result for result in reports.results(out)}
    for name, expected in wanted.items():
        result = results.pop(name, None)
        check(f"{kind}: {name}", ["no result"] if result is None else
              reports.about(reports.record_of(result), expected))
    right = cases.Expected({"graded"}, set(prototypes["03-screen"]))
    for name, result in results.items():
        check(f"{kind}: odd name {name}", reports.about(reports.record_of(result), right))
    check(f"{kind}: every odd name has a result of its own",
          [] if len(results) == odd else [f"{len(results)} results of {odd}"])


def left_behind(scratch: Path) -> list:
    """The attacks use one name for every file that they should not be able to write."""
    return [path for place in ("/tmp", "/var/tmp", "/dev/shm", scratch)
            for path in sorted(Path(place).glob("hostile-was-here*"))]


def has_no_sandbox(kind: str, done: dict, out: Path) -> bool:
    if NO_SANDBOX not in done["words"]:
        return False
    print(f"skipped {kind}: not to be had here")
    check(f"{kind}: without a sandbox nothing is graded", [str(path) for path in out.glob("*/*")])
    check(f"{kind}: and the grader says so", [] if done["status"] != 0 else ["exit status 0"])
    return True


def records_without_times(out: Path) -> dict:
    """submission -> what it got"""
    return {reports.record_of(result)["submission"]: reports.without_times(result) for result in reports.results(out)}


def check_kind(kind: str, places: dict, honest: dict, prototypes: dict, secrets: dict, parts: list) -> None:
    submissions, out = places["SUBMISSIONS"], places["OUT"]
    shutil.rmtree(submissions, ignore_errors=True)
    submissions.mkdir()
    if parts:
        grade(places, kind, secrets["the environment"])     # there is nobody yet: only builds what is not built

    def is_wanted(name: str) -> bool:
        return not parts or name == "honest" or any(part in name for part in parts)

    def hand_in(those: dict) -> dict:
        """name -> what must come of it"""
        those = {name: one for name, one in those.items() if is_wanted(name)}
        for name, (files, _) in those.items():
            odd_files.lay(submissions / name, files)
        return {name: expected for name, (_, expected) in those.items()}

    wanted = hand_in(odd_files.honest_ones(honest, prototypes, secrets[reports.CLASSMATE_S]))
    alone = {}
    if not parts:
        done = grade(places, kind, secrets["the environment"])
        if has_no_sandbox(kind, done, out):
            return
        if not check_run(f"{kind}, honest alone", done, places, len(wanted), secrets):
            return
        check_records(f"{kind}, honest alone", out, wanted, 0, prototypes)
        alone = records_without_times(out)

    wanted.update(hand_in({**cases.build(honest, prototypes, places, is_wanted), **odd_files.hostile(honest, prototypes, places)}))
    for name in [] if parts else odd_files.ODD_NAMES:     # each with one answer, which is right
        odd_files.lay(submissions / os.fsdecode(name), {odd_files.SCREEN: honest["03-screen"].encode()})
    # In the tree itself other tests build meanwhile, but not what grading uses.
    busy = TREE / "build" if places["TREE"] == TREE else None
    watched = [places["TREE"], *([busy / "grading"] if busy else []), submissions, places["HOME"]]
    before = room.picture_of(watched, busy)
    done = grade(places, kind, secrets["the environment"])
    after = room.picture_of(watched, busy)
    count = len(os.listdir(submissions))
    if has_no_sandbox(kind, done, out) or not check_run(kind, done, places, count, secrets):
        return
    check_records(kind, out, wanted, 0 if parts else len(odd_files.ODD_NAMES), prototypes)
    together = records_without_times(out)
    if alone:
        check(f"{kind}: the honest have the marks and the words that they have alone",
              [f"{name}: {reports.first_difference(result, together.get(name))}" for name, result in alone.items()
               if together.get(name) != result])
    check(f"{kind}: nothing outside {out.name}/ has changed",
          [os.fsdecode(path) for path in sorted(before.keys() | after.keys()) if before.get(path) != after.get(path)])
    check(f"{kind}: nothing was left where anybody may write",
          [str(path) for path in left_behind(places["SCRATCH"])])
    check(f"{kind}: nobody called from inside", ["somebody did"] if room.came_in(places["doors"]) else [])
    print(f"{kind}: {count} submissions, {done['seconds']:.0f} s", flush=True)


def main(words: list) -> int:
    room.enter()
    room.adopt_orphans()
    scratch = Path(tempfile.mkdtemp(prefix="hostile-")).resolve()
    try:
        port, doors = room.doors()
        here = os.environ.get("HERE", "") not in ("", "0")
        places = {"TREE": TREE if here else scratch / "tree", "SUBMISSIONS": scratch / "class", "OUT": scratch / "out",
                  "HOME": scratch / "home", "SCRATCH": scratch, "PORT": port, "ESC": "\x1b", "BEL": "\x07",
                  "doors": doors}
        secrets = {what: f"canary-{chance.token_hex(20)}" for what in
                   ("solutions", "tests", reports.CLASSMATE_S, "the home directory", "the environment")}
        places["HOME"].mkdir()
        (places["HOME"] / ".netrc").write_text(f"{secrets['the home directory']}\n")
        honest = {path.stem: path.read_text() for path in sorted((TREE / "solutions").glob("*.c"))}
        if not here:
            copy_of_the_tree(places["TREE"], secrets)
        secrets["the password file"] = "root:x:0:0"
        for kind in [word for word in words if word in [*KINDS, "none"]] or KINDS:
            check_kind(kind, places, honest, exercises.prototypes(exercises.read()), secrets,
                       [word for word in words if word not in [*KINDS, "none"]])
        if os.environ.get("KEEP"):
            subprocess.run(["cp", "-a", "--", scratch, os.environ["KEEP"]], check=False)
    finally:
        room.end_all()
        subprocess.run(["rm", "-rf", "--", *map(str, [scratch, *left_behind(scratch)])], check=True)
    print(f"hostile: {counts['passed']} passed, {counts['failed']} failed")
    return 1 if counts["failed"] or not counts["passed"] else 0


sys.exit(main(sys.argv[1:]))
