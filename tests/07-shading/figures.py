"""figures.py - the figures of chapter 07 are right."""
import base64
import math
import os
import random
import re
import struct
import tempfile

import png
from check import Checks, holds_for_every, labels_are_clear, on_the_canvas, told_in_words
from figure import Figure, SVG, XLINK, dot, plus, times, unit

checks = Checks("figures of 07-shading")

# The deck's spheres (deck units negated in z, as NFF has it), the scene's light, Phong's model.
SPHERES = [((2, 2, 1), (1, 0, 0)), ((2, -2, 0), (0, 1, 0)), ((-2, 0, -1), (0, 0, 1))]
RADIUS, EYE, ANGLE, LIGHT = 3, (0, 0, 20), 42, (-8, 14, 16)
KD, KS, SHINE, AMBIENT, GREY = 0.9, 0.5, 40, 0.1, 127
COLUMNS, ROWS, SAMPLES = 920, 690, 2


def meets(origin, direction, center):
    """The point where a line of unit direction enters a sphere, from the center's distance to it."""
    to_center = plus(center, origin, -1)
    ahead = dot(to_center, direction)
    square = RADIUS ** 2 - (dot(to_center, to_center) - ahead ** 2)
    return ahead - math.sqrt(square) if square >= 0 and ahead > 0 else math.inf


def seen_at(x, y):
    """(flat, shaded, which sphere, whether in a shadow) at a place of the picture, in pixels from its upper left."""
    half = math.tan(math.radians(ANGLE / 2))
    way = unit(((2 * x / COLUMNS - 1) * half, (1 - 2 * y / ROWS) * half * ROWS / COLUMNS, -1))
    t, i = min((meets(EYE, way, center), i) for i, (center, _) in enumerate(SPHERES))
    if t == math.inf:
        return (GREY / 255,) * 3, (GREY / 255,) * 3, None, False
    center, color = SPHERES[i]
    point = plus(EYE, way, t)
    normal = unit(plus(point, center, -1))
    to_light = unit(plus(LIGHT, point, -1))
    start = plus(point, normal, 1e-6)
    dark = any(meets(start, to_light, other) < 99 for other, _ in SPHERES)
    cosine = 0 if dark else max(0, dot(normal, to_light))
    mirrored = plus(times(2 * dot(normal, to_light), normal), to_light, -1)
    shine = KS * max(0, -dot(mirrored, way)) ** SHINE if cosine > 0 else 0
    return color, [min(1, KD * c * (AMBIENT + cosine) + shine) for c in color], i, dark and dot(normal, to_light) > 0


def mean_at(column, row):
    """(flat, shaded) bytes of a pixel, the mean of its samples; and what its samples see."""
    seen = [seen_at(column + (i + 0.5) / SAMPLES, row + (j + 0.5) / SAMPLES) for i in range(SAMPLES) for j in range(SAMPLES)]
    means = [[255 * sum(sample[which][k] for sample in seen) / len(seen) for k in range(3)] for which in (0, 1)]
    return (*means, {(sample[2:]) for sample in seen})


def picture(figure, name):
    """A picture of the script: its width, its height, and its bytes."""
    text = re.search(r"^\$" + name + r" << EOD\n#[^\n]*\n(.*?)\nEOD$", figure.script, re.M | re.S)[1]
    data = base64.b64decode(text)
    return (*struct.unpack(">II", data[16:24]), png.decoded(data))


def drawn_pictures(figure):
    """The pictures of the drawn figure, from the left: where each is on the canvas, and its PNG."""
    found = []
    for image in figure.svg.iter(SVG + "image"):
        x, y, wide, tall = (float(image.get(key)) for key in ("x", "y", "width", "height"))
        found.append(((x, figure.height - y - tall, wide, tall), base64.b64decode(image.get(XLINK + "href").split(",")[1])))
    return sorted(found)


figure = Figure("07-shading", "flat-and-shaded")
pictures = {name: picture(figure, name) for name in ("flat", "shaded")}
for name, (wide, tall, _) in pictures.items():
    checks.that(f"the {name} picture has two pixels for a unit of the canvas", (wide, tall) == (COLUMNS, ROWS), f"{wide}, {tall}")
dice = random.Random(7)
places = [(dice.randrange(COLUMNS), dice.randrange(ROWS)) for _ in range(int(os.environ.get("PIXELS", "600")))]
wrong = {"flat": 0, "shaded": 0}
for column, row in places:
    *wanted, seen = mean_at(column, row)
    for name, goal in zip(("flat", "shaded"), wanted):
        got = pictures[name][2][3 * (row * COLUMNS + column):][:3]
        wrong[name] += max(abs(a - b) for a, b in zip(got, goal)) > (1 if len(seen) == 1 else 30)
