"""lecture.py - reads a lecture: a text file with a title, then parts, slides and what is on them.

    TITLE                         of the lecture; the lines below it are its author and lecturer
    == PART
    = TITLE OF A SLIDE
    name: NAME                    its address
    minutes: NUMBER
    exercise: 05 hit_sphere       what practises it
    figure: NAME [STEP] [below]   beside the words, or below them; from its first step, or another one on
    picture: FILE.png [FILE.png] [below]
    film: NAME                    of 'make animations'; only a page shows it
    ask: FUNCTION                 what else it shows is the first question to the class about that function ('make questions')
    added                         the deck does not have it
    code                          for phones: the address of its figure on the site, if make is told ADDRESS
    - words                       items, a line each: "- " and "  - " of a list, "? " a question, "! " an answer,
                                  "$$ formula $$", code after four spaces, all other lines are text
    then [STEP]                   the slide goes on; and its figure, if STEP is given
    answer [STEP]                 the same, and from here on the slide shows its answer
    notes                         what only the lecturer sees: paragraphs, a line each

In all words: $mathematics$, `code`, *emphasis*, **more**, <address>, and [[name]], a number of the lecture (numbers.c).
"""
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "lessons"))
from fill import as_latex, in_formulas

KEYS = ("name", "minutes", "exercise", "figure", "picture", "film", "ask")
# How a paragraph of the notes may begin, and how it is shown.
LABELS = ("Ask", "The deck leaves out", "Our correction")


PIECES = re.compile(r"(?P<math>\$[^$]*\$)|`(?P<code>[^`]*)`|\*\*(?P<bold>.*?)\*\*|\*(?P<emph>.*?)\*|<(?P<url>https?:[^>]*)>"
                    r"|\"(?P<quote>.*?)\"|(?P<letter>.)")


def in_pieces(text, writers):
    """Words in another language: each piece as the writer of its kind has it."""
    return PIECES.sub(lambda found: writers[found.lastgroup](found[found.lastgroup]), text)


class Wrong(Exception):
    """With a message: where, what, what was expected."""


@dataclass
class Item:
    kind: str  # text, bullet, question, answer, formula or code
    level: int
    text: str


@dataclass
class Page:
    """What a slide shows more than the page before it, and the step of its figure."""
    step: int
    answers: bool
    items: list = field(default_factory=list)


@dataclass
class Slide:
    part: str
    title: str
    line: int
    name: str = ""
    minutes: int = 0
    exercise: str = ""
    figure: str = ""
    picture: str = ""
    film: str = ""
    ask: str = ""
    below: bool = False
    added: bool = False
    code: bool = False
    number: int = 0
    pages: list = field(default_factory=lambda: [Page(1, False)])
    notes: list = field(default_factory=list)  # pairs: how it begins, and the words

    def items(self, count):
        """All that the first so many pages show."""
        return [item for page in self.pages[:count] for item in page.items]

    def unanswered(self):
        """How many of its pages come before its answer."""
        return next((i for i, page in enumerate(self.pages) if page.answers), len(self.pages))

    def most(self, items_of):
        """The words of the page that has most of them; items_of(count) are those of a page."""
        return max((items_of(count + 1) for count in range(len(self.pages))),
                   key=lambda items: sum(len(item.text) + 40 for item in items))

    def practised_by(self):
        """The exercise, as a slide's lower edge says it."""
        one = re.fullmatch(r"(\d\d) (\w+(?:, \w+)*)", self.exercise)
        return f"Exercise {one[1]}: {one[2]}" if one else f"Exercises {self.exercise}" if self.exercise else ""

    def place_on_site(self):
        return f"figures.html#{self.figure}" if self.figure else "index.html"

    def asks(self):
        return any(item.kind == "question" for item in self.items(self.unanswered()))


@dataclass
class Lecture:
    title: str
    about: dict
    slides: list

    def parts(self):
        return list(dict.fromkeys(slide.part for slide in self.slides))


