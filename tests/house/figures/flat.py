"""flat.py - figures in two dimensions: where a place of a panel belongs, and numbers as they show them."""


class Panel:
    """A panel, as large and where C has chosen (common/figure/plot_view.c)."""

    def __init__(self, figure, number=1):
        self.unit = figure.chosen(f"size[{number}]")
        self.zero = figure.chosen(f"zero_x[{number}]"), figure.chosen(f"zero_y[{number}]")

    def place(self, x, y):
        return tuple(zero + self.unit * at for zero, at in zip(self.zero, (x, y)))


def line(figure, title):
    """The places on the first line of a title; none where a wrong answer left nothing to draw."""
    found = figure.lines(title)
    return found[0] if found else []


def stroke(checks, figure, title, start, end):
    """A single line from here to there; too short to see, it may be missing."""
    if max(abs(a - b) for a, b in zip(start, end)) > 0.1:
        checks.near(title, line(figure, title), [start, end])


def number(x):
    """A number as stories and labels of screens show it: to 6 digits, with a minus sign."""
    return f"{x if x else 0:.6g}".replace("-", "−")


def pair(x, y):
    return f"({number(x)}, {number(y)})"
