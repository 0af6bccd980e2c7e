"""read_example.py - an example for the lecture, from a file with a name, as the numbers that programs are compiled with.

    read_example.py NAME.txt > NAME.h

A camera is given as the deck gives it (right, up, forward, distance, width, height), or as a look-at: look-at and up
say where it looks, width or angle (degrees across) how much it sees, and the height follows from the screen. What is
left out is the deck's.
"""
import math
import re
import sys

COUNTS = {"eye": 3, "right": 3, "up": 3, "forward": 3, "distance": 1, "width": 1, "height": 1, "look-at": 3, "angle": 1,
          "place": 2, "screen": 2, "point": 2, "ray-origin": 3, "ray-direction": 3, "center": 3, "radius": 1}
WHOLE = ("screen", "point")
NUMBERS = {1: "one number", 2: "two numbers", 3: "three numbers"}
LEAST_SINE = 1e-6  # of the angle between up and where the camera looks


class Refused(Exception):
    """With what is wrong."""


def read_number(text, whole):
    number = int(text) if whole else float(text)
    if not math.isfinite(number):
        raise ValueError
    return number


def read_line(line):
    name, _, rest = line.strip().partition(" ")
    if name not in COUNTS:
        raise Refused(f"'{name}' is not known, expected one of {', '.join(COUNTS)}")
    words, count = re.split(r"\s*[,x]\s*|\s+", rest.strip()), COUNTS[name]
    kind = f"{name}: expected {NUMBERS[count]}{', whole ones' if name in WHOLE else ''}, found '{rest.strip()}'"
    try:
        numbers = [read_number(word, name in WHOLE) for word in words]
    except ValueError as error:
        raise Refused(kind) from error
    if len(numbers) != count:
        raise Refused(kind)
    return name, numbers


def read(path):
    given = {}
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            line = line.partition("#")[0].strip()
            try:
                name, numbers = read_line(line) if line else (None, None)
            except Refused as error:
                raise Refused(f"{path}:{number}: {error}") from error
            if name in given:
                raise Refused(f"{path}:{number}: {name} is there twice")
            given.update({name: numbers} if line else {})
    return given


# ---- a look-at becomes the deck's form ------------------------------------------------------------

def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(v):
    return [x / math.hypot(*v) for x in v]


def said(v):
    return f"({', '.join(f'{x:g}' for x in v)})"


def look_at(given):
    """Right is where up and forward leave it, of the hand that the deck's camera has: left."""
    eye, at, up = given.get("eye", [2, 2, -4]), given.pop("look-at"), given.get("up", [0, 1, 0])
    for name in ("right", "forward"):
        if name in given:
            raise Refused(f"look-at and {name} do not go together: right, up and forward follow from look-at and up")
    ahead = minus(at, eye)
    distance = math.hypot(*ahead)
    if distance == 0:
        raise Refused(f"look-at {said(at)} is the eye")
    if math.hypot(*cross(ahead, up)) <= LEAST_SINE * distance * math.hypot(*up):
        raise Refused(f"up {said(up)} goes the same way as the camera looks, {said(ahead)}")
    forward = unit(ahead)
    right = unit(cross(up, forward))
    given.update({"right": right, "up": cross(forward, right), "forward": forward})
    given.setdefault("distance", [distance])


def width_of_angle(given):
    angle = given.pop("angle")[0]
    if "width" in given:
        raise Refused("angle and width do not go together: each says the other")
    if not 0 < angle < 180:
        raise Refused(f"angle is {angle:g}, expected more than 0 and less than 180 degrees")
    given["width"] = [2 * given.get("distance", [4])[0] * math.tan(math.radians(angle / 2))]


def complete(given):
    is_look_at = "look-at" in given
    if is_look_at:
        look_at(given)
    if "angle" in given:
        width_of_angle(given)
    if (is_look_at or "width" in given) and "height" not in given:
        columns, rows = given.get("screen", [640, 480])
        if columns > 0:
            given["height"] = [given.setdefault("width", [2])[0] * rows / columns]


def main(path):
    try:
        given = read(path)
        try:
            complete(given)
        except Refused as error:
            raise Refused(f"{path}: {error}") from error
    except (Refused, OSError, UnicodeDecodeError) as error:
        print(error, file=sys.stderr)
        return 1
    print(f"// Made from {path}.\n#include \"chapters/example.h\"\n#undef EXAMPLE_FILE\n#define EXAMPLE_FILE \"{path}\"")
    for name, numbers in given.items():
        macro = f"EXAMPLE_{name.upper().replace('-', '_')}"
        print(f"#undef {macro}\n#define {macro} {', '.join(f'{x!r}' for x in numbers)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
