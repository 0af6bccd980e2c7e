"""corners.py - the figures of chapter 01 show what is so."""
import os
import random

from check import Checks, holds_for_every
from figure import Figure, plus, times

checks = Checks("figures of 01-corners")
DECK = {"p": (2, 2, -4), "r": (1, 0, 0), "u": (0, 1, 0), "f": (0, 0, 1), "d": 4, "w": 2, "h": 2}


def some_camera(dice):
    """Any camera, of either hand; three vectors made perpendicular by Gram and Schmidt."""
    def direction():
        while True:
            v = [dice.uniform(-1, 1) for _ in range(3)]
            if 0.1 < sum(x * x for x in v) < 1:
                return v
    frame = []
    while len(frame) < 3:
        v = direction()
        for unit in frame:
            v = plus(v, unit, -sum(a * b for a, b in zip(v, unit)))
        length = sum(x * x for x in v) ** 0.5
        if length > 0.05:
            frame.append(times(1 / length, v))
    return {"p": tuple(dice.uniform(-9, 9) for _ in range(3)), "r": frame[0], "u": frame[1],
            "f": frame[2], "d": dice.uniform(0.5, 8), "w": dice.uniform(0.5, 8), "h": dice.uniform(0.5, 8)}


def options_of(c):
    def words(v):
        return ",".join(f"{x:.17g}" for x in v)
    return ["--eye", words(c["p"]), "--right", words(c["r"]), "--up", words(c["u"]),
            "--forward", words(c["f"]), "--distance", c["d"], "--width", c["w"], "--height", c["h"]]


def legs(c, across, upward):
    """Ahead, aside by so many halves of the width, up by so many of the height."""
    return plus(plus(times(c["d"], c["f"]), c["r"], across * c["w"] / 2), c["u"], upward * c["h"] / 2)


def corner_vectors(c, options):
    figure = Figure("01-corners", "corner-vectors", *options)
    figure.see(c["r"], c["u"], c["f"], room=(0.08, 0.70, 0.08, 0.84))
    left, right = legs(c, -1, 1), legs(c, 1, 1)
    checks.same("the upper left corner's data", figure.block("upper_left")[0], [*c["p"], *left])
    checks.same("the upper right corner's data", figure.block("upper_right")[0], [*c["p"], *right])
    checks.near("the arrow to the upper left", figure.tips("upper left"), figure.place(plus(c["p"], left)))
    checks.near("the arrow to the upper right", figure.tips("upper right"), figure.place(plus(c["p"], right)))
    checks.near("the eye", figure.dots("eye"), figure.place(c["p"]))
    checks.near("the arrow ahead", figure.tips("ahead"), figure.place(plus(c["p"], legs(c, 0, 0))))
    outline = [figure.place(plus(c["p"], legs(c, *corner)))
               for corner in ((-1, 1), (1, 1), (1, -1), (-1, -1), (-1, 1))]
    checks.near("the outline of the plane", figure.lines("plane")[0], outline)


def yours_and_right(c, options, yours=None):
    """The point 30% across and 10% up; by default, who counts from the middle of the plane."""
    figure = Figure("01-corners", "yours-and-right", *options)
    figure.see(c["r"], c["u"], c["f"], room=(0.10, 0.95, 0.05, 0.90))
    right = legs(c, -0.4, -0.8)
    yours = yours or legs(c, 0.6, 0.2)
    checks.same("yours and right: data", [figure.block("answer")[0], figure.block("yours")[0]],
                [[*c["p"], *right], [*c["p"], *yours]])
    checks.near("yours and right: right", figure.tips("right"), figure.place(plus(c["p"], right)))
    checks.near("yours and right: yours", figure.tips("yours"), figure.place(plus(c["p"], yours)))
    return figure


def is_said(figure, off):
    checks.that("yours and right: what it is off by", figure.text("off_text") == off, figure.text("off_text"))


corner_vectors(DECK, [])
is_said(yours_and_right(DECK, []), "off by (1, 1, 0) = ½ w r + ½ h u")
is_said(yours_and_right(DECK, ["--yours", "-0.4,0.8,4"], (-0.4, 0.8, 4)), "off by (0, 1.6, 0) = 4/5 h u")
is_said(yours_and_right(DECK, ["--yours", "0.123,0.4567,4"], (0.123, 0.4567, 4)), "off by (0.523, 1.257, 0)")
holds_for_every(checks, "01-corners", "yours-and-right")
holds_for_every(checks, "01-corners", "corner-vectors")
dice = random.Random(1)
for _ in range(int(os.environ.get("CAMERAS", "5"))):
    camera = some_camera(dice)
    corner_vectors(camera, options_of(camera))
    yours_and_right(camera, options_of(camera))
checks.end()
