"""figures.py - the figures of chapter 01 are right."""
import os
import random

from cameras import DECK, beside_right, corners, vector_to, options_of, some_camera
from check import SHAPES, Checks, drawn, holds_for_every, nothing_collides, on_the_canvas
from figure import Figure, plus, times
from shown import shown, shown_vector

checks = Checks("figures of 01-corners")


def place_of(c, s, t):
    """The point of the world that is s across, t up."""
    return plus(c["p"], vector_to(c, 2 * s - 1, 2 * t - 1))


def arrow(figure, title, start, end, aside=(0, 0)):
    """An arrow or a line between two points of the world, moved to the side on the canvas."""
    at = [tuple(x + d for x, d in zip(figure.place(p), aside)) for p in (start, end)]
    checks.near(f"{title}, from one end to the other", figure.ends(title), at)


def outline(figure, title, c, points=None):
    points = points or corners(c)
    checks.near(f"the outline of {title}", figure.lines(title)[0], [figure.place(p) for p in points + points[:1]])


def eye(figure, c):
    checks.near("the eye", figure.dots("eye"), figure.place(c["p"]))


def camera_frame(c, options, shape):
    figure = drawn(checks, "01-corners", "camera-frame", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=32)
    eye(figure, c)
    outline(figure, "plane", c)
    long = max(c["d"], c["w"], c["h"]) / 4
    for name, title in zip("ruf", ("right arrow", "up arrow", "forward arrow")):
        checks.near(f"the arrow {name}", figure.tips(title), figure.place(plus(c["p"], c[name], long)))
    middle = place_of(c, 0.5, 0.5)
    checks.near("the middle", figure.dots("middle"), figure.place(middle))
    arrow(figure, "ahead", c["p"], middle)
    for i, stroke in enumerate(figure.strokes("to the corners")):
        checks.near("a line to a corner", stroke, [figure.place(p) for p in (c["p"], corners(c)[(0, 1, 3, 2)[i]])])
    grid = [((i / 8, 0), (i / 8, 1)) for i in range(1, 8)] + [((0, i / 8), (1, i / 8)) for i in range(1, 8)]
    for stroke, ends in zip(figure.strokes("grid"), grid):
        checks.near("a line of the grid", stroke, [figure.place(place_of(c, *end)) for end in ends])
    checks.that("all lines are there", [len(figure.strokes(t)) for t in ("to the corners", "grid")] == [4, 14])
    upper_left, upper_right, lower_right, _ = corners(c)
    arrow(figure, "upper edge", upper_left, upper_right, (0, 14))
    arrow(figure, "right edge", lower_right, upper_right, (14, 0))
    checks.shows(figure, *(f"{name} = {shown(c[name])}" for name in "dwh"), *"pruf", *"xyz")
    axes(figure, c, middle)


def axes(figure, c, middle):
    """Through the world's origin if it is near; always parallel to the axes."""
    size = max(c["d"], c["w"], c["h"])
    far = sum(x * x for x in middle) ** 0.5 > 1.5 * size
    zero = plus(plus(c["p"], c["f"], 0.4 * c["d"]), c["u"], -0.2 * c["h"] - 0.4 * size)
    for i, name in enumerate("xyz"):
        unit = tuple(float(i == j) for j in range(3))
        if far:
            arrow(figure, f"{name} axis", zero, plus(zero, unit, size / 6))
        else:
            along = [0, c["p"][i], *(p[i] for p in corners(c))]
            arrow(figure, f"{name} axis", times(min(along), unit), times(max(along) + size / 8, unit))


def corner_vectors(c, options, shape):
    figure = drawn(checks, "01-corners", "corner-vectors", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=34)
    left, right = vector_to(c, -1, 1), vector_to(c, 1, 1)
    checks.same("the upper left corner's data", figure.block("upper_left")[0], [*c["p"], *left])
    checks.same("the upper right corner's data", figure.block("upper_right")[0], [*c["p"], *right])
    checks.near("the arrow to the upper left", figure.tips("upper left"), figure.place(plus(c["p"], left)))
    checks.near("the arrow to the upper right", figure.tips("upper right"), figure.place(plus(c["p"], right)))
    eye(figure, c)
    outline(figure, "plane", c)
    way = {"ahead": ((0.5, 0.5), None), "aside left": ((0, 0.5), (0.5, 0.5)), "up left": ((0, 1), (0, 0.5)),
           "aside right": ((1, 0.5), (0.5, 0.5)), "up right": ((1, 1), (1, 0.5))}
    for title, (end, start) in way.items():
        checks.near(f"the arrow {title}", figure.tips(title), figure.place(place_of(c, *end)))
        arrow(figure, title, place_of(c, *start) if start else c["p"], place_of(c, *end))
    checks.shows(figure, "= " + shown_vector(left), "= " + shown_vector(right),
                 "d f − (w/2) r + (h/2) u", "d f + (w/2) r + (h/2) u")


