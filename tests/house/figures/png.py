"""png.py - the colours of a PNG, of 8-bit RGB or with a palette: red, green, blue, pixel by pixel.

From the upper left on, row by row, as one bytearray.
"""
import struct
import zlib


def chunks(data):
    at = 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size


def predicted(kind, left, above, corner):
    """The byte that a filter of PNG predicts."""
    if kind < 4:
        return (0, left, above, (left + above) // 2)[kind]
    return min((left, above, corner), key=lambda x: abs(left + above - corner - x))


def rows(raw, height, line, step):
    """The bytes of each row; a filter compares each with the byte that is step bytes to the left."""
    before = bytes(line)
    for row in range(height):
        kind, now = raw[row * (line + 1)], bytearray(raw[row * (line + 1) + 1:(row + 1) * (line + 1)])
        if kind == 2:  # the row above, as our own pictures have it: large ones are read quickly
            now = bytearray((a + b) & 255 for a, b in zip(now, before))
        for i in range(line if kind in (1, 3, 4) else 0):
            left, corner = (now[i - step], before[i - step]) if i >= step else (0, 0)
            now[i] = (now[i] + predicted(kind, left, before[i], corner)) & 255
        yield now
        before = now


def by_palette(row, width, depth, palette):
    """A row of indices, several to a byte, as colours."""
    found = bytearray()
    for column in range(width):
        bit = column * depth
        index = row[bit // 8] >> (8 - depth - bit % 8) & ((1 << depth) - 1)
        found += palette[3 * index:3 * index + 3]
    return found


def pixels(path):
    with open(path, "rb") as file:
        return decoded(file.read(), path)


def decoded(data, path=""):
    parts = list(chunks(data))
    width, height, depth, kind = struct.unpack(">IIBB", dict(parts)[b"IHDR"][:10])
    raw = zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT"))
    if kind == 3:
        palette = dict(parts)[b"PLTE"]
        return bytearray().join(by_palette(row, width, depth, palette)
                                for row in rows(raw, height, (width * depth + 7) // 8, 1))
    assert (depth, kind) == (8, 2), f"{path}: neither 8-bit RGB nor a palette"
    return bytearray().join(rows(raw, height, 3 * width, 3))


def pixel(path, column, row):
    with open(path, "rb") as file:
        width, = struct.unpack(">I", file.read(20)[16:])
    at = 3 * (row * width + column)
    return tuple(pixels(path)[at:at + 3])
