"""grade - marks a folder of submissions: make grade SUBMISSIONS=dir.

Settings (settings.py), then each submission in a process of its own (mark/), then the reports of the class
from what those wrote (report/). A grader that was stopped goes on where it was, and several (SHARD)
can share the work.
"""
import os
import shutil
import sys
import time
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # there the package is found, from any working directory

from grade.collect import submissions  # noqa: E402 - found from there on
from grade.mark.crew import alone, mark_all, of_shard  # noqa: E402
from grade.mark.grader import Grader  # noqa: E402
from grade.mark.lecture_figures import lecture_figures  # noqa: E402
from grade.people.matching import class_of  # noqa: E402
from grade.people.history import members, remember  # noqa: E402
from grade.people.ledger import check_marks, read_ledger, stem_named  # noqa: E402
from grade.people.sheets import SheetError  # noqa: E402
from grade.policy import came_in, names_in_times  # noqa: E402
from grade.report import files, text  # noqa: E402
from grade.report.points import FAILED, NOTHING  # noqa: E402
from grade.settings import arguments, remember as remember_settings, remembered, stop  # noqa: E402
from grade.visible import visible, why  # noqa: E402


def mention(found: list, others: list, stems: list, folder) -> None:
    answers = [name for name in others if name in [f"{stem}.c" for stem in stems]]
    if answers and all(submission.kind == "file" for submission in found if submission.parts):
        stop(f"{folder} holds {answers[0]} itself: it is one submission. Name the folder that it lies in.")
    if not found:
        stop(f"{folder} holds no submission")
    for name in answers:
        print(f"{name} lies loose in {folder}: put it into a folder of its owner's", file=sys.stderr)
    if set(others) - set(answers):
        print(f"Not submissions: {', '.join(name for name in others if name not in answers)}", file=sys.stderr)


def mention_times(policy, found: list) -> None:
    if policy.times is None:
        return
    known = {name for submission in found for name in names_in_times(submission)}
    for name in sorted(set(policy.times) - known):
        print(f"No submission is called {visible(name)}, whose time is given", file=sys.stderr)
    without = [submission.name for submission in found if submission.parts and came_in(policy, submission, None) is None]
    if without:
        print(f"Without a time, taken as on time: {', '.join(without)}", file=sys.stderr)


def with_the_others(found: list, known: dict, given) -> list:
    """The class of OUT, of which some are marked again: those of these submissions, and the others as they are."""
    here = {submission.folder for submission in found if submission.parts}
    gone = [folder for folder in known if folder not in here and known[folder]["status"] != NOTHING]
    if not given.only:
        if gone and len(gone) > len(here):
            stop(f"OUT={given.out} holds the marks of {len(gone)} others, and they are not in {given.submissions}. "
                 f"To mark one of them again, say who: ONLY={found[0].name if found else 'NAME'}; for another class, take another OUT")
        return found
    return [submissions.Submission(known[one.folder]["submission"], one.folder, (), one.claims, one.person, one.unlisted, True)
            if one.folder in gone else one for one in found] + \
        [submissions.Submission(known[folder]["submission"], folder, (), is_elsewhere=True)
         for folder in gone if folder not in {one.folder for one in found}]


def mark_again(grader: Grader, found: list, class_list, given) -> list:
    """Those that ONLY names, or all; and what is marked though there is a verdict."""
    keys = class_list.keys(given.only)
    todo = [submission for submission in found if submission.parts]
    if given.ex:
        stem = stem_named(given.ex, grader.asked)
        if stem is None:
            stop(f"EX={given.ex}: expected a chapter that has points: {', '.join(grader.asked)}")
        grader.again, grader.again_stems = None, [stem]
    if given.only:
        todo = [submission for submission in todo if submission.key in keys]
        if len(keys) != 1 or not todo:
            stop(f"ONLY={given.only}: " + ("this person handed in nothing" if len(keys) == 1 else class_list.fits(given.only)))
        last = remembered(given.out).get("submissions")
        if last is not None and last != given.submissions.resolve():
            print(f"Put this into {last} as well: when the whole class is marked, what is there counts", file=sys.stderr)
        grader.again = {submission.folder for submission in todo}
    return todo


def grade() -> int:
    given = arguments()
    try:
        grader = Grader(given)
        class_list = class_of(given.submissions, given.roster, grader.stems)
        grader.ledger = read_ledger(given.ledger, grader.stems, class_list.keys, class_list.fits)
        check_marks(given.ledger, grader.ledger, grader.points_of())
    except SheetError as error:
        stop(str(error))
    mention(class_list.found, class_list.others, grader.stems, given.submissions)
    mention_times(grader.policy, class_list.found)
    found = with_the_others(class_list.found, members(grader.out), given)
    now = mark_again(grader, found, class_list, given)
    todo = of_shard(now, given.shard)
    began = time.monotonic()
    try:
        lock = alone(grader.work)
        grader.begin()
    except OSError as error:
        stop(f"OUT={given.out} cannot be written: {why(error)}")
    if sys.stderr.isatty():
        print("Marking the reference first ...", file=sys.stderr)
    try:
        grader.make_tables()
        grader.prove()
        failed = mark_all(grader, todo, given.jobs)
        return report(grader, found, now, todo, failed, given, began)
    finally:
        shutil.rmtree(grader.work, ignore_errors=True)
        lock.close()


def refuse_another_week(records: list, before: dict, grader: Grader, given) -> None:
    """Marks that there were, and now not one file of the chapters that count: nobody wants that."""
    if any(member["score"] for member in before.values()) and not any(
            stem["state"] != "missing" for record in records for stem in record["stems"]):
        stop(f"no submission in {given.submissions} has a file of {', '.join(grader.asked)}: is it another week's? The class's reports in "
             f"OUT={given.out} are left as they were; the right folder marks all again")


def report(grader: Grader, found: list, now: list, todo: list, failed: dict, given, began: float) -> int:
    """The exit status. now: those that are marked by this run or another shard's; todo: by this one."""
    marked = {submission.folder for submission in now}
    records = [failed.get(submission.folder)
               or (grader.record if submission.folder in marked else grader.without_marking)(submission)
               for submission in found]
    missing = records.count(None)
    if missing:
        print(f"{missing} of {len(found)} submissions have no result yet: when all are marked, 'make grade' once more, "
              f"without {'SHARD' if given.shard else 'ONLY'}, writes the reports.")
        print(text.failures(records), end="")
        return 0 if given.shard and not failed else 1
    refuse_another_week(records, members(grader.out), grader, given)
    print(text.closing(records))
    try:
        figures = lecture_figures(grader, records)
        if not given.only and not given.ex:
            remember_settings(given)
        files.write_class(records, str(grader.out), remember(records, grader.out), figures)
    except OSError as error:
        stop(f"the reports cannot be written to {given.out}: {error.strerror}")
    print(f"Took {time.monotonic() - began:.1f} s. Reports: {given.out}/index.html")
    return 1 if any(record["status"] == FAILED for record in records) else 0


def main() -> int:
    """The exit status. Whatever this machine cannot do is one sentence."""
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.reconfigure(errors="backslashreplace")
    try:
        status = grade()
        print(end="", flush=True)
        return status
    except KeyboardInterrupt:
        print("\ngrade: stopped; what is done is kept. The same command does the rest.", file=sys.stderr)
        return 130
    except OSError as error:
        # Python would try to print the rest again when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        stop(f"{error.filename or 'its output'}: {why(error)}")
    except UnicodeError as error:
        stop(f"a file of the grader's is not text: {why(error)}")


sys.exit(main())
