"""random_example.py - an example for the lecture, made from a number (tests/proof/examples.sh).

    random_example.py NUMBER             prints it as chapters/example.h
    random_example.py NUMBER --lessons   what lessons must hold then: FILE, and TEXTS after tabs, any of them
    random_example.py NUMBER --figures   PROGRAM FIGURE OPTIONS: the figure must be the one without options
    random_example.py NUMBER --slides    numbers that the slides must have then, as JSON writes them
    random_example.py NUMBER --clear     tests that its figures are clear, in both shapes (tests/proof/figures.sh)

The results are found in another way than the chapters find them, and in another language: by the geometry of the
chord. NUMBER 0 is the deck's example; from 1000 on, numbers are from 1e-6 to 1e6.
"""
import math
import re
import sys
from pathlib import Path
from random import Random
from types import SimpleNamespace

sys.path.insert(0, str(Path(__file__).parents[1] / "house/figures"))
import shown as writing  # it is beside the tests of figures

PLAIN = {raised: chr(plain) for plain, raised in writing.RAISED.items()}

from check import SHAPES, Checks, drawn
from figure import cross, dot, plus, times, unit

SIZES = ((320, 240), (640, 480), (800, 600), (1024, 768), (1280, 720), (1920, 1080), (512, 512), (600, 900))


LARGEST_SIDE = 16384  # of a picture (common/image.h)


# ---- the example ------------------------------------------------------------------------------------

class Chance(Random):
    """Numbers as people choose them: with few digits."""

    def rounded(self, low, high, step):
        return rounded(self.uniform(low, high), step)

    def place(self, size, step):
        return [self.rounded(-size, size, step) for _ in range(3)]

    def sign(self):
        return self.choice((1, -1))

    def frame(self):
        """right, up, forward: along the axes, or turned in any way; of either handedness."""
        if self.random() < 0.5:
            first, second = self.sample(range(3), 2)
            right, up = ([self.sign() if i == axis else 0 for i in range(3)] for axis in (first, second))
        else:
            right = leaning = [0, 0, 0]
            while math.hypot(*cross(right, leaning)) < 0.1:
                right, leaning = self.place(1, 1e-3), self.place(1, 1e-3)
            right = unit(right)
            up = unit(cross(leaning, right))
        return right, up, times(self.sign(), cross(right, up))


def rounded(x, step):
    return float(f"{round(x / step) * step:.6g}")


def spread(e, chance):
    """The camera and the ray in units of their own, and far from the origin or near to it."""
    def units(smallest, largest):
        return 10 ** chance.uniform(math.log10(smallest), math.log10(largest))
    size = max(e.d, e.w, e.h)
    one = units(1e-6 / min(e.d, e.w, e.h), 1e6 / size)
    e.d, e.w, e.h = (float(f"{one * x:.6g}") for x in (e.d, e.w, e.h))
    e.eye = [float(f"{x:.6g}") for x in times(min(1e6, one * size * units(1e-3, 1e5)), unit(plus(e.eye, (0.1, 0, 0))))]
    one, faster = units(1e-6, 1e4), units(1e-3, 1e3)
    ahead, off = times(one, plus(e.p, e.center, -1)), min(1e5, one * units(1e-3, 1e4))
    e.center = [float(f"{x:.6g}") for x in times(off, e.center)]
    e.p, e.v, e.radius = list(plus(e.center, ahead)), list(times(one * faster, e.v)), one * e.radius


