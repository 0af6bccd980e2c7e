"""figures.py - the figures of chapter 05 are right.

The points where a line meets a sphere are computed without a quadratic: the center is projected on
the line, the rest is Pythagoras. The drawn sphere gives the scale and the place of everything else.
"""
import math
import os
import random
import re

from check import Checks, holds_for_every, labels_are_clear
from figure import Figure, cross, dot, length, plus, times, unit
from shown import NUMBER, read

checks = Checks("figures of 05-quadratic")
P = "05-quadratic"
DECK = ((-4, -1, 0), (0.89, 0.45, 0), (0, 0, 0), 1)


def across(v, line):
    """v's part at right angles to the line, as a unit vector."""
    return unit(plus(v, line, -dot(v, line)))


class Meeting:
    """A ray and a sphere, and the points where they meet."""

    def __init__(self, p, v, c, r):
        self.p, self.v, self.c, self.r = p, v, c, r
        self.line = unit(v)
        along = dot(plus(c, p, -1), self.line)
        self.nearest = plus(p, self.line, along)
        self.t = along / length(v)
        apart = plus(self.nearest, c, -1)
        self.away = length(apart)
        through = self.away < 1e-7 * r
        self.off = across((0, 1, 0) if abs(self.line[1]) < 0.9 else (1, 0, 0), self.line) if through \
            else across(apart, self.line)
        self.roots = []
        if self.away <= r:
            half = math.sqrt((r - self.away) * (r + self.away)) / length(v)
            self.roots = [self.t - half, self.t + half]
        ahead = [t for t in self.roots if t > 0]
        self.hit = min(ahead) if ahead else None

    def at(self, t):
        return plus(self.p, self.v, t)

    def options(self):
        def words(v):
            return ",".join(f"{x:.17g}" for x in v)
        return ["--origin=" + words(self.p), "--direction=" + words(self.v), "--center=" + words(self.c),
                f"--radius={self.r:.17g}"]

    def upright(self):
        """To the right and up on the paper: seen from where z is positive, y as far up as possible."""
        out = cross(self.line, self.off)
        if out[2] < 0:
            out = times(-1, out)
        up = across((0, 1, 0), out)
        return cross(up, out), up

    def f(self, t):
        place = plus(self.at(t), self.c, -1)
        return dot(place, place) - self.r**2

    def coefficients(self):
        """By the parabola's lowest point instead of the slide's products."""
        a, lowest = dot(self.v, self.v), self.away**2 - self.r**2
        return a, -2 * a * self.t, lowest + a * self.t**2, -4 * a * lowest


class Panel:
    """The right places of the section's points, computed from the drawn circle."""

    def __init__(self, meeting, circle, right, up, center=None):
        self.meeting, self.right, self.up = meeting, right, up
        self.center = meeting.c if center is None else center
        round_it = circle[:-1]
        self.middle = [sum(point[i] for point in round_it) / len(round_it) for i in range(2)]
        away = [math.dist(point, self.middle) for point in round_it]
        self.radius = sum(away) / len(away)
        self.scale = self.radius / meeting.r
        checks.that("the circle is round", max(abs(a - self.radius) for a in away) < 0.1, str(self.radius))

    def place(self, point):
        from_center = plus(point, self.center, -1)
        return tuple(self.middle[i] + self.scale * dot(from_center, axis)
                     for i, axis in enumerate((self.right, self.up)))

    def on_circle(self, what, points):
        for point in points:
            checks.that(what + " is on the circle", abs(math.dist(point, self.middle) - self.radius) < 0.3)


def has_label(figure, what, wanted):
    found = [text for text, _, _ in figure.labels()]
    checks.that(f"{what}: there is {wanted!r}", any(wanted in text for text in found), str(found))


