"""outputs.py - files of figures are what they should be.

outputs.py FOLDER NAME..., in FOLDER/NAME/
"""
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import png
from check import Checks, color, contrast, luminance
from figure import SVG

checks = Checks("outputs of figures")
folder, names = sys.argv[1], sys.argv[2:]
HEIGHT = 540
WIDTHS = {"": 960, "-4x3": 720}
LEGIBLE = 4.5


def extra(name):
    """The strip below a figure in which something is wrong; else nothing."""
    return float(ElementTree.parse(os.path.join(folder, name, name + ".svg")).getroot().get("height")) - HEIGHT


def svg(path, width, dark, words):
    root = ElementTree.parse(path).getroot()
    checks.that(f"{path}: is an image to who hears it", root.get("role") == "img")
    title, description = root.find(SVG + "title"), root.find(SVG + "desc")
    checks.that(f"{path}: has a title and a description, those of the words",
                title is not None and description is not None
                and [title.text, description.text] == words, f"expected {words}")
    checks.that(f"{path}: which are its name",
                (root.get("aria-labelledby") or "").split() == [e.get("id") for e in (title, description)])
    checks.that(f"{path}: is as wide as its shape", float(root.get("width")) == width)
    ground = color(next(root.iter(SVG + "rect")).get("fill"))
    checks.that(f"{path}: has the ground of its theme", (luminance(ground) < 0.1) == dark)
    for group in root.iter(SVG + "g"):
        for text in group.findall(SVG + "text"):
            ink = color(group.get("fill")) if group.get("fill") else [0, 0, 0]
            said = "".join(text.itertext()).strip()
            # On something that is drawn, a label may have the ink for that.
            if said and contrast(ink, ground) < LEGIBLE:
                checks.that(f"{path}: {said!r} can be read", ink in ([0, 0, 0], [255, 255, 255]),
                            f"{contrast(ink, ground):.2f} of {LEGIBLE}")


def png_file(path, width, height):
    shape, _ = png.read(Path(path).read_bytes(), path)
    checks.that(f"{path}: is {width} x {height}", shape == (width, height), str(shape))


def pdf(path, width, height):
    with open(path, "rb") as file:
        data = file.read()
    checks.that(f"{path}: is a PDF", data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"))
    checks.that(f"{path}: has no date of today", re.search(rb"CreationDate \(D:(?!19700101)", data) is None)
    if shutil.which("pdfinfo"):
        said = subprocess.run(["pdfinfo", path], capture_output=True, text=True, check=False)
        checks.that(f"{path}: is read without a complaint", said.returncode == 0 and not said.stderr, said.stderr)
        size = re.search(r"^Page size: *([\d.]+) x ([\d.]+)", said.stdout, re.M)
        inches = (width / 60 / 2.54, height / 60 / 2.54)
        checks.that(f"{path}: has its size", all(abs(float(size[i + 1]) / 72 - inches[i]) < 0.01 for i in range(2)), size[0])
        if not path.endswith("-tex.pdf"):
            text = subprocess.run(["pdftotext", path, "-"], capture_output=True, text=True, check=False).stdout
            checks.that(f"{path}: has text", len(text.split()) > 0)


def tex(path):
    with open(path, encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("%")]
    graphics = re.search(r"\\includegraphics\[[^]]*\]\{([^}]*)\}", "".join(lines))[1]
    checks.that(f"{path}: its graphics are beside it", "/" not in graphics
                and os.path.exists(os.path.join(os.path.dirname(path), graphics + ".pdf")), graphics)
    checks.that(f"{path}: needs no letters that LaTeX lacks", "".join(lines).isascii())
    labels = re.findall(r"\\strut\{\}(.*?)\}\}%", "".join(lines))
    checks.that(f"{path}: has labels", len(labels) > 0)
    words = [re.sub(r"\$[^$]*\$|\\[a-z]+\{[^{}]*\}", " ", label) for label in labels]
    checks.that(f"{path}: numbers have the font of formulas", not re.search(r"\b\d", " ".join(words)), str(words))


for name in names:
    with open(os.path.join(folder, name, name + ".txt"), encoding="utf-8") as file:
        first, _, rest = file.read().partition("\n")
    words = [first, " ".join(rest.split("\n")).strip()]
    checks.that(f"{name}: is described in words", len(first) > 10 and len(words[1]) > 40, str(words))
    checks.that(f"{name}: with minus signs", not re.search(r"(?<![\w-])-\d", words[1]), words[1])
    with open(os.path.join(folder, ".drawn", name + ".steps"), encoding="utf-8") as file:
        steps = int(file.read())
    below = extra(name)
    for shape, width in WIDTHS.items():
        for step in ["", *(f"-step{n}" for n in range(1, steps + 1))]:
            for theme in ("", "-dark"):
                path = os.path.join(folder, name, name + shape + step + theme)
                svg(path + ".svg", width, theme == "-dark", words)
                png_file(path + ".png", 2 * width, 2 * (HEIGHT + below))
                pdf(path + ".pdf", width, HEIGHT + below)
                pdf(path + "-tex.pdf", width, HEIGHT + below)
                tex(path + ".tex")
if not shutil.which("pdfinfo"):
    print("skipped: sizes and text of PDFs, which need poppler-utils ('make setup FOR=contributor' installs it)")
checks.end()
