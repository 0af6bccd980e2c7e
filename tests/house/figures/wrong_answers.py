"""wrong_answers.py - a wrong answer beside the right one: each mark is where it belongs.

Every case is a mistake that is put into a solution. The right result and the result of the mistake for
the deck's numbers are worked out here again, by hand.
"""
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

import png
from cameras import DECK, vector_to
from check import SHAPES, Checks, nothing_collides
from figure import Figure, dot, plus, times

checks = Checks("yours beside right")
answers = sys.argv[1]
FRAME = (DECK["r"], DECK["u"], DECK["f"])


def place(s, t):
    """From the eye to a place of the image plane."""
    return vector_to(DECK, 2 * s - 1, 2 * t - 1)


def judge(stem, *changes):
    """Puts the changes into a solution. Returns the verdict and the folder of figures."""
    shutil.rmtree(answers, ignore_errors=True)
    os.makedirs(answers)
    with open(f"solutions/{stem}.c", encoding="utf-8") as file:
        text = file.read()
    for old, new in changes:
        if old not in text:
            raise AssertionError(f"solutions/{stem}.c has no {old!r} any more")
        text = text.replace(old, new)
    with open(f"{answers}/{stem}.c", "w", encoding="utf-8") as file:
        file.write(text)
    # What 'make exercises' starts: make itself is asked only once, for the plan.
    plan = f"build{answers}/verdict/plan"
    command = ["build/course", "exercises", plan, stem] if os.path.exists(plan) else [
        "make", "--no-print-directory", "exercises", f"ANSWERS={answers}", f"EX={stem[:2]}"]
    done = subprocess.run(
        command, env={**os.environ, "NO_COLOR": "1", "ALL": "1"}, capture_output=True, text=True,
        check=False, timeout=120)
    return done.stdout + done.stderr, f"build{answers}/figures"


def figure_of(name, stem, *changes):
    said, folder = judge(stem, *changes)
    line = f"  see        {folder}/{name}.svg\n"
    checks.that(f"{name}: its path is in the verdict", line in said, said)
    if not os.path.exists(f"{folder}/{name}.svg"):
        checks.that(f"{name}: it is drawn", False)
        return None
    with open(f"{folder}/{name}.gp", encoding="utf-8") as file:
        figure = Figure(None, name, script=file.read())
    for shape in SHAPES:
        again = Figure(None, name, script=figure.script, settings=f"shape='{shape}'; theme='dark'")
        nothing_collides(checks, f"{name}, {shape}", again)
    with open(f"{folder}/{name}.svg", encoding="utf-8") as file:
        svg = file.read()
    for key in ("answer_text", "yours_text"):
        checks.that(f"{name}: {key} is in the words of the figure",
                    figure.text(key) in svg.split("</desc>")[0], figure.text(key))
    # A vector may be called right: what is expected has another word.
    labels = svg.replace("<title>right", "")
    checks.that(f"{name}: nothing is labelled 'right'", ">right" not in labels and "expected: " in labels)
    checks.that(f"{name}: 'dashed' is said if something is", ("dashed" in svg) == ("stroke-dasharray" in svg))
    figure.said = said
    return figure


def has_words(figure, right, yours, off="", why=""):
    for key, wanted in (("answer_text", right), ("yours_text", yours), ("off_text", off)):
        checks.that(f"{figure.text('asked')}: {key}", figure.text(key) == wanted,
                    f"{figure.text(key)!r}, expected {wanted!r}")
    checks.that(f"{figure.text('asked')}: why", why in figure.text("why"), figure.text("why"))


# ---- vectors from the eye ---------------------------------------------------------------------------

def vector(name, change, right, yours, off, why):
    figure = figure_of(name, "01-corners", change)
    if figure is None:
        return
    p = DECK["p"]
    figure.see(*FRAME)
    checks.same(f"{name}: data of the right vector", figure.block("answer")[0], [*p, *right])
    checks.same(f"{name}: data of yours", figure.block("yours")[0], [*p, *yours])
    checks.near(f"{name}: the right arrow", figure.tips("right"), figure.place(plus(p, right)))
    checks.near(f"{name}: your arrow", figure.tips("yours"), figure.place(plus(p, yours)))
    checks.near(f"{name}: the difference", figure.tips("off by"), figure.place(plus(p, yours)))
    checks.near(f"{name}: the eye", figure.dots("eye"), figure.place(p))
    outline = [figure.place(plus(p, place(s, t))) for s, t in ((0, 1), (1, 1), (1, 0), (0, 0), (0, 1))]
    checks.near(f"{name}: the plane", figure.lines("plane")[0], outline)
    has_words(figure, *(f"({', '.join(f'{x:g}' for x in v)})".replace("-", "−") for v in (right, yours)),
              off, why)


