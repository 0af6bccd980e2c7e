"""figure.py - one figure as a test sees it: its script's data, and the marks in its SVG.

Marks are found by the title of the plot that drew them (title "eye" in the layout), on the canvas:
960 by 540 units, x to the right, y up. Their right places are computed here again, from the
numbers of the test, by its own formulas.
"""
import functools
import math
import os
import re
import shlex
import struct
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

from shown import NUMBER

SVG = "{http://www.w3.org/2000/svg}"
XLINK = "{http://www.w3.org/1999/xlink}"
LETTER = r"[^\W\d_⁰¹²³⁴⁵⁶⁷⁸⁹]"
PROGRAMS = os.environ.get("PROGRAMS", "build/solutions")


def numbers(text):
    return [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", text)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b, factor=1):
    return tuple(x + factor * y for x, y in zip(a, b))


def times(factor, a):
    return tuple(factor * x for x in a)


def length(v):
    return math.sqrt(dot(v, v))


def unit(v):
    return times(1 / length(v), v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def widths_of_letters(path):
    """How wide each character is, in its size: read from the font itself (cmap of format 12, hmtx)."""
    with open(path, "rb") as file:
        font = file.read()
    tables = {}
    for i in range(struct.unpack_from(">H", font, 4)[0]):
        tag, _, offset, _ = struct.unpack_from(">4sLLL", font, 12 + 16 * i)
        tables[tag.decode()] = offset
    em = struct.unpack_from(">H", font, tables["head"] + 18)[0]
    glyphs = struct.unpack_from(">H", font, tables["hhea"] + 34)[0]
    widths = {}
    for i in range(struct.unpack_from(">H", font, tables["cmap"] + 2)[0]):
        map_at = tables["cmap"] + struct.unpack_from(">L", font, tables["cmap"] + 8 + 8 * i)[0]
        if struct.unpack_from(">H", font, map_at)[0] != 12:
            continue
        for k in range(struct.unpack_from(">L", font, map_at + 12)[0]):
            first, last, glyph = struct.unpack_from(">LLL", font, map_at + 16 + 12 * k)
            for code in range(first, last + 1):
                at = min(glyph + code - first, glyphs - 1)
                widths[chr(code)] = struct.unpack_from(">H", font, tables["hmtx"] + 4 * at)[0] / em
    return widths


FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
WIDTHS = widths_of_letters(FONT) if os.path.exists(FONT) else {}


class Text:
    """One line of text on the canvas, and the box that it takes there."""

    EM = 0.6  # a character's mean width, in its size, where the font is not there

    def __init__(self, figure, group, text, title, plot):
        self.title, self.plot = title, plot  # of the plot that drew it; None where none did
        self.words = "".join(text.itertext()).strip()
        move = re.match(r"translate\(([^,]*),([^)]*)\)", group.get("transform"))
        self.x, self.y = figure.up(float(move[1]), float(move[2]))
        self.color = group.get("fill")
        size = float(group.get("font-size"))
        # On the line, that is, neither index nor exponent: those are names and formulas.
        self.plain, long, raised = "", 0.0, 0.0
        for span in text.iter():
            raised += float((span.get("dy") or "0").replace("px", ""))
            self.plain += (span.text or "") if abs(raised) < 0.01 else " "
            long += float(span.get("font-size") or size) * sum(WIDTHS.get(c, self.EM) for c in span.text or "")
        left = {"start": 0, "middle": -long / 2, "end": -long}[group.get("text-anchor") or "start"]
        flat = (left, -0.25 * size, left + long, 0.8 * size)
        if "rotate" in group.get("transform"):
            flat = (-flat[3], flat[0], -flat[1], flat[2])
        self.box = (self.x + flat[0], self.y + flat[1], self.x + flat[2], self.y + flat[3])

    def numbers(self):
        """The numbers that it shows, as it shows them; not those of formulas: w/2, 2 d, ½, 1/2."""
        data = re.sub(rf"{LETTER}\s?/\s?\d+|\)\s?/\s?\d+|\b1/2\b", " ", self.plain)
        data = re.sub(rf"(?<![\d,.])\d+(?:\.\d+)?\s?(?={LETTER}(?!{LETTER}))", " ", data)
        data = re.sub(rf"\b\d+(?={LETTER}{{2}}(?!\w))", " ", data)  # 4ac
        return re.findall(NUMBER, data)


@functools.lru_cache(maxsize=4)
def script_of(_, program, name, *options):
    """A figure's script, for one drawing after another of the same files."""
    command = [os.path.join(PROGRAMS, program), "--figure", name, *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"{shlex.join(command)}: {done.stderr.strip()}")
    return done.stdout


@functools.lru_cache(maxsize=8)
def drawn(script, settings, kind):
    """The file that gnuplot draws. One test after another looks at the same figure: it is drawn once for them."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figure.gp")
        with open(path, "w", encoding="utf-8") as file:
            file.write(script)
        done = subprocess.run(["gnuplot", "-e", f"output='figure'; {settings}", path], cwd=folder,
                              capture_output=True, text=True, check=False, timeout=60)
        if done.returncode != 0 or done.stderr:
            raise AssertionError(f"gnuplot, {path}: {done.stderr.strip()}")
        with open(os.path.join(folder, f"figure.{kind}"), "rb") as file:
            return file.read()


class Figure:
    """A figure by a chapter's program, or by a script that is there, drawn by gnuplot as SVG."""

    def __init__(self, program, name, *options, settings="", script=None):
        self.script = script if script is not None else self.made(program, name, *map(str, options))
        self.variables = dict(re.findall(r"^(\w+) = (.*)$", self.script, re.M))
        self.svg = ElementTree.fromstring(drawn(self.script, settings.replace("shape='16:9'", ""), "svg"))
        _, _, self.width, tall = map(float, self.svg.get("viewBox").split())
        if self.width != (720 if "4:3" in settings else 960):
            raise AssertionError(f"{name}, {settings}: the canvas is {self.width:.0f} wide")
        self.height = 540.0
        self.strip = tall - self.height  # of words on what is wrong, below the canvas
        self.plots = {}
        for group in self.svg.iter(SVG + "g"):
            title = group.find(SVG + "title")
            if title is not None:
                self.plots.setdefault(title.text, []).append(group)

    @staticmethod
    def made(program, name, *options):
        files = [os.path.join(PROGRAMS, program), *(option for option in options if os.path.exists(option))]
        return script_of(tuple(os.stat(file).st_mtime_ns for file in files), program, name, *options)

    # ---- the data -----------------------------------------------------------------------------

    def number(self, name):
        return float(self.variables[name])

    def placed(self):
        """What C has placed on this canvas (common/figure/plot_view.c)."""
        which = "eq" if self.width == 720 else "ne"
        return "\n".join(re.findall(rf'^if \(shape {which} "4:3"\) (.*)', self.script, re.M))

    def chosen(self, name):
        """A number of that."""
        return float(re.search(rf"^{re.escape(name)} = (.*)", self.placed(), re.M).group(1))

    def text(self, name):
        return self.variables[name].strip('"')

    def block(self, name, index=0):
        """The rows of a data block, as lists of numbers; empty lines are left out."""
        body = re.search(r"^\$" + re.escape(name) + r" << EOD\n(.*?)^EOD$", self.script, re.M | re.S)
        if body is None:
            raise AssertionError(f"no block ${name} in the script")
        parts = re.split(r"\n\n\n", body.group(1))
        rows = [line for line in parts[index].splitlines()
                if line and not line.startswith("#") and not line.startswith(("1e9 ", "1000000000 "))]  # nowhere
        return [[float(word) for word in re.sub(r'"[^"]*"', "nan", row).split()] for row in rows]

    # ---- the marks ----------------------------------------------------------------------------

    def up(self, x, y):
        return (x, self.height - y)

    def groups(self, title):
        if title not in self.plots:
            raise AssertionError(f"nothing is titled {title!r}; there are {sorted(self.plots)}")
        return self.plots[title]

    def dots(self, title):
        """The middles of the points."""
        return [self.up(*numbers(use.get("transform"))[:2])
                for group in self.groups(title) for use in group.iter(SVG + "use")]

    def tips(self, title):
        """The tips of the arrows."""
        found = []
        for group in self.groups(title):
            for head in group.iter(SVG + "polygon"):
                flat = numbers(head.get("points"))
                found.append(self.up(flat[4], flat[5]))
        return found

    def ends(self, title):
        """The start and the end of the first arrow or line."""
        stroke, tips = self.strokes(title)[0], self.tips(title)
        return tips[::-1] if len(tips) == 2 else [stroke[0], *(tips or stroke[-1:])]

    def lines(self, title):
        """The places on lines, one list a path."""
        found = []
        for group in self.groups(title):
            for path in group.iter(SVG + "path"):
                flat = numbers(path.get("d"))
                found.append([self.up(x, y) for x, y in zip(flat[::2], flat[1::2])])
        return found

    def line(self, title):
        """The places on the first line; none where a wrong answer left nothing to draw."""
        found = self.lines(title)
        return found[0] if found else []

    def strokes(self, title):
        """The same, one list a stroke, and without the outlines of arrowheads."""
        found = []
        for group in self.groups(title):
            for path in group.iter(SVG + "path"):
                for stroke in path.get("d").split("M")[1:]:
                    flat = numbers(stroke)
                    if "Z" not in stroke:
                        found.append([self.up(x, y) for x, y in zip(flat[::2], flat[1::2])])
        return found

    def circles(self, title):
        """Middle and radius of what is drawn as a circle: an outline of many places."""
        found = []
        for line in self.lines(title):
            left, right = min(x for x, _ in line), max(x for x, _ in line)
            low, high = min(y for _, y in line), max(y for _, y in line)
            found.append(((left + right) / 2, (low + high) / 2, (right - left + high - low) / 4))
        return found

    def polygons(self, title):
        """The corners of what is filled."""
        found = []
        for group in self.groups(title):
            for shape in group.iter(SVG + "polygon"):
                flat = numbers(shape.get("points"))
                found.append([self.up(x, y) for x, y in zip(flat[::2], flat[1::2])])
        return found

    def texts(self):
        """All text, with what is needed to say how much of the canvas it takes."""
        drawn_by = {text: (title, plot) for title, plots in self.plots.items() for plot in plots
                    for text in plot.iter(SVG + "text")}
        return [Text(self, group, text, *drawn_by.get(text, (None, None))) for group in self.svg.iter(SVG + "g")
                for text in group.findall(SVG + "text")
                if (group.get("transform") or "").startswith("translate")]

    def labels(self):
        """All text with the place of its anchor: (text, x, y)."""
        return [(text.words, text.x, text.y) for text in self.texts()]

    def in_words(self):
        """Its title, and itself in words: what the script says where no picture is wanted."""
        title, _, description = drawn(self.script, "format='txt'", "txt").decode("utf-8").partition("\n\n")
        return title.strip(), description.strip()

    # ---- where a place of the world belongs ---------------------------------------------------

    def see(self, right, up, forward, azimuth=28, elevation=16):
        """Looks from the right side of a frame; how large, and where, C has chosen (common/figure/plot_view.c)."""
        a, e = math.radians(azimuth), math.radians(elevation)
        side = plus(times(math.cos(a), right), forward, -math.sin(a))
        self.axes = (plus(times(math.cos(a), forward), right, math.sin(a)),
                     plus(times(math.cos(e), up), side, -math.sin(e)),
                     plus(times(math.sin(e), up), side, math.cos(e)))
        self.scale = self.chosen("size[1]")
        self.zero = (self.chosen("zero_x[1]"), self.chosen("zero_y[1]"))

    def see_flat(self, panel=1):
        """Where x, y of a panel of a flat figure belong."""
        size, x0, y0 = (self.chosen(f"{name}[{panel}]") for name in ("size", "zero_x", "zero_y"))
        return lambda x, y: (x0 + size * x, y0 + size * y)

    def place(self, point):
        return tuple(self.zero[i] + self.scale * dot(point, self.axes[i]) for i in range(2))
