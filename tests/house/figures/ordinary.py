"""ordinary.py - labels of ordinary figures never collide: cameras, rays and scenes drawn at random.

Ordinary: fields of view from 20 to 100 degrees, all aspects, any units, any hand.
ordinary.py COUNT [NAME...] draws each figure whose labels are placed by the rule, or those alone, that often, in
both shapes.
"""
import glob
import math
import multiprocessing
import os
import random
import sys
import tempfile

from cameras import options_of, some_camera
from check import Checks
from collisions import collisions, is_placed
from figure import Figure, dot, plus, times

# Numbers of figures that once collided: they are drawn even if only a few are.
HARD = {"screen-to-unit": (95, 221), "pixel-grid": (166, 327), "pixel-to-ray": (194, 958),
        "camera-forms": (765,), "object-order": (584, 647), "nearest-hit": (314, 394), "explain": (523, 988)}


def words(v):
    return ",".join(f"{x:.17g}" for x in v)


def direction(dice):
    while True:
        v = tuple(dice.uniform(-1, 1) for _ in range(3))
        if 0.1 < dot(v, v) < 1:
            return times(1 / dot(v, v) ** 0.5, v)


def camera(dice):
    """The larger side of its plane is seen at an angle of 20 to 100 degrees."""
    c, unit = some_camera(dice), 10 ** dice.uniform(-3, 3)
    c["d"] = unit * dice.uniform(0.5, 8)
    larger = 2 * c["d"] * math.tan(math.radians(dice.uniform(20, 100) / 2))
    aspect = math.exp(dice.uniform(-1, 1))
    c["w"], c["h"] = larger * min(1, aspect), larger * min(1, 1 / aspect)
    c["p"] = times(unit, c["p"])
    return c


def camera_options(dice):
    return options_of(camera(dice))


def place_options(dice):
    return camera_options(dice) + ["-s", dice.uniform(0, 1), "-t", dice.uniform(0, 1)]


def yours_options(dice):
    c = camera(dice)
    yours = plus(plus(times(c["d"], c["f"]), c["r"], c["w"] * dice.uniform(-1, 1)), c["u"], c["h"] * dice.uniform(-1, 1))
    return options_of(c) + dice.choice([[], ["--yours", words(yours)]])


def look_at_options(dice):
    c = camera(dice)
    if dice.random() < 0.5:
        return options_of(c)
    leaning = plus(c["u"], c["f"], dice.uniform(-1, 1))
    return ["--eye", words(c["p"]), "--at", words(plus(c["p"], c["f"], c["d"])), "--up", words(leaning),
            "--width", c["w"], "--aspect", c["w"] / c["h"], "--hand", dice.choice(["left", "right"])]