vector("upper_left", ("c.distance * c.forward - c.width / 2", "c.distance * c.forward - c.width"),
       (-1, 1, 4), (-2, 1, 4), "off by (−1, 0, 0) = −½ w r", "the whole width")
vector("upper_right", ("c.distance * c.forward + c.width / 2", "c.distance * c.forward - c.width / 2"),
       (1, 1, 4), (-1, 1, 4), "off by (−2, 0, 0) = −w r", "")
vector("across_30_up_10", ("image_plane_vector(c, 0.3, 0.1)", "image_plane_vector(c, 0.8, 0.6)"),
       (-0.4, -0.8, 4), (0.6, 0.2, 4), "off by (1, 1, 0) = ½ w r + ½ h u", "from the middle")

# ---- rays -------------------------------------------------------------------------------------------

# The upper left pixel of 640 x 480; the frame's sides are exchanged, and the ray begins elsewhere.
figure = figure_of("pixel_ray", "04-pixel-ray", ("(Ray){camera.origin, ", "(Ray){-camera.origin, 2 * "))
if figure is not None:
    v = place(0.5 / 640, 1 - 0.5 / 480)
    figure.see(*FRAME)
    checks.near("pixel_ray: the right arrow", figure.tips("right"), figure.place(plus(DECK["p"], v)))
    checks.near("pixel_ray: yours, as long", figure.tips("yours"), figure.place(plus(v, DECK["p"], -1)))
    start = figure.place(times(-1, DECK["p"]))
    nearest = min((place for line in figure.lines("yours") for place in line), key=lambda p: math.dist(p, start))
    checks.near("pixel_ray: yours begins", [nearest], [start])

figure = figure_of("to_object_coordinates", "05-quadratic",
                   ("ray.origin - sphere.center, ray.direction", "ray.origin + sphere.center, ray.direction"))
if figure is not None:
    # From (1, 2, 3) along (0, 0, -1), round (4, -1, 1): seen from the side of the center.
    right, yours, v = (-3, 3, 2), (5, 1, 4), (0, 0, -1)
    up = times(1 / math.sqrt(18), (3, -3, 0))
    side = (v[1] * up[2] - v[2] * up[1], v[2] * up[0] - v[0] * up[2], v[0] * up[1] - v[1] * up[0])
    figure.see(side, up, v, azimuth=16, elevation=12)
    checks.near("object: the right arrow", figure.tips("right"), figure.place(plus(right, v)))
    checks.near("object: your arrow", figure.tips("yours"), figure.place(plus(yours, v)))
    checks.near("object: the center", figure.dots("center"), figure.place((0, 0, 0)))
    has_words(figure, "from (−3, 3, 2) along (0, 0, −1)", "from (5, 1, 4) along (0, 0, −1)",
              "starts off by (8, −2, 2)", "p + C")

# ---- cameras ----------------------------------------------------------------------------------------

figure = figure_of("with_unit_distance", "01-corners", ("c.height /= c.distance;", ""))
if figure is not None:
    # d 2, w 6, h 4
    p = DECK["p"]
    figure.see(*FRAME)
    for i, right, yours in ((0, (0, 0, 1), (0, 0, 1)), (1, (3, 0, 0), (3, 0, 0)), (2, (0, 2, 0), (0, 4, 0))):
        label = ("d f", "w r", "h u")[i]
        checks.near(f"camera: right {label}", figure.tips(f"right {label}"), figure.place(plus(p, right)))
        checks.near(f"camera: yours {label}", figure.tips(f"yours {label}"), figure.place(plus(p, yours)))
    has_words(figure, "h 2", "h 4", "", "the height is unchanged")
figure = figure_of("camera_from_look_at", "02-cameras", ("world == RIGHT_HANDED", "world != RIGHT_HANDED"))
if figure is not None:
    has_words(figure, "r (1, 0, 0)", "r (−1, 0, 0)", "", "")

# ---- places -----------------------------------------------------------------------------------------


def places(name, change, from_where, given, into, right, yours, words):
    figure = figure_of(name, "03-screen", change)
    if figure is None:
        return
    if given is not None:
        checks.near(f"{name}: the argument", figure.dots("given"), figure.see_flat(2)(*given))
    checks.near(f"{name}: right", figure.dots("right"), figure.see_flat(1)(*right))
    checks.near(f"{name}: yours", figure.dots("yours"), figure.see_flat(1)(*yours))
    for title, number, wanted in (("into", 1, into), ("from", 2, from_where)):
        if wanted is not None:
            checks.near(f"{name}: the corners of {title}", figure.polygons(title)[0][:4],
                        [figure.see_flat(number)(*corner) for corner in wanted])
    has_words(figure, *words)