def point_30_10(c, options, shape, s=0.3, t=0.1):
    figure = drawn(checks, "01-corners", "point-30-10", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=42)
    vector, point = vector_to(c, 2 * s - 1, 2 * t - 1), place_of(c, s, t)
    checks.same("the point's data", figure.block("vector")[0], [*c["p"], *vector])
    checks.near("the point", figure.dots("point"), figure.place(point))
    checks.near("its place", figure.dots("place"), figure.place(point))
    checks.near("the arrow to the point", figure.tips("vector"), figure.place(point))
    eye(figure, c)
    outline(figure, "plane", c)
    arrow(figure, "ahead", c["p"], place_of(c, 0.5, 0.5))
    arrow(figure, "aside", place_of(c, 0.5, 0.5), place_of(c, s, 0.5))
    arrow(figure, "up or down", place_of(c, s, 0.5), point)
    arrow(figure, "across", place_of(c, 0, 0), place_of(c, s, 0), (0, -14))
    arrow(figure, "upward", place_of(c, 1, 0), place_of(c, 1, t), (14, 0))
    arrow(figure, "column", place_of(c, s, 0), point)
    arrow(figure, "row", place_of(c, 1, t), point)
    checks.shows(figure, f"{shown(100 * s)} %", f"{shown(100 * t)} %", f"s = {shown(s)}", f"t = {shown(t)}",
                 "d f + (s − ½) w r + (t − ½) h u", f"= {shown_vector(vector)}")


def double_dwh(c, options, shape, s=0.3, t=0.1):
    figure = drawn(checks, "01-corners", "double-dwh", options, shape)
    figure.see(c["r"], c["u"], c["f"], azimuth=32)
    eye(figure, c)
    # Seen from the eye, everything of another camera is multiplied by one factor.
    larger = {"plane": 1, "twice": 2, "unit": 1 / c["d"]}
    if not 0.08 <= larger["unit"] <= 8:
        larger["unit"] = 0.5 if larger["unit"] < 1 else 3
        checks.that("a plane that is not to scale is said not to be", "not drawn to scale" in " ".join(figure.in_words()))
    note = "" if larger["unit"] == 1 / c["d"] else "not to scale: "
    for title, factor in larger.items():
        outline(figure, title, c, [plus(c["p"], plus(p, c["p"], -1), factor) for p in corners(c)])
    through = [plus(c["p"], vector_to(c, 2 * s - 1, 2 * t - 1), factor) for factor in larger.values()]
    checks.near("all at one place", figure.dots("same place"), [figure.place(p) for p in through])
    far = 1.15 * max(larger.values())
    ends = [plus(c["p"], plus(corners(c)[i], c["p"], -1), far) for i in (0, 1, 3, 2)]
    checks.near("the rays", [stroke[-1] for stroke in figure.strokes("rays")], [figure.place(p) for p in ends])
    checks.near("the ray", figure.tips("one ray"),
                figure.place(plus(c["p"], vector_to(c, 2 * s - 1, 2 * t - 1), far)))
    checks.shows(figure, *(f"{n} = {shown(c[n])}" for n in "dwh"), *(f"2 {n} = {shown(2 * c[n])}" for n in "dwh"),
                 f"{note}d/d = 1", *(f"{n}/d = {shown(c[n] / c['d'])}" for n in "wh"))
    for title, factor in (("plane", 1), ("twice plane", 2), ("unit plane", larger["unit"])):
        upper_left, upper_right, lower_right, _ = (
            plus(c["p"], plus(p, c["p"], -1), factor) for p in corners(c))
        arrow(figure, f"{title} w", upper_left, upper_right, (0, 14))
        arrow(figure, f"{title} h", lower_right, upper_right, (14, 0))
        # Its distance is drawn below all planes, as long as it is, along f.
        start, end = [plus(p, figure.place(c["p"]), -1) for p in figure.tips(f"{title} d")][::-1]
        ahead = plus(figure.place(plus(c["p"], c["f"], factor * c["d"])), figure.place(c["p"]), -1)
        checks.near(f"the dimension {title} d", [plus(end, start, -1)], [ahead])
        checks.that(f"it is below: {title} d", start[1] < figure.place(lower_right)[1] - figure.place(c["p"])[1]
                    and abs(start[0]) < 0.1)


