"""figures.py - the figures of chapter 02 are right: four forms, and one camera from each; a look-at and its frame."""
import math
import os
import random

from cameras import DECK, beside_right, corners, options_of, some_camera
from check import SHAPES, Checks, drawn, holds_for_every, nothing_collides
from figure import cross, dot, length, plus, times, unit
from shown import shown, shown_vector

checks = Checks("figures of 02-cameras")
FORMS = ("look-at", "points", "corner", "vectors")  # panels 1 to 4


def in_panel(drawn, panel):
    """One of the things that each panel has once; None if there are fewer."""
    return drawn[panel:panel + 1]


def camera_forms(c, options, shape, up=None):
    up = up or c["u"]
    figure = drawn(checks, "02-cameras", "camera-forms", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=34)

    def place(form, point):
        """All panels have one size, each a middle of its own."""
        panel = FORMS.index(form) + 1
        zero = (figure.chosen(f"zero_x[{panel}]"), figure.chosen(f"zero_y[{panel}]"))
        return tuple(zero[i] + figure.scale * dot(point, figure.axes[i]) for i in range(2))

    upper_left, upper_right, lower_right, lower_left = points = corners(c)
    middle = plus(c["p"], c["f"], c["d"])
    size = max(c["d"], c["w"], c["h"]) / 5
    checks.near("the eyes", figure.dots("eye"), [place(form, c["p"]) for form in FORMS])
    for panel, form in enumerate(FORMS):
        checks.near(f"{form}: the plane that is found", [p for found in in_panel(figure.strokes("found"), panel) for p in found[:4]],
                    [place(form, p) for p in points])
        for name in "ruf":
            start = [shaft[0] for shaft in in_panel(figure.strokes(name), panel)]
            checks.near(f"{form}: {name} that is found", start + in_panel(figure.tips(name), panel),
                        [place(form, middle), place(form, plus(middle, c[name], size))])

    checks.near("the point looked at", figure.dots("at"), place("look-at", middle))
    checks.near("the arrow to it", figure.ends("view"), [place("look-at", p) for p in (c["p"], middle)])
    checks.near("up", figure.tips("up"), place("look-at", plus(c["p"], unit(up), c["d"] / 4)))
    checks.near("the four points", figure.dots("points"),
                [place("points", p) for p in (upper_left, upper_right, lower_left, lower_right)])
    checks.near("the lower left corner", figure.dots("lower left"), place("corner", lower_left))
    checks.near("across", figure.ends("across"), [place("corner", p) for p in (lower_left, lower_right)])
    checks.near("up the left edge", figure.ends("upward"), [place("corner", p) for p in (lower_left, upper_left)])
    checks.near("the four vectors", figure.tips("vectors"),
                [place("vectors", p) for p in (upper_left, upper_right, lower_left, lower_right)])

    labels = [words for words, _, _ in figure.labels()]
    found = f"d = {shown(c['d'])}, w = {shown(c['w'])}, h = {shown(c['h'])}"
    checks.that("the common result is shown", f"each gives {found}" in labels or found in labels, f"{found!r} is not in {labels}")
    checks.that("each form's result is in the words", figure.in_words()[1].count(found) == 4, found)
    aspect = f"look-at, w/h = {shown(c['w'] / c['h'])}"
    checks.that("the panel of the look-at has the aspect ratio", aspect in labels, f"{aspect!r} is not in {labels}")
    _, words = figure.in_words()
    for v in (c["p"], middle, up, lower_left, times(c["w"], c["r"]), times(c["h"], c["u"])):
        checks.that(f"{shown_vector(v)} is in the words", shown_vector(v) in words, words)


def look_at(c, options, shape, up=None):
    """The frame is the one that the camera was made of; that r and u are at right angles is computed from the data."""
    figure = drawn(checks, "02-cameras", "look-at", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=34)
    given = unit(up or c["u"])
    if length(plus(given, c["u"], -1)) < 1e-6:   # an up that is straight already is shown leaning
        given = unit(plus(c["u"], c["f"], 0.6))
    checks.near("the eye", figure.dots("eye"), figure.place(c["p"]))
    for title, arrow in (("f", c["f"]), ("r", c["r"]), ("u", c["u"]), ("up", given)):
        checks.near(f"the arrow {title}", figure.tips(title), figure.place(plus(c["p"], arrow)))
    r, u = (figure.block(name)[0][3:] for name in "ru")
    checks.that("r is at right angles to f and up", max(abs(dot(r, c["f"])), abs(dot(r, given))) < 1e-5, str(r))
    checks.that("u is in the plane of f and up, on the side of up", abs(dot(u, cross(c["f"], given))) < 1e-5 and dot(u, given) > 0)
    half = math.degrees(math.atan(c["w"] / 2 / c["d"]))
    checks.same("half the angle", [figure.number("half_degrees")], [half])
    (x, y), (to_x, to_y) = figure.line("edge")
    checks.that("the triangle has that angle", abs(math.degrees(math.atan2(to_y - y, to_x - x)) - half) < 0.1)
    checks.near("its sides meet on the plane", [figure.line("half the width")[1]], [(to_x, to_y)])


def looking(dice):
    """A camera by a look-at in a world of either handedness, with an up that leans; as frame and options."""
    eye, at = (tuple(dice.uniform(-9, 9) for _ in range(3)) for _ in range(2))
    ahead = plus(at, eye, -1)
    f, hand = unit(ahead), dice.choice(["left", "right"])
    while True:
        up = tuple(dice.uniform(-1, 1) for _ in range(3))
        aside = cross(f, up) if hand == "right" else cross(up, f)
        if dot(aside, aside) > 0.04:
            break
    r = unit(aside)
    width, aspect = dice.uniform(0.5, 8), dice.uniform(0.5, 2)
    camera = {"p": eye, "r": r, "u": cross(r, f) if hand == "right" else cross(f, r), "f": f,
              "d": dot(ahead, ahead) ** 0.5, "w": width, "h": width / aspect}
    options = []
    for name, v in (("--eye", eye), ("--at", at), ("--up", up)):
        options += [name, ",".join(f"{x:.17g}" for x in v)]
    return camera, options + ["--width", width, "--aspect", aspect, "--handedness", hand], up


def yours_beside_right():
    """Another camera instead of a wrong answer: labels name the places of the right one."""
    figure, = beside_right("02-cameras", "camera-forms", dict(DECK, w=3))
    nothing_collides(checks, "yours beside right", figure)
    labels = [words for words, _, _ in figure.labels()]
    checks.that("yours is below the right one", "yours, look-at: d = 4, w = 3, h = 2" in labels, str(labels))


for canvas in SHAPES:
    camera_forms(DECK, options_of(DECK), canvas)
    look_at(DECK, options_of(DECK), canvas)
yours_beside_right()
for title in ("camera-forms", "look-at"):
    holds_for_every(checks, "02-cameras", title)
dice = random.Random(2)
for i in range(int(os.environ.get("CAMERAS", "5"))):
    camera, canvas = some_camera(dice, 10 ** dice.uniform(-6, 6)), SHAPES[i % 2]
    camera_forms(camera, options_of(camera), canvas)
    look_at(camera, options_of(camera), canvas)
    camera, options, up = looking(dice)
    camera_forms(camera, options, canvas, up)
    look_at(camera, options, canvas, up)
checks.end()