def screen(dice):
    most = dice.choice([12, 100, 2000])
    return dice.randint(most // 4, most), dice.randint(most // 4, most)


def point_options(dice):
    across, down = screen(dice)
    return ["--size", f"{across}x{down}", "--point", words((dice.uniform(0, across), dice.uniform(0, down)))]


def pixel_options(dice):
    across, down = screen(dice)
    return ["--size", f"{across}x{down}", "--pixel", f"{dice.randrange(across)},{dice.randrange(down)}"]


def chain_options(dice):
    return pixel_options(dice) + camera_options(dice)


def ray_options(dice):
    """From one to nine radii before the sphere, past it at up to 1.3 radii."""
    unit = 10 ** dice.uniform(-2, 2)
    center, r = tuple(unit * dice.uniform(-6, 6) for _ in range(3)), unit * dice.uniform(0.3, 3)
    line, aside = direction(dice), direction(dice)
    aside = plus(aside, line, -dot(aside, line))
    past = plus(center, aside, dice.uniform(0.02, 1.3) * r / max(0.05, dot(aside, aside) ** 0.5))
    start = plus(past, line, -dice.uniform(0, 9) * r)
    return ["--origin", words(start), "--direction", words(times(unit * dice.uniform(0.2, 5), line)),
            "--center", words(center), "--radius", f"{r:.17g}"]


def radius_options(dice):
    return ["--radius", f"{10 ** dice.uniform(-2, 2):.17g}"]


def scene_file(dice, folder):
    """Spheres in front of an eye, in any units."""
    unit = 10 ** dice.uniform(-2, 2)
    eye, f = tuple(unit * dice.uniform(-5, 5) for _ in range(3)), direction(dice)
    up = plus(direction(dice), f, -0.5)
    while abs(dot(up, f)) > 0.8 * dot(up, up) ** 0.5:
        up = direction(dice)
    size, lines = (dice.randint(3, 9), dice.randint(3, 9)), ["v"]
    lines += [f"from {words(eye)}", f"at {words(plus(eye, f, unit))}", f"up {words(up)}",
              f"angle {dice.uniform(20, 100)}", f"resolution {size[0]} {size[1]}"]
    for _ in range(dice.randint(1, 5)):
        far = unit * dice.uniform(2, 6)
        center = plus(plus(eye, f, far), direction(dice), far * dice.uniform(0, 0.4))
        lines += [f"f {words(dice.random() for _ in range(3))} 1 0 1 0 1",
                  f"s {words(center)} {far * dice.uniform(0.08, 0.3)}"]
    path = os.path.join(folder, "scene.nff")
    with open(path, "w", encoding="ascii") as file:
        file.write("b 0.1 0.1 0.2\n" + "\n".join(lines).replace(",", " ") + "\n")
    return path, f"{dice.randrange(size[0])},{dice.randrange(size[1])}"


def scene_options(dice, folder):
    path, pixel = scene_file(dice, folder)
    return ["--pixel", pixel, path]


OPTIONS = {"camera-frame": camera_options, "corner-vectors": camera_options, "point-30-10": place_options,
           "double-dwh": place_options, "yours-and-right": yours_options, "camera-forms": look_at_options,
           "screen-to-unit": point_options, "pixel-grid": pixel_options, "pixel-to-ray": chain_options,
           "ray-sphere": ray_options, "parabola": ray_options, "world-object": ray_options,
           "discriminant": radius_options}


def options_for(name, dice, folder):
    return OPTIONS[name](dice) if name in OPTIONS else scene_options(dice, folder)


def found_in(job):
    """What collides in one figure, in both shapes, with its command; None if its labels are placed by hand."""
    program, name, number = job
    found = []
    with tempfile.TemporaryDirectory() as folder:
        options = options_for(name, random.Random(f"{name} {number}"), folder)
        for shape in ("16:9", "4:3"):
            try:
                figure = Figure(program, name, *options, settings=f"shape='{shape}'")
            except AssertionError as error:
                return name, [str(error)]
            if not is_placed(figure):
                return name, None
            if collided := collisions(figure):
                found.append("\n    ".join([f"{shape}: {program} --figure {name} {' '.join(map(str, options))}",
                                            *collided]))
    return name, found


def main():
    count, wanted = int(sys.argv[1]), sys.argv[2:]
    # In chapter 07, pictures are the most of a figure, and its labels are always the same.
    layouts = sorted(glob.glob("chapters/0[1-6]-*/figures/*.gp"))
    figures = [(layout.split("/")[1], os.path.basename(layout)[:-3]) for layout in layouts]
    figures = [(program, name) for program, name in figures if not wanted or name in wanted]
    checks = Checks("labels of ordinary figures")
    counts = {name: [0, 0] for _, name in figures}
    jobs = [(program, name, number) for program, name in figures
            for number in sorted({*range(count), *HARD.get(name, ())})]
    with multiprocessing.Pool() as pool:
        for name, found in pool.imap_unordered(found_in, jobs, chunksize=4):
            if found is None:
                continue
            counts[name][0] += 2
            counts[name][1] += len(found)
            checks.that(f"labels of {name}", not found, "\n    ".join(found))
    for name, (drawn, collided) in counts.items():
        print(f"{name}: {collided} of {drawn} figures have labels that collide")
    checks.end()


if __name__ == "__main__":
    main()
