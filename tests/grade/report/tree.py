"""tree.py - pages as trees: text that goes in is text that comes out, whatever it says.

Trees are xml.etree's and are written by its HTML writer, which escapes all text and attributes; no
page is ever put together from strings.
"""
import base64
import os
import pathlib
import stat
import xml.etree.ElementTree as ElementTree
from urllib.parse import quote

from .points import UNSAFE, any_unsafe

POLICY = "default-src 'none'; img-src data: 'self'; style-src 'unsafe-inline'"
STYLE = pathlib.Path(__file__).with_name("report.css").read_text(encoding="utf-8")
INLINE = {"a", "abbr", "b", "bdi", "code", "span", "strong", "text"}
LARGEST_PICTURE = 4_000_000  # bytes; a page should open on a telephone


def tag(name: str, /, *children, **attributes) -> ElementTree.Element:
    """tag('a', 'words', href='...'): class_ is class, aria_label aria-label; None is left out."""
    element = ElementTree.Element(
        name,
        {
            key.rstrip("_").replace("_", "-"): str(value)
            for key, value in attributes.items()
            if value is not None
        },
    )
    last = None
    for child in children:
        if child is None:
            continue
        if isinstance(child, str):
            if last is None:
                element.text = (element.text or "") + child
            else:
                last.tail = (last.tail or "") + child
        else:
            element.append(child)
            last = child
            if child.tag not in INLINE:
                child.tail = "\n"
    return element


def page(title: str, *body) -> str:
    root = tag(
        "html",
        tag(
            "head",
            tag("meta", charset="utf-8"),
            tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
            tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
            tag("meta", name="color-scheme", content="light dark"),
            tag("meta", name="robots", content="noindex"),
            tag("title", title),
            tag("style", STYLE),
        ),
        tag("body", *body),
        lang="en",
    )
    return "<!DOCTYPE html>\n" + ElementTree.tostring(root, "unicode", method="html") + "\n"


def banner(records: list):
    """None where all were graded in a sandbox."""
    if not any_unsafe(records):
        return None
    return tag("p", tag("strong", UNSAFE), class_="unsafe", role="alert")


def address(*parts: str) -> str:
    """A relative URL of files beside the page; the names in it mean nothing but themselves."""
    return "./" + "/".join(quote(os.fsencode(part), safe="") for part in parts)


def read_picture(folder: str, name: str):
    """The bytes of a PNG that lies in the folder as an ordinary file; else None."""
    if not name or name != os.path.basename(name):
        return None
    try:
        handle = os.open(os.path.join(folder, name), os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except (OSError, ValueError):
        return None
    with open(handle, "rb") as file:
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            return None
        data = file.read(LARGEST_PICTURE + 1)
    return data if data.startswith(b"\x89PNG\r\n\x1a\n") and len(data) <= LARGEST_PICTURE else None


def data_url(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode("ascii")
