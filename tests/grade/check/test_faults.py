"""test_faults.py - what goes wrong on this machine is never a mark, and never kept.

A kit whose compiler, linker and judges fail on purpose for submissions that ask for it; then real kills, a full
disk, and a submission that fills it.
"""
from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from grade.confine.machine import DISK
from grade.confine.sandbox import choose

from .fixtures import Sentences
from .small_class import KIT, STEMS, WAITS, at_work_in, but, gone, grade, processes, records, right, rows, started

HERE = Path(__file__).parent
FAULTY = HERE / "faulty.sh"
FAULTS = ["the compiler is killed", "the step is killed", "the compiler refuses every file", "the linker is killed",
          "the linker refuses every file", "the judge is killed", "the judge gives up",
          "the judge is killed when it lends", "the report is cut", "a header is away",
          "a library is away from when it lends", "every answer crashes"]
PASSING = ["the compiler refuses a file once", "the linker refuses a file once", "an answer crashes once"]
SIGNALS = ["TERM", "HUP", "INT", "KILL"]
FILL = '__asm__(".data\\n.fill 15000000,1,7\\n.text\\n");\n'
NUMBER_OF_FULL = 10     # points of chapter 01
ENDLESS = but("01-corners", "upper_left: for (;;) { }\nupper_right: for (;;) { }\n")


def faulty_kit(work: Path, always: str = "") -> Path:
    """always: what is wrong with the judges, whoever is judged; else answers ask for it."""
    kit = work / "kit"
    shutil.copytree(KIT, kit)
    old, new = Path(KIT).resolve(), kit.resolve()
    lines = (kit / "commands").read_text().replace(str(old), str(new)).splitlines()
    commands = dict(line.split("=", 1) for line in lines)
    picture = new / "picture"       # a folder that the sandbox shows when it judges
    (picture / "real").mkdir()
    shutil.copy(commands["JUDGE"], picture / "real" / "judge")
    shutil.copy(FAULTY, picture / "judge")
    if always:
        (picture / "real" / "fault").write_text(always)
    for place in ("headers", "link"):
        shutil.copy(FAULTY, kit / place)
    commands["JUDGE"] = str(picture / "judge")
    commands["COMPILE"] = f"{new}/headers/{FAULTY.name} compiler {commands['COMPILE']}"
    commands["LINK"] = f"{new}/link/{FAULTY.name} linker {commands['LINK']}"
    (kit / "commands").write_text("".join(f"{key}={value}\n" for key, value in commands.items()))
    return kit


def put(folder: Path, name: str, text: str, stem: str = "01-corners") -> None:
    (folder / name).mkdir(parents=True, exist_ok=True)
    (folder / name / f"{stem}.c").write_text(text)


def largest(folder: Path, stop: threading.Event, seen: list) -> None:
    while not stop.is_set():
        size = 0
        for place, _, names in os.walk(folder):
            for name in names:
                with contextlib.suppress(OSError):
                    size += os.lstat(os.path.join(place, name)).st_blocks * 512
        seen.append(size)
        time.sleep(0.005)


def is_scored_whole_or_not(found: dict, most: float) -> bool:
    return all(record["score"] in (None, most) for record in found.values())


def signalled(at_work: Path, kind: str, number: str) -> bool:
    """Sends the signal to the process of this kind that works in this folder. False if there is none."""
    for process in processes():
        program = Path(process.words[0]).name
        if process.folder != str(at_work):
            continue
        if program == "confine" and process.words[1] == "watch" and kind in ("watch", "grader"):
            one = process.number if kind == "watch" else int(process.status()["PPid"])
        elif kind == program:
            one = process.number
        else:
            continue
        with contextlib.suppress(OSError):
            os.kill(one, signal.Signals[f"SIG{number}"])
            return True
    return False


