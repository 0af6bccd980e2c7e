"""matching.py - the class: its submissions, whose each is by the list of the class, and people as an instructor names them.
Nothing is guessed.

A platform's own number decides, then an id, a login, an address, at last a name; each must be exactly one person's. So
somebody who was renamed is found by the number, and two people of one name are told apart or both left alone.
Everyone on the list has one submission: what several entries hold together, or nothing. What fits nobody, or two, stays
a submission of its own, with the names that come closest.
"""
from __future__ import annotations

import difflib
import re
import unicodedata
from collections import defaultdict
from dataclasses import dataclass, replace
from pathlib import Path

from grade.collect import names, submissions
from grade.collect.archives import suffix_of
from grade.collect.platforms import Claim
from grade.collect.submissions import Submission
from grade.visible import brief, spelled
from .history import members
from .roster import Person, Roster
from .sheets import SheetError

NEAREST = 3     # that are named


def plain(text: str) -> str:
    """Without capitals, and with one blank for whatever separates words."""
    text = unicodedata.normalize("NFKC", text).casefold()
    return re.sub(r"[\W_]+", " ", text).strip()


def joined(name: str) -> set:
    """Canvas writes 'Jane van Doe' as vandoejane: the words of a name, begun at any of them, without blanks."""
    words = plain(name).split()
    return {"".join(words[at:] + words[:at]) for at in range(len(words))}


def without_suffix(text: str) -> str:
    return text.removesuffix(suffix_of(text))


class Finder:
    """Finds people by what is said of them."""

    def __init__(self, people: list):
        self.people = people
        self.by: dict = {field: defaultdict(list) for field in ("number", "id", "login", "mail", "github", "name", "text")}
        for person in people:
            for field in ("number", "id", "login", "mail", "github"):
                if value := getattr(person, field):
                    self.by[field][value.casefold()].append(person)
            for word in {plain(person.name), *joined(person.name)}:
                self.by["name"][word].append(person)
            texts = {plain(text) for text in (person.id, person.login, person.mail, person.mail.split("@")[0], person.github,
                                              person.key)}
            for word in (texts | {plain(person.name), *joined(person.name)}) - {""}:
                self.by["text"][word].append(person)

    def of(self, field: str, *values: str) -> list:
        """Those whom the first of these values fits that fits anybody."""
        return next((found for value in values if value and (found := self.by[field].get(value))), [])

    def by_text(self, text: str) -> list:
        """Of a folder or a file that its owner has named; a clone is called ASSIGNMENT-GITHUB."""
        text = without_suffix(text)
        found = self.of("text", plain(text)) or self.of("text", *joined(text))
        if not found:
            ends = [name for name in self.by["github"] if text.casefold().endswith("-" + name)]
            found = self.of("github", max(ends, key=len, default=""))
        return found

    def find(self, claim: Claim) -> list:
        if claim.text:
            return self.by_text(claim.text) or self.by_text(claim.text.rpartition(".")[0])
        for field, values in (("number", (claim.number,)), ("id", (claim.id,)), ("login", claim.login), ("mail", (claim.mail,))):
            found = self.of(field, *(value.casefold() for value in values))
            if found or (field == "number" and claim.number and self.by["number"]):
                return found    # where the list has the platform's numbers, a name does not overrule them
        return self.of("name", plain(claim.name), *joined(claim.name))

    def nearest(self, claim: Claim) -> list:
        """The names that come closest, for a person to decide."""
        said = plain(without_suffix(claim.text) or claim.name or " ".join(claim.login))
        known = {word: person for word, found in self.by["text"].items() for person in found}
        close = difflib.get_close_matches(said, known, n=3 * NEAREST, cutoff=0.6)
        return list(dict.fromkeys(known[word].name for word in close))[:NEAREST]


def fits(finder: Finder, people: list, claims: tuple, of: str) -> str:
    """What is said of claims that do not fit exactly one person: these, or nobody."""
    if people:
        return f"fits {len(people)} people: {', '.join(f'{brief(one.name)} ({brief(one.key)})' for one in people[:NEAREST])}"
    near = list(dict.fromkeys(name for claim in claims for name in finder.nearest(claim)))[:NEAREST]
    return f"fits nobody {of}" + (f"; closest: {', '.join(map(brief, near))}" if near else "")


def why_unlisted(finder: Finder, claims: tuple) -> str:
    people = next((found for claim in claims if len(found := finder.find(claim)) > 1), [])
    return "it " + fits(finder, people, claims, "on the list")


def assigned(found: list, roster: Roster) -> tuple:
    """The class: a submission for each person, in the order of the list, then those that are nobody's; and the names of
    loose files that are none."""
    finder = Finder(roster.people)
    theirs, nobodys, others = defaultdict(list), [], []
    for submission in found:
        owners = [people for claim in submission.claims if len(people := finder.find(claim)) == 1]
        for (person,) in owners:
            theirs[person.key].append(submission)
        if len(owners) == len(submission.claims):
            continue
        if submission.kind == "file" and submission.claims[0].text and not owners:
            others.append(submission.name)
        else:
            nobodys.append(submission)
    titles = roster.titles()
    stored = names.folders([(re.sub("[/\0]", "_", person.key).encode("utf-8", "surrogateescape"), 0) for person in roster.people]
                           + [(submission.folder.encode("utf-8", "surrogateescape"), 0) for submission in nobodys])
    mine = [Submission(spelled(titles[person.key]), folder, tuple(part for one in theirs[person.key] for part in one.parts),
                       person=person) for person, folder in zip(roster.people, stored)]
    return mine + [replace(one, folder=folder, unlisted=why_unlisted(finder, one.claims))
                   for one, folder in zip(nobodys, stored[len(mine):])], others


def are_people(roster: Roster):
    """Whether entries of these names are submissions of people of the list: at least two, and all."""
    finder = Finder(roster.people)
    return lambda raws: len(raws) > 1 and all(len(finder.by_text(names.decoded(raw))) == 1 for raw in raws)


# ---- the class ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class ClassList:
    found: list     # submissions; with a list of the class, one for each person on it, then those of nobody on it
    others: list    # names of what is no submission
    people: list    # as decisions and ONLY name them

    def keys(self, words: str) -> list:
        """Of those whom words fit that somebody has typed: an id, a login, an address, a name."""
        return [person.key for person in Finder(self.people).by_text(words)]

    def fits(self, words: str) -> str:
        """What is said of words that do not fit exactly one person."""
        finder = Finder(self.people)
        return fits(finder, finder.by_text(words), (Claim(name=words),), "of the class")


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
