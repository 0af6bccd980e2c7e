"""animations.py - what the animations show at each moment, and the frames that are drawn of it.

Scenes are made here at random, as NFF. The expected hits are computed by plane geometry, without a
quadratic: the point of a ray nearest to a sphere's center, and half the chord through it.
"""
import math
import os
import random
import re
import subprocess
import tempfile

from check import Checks, on_the_canvas
from figure import Figure, PROGRAMS, SVG, dot, numbers, plus, times
from shown import shown

checks = Checks("animations")
folder = tempfile.TemporaryDirectory()
random.seed(int(os.environ.get("SEED") or 2015))
TEXT = 24  # units of 540, of the smallest text


def script_of(name, *options):
    done = subprocess.run([os.path.join(PROGRAMS, "print_animation"), name, *options], capture_output=True, text=True,
                          check=False, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"{name}: {done.stderr.strip()}")
    return done.stdout


def frame(script, step, theme="light"):
    return Figure(None, None, script=script, settings=f"step={step}; theme='{theme}'")


def large_enough(name, figure):
    sizes = [float(span.get("font-size") or group.get("font-size")) for group in figure.svg.iter(SVG + "g")
             for text in group.findall(SVG + "text") for span in text.iter() if (span.text or "").strip()]
    checks.that(f"{name}: no text is smaller than {TEXT} units", sizes and min(sizes) > TEXT - 0.5, str(sorted(sizes)[:3]))
    on_the_canvas(checks, name, figure)


# ---- a random scene, and its hits -------------------------------------------------------------------

class World:
    """The eye at the origin looks along z; the image plane is 1 away and 1 wide."""

    def __init__(self):
        self.columns, self.rows = random.randint(5, 9), random.randint(5, 9)
        # Each is its own color, and leaves a place in the middle to the one behind it.
        self.colors = [(0.9, 0.3, 0.1), (0.1, 0.6, 0.4), (0.7, 0.4, 0.6), (0.2, 0.5, 0.8)]
        self.spheres = []
        for i in random.sample(range(4), 4):
            z = 3 + 1.5 * i
            self.spheres.append(((random.uniform(-0.12, 0.12) * z, random.uniform(-0.12, 0.12) * z, z), 0.15 * z))
        self.path = os.path.join(folder.name, "scene.nff")
        with open(self.path, "w", encoding="utf-8") as file:
            file.write("b 0 0 0\nv\nfrom 0 0 0\nat 0 0 1\nup 0 1 0\n"
                       f"angle {math.degrees(2 * math.atan(0.5)):.17g}\nhither 0.1\nresolution {self.columns} {self.rows}\n")
            for color, (center, radius) in zip(self.colors, self.spheres):
                file.write("f %g %g %g 0.8 0.2 20 0 1\n" % color)
                file.write("s %.17g %.17g %.17g %.17g\n" % (*center, radius))

    def ray(self, column, row):
        # NFF is right-handed: whoever looks along z with y up has x at the left.
        return (0.5 - (column + 0.5) / self.columns, (0.5 - (row + 0.5) / self.rows) * self.rows / self.columns, 1.0)

    def hit(self, ray, sphere):
        center, radius = self.spheres[sphere]
        nearest = dot(center, ray) / dot(ray, ray)
        gap = plus(center, ray, -nearest)
        half = radius * radius - dot(gap, gap)
        if half < 0:
            return math.inf
        t = nearest - math.sqrt(half / dot(ray, ray))
        return t if t > 0 else math.inf

    def closest(self, ray, spheres):
        return min(((self.hit(ray, i), i) for i in spheres), default=(math.inf, -1))

    def shown(self, column, row):
        t, sphere = self.closest(self.ray(column, row), range(4))
        return sphere if t < math.inf else -1


def rgb(color):
    return "#%02x%02x%02x" % tuple(math.floor(255 * c + 0.5) for c in color)


