"""judging.py - what the judge finds of a submission's programs, under the rule for faults of this machine; and who has
marks though it fails, because it calls another one that is wrong: 'Waiting' in trust.md.

A function that failed and calls an earlier one that failed is judged again, with the reference lent for that
other one.
"""
from __future__ import annotations

from grade.confine.machine import GraderFailed, believed
from grade.exercises import stems as chapters

from .building import is_refused, linked
from .commands import DONE, RIGHT, Command
from .workbench import Workbench

# How an answering process can end by a fault of this machine. A fault does not make a wrong value.
DOUBTFUL = {"crashed", "timed out"}


def is_doubtful(functions: dict[str, dict[str, str]]) -> bool:
    return any(found["state"] in DOUBTFUL for found in functions.values())


def again(bench: Workbench, stem: str, command: Command) -> int:
    """The exit status, between two judgements of the reference. There is none while the reference itself is judged."""
    if stem not in bench.right:
        return bench.judge([command])[command.name]
    (bench.folder / f"{RIGHT}{stem}.o").write_bytes(bench.right[stem])
    (bench.folder / f"{RIGHT}{stem}.d").mkdir(exist_ok=True)
    if bench.link([bench.kit.link(stem, RIGHT)])[stem] != DONE:
        raise GraderFailed("the linker refuses the reference")
    status = bench.sandwich(bench.judge, bench.kit.judge(stem, RIGHT), command)
    (bench.folder / f"{RIGHT}{stem}.exe").unlink()
    (bench.folder / f"{RIGHT}{stem}.o").unlink()
    return status


def judged(bench: Workbench, names: dict[str, list[str]]) -> dict[str, dict[str, dict[str, str]]]:
    """STEM -> FUNCTION -> KEY -> value. names: STEM -> its functions."""
    def judged_again(stem: str) -> dict[str, dict]:
        again(bench, stem, bench.kit.judge(stem))
        return bench.report(stem, names[stem])

    if not names:
        return {}
    bench.judge([bench.kit.judge(stem) for stem in names])
    return believed({stem: bench.report(stem, names[stem]) for stem in names}, is_doubtful, judged_again)


def passing(bench: Workbench, stem: str, lent: dict[str, list[str]]) -> list[str]:
    """Those that pass if these others are lent to them."""
    commands = {name: bench.kit.judge_lent(stem, name, others) for name, others in lent.items()}
    if not commands:
        return []
    found = believed(bench.judge(list(commands.values())), lambda status: status != DONE,
                     lambda name: again(bench, stem, commands[name]))
    return [name for name, status in found.items() if status == DONE]


# ---- waiting ------------------------------------------------------------------------------------


def is_attempt(found: dict[str, str]) -> bool:
    """Wrong, and in a way that the tests know by name: it does its own work. Anything else may be a placeholder."""
    return found["state"] == "wrong" and "mistake" in found and found.get("partly") != "yes"


def calls_among(functions: dict[str, dict], names: list[str]) -> dict[str, list[str]]:
    """Which of these call which others, as the answering process noted when it was asked (tests/judge/message.h).
    The process is the student's, so this proves nothing: it only says what is worth a try. Two that call each other
    do not excuse each other."""
    calls = {name: set(functions[name].get("calls", "").split()) for name in names}
    return {name: [other for other in names if other != name and other in calls[name] and name not in calls[other]]
            for name in names}


def calls_of(bench: Workbench, exercises: list) -> dict[str, set[str]]:
    """FUNCTION -> those of its chapter that it calls. Of the answers that were marked last: the reference's."""
    found: dict[str, set[str]] = {}
    for stem in chapters(exercises):
        names = [exercise.name for exercise in exercises if exercise.stem == stem]
        calls = calls_among(bench.report(stem, names), names)
        found.update((name, set(others)) for name, others in calls.items())
    return found


def not_right(functions: dict[str, dict]) -> list[str]:
    return [name for name, found in functions.items() if found["state"] != "right"]


def may_wait(functions: dict[str, dict], called: dict[str, set[str]]) -> dict[str, list[str]]:
    """FUNCTION -> those that it may wait for. called: by the reference."""
    failed = [name for name in not_right(functions) if functions[name]["state"] in ("wrong", "waiting")]
    return {name: [other for j, other in enumerate(failed) if j < i or other in called.get(name, ())]
            for i, name in enumerate(failed)}


def lend(bench: Workbench, stem: str, functions: dict[str, dict], may: dict[str, list[str]]) -> dict[str, list[str]]:
    """FUNCTION -> those that it asked for, of the functions that pass if those that it may wait for are lent."""
    if not any(may.values()):
        return {}
    calls = calls_among(functions, not_right(functions))
    called = {name: others for name in may if (others := [other for other in calls[name] if other in may[name]])}
    if not called:
        return {}
    programs = linked(bench, {name: bench.kit.link_lent(stem, name, others) for name, others in called.items()},
                      lambda _: bench.kit.link_blanks(stem))
    ready = [name for name, status in programs.items() if not is_refused(status)]
    good = passing(bench, stem, {name: called[name] for name in ready})
    for name in ready:
        (bench.folder / f"{stem}.{name}.exe").unlink()
    return {name: (bench.folder / f"{name}.asked").read_text().split() for name in good}


def waiting(functions: dict[str, dict], asked: dict[str, list[str]]) -> dict[str, list[str]]:
    """Those that have their marks though they fail: see 'Waiting' in trust.md. Two that wait for each other have
    none: neither is an answer."""
    good: dict[str, list[str]] = {}
    while True:
        more = {name: others for name, others in asked.items() if name not in good and others and
                all(other in good or is_attempt(functions[other]) for other in others)}
        if not more:
            return good
        good.update(more)
