"""figures.py - the figures of chapter 03 are right."""
import os
import random

from check import Checks, holds_for_every, labels_are_clear
from figure import Figure
from shown import place_digits, shown, shown_vector

checks = Checks("figures of 03-screen")
DOT = 0.05  # canvas units


def on_screen(panel, x, y):
    return panel(x, -y)


def label_at(figure, text, x=None, y=None):
    """Is the label somewhere in line with a place?"""
    return any(found == text and (x is None or abs(x - at_x) < 0.1) and (y is None or abs(y - at_y) < 10)
               for found, at_x, at_y in figure.labels())


def screen_to_unit(size, at, options):
    labels_are_clear(checks, "03-screen", "screen-to-unit", options)
    figure = Figure("03-screen", "screen-to-unit", *options)
    (across, down), (x, y) = size, at
    s, t = x / across, (down - y) / down
    screen, square = figure.see_flat(1), figure.see_flat(2)
    for panel, corners in ((screen, ((0, 0), (across, -down), (x, -y))), (square, ((0, 0), (1, 1), (s, t)))):
        for left, low in (panel(*corner) for corner in corners):
            checks.that("all of it is on the canvas", 0 < left < 960 and 0 < low < 464, f"{left}, {low}")
    checks.same("the point's data", figure.block("point"), [[x, y]])
    checks.same("the place's data", figure.block("place"), [[s, t]])
    checks.near("the screen", figure.line("screen"),
                [on_screen(screen, i * across, j * down) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))])
    checks.near("the square", figure.line("square"),
                [square(i, j) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))])
    checks.near("the screen's origin is its upper left corner", figure.dots("origin of the screen"),
                on_screen(screen, 0, 0))
    checks.near("the square's origin is its lower left corner", figure.dots("origin of the square"),
                square(0, 0))
    checks.near("the point", figure.dots("point"), on_screen(screen, x, y), DOT)
    checks.near("the same point in the square", figure.dots("place"), square(s, t), DOT)
    for title, panel, a, b in (("x of the point", screen, (0, -y), (x, -y)), ("y of the point", screen, (x, 0), (x, -y)),
                               ("s of the point", square, (0, t), (s, t)), ("t of the point", square, (s, 0), (s, t)),
                               ("from the top", square, (s, 1), (s, t))):
        checks.stroke(figure, title, panel(*a), panel(*b))
    digits = place_digits(across, down)
    y_text = f"({shown(y)})" if y < 0 else shown(y)
    checks.shows(figure, shown_vector((x, y)), shown(x), shown(y), shown(across), shown(down), f"s = x/{shown(across)}",
                 f"t = 1 − y/{shown(down)}", f"s = {shown(x)}/{shown(across)} = {shown(s, digits)}",
                 f"t = 1 − {y_text}/{shown(down)} = {shown(t, digits)}")
    words = figure.in_words()[1]
    for text in (f"{shown(across)} by {shown(down)} pixels", shown_vector((x, y)), shown_vector((s, t), digits)):
        checks.that(f"the words have {text}", text in words, words)


