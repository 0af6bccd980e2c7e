"""png.py - a PNG of 8-bit RGB or of a palette: red, green, blue, pixel by pixel from the upper left."""
import struct
import zlib


def chunks(data):
    at = 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size


def predicted(kind, left, above, corner):
    """What a filter of PNG expects of a byte."""
    if kind < 4:
        return (0, left, above, (left + above) // 2)[kind]
    return min((left, above, corner), key=lambda x: abs(left + above - corner - x))


def size(path):
    with open(path, "rb") as file:
        return struct.unpack(">II", file.read(24)[16:])


def pixels(path):
    with open(path, "rb") as file:
        data = file.read()
    packed, palette = b"", None
    for name, body in chunks(data):
        if name == b"IHDR":
            width, height, depth, kind = struct.unpack(">IIBB", body[:10])
            assert (depth, kind) == (8, 2) or kind == 3, f"{path}: not 8-bit RGB, no palette"
        if name == b"PLTE":
            palette = body
        if name == b"IDAT":
            packed += body
    raw = zlib.decompress(packed)
    bits = depth if palette else 24
    line, step = (bits * width + 7) // 8, (bits + 7) // 8
    found, before = bytearray(), bytes(line)
    for row in range(height):
        kind, *rest = raw[row * (line + 1):(row + 1) * (line + 1)]
        now = bytearray(rest)
        for i in range(line):
            left, corner = (now[i - step], before[i - step]) if i >= step else (0, 0)
            now[i] = (now[i] + predicted(kind, left, before[i], corner)) & 255
        found += colors(now, width, depth, palette) if palette else now
        before = now
    return found


def colors(line, width, depth, palette):
    """What the indices of a row stand for, the first in the highest bits."""
    found = b""
    for i in range(width):
        byte, bit = divmod(i * depth, 8)
        index = line[byte] >> (8 - depth - bit) & ((1 << depth) - 1)
        found += palette[3 * index:3 * index + 3]
    return found
