"""cameras.py - the deck's camera, any camera, and places on its image plane, for the tests of figures."""
import os
import tempfile

from figure import Figure, plus, times

DECK = {"p": (2, 2, -4), "r": (1, 0, 0), "u": (0, 1, 0), "f": (0, 0, 1), "d": 4, "w": 2, "h": 2}


def some_camera(dice, one=1.0):
    """Any camera, of either handedness, in such units; three vectors made perpendicular by Gram and Schmidt."""
    def direction():
        while True:
            v = [dice.uniform(-1, 1) for _ in range(3)]
            if 0.1 < sum(x * x for x in v) < 1:
                return v
    frame = []
    while len(frame) < 3:
        v = direction()
        for unit in frame:
            v = plus(v, unit, -sum(a * b for a, b in zip(v, unit)))
        length = sum(x * x for x in v) ** 0.5
        if length > 0.05:
            frame.append(times(1 / length, v))
    return {"p": tuple(one * dice.uniform(-9, 9) for _ in range(3)), "r": frame[0], "u": frame[1],
            "f": frame[2], **{side: one * dice.uniform(0.5, 8) for side in "dwh"}}


def options_of(c):
    def words(v):
        return ",".join(f"{x:.17g}" for x in v)
    return ["--eye", words(c["p"]), "--right", words(c["r"]), "--up", words(c["u"]),
            "--forward", words(c["f"]), "--distance", c["d"], "--width", c["w"], "--height", c["h"]]


def vector_to(c, across, upward):
    """Ahead, aside by that number of halves of the width, up by that number of halves of the height."""
    return plus(plus(times(c["d"], c["f"]), c["r"], across * c["w"] / 2), c["u"], upward * c["h"] / 2)


def corners(c):
    """Of the image plane, as points of the world: upper left, upper right, lower right, lower left."""
    return [plus(c["p"], vector_to(c, *corner)) for corner in ((-1, 1), (1, 1), (1, -1), (-1, -1))]


def beside_right(program, name, *cameras):
    """The figures of these cameras, each as a wrong answer is drawn: beside the deck's, the right one."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "right.gp")
        with open(path, "w", encoding="utf-8") as file:
            file.write(Figure(program, name, *options_of(DECK)).script)
        return [Figure(program, name, *options_of(c), "--beside", path) for c in cameras]