checks.that("every pixel of the flat picture agrees with the light model", wrong["flat"] == 0, f"{wrong['flat']} do not")
checks.that("and of the shaded one", wrong["shaded"] == 0, f"{wrong['shaded']} do not")
(x, y), = figure.block("highlight")
reds = [(mean_at(c, r)[1][1], c, r) for c in range(8, COLUMNS, 16) for r in range(8, ROWS, 16)
        if mean_at(c, r)[2] == {(0, False)}]
_, c, r = max(reds)
checks.that("the highlight is where the red sphere is whitest", math.hypot(x - c, ROWS - y - r) <= 20, f"{x}, {y}, not {c}, {r}")
(x, y), = figure.block("shadow")
checks.that("the shadow is in the shadow of a sphere", all(
    seen_at(x + dx, ROWS - y + dy)[3] for dx in (-9, 0, 9) for dy in (-9, 0, 9)))

# What is drawn: the two pictures, whole, side by side, one a step.
(left, flat), (right, shaded) = drawn_pictures(figure)
checks.that("the drawn pictures are those of the script, to the last byte",
            [png.decoded(flat, "flat"), png.decoded(shaded, "shaded")] == [pictures[name][2] for name in ("flat", "shaded")])
checks.that("they are side by side, and as large as each other",
            left[0] + left[2] < right[0] and max(abs(a - b) for a, b in zip(left[1:], right[1:])) < 0.1, f"{left}, {right}")
checks.that("with square pixels", abs(left[2] / left[3] - COLUMNS / ROWS) < 1e-3, f"{left}")
checks.that("the first step has the flat one alone", len(drawn_pictures(Figure(
    "07-shading", "flat-and-shaded", settings="step=1"))) == 1)
for shape in ("16:9", "4:3"):
    canvas = Figure("07-shading", "flat-and-shaded", settings=f"shape='{shape}'")
    tops = [text.box[3] for text in canvas.texts()] + [box[1] + box[3] for box, _ in drawn_pictures(canvas)]
    checks.that(f"{shape}: there is room for a slide's title", max(tops) <= 0.87 * canvas.height, str(max(tops)))
holds_for_every(checks, "07-shading", "flat-and-shaded")


def pointed_at(name, text):
    """Which of the two words the figure of this scene has."""
    with tempfile.NamedTemporaryFile("w", suffix=".nff", encoding="ascii") as file:
        file.write(text)
        file.flush()
        own = Figure("07-shading", "flat-and-shaded", file.name)
    told_in_words(checks, name, own)
    on_the_canvas(checks, name, own)
    words = {text.words for text in own.texts()} & {"highlight", "shadow"}
    told = {word for word in ("highlight", "shadow") if word in own.in_words()[1].lower()}
    checks.that(f"{name}: the words name what the arrows point at", words == told, f"{words}, {told}")
    return own, words


VIEW = "b 0.5 0.7 0.9\nv\nfrom 0 1.5 6\nat 0 1 0\nup 0 1 0\nangle 50\nresolution 320 240\nl 5 8 6\n"
own, words = pointed_at("a ground", VIEW + "f 0.5 0.5 0.5 1 0 1 0 1\ns 0 -1000 0 1000\n"
                        "f 0.8 0.2 0.2 0.7 0.3 20 0 1\ns -1.2 1 0 1\n")
checks.that("on a ground: both", len(words) == 2, str(words))
(x, y), = own.block("highlight")
wide, tall, rgb = picture(own, "flat")
red, green, _ = rgb[3 * (int(tall - y) * wide + int(x)):][:3]
checks.that("the highlight is on the shiny sphere, not on the ground", red > 2 * green, f"{red}, {green}")
own, words = pointed_at("alone and dull", VIEW + "f 0.5 0.5 0.5 1 0 1 0 1\ns 0 1 0 1\n")
checks.that("alone and dull: neither", not words, str(words))

# ---- the flat figures: light and eye in the plane of the paper -------------------------------------
# Directions are angles from the x axis, so nothing here is a dot product.

P = "07-shading"


def plane(name, light=None, eye=None):
    """The figure and its options."""
    options = [f"--{what}={place[0]:.17g},{place[1]:.17g},0" for what, place in (("light", light), ("eye", eye)) if place]
    return Figure(P, name, *options), options


def angle(start, end):
    return math.atan2(end[1] - start[1], end[0] - start[0])


def apart(one, other):
    """Of two angles, 0 to pi."""
    return abs(math.remainder(one - other, 2 * math.pi))