def coefficients_shown(figure, m):
    """With those that are shown, a reader finds the discriminant."""
    labels = [text for text, _, _ in figure.labels()]
    found = [re.fullmatch(re.escape(what) + f" = ({NUMBER})", label)
             for what in ("a = v·v", "b = 2 p·v", "c = p·p − r²", "b² − 4 a c") for label in labels]
    found = [read(each[1]) for each in found if each]
    checks.that("a, b, c and the discriminant are labels", len(found) == 4, str(labels))
    checks.same("with the right numbers", found[:3], m.coefficients()[:3], within=1e-3)
    a, b, c, discriminant = found if len(found) == 4 else (0, 0, 0, 0)
    checks.that("which go together", abs(b * b - 4 * a * c - discriminant) <= 0.011 * abs(discriminant) + 1e-9 * b * b, str(found))


def has_numbers(figure, prefix, m):
    """Coefficients within 1e-5 of the largest number that went into each."""
    for name, wanted, size in zip(("a", "b", "c", "D"), m.coefficients(),
                                  (1, 1, 1 + m.r**2, 1 + m.coefficients()[1]**2)):
        checks.that(f"{prefix}{name}", abs(figure.number(prefix + name) - wanted) <= 1e-9 * max(size, abs(wanted)),
                    f"{figure.number(prefix + name)}, expected {wanted}")
    checks.that(f"{prefix}roots: the count", figure.number(prefix + "roots") == len(m.roots))
    for i, t in enumerate(m.roots):
        checks.same(f"{prefix}t{i}", [figure.number(f"{prefix}t{i}")], [t])


def meets_in(figure, panel, m, names):
    """The marks of both roots, and no mark if there is no root."""
    for t, name in zip(m.roots or [None, None], names):
        found = figure.dots(name)
        if t is None:
            checks.that(f"no mark for {name}", found == [], str(found))
            continue
        checks.near(f"the mark of {name}", found, panel.place(m.at(t)))
        panel.on_circle(f"the mark of {name}", found)


def ray_in(figure, panel, m):
    if figure.number("near_p"):
        checks.near("p", figure.dots("p"), panel.place(m.p))
        start = m.p
        checks.near("the arrow v", figure.tips("v"), panel.place(plus(start, m.v, figure.number("stride"))))
    for place in (point for line in figure.lines("p + t v") for point in line):
        checks.that("the line goes through p + t v", abs(sum(
            (place[i] - panel.place(m.p)[i]) * dot(m.off, axis)
            for i, axis in enumerate((panel.right, panel.up)))) < 0.1 * max(1, m.away / m.r), str(place))


def from_the_margin(figure, name):
    """Formulas begin where a slide's text does: 36 units from the left (chapters/slides/lecture.sty)."""
    left = min(text.box[0] for text in figure.texts() if text.title == "label of words" and text.words)
    checks.that(f"{name}: formulas begin at the margin of a slide", left > 35.9, f"at {left}")


def ray_sphere(m, settings=""):
    figure = Figure(P, "ray-sphere", *m.options(), settings=settings)
    right, up = m.upright()
    panel = Panel(m, figure.lines("circle")[0], right, up)
    checks.near("c", figure.dots("c"), panel.place(m.c))
    from_the_margin(figure, "ray-sphere")
    has_numbers(figure, "", m)
    ray_in(figure, panel, m)
    meets_in(figure, panel, m, ("t0", "t1"))
    checks.near("the hit", figure.dots("the hit"), [panel.place(m.at(m.hit))] if m.hit else [])
    if not m.roots:
        checks.near("the nearest point", figure.dots("nearest point"), panel.place(m.nearest))
    ticks = figure.block("ticks")
    checks.same("the marks of t are on the line", [row[:3] for row in ticks], [m.at(row[3]) for row in ticks])
    for row in ticks:
        count = row[3] / figure.number("stride")
        checks.that("the marks of t are whole", abs(count - round(count)) < 1e-6, str(row))
    lines = figure.lines("marks of t")
    middles = [((x + u) / 2, (y + v) / 2) for line in lines for (x, y), (u, v) in zip(line[::2], line[1::2])]
    checks.near("the marks of t", middles, [panel.place(m.at(row[3])) for row in ticks])
    coefficients_shown(figure, m)


