"""figures.py - the figures of chapter 06, and its story of one pixel, are right.

Scenes are made here, as NFF. The expected values are computed by plane geometry, without a
quadratic: the point of a ray nearest to a sphere's center, and half the chord through it.
"""
import math
import os
import random
import re
import subprocess
import tempfile

import png
from check import NEAR, Checks, holds_for_every, labels_are_clear
from figure import Figure, PROGRAMS, cross, dot, length, plus, times
from shown import shown as number_shown

PROGRAM = "06-ray-casting"
checks = Checks("figures of 06-ray-casting")
folder = tempfile.TemporaryDirectory()
DECK = {"from": (2, 2, 4), "at": (2, 2, 0), "up": (0, 1, 0), "angle": math.degrees(2 * math.atan(0.25)),
        "size": (8, 8), "background": (0, 0, 0)}
ONE = {**DECK, "spheres": [((2.5, 2.5, -4), 0.9, (0.85, 0.42, 0.13))]}
FOUR = {**DECK, "spheres": [((2.4, 1.6, -2), 0.5, (0.85, 0.42, 0.13)), ((1.2, 3.1, -3.5), 0.7, (0.1, 0.58, 0.44)),
                            ((3, 1.4, -5.5), 1.1, (0.74, 0.36, 0.62)), ((2.7, 2.8, -3), 0.45, (0.22, 0.52, 0.8))]}
ALONG = {"from": (0, 0, 0), "at": (1, 0, 0), "up": (0, 1, 0), "angle": 60, "size": (1, 1), "background": (0, 0, 0),
         "spheres": [((-1.3, 0.25, 0), 0.7, (0.74, 0.36, 0.62)), ((2.2, 1.75, 0), 0.85, (0.5, 0.53, 0.57)),
                     ((7.9, -0.35, 0), 1.5, (0.85, 0.42, 0.13)), ((4.1, 0.5, 0), 0.95, (0.1, 0.58, 0.44))]}

# Spheres on a ground, as in many scenes; pixel (5, 7) sees the ground, (2, 4) a sphere on it.
GROUND = {"from": (0, 1.5, 6), "at": (0, 1, 0), "up": (0, 1, 0), "angle": 50, "size": (12, 9), "background": (0.5, 0.7, 0.9),
          "spheres": [((0, -1000, 0), 1000, (0.5, 0.5, 0.5)), ((-1.2, 1, 0), 1, (0.8, 0.2, 0.2)),
                      ((1.4, 0.8, 0.5), 0.8, (0.2, 0.6, 0.9))]}


# ---- geometry -------------------------------------------------------------------------------------

class World:
    """A scene, its camera, and the hits of its rays."""

    def __init__(self, scene):
        self.scene, self.eye, self.spheres = scene, scene["from"], scene["spheres"]
        ahead = plus(scene["at"], self.eye, -1)
        self.d = length(ahead)
        self.f = times(1 / self.d, ahead)
        side = cross(self.f, scene["up"])
        self.r = times(1 / length(side), side)
        self.u = cross(self.r, self.f)
        self.w = 2 * self.d * math.tan(math.radians(scene["angle"]) / 2)
        self.columns, self.rows = scene["size"]
        self.h = self.w * self.rows / self.columns

    def vector(self, x, y):
        """From the eye to the point (x, y) of the screen, y down from its upper edge."""
        across = (x - self.columns / 2) / self.columns * self.w
        upward = (self.rows / 2 - y) / self.rows * self.h
        return plus(plus(times(self.d, self.f), self.r, across), self.u, upward)

    def roots(self, v, i):
        center, radius, _ = self.spheres[i]
        p = plus(center, self.eye, -1)
        middle = dot(p, v) / dot(v, v)
        gap2 = dot(p, p) - middle * middle * dot(v, v)
        if gap2 > radius * radius:
            return None
        half = math.sqrt((radius * radius - gap2) / dot(v, v))
        return middle - half, middle + half

    def hits(self, v):
        """(t, sphere), the nearest first."""
        found = []
        for i in range(len(self.spheres)):
            ahead = [t for t in self.roots(v, i) or () if t > 0]
            if ahead:
                found.append((min(ahead), i))
        return sorted(found)

    def pixel(self, column, row):
        return self.vector(column + 0.5, row + 0.5)

    def color(self, v):
        hits = self.hits(v)
        return self.spheres[hits[0][1]][2] if hits else self.scene["background"]