def surface_vectors(light=(-2.4, 1.7), eye=(1.5, 1.9), given=True):
    """At the top of the sphere, where the normal is straight up."""
    figure, options = plane("surface-vectors", light, eye) if given else plane("surface-vectors")
    up, l, e = math.pi / 2, angle((0, 0), light), angle((0, 0), eye)
    m, h = math.pi - l, l + math.remainder(e - l, 2 * math.pi) / 2
    start, scale = figure.dots("point")[0], figure.tips("n")[0][1] - figure.dots("point")[0][1]
    for title, way in (("n", up), ("l", l), ("m", m), ("e", e), ("h", h)):
        checks.near(f"the arrow {title}", figure.tips(title), (start[0] + scale * math.cos(way), start[1] + scale * math.sin(way)), 0.3)
    for name, between in (("diffuse", apart(up, l)), ("phong", apart(m, e)), ("halfway", apart(up, h))):
        checks.same(f"the cosine of {name}", [figure.number(name)], [max(0, math.cos(between))])
    return options


def beam_and_lobe(light=(-1.5, 1.6), given=True):
    figure, options = plane("beam-and-lobe", light) if given else plane("beam-and-lobe")
    l = angle((0, 0), light)
    slant = math.cos(apart(l, math.pi / 2))
    checks.same("the cosine", [figure.number("cosine")], [slant])
    checks.that("a beam arrives", (figure.number("arrives") == 1) == (slant > 0.15))
    if slant > 0.15:
        edges = figure.strokes("beam")
        (ax, ay), (bx, by) = (edge[-1] for edge in edges)
        (cx, cy), (dx, dy) = figure.ends("across")[0], figure.ends("across")[1]
        checks.that("the beam is narrow across, and wide on the surface",
                    abs(math.hypot(dx - cx, dy - cy) / math.hypot(bx - ax, by - ay) - slant) < 0.01)
        checks.that("across is at right angles to the beam", abs(apart(angle((cx, cy), (dx, dy)), l) - math.pi / 2) < 0.01)
    for name, shine in (("wide_lobe", 8), ("narrow_lobe", 80)):
        for i, (x, y, _) in enumerate(figure.block(name)):
            bright = max(0, math.cos(apart(math.pi - l, math.pi * i / 180))) ** shine
            checks.that(f"{name}: as far as it is bright", abs(math.hypot(x, y) - bright) < 1e-5)
    return options


BALLS = [((0, -0.4), 1.5), ((0.2, 2.6), 0.45), ((4.1, 2.7), 0.9)]


def first(start, way, without=None):
    """The nearest distance along a direction at which a circle is met, by the center's distance from the line; and which."""
    found = [(math.inf, None)]
    for i, ((x, y), r) in enumerate(BALLS):
        turned = angle(start, (x, y)) - way
        away, along = math.dist(start, (x, y)) * math.sin(turned), math.dist(start, (x, y)) * math.cos(turned)
        if i != without and abs(away) < r and along > 0:
            found.append((along - math.sqrt(r * r - away * away), i))
    return min(found)


def shadow_and_mirror(light=(0.3, 4.2), eye=(-4.4, 2.6), given=True):
    figure, options = plane("shadow-and-mirror", light, eye) if given else plane("shadow-and-mirror")
    way = angle(eye, (0.2, 1))
    t, which = first(eye, way)
    point = eye[0] + t * math.cos(way), eye[1] + t * math.sin(way)
    checks.same("the point", figure.block("point")[0][:2], point)
    normal = angle(BALLS[which][0], point)
    mirrored = 2 * normal + math.pi - way
    *_, x, y, _ = figure.block("mirrored")[0]
    checks.that("the mirrored ray leaves as it came", apart(math.atan2(y, x), mirrored) < 1e-6)
    t, other = first(point, mirrored, which)
    if other is not None:
        checks.same("and ends on the sphere that it meets", [math.hypot(x, y)], [t], within=1e-4)
    to_light = angle(point, light)
    behind = apart(to_light, normal) > math.pi / 2
    blocked = behind or first(point, to_light, which)[0] < math.dist(point, light)
    checks.that("the light arrives or not", figure.number("visibility") == (0 if blocked else 1))
    return options


def dark_and_lit(figure, name, light):
    """Of the pixels that face the light by far, how many are dark."""
    wide, tall, rgb = picture(figure, name)
    found, to_light = [], unit((3 * light[0], 3 * light[1], 6))
    for row in range(tall):
        for column in range(wide):
            x, y = 2.25 * ((column + 0.5) / wide - 0.5), 2.25 * (0.5 - (row + 0.5) / tall)
            if x * x + y * y < 0.8 and dot((x, y, math.sqrt(1 - x * x - y * y)), to_light) > 0.4:
                found.append(rgb[3 * (row * wide + column)])
    return sum(byte < 60 for byte in found), len(found)