def example_number(number):
    """d, w, h: distance, width, height of the camera; columns, rows: the screen; x, y: a point on it; p, v: the ray."""
    if number == 0:
        return SimpleNamespace(eye=[2, 2, -4], right=[1, 0, 0], up=[0, 1, 0], forward=[0, 0, 1], d=4, w=2, h=2, s=0.3, t=0.1,
                               columns=640, rows=480, x=300, y=400, p=[-4, -1, 0], v=[0.89, 0.45, 0], center=[0, 0, 0],
                               radius=1)
    chance, e = Chance(number), SimpleNamespace()
    units = chance.choice((0.1, 1, 10))
    # Fields of view from 20 to 90 degrees, the sides at most as 2.5 to 1.
    half = math.tan(math.radians(chance.uniform(20, 90) / 2))
    e.eye = times(units, chance.place(10, 0.25))
    e.right, e.up, e.forward = chance.frame()
    e.d = chance.rounded(1, 8, 0.25) * units
    e.w = rounded(2 * half * e.d, 0.05 * units)
    e.h = rounded(e.w * chance.uniform(0.4, 1.5), 0.05 * units)
    e.s, e.t = chance.rounded(0.05, 0.95, 0.05), chance.rounded(0.05, 0.95, 0.05)
    e.columns, e.rows = chance.choice(SIZES)
    e.x, e.y = chance.randint(1, e.columns - 1), chance.randint(1, e.rows - 1)
    # The ray goes to a point near the center; how long v is says where t is 1.
    while True:
        e.radius = chance.rounded(0.5, 3, 0.25)
        e.center = chance.choice(([0, 0, 0], chance.place(5, 0.5)))
        e.p = plus(e.center, chance.place(8, 0.5))
        towards = plus(plus(e.center, chance.place(0.5 * e.radius, 0.1)), e.p, -1)
        e.v = [rounded(x / chance.uniform(2, 6), 0.01) for x in towards]
        ahead, length = plus(e.center, e.p, -1), math.hypot(*e.v)
        if math.hypot(*ahead) >= 1.5 * e.radius and length >= 0.3 and dot(ahead, e.v) >= 0 and \
                math.hypot(*cross(ahead, e.v)) <= 0.9 * e.radius * length:
            break
    if number >= 1000:
        spread(e, chance)
    # Some sentences have other words for a unit arrow, for a distance of 1, and on a large screen.
    if number % 4 == 1:
        e.v = unit(e.v)
    if number % 4 == 2:
        e.w, e.h, e.d = e.w / e.d, e.h / e.d, 1
    if number % 4 == 3:
        many = LARGEST_SIDE // max(e.columns, e.rows)
        e.columns, e.rows = many * e.columns, many * e.rows
        e.x, e.y = many * e.x + many // 2, many * e.y + many // 2
    return e


# ---- as a file, as options --------------------------------------------------------------------------

def exact(*numbers):
    return [f"{x + 0.0:.17g}" for x in numbers]


def print_file(e):
    for name, numbers in (("EYE", e.eye), ("RIGHT", e.right), ("UP", e.up), ("FORWARD", e.forward), ("DISTANCE", [e.d]),
                          ("WIDTH", [e.w]), ("HEIGHT", [e.h]), ("PLACE", [e.s, e.t]), ("SCREEN", [e.columns, e.rows]),
                          ("POINT", [e.x, e.y]), ("RAY_ORIGIN", e.p), ("RAY_DIRECTION", e.v), ("CENTER", e.center),
                          ("RADIUS", [e.radius])):
        print(f"#define EXAMPLE_{name} {', '.join(exact(*numbers))}")


def options(**given):
    return " ".join(f"--{name} {','.join(exact(*numbers))}" for name, numbers in given.items())


def figures_of(e):
    """The figures that follow the example, each with the options that give it these numbers."""
    camera = options(eye=e.eye, right=e.right, up=e.up, forward=e.forward, distance=[e.d], width=[e.w], height=[e.h])
    ray = options(origin=e.p, direction=e.v, center=e.center, radius=[e.radius])
    size = f"--size {e.columns}x{e.rows}"
    for figure in ("camera-frame", "corner-vectors", "point-30-10", "double-dwh", "yours-and-right"):
        yield f"01-corners {figure} {options(s=[e.s], t=[e.t])} {camera}"
    for figure in ("camera-forms", "look-at"):
        yield f"02-cameras {figure} {camera}"
    yield f"03-screen screen-to-unit {size} --point {e.x},{e.y}"
    yield f"04-pixel-ray pixel-to-ray {size} --pixel {e.x},{e.y} {camera}"
    for figure in ("ray-sphere", "parabola", "discriminant", "world-object", "geometric-roots"):
        yield f"05-quadratic {figure} {ray}"


def print_figures(e):
    print("\n".join(figures_of(e)))


# ---- what the lessons must hold ---------------------------------------------------------------------

def in_words(x, digits):
    return f"{x + 0.0:.{digits}g}"


def in_formula(text):
    """As LaTeX writes a number: 10{,}000, 1.2 \\cdot 10^{-6}."""
    text = re.sub(r"(?<=\d),(?=\d)", "{,}", text.replace("−", "-").replace(" · ", r" \cdot "))
    return re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda power: f"^{{{power[0].translate(PLAIN)}}}", text)


def holds(stem, before, x, digits=(4,), after="", formula=False):
    """A number or a vector, to any of these digits. A last digit of 5 may be rounded up or down: all such texts are
    given, with tabs between."""
    texts = []
    for a_little in (1 + 1e-13, 1 - 1e-13):
        for each in digits:
            words = writing.shown_vector([a_little * part for part in x], each) if isinstance(x, (list, tuple)) else \
                writing.shown(a_little * x, each)
            texts.append(f"{before}{in_formula(words) if formula else words}{after}")
    print(f"chapters/{stem}/README.md", *texts, sep="\t")