def rgb(color):
    r, g, b = (math.floor(255 * c + 0.5) for c in color)
    return r * 65536 + g * 256 + b


def write(scene):
    path = os.path.join(folder.name, "scene.nff")

    def words(v):
        return " ".join(f"{x:.17g}" for x in v)
    lines = [f"b {words(scene['background'])}", "v"]
    lines += [f"{key} {words(scene[key])}" for key in ("from", "at", "up")]
    lines += [f"angle {scene['angle']:.17g}", f"resolution {scene['size'][0]} {scene['size'][1]}"]
    for center, radius, color in scene["spheres"]:
        lines += [f"f {words(color)} 1 0 1 0 1", f"s {words(center)} {radius:.17g}"]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    return path


def some_scene(dice, count):
    """Spheres in front of an eye that looks anywhere; some intersect, some are behind the eye."""
    eye = tuple(dice.uniform(-5, 5) for _ in range(3))
    while True:
        ahead = tuple(dice.uniform(-9, 9) for _ in range(3))
        up = tuple(dice.uniform(-1, 1) for _ in range(3))
        if length(ahead) > 2 and length(cross(ahead, up)) > 0.4 * length(ahead):
            break
    scene = {"from": eye, "at": plus(eye, ahead), "up": up, "angle": dice.uniform(25, 70),
             "size": (dice.randint(3, 9), dice.randint(3, 9)),
             "background": tuple(dice.random() for _ in range(3)), "spheres": []}
    world = World(scene)
    for i in range(count):
        v = world.vector(dice.uniform(0, world.columns), dice.uniform(0, world.rows))
        away = dice.uniform(0.6, 3) * (-1 if i % 5 == 4 else 1)
        scene["spheres"].append((plus(eye, v, away), dice.uniform(0.08, 0.35) * abs(away) * world.d,
                                 tuple(dice.random() for _ in range(3))))
    return scene


def telling_pixel(world, dice):
    """A pixel whose ray hits as many spheres as any other's."""
    pixels = [(column, row) for column in range(world.columns) for row in range(world.rows)]
    dice.shuffle(pixels)
    return max(pixels, key=lambda pixel: len(world.hits(world.pixel(*pixel))))


# ---- shared by the figures in space -----------------------------------------------------------------

def see(figure, world):
    figure.see(world.r, world.u, world.f)
    nearer = figure.number("plane_t")
    ahead = [gap for gap in (dot(plus(tuple(row[1:4]), world.eye, -1), world.f) - row[4]
                             for row in figure.block("spheres")[:int(figure.number("balls"))]) if gap > 0]
    checks.that("the image plane is before the spheres", nearer > 0 and
                (not ahead or nearer * world.d <= min(ahead) + 1e-6 * world.d), f"t = {nearer}, spheres from {ahead}")
    return nearer


def from_the_eye(figure, title):
    """How a line goes on the canvas, if the eye is in its lower left corner."""
    eye = figure.dots("eye")[0]
    return [(x - eye[0], y - eye[1]) for x, y in figure.lines(title)[0]]


def plane_where_it_is_seen():
    """However far the point is that the eye looks at, and however wide the angle."""
    far = {"from": (0, 0, 0), "at": (0, 0, -1), "up": (0, 1, 0), "angle": 40, "size": (8, 8), "background": (0, 0, 0),
           "spheres": [((30, -20, -400), 60, (0.8, 0.3, 0.2))]}
    for name in ("object-order", "image-order", "ray-casting", "explain"):
        one, other = (Figure(PROGRAM, name, *scene_options({**far, "at": at}, (4, 4)))
                      for at in ((0, 0, -1), (0, 0, -9000)))
        # Seen from the eye: the words of explain are other ones, so the picture may be elsewhere on the canvas.
        checks.near(f"{name}: a direction has no length", from_the_eye(other, "plane"), from_the_eye(one, "plane"))
        across = [x for x, _ in one.lines("plane")[0]]
        checks.that(f"{name}: the plane can be seen", max(across) - min(across) > 40, str(across))
        # Between the centers of the pixels: no ray that is drawn meets it.
        unseen = Figure(PROGRAM, name, *scene_options({**far, "spheres": [((0, 0, -400), 5, (0.8, 0.3, 0.2))]}, (4, 4)))
        across = [x for x, _ in unseen.lines("plane")[0]]
        checks.that(f"{name}: the plane is before a sphere that no pixel sees, and so it can be seen",
                    unseen.number("balls") == 1 and max(across) - min(across) > 40, str(across))
        wide = {**far, "at": (0, 0, -10), "angle": 170, "spheres": [((16, -14, -20), 14, (0.8, 0.3, 0.2))]}
        figure, world = Figure(PROGRAM, name, *scene_options(wide, (4, 4))), World(wide)
        see(figure, world)
        checks.that(f"{name}: so can a sphere, at a wide angle", figure.scale * 14 > 40, str(figure.scale))
        middle = figure.place((16, -14, -20))
        for x, y in [] if name == "object-order" else figure.dots("closest hit"):
            checks.that(f"{name}: with the hit on it", math.hypot(x - middle[0], y - middle[1]) <= figure.scale * 14 + NEAR)


