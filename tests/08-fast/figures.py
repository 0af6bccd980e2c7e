"""figures.py - the figure of chapter 08 is right: two lines that touch a circle, from above.

They are computed by angles: that of the center, and the arc sine of r over its distance on both sides.
"""
import math
import os
import random

from check import Checks, holds_for_every, labels_are_clear
from figure import Figure

checks = Checks("figures of 08-fast")
P, F = "08-fast", "tangents"
# The camera of three-spheres.nff looks along -z, so its right is x: the eye, the plane, the columns.
EYE, DISTANCE, COLUMNS, ROWS = (0, 0, 20), 20, 640, 480
WIDTH = 2 * DISTANCE * math.tan(math.radians(21))


def span(ahead, aside, r, count):
    """The places of two lines that touch, on that many columns or rows, cut off at the edges; None if they are all beyond one."""
    middle, half = math.atan2(aside, ahead), math.asin(r / math.hypot(ahead, aside))
    low, high = ((DISTANCE * math.tan(angle) / WIDTH * COLUMNS + count / 2) if abs(angle) < math.pi / 2 else
                 math.copysign(math.inf, angle) for angle in (middle - half, middle + half))
    return (max(low, 0), min(high, count)) if low < count and high > 0 else None


def edges(c, r):
    """None if there is no rectangle."""
    ahead = EYE[2] - c[2]
    if ahead <= -r:
        return None
    if ahead <= r:
        return 0, COLUMNS
    return span(ahead, c[1], r, ROWS) and span(ahead, c[0], r, COLUMNS)


def tangents(c=(2, 2, 1), r=3, given=True):
    options = [f"--center={c[0]:.17g},{c[1]:.17g},{c[2]:.17g}", f"--radius={r:.17g}"] if given else []
    figure = Figure(P, F, *options)
    wanted = edges(c, r)
    checks.that("there is a rectangle or not", (figure.number("nothing") == 1) == (wanted is None), f"{c} {r}")
    eye = figure.dots("eye")[0]
    circle = figure.lines("circle")[0][:-1]
    middle = [sum(point[i] for point in circle) / len(circle) for i in range(2)]
    scale = math.dist(*figure.line("image plane")) / WIDTH
    checks.that("the circle has the radius", all(abs(math.dist(point, middle) - scale * r) < 0.3 for point in circle))
    checks.near("C", figure.dots("C"), (eye[0] + scale * (EYE[2] - c[2]), eye[1] + scale * -c[0]))
    if wanted is None:
        return options
    checks.same("left and right", [figure.number("left"), figure.number("right")], wanted, within=1e-6)
    for name, x in zip(("left", "right"), wanted):
        place = eye[0] + scale * DISTANCE, eye[1] - scale * WIDTH * (x / COLUMNS - 0.5)
        checks.near(f"the mark of {name}", figure.dots(name), place)
        line = figure.line(f"{name} line")
        away = abs((line[1][0] - eye[0]) * (middle[1] - eye[1]) - (line[1][1] - eye[1]) * (middle[0] - eye[0])) / math.dist(line[1], eye)
        checks.that(f"the {name} line touches the circle", x in (0, COLUMNS) or abs(away - scale * r) < 0.3, f"{away}, r is {scale * r}")
    return options


tangents(given=False)
checks.shows(Figure(P, F), "left = 275.941", "right = 544.047", "columns 275.941 to 544.047 of 640")
holds_for_every(checks, P, F)
for case in (((-2, 0, -1), 3), ((0, 0, 5), 2), ((0, 0, 21), 3), ((7, 0, 0), 2)):
    holds_for_every(checks, P, F, *tangents(*case))
for nowhere in (((0, 0, 24), 3), ((14, 1, 0), 3), ((60, 0, 0), 3)):
    labels_are_clear(checks, P, F, tangents(*nowhere))
dice = random.Random(8)
for _ in range(int(os.environ.get("SCENES", "5"))):
    tangents(tuple(dice.uniform(-9, 9) for _ in range(3)), dice.uniform(0.2, 4))
    labels_are_clear(checks, P, F, tangents(tuple(dice.uniform(-20, 20) for _ in range(3)), 10 ** dice.uniform(-1, 1)))
checks.end()
