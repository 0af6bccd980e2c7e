"""lesson_figures.py - the figures that the lessons show are those that the code draws.

  lesson_figures.py DRAWN CHAPTER...            says what differs; exit status 1 if anything does
  lesson_figures.py --write DRAWN CHAPTER...    writes it
  lesson_figures.py --in-steps CHAPTER...       names the figures of which lessons show a step
  lesson_figures.py --svg LIGHT.svg DARK.svg TITLE WORDS    prints one SVG for both themes

DRAWN/NAME/ has what 'make figures' made: NAME[-stepN][-dark].svg, and NAME.txt, the figure in words. A lesson shows
each layout CHAPTER/figures/NAME.gp, and some steps, by a line of its own, ![the words](NAME[-stepN].svg). That file is
one SVG for light and dark pages: it follows the reader's system by prefers-color-scheme.
"""
import os
import re
import sys
from glob import glob
from html import escape
from itertools import zip_longest
from xml.etree import ElementTree

# ---- one SVG for both themes ------------------------------------------------------------------------

SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"
SHAPES = ("rect", "path", "polygon", "use", "text", "image")
STYLE = """text { fill: currentColor; font: 24px "DejaVu Sans", Verdana, sans-serif; white-space: pre }
.math { font-family: "DejaVu Serif", Georgia, serif; font-style: italic }
.line { fill: none; stroke: currentColor }
.mark { fill: none }
.area { fill: currentColor; shape-rendering: crispEdges }"""


def color_names():
    """The colors of common/figure/plot.gp, by their light values."""
    with open(os.path.join(os.path.dirname(__file__), "../../common/figure/plot.gp"), encoding="utf-8") as file:
        return {light: name for name, light in re.findall(r'(\w+) = dark \? "#\w+" : "(#\w+)"', file.read())}


def hexadecimal(color):
    digits = re.fullmatch(r"rgb\( *(\d+), *(\d+), *(\d+)\)", color)
    return "#%02x%02x%02x" % tuple(map(int, digits.groups())) if digits else color.lower()


def shapes_of(root):
    """The shapes of a drawing, in order, each with the attributes that it has or inherits."""
    found = []

    def walk(element, inherited):
        tag = element.tag.removeprefix(SVG)
        if tag in ("defs", "title", "desc"):
            return
        attributes = {**inherited, **element.attrib}
        if tag in SHAPES:
            found.append((tag, attributes, element))
        elif tag in ("svg", "g"):
            for child in element:
                walk(child, {} if tag == "svg" else attributes)
        else:
            raise ValueError(f"unexpected element {tag}")

    walk(root, {})
    return found


def color_of(tag, attributes):
    """The one color of a shape; a picture has none."""
    if tag in ("rect", "polygon", "text"):
        return hexadecimal(attributes["fill"])
    if tag == "image":
        return None
    color = attributes["stroke"] if tag == "path" else "currentColor"
    return hexadecimal(attributes["color"] if color == "currentColor" else color)


def rounded(text):
    """Coordinates to a tenth of a pixel, which is as much as anybody sees."""
    return re.sub(r"-?\d+\.\d+", lambda number: f"{round(float(number[0]), 1) + 0:g}", text)


def path_of(d):
    """The lines of a path, without those that have no length: M1,2 3,4 5,6."""
    parts = []
    for part in rounded(d).replace("L", " ").split("M")[1:]:
        points = part.split()
        points = [point for before, point in zip([None, *points], points) if point != before]
        if len(points) > 1:
            parts.append("M" + " ".join(points))
    return " ".join(parts)


def content_of(text):
    """The words of a text, its mathematics in italics, its indices below and its exponents above."""
    parts = []
    for part in filter(lambda each: each.text, text):
        attributes = ' class="math"' if part.get("font-style") else ""
        if part.get("dy"):
            attributes += f' dy="{rounded(part.get("dy").removesuffix("px"))}"'
        words = escape(part.text, quote=False)
        parts.append(f"<tspan{attributes}>{words}</tspan>" if attributes else words)
    return "".join(parts)