def along(e, right, up):
    return plus(plus(times(e.d, e.forward), e.right, right), e.up, up)


def degrees_across(distance, width):
    return math.degrees(2 * math.asin(width / 2 / math.hypot(distance, width / 2)))


def print_lessons(e):
    holds("01-corners", "| eye $p$ | ", e.eye, after=" |")
    holds("01-corners", "| width $w$ | ", e.w, after=" |")
    holds("01-corners", "| upper left | 0 | 1 | ", along(e, -0.5 * e.w, 0.5 * e.h), after=" |")
    holds("01-corners", "| 30% across, 10% up | 0.3 | 0.1 | ", along(e, -0.2 * e.w, -0.4 * e.h), after=" |")
    print(f"chapters/01-corners/README.md\tat the distance d = {e.d + 0.0:.4g}. It is")
    holds("02-cameras", "| look-at | look-at point ", plus(e.eye, along(e, 0, 0)), after=",")
    holds("02-cameras", "aspect ratio ", e.w / e.h, after=" |")
    print(f"chapters/02-cameras/README.md\tthis camera sees            {degrees_across(e.d, e.w):.6g} degrees across")
    for text in (rf"\frac{{{in_formula(writing.shown(e.x))}}}{{{in_formula(writing.shown(e.columns))}}}", f"A screen of {e.columns} x {e.rows} pixels",
                
                 f"a screen of {writing.shown(e.columns)} by {writing.shown(e.rows)} pixels. Its origin"):
        print(f"chapters/03-screen/README.md\t{text}")
    holds("04-pixel-ray", r"\frac{", e.x + 0.5, after="}{", formula=True)
    holds("04-pixel-ray", " ", along(e, (2 * e.x + 1 - e.columns) * e.w / (2 * e.columns),
                                     (e.rows - 2 * e.y - 1) * e.h / (2 * e.rows)), formula=True)
    print_rays(e)


def print_rays(e):
    stem, length, to_center = "05-quadratic", math.hypot(*e.v), plus(e.center, e.p, -1)
    middle = dot(to_center, unit(e.v))
    off = math.hypot(*plus(to_center, unit(e.v), -middle))
    half = math.sqrt((e.radius - off) * (e.radius + off))
    first, second = (middle - half) / length, (middle + half) / length
    holds(stem, "$p$ = ", e.p)
    some = range(4, 13)  # more, if the discriminant needs them, or the roots are near to each other
    holds(stem, "$a = ", length * length, some, "$", formula=True)
    holds(stem, "$t$ is ", first, some, " or")
    holds(stem, ", r is ", e.radius)
    for words, t in (("    t                         ", second), ("  the hit, smallest t > 0     ", first)):
        print(f"chapters/{stem}/README.md", *(f"{words}{a_little * t:.6g}" for a_little in (1 + 1e-13, 1 - 1e-13)), sep="\t")
    # As if every direction had length 1.
    b, c = -2 * dot(e.v, to_center), dot(to_center, to_center) - e.radius * e.radius
    if abs(length * length - 1) < 1e-9:
        print(f"chapters/{stem}/README.md\tthat makes no difference here")
    elif b * b < 4 * c:
        print(f"chapters/{stem}/README.md\tand the ray seems to miss")
    else:
        t = (-b - math.sqrt(b * b - 4 * c)) / 2
        inside = math.hypot(*plus(times(t, e.v), to_center, -1)) < e.radius
        holds(stem, "$t = ", t, after="$. That point is", formula=True)
        print(f"chapters/{stem}/README.md\tfrom the center: {'inside' if inside else 'outside'} the sphere.")


# ---- what the slides must say -----------------------------------------------------------------------

def print_slides(e):
    a = dot(e.v, e.v)
    without = "Here $d$ is 1, so they stay." if e.d == 1 else \
        f"With $d = 1$ and the old $w$ and $h$ this camera would see {writing.shown(degrees_across(1, e.w))} degrees " \
        f"across, not {writing.shown(degrees_across(e.d, e.w))}."
    arrow = "as this arrow is" if abs(a - 1) < 1e-12 else f"and this arrow has $a = {writing.shown(a)}$"
    print(f'"without_dividing": "{without}"\n"arrow": "{arrow}"')


def check_figures(e):
    checks = Checks("figures of an example")
    for line in figures_of(e):
        program, figure, *options = line.split()
        for shape in SHAPES:
            drawn(checks, program, figure, options, shape)
    checks.end()


DO = {"": print_file, "--lessons": print_lessons, "--figures": print_figures, "--slides": print_slides, "--clear": check_figures}
DO["".join(sys.argv[2:])](example_number(int(sys.argv[1])))