def shown_spheres(figure, world, expected):
    """The discs: their names, places, sizes and colors, and the far ones first."""
    data = {int(row[0]): row for row in figure.block("spheres")}
    checks.that("these spheres are drawn", figure.number("balls") == len(expected) and
                (not expected or set(data) == set(expected)), f"{sorted(data)}, expected {sorted(expected)}")
    order = []
    for number in set(expected) & set(data):
        center, radius, color = world.spheres[number]
        checks.same("a sphere's data", data[number][1:], [*center, radius, rgb(color)])
        name, middle = chr(ord("A") + number), figure.place(center)
        whole = [shape for title in (f"sphere {name}", f"in front of the plane, sphere {name}")
                 for shape in (figure.polygons(title) if title in figure.plots else [])]
        away = [math.hypot(x - middle[0], y - middle[1]) for shape in whole for x, y in shape]
        others = [i for i in expected if i != number]
        apart = all(length(plus(center, world.spheres[i][0], -1)) > radius + world.spheres[i][1] for i in others)
        if apart and f"sphere {name}" in figure.plots:
            checks.that("a sphere that does not intersect another is a whole disc",
                        all(abs(a - figure.scale * radius) <= NEAR for a in away), f"{min(away)} to {max(away)}")
        checks.that("no sphere is larger than its disc", all(a <= figure.scale * radius + NEAR for a in away))
        if f"sphere {name}" in figure.plots:
            order.append((list(figure.plots).index(f"sphere {name}"), dot(center, figure.axes[2])))
    nearness = [near for _, near in sorted(order)]
    checks.that("far spheres are drawn first", nearness == sorted(nearness))


def cells(figure, world, nearer, expected):
    """The colored pixels, their colors and their places."""
    rows = figure.block("pixels")
    got = {(int(row[4]), int(row[5])): int(row[3]) for row in rows if row[4] >= 0}
    checks.that("the pixels that are colored", got == expected, f"{got}, expected {expected}")
    checks.that("they are counted", figure.number("cells") == len(expected))
    drawn = {}
    for shape in figure.polygons("pixels"):
        corner = min(drawn_at(figure, world, nearer), key=lambda c: math.hypot(
            c[1][0] - shape[0][0], c[1][1] - shape[0][1]))
        drawn[corner[0]] = shape
    for place in expected:
        checks.near("a pixel's place", drawn.get(place, [])[:4], rectangle(figure, world, nearer, place))


def drawn_at(figure, world, nearer):
    return [((column, row), figure.place(plus(world.eye, world.vector(column, row), nearer)))
            for column in range(world.columns) for row in range(world.rows)]


def cast(world):
    """The sphere that each pixel shows, if it shows one."""
    found = {}
    for row in range(world.rows):
        for column in range(world.columns):
            hits = world.hits(world.pixel(column, row))
            if hits:
                found[column, row] = rgb(world.spheres[hits[0][1]][2])
    return found


def seen_spheres(world, pixel):
    """Those that a ray hits first, and those that the pixel's ray hits, up to four."""
    seen = {i for _, i in world.hits(world.pixel(*pixel))[:4]}
    for row in range(world.rows):
        for column in range(world.columns):
            seen |= {i for _, i in world.hits(world.pixel(column, row))[:1]}
    return [i for i in sorted(seen) if drawable(world, i)]