def parabola(m):
    figure = Figure(P, "parabola", *m.options())
    from_the_margin(figure, "parabola")
    panel = Panel(m, figure.lines("circle")[0], m.line, m.off)
    has_numbers(figure, "", m)
    ray_in(figure, panel, m)
    meets_in(figure, panel, m, ("first hit", "second hit"))
    checks.same("the parabola's data", [row[1] for row in figure.block("parabola")],
                [m.f(row[0]) for row in figure.block("parabola")])

    # v = axis + k f, for one k: by the points that are drawn, and f of the t under each.
    axis = figure.lines("axis")[0][0][1]
    points = [point for line in figure.lines("f") for point in line]
    drawn = []
    for u, v in points:
        t = m.t + (u - panel.place(m.nearest)[0]) / (panel.scale * length(m.v))
        drawn.append((m.f(t), v, abs(2 * dot(m.v, m.v) * (t - m.t)) / (panel.scale * length(m.v))))
    checks.that("there is a parabola", len(points) > 20, str(len(points)))
    if not points:
        return figure
    k = sum((v - axis) * f for f, v, _ in drawn) / sum(f * f for f, _, _ in drawn)
    checks.that("f goes up on the paper", k > 0)
    off = [abs(axis + k * f - v) - 0.01 * k * slope for f, v, slope in drawn]
    checks.that("each point of the parabola is f(t) above its t", max(off) < 0.1, str(max(off)))
    for i, t in enumerate(m.roots):
        checks.near(f"root {i} on the axis", figure.dots(f"t{i}"), (panel.place(m.at(t))[0], axis))
        ends = [place for line in figure.lines(f"t{i}, vertical") for place in (line[0], line[-1])]
        checks.near(f"the vertical of root {i}", ends, [panel.place(m.at(t)), (panel.place(m.at(t))[0], axis)])
    _, _, c, _ = m.coefficients()
    higher_up = "higher up" in " ".join(text for text, _, _ in figure.labels())
    if figure.number("near_p"):
        checks.that("the words name what is higher up", higher_up == (c > figure.number("f_high")))
        checks.near("f(0)", figure.dots("f(0)"), [] if higher_up else [(panel.place(m.p)[0], axis + k * c)])
    return figure


SITUATIONS = [(-1.875, 1.5), (-1.875, 1), (-1.875, 0.5), (-0.5, 0.5), (1.25, 0.5)]


def discriminant(r):
    """Five rays along x, in radii of the sphere; only the radius is the reader's."""
    figure = Figure(P, "discriminant", f"--radius={r:.17g}")
    speed = figure.number("v")
    checks.that("v is half a radius to a radius long", r * 0.4999 <= speed <= r * 1.0001)
    marks = {"hit": [], "later place": [], "place behind": []}
    roots = {"root used": [], "later root": [], "root behind": []}
    axes = [line[0][1] for line in figure.lines("axis")]
    for i, (x, y) in enumerate(SITUATIONS):
        m = Meeting((x * r, y * r, 0), (speed, 0, 0), (0, 0, 0), r)
        if i == 1:
            m.away, m.roots, m.hit = r, [m.t, m.t], m.t
        panel = Panel(m, figure.lines("circle")[i], (1, 0, 0), (0, 1, 0))
        checks.near("p", figure.dots("p")[i:i + 1], panel.place(m.p))
        checks.near("v", figure.tips("v")[i:i + 1], panel.place(m.at(1)))
        checks.near("t = 0", figure.lines("t = 0")[i][:1], [(panel.place(m.p)[0], axes[i] - 5)])
        for name, wanted in zip(("a", "b", "c", "D"), m.coefficients()):
            checks.same(f"panel {i + 1}: {name}", [figure.number(f"panel{i + 1}_{name}") / r**4], [wanted / r**4])
        for k, t in enumerate(m.roots):
            checks.same(f"panel {i + 1}: root {k}", [figure.number(f"panel{i + 1}_t{k}")], [t])
            kind = 0 if t == m.hit else 1 if t > 0 else 2
            if i != 1 or k == 0:
                place = panel.place(m.at(t))
                marks[list(marks)[kind]].append(place)
                roots[list(roots)[kind]].append((place[0], axes[i]))
    for title, wanted in {**marks, **roots}.items():
        checks.near(title, figure.dots(title), wanted)
    checks.that("a tangent is exactly one", figure.number("panel2_D") == 0
                and figure.number("panel2_t0") == figure.number("panel2_t1"))
    for i, sign in enumerate((-1, 0, 1, 1, 1)):
        d = figure.number(f"panel{i + 1}_D")
        checks.that(f"panel {i + 1}: the discriminant's sign", (d > 0) - (d < 0) == sign)
    shape = sorted(point for title in ("f", "f, t < 0") for line in figure.lines(title) for point in line)
    for i in range(5):
        panel = Panel(Meeting((0, 0, 0), (1, 0, 0), (0, 0, 0), r), figure.lines("circle")[i], (1, 0, 0), (0, 1, 0))
        drawn = [(((u - panel.middle[0]) / panel.radius)**2 + SITUATIONS[i][1]**2 - 1, v - axes[i])
                 for u, v in shape if 120 + i * 168 < u < 120 + (i + 1) * 168]
        checks.that(f"panel {i + 1}: its parabola", len(drawn) > 20 and
                    all(abs(v - 45 * f) < 0.3 for f, v in drawn))