def without_color(tag, attributes, element):
    """What is drawn, besides its color: the kind of line or area, attributes, and what is inside."""
    kind, shown, content = "", {}, ""
    if tag == "path":
        kind = "line"
        shown = {"stroke-width": f"{float(attributes['stroke-width']):g}",
                 "stroke-dasharray": attributes.get("stroke-dasharray"), "d": path_of(attributes["d"])}
    elif tag == "polygon":
        kind = "area"
        shown = {"fill-opacity": attributes.get("fill-opacity"), "points": " ".join(rounded(attributes["points"]).split())}
    elif tag == "rect":
        kind = "area"
        shown = {name: attributes[name] for name in ("width", "height")}
    elif tag == "use":
        kind = "mark"
        shown = {"href": attributes[HREF], **{name: rounded(attributes[name]) for name in ("x", "y") if name in attributes},
                 "transform": re.sub(r"translate\([^)]*\)", lambda moved: rounded(moved[0]), attributes.get("transform", ""))}
    elif tag == "image":
        shown = {**{name: rounded(attributes[name]) for name in ("x", "y", "width", "height")},
                 "preserveAspectRatio": "none", "href": attributes[HREF]}
    elif tag == "text":
        anchor = attributes["text-anchor"]
        shown = {"transform": rounded(attributes["transform"]), "text-anchor": anchor if anchor != "start" else None}
        content = content_of(element)
    return kind, {name: value for name, value in shown.items() if value}, content


def markers_of(root, used):
    """gnuplot's marks that the drawing uses, and those that they use."""
    marks = {mark.get("id"): mark for mark in root.iter() if mark.get("id", "").startswith("gp")}
    wanted = [name.removeprefix("#") for name in used]
    for name in wanted:
        wanted += [marks[name].get(HREF).removeprefix("#")] if marks[name].get(HREF) else []
    for name, mark in marks.items():
        if name in wanted:
            attributes = {key.replace(HREF, "href"): value for key, value in mark.attrib.items()}
            yield f"<{mark.tag.removeprefix(SVG)}{in_tag(attributes)}/>"


def in_tag(attributes):
    return "".join(f' {name}="{escape(value)}"' for name, value in attributes.items())


def svg_for_both(light, dark, title=None, words=None):
    """One SVG of a drawing in light and in dark colors: an element a line, its colors as classes."""
    root, dark_root = ElementTree.fromstring(light), ElementTree.fromstring(dark)
    names, classes, used, lines = color_names(), {}, [], []
    for shape, dark_shape in zip_longest(shapes_of(root), shapes_of(dark_root)):
        kind, attributes, content = without_color(*shape)
        if dark_shape is None or (kind, attributes, content) != without_color(*dark_shape):
            raise ValueError("light and dark differ in more than colors")
        if "d" not in attributes and shape[0] == "path":
            continue
        colors = color_of(*shape[:2]), color_of(*dark_shape[:2])
        if colors[0] is not None:
            name = "background" if shape[0] == "rect" else names.get(colors[0], "shade")
            taken = [each for pair, each in classes.items() if pair != colors]
            number = next(n for n in range(1, len(taken) + 2) if (name if n == 1 else f"{name}{n}") not in taken)
            name = classes.setdefault(colors, name if number == 1 else f"{name}{number}")
            attributes = {"class": f"{kind} {name}".strip(), **attributes}
        if shape[0] == "use" and attributes["href"] not in used:
            used.append(attributes["href"])
        tag = f"<{shape[0]}{in_tag(attributes)}"
        lines.append(f"{tag}>{content}</{shape[0]}>" if content else f"{tag}/>")
    return "\n".join((
        f'<svg xmlns="http://www.w3.org/2000/svg"{in_tag({name: root.get(name) for name in ("width", "height", "viewBox")})} '
        'role="img" aria-labelledby="title description" xml:space="preserve">',
        f'<title id="title">{escape(title or root.findtext(f"{SVG}title"), quote=False)}</title>',
        f'<desc id="description">{escape(words or root.findtext(f"{SVG}desc"), quote=False)}</desc>',
        "<style>", STYLE,
        *(f".{name} {{ color: {light} }}" for (light, _), name in classes.items()),
        "@media (prefers-color-scheme: dark) {",
        *(f".{name} {{ color: {dark} }}" for (light, dark), name in classes.items() if light != dark),
        "}", "</style>",
        *(("<defs>", *markers_of(root, used), "</defs>") if used else ()),
        *lines, "</svg>", ""))


