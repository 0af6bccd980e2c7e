"""grade - marks a folder of submissions: make grade SUBMISSIONS=dir.

Each submission is marked by a process of its own, which writes its results whole; whatever becomes of
it, there is one result. What has one already, of the same files, seed, policy and tests, is kept, so a
grader that was stopped goes on where it was, and several (SHARD) can share the work.
"""
import argparse
import fcntl
import hashlib
import os
import resource
import secrets
import shutil
import signal
import sys
import time
import traceback
from pathlib import Path

from collect import submissions
import exercises as table
from marking import Bench, mark, read_kit
import policy as policies
from report import files, text
from sandbox import choose

MOST_SECONDS = 600      # for one submission, whatever happens
COLLECT_MEMORY = 2 << 30
COLLECT_SECONDS = 60
DONE, KEPT = 0, 3       # exit statuses of the process that marks


def arguments() -> argparse.Namespace:
    there = os.environ.get
    parser = argparse.ArgumentParser(prog="grade.py", description="Marks a folder of submissions.")
    parser.add_argument("kit", type=Path)
    parser.add_argument("submissions", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--policy", type=Path, default=policies.DEFAULT)
    parser.add_argument("--seed", default=there("SEED", ""))
    parser.add_argument("--jobs", default=there("JOBS", ""))
    parser.add_argument("--shard", default=there("SHARD", ""))
    parser.add_argument("--sandbox", default=there("SANDBOX", ""))
    parser.add_argument("--unsafe", action="store_true", default=there("UNSAFE", "") not in ("", "0"))
    given = parser.parse_args()
    given.jobs = number("JOBS", given.jobs, 1, 1024) if given.jobs else len(os.sched_getaffinity(0))
    given.shard = shard(given.shard) if given.shard else None
    given.seed = number("SEED", given.seed, 0, 2**63 - 1) if given.seed else None
    return given


def stop(words: str) -> None:
    raise SystemExit(f"grade: {words}")


def number(name: str, text: str, least: int, most: int) -> int:
    if not (text.isascii() and text.isdigit()) or not least <= int(text) <= most:
        stop(f"{name}={text}: expected a whole number from {least} to {most}")
    return int(text)


def shard(text: str) -> tuple[int, int]:
    part, _, parts = text.partition("/")
    n = number("SHARD", parts or "x", 1, 10000)
    return number("SHARD", part, 1, n), n


def the_seed(out: Path, wanted: int | None) -> int:
    """That of this class: the first grader draws it, and all others, later or elsewhere, take it."""
    path = out / ".seed"
    if wanted is None and path.exists():
        return number(str(path), path.read_text().strip(), 0, 2**63 - 1)
    seed = secrets.randbelow(2**63) if wanted is None else wanted
    new = path.with_suffix(f".{secrets.token_hex(6)}")
    new.write_text(f"{seed}\n")
    try:
        if wanted is None:
            os.link(new, path)      # fails where another was first
        else:
            os.replace(new, path)
    except FileExistsError:
        return the_seed(out, None)
    finally:
        new.unlink(missing_ok=True)
    return seed


def sum_of_files(paths: list[Path]) -> str:
    total = hashlib.sha256()
    for path in paths:
        total.update(path.read_bytes())
    return total.hexdigest()


# ---- one submission -----------------------------------------------------------------------------

class Grader:
    """What does not change from one submission to the next."""

    def __init__(self, given: argparse.Namespace):
        self.out = given.out.resolve()
        self.exercises = table.read()
        self.stems = table.stems(self.exercises)
        self.policy = policies.load(given.policy, self.exercises)
        self.kit = read_kit(given.kit.resolve())
        self.sandbox = choose(given.kit.resolve() / "confine", given.sandbox, given.unsafe)
        self.out.mkdir(parents=True, exist_ok=True)
        self.seed = the_seed(self.out, given.seed)
        part, parts = given.shard or (1, 1)
        self.work = self.out / ".work" / f"{part}-of-{parts}"
        judges = sorted(path for path in self.kit.judges.iterdir() if path.name in self.stems)
        self.tests = sum_of_files([given.policy, table.TABLE, *judges,
                                   *sorted((self.kit.folder / "link").iterdir()),
                                   self.kit.folder / "commands", *([Path(self.sandbox.confine)] if self.sandbox.confine else [])])

    def key(self, collected) -> str:
        """Changes with everything that the marks depend on."""
        parts = [submissions.digest(collected), str(self.seed), self.tests, self.sandbox.name]
        if self.policy.due is not None:
            parts.append(str(collected.when))
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def results(self, submission) -> Path:
        return self.out / submission.folder / "results.json"

    def record(self, submission) -> dict | None:
        try:
            return files.read_record(str(self.results(submission)))
        except (OSError, ValueError):
            return None

    def collect(self, submission):
        """Hostile archives get less memory and time than this process has."""
        limits = {resource.RLIMIT_AS: COLLECT_MEMORY, resource.RLIMIT_CPU: COLLECT_SECONDS}
        before = {what: resource.getrlimit(what) for what in limits}
        for what, most in limits.items():
            hard = before[what][1]
            resource.setrlimit(what, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))
        try:
            return submissions.collect(submission, self.stems)
        finally:
            for what, limit in before.items():
                resource.setrlimit(what, limit)

    def mark(self, submission) -> int:
        """In a process of its own."""
        began = time.monotonic()
        collected = self.collect(submission)
        key = self.key(collected)
        old = self.record(submission)
        if old is not None and old.get("key") == key:
            return KEPT
        bench = Bench(self.kit, self.sandbox, self.work / submission.folder, self.seed)
        record = mark(bench, collected, self.exercises,
                      lambda stem, name: policies.points(self.policy, stem, name))
        when = policies.came_in(self.policy, submission, collected)
        record["score"], record["late"] = policies.late(self.policy, when, record["score"])
        record.update(key=key, submission=submission.name, folder=submission.folder,
                      seconds=round(time.monotonic() - began, 2))
        place = self.results(submission).parent
        place.mkdir(exist_ok=True)
        for name, source in (("expected.png", self.kit.folder), ("yours.png", bench.folder)):
            if name in record["pictures"].values():
                shutil.copyfile(source / name, place / name)
            else:
                (place / name).unlink(missing_ok=True)
        self.write(submission, record)
        shutil.rmtree(bench.folder, ignore_errors=True)
        return DONE

    def write(self, submission, record: dict) -> None:
        files.write_submission(record, str(self.results(submission).parent))

    def give_up_on(self, submission, status: str, words: str) -> None:
        """Where the process that marks did not come to its end."""
        stems = [{"stem": stem, "file": "", "state": "not judged", "words": words, "functions": [], "score": 0,
                  "max": sum(policies.points(self.policy, stem, exercise.name)
                             for exercise in self.exercises if exercise.stem == stem)} for stem in self.stems]
        self.write(submission, {
            "submission": submission.name, "folder": submission.folder, "status": status, "words": words, "score": 0,
            "max": sum(stem["max"] for stem in stems), "late": "", "stems": stems, "pictures": {}, "key": "",
            "seed": self.seed, "sandbox": self.sandbox.name, "unsafe": self.sandbox.unsafe, "seconds": 0})


