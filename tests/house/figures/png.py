"""png.py - the colours of a PNG, by libpng's simplified interface: red, green, blue, pixel by pixel.

From the upper left on, row by row, as bytes.
"""
import ctypes
import ctypes.util
from pathlib import Path

PNG_IMAGE_VERSION, PNG_FORMAT_RGB = 1, 2


class Image(ctypes.Structure):
    """png_image of png.h"""
    _fields_ = [("opaque", ctypes.c_void_p), *((name, ctypes.c_uint32) for name in (
        "version", "width", "height", "format", "flags", "colormap_entries", "warning_or_error")), ("message", ctypes.c_char * 64)]


def read(data, path=""):
    """(width, height), colours"""
    library = ctypes.CDLL(ctypes.util.find_library("png16") or "libpng16.so.16")
    image = Image(version=PNG_IMAGE_VERSION)
    good = library.png_image_begin_read_from_memory(ctypes.byref(image), data, ctypes.c_size_t(len(data)))
    image.format = PNG_FORMAT_RGB
    colours = ctypes.create_string_buffer(3 * image.width * image.height)
    good = good and library.png_image_finish_read(ctypes.byref(image), None, colours, 0, None)
    assert good, f"{path}: {image.message.decode()}"
    return (image.width, image.height), colours.raw


def decoded(data, path=""):
    return read(data, path)[1]


def pixels(path):
    return decoded(Path(path).read_bytes(), path)


def pixel(path, column, row):
    (width, _), colours = read(Path(path).read_bytes(), path)
    at = 3 * (row * width + column)
    return tuple(colours[at:at + 3])
