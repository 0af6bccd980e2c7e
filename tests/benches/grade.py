"""grade.py - how many submissions a minute make grade marks, and what each step takes of them: of all chapters, and of
the two of a week; then both once more, when nothing has changed; and how equal the work of 1, 2 and 4 tasks is (SHARD).

Usage: grade.py KIT [COUNT], where make builds the kit. A class has COUNT (200) submissions, no two the
same: two thirds of the files are right, the others have a sign or a number changed, or are blank, as half a class's are.
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def slipped(text, chance):
    """One sign or number of one answer is another."""
    start, end = chance.choice([match.span(1) for match in re.finditer(r"// BEGIN SOLUTION\n(.*?)// END SOLUTION", text, re.S)])
    places = list(re.finditer(r"(?<= )[-+*](?= )|\b[0-9]+(?:\.[0-9]+)?\b", text[start:end]))
    if not places:
        return text
    place = chance.choice(places)
    new = {"-": "+", "+": "-", "*": "+"}.get(place[0]) or f"{float(place[0]) + 1:g}"
    return text[:start + place.start()] + new + text[start + place.end():]


def write_class(folder, count, stems):
    chance = random.Random(2015)
    for number in range(count):
        submission = folder / f"student-{number:04d}"
        submission.mkdir(parents=True)
        for path in (Path("solutions", f"{stem}.c") for stem in stems):
            text, kind = path.read_text(), chance.random()
            if kind > 0.9:
                text = Path("build/blanks", path.name).read_text()
            elif kind > 0.67:
                text = slipped(text, chance)
            (submission / path.name).write_text(f"// {number}: {path.stem}\n{text}")


def marked(kit, students, out, *settings):
    """How many seconds it took."""
    began = time.monotonic()
    done = subprocess.run([sys.executable, "-B", "tests/grade", kit, students, "--out", out, *settings],
                          capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)
    return time.monotonic() - began


def shared(kit, students, out, policy, tasks):
    """The seconds of each task, which marks one submission at a time, beside the others."""
    began = time.monotonic()
    running = [subprocess.Popen([sys.executable, "-B", "tests/grade", kit, students, "--out", out, "--policy", policy, "--seed", "1",
                                 "--jobs", "1", "--shard", f"{part}/{tasks}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
               for part in range(1, tasks + 1)]
    seconds = {}
    while len(seconds) < tasks:
        seconds.update((task, time.monotonic() - began) for task in running if task not in seconds and task.poll() is not None)
        time.sleep(0.01)
    if any(task.returncode for task in running):
        sys.exit("a task has failed")
    return seconds.values()


def report(records, seconds, again):
    files = sum(stem["file"] != "" for record in records for stem in record["stems"])
    print(f"{len(records)} submissions, {files} files, {seconds:.1f} s on {len(os.sched_getaffinity(0))} processors, "
          f"sandbox: {records[0]['sandbox']}")
    print(f"  {60 * len(records) / seconds:.0f} submissions a minute; once more, when nothing has changed: {again:.1f} s")
    each = {step: sum(record["steps"][step] for record in records) / len(records) for step in records[0]["steps"]}
    each["the rest"] = sum(record["seconds"] for record in records) / len(records) - sum(each.values())
    for step, mean in each.items():
        print(f"  {step:9} {1000 * mean:6.1f} ms of each")


def main(kit, count="200"):
    stems = sorted(path.stem for path in Path("solutions").glob("*.c"))
    week = stems[2:4]
    for some, words in ((stems, "points others 10\n"),
                        (week, "points others 0\n" + "".join(f"points {stem} 10\n" for stem in week))):
        with tempfile.TemporaryDirectory() as folder:
            students, out, policy = Path(folder, "class"), Path(folder, "out"), Path(folder, "policy")
            policy.write_text(words)
            write_class(students, int(count), some)
            seconds = marked(kit, students, out, "--policy", policy)
            again = marked(kit, students, out, "--policy", policy)
            report([json.loads(path.read_text())["extra_data"]["record"] for path in out.glob("*/results.json")], seconds, again)
            if some is week:
                for tasks in (1, 2, 4):
                    each = shared(kit, students, out.with_name(f"shared-{tasks}"), policy, tasks)
                    print(f"  {tasks} task{'s' * (tasks > 1)} of one job: {min(each):.1f} to {max(each):.1f} s")


main(*sys.argv[1:])
