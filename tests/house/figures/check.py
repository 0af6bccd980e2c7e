"""check.py - the checks of figures: how they are counted, and what holds for every figure."""
import re
import sys

from figure import NUMBER, Figure

NEAR = 0.1  # canvas units, that is, pixels of the SVG


def luminance(color):
    """Relative luminance of red, green and blue from 0 to 255, as WCAG 2 defines it."""
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in (c / 255 for c in color)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    dark, light = sorted((luminance(a), luminance(b)))
    return (light + 0.05) / (dark + 0.05)


def color(text):
    """#rrggbb, or rgb(r, g, b)"""
    if text.startswith("#"):
        return [int(text[i:i + 2], 16) for i in (1, 3, 5)]
    return [int(n) for n in re.findall(r"\d+", text)]


class Checks:
    """Counts; the last line is that of every test of the toolkit."""

    def __init__(self, name):
        self.name, self.passed, self.failed = name, 0, 0

    def that(self, what, holds, words=""):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"not ok: {what}" + (f"\n    {words}" if words else ""))

    def near(self, what, got, wanted, within=NEAR):
        """A mark, or a list of marks, is where it belongs."""
        if wanted and isinstance(wanted[0], (int, float)):
            got, wanted = got[:1], [wanted]
        away = [max(abs(a - b) for a, b in zip(g, w)) for g, w in zip(got, wanted)]
        self.that(what, len(got) == len(wanted) and all(d <= within for d in away),
                  f"drawn at {got}, expected {wanted}")

    def same(self, what, got, wanted, within=1e-5):
        """Numbers of the data are these."""
        flat = [x for row in got for x in row] if got and isinstance(got[0], list) else list(got)
        goal = [x for row in wanted for x in row] if isinstance(wanted[0], (list, tuple)) else list(wanted)
        close = len(flat) == len(goal) and all(
            abs(a - b) <= within * max(1, abs(b)) for a, b in zip(flat, goal))
        self.that(what, close, f"data {flat}, expected {goal}")

    def shows(self, figure, *texts):
        """Labels say this, however many spaces they have."""
        labels = [" ".join(words.split()) for words, _, _ in figure.labels()]
        for text in texts:
            self.that(f"a label says {text!r}", text in labels, str(labels))

    def end(self):
        print(f"{self.name}: {self.passed} passed, {self.failed} failed")
        sys.exit(1 if self.failed else 0)


def steps_only_add(checks, program, name, steps, *options):
    """Each step draws all that the one before drew, at the same place."""
    before = None
    for step in range(1, steps + 1):
        figure = Figure(program, name, *options, settings=f"step={step}")
        marks = {(title, tuple(shape.get(key) or "" for key in ("points", "d", "transform", "href")))
                 for title, groups in figure.plots.items() for group in groups
                 for shape in group.iter() if not shape.tag.endswith("title")}
        labels = {label for label in figure.labels()}
        if before is not None:
            checks.that(f"{name}: step {step} keeps what step {step - 1} shows",
                        before[0] <= marks and before[1] <= labels, str(before[1] - labels))
            checks.that(f"{name}: step {step} adds something", before != (marks, labels))
        before = (marks, labels)


def on_the_canvas(checks, name, figure):
    """No text is cut off, as wide as it may be."""
    for text in (text for text in figure.texts() if text.words):
        left, low, right, high = text.box
        checks.that(f"{name}: {text.words!r} is on the canvas",
                    left >= 0 and low >= -figure.strip and right <= figure.width and high <= figure.height,
                    f"from {left:.0f}, {low:.0f} to {right:.0f}, {high:.0f}"
                    f" of {figure.width:.0f} by {figure.height:.0f}")


AXES = ("t", "label of ticks", "columns", "rows", "numbers")  # titles of the plots that write numbers along one


def is_a_scale(texts):
    """The numbers along an axis: bare, and three or more."""
    return texts[0].title in AXES or \
        len(texts) >= 3 and all(re.fullmatch(NUMBER, text.words) for text in texts)


def told_in_words(checks, name, figure):
    """The words of the figure name the numbers that it shows."""
    title, description = figure.in_words()
    checks.that(f"{name}: it has a title", title != "")
    checks.that(f"{name}: it has words", len(description) > len(title), description)
    checks.that(f"{name}: its words have no NaN and no infinity",
                not re.search(r"\bnan\b|\binf|not answered", title + description, re.I), description)
    told = set(re.findall(NUMBER, description))
    plots = {}
    for text in figure.texts():
        plots.setdefault(text.title or text.words, []).append(text)
        checks.that(f"{name}: {text.words!r} has no hyphen for a minus",
                    not re.search(r"(?<!\w)-\s?\d", text.words))
    for texts in plots.values():
        for text in [] if is_a_scale(texts) else texts:
            checks.that(f"{name}: {text.words!r} is also in its words", told.issuperset(text.numbers()),
                        f"its numbers are {text.numbers()}, those in words {sorted(told)}")


def holds_for_every(checks, program, name, *options):
    """Everything that each figure needs; text on the canvas, in both shapes; the same in words."""
    for shape in ("16:9", "4:3"):
        figure = Figure(program, name, *options, settings=f"shape='{shape}'")
        checks.that(f"{name}, {shape}: there is text", len(figure.labels()) > 0)
        on_the_canvas(checks, f"{name}, {shape}", figure)
    told_in_words(checks, name, figure)
    steps = int(figure.variables.get("steps", "1"))
    steps_only_add(checks, program, name, steps, *options)