def drawable(world, i):
    center, radius, _ = world.spheres[i]
    gap = length(plus(center, world.eye, -1)) - radius
    return gap > 0 and radius < 6 * gap


def patches(figure, world, hits):
    """For spheres that are hit and cannot be drawn as a whole: a circle on them, around the hit."""
    wanted = [(t, i) for t, i in hits[:4] if not drawable(world, i)]
    rows = [row for row in figure.block("patches") if wanted]
    names = [int(row[3]) for row in figure.block("patch_names")]
    checks.that("the drawn parts of large spheres", names == [i for _, i in wanted], f"{names}, expected {wanted}")
    places = len(rows) // max(1, len(wanted))
    for k, (t, i) in enumerate(wanted):
        center, radius, color = world.spheres[i]
        hit = plus(world.eye, figure_ray(figure), t)
        for row in rows[k * places:(k + 1) * places]:
            checks.same("a patch is on its sphere", [length(plus(tuple(row[:3]), center, -1)), row[3]], [radius, rgb(color)])
            away = length(plus(tuple(row[:3]), hit, -1)) / length(plus(hit, world.eye, -1))
            checks.that("and around the hit", 0.19 < away < 0.29, str(away))
    drawn = figure.polygons("patches") if wanted else []
    corners = [corner for shape in drawn for corner in shape[:places]]
    checks.near("its place", sorted(corners), sorted(figure.place(row[:3]) for row in rows))


def figure_ray(figure):
    """The direction of the figure's ray: from the eye, its first place, to where t is 1."""
    first, *_, last = figure.block("ray")
    return tuple((b - a) / last[3] for a, b in zip(first[:3], last[:3]))


def scene_options(scene, pixel):
    return [write(scene), "--pixel", f"{pixel[0]},{pixel[1]}"]


def drawn_for(name, scene, pixel, options):
    """The figure, by these options or the scene's; and the world, the pixel's ray and its hits."""
    world = World(scene)
    v = world.pixel(*pixel)
    return Figure(PROGRAM, name, *(scene_options(scene, pixel) if options is None else options)), world, v, world.hits(v)


def rectangle(figure, world, nearer, upper_left, size=(1, 1)):
    """The corners of a rectangle of the screen, on the image plane."""
    return [figure.place(plus(world.eye, world.vector(upper_left[0] + x * size[0], upper_left[1] + y * size[1]), nearer))
            for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]


# ---- the figures --------------------------------------------------------------------------------------

def ray_casting(scene, pixel, options=None):
    figure, world, v, hits = drawn_for("ray-casting", scene, pixel, options)
    nearer = see(figure, world)
    shown_spheres(figure, world, seen_spheres(world, pixel))
    patches(figure, world, hits)
    cells(figure, world, nearer, cast(world))
    checks.near("the eye", figure.dots("eye"), figure.place(world.eye))
    outline = rectangle(figure, world, nearer, (0, 0), scene["size"])
    checks.near("the outline of the plane", figure.lines("plane")[0], outline + outline[:1])
    checks.that("the number of hits", figure.number("all_hits") == len(hits))
    along = figure.lines("ray, all of it")[0]
    checks.near("the ray starts at the eye", along[:1], [figure.place(world.eye)])
    for (t, sphere), row in zip(hits[:4], figure.block("hits")):
        checks.same("a hit: its place, t, sphere", row, [*plus(world.eye, v, t), t, sphere])
    places = [figure.place(plus(world.eye, v, t)) for t, _ in hits[:4]]
    checks.near("the dot of the closest hit", figure.dots("closest hit"), places[:1])
    checks.near("the rings of the farther hits", figure.dots("farther hits"), places[1:])
    texts = " ".join(text for text, _, _ in figure.labels())
    checks.that("no label is only a number", not any(
        re.fullmatch(r"-?[0-9.]+", text) for text, _, _ in figure.labels()), texts)
    for t, sphere in hits[:4]:
        name = f"{number_shown(t)}, sphere {chr(ord('A') + sphere)}"
        checks.that("the t of a hit is in the words", name in texts, f"{name} in {texts}")
    if hits:
        checks.same("the pixel's color", [figure.number("pixel_rgb")], [rgb(world.color(v))])
        checks.that("the closest is named", f"{number_shown(hits[0][0])}, sphere {chr(ord('A') + hits[0][1])}: closest" in texts)
    end = max([1.2 * nearer] + [1.1 * t for t, _ in hits[:4]])
    if hits:
        checks.near("the ray's end", along[-1:], [figure.place(plus(world.eye, v, end))])


