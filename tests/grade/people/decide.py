"""decide.py - make grade-set: one more decision in the ledger.

    decide.py, and settings in the environment: WHO, WHAT, VALUE, CHAPTER, COMMENT, BY; OUT, LEDGER, CLASS

Nothing is marked: the next 'make grade' counts it in.
"""
import os
import time
from pathlib import Path

from grade import exercises
from grade.people.matching import ClassList, marked_class
from grade.people.ledger import KINDS, add_decision
from grade.people.roster import Roster
from grade.people.sheets import SheetError
from grade.settings import stop
from grade.visible import why


def main() -> None:
    who, what, value, chapter, comment, by = (os.environ.get(name, "") for name in
                                              ("WHO", "WHAT", "VALUE", "CHAPTER", "COMMENT", "BY"))
    out = Path(os.environ.get("OUT") or "build/grades")
    path = Path(os.environ.get("LEDGER") or out / "ledger.csv")
    if not who or not what:
        stop("who, and what? Say: make grade-set WHO=anna WHAT='extra days' VALUE=2 COMMENT='ill' BY=me; "
             f"WHAT is one of: {', '.join(KINDS)}")
    try:
        roster = os.environ.get("CLASS")
        people = ClassList([], [], Roster(Path(roster)).people) if roster else marked_class(out)
        if not people.people:
            stop(f"OUT={out} holds no marks yet, so nobody is known: mark the class first, or say CLASS=list.csv")
        line = add_decision(path, [who, chapter, what, value, comment, by, time.strftime("%Y-%m-%d")],
                            exercises.stems(exercises.read()), people.keys, people.fits)
    except SheetError as error:
        stop(f"nothing is written: {error}")
    except OSError as error:
        stop(f"{error.filename}: {why(error)}")
    print(f"{path}, line {line}: the next 'make grade' counts it in.")


main()
