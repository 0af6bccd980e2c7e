"""figures.py - the figures of chapter 07 are right."""
import math
import tempfile

from check import Checks, holds_for_every, on_the_canvas, told_in_words
from figure import Figure, dot, plus, times

checks = Checks("figures of 07-shading")

# The deck's spheres (deck units negated in z, as NFF has it), the scene's light, Phong's model.
SPHERES = [((2, 2, 1), (1, 0, 0)), ((2, -2, 0), (0, 1, 0)), ((-2, 0, -1), (0, 0, 1))]
RADIUS, EYE, ANGLE, LIGHT = 3, (0, 0, 20), 42, (10, 10, 20)
KD, KS, SHINE, AMBIENT, GREY = 0.8, 0.2, 20, 0.1, 127
COLUMNS, ROWS = 112, 84


def unit(v):
    return times(1 / math.sqrt(dot(v, v)), v)


def meets(origin, direction, center):
    """The point where a line of unit direction enters a sphere, from the centre's distance to it."""
    to_center = plus(center, origin, -1)
    ahead = dot(to_center, direction)
    square = RADIUS ** 2 - (dot(to_center, to_center) - ahead ** 2)
    return ahead - math.sqrt(square) if square >= 0 and ahead > 0 else math.inf


def light_of(column, row):
    """(flat, shaded) bytes of a pixel, and how near it is to an edge, where rounding decides."""
    half = math.tan(math.radians(ANGLE / 2))
    x = (2 * (column + 0.5) / COLUMNS - 1) * half
    y = (1 - 2 * (row + 0.5) / ROWS) * half * ROWS / COLUMNS
    way = unit((x, y, -1))
    t, i = min((meets(EYE, way, center), i) for i, (center, _) in enumerate(SPHERES))
    if t == math.inf:
        return (GREY,) * 3, (GREY,) * 3
    center, color = SPHERES[i]
    point = plus(EYE, way, t)
    normal = unit(plus(point, center, -1))
    to_light = unit(plus(LIGHT, point, -1))
    start = plus(point, normal, 1e-6)
    dark = any(meets(start, to_light, other) < 99 for other, _ in SPHERES)
    cosine = 0 if dark else max(0, dot(normal, to_light))
    mirrored = plus(times(2 * dot(normal, to_light), normal), to_light, -1)
    shine = KS * max(0, -dot(mirrored, way)) ** SHINE if cosine > 0 else 0
    shaded = [KD * c * (AMBIENT + cosine) + shine for c in color]
    return tuple(255 * c for c in color), tuple(math.floor(255 * min(1, c) + 0.5) for c in shaded)


def bytes_of(number):
    return int(number) >> 16, int(number) >> 8 & 255, int(number) & 255


figure = Figure("07-shading", "flat-and-shaded")
flat, shaded = figure.block("flat"), figure.block("shaded")
wrong, far = 0, 0
for row in range(ROWS):
    for column in range(COLUMNS):
        wanted = light_of(column, row)
        wrong += bytes_of(flat[ROWS - 1 - row][column]) != wanted[0]
        got = bytes_of(shaded[ROWS - 1 - row][column])
        far += max(abs(a - b) for a, b in zip(got, wanted[1])) > 1
checks.that("every pixel of the flat picture agrees with the light model", wrong == 0, f"{wrong} are not")
checks.that("and of the shaded one, except at edges of shadows", far <= 12, f"{far} are not")
(x, y), = figure.block("highlight")
lit = light_of(int(x), int(ROWS - y))[1]
brightest = max(light_of(c, r)[1][1] for r in range(ROWS) for c in range(COLUMNS)
                if light_of(c, r)[0] == (255, 0, 0))
checks.that("the highlight is where the red sphere is whitest", lit[1] == brightest, f"{lit}, {brightest}")
(x, y), = figure.block("shadow")
checks.that("the shadow is where there is only ambient light",
            max(light_of(int(x), int(ROWS - y))[1]) == round(255 * KD * AMBIENT))
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
red, green, _ = bytes_of(own.block("flat")[int(y)][int(x)])
checks.that("the highlight is on the shiny sphere, not on the ground", red > 2 * green, f"{red}, {green}")
own, words = pointed_at("alone and dull", VIEW + "f 0.5 0.5 0.5 1 0 1 0 1\ns 0 1 0 1\n")
checks.that("alone and dull: neither", not words, str(words))

figure = Figure("07-shading", "self-hit")
(px, py, pz, vx, vy, vz), = figure.block("seen")
v = unit((vx, vy, vz))
b = dot((px, py, pz), v)
hit = plus((px, py, pz), v, -b - math.sqrt(b * b - dot((px, py, pz), (px, py, pz)) + 1))
checks.same("the ray ends on the sphere", [px + vx, py + vy, pz + vz], list(hit))
(*at, nx, ny, nz), = figure.block("normal")
checks.same("the normal is the point itself, of a unit sphere around the origin", [nx, ny, nz], list(hit))
(*_, ox, oy, oz), = figure.block("offset")
size = math.sqrt(ox * ox + oy * oy + oz * oz)
checks.that("the start is off by 2^-32 to 2^-28 of the radius", 2 ** -32 <= size <= 2 ** -28, str(size))
checks.that("outward", abs(dot((ox, oy, oz), hit) / size - 1) < 1e-6)
light = figure.block("light")[0]
angle = math.degrees(math.acos(dot(unit(plus(light, hit, -1)), hit)))
checks.same("the angle to the light", [figure.number("light_angle")], [angle])
checks.that("the point is a rounding inside", 0 < figure.number("inside_by") < 1e-15)
checks.that("its ray to the light hits the sphere at once", 0 < figure.number("self_t") < 1e-14)
checks.that("not so from the start", figure.number("largest_from_start") < 0)
one = figure.dots("light")[0][0] - figure.dots("centre")[0][0]
scale = one / light[0]
center = figure.dots("centre")[0]
checks.near("the light is at its place", figure.dots("light"),
            (center[0] + scale * light[0], center[1] + scale * light[1]))
checks.near("the point is on the circle", figure.dots("point"),
            (center[0] + scale * hit[0], center[1] + scale * hit[1]))
checks.near("the tip of the normal", figure.tips("normal"),
            (center[0] + 2 * scale * hit[0], center[1] + 2 * scale * hit[1]))
holds_for_every(checks, "07-shading", "self-hit")
checks.end()