def image_order(scene, pixel, options=None):
    figure, world, v, hits = drawn_for("image-order", scene, pixel, options)
    nearer = see(figure, world)
    shown_spheres(figure, world, seen_spheres(world, pixel))
    patches(figure, world, hits)
    cells(figure, world, nearer, cast(world))
    centers = [figure.place(plus(world.eye, world.pixel(column, row), nearer))
               for row in range(world.rows) for column in range(world.columns)]
    checks.near("the centers of the pixels", figure.dots("centers"), centers)
    outline = rectangle(figure, world, nearer, pixel)
    checks.near("the pixel", figure.lines("outline of the pixel")[0], outline + outline[:1])
    checks.near("the hit", figure.dots("closest hit"), [figure.place(plus(world.eye, v, t)) for t, _ in hits[:1]])
    if figure.number("misses"):
        end = figure.block("miss")[-1][:3]
        checks.that("the ray that misses misses", not world.hits(plus(tuple(end), world.eye, -1)))
    checks.that("the pixel centers are counted", any(
        re.fullmatch(f"{len(cast(world))} pixel centers? hit", text) for text, _, _ in figure.labels()))


def object_order(scene, pixel, options=None):
    world = World(scene)
    hits = world.hits(world.pixel(*pixel))
    if not hits or not drawable(world, hits[0][1]):
        return
    number = hits[0][1]
    figure = drawn_for("object-order", scene, pixel, options)[0]
    nearer = see(figure, world)
    shown_spheres(figure, world, [number])
    center, radius, color = world.spheres[number]
    alone = World({**scene, "spheres": [world.spheres[number]]})
    cells(figure, world, nearer, cast(alone))
    axis = plus(center, world.eye, -1)
    slope = math.asin(radius / length(axis))
    for row in figure.block("outline"):
        if math.isnan(row[0]):
            continue
        v = plus(tuple(row), world.eye, -1)
        angle = math.acos(min(1, dot(v, axis) / length(v) / length(axis)))
        checks.same("the outline has the sphere's angle, seen from the eye", [angle], [slope])
        checks.same("the outline is on the plane", [dot(v, world.f)], [nearer * world.d])
    if all(not math.isnan(row[0]) for row in figure.block("outline")):
        checks.near("the outline's places", figure.lines("outline on the plane")[0],
                    [figure.place(row) for row in figure.block("outline")])
    for row in figure.block("lines"):
        if row[3] == 1:
            v = plus(tuple(row[:3]), world.eye, -1)
            checks.same("a line touches the sphere", [length(plus(tuple(row[:3]), center, -1)),
                                                      dot(v, plus(tuple(row[:3]), center, -1))], [radius, 0])


def parts_of_circles(figure, place, circles, window):
    """Of each circle that is too large, only the visible part is filled, and its arc drawn."""
    low_x, high_x, low_y, high_y = window
    (left, low), (right, high) = place(low_x, low_y), place(high_x, high_y)
    one = place(1, 0)[0] - place(0, 0)[0]
    shapes = figure.polygons("parts") if "parts" in figure.plots else []
    checks.that("as many parts as large circles", len(shapes) == len(circles), str(len(shapes)))
    if not circles:
        return
    filled = []
    for shape in shapes:
        filled.append(abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(shape, shape[1:] + shape[:1]))) / 2)
        checks.that("a part is within the window", all(
            left - NEAR <= x <= right + NEAR and low - NEAR <= y <= high + NEAR for x, y in shape))
    wanted, columns = [], 4000
    for t, y, r in circles:
        area = 0
        for k in range(columns):
            x = low_x + (high_x - low_x) * (k + 0.5) / columns
            half = math.sqrt(max(0, r * r - (x - t) ** 2))
            area += max(0, min(high_y, y + half) - max(low_y, y - half)) * (high_x - low_x) / columns
        wanted.append(area * one * one)
    checks.same("the parts are as large as they should be", sorted(filled), sorted(wanted), within=1e-3)
    for x, y in (spot for line in figure.lines("parts, outline") for spot in line):
        off = min(abs(math.hypot(x - place(t, 0)[0], y - place(0, a)[1]) - one * r) for t, a, r in circles)
        checks.that("the outline of a part is on its circle", off <= NEAR, str(off))


