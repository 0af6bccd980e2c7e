"""pbrt.py - reads a pbrt-v4 scene by the syntax of its documentation, and holds it against the NFF.

Usage: pbrt.py SCENE.pbrt SCENE.nff. A directive, then "type name" [ values ] pairs; the camera's
Transform, column by column, takes the world to a camera that looks along z.
"""
import math
import re
import sys

from figure import cross, unit

PARAMETERS = {
    "Transform": None, "Camera": "string", "Film": "string", "PixelFilter": "string",
    "Sampler": "string", "Integrator": "string", "WorldBegin": "", "AttributeBegin": "",
    "AttributeEnd": "", "LightSource": "string", "AreaLightSource": "string", "Material": "string",
    "Translate": 3, "Shape": "string"}
TYPES = {"float": float, "integer": int, "rgb": float, "point3": float, "string": str}


def statements(text):
    """(directive, kind, {name: values}) of each; a ValueError where the syntax is broken."""
    text = re.sub(r"#.*", "", text)
    words = re.findall(r'"[^"]*"|\[|\]|[^\s\[\]"]+', text)
    at = 0
    while at < len(words):
        directive = words[at]
        if directive not in PARAMETERS:
            raise ValueError(f"no directive: {directive}")
        at += 1
        takes = PARAMETERS[directive]
        if takes is None:
            end = words.index("]", at)
            yield directive, [float(word) for word in words[at + 1:end]], {}
            at = end + 1
            continue
        if isinstance(takes, int):
            yield directive, [float(word) for word in words[at:at + takes]], {}
            at += takes
            continue
        kind = ""
        if takes == "string":
            kind, at = words[at].strip('"'), at + 1
        named = {}
        while at < len(words) and words[at].startswith('"'):
            what, name = words[at].strip('"').split(" ")
            if words[at + 1] == "[":
                end = words.index("]", at)
                values, at = words[at + 2:end], end + 1
            else:
                values, at = [words[at + 1]], at + 2
            named[name] = [TYPES[what](value.strip('"')) for value in values]
        yield directive, kind, named


def nff(path):
    view, spheres = {}, []
    with open(path, encoding="ascii") as file:
        for line in file:
            word, *numbers = line.split("#")[0].split() or [""]
            if word in ("from", "at", "up", "angle", "resolution"):
                view[word] = [float(n) for n in numbers]
            if word == "s":
                spheres.append([float(n) for n in numbers])
    return view, spheres


def near(a, b):
    return len(a) == len(b) and all(abs(x - y) < 1e-9 * (1 + abs(y)) for x, y in zip(a, b))


def main(path, scene):
    with open(path, encoding="ascii") as file:
        found = list(statements(file.read()))
    view, spheres = nff(scene)
    forward = unit([a - b for a, b in zip(view["at"], view["from"])])
    right = unit(cross(forward, view["up"]))
    up = cross(right, forward)
    wanted = []
    for i in range(3):
        wanted += [right[i], up[i], forward[i], 0]
    wanted += [-sum(a * b for a, b in zip(axis, view["from"])) for axis in (right, up, forward)] + [1]
    by_name = {directive: (kind, named) for directive, kind, named in found}
    assert near(by_name["Transform"][0], wanted), f"camera {by_name['Transform'][0]}, expected {wanted}"
    half = math.tan(math.radians(view["angle"][0] / 2))
    tall = half * view["resolution"][1] / view["resolution"][0]
    assert near(by_name["Camera"][1]["screenwindow"], [-half, half, -tall, tall]), by_name["Camera"]
    places = [values for directive, values, _ in found if directive == "Translate"]
    radii = [named["radius"] for directive, kind, named in found if directive == "Shape"]
    drawn = [place + radius for place, radius in zip(places, radii)]
    assert all(near(a, b) for a, b in zip(drawn, spheres)) and len(drawn) == len(spheres), drawn
    order = [directive for directive, _, _ in found]
    assert order.index("Camera") < order.index("WorldBegin") < order.index("Shape")
    assert order.count("AttributeBegin") == order.count("AttributeEnd") == len(spheres)


main(*sys.argv[1:])