def self_hit(light=(0.85, 1.8), eye=(-1.15, 1.575), given=True):
    """A unit sphere around the origin; the eye's ray goes to its top."""
    figure, options = plane("self-hit", light, eye) if given else plane("self-hit")
    *seen, = figure.block("seen_1")[0]
    checks.same("the ray goes from the eye to the top of the sphere", seen, [*eye, 0, -eye[0], 1 - eye[1], 0])
    checks.same("the normal goes up", unit(figure.block("normal")[0][3:]), [0, 1, 0])
    *_, ox, oy, oz = figure.block("offset")[0]
    checks.that("the real start is off by 2^-32 to 2^-28 of the numbers", 2 ** -32 <= oy <= 2 ** -28, str(oy))
    checks.that("outward", math.hypot(ox, oz) < 1e-6 * oy)
    checks.that("the real point is a rounding inside", 0 < figure.number("inside_by") < 4e-15, figure.number("inside_by"))
    checks.that("its ray to the light hits the sphere at once", 0 < figure.number("self_t") < 1e-14)
    checks.that("not so from the real start", math.isnan(figure.number("start_t")))
    # What is drawn, far too large: the point inside, the start outside, both in the direction of the normal.
    (ix, iy, iz), = figure.block("inside")
    deep = 1 - iy
    checks.that("it is drawn large enough to be seen", 0.1 < deep < 0.4, str(deep))
    checks.same("the point is inside, below the hit", [ix, iz], [0, 0])
    checks.same("the start is as far outside", figure.block("outside")[0], [0, 1 + deep, 0])
    # From inside, the line of the angle a leaves the circle by the law of sines.
    a = angle((0, iy), light)
    leaves = a + math.asin(iy * math.cos(a))
    checks.same("its ray to the light meets the sphere from inside", figure.block("own_hit")[0], [math.cos(leaves), math.sin(leaves), 0])
    *start, tx, ty, tz = figure.block("to_light")[0]
    checks.that("the other one goes towards the light", apart(math.atan2(ty, tx), angle((0, 1 + deep), light)) < 1e-5)
    lights = (figure.dots("light") + figure.dots("light, right"))
    middle = figure.dots("point")[0]
    scale = (lights[0][1] - middle[1]) / (light[1] - 1)
    for title, place in (("rounded", (ix, iy)), ("self hit", (math.cos(leaves), math.sin(leaves))), ("light", light)):
        checks.near(f"{title}: drawn at its place", figure.dots(title), (middle[0] + scale * place[0], middle[1] + scale * (place[1] - 1)))
    (x, y), = figure.dots("start")
    checks.near("and the light of the right panel", lights[1:], (x + scale * light[0], y + scale * (light[1] - 1 - deep)))
    checks.that("which is beside the left one", lights[1][0] - lights[0][0] > figure.width / 3)
    dark, lit = dark_and_lit(figure, "specks", light)
    checks.that("without the remedy the picture has specks", 0.1 * lit < dark < 0.9 * lit, f"{dark} of {lit}")
    dark, lit = dark_and_lit(figure, "smooth", light)
    checks.that("with it there are none", dark == 0 and lit > 3000, f"{dark} of {lit}")
    checks.that("both are drawn, at the same height", [box[1] for box, _ in drawn_pictures(figure)] == 2 * [
        drawn_pictures(figure)[0][0][1]])
    return options


surface_vectors(given=False)
beam_and_lobe(given=False)
shadow_and_mirror(given=False)
self_hit(given=False)
beam_and_lobe((-2, 0.1))
for name in ("surface-vectors", "beam-and-lobe", "shadow-and-mirror", "self-hit"):
    holds_for_every(checks, P, name)
for _ in range(int(os.environ.get("SCENES", "5"))):
    above = [(dice.uniform(-3, 3), dice.uniform(0.6, 3)) for _ in range(2)]
    labels_are_clear(checks, P, "surface-vectors", surface_vectors(*above))
    labels_are_clear(checks, P, "beam-and-lobe", beam_and_lobe(above[0]))
    labels_are_clear(checks, P, "shadow-and-mirror", shadow_and_mirror(
        (dice.uniform(-3, 5), dice.uniform(3.5, 5)), (dice.uniform(-6, -3), dice.uniform(2, 4))))
    labels_are_clear(checks, P, "self-hit", self_hit(*((dice.uniform(-3, 3), dice.uniform(1.5, 4)) for _ in range(2))))
checks.end()