class Reader:
    def __init__(self, path, numbers, questions):
        self.path, self.numbers, self.questions, self.line = path, numbers, questions, 0
        self.part, self.slides, self.in_notes = "", [], False

    def wrong(self, words):
        return Wrong(f"{self.path}:{self.line}: {words}")

    def filled(self, text):
        def number(found):
            if self.numbers is None:
                return found[1]
            if found[1] not in self.numbers:
                raise self.wrong(f"no number has the name '{found[1]}', expected one of {' '.join(sorted(self.numbers))}")
            return self.numbers[found[1]]
        text = re.sub(r"\[\[(\w+)\]\]", number, text)
        if text.count("$") % 2:
            raise self.wrong("a formula does not end: expected one more $")
        return in_formulas(text)

    def head(self, slide, line):
        """Takes a line of a slide's head; False if it is not one."""
        key, _, value = line.partition(": ")
        if line in ("added", "code"):
            setattr(slide, line, True)
        elif key in KEYS and not slide.items(1) and len(slide.pages) == 1:
            if key == "minutes" and not value.isdigit():
                raise self.wrong(f"minutes: {value}: expected a number")
            if key in ("figure", "picture"):
                found = re.fullmatch(r"(\S+?(?: \S+\.png)?)(?: (\d+))?( below)?", value)
                if not found:
                    raise self.wrong(f"{key}: {value}: expected a name, a step if it is not the first, and 'below' if it is below the words")
                value, slide.pages[0].step, slide.below = found[1], int(found[2] or 1), bool(found[3])
            setattr(slide, key, int(value) if key == "minutes" else value)
        else:
            return False
        return True

    def item(self, line):
        for pattern, kind in ((r"( *)- (.*)", "bullet"), (r"()\? (.*)", "question"), (r"()! (.*)", "answer"),
                              (r"()\$\$ (.*) \$\$", "formula"), (r"    ( *)(.*)", "code"), (r"()(.*)", "text")):
            found = re.fullmatch(pattern, line)
            if found:
                spaces = len(found[1])
                text = self.filled(found[2])
                return Item(kind, spaces // (4 if kind == "code" else 2), as_latex(text) if kind == "formula" else text)
        raise AssertionError

    def goes_on(self, slide, line):
        """'then 2' and 'answer 2'."""
        word, _, step = line.partition(" ")
        before = slide.pages[-1]
        if step and int(step) < before.step:
            raise self.wrong(f"{line}: the figure is at step {before.step} already")
        slide.pages.append(Page(int(step or before.step), before.answers or word == "answer"))

    def note(self, line):
        label = next((label for label in LABELS if line.startswith(label + ": ")), "")
        return label, self.filled(line[len(label) + 2:] if label else line)

    def slide_line(self, line):
        slide = self.slides[-1]
        if self.in_notes:
            slide.notes.append(self.note(line))
        elif line == "notes":
            self.in_notes = True
        elif re.fullmatch(r"(then|answer)( \d+)?", line):
            self.goes_on(slide, line)
        elif not self.head(slide, line):
            slide.pages[-1].items.append(self.item(line))

    def check(self, slide):
        self.line = slide.line
        if not re.fullmatch(r"[a-z0-9-]+", slide.name):
            raise self.wrong(f"'{slide.title}' has no name: expected a line 'name: WORD', of small letters, digits and '-'")
        if any(other.name == slide.name for other in self.slides if other is not slide):
            raise self.wrong(f"two slides have the name '{slide.name}'")
        if slide.figure and slide.picture:
            raise self.wrong("a slide has a figure or a picture, not both")

    def put_question(self, slide):
        found = next((each for each in self.questions.slides if each.exercise.endswith(f" {slide.ask}")), None)
        if not found:
            self.line = slide.line
            raise self.wrong(f"ask: {slide.ask}: no question is about it, chapters/mistakes/questions.txt has them")
        for what in ("exercise", "picture", "added", "pages", "notes"):
            setattr(slide, what, getattr(found, what))

    def read(self):
        lines = Path(self.path).read_text(encoding="utf-8").splitlines()
        about, title = {}, lines[0] if lines else ""
        for self.line, line in enumerate(lines[1:], 2):
            if line.startswith("== "):
                self.part = line[3:]
            elif line.startswith("= "):
                self.slides.append(Slide(self.part, line[2:], self.line, number=len(self.slides) + 1))
                self.in_notes = False
            elif line.strip() and self.slides:
                self.slide_line(line)
            elif line.strip():
                key, _, value = line.partition(":")
                about[key] = value.strip()
                if self.numbers is not None:
                    self.numbers[key] = about[key]
        for slide in self.slides:
            self.check(slide)
            if slide.ask and self.questions:
                self.put_question(slide)
        if not self.slides:
            raise Wrong(f"{self.path}: no slide in it, expected lines that begin with '= '")
        return Lecture(title, about, self.slides)


def read(path, numbers=None, questions=None):
    """Without numbers, a number's name stays in its place; without another lecture of questions, those to ask are empty."""
    return Reader(path, numbers, questions).read()
