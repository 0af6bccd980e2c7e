"""png.py - the colors of a PNG, by libpng's simplified interface: red, green, blue, pixel by pixel.

From the upper left on, row by row, as bytes. As a program: do two files hold the same picture, that is, the same size
and the same colors, however each was encoded? Exit status 0 if they do, 1 with the first difference if not.

    png.py ONE.png OTHER.png [PIXELS [MEAN]]
    png.py ONE.png OTHER.png --blocks MOST

PIXELS: the number of pixels that may differ; with MEAN, by more than 1, and all by at most so much on average. --blocks
MOST: the means of each 8 x 8 pixels differ by at most so much, as for a picture that was given a palette.
"""
import ctypes
import ctypes.util
import sys
from pathlib import Path

PNG_IMAGE_VERSION, PNG_FORMAT_RGB = 1, 2
BLOCK = 8


class Image(ctypes.Structure):
    """png_image of png.h"""
    _fields_ = [("opaque", ctypes.c_void_p), *((name, ctypes.c_uint32) for name in (
        "version", "width", "height", "format", "flags", "colormap_entries", "warning_or_error")), ("message", ctypes.c_char * 64)]


def read(data, path=""):
    """(width, height), colors"""
    library = ctypes.CDLL(ctypes.util.find_library("png16") or "libpng16.so.16")
    image = Image(version=PNG_IMAGE_VERSION)
    good = library.png_image_begin_read_from_memory(ctypes.byref(image), data, ctypes.c_size_t(len(data)))
    image.format = PNG_FORMAT_RGB
    colors = ctypes.create_string_buffer(3 * image.width * image.height)
    good = good and library.png_image_finish_read(ctypes.byref(image), None, colors, 0, None)
    assert good, f"{path}: {image.message.decode()}"
    return (image.width, image.height), colors.raw


def decoded(data, path=""):
    return read(data, path)[1]


def pixels(path):
    return decoded(Path(path).read_bytes(), path)


def pixel(path, column, row):
    (width, _), colors = read(Path(path).read_bytes(), path)
    at = 3 * (row * width + column)
    return tuple(colors[at:at + 3])


def apart(one, other):
    """How far apart each two pixels are: the largest of three differences of bytes."""
    all_bytes = list(map(lambda a, b: abs(a - b), one, other))
    return list(map(max, all_bytes[::3], all_bytes[1::3], all_bytes[2::3]))


def blocks_apart(one, other, width, height):
    """The largest difference of the means of a block, of its three colors."""
    most = 0
    for top in range(0, height, BLOCK):
        rows = range(top, min(top + BLOCK, height))
        for left in range(0, width, BLOCK):
            right = min(left + BLOCK, width)
            for color in range(3):
                parts = [slice(3 * (row * width + left) + color, 3 * (row * width + right), 3) for row in rows]
                sums = [sum(sum(picture[part]) for part in parts) for picture in (one, other)]
                most = max(most, abs(sums[0] - sums[1]) / (len(rows) * (right - left)))
    return most


def main(words):
    (size, one), (other_size, other) = (read(Path(path).read_bytes(), path) for path in words[:2])
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


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