def cells_drawn(figure, columns, rows):
    """The pixels of the picture: column and row of the middle, and the color, in the order of drawing."""
    outline = figure.lines("picture, outline")[0]
    left, right = min(x for x, _ in outline), max(x for x, _ in outline)
    low, high = min(y for _, y in outline), max(y for _, y in outline)
    found = []
    for group in figure.groups("picture, pixels"):
        for shape in group.iter(SVG + "polygon"):
            flat = numbers(shape.get("points"))
            x, y = sum(flat[::2]) / len(flat[::2]), 540 - sum(flat[1::2]) / len(flat[1::2])
            fill = shape.get("fill") or re.search(r"rgb\( *(\d+), *(\d+), *(\d+)\)", shape.get("style") or "")[0]
            parts = [int(n) for n in re.findall(r"\d+", fill)]
            found.append((math.floor((x - left) / (right - left) * columns),
                          math.floor((high - y) / (high - low) * rows), "#%02x%02x%02x" % tuple(parts[:3])))
    return found


# ---- image order, and object order ------------------------------------------------------------------

def image_order(world):
    script = script_of("image-order", world.path)
    count = world.columns * world.rows
    order = [(i % world.columns, i // world.columns) for i in range(count)]
    colors = {-1: "#000000", **{i: rgb(color) for i, color in enumerate(world.colors)}}
    for k in (1, random.randint(2, count - 1), count):
        figure = frame(script, k, "dark" if k == count else "light")
        checks.that(f"image order: frame {k} fills exactly the first {k} pixels", [cell[:2] for cell in
                    cells_drawn(figure, world.columns, world.rows)] == order[:k])
        checks.that(f"image order: frame {k} has the colors of the closest spheres",
                    [cell[2] for cell in cells_drawn(figure, world.columns, world.rows)] ==
                    [colors[world.shown(*cell)] for cell in order[:k]])
        large_enough(f"image order, frame {k}", figure)
        said = [label for label, _, _ in figure.labels() if label.startswith("pixel")]
        ball = world.shown(*order[k - 1])
        checks.that(f"image order: frame {k} says which sphere is hit", said == ["pixel (%d, %d): " % order[k - 1] + (
            "the ray hits nothing" if ball < 0 else f"the ray hits sphere {'ABCD'[ball]}")], str(said))
    checks.that("image order: there is a frame for each pixel", figure.number("sets") == count)
    rays = figure.block("rays")
    per_ray = len(rays) // count
    for i, cell in enumerate(order):
        ray, end = world.ray(*cell), rays[(i + 1) * per_ray - 1][:3]
        t, _ = world.closest(ray, range(4))
        if t < math.inf:
            checks.same(f"image order: the ray of pixel {cell} ends at its closest hit", end, times(t, ray))
    return [world.shown(*cell) for cell in order]


def object_order(world, picture):
    script = script_of("object-order", world.path)
    figure = frame(script, 1000)
    sets, moments = figure.block("pixel_sets"), figure.block("moments")
    count = world.columns * world.rows
    last = {(int(column), int(row)): int(sphere) for column, row, sphere in sets}
    checks.that("object order: in the end it is the picture of image order",
                [last[i % world.columns, i // world.columns] for i in range(count)] == picture)
    checks.that("object order: no pixel is set to a sphere that its ray misses",
                all(ball < 0 or world.hit(world.ray(column, row), int(ball)) < math.inf for column, row, ball in sets))
    checks.that("object order: the spheres have their turn one after the other",
                [int(s[2]) for s in sets] == sorted(int(s[2]) for s in sets))
    checks.that("object order: the last frame has all pixels", int(moments[-1][3]) == len(sets))
    checks.that("object order: a frame sets one pixel at most, after the background",
                all(b[3] - a[3] in (0, 1) for a, b in zip(moments[1:], moments[2:])))
    for ball, own, inside in figure.block("shares"):
        within = sum(world.hit(world.ray(i % world.columns, i // world.columns), int(ball)) < math.inf for i in range(count))
        checks.that(f"object order: sphere {'ABCD'[int(ball)]} has {within} pixels inside its outline", inside == within)
        checks.that(f"object order: sphere {'ABCD'[int(ball)]} sets those of its turn",
                    own == sum(int(s[2]) == int(ball) for s in sets))
    k = next(i for i, m in enumerate(moments) if m[0] == 1 and m[3] > 0 and m[2] == 1) + 1
    drawn = cells_drawn(frame(script, k, "dark"), world.columns, world.rows)
    checks.that(f"object order: frame {k} has the pixels set by then", [cell[:2] for cell in drawn] ==
                [(int(s[0]), int(s[1])) for s in sets[:int(moments[k - 1][3])]])
    large_enough("object order", figure)


# ---- one ray ------------------------------------------------------------------------------------------

def closest_hit(world):
    script = script_of("closest-hit", world.path)
    figure = frame(script, 1000)
    # The pixel is the one whose ray meets most: its ray is in the data of image order too.
    pixel = [int(n) for n in re.findall(r"\d+", frame(script_of("image-order", world.path), 1).text("pixel_text"))]
    ray = world.ray(*pixel)
    moments = figure.block("moments")
    best = math.inf
    for ball, tip, t, so_far, answered in moments:
        if ball >= 0 and answered:
            best = min(best, world.hit(ray, int(ball)))
            checks.same(f"closest hit: after sphere {'ABCD'[int(ball)]} the closest so far", [t if best < math.inf else 0],
                        [best if best < math.inf else 0])
    wanted, sphere = world.closest(ray, range(4))
    checks.that("closest hit: the ray meets a sphere", wanted < math.inf)
    checks.same("closest hit: the last step is there", moments[-1][1:3], [wanted, wanted])
    checks.that("closest hit: and names its sphere", int(moments[-1][3]) == sphere)
    checks.that("closest hit: it never moves away again", all(
        not b[2] > a[2] for a, b in zip(moments, moments[1:]) if a[3] >= 0))
    checks.shows(figure, f"closest hit: t = {round(wanted, 3):.4g}, sphere {'ABCD'[sphere]}")
    eye, tip, mark = figure.dots("eye")[0], figure.tips("v")[0], figure.dots("closest so far, hit")[0]
    checks.near("closest hit: the mark of the last frame is at that t", [mark],
                (eye[0] + wanted * (tip[0] - eye[0]), eye[1]), 1)
    large_enough("closest hit", figure)
    large_enough("closest hit, half way", frame(script, len(moments) // 2, "dark"))


def discriminant():
    script = script_of("discriminant")
    figure = frame(script, 1000, "dark")
    r, v, rays = figure.number("r"), figure.number("v"), figure.block("rays")
    checks.that("discriminant: there is a ray for each frame", len(rays) == figure.number("moments"))
    for i, (_, _, y, *_) in enumerate(rays):
        # (b² − 4ac) / (4 v²) is by how much the square of the radius exceeds that of the distance.
        wanted, got = 4 * v * v * (r * r - y * y), figure.number(f"panel{i + 1}_D")
        checks.same(f"discriminant: frame {i + 1}", [got], [wanted], 1e-9)
        checks.that(f"discriminant: its sign in frame {i + 1}", (got > 0) - (got < 0) == (y < r) - (y > r))
        checks.that(f"discriminant: its roots in frame {i + 1}", figure.number(f"panel{i + 1}_roots") == (0 if y > r else 2))
    moves = [(b[1] - a[1], a[2] - b[2]) for a, b in zip(rays, rays[1:])]
    checks.that("discriminant: the ray only moves down and ahead, and never jumps",
                all(0 <= x <= 0.15 * r and 0 <= y <= 0.15 * r for x, y in moves), str(max(moves)))
    stays = figure.block("stays")
    names = ["miss", "tangent", "two hits", "inside", "behind"]
    for name, (first, last) in zip(names, stays):
        at = frame(script, random.randint(int(first), int(last)))
        checks.that(f"discriminant: the frames from {first:g} to {last:g} show: {name}",
                    name in [label for label, _, _ in at.labels()], str(at.labels()))
        large_enough(f"discriminant, {name}", at)
        still = Figure("05-quadratic", "discriminant")
        for i in range(2 if name in ("two hits", "inside", "behind") else 0):
            t = shown(still.number(f"panel{names.index(name) + 1}_t{i}"))
            checks.shows(at, f"t{i} = {t}")


random_world = World()
object_order(random_world, image_order(random_world))
closest_hit(random_world)
discriminant()
checks.end()
