"""png.py - the colours of a PNG, of 8-bit RGB or with a palette: red, green, blue, pixel by pixel.

From the upper left on, row by row, as one bytearray.
"""
import struct
import zlib
from itertools import accumulate


def chunks(data):
    at = 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size


def unfiltered(kind, now, before, step):
    """The bytes of a row. A filter of PNG compares each with the one step bytes to the left, and with those above."""
    if kind == 1:
        for first in range(step):
            now[first::step] = bytes(byte & 255 for byte in accumulate(now[first::step]))
    elif kind == 2:
        now = bytearray((a + b) & 255 for a, b in zip(now, before))
    elif kind == 3:
        for i, above in enumerate(before):
            now[i] = (now[i] + (above + (now[i - step] if i >= step else 0)) // 2) & 255
    elif kind == 4:
        for i, above in enumerate(before):
            left, corner = (now[i - step], before[i - step]) if i >= step else (0, 0)
            to_left, to_above, to_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
            near = left if to_left <= to_above and to_left <= to_corner else above if to_above <= to_corner else corner
            now[i] = (now[i] + near) & 255
    return now


def rows(raw, height, line, step):
    before = bytearray(line)
    for at in range(0, height * (line + 1), line + 1):
        before = unfiltered(raw[at], bytearray(raw[at + 1:at + 1 + line]), before, step)
        yield before


def colours_of_bytes(depth, palette):
    """For each byte of a row of indices: the colours of its pixels."""
    return [b"".join(palette[3 * index:3 * index + 3] for index in
                     (byte >> shift & ((1 << depth) - 1) for shift in range(8 - depth, -1, -depth)))
            for byte in range(256)]


def pixels(path):
    with open(path, "rb") as file:
        return decoded(file.read(), path)


def decoded(data, path=""):
    parts = list(chunks(data))
    width, height, depth, kind = struct.unpack(">IIBB", dict(parts)[b"IHDR"][:10])
    raw = zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT"))
    if kind == 3:
        palette = dict(parts)[b"PLTE"]
        colours = colours_of_bytes(depth, palette)
        return bytearray().join(b"".join(map(colours.__getitem__, row))[:3 * width]
                                for row in rows(raw, height, (width * depth + 7) // 8, 1))
    assert (depth, kind) == (8, 2), f"{path}: neither 8-bit RGB nor a palette"
    return bytearray().join(rows(raw, height, 3 * width, 3))


def pixel(path, column, row):
    with open(path, "rb") as file:
        width, = struct.unpack(">I", file.read(20)[16:])
    at = 3 * (row * width + column)
    return tuple(pixels(path)[at:at + 3])
