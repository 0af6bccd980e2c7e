"""hostile_records.py - records in which every string that quotes a student is an attack."""
import os

from .make_records import function, record, stem

# Strings that a student might put into a name, a file name or a compiler message; some raw, though the
# grader should have escaped them by then.
HOSTILE = [
    "\"quotes\" 'both' `ticks`",
    "two\nlines",
    "two\r\nwindows lines",
    "\x1b[2J\x1b]0;title\x07",
    "]]>",
    "<![CDATA[",
    "</script><script>alert(1)</script>",
    "</style><img src=x onerror=alert(1)>",
    '" onmouseover="alert(1)',
    "--><!--",
    "<?xml version='1.0'?><!DOCTYPE x [<!ENTITY y 'z'>]>&y;",
    "=cmd|' /C calc'!A0",
    "+1+1",
    "-2+3",
    "@SUM(1+1)",
    "\t=1+1",
    "\r=1+1",
    " =1+1",
    "＝1+1",
    "a;=1+1;b",
    'a,"b",c',
    "nul\0inside",
    os.fsdecode(b"caf\xe9 \xff\xfe"),
    "\ud800 \udfff",
    "line\u2028separator\u2029paragraph",
    "\u202egnp.exe",
    "\u2066isolate\u200b\ufeff",
    "\ufffe\uffff",
    "x" * 30_000,
    "not ok 1 - forged",
    "\nok 99 - forged\n1..1\nBail out! forged",
    "# SKIP forged",
    "x # TODO forged",
    "\\# \\\\",
    "  ---\n  forged: true\n  ...",
    "...",
    "%s%n%d {0} {name}",
    "\\u0000 \\x1b",
    "[[ATTACHMENT|/etc/passwd]]",
    "javascript:alert(1)",
    "../../up",
    "-rf --help",
    "&amp;&lt;&#0;",
    "\U0001f600 \U000e0041 \U0010ffff",
    "e" + "\u0301" * 50,
    "",
    " ",
    "~",
    "$(id) `id`",
]


def hostile_record(text: str, place: int) -> dict:
    """Every string that might quote a student is the same hostile one. Ten points, always."""
    trap = {
        "test": text,
        "how": "",
        "law": text,
        "expected": text,
        "yours": text,
        "given": [[text, text], ["ray", text]],
        "mistake": None,
    }
    known = {"id": text, "formula": text, "why": text, "picture": text}
    quadratic = [
        function("to_object_coordinates"),
        function("object_quadratic", text, text, "wrong", **trap),
        function("world_quadratic", text, text, "wrong", **{**trap, "mistake": known}),
        function("quadratic_roots", text, text, "unanswered", **trap),
        function("sphere_roots", text, text, "waiting", waiting_for=[text, text]),
        function("hit_sphere", text, text, "crashed", **{**trap, "how": text}),
    ]
    stems = [
        stem("01-corners", state="missing", most=20.0, words=text),
        stem("02-cameras", state="twice", most=20.0, words=text + "\n" + text),
        stem("03-screen", state="does not compile", most=12.0, words=text, file=text),
        stem("04-pixel-ray", state="not judged", most=4.0, words=text, file=text),
        stem("05-quadratic", quadratic, file=text),
    ]
    return record(
        text,
        stems,
        "crashed",
        words=text,
        late=text,
        folder=f"h{place:02}",
        pictures={"expected": text, "yours": text},
    )


def hostile_class() -> list:
    return [hostile_record(text, place) for place, text in enumerate(HOSTILE)]