def asks_before_it_answers():
    """The first step of the example does not say which spheres are hit; the second and third do."""
    words = [Figure(PROGRAM, "nearest-hit", settings=f"step={step}").labels() for step in (1, 2, 3)]
    answers = [sorted({"missed", "behind"} & {label[0] for label in labels}) for labels in words]
    checks.that("no answer, the spheres that are missed, and those behind the eye",
                answers == [[], ["missed"], ["behind", "missed"]], f"{answers}")
    first = Figure(PROGRAM, "nearest-hit", settings="step=1")
    dashed = [title for title in ("missed circles", "circles behind", "hit circles")
              for group in first.groups(title) for shape in group.iter() if shape.get("stroke-dasharray")]
    checks.that("and at first all circles look alike", dashed == [], f"dashed: {dashed}")


def nearest_hit(scene, pixel, options=None):
    figure, world, v, hits = drawn_for("nearest-hit", scene, pixel, options)
    circles = {}
    for number, (center, radius, color) in enumerate(world.spheres):
        p = plus(center, world.eye, -1)
        t = dot(p, v) / dot(v, v)
        off = plus(p, v, -t)
        side = -1 if dot(off, world.u) < 0 else 1
        circles[number] = (t, side * length(off) / length(v), radius / length(v))
    # A sphere more than 12 times as far as the end of the ray would make everything else tiny. It is left
    # out if it is not hit; if it is hit, the part in a window is drawn.
    reach = max([1.2] + [t for t, _ in hits[:4]])
    far = {i for i, (t, y, r) in circles.items() if abs(t) + abs(y) + r > 12 * reach}
    parts = {i: t for t, i in hits if i in far and t <= reach}
    circles = {i: circle for i, circle in circles.items() if i not in far or i in parts}
    whole = [circle for i, circle in circles.items() if i not in parts]
    room = max([0.1] + [0.25 * max(1, t) for t in parts.values()])
    low_x = min([-0.1] + [t - r for t, _, r in whole])
    high_x = max([1.2] + [t + r for t, _, r in whole] + [t + 0.25 * max(1, t) for t in parts.values()])
    low_y = min([-room] + [y - r for _, y, r in whole])
    high_y = max([room] + [y + r for _, y, r in whole])
    place = figure.see_flat()
    (left, bottom), (right, top) = place(low_x, low_y), place(high_x, high_y)
    checks.that("all of it is on the canvas, below a title", 0 < left and right < figure.width and
                150 < bottom and top < 464 + NEAR, str((left, bottom, right, top)))
    rows = figure.block("circles")
    shown = sorted(int(row[0]) for row in rows)
    checks.that("these spheres are drawn", shown == sorted(circles), f"{shown}, expected {sorted(circles)}")
    for row in rows:
        number = int(row[0])
        ends = world.roots(v, number)
        checks.same("a circle", row[1:4], circles[number])
        fate = (0 if ends is None else 3 if hits and hits[0][1] == number else
                2 if number in [i for _, i in hits] else 1)
        checks.that("how a sphere is drawn", row[5] == fate, f"{row[5]}, expected {fate}")
        if ends:
            checks.same("its roots", row[6:8], ends)
    wanted = sorted(place(t, 0) for i in circles for t in world.roots(v, i) or () if low_x <= t <= high_x)
    checks.near("the rings where the ray meets them", sorted(figure.dots("roots")), wanted)
    checks.near("the closest", figure.dots("closest"), [place(t, 0) for t, _ in hits[:1]])
    checks.near("the closest on the axis", figure.dots("closest on the axis"),
                [(place(t, 0)[0], 96) for t, _ in hits[:1]])
    checks.near("the eye", figure.dots("eye"), place(0, 0))
    drawn = figure.lines("intervals") if any(world.roots(v, i) for i in circles) else []
    spans = sorted((min(x for x, _ in line), max(x for x, _ in line)) for line in drawn)
    checks.near("the intervals on the axis", spans, sorted(
        (place(max(low_x, ends[0]), 0)[0], place(min(high_x, ends[1]), 0)[0])
        for ends in (world.roots(v, i) for i in circles) if ends))
    parts_of_circles(figure, place, [circles[i] for i in parts], (low_x, high_x, low_y, high_y))
    if hits:
        words = f"{number_shown(hits[0][0])}, sphere {chr(ord('A') + hits[0][1])}"
        checks.that("the smallest t is in the words", any(text.startswith("smallest") and text.endswith(words)
                                                  for text, _, _ in figure.labels()), words)