def world_object(m, by=(0, 0, 0)):
    """by: how far the program moves the deck's ray and sphere away from the origin."""
    figure = Figure(P, "world-object", *m.options())
    m = Meeting(plus(m.p, by), m.v, plus(m.c, by), m.r)
    right, up = m.upright()
    world = Panel(m, figure.lines("circle")[0], right, up)
    seen = Meeting(plus(m.p, m.c, -1), m.v, (0, 0, 0), m.r)
    there = Panel(seen, figure.lines("object circle")[0], right, up)
    has_numbers(figure, "world_", m)
    has_numbers(figure, "object_", m)
    ray_in(figure, world, m)
    meets_in(figure, world, m, ("t0", "t1"))
    meets_in(figure, there, seen, ("object t0", "object t1"))
    checks.that("one size", abs(world.scale - there.scale) < 1e-3 * world.scale)
    checks.near("c", figure.tips("c") or [world.middle], world.place(m.c))
    if figure.number("near_p"):
        checks.near("p − c", figure.dots("p − c"), there.place(seen.p))
        checks.near("v, moved", figure.tips("object v"), there.place(seen.at(figure.number("stride"))))
    if figure.number("near_origin"):
        # An axis is drawn through the origin along x, y or z: the point where it would reach the tip.
        for x, y, z, dx, dy, dz in figure.block("world_axes"):
            checks.that("an axis goes through the origin", length(cross((x, y, z), (dx, dy, dz))) < 1e-6)
    return figure


def geometric_roots(m):
    """By Pythagoras, from the side of the line: no quadratic equation, and no formula of the figure."""
    figure = Figure(P, "geometric-roots", *m.options())
    panel = Panel(m, figure.lines("circle")[0], m.line, m.off)
    from_the_margin(figure, "geometric-roots")
    near = figure.number("near_p")
    meets_in(figure, panel, m, ("t0", "t1"))
    checks.near("M", figure.dots("M"), panel.place(m.nearest))
    checks.near("L", figure.tips("L"), [panel.place(m.c)] if near and math.dist(m.p, m.c) > 1e-6 * m.r else [])
    checks.same("s and m", [figure.number("s"), figure.number("m")], [m.t * length(m.v), m.away])
    middle = math.dist(m.at(m.roots[0]), m.at(m.roots[1])) / 2 if m.roots else math.nan
    checks.that("k is half the distance of the hits", not m.roots or abs(figure.number("k") - middle) < 1e-5 * m.r)
    checks.stroke(figure, "m", panel.place(m.nearest), panel.place(m.c))
    if m.roots:
        checks.stroke(figure, "k", panel.place(m.nearest), panel.place(m.at(m.roots[1])))
    if min(m.away, abs(m.t) * length(m.v)) > 0.1 * m.r:
        at_m = panel.place(m.nearest)
        checks.that("the mark of the right angle is a square at M", all(
            min(abs(x - at_m[0]), abs(y - at_m[1])) < 0.1 for x, y in figure.line("right angle")[::2]))
    has_label(figure, "geometric-roots", "no root" if not m.roots else "(s + k) / |v|")
    return figure