SCREEN = ((0, 0), (640, 0), (640, -480), (0, -480))
SQUARE = ((0, 0), (1, 0), (1, 1), (0, 1))
# Of x only the rounding differs, which is not shown.
places("screen_to_normalized", ("width, 1 - point.y", "width * (1 + 4e-16), point.y"), SCREEN, (300, -400),
       SQUARE, (0.46875, 1 / 6), (0.46875, 5 / 6),
       ("(0.46875, 0.166667)", "(0.46875, 0.833333)", "off by (0, 0.666667)", "y counts down"))
places("normalized_to_screen", ("(1 - normalized.t)", "normalized.t"), SQUARE, (0.46875, 1 / 6),
       SCREEN, (300, -400), (300, -80), ("(300, 400)", "(300, 80)", "off by (0, −320)", ""))
places("pixel_center", ("pixel.column + 0.5, pixel.row + 0.5", "pixel.column, pixel.row"), None, None,
       ((0, 0), (1, 0), (1, -1), (0, -1)), (0.5, -0.5), (0, 0), ("(0.5, 0.5)", "(0, 0)", "off by (−0.5, −0.5)", ""))

# ---- rectangles -------------------------------------------------------------------------------------

# Sides 9, 40, 41: the tangents of the right answer are 9/40 aside, and those of this mistake 9 * 41 / 40^2.
figure = figure_of("sphere_rectangle", "08-fast", ("sqrt(aside * aside + g)", "sqrt(aside * aside + ahead * ahead)"))
if figure is not None:
    at = figure.see_flat()

    def corners_of(m):
        x, y = 1280 * m, 960 * m
        return [at(320 + i * x, -240 + j * y) for i, j in ((-1, 1), (1, 1), (1, -1), (-1, -1), (-1, 1))]

    outline = figure.lines("outline")[0]
    ends = [(f(x for x, _ in outline), f(y for _, y in outline)) for f in (min, max)]
    checks.near("sphere_rectangle: right", figure.lines("right")[0], corners_of(9 / 40))
    checks.near("sphere_rectangle: yours", figure.lines("yours")[0], corners_of(9 * 41 / 1600))
    checks.near("sphere_rectangle: the outline reaches the edges", ends, [at(32, -456), at(608, -24)])
    has_words(figure, "x 32 to 608, y 24 to 456", "x 24.8 to 615.2, y 18.6 to 461.4", "", "under the root")

# Of one that is too small to be seen the place is marked.
figure = figure_of("sphere_rectangle", "08-fast", ("r = sphere.radius", "r = 0.002 * sphere.radius"))
if figure is not None:
    checks.near("sphere_rectangle: a tiny one has a mark", figure.dots("yours, tiny"), figure.see_flat()(320, -240), 1)

# ---- roots and hits -----------------------------------------------------------------------------------


def section(name, stem, change, p, v, spheres, right, yours, words):
    """p, v: the ray; spheres: center and radius; right and yours: t."""
    figure = figure_of(name, stem, change)
    if figure is None:
        return
    unit = math.sqrt(dot(v, v))
    at = figure.see_flat()
    circles = []
    for center, radius in spheres:
        away = plus(center, p, -1)
        along = dot(away, v) / unit
        circles.append((along, -math.sqrt(max(0, dot(away, away) - along * along)), radius))
    axis = figure.strokes("axis")[0][0][1]
    checks.that(f"{name}: the axis is below", axis < at(0, min(y - r for _, y, r in circles))[1] - 20, str(axis))
    for title, wanted in (("right", right), ("yours", yours)):
        ts = [at(t * unit, 0) for t in wanted]
        if not ts:
            checks.that(f"{name}: nothing is drawn as {title}", title not in figure.plots or not figure.dots(title))
            continue
        checks.near(f"{name}: {title} on the ray", figure.dots(title), ts)
        checks.near(f"{name}: {title} on the axis", figure.dots(f"{title}, on the axis"), [(x, axis) for x, _ in ts])
    checks.near(f"{name}: the spheres", figure.circles("spheres"),
                [(*at(x, y), figure.chosen("size[1]") * r) for x, y, r in circles])
    has_words(figure, *words)


DECKS = ((-4, -1, 0), (1, 0.5, 0), [((0, 0, 0), 1)])
section("sphere_roots", "05-quadratic",
        ("    return quadratic_roots(object_quadratic(", "    ray.direction = -ray.direction;\n    return quadratic_roots(object_quadratic("),
        *DECKS, (3.2, 4), (-4, -3.2), ("t = 3.2 and 4", "t = −4 and −3.2"))