def explain_figure(scene, pixel, options=None):
    figure, world, v, hits = drawn_for("explain", scene, pixel, options)
    nearer = see(figure, world)
    checks.same("s and t", [figure.number("s"), figure.number("t")],
                [(pixel[0] + 0.5) / world.columns, 1 - (pixel[1] + 0.5) / world.rows])
    checks.same("the vector from the eye", figure.block("vector_v")[0], [*world.eye, *v])
    patches(figure, world, hits)
    checks.near("its arrow", figure.tips("vector from the eye"), figure.place(plus(world.eye, v, nearer)))
    checks.near("the hits", figure.dots("hits"), [figure.place(plus(world.eye, v, t)) for t, _ in hits[:4]])
    checks.near("the closest", figure.dots("closest hit"),
                [figure.place(plus(world.eye, v, t)) for t, _ in hits[:1]])
    for k in range(1, int(figure.number("told")) + 1):
        number = ord(figure.text(f"name_{k}")) - ord("A")
        center, radius, _ = world.spheres[number]
        p = plus(world.eye, center, -1)
        a, b, c = dot(v, v), 2 * dot(p, v), dot(p, p) - radius * radius
        checks.same("a, b, c", [figure.number(f"{name}_{k}") for name in "abc"], [a, b, c])
        checks.same("the discriminant", [figure.number(f"discriminant_{k}")], [b * b - 4 * a * c],
                    within=1e-5 * max(1, b * b))
        ends = world.roots(v, number)
        checks.that("the number of roots", figure.number(f"roots_{k}") == (2 if ends else 0))
        if ends:
            checks.same("the roots", [figure.number(f"root_0_{k}"), figure.number(f"root_1_{k}")], ends)
    lines = [text for text, _, _ in figure.labels()]
    explained = [i for i in range(len(world.spheres)) if any(figure.text(f"name_{k}") == chr(ord("A") + i)
                                                             for k in range(1, int(figure.number("told")) + 1))]
    for i in explained:
        ends = world.roots(v, i)
        fate = "missed" if ends is None else "behind the eye" if ends[1] <= 0 else f"t = {number_shown(ends[0])}, {number_shown(ends[1])}"
        line = f"{chr(ord('A') + i)}: {fate}"
        checks.that("what becomes of each sphere is in the words", line in lines, f"{line!r}, not in {lines}")
    nearest = f"smallest t: {number_shown(hits[0][0])}, {chr(ord('A') + hits[0][1])}" if hits else "no hit: background"
    checks.that("and which hit is the closest", nearest in lines, f"{nearest!r}, not in {lines}")
    bytes_text = ", ".join(str(math.floor(255 * x + 0.5)) for x in world.color(v))
    checks.that("the color is in the words", f"color {bytes_text}" in lines, str(lines))
    checks.that("the color", figure.text("bytes_text") == bytes_text, figure.text("bytes_text"))


# ---- the story in words -------------------------------------------------------------------------------

def run(*arguments):
    return subprocess.run([os.path.join(PROGRAMS, PROGRAM), *map(str, arguments)], capture_output=True,
                          text=True, check=False, timeout=60)