class Faults(Sentences):
    def test_a_step_that_fails_is_no_mark(self) -> None:
        work = self.work
        folder, out = work / "class", work / "out"
        waits = but("01-corners", WAITS)
        for fault in FAULTS + PASSING:
            put(folder, fault, f"// fault: {fault}\n{waits if 'lends' in fault else right('01-corners')}")
        put(folder, "nothing is wrong", right("01-corners"))
        grade(folder, out)
        first = records(out)
        shutil.copytree(out, work / "again")
        for place in out.glob("*/results.json"):    # as if these were handed in before, and other ones now
            place.write_text(place.read_text().replace('"key": "', '"key": "other '))
        done = grade(folder, out, kit=faulty_kit(work))
        found = records(out)
        for fault in FAULTS:
            record = found[fault]
            self.check(f"{fault}: no score, and the reason",
                       (record["status"], record["score"]) == ("grader failed", None)
                       and record["words"] != "" and record["key"] == "", record)
            self.check(f"{fault}: the last lines say so", f"{fault}: " in " ".join(done.stdout.split()),
                       done.stdout[-900:])
        for fault in [*PASSING, "nothing is wrong"]:
            self.check(f"{fault}: all marks", found[fault]["score"] == NUMBER_OF_FULL, found[fault])
        self.check("the exit status says that somebody has no score", done.returncode == 1, done.returncode)
        self.reports_say_it(out)
        done = grade(folder, out)
        self.check("the next run marks them, and has the marks of one that nothing happened to",
                   done.returncode == 0 and records(out) == first, done.stderr[-500:])

    def reports_say_it(self, out: Path) -> None:
        row = rows(out)[FAULTS[0]]
        self.check("grades.csv: an empty score, not 0", row["status"] == "grader failed" and row["final"] == ""
                   and row["01-corners"] == "", row)
        results = json.loads((out / FAULTS[0] / "results.json").read_text())
        self.check("results.json: neither a score nor a test", {"score", "tests"}.isdisjoint(results), results)
        for name in ("index.html", f"{FAULTS[0]}/index.html", "junit.xml"):
            self.check(f"{name}: grader failed", "grader failed" in (out / name).read_text(encoding="utf-8"))

    def test_the_reference_comes_first(self) -> None:
        work = self.work
        put(work / "class", "anna", right("01-corners"))
        for name, always, words in (
                ("no-judge", "the judge gives up", "the grader fails on the reference"),
                ("a-wrong-verdict", "every verdict is wrong", "the reference (solutions/) does not get all marks")):
            (work / name).mkdir()
            done = grade(work / "class", work / name / "out", kit=faulty_kit(work / name, always))
            self.check(f"{name}: nothing is graded, in words", done.returncode != 0 and words in done.stderr
                       and not list((work / name / "out").glob("*/results.json")), done.stderr[-500:])

    def test_who_fills_the_disk_harms_nobody_else(self) -> None:
        work = self.work
        folder, out = work / "class", work / "out"
        for stem in STEMS:
            put(folder, "hog", f'#include "exercises/{stem}.h"\n{FILL}', stem)
            put(folder, "neighbour", right(stem), stem)
        stop, seen = threading.Event(), []
        watching = threading.Thread(target=largest, args=(out, stop, seen))
        watching.start()
        done = grade(folder, out, JOBS="2")
        stop.set()
        watching.join()
        found = records(out)
        self.check("who fills the disk has no marks, by a limit",
                   found["hog"]["status"] == "does not compile" and "2 MB" in found["hog"]["stems"][0]["words"],
                   found["hog"])
        self.check("the neighbour has all marks", found["neighbour"]["score"] == 100, found["neighbour"]["score"])
        self.check("nobody takes more room than a submission may", max(seen) < DISK, f"{max(seen) >> 20} MB")
        self.check("and that is not a failure", done.returncode == 0, done.stderr[-300:])

    def test_a_full_disk_is_no_mark(self) -> None:
        work = self.work
        namespace = ["unshare", "--mount"] if os.geteuid() == 0 else ["unshare", "--mount", "--map-root-user"]
        if shutil.which("unshare") is None or subprocess.run([*namespace, "true"], capture_output=True).returncode != 0:
            self.skip("a full disk: no name space of mounts here")
            return
        out = work / "out"
        out.mkdir()
        for name in ("anna", "ben", "carl"):
            put(work / "class", name, right("01-corners"))
        for size, whole in (("6m", False), ("300m", True)):
            kept = work / f"kept {size}"
            disk = (f'mount -t tmpfs -o size={size} none "$0" || exit 1; "$@"; status=$?; '
                    f'cp -r "$0" "{kept}"; exit $status')
            done = grade(work / "class", out, *namespace, "sh", "-c", disk, str(out))
            found = records(kept)
            self.check(f"a disk of {size}: all marks or none given",
                       is_scored_whole_or_not(found, NUMBER_OF_FULL) and len(found) == (3 if whole else 0)
                       and (done.returncode == 0) == whole, (done.returncode, done.stderr[-300:], done.stdout[-300:]))

    def kills_leave_nothing(self, work: Path, sandbox: str) -> None:
        work.mkdir()
        kit = faulty_kit(work)
        for number, (fault, program, delay) in enumerate([
                ("the compiler sleeps", "", 0), ("the compiler sleeps", "", 0.03), ("the compiler sleeps", "", 0.3),
                ("the judge sleeps", "", 0.3), ("an endless answer", "answering", 0)]):
            folder, out = work / f"class{number}", work / f"out{number}"
            # Of many endless ones, one is at work when this looks for it, however seldom that is.
            for at in range(50 if program else 1):
                put(folder, str(at), f"// fault: {fault}\n{ENDLESS if program else right('01-corners')}")
            grader = started(folder, out, kit, SANDBOX=sandbox)
            found = []
            while not (found if program else (out / ".work/1-of-1/0").exists()) and grader.poll() is None:
                found = [status for one in processes() if one.folder.startswith(str(out))
                         and Path(one.words[0]).name == program and (status := one.status())]
                time.sleep(0.002)
            rights = [value for status in found for name, value in status.items() if re.match("Cap(Inh|Prm|Eff|Amb)", name)]
            self.check(f"under {sandbox} an answer has no capabilities, also if root grades",
                       bool(rights) == bool(program) and not any(int(value, 16) for value in rights), rights)
            time.sleep(delay)
            was_at_work = grader.poll() is None
            grader.kill()
            grader.communicate()
            self.check(f"{sandbox}, {fault}, killed after {delay} s: nothing is left", was_at_work and gone(out),
                       at_work_in(out))

    def test_a_killed_grader_leaves_nothing(self) -> None:
        kernel = subprocess.run([f"{KIT}/confine", "probe"], capture_output=True, text=True).stdout
        there = {"landlock": "landlock" in kernel, "bubblewrap": shutil.which("bwrap") is not None}
        for sandbox in ("bubblewrap", "landlock"):
            if not there[sandbox]:
                self.skip(f"kills under {sandbox}, which is not to be had here")
                continue
            self.kills_leave_nothing(self.work / sandbox, sandbox)

    def test_a_signal_is_no_mark(self) -> None:
        """To each kind of process that works on a submission, found by the submission's folder."""
        folder, out, kit = self.work / "class", self.work / "out", faulty_kit(self.work)
        view = ["bwrap"] if choose(Path(KIT) / "confine", "", False).bubblewrap else []
        wanted = {}     # submission -> kind of process, signal
        for number in SIGNALS:
            for fault in ("the compiler sleeps", "the judge sleeps"):
                # A shell waits for its command before it ends by SIGINT, and commands have limits.
                for kind in ("grader", "watch", *view, *(["sh"] if number != "INT" else []), "sleep"):
                    name = f"{fault}, SIG{number} to {kind}"
                    put(folder, name, f"// fault: {fault}\n{right('01-corners')}")
                    wanted[name] = (kind, number)
            name = f"SIG{number} to answering"
            put(folder, name, ENDLESS)
            wanted[name] = ("answering", number)
        grader = started(folder, out, kit, JOBS="64")
        until = time.monotonic() + 120
        ended = set()
        while grader.poll() is None and time.monotonic() < until:
            for name, (kind, number) in wanted.items():
                if name not in ended and signalled(out / ".work" / "1-of-1" / name, kind, number):
                    ended.add(name)
            time.sleep(0.01)
        grader.kill()
        said = grader.communicate()[1]
        found = records(out)
        for name in wanted:
            record = found.get(name, {})
            self.check(f"{name}: no score", name in ended and record.get("status") == "grader failed"
                       and record["score"] is None, (name in ended, record, said[-300:]))
        self.check("the exit status says so", grader.returncode == 1, grader.returncode)

    def test_how_a_part_of_the_compiler_ended_is_known(self) -> None:
        for how, status in (("0", 0), ("1", 90), ("4", 94), ("SIGXCPU", 91), ("SIGXFSZ", 92), ("SIGSEGV", 93),
                            ("SIGKILL", 99), ("SIGTERM", 99), ("SIGBUS", 99)):
            ends = f"exit {how}" if how.isdigit() else f"kill -{how[3:]} $$"
            words = [f"{KIT}/confine", "tool", "/bin/sh", "-c", f"ulimit -c 0; {ends}"]
            done = subprocess.run(words, capture_output=True)
            self.check(f"a part of the compiler that ends with {how} is {status}", done.returncode == status,
                       done.returncode)
        done = subprocess.run([f"{KIT}/confine", "tool", "/no/such/program"], capture_output=True)
        self.check("one that cannot be started is not the student's", done.returncode == 99, done.returncode)

    def test_limits_on_processes(self) -> None:
        """As somebody whom they hold for: root has none."""
        who = ["setpriv", "--reuid", "65534", "--clear-groups"] if os.geteuid() == 0 else []
        confine = shutil.copy(f"{KIT}/confine", tempfile.gettempdir())
        try:
            done = subprocess.run([*who, "prlimit", "--nproc=512:512", confine, "compile", "/dev/null", "-", "/", "--",
                                   "/bin/true"], capture_output=True, text=True)
            self.check("a compiler is started where somebody may have 512 processes", done.returncode == 0, done)
            done = subprocess.run([*who, "prlimit", "--as=800000000:800000000", confine, "compile", "/dev/null", "-",
                                   "/", "--", "/bin/true"], capture_output=True, text=True)
            self.check("a hard limit that is too low is named", "ulimit -v" in done.stderr, done)
            for most, status in (("3", 1), ("4000", 0)):
                done = subprocess.run([*who, "prlimit", f"--nproc={most}", confine, "room", "12"],
                                      capture_output=True, text=True)
                self.check(f"room for 12 processes where {most} may be: {status}", done.returncode == status, done)
        finally:
            os.unlink(confine)