# ---- all of them ----------------------------------------------------------------------------------

class Progress:
    """A line that is written over where it is a terminal, else a line for each."""

    def __init__(self, total: int):
        self.total, self.done, self.marked, self.began = total, 0, 0, time.monotonic()
        self.terminal = sys.stderr.isatty()

    def say(self, record: dict | None, kept: bool) -> None:
        self.done += 1
        self.marked += not kept
        words = "no result" if record is None else f"{record['status']}, {record['score']:g} of {record['max']:g}"
        name = "" if record is None else record["submission"]
        if self.terminal:
            each = (time.monotonic() - self.began) / max(self.marked, 1)
            left = int(each * (self.total - self.done) + 0.5)
            line = f"{self.done} of {self.total}, {left // 60}:{left % 60:02d} left  {name}: {words}"
            print(f"\r\x1b[K{line[:79]}", end="", file=sys.stderr, flush=True)
        else:
            print(f"{self.done}/{self.total} {name}: {words}{' (kept)' if kept else ''}", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self.terminal and self.total:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def start(grader: Grader, submission) -> int:
    """The process that marks it, with a session of its own, so that all of it can be ended."""
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child:
        return child
    status = 1
    try:
        os.setsid()
        for number_of in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number_of, signal.SIG_DFL)
        status = grader.mark(submission)
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(status)