hits = tuple((8.02 + sign * math.sqrt(8.02 ** 2 - 4 * 0.9946 * 16)) / (2 * 0.9946) for sign in (-1, 1))
section("hit_sphere", "05-quadratic",
        ("    for (int i = 0; i < roots.count; i++)\n        if (roots.t[i] > 0)",
         "    for (int i = roots.count; i-- > 0;)\n        if (roots.t[i] > 0)"),
        (-4, -1, 0), (0.89, 0.45, 0), [((0, 0, 0), 1)], hits[:1], hits[1:],
        ("t = 3.62151", "t = 4.44203", "off by 0.8205", "the far root"))
section("hit_sphere", "05-quadratic", ("if (roots.t[i] > 0)", "if (roots.t[i] > 1000)"),
        (-4, -1, 0), (0.89, 0.45, 0), [((0, 0, 0), 1)], hits[:1], (), ("t = 3.62151", "no hit"))
section("nearest_hit", "06-ray-casting", ("if (t < nearest.t)", "if (t < NO_HIT)"),
        (0, 0, 0), (0, 0, -1), [((0, 0, -4), 1), ((0, 0, -7), 1), ((0, 0, -10), 1)], (3,), (9,),
        ("sphere 0 at t = 3", "sphere 2 at t = 9", "off by 6", "the last sphere"))

figure = figure_of("quadratic_roots", "05-quadratic",
                   ("u = (-q.b + sqrt(D)) / (2 * q.a);", "u = (-q.b + sqrt(D)) / (2 * q.a) + 0.4;"))
if figure is not None:
    scale, at = figure.number("scale_of_f"), figure.see_flat()

    def on_axis(t, f=0.0):
        return at(t, scale * f)
    yours = (3.2, 4.4)
    checks.near("quadratic_roots: right", figure.dots("right"), [on_axis(3.2), on_axis(4)])
    checks.near("quadratic_roots: yours", figure.dots("yours"), [on_axis(t) for t in yours])
    off = [abs(f / scale - (1.25 * t * t - 9 * t + 16)) for t, f, _ in figure.block("curve")]
    checks.that("quadratic_roots: the curve is the quadratic's", max(off) < 1e-6, str(max(off)))
    # The lowest point of the parabola, f = 16 - 81/5 = -0.2.
    ys = [y for line in figure.lines("curve") for _, y in line]
    checks.near("quadratic_roots: its lowest point", [(0, min(ys))], [(0, on_axis(3.6, -0.2)[1])], within=0.6)

figure = figure_of("object_quadratic", "05-quadratic", ("2 * vec3_dot(p, v)", "vec3_dot(p, v)"))
if figure is not None:
    scale = figure.number("scale_of_f")
    for name, b in (("curve", -8.02), ("your_curve", -4.01)):
        off = [abs(f / scale - (0.9946 * t * t + b * t + 16)) for t, f, _ in figure.block(name)]
        checks.that(f"object_quadratic: {name}", off and max(off) < 1e-5, str(off))
    has_words(figure, "a = 0.9946, b = −8.02, c = 16", "a = 0.9946, b = −4.01, c = 16", "", "")

# ---- pictures ---------------------------------------------------------------------------------------

said, folder = judge("06-ray-casting", ("if (t < depth[i])", "if (t < NO_HIT)"))
path = f"{folder}/cast_object_order.png"
checks.that("a wrong picture: its path is in the verdict", f"  see        {path}\n" in said, said)
# Green under red: 5 x 3 pixels, each 57 wide; yours has green in the middle as well.
GREY, RED, GREEN = (89, 115, 140), (217, 38, 1), (51, 191, 115)
ALIKE, DIFFER = (31, 36, 43), (255, 209, 89)
(width, _), colors = png.read(Path(path).read_bytes(), path)
cross = ["..g..", ".grg.", "..g.."]
wrong = []
for panel in range(3):
    for row in range(3):
        for column in range(5):
            at = 3 * ((40 + 57 * row + 28) * width + 16 + panel * (5 * 57 + 16) + 57 * column + 28)
            middle = tuple(colors[at:at + 3])
            letter = cross[row][column]
            is_red = letter == "r"
            wanted = ({".": GREY, "g": GREEN, "r": GREEN}[letter], {".": GREY, "g": GREEN, "r": RED}[letter],
                      DIFFER if is_red else ALIKE)[panel]
            if middle != wanted:
                wrong.append((panel, row, column, middle, wanted))
checks.that("a wrong picture: yours, expected, difference", not wrong, str(wrong[:3]))
shutil.rmtree(f"build{answers}", ignore_errors=True)
checks.end()