def pixel_grid(size, pixel, options):
    labels_are_clear(checks, "03-screen", "pixel-grid", options)
    figure = Figure("03-screen", "pixel-grid", *options)
    (across, down), (column, row) = size, pixel
    whole = across <= 12 and down <= 9
    seen = []
    for name, at, count, part in (("x", column, across, 8), ("y", row, down, 6)):
        low, high = figure.number(f"begin_{name}"), figure.number(f"end_{name}")
        numbers = [n for n, in figure.block("columns" if name == "x" else "rows")]
        seen.append(range(int(numbers[0]), int(numbers[-1]) + 1))
        checks.that("the numbers count up", numbers == list(seen[-1]), str(numbers))
        checks.that("the pixel is in sight", at in numbers, str(numbers))
        checks.that("as many as can be distinguished", len(numbers) == (count if whole else min(count, part)))
        checks.that("the screen ends at its edge, or goes on", low == (numbers[0] - 0.4 if numbers[0] else 0) and
                    high == (numbers[-1] + 1 + 0.4 * (numbers[-1] + 1 < count)), f"{low} to {high}")
    low = (figure.number("begin_x"), -figure.number("end_y"))
    high = (figure.number("end_x"), -figure.number("begin_y"))
    panel = figure.see_flat()
    for left, height in (panel(*low), panel(*high)):
        checks.that("the part is on the canvas", 0 < left < 960 and 0 < height < 464, f"{left}, {height}")
    x, y, s, t = column + 0.5, row + 0.5, (2 * column + 1) / (2 * across), (2 * down - 2 * row - 1) / (2 * down)
    checks.same("the center's data", figure.block("center"), [[x, y]])
    checks.same("the place's data", figure.block("place"), [[s, t]])
    middle = on_screen(panel, x, y)
    checks.near("the center", figure.dots("center"), middle, DOT)
    checks.near("every center", sorted(figure.dots("centers")),
                sorted(on_screen(panel, i + 0.5, j + 0.5) for i in seen[0] for j in seen[1]), DOT)
    square = [on_screen(panel, column + i, row + j) for i, j in ((0, 1), (1, 1), (1, 0), (0, 0), (0, 1))]
    checks.near("the pixel's outline", figure.line("pixel, outline"), square)
    # The center's s and t are straight below and beside it.
    lower, side = panel(0, low[1])[1] - 12, panel(high[0], 0)[0] + 12
    checks.near("from the center to its s", figure.line("to s"), [middle, (middle[0], lower)])
    checks.near("from the center to its t", figure.line("to t"), [middle, (side, middle[1])])
    checks.that("the column's number is above it", label_at(figure, str(column), x=middle[0]))
    checks.that("the row's number is beside it", label_at(figure, str(row), y=middle[1]))
    digits = place_digits(across, down)
    checks.shows(figure, f"pixel {shown_vector((column, row))}", f"center {shown_vector((x, y))}", f"s = ({column} + ½)/{across}",
                 f"t = 1 − ({row} + ½)/{down}", f"= {shown(s, digits)}", f"= {shown(t, digits)}")
    if whole:  # 0 and 1 are s and t of the edges, if the center's own number leaves room for them
        left, bottom = panel(0, -down)
        right, top = panel(across, 0)
        for text, far_off, at in (("0", s * across, {"x": left}), ("1", (1 - s) * across, {"x": right}),
                                  ("0", t * down, {"y": bottom}), ("1", (1 - t) * down, {"y": top})):
            if far_off * figure.chosen("size[1]") > 70:
                checks.that(f"the edge {text} at {at}", label_at(figure, text, **at))


DECK = ["--size", "640x480", "--point", "300,400"]  # the lecture may have another example
screen_to_unit((640, 480), (300, 400), DECK)
checks.that("the deck's answer", "(0.46875, 0.1667)" in Figure("03-screen", "screen-to-unit", *DECK).in_words()[1])
pixel_grid((8, 6), (3, 4), [])
pixel_grid((640, 480), (300, 400), DECK)
pixel_grid((1, 1), (0, 0), ["--size", "1x1"])
for figure_name in ("screen-to-unit", "pixel-grid"):
    holds_for_every(checks, "03-screen", figure_name)
dice = random.Random(3)
for i in range(int(os.environ.get("CAMERAS", "5"))):
    across, down = dice.randint(1, 4000), dice.randint(1, 4000)
    low, high = ((0, 1), (-0.3, 1.3))[i % 2]  # also beyond the screen
    point = dice.uniform(low, high) * across, dice.uniform(low, high) * down
    screen_to_unit((across, down), point, ["--size", f"{across}x{down}", "--point", "%.17g,%.17g" % point])
    if i % 2 == 0:
        across, down = dice.randint(1, 12), dice.randint(1, 9)
    pixel = dice.randrange(across), dice.randrange(down)
    pixel_grid((across, down), pixel, ["--size", f"{across}x{down}", "--pixel", "%d,%d" % pixel])
checks.end()