def end(child: int) -> None:
    for kill in (os.killpg, os.kill):
        try:
            kill(child, signal.SIGKILL)
        except ProcessLookupError:
            pass


def mark_all(grader: Grader, todo: list, jobs: int) -> None:
    progress = Progress(len(todo))
    running: dict[int, tuple] = {}
    waiting = list(reversed(todo))
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                submission = waiting.pop()
                running[start(grader, submission)] = (submission, time.monotonic())
            child, status = os.waitpid(-1, os.WNOHANG)
            if child == 0:
                for late, (_, began) in running.items():
                    if time.monotonic() - began > MOST_SECONDS:
                        end(late)
                time.sleep(0.005)
                continue
            submission, began = running.pop(child)
            code = os.waitstatus_to_exitcode(status)
            if code not in (DONE, KEPT):
                if time.monotonic() - began > MOST_SECONDS:
                    grader.give_up_on(submission, "timed out", f"took more than {MOST_SECONDS} s in all")
                else:
                    grader.give_up_on(submission, "crashed", f"the grader itself ended early ({code}): please report it")
            progress.say(grader.record(submission), code == KEPT)
    finally:
        for child in running:
            end(child)
            os.waitpid(child, 0)
        progress.end()


def of_shard(found: list, part: tuple[int, int] | None) -> list:
    if part is None:
        return found
    mine, parts = part
    return [submission for submission in found
            if int(hashlib.sha256(os.fsencode(submission.folder)).hexdigest(), 16) % parts == mine - 1]


def alone(work: Path):
    """Two graders of one shard would do everything twice."""
    work.mkdir(parents=True, exist_ok=True)
    lock = open(work.parent / f"{work.name}.lock", "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        stop(f"another grader is at work here: {work.parent.parent}")
    shutil.rmtree(work, ignore_errors=True)
    return lock


def main() -> int:
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")
    given = arguments()
    if not given.submissions.is_dir():
        stop(f"SUBMISSIONS={given.submissions}: no such folder")
    try:
        grader = Grader(given)
    except policies.PolicyError as error:
        stop(str(error))
    found, others = submissions.find(given.submissions)
    if others:
        print(f"Not submissions (neither folder nor archive): {', '.join(others[:5])}" +
              (f" and {len(others) - 5} more" if len(others) > 5 else ""), file=sys.stderr)
    todo = of_shard(found, given.shard)
    lock = alone(grader.work)
    began = time.monotonic()
    try:
        mark_all(grader, todo, given.jobs)
    except KeyboardInterrupt:
        print("\ngrade: stopped; what is done is kept. The same command does the rest.", file=sys.stderr)
        return 130
    finally:
        shutil.rmtree(grader.work, ignore_errors=True)
        lock.close()
    records = [grader.record(submission) for submission in found]
    missing = records.count(None)
    if missing:
        print(f"{len(todo)} of {len(found)} submissions are of this shard; {missing} of the class have no result yet.\n"
              "When all shards are done, 'make grade' once more, without SHARD, writes the reports.")
        return 0 if given.shard else 1
    files.write_class(records, str(grader.out))
    print(text.closing(records))
    print(f"Took {time.monotonic() - began:.1f} s. Reports: {given.out}/index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