def yours_beside_right():
    """Another camera instead of a wrong answer: both are drawn, the other one dashed."""
    wrong = dict(DECK, w=3)
    figure, same = beside_right("01-corners", "corner-vectors", wrong, DECK)
    figure.see(DECK["r"], DECK["u"], DECK["f"], azimuth=34)
    ends = [plus(c["p"], vector_to(c, 1, 1)) for c in (DECK, wrong)]
    checks.near("right and yours", figure.tips("upper right"), [figure.place(p) for p in ends])
    dashed = [path.get("stroke-dasharray") for group in figure.groups("upper right")
              for path in group.iter() if "M" in (path.get("d") or "") and "Z" not in path.get("d")]
    checks.that("only yours is dashed", [d is not None for d in dashed] == [False, True], str(dashed))
    checks.that("the words name the dashed one", "dashed: yours" in " ".join(w for w, _, _ in figure.labels()))
    checks.that("a right answer is drawn alone", len(same.tips("upper right")) == 1)
    on_the_canvas(checks, "yours beside right", figure)
    nothing_collides(checks, "yours beside right", figure)


def yours_and_right(c, options, yours=None):
    """The point 30% across and 10% up; by default, an answer that starts from the middle."""
    figure = Figure("01-corners", "yours-and-right", *options)
    figure.see(c["r"], c["u"], c["f"])
    right = vector_to(c, -0.4, -0.8)
    yours = yours or vector_to(c, 0.6, 0.2)
    checks.same("yours and right: data", [figure.block("answer")[0], figure.block("yours")[0]],
                [[*c["p"], *right], [*c["p"], *yours]])
    checks.near("yours and right: right", figure.tips("right"), figure.place(plus(c["p"], right)))
    checks.near("yours and right: yours", figure.tips("yours"), figure.place(plus(c["p"], yours)))
    return figure


def is_said(figure, off):
    checks.that("yours and right: the difference", figure.text("off_text") == off, figure.text("off_text"))


OPTIONS = [*options_of(DECK), "-s", 0.3, "-t", 0.1]  # the lecture may have another example
FIGURES = {"camera-frame": camera_frame, "corner-vectors": corner_vectors,
           "point-30-10": point_30_10, "double-dwh": double_dwh}
for name, test in FIGURES.items():
    for canvas in SHAPES:
        test(DECK, OPTIONS, canvas)
    holds_for_every(checks, "01-corners", name)
yours_beside_right()
dice = random.Random(1)
for i in range(int(os.environ.get("CAMERAS", "5"))):
    across, up = dice.uniform(0, 1), dice.uniform(0, 1)
    for test in FIGURES.values():
        camera = some_camera(dice, 10 ** dice.uniform(-6, 6))
        more = [] if test in (camera_frame, corner_vectors) else [across, up]
        test(camera, options_of(camera) + (["-s", across, "-t", up] if more else []), SHAPES[i % 2], *more)
    yours_and_right(camera, options_of(camera))
is_said(yours_and_right(DECK, OPTIONS), "off by (1, 1, 0) = ½ w r + ½ h u")
is_said(yours_and_right(DECK, [*OPTIONS, "--yours", "-0.4,0.8,4"], (-0.4, 0.8, 4)), "off by (0, 1.6, 0) = 4/5 h u")
is_said(yours_and_right(DECK, [*OPTIONS, "--yours", "0.123,0.4567,4"], (0.123, 0.4567, 4)), "off by (0.523, 1.2567, 0)")
holds_for_every(checks, "01-corners", "yours-and-right")
checks.end()
