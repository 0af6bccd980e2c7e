"""make_records.py - records by hand, for the tests: a function, a stem, a submission, a picture.

Fields that are not given are those of a right submission.
"""
import struct
import zlib


def function(name, slide="", prompt="", state="right", most=4.0, **more) -> dict:
    return {
        "name": name,
        "slide": slide,
        "prompt": prompt,
        "state": state,
        "score": most if state in ("right", "waiting") else 0.0,
        "max": most,
        "test": "",
        "hidden": False,
        "given": [],
        "expected": "",
        "yours": "",
        "how": "",
        "waiting_for": [],
        "mistake": None,
        "partly": False,
        "law": "",
        **more,
    }


def stem(name, functions=(), state="judged", most=0.0, **more) -> dict:
    return {
        "stem": name,
        "file": name + ".c" if state not in ("missing", "twice") else "",
        "state": state,
        "words": "",
        "score": sum(one["score"] for one in functions),
        "max": most or sum(one["max"] for one in functions),
        "functions": list(functions),
        **more,
    }


def record(name, stems, status="graded", **more) -> dict:
    return {
        "submission": name,
        "folder": name,
        "status": status,
        "words": "",
        "score": sum(one["score"] for one in stems),
        "max": sum(one["max"] for one in stems),
        "late": "",
        "seed": 123456,
        "sandbox": "bubblewrap, Landlock, seccomp",
        "unsafe": False,
        "seconds": 0.41,
        "pictures": {},
        "stems": stems,
        **more,
    }


def png(columns, rows, shade) -> bytes:
    """A small picture: shade(x, y) gives three bytes, x and y from -1 to 1."""
    lines = b"".join(
        b"\0"
        + b"".join(
            bytes(shade(2 * (x + 0.5) / columns - 1, 2 * (y + 0.5) / rows - 1))
            for x in range(columns)
        )
        for y in range(rows)
    )

    def chunk(kind, data):
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(lines))
        + chunk(b"IEND", b"")
    )


def ball(radius: float) -> bytes:
    def shade(x, y):
        depth = radius * radius - x * x - y * y
        return (0, 0, 0) if depth < 0 else (int(250 * depth**0.5 / radius), int(120 * radius), 90)

    return png(96, 72, shade)