def some_meeting(dice, one=1.0):
    """A ray that passes a sphere at up to 1.3 radii, from far to inside, ahead or behind, in such units."""
    def direction():
        while True:
            v = tuple(dice.uniform(-1, 1) for _ in range(3))
            if 0.1 < length(v) < 1:
                return unit(v)
    c, r, line = tuple(one * dice.uniform(-6, 6) for _ in range(3)), one * dice.uniform(0.3, 3), direction()
    past = plus(c, across(direction(), line), dice.uniform(0.02, 1.3) * r)
    return Meeting(plus(past, line, -dice.uniform(-3, 9) * r), times(one * dice.uniform(0.2, 5), line), c, r)


deck = Meeting(*DECK)
ray_sphere(deck)
ray_sphere(deck, "shape='4:3'")
parabola(deck)
geometric_roots(deck)
discriminant(1)
# The lecture may have another example; only that is moved.
IS_EXAMPLE = Figure(P, "ray-sphere").script == Figure(P, "ray-sphere", *deck.options()).script
world_object(deck, by=(3, 2, 0) if IS_EXAMPLE else (0, 0, 0))
checks.same("the deck's first hit", [deck.hit], [3.621514], within=1e-6)
for title in ("ray-sphere", "parabola", "discriminant", "world-object", "geometric-roots"):
    holds_for_every(checks, P, title)

# Miss, tangent, inside, behind, through the center, far away: each with its words.
CASES = [
    (((-4, 2, 0), (1, 0, 0), (0, 0, 0), 1), "no root: C is 2 away", "no root"),
    (((-4, -1, 0), (1, 0, 0), (0, 0, 0), 1), "t0 = t1 = 4", "t0 = t1 = 4"),
    (((0.2, 0, 0), (1, 0.5, 0), (0, 0, 0), 1), "is the hit", "t1 = "),
    (((-4, -1, 0), (-1, -0.5, 0), (0, 0, 0), 1), "no root > 0", "t0 = −4"),
    (((-5, 0, 0), (1, 0, 0), (0, 0, 0), 1), "t = 4 is the hit", "t0 = 4"),
    (((0, 5, 0), (0, -1, 0), (0, 0.2, 0), 0.5), "t = 4.3 is the hit", "t1 = 5.3"),
    (((-1000, 3, 0), (1, 0, 0), (0, 0, 0), 5), "t = 996 is the hit", "t = 0 is far away"),
    (((900, 3, 0), (3, 0, 0), (0, 0, 0), 5), "no root > 0", "t = 0 is far away"),
]
for case, words, over in CASES:
    meeting = Meeting(*case)
    ray_sphere(meeting)
    has_label(Figure(P, "ray-sphere", *meeting.options()), "ray-sphere", words)
    has_label(parabola(meeting), "parabola", over)
    world_object(meeting)
    geometric_roots(meeting)
    for title in ("ray-sphere", "parabola", "world-object", "geometric-roots"):
        holds_for_every(checks, P, title, *meeting.options())

dice = random.Random(5)
for _ in range(int(os.environ.get("SCENES", "5"))):
    meeting = some_meeting(dice)
    ray_sphere(meeting)
    parabola(meeting)
    world_object(meeting)
    geometric_roots(meeting)
    discriminant(meeting.r)
    meeting = some_meeting(dice, 10 ** dice.uniform(-6, 6))
    for title in ("ray-sphere", "parabola", "world-object", "geometric-roots"):
        labels_are_clear(checks, P, title, meeting.options())
    labels_are_clear(checks, P, "discriminant", [f"--radius={meeting.r:.17g}"])
checks.end()
