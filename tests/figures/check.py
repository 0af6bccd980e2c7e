"""check.py - the checks of figures: how they are counted, and what holds for every figure."""
import sys

from figure import Figure

NEAR = 0.1  # canvas units, that is, pixels of the SVG


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


def holds_for_every(checks, program, name, *options):
    """What no figure does without; labels inside the canvas, in both shapes and themes."""
    for shape in ("16:9", "4:3"):
        figure = Figure(program, name, *options, settings=f"shape='{shape}'")
        checks.that(f"{name}, {shape}: there is text", len(figure.labels()) > 0)
        for text, x, y in figure.labels():
            checks.that(f"{name}, {shape}: {text!r} is on the canvas",
                        0 <= x <= figure.width and -figure.strip <= y <= figure.height, f"at {x}, {y}")
    steps = int(figure.variables.get("steps", "1"))
    steps_only_add(checks, program, name, steps, *options)
