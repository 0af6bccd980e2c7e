"""same_picture.py - do two PNG files hold the same picture?

The same size and the same decoded 8-bit RGB, however each was encoded. Exit status 0 if they are the same, 1 with the
first difference if not.

    same_picture.py ONE.png OTHER.png [PIXELS [MEAN]]
    same_picture.py ONE.png OTHER.png --blocks MOST

PIXELS: the number of pixels that may differ; with MEAN, by more than 1, and all by at most so much on average. --blocks
MOST: the means of each 8 x 8 pixels differ by at most so much, as for a picture that was given a palette.
"""
import sys
from pathlib import Path

import png

BLOCK = 8


def apart(one, other):
    """How far apart each two pixels are: the largest of three differences of bytes."""
    all_bytes = list(map(lambda a, b: abs(a - b), one, other))
    return list(map(max, all_bytes[::3], all_bytes[1::3], all_bytes[2::3]))


def blocks_apart(one, other, width, height):
    """The largest difference of the means of a block, of its three colours."""
    most = 0
    for top in range(0, height, BLOCK):
        rows = range(top, min(top + BLOCK, height))
        for left in range(0, width, BLOCK):
            right = min(left + BLOCK, width)
            for colour in range(3):
                parts = [slice(3 * (row * width + left) + colour, 3 * (row * width + right), 3) for row in rows]
                sums = [sum(sum(picture[part]) for part in parts) for picture in (one, other)]
                most = max(most, abs(sums[0] - sums[1]) / (len(rows) * (right - left)))
    return most


def main(words):
    (size, one), (other_size, other) = (png.read(Path(path).read_bytes(), path) for path in words[:2])
    if size != other_size:
        print(f"{size[0]} x {size[1]} pixels against {other_size[0]} x {other_size[1]}")
        return 1
    if words[2:3] == ["--blocks"]:
        most = blocks_apart(one, other, *size)
        print(f"the means of {BLOCK} x {BLOCK} pixels differ by at most {most:g}")
        return most > float(words[3])
    if one == other:
        return 0
    distances = apart(one, other)
    mean = sum(distances) / len(distances)
    different = [place for place, distance in enumerate(distances) if distance > (len(words) > 3)]
    if len(different) <= int((words[2:] or [0])[0]) and (len(words) < 4 or mean <= float(words[3])):
        return 0
    first = (different or [0])[0]
    print(f"{len(different)} pixels differ, first in column {first % size[0]}, row {first // size[0]}; by {mean:g} on average")
    return 1


sys.exit(main(sys.argv[1:]))