def told(text, label):
    found = re.search(r"^ *" + re.escape(label) + r" +(.*)$", text, re.M)
    return [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", found.group(1))] if found else []


def story(scene, pixel):
    world = World(scene)
    path, picture = write(scene), os.path.join(folder.name, "picture.png")
    done = run("--explain", f"{pixel[0]},{pixel[1]}", path)
    text = done.stdout
    checks.that("there is a story", done.returncode == 0 and done.stderr == "", done.stderr)
    checks.that("it is at most 80 columns wide", all(len(line) <= 80 for line in text.splitlines()),
                max(text.splitlines(), key=len))
    v = world.pixel(*pixel)
    hits = world.hits(v)
    checks.same("the story's s and t", told(text, "normalized (s, t)"),
                [(pixel[0] + 0.5) / world.columns, 1 - (pixel[1] + 0.5) / world.rows], within=1e-4)
    checks.same("the story's vector", told(text, "vector from the eye"), v, within=1e-4)
    listed = [(float(t), name) for name, t in re.findall(r"^  (\w+) +t = (\S+)", text, re.M)]
    expected = [(t, chr(ord("A") + i)) for t, i in hits[:8]]
    checks.that("the story's hits, in order", [name for _, name in listed] == [name for _, name in expected],
                f"{listed}, expected {expected}")
    if expected:
        checks.same("the story's t's", [t for t, _ in listed], [t for t, _ in expected], within=1e-4)
    count = re.search(r"In all: (\d+) hit, (\d+) behind the eye, (\d+) missed", text)
    met = sum(world.roots(v, i) is not None for i in range(len(world.spheres)))
    checks.that("the story counts", count is not None and list(map(int, count.groups())) ==
                [len(hits), met - len(hits), len(world.spheres) - met], str(count))
    color = tuple(math.floor(255 * x + 0.5) for x in world.color(v))
    in_words = re.search(r"as bytes.*?(\d+), (\d+), (\d+) +#(\w{6})$", text, re.M)
    checks.that("the story's color", tuple(map(int, in_words.groups()[:3])) == color and
                int(in_words.group(4), 16) == rgb(world.color(v)), in_words.group(0))
    for order in ("image", "object"):
        run("--order", order, "-o", picture, path)
        checks.that(f"the picture also has it, in {order} order", png.pixel(picture, *pixel) == color)
    checks.that("the story says so", "the same" in text and "another" not in text)


# ---- all ----------------------------------------------------------------------------------------------

ray_casting(FOUR, (4, 4), [])
image_order(ONE, (5, 2), [])
object_order(ONE, (5, 2), [])
nearest_hit(ALONG, (0, 0), [])
asks_before_it_answers()
nearest_hit({**ALONG, "spheres": ALONG["spheres"][1:2]}, (0, 0))  # which is missed
for spot in ((5, 7), (2, 4), (6, 0)):
    for kind in (ray_casting, image_order, object_order, nearest_hit, explain_figure):
        kind(GROUND, spot)
BELOW = {**GROUND, "from": (0, -0.5, 6)}
nearest_hit(BELOW, (5, 4))
words = Figure(PROGRAM, "object-order", *scene_options({**BELOW, "spheres": BELOW["spheres"][:1]}, (5, 4))).in_words()[1]
checks.that("seen from inside, a sphere has no outline", "Sphere A has no outline here, because the eye is in it." in words, words)
plane_where_it_is_seen()
explain_figure(FOUR, (4, 4))
explain_figure(ALONG, (0, 0))
story(FOUR, (4, 4))
story(ALONG, (0, 0))
FIGURES = ("ray-casting", "image-order", "object-order", "nearest-hit", "explain")
for name in FIGURES:
    holds_for_every(checks, PROGRAM, name)
    holds_for_every(checks, PROGRAM, name, *scene_options(GROUND, (5, 7)), crowded=True)
    empty = {**DECK, "spheres": []}
    Figure(PROGRAM, name, *scene_options(empty, (3, 3)))
figure = Figure(PROGRAM, "object-order")
checks.that("a sphere like the deck's is inside its picture",
            all(1 <= x <= 3 and 1 <= y <= 3 for x, y, _ in figure.block("outline")))

dice = random.Random(6)
kinds = (ray_casting, image_order, object_order, nearest_hit, explain_figure, story)
for i in range(int(os.environ.get("SCENES", "5"))):
    scene = some_scene(dice, dice.randint(1, 8))
    pixel = telling_pixel(World(scene), dice)
    for kind in kinds if i < 5 else kinds[i % 6:i % 6 + 1]:
        kind(scene, pixel)
    anywhere = (dice.randrange(scene["size"][0]), dice.randrange(scene["size"][1]))
    kinds[i % 2 * 5](scene, anywhere)
    labels_are_clear(checks, PROGRAM, FIGURES[i % 5], scene_options(scene, pixel))
checks.end()
