"""figures.py - the figure of chapter 04 is right: each link of the chain."""
import os
import random

from cameras import DECK, corners, options_of, some_camera
from check import Checks, holds_for_every, labels_are_clear
from figure import Figure, plus, times
from shown import place_digits, shown, shown_vector

checks = Checks("figures of 04-pixel-ray")
DOT = 0.05  # canvas units
FAR = 1.5  # the length of the ray in the figure, in lengths of v
SQUARE = ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))


def toward(c, s, t):
    """From the eye to a place of the plane: the mean of its corners, weighted by nearness."""
    upper_left, upper_right, lower_right, lower_left = corners(c)
    place = (0, 0, 0)
    for corner, share in ((upper_left, (1 - s) * t), (upper_right, s * t),
                          (lower_left, (1 - s) * (1 - t)), (lower_right, s * (1 - t))):
        place = plus(place, corner, share)
    return plus(place, c["p"], -1)


def lens_and_screen(figure, size, pixel):
    (across, down), (column, row) = size, pixel
    lens = figure.see_flat(2)
    screen = figure.see_flat(3)
    checks.near("the pixel under the lens", figure.line("pixel, outline"),
                [lens(column + i, j - row - 1) for i, j in SQUARE])
    checks.near("the pixel on the screen", figure.polygons("pixel on the screen")[0],
                [screen(column + i, j - row - 1) for i, j in SQUARE])
    checks.near("the screen", figure.line("screen"), [screen(i * across, (j - 1) * down) for i, j in SQUARE])
    checks.near("its origin is its upper left corner", figure.dots("origin of the screen"), screen(0, 0))
    x, y = column + 0.5, row + 0.5
    for title, panel, a in (("half across", lens, (column, -y)), ("half down", lens, (x, -row)),
                            ("x of the center", screen, (0, -y)), ("y of the center", screen, (x, 0))):
        checks.stroke(figure, title, panel(*a), panel(x, -y))
    checks.same("the center's data", figure.block("center"), [[x, y]])
    checks.that("they are side by side", lens(column + 1, 0)[0] < screen(0, 0)[0])
    checks.near("the center under the lens", figure.dots("center under the lens"), lens(x, -y), DOT)
    checks.near("the center", figure.dots("center"), screen(x, -y), DOT)


def unit_square(figure, s, t):
    square = figure.see_flat(4)
    checks.near("the square", figure.line("square"), [square(*corner) for corner in SQUARE])
    checks.near("its origin is its lower left corner", figure.dots("origin of the square"), square(0, 0))
    checks.same("the place's data", figure.block("place"), [[s, t]])
    checks.near("the place", figure.dots("place"), square(s, t), DOT)
    checks.stroke(figure, "s", square(0, t), square(s, t))
    checks.stroke(figure, "t", square(s, 0), square(s, t))


def world(figure, c, s, t):
    figure.see(c["r"], c["u"], c["f"])
    vector, eye = toward(c, s, t), c["p"]

    def at(s, t, far=1.0):
        return figure.place(plus(eye, toward(c, s, t), far))
    checks.same("the vector's data", figure.block("vector")[0], [*eye, *vector])
    checks.same("the ray's start", figure.block("origin")[0], eye)
    checks.same("the ray's data", figure.block("ray")[0], [*eye, *times(FAR, vector)])
    checks.near("the eye", figure.dots("eye"), figure.place(eye), DOT)
    checks.near("the pixel on the plane", figure.dots("pixel on the plane"), at(s, t), DOT)
    checks.near("the vector's arrow", figure.tips("vector"), at(s, t))
    checks.near("the ray's arrow, beyond", figure.tips("ray"), at(s, t, FAR))
    checks.near("the plane", figure.line("plane"),
                [at(0, 1), at(1, 1), at(1, 0), at(0, 0), at(0, 1)])
    checks.near("its origin is its lower left corner", figure.dots("origin of the plane"), at(0, 0))
    checks.stroke(figure, "s on the plane", at(0, t), at(s, t))
    checks.stroke(figure, "t on the plane", at(s, 0), at(s, t))


def pixel_to_ray(c, size, pixel, options):
    labels_are_clear(checks, "04-pixel-ray", "pixel-to-ray", options)
    figure = Figure("04-pixel-ray", "pixel-to-ray", *options)
    (across, down), (column, row) = size, pixel
    s, t = (2 * column + 1) / (2 * across), (2 * (down - row) - 1) / (2 * down)
    lens_and_screen(figure, size, pixel)
    unit_square(figure, s, t)
    world(figure, c, s, t)
    labels, digits = [text for text, _, _ in figure.labels()], place_digits(across, down)
    for text in (f"pixel {shown_vector(pixel)}", f"center {shown_vector((column + 0.5, row + 0.5))}", f"s = x/{across} = {shown(s, digits)}",
                 f"t = 1 − y/{down} = {shown(t, digits)}", "pixel", "screen", "(s, t)", "p", "v", "p + t v"):
        checks.that(f"the label {text!r}", text in labels, str(labels))
    if c is DECK:  # a number that is 0 except for rounding has other digits on other machines
        vector = shown_vector(toward(c, s, t))
        for text in ("v = d f + (s − ½) w r", "+ (t − ½) h u", f"= {vector}", "ray p + t v from", "(2, 2, −4)"):
            checks.that(f"the vector's and the ray's label {text!r}", text in labels, str(labels))
        words = figure.in_words()[1]
        for text in (shown_vector((column + 0.5, row + 0.5)), shown_vector((s, t), digits), vector):
            checks.that(f"the words have {text}", text in words, words)


pixel_to_ray(DECK, (640, 480), (300, 400), ["--size", "640x480", "--pixel", "300,400", *options_of(DECK)])
pixel_to_ray(DECK, (4, 3), (3, 0), ["--size", "4x3", "--pixel", "3,0", *options_of(DECK)])
holds_for_every(checks, "04-pixel-ray", "pixel-to-ray")
dice = random.Random(4)
for i in range(int(os.environ.get("CAMERAS", "5"))):
    most = (12, 4000)[i % 2]
    resolution = dice.randint(1, most), dice.randint(1, most)
    somewhere = dice.randrange(resolution[0]), dice.randrange(resolution[1])
    camera = some_camera(dice, 10 ** dice.uniform(-6, 6))
    pixel_to_ray(camera, resolution, somewhere, [
        "--size", "%dx%d" % resolution, "--pixel", "%d,%d" % somewhere, *options_of(camera)])
checks.end()