# ---- the lessons --------------------------------------------------------------------------------------

SHOWN = re.compile(r"^!\[(.*)\]\(([a-z0-9-]+?(-step\d)?)\.svg\)$", re.MULTILINE)
REMEDY = "make lesson-figures"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    print(f"wrote {path}")


def sentences(words):
    return re.split(r"(?<=\.) ", words)


def line_of(name, words):
    """The line that shows a figure; what Markdown and GitHub's mathematics would read as theirs is escaped."""
    escaped = re.sub(r"[\\`*_\[\]<&$]", lambda found: "\\" + found[0], words)
    return f"![{escaped}]({name}.svg)"


class Chapter:
    """The figures of a chapter's lesson, and what differs from those that the code draws."""

    def __init__(self, folder):
        self.folder = folder
        self.lesson = read(f"{folder}/README.md")
        self.layouts = sorted(os.path.basename(path)[:-len(".gp")] for path in glob(f"{folder}/figures/*.gp"))
        self.differences = []

    def shown(self):
        """Each figure that the lesson shows: its words there, its name, the name of its layout."""
        for words, name, step in SHOWN.findall(self.lesson):
            layout = name.removesuffix(step)
            if layout in self.layouts:
                yield words, name, layout

    def compare(self, drawn, writing):
        """Compares, or writes what is right in the place of what is wrong."""
        right = self.lesson
        names = [name for _, name, _ in self.shown()]
        for shown, name, layout in self.shown():
            drawing = f"{drawn}/{layout}/{name}"
            words = " ".join(read(f"{drawn}/{layout}/{layout}.txt").split("\n")[1:]).strip()
            if name != layout:
                # A step has the first sentences of the figure's words, as many as the lesson has now: a question
                # must not have its answer beside it.
                words = " ".join(sentences(words)[:len(sentences(shown))])
            right = right.replace(f"![{shown}]({name}.svg)", line_of(name, words))
            self.compare_file(f"{name}.svg", svg_for_both(read(f"{drawing}.svg"), read(f"{drawing}-dark.svg")), writing)
            if right != self.lesson and not writing:
                self.differences.append(f"{self.folder}/README.md shows {name} with other words than the figure's: {REMEDY}")
                right = self.lesson
        for layout in self.layouts:
            if layout not in names:
                self.differences.append(f"{self.folder}/README.md does not show the figure {layout}. Add a line: ![]({layout}.svg)")
        for path in glob(f"{self.folder}/*.svg"):
            if f"]({os.path.basename(path)})" not in self.lesson:
                self.differences.append(f"{path}: the lesson does not show it")
        if writing and right != self.lesson:
            write(f"{self.folder}/README.md", right)

    def compare_file(self, name, right, writing):
        path = f"{self.folder}/{name}"
        old = read(path) if os.path.exists(path) else None
        if old == right:
            return
        if writing:
            write(path, right)
        else:
            self.differences.append(f"{path} {'is missing' if old is None else 'is not what the code draws'}: {REMEDY}")


def main(arguments):
    if arguments[0] == "--svg":
        light, dark, title, words = arguments[1:]
        print(svg_for_both(read(light), read(dark), title, words), end="")
        return 0
    if arguments[0] == "--in-steps":
        chapters = map(Chapter, arguments[1:])
        print(*sorted({layout for chapter in chapters for _, name, layout in chapter.shown() if name != layout}))
        return 0
    writing = arguments[0] == "--write"
    drawn, *chapters = map(str, arguments[writing:])
    chapters = [Chapter(folder) for folder in chapters]
    for chapter in chapters:
        chapter.compare(drawn, writing)
        for difference in chapter.differences:
            print(difference)
    return int(any(chapter.differences for chapter in chapters))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or sys.exit(__doc__)))
