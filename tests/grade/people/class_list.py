"""class_list.py - the class: submissions, whose they are, and people as an instructor names them."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from grade.collect import submissions
from grade.collect.platforms import Claim
from grade.visible import brief
from .history import members
from .matching import Finder, are_people, assigned, chosen, fits
from .roster import Person, Roster
from .sheets import SheetError


@dataclass(frozen=True)
class ClassList:
    found: list     # submissions; with a list of the class, one for each person on it, then those of nobody on it
    others: list    # names of what is no submission
    people: list    # as decisions and ONLY name them

    def keys(self, words: str) -> list:
        """Of those whom the words fit."""
        return [person.key for person in chosen(words, self.people)]

    def fits(self, words: str) -> str:
        """What is said of words that do not fit exactly one person."""
        return fits(Finder(self.people), chosen(words, self.people), (Claim(name=words),), "of the class")


def class_of(directory: Path, list_of_class: Path | None, stems: list) -> ClassList:
    """SheetError, if the list cannot be read."""
    if list_of_class is None:
        found, others = submissions.find(directory, stems)
        return ClassList(found, others, [Person(one.name, id=one.folder) for one in found])
    roster = Roster(list_of_class)
    found, others = submissions.find(directory, stems, are_people(roster))
    found, more = assigned(found, roster)
    given = [one for one in found if one.parts]
    if len(given) > 1 and not any(one.person for one in given):
        raise SheetError(f"{list_of_class}:1: this list fits none of {len(given)} submissions, expected that of this class, with "
                         f"headings such as name, id, login, mail: it has {brief(', '.join(roster.sheet.heading()))}")
    return ClassList(found, others + more, roster.people + [Person(one.name, id=one.folder) for one in found if not one.person])


def marked_class(out: Path) -> ClassList:
    """The class whose marks are in OUT, as it was when its reports were written last."""
    return ClassList([], [], [Person(**{"name": one["submission"], "id": folder, **one["person"]})
                              for folder, one in members(out).items()])
