"""check.py - the checks of figures: how they are counted, and what holds for every figure."""
import math
import re
import sys

from figure import NUMBER, SVG, Figure, numbers

SHAPES = ("4:3", "16:9")
NEAR = 0.1  # canvas units, that is, pixels of the SVG
SHRUNK = 1.0  # a label may be touched by this much
ON = 1.5  # so near to a mark, a place is on it
HEAD = 9  # so near to one, it is on a mark that is all arrowhead
LEADER_GAP = 8  # so near to its label, a leader begins
TITLE = 76  # the upper edge of the canvas, for a slide's title
EDGE = 0.5  # so near to the canvas' edge, gnuplot has cut a line off


def linear(color):
    """Of red, green and blue from 0 to 255, as much light as they are, from 0 to 1."""
    return [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in (c / 255 for c in color)]


def luminance(color):
    """Relative luminance, as WCAG 2 defines it."""
    red, green, blue = linear(color)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(a, b):
    dark, light = sorted((luminance(a), luminance(b)))
    return (light + 0.05) / (dark + 0.05)


def color(text):
    """#rrggbb, or rgb(r, g, b)"""
    if text.startswith("#"):
        return [int(text[i:i + 2], 16) for i in (1, 3, 5)]
    return [int(n) for n in re.findall(r"\d+", text)]


class Checks:
    """Counts; the last line is that of every test of the toolkit."""

    def __init__(self, name):
        self.name, self.passed, self.failed = name, 0, 0

    def that(self, what, holds, words=""):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"not ok: {what}" + (f"\n    {words}" if words else ""))

    def near(self, what, got, wanted, within=NEAR):
        """A mark, or a list of marks, is where it belongs."""
        if wanted and isinstance(wanted[0], (int, float)):
            got, wanted = got[:1], [wanted]
        away = [max(abs(a - b) for a, b in zip(g, w)) for g, w in zip(got, wanted)]
        self.that(what, len(got) == len(wanted) and all(d <= within for d in away),
                  f"drawn at {got}, expected {wanted}")

    def same(self, what, got, wanted, within=1e-5):
        """Numbers of the data are these."""
        flat = [x for row in got for x in row] if got and isinstance(got[0], list) else list(got)
        goal = [x for row in wanted for x in row] if isinstance(wanted[0], (list, tuple)) else list(wanted)
        close = len(flat) == len(goal) and all(
            abs(a - b) <= within * max(1, abs(b)) for a, b in zip(flat, goal))
        self.that(what, close, f"data {flat}, expected {goal}")

    def shows(self, figure, *texts):
        """Labels say this, however many spaces they have."""
        labels = [" ".join(words.split()) for words, _, _ in figure.labels()]
        for text in texts:
            self.that(f"a label says {text!r}", text in labels, str(labels))

    def stroke(self, figure, title, start, end):
        """A single line from here to there; too short to see, it may be missing."""
        if max(abs(a - b) for a, b in zip(start, end)) > NEAR:
            self.near(title, figure.line(title), [start, end])

    def end(self):
        print(f"{self.name}: {self.passed} passed, {self.failed} failed")
        sys.exit(1 if self.failed else 0)


def steps_only_add(checks, program, name, steps, *options):
    """Each step draws all that the one before drew, at the same place."""
    before = None
    for step in range(1, steps + 1):
        figure = Figure(program, name, *options, settings=f"step={step}")
        marks = {(title, tuple(shape.get(key) or "" for key in ("points", "d", "transform", "href")))
                 for title, groups in figure.plots.items() for group in groups
                 for shape in group.iter() if not shape.tag.endswith("title")}
        labels = {label for label in figure.labels() if label[0]}  # an empty one shows nothing
        if before is not None:
            checks.that(f"{name}: step {step} keeps what step {step - 1} shows",
                        before[0] <= marks and before[1] <= labels, str(before[1] - labels))
            checks.that(f"{name}: step {step} adds something", before != (marks, labels))
        before = (marks, labels)


def texts_off(figure):
    """Text that is cut off, as wide as it may be."""
    for text in (text for text in figure.texts() if text.words):
        left, low, right, high = text.box
        if left < 0 or low < -figure.strip or right > figure.width or high > figure.height:
            yield f"{text.words!r} leaves the canvas"


def on_the_canvas(checks, name, figure):
    found = list(texts_off(figure))
    checks.that(f"{name}: all text is on the canvas", not found, "\n    ".join(found))


AXES = ("t", "label of ticks", "columns", "rows", "numbers")  # titles of the plots that write numbers along one


def is_a_scale(texts):
    """The numbers along an axis: bare, and three or more."""
    return texts[0].title in AXES or \
        len(texts) >= 3 and all(re.fullmatch(NUMBER, text.words) for text in texts)


def told_in_words(checks, name, figure):
    """The words of the figure name the numbers that it shows."""
    title, description = figure.in_words()
    checks.that(f"{name}: it has a title", title != "")
    checks.that(f"{name}: it has words", len(description) > len(title), description)
    checks.that(f"{name}: its words have no NaN and no infinity",
                not re.search(r"\bnan\b|\binf|not answered", title + description, re.I), description)
    told = set(re.findall(NUMBER, description))
    plots = {}
    for text in figure.texts():
        plots.setdefault(text.title or text.words, []).append(text)
        checks.that(f"{name}: {text.words!r} has no hyphen for a minus",
                    not re.search(r"(?<!\w)-\s?\d", text.words))
    for texts in plots.values():
        for text in [] if is_a_scale(texts) else texts:
            checks.that(f"{name}: {text.words!r} is also in its words", told.issuperset(text.numbers()),
                        f"its numbers are {text.numbers()}, those in words {sorted(told)}")


# ---- labels that collide: with lines, with each other, with the canvas' edge -------------------------

def is_placed(figure):
    return "text_size" in figure.variables


# ---- geometry: boxes are (left, bottom, right, top), lines are two places ---------------------------

def shrunk(box, by=SHRUNK):
    return box[0] + by, box[1] + by, box[2] - by, box[3] - by


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def part_inside(box, line):
    """The part of the line that is in the box, from 0 to 1; None if there is none."""
    first, last = 0.0, 1.0
    for start, end, low, high in ((line[0][i], line[1][i], box[i], box[i + 2]) for i in range(2)):
        if start == end:
            if not low < start < high:
                return None
            continue
        a, b = (low - start) / (end - start), (high - start) / (end - start)
        first, last = max(first, min(a, b)), min(last, max(a, b))
    return (first, last) if first < last else None


def crosses(box, line):
    (a, b), (c, d) = line
    if (a <= box[0] and c <= box[0]) or (a >= box[2] and c >= box[2]) or \
            (b <= box[1] and d <= box[1]) or (b >= box[3] and d >= box[3]):
        return False
    return part_inside(box, line) is not None


def to_line(place, line):
    """How far a place is from a line."""
    (a, b), (c, d) = line
    u, v = c - a, d - b
    long2 = u * u + v * v
    part = min(1, max(0, ((place[0] - a) * u + (place[1] - b) * v) / long2)) if long2 > 0 else 0
    return math.hypot(place[0] - a - part * u, place[1] - b - part * v)


def to_box(place, box):
    return math.hypot(max(box[0] - place[0], 0, place[0] - box[2]), max(box[1] - place[1], 0, place[1] - box[3]))


def between(box, line):
    """How far a box is from a line, which may be a single place."""
    if line[0] != line[1] and crosses(box, line):
        return 0.0
    corners = [(x, y) for x in box[::2] for y in box[1::2]]
    return min([to_box(end, box) for end in line] + [to_line(corner, line) for corner in corners])


# ---- what the SVG shows -----------------------------------------------------------------------------

class Marks:
    """All that is drawn: lines as two places each, dots as (place, radius); with the titles of their plots."""

    def __init__(self, figure):
        self.lines, self.dots, self.leaders = [], [], []
        for element in figure.svg:
            if not element.tag.endswith("defs"):
                self.read(figure, element, "")

    def read(self, figure, element, title):
        named = element.find(SVG + "title")
        title = named.text if named is not None and element.tag == SVG + "g" else title
        before = len(self.lines)
        if element.tag == SVG + "path":
            self.read_path(figure, element.get("d"), title)
        elif element.tag == SVG + "use":
            x, y, *size = numbers(element.get("transform") or "0 0")
            self.dots.append((figure.up(x, y), size[0] if size else 1, title))
        for child in element:
            if not child.tag.endswith("defs"):
                self.read(figure, child, title)
        if named is not None and title == "leader":
            self.leaders.append([line for line, _ in self.lines[before:]])

    def read_path(self, figure, path, title):
        for stroke in (path or "").split("M")[1:]:
            flat = numbers(stroke)
            places = [figure.up(x, y) for x, y in zip(flat[::2], flat[1::2])]
            if "Z" in stroke and places:
                places.append(places[0])
            self.lines += [(pair, title) for pair in zip(places, places[1:])]

    def has(self, place):
        return any(to_line(place, line) <= HEAD for line, _ in self.lines) or \
            any(math.dist(place, dot) <= max(radius, ON) for dot, radius, _ in self.dots)


class Label:
    """The lines of text that name one place, and the leader from there."""

    def __init__(self, name, anchor):
        self.name, self.anchor, self.texts, self.leader = name, anchor, [], []

    def words(self):
        return " / ".join(text.words for text in self.texts)

    def box(self):
        """Of all its lines together."""
        left, low, right, high = zip(*(text.box for text in self.texts))
        return min(left), min(low), max(right), max(high)

    def to(self, anchor):
        return max(0, between(self.box(), anchor[:2]) - anchor[2])

    def touches(self, anchor):
        """It names a single place, which is on what another label names."""
        return self.anchor[0] == self.anchor[1] and to_line(self.anchor[0], anchor[:2]) < ON + anchor[2]


def anchors_of(figure):
    """Number of a label's line: the stretch that it names, and the radius of the disc around it."""
    found = {}
    for number, line in enumerate(re.findall(r"^labels = labels\.'(.*)$", figure.placed(), re.M), 1):
        named = re.search(r"' # names (.*)", line)
        if named:
            u, v, to_u, to_v, radius = map(float, named.group(1).split())
            found[number] = ((u, v), (to_u, to_v), radius)
    return found


def labels_of(figure, texts, marks):
    """All labels that are shown. plot.gp draws a plot for each leader, and then one for each line of text."""
    groups = [group for title in figure.plots if title.startswith("label of ") for group in figure.plots[title]]
    groups.sort(key=lambda group: int(group.get("id").rsplit("_", 1)[1]))
    anchors = anchors_of(figure)
    led = dict(zip(map(int, re.findall(r"' # of label (.*)", figure.placed())), marks.leaders))
    by_group = {}
    for text in texts:
        if text.words and text.plot is not None:
            by_group.setdefault(text.plot, []).append(text)
    labels = []
    for i, group in enumerate(groups, 1):
        anchor, name = anchors.get(i), group.find(SVG + "title").text.removeprefix("label of ")
        if not labels or (labels[-1].name, labels[-1].anchor) != (name, anchor):
            labels.append(Label(name, anchor))
        labels[-1].leader += led.get(i, [])
        labels[-1].texts += by_group.get(group, [])
    return [label for label in labels if label.texts]


# ---- what must not be ---------------------------------------------------------------------------------

def overlapping(texts):
    for i, text in enumerate(texts):
        for other in texts[i + 1:]:
            if overlap(shrunk(text.box), shrunk(other.box)):
                yield f"{text.words!r} and {other.words!r} overlap"


def crossed(texts, marks):
    for text in texts:
        box = shrunk(text.box)
        titles = {title for line, title in marks.lines if crosses(box, line)} | \
            {title for dot, radius, title in marks.dots if to_box(dot, box) < radius}
        for title in sorted(titles):
            yield f"{title!r} crosses {text.words!r}"


def in_the_title(figure, texts, marks):
    """The upper edge of the canvas is free, for a slide's title."""
    low = figure.height - TITLE
    for text in texts:
        if text.box[3] > low + SHRUNK:
            yield f"{text.words!r} is in the title"
    for title in sorted({title for line, title in marks.lines for x, y in line if title and
                         y > low + ON and -EDGE < x < figure.width + EDGE}):
        yield f"{title!r} is in the title"


def lines_off(figure, marks):
    for title in sorted({title for line, title in marks.lines for x, y in line if title and (
            not EDGE < x < figure.width - EDGE or not EDGE < y < figure.height - EDGE)}):
        yield f"{title!r} leaves the canvas"


def misplaced(labels, marks):
    """Nearer to what another label names; or far from what it names, without a leader from there to it."""
    for label in labels:
        if label.anchor is None:
            continue
        if not any(marks.has(end) for end in label.anchor[:2]) and label.name:
            yield f"nothing is drawn where {label.words()!r} points"
        for start, end in label.leader:  # two, if two labels name the same place
            if to_line(end, label.anchor[:2]) > ON + label.anchor[2] or to_box(start, label.box()) > LEADER_GAP:
                yield f"the leader of {label.words()!r} does not lead to what it names"
        if label.leader:
            continue
        own = label.to(label.anchor)
        for other in labels:
            if other is not label and other.anchor is not None and other.anchor != label.anchor and \
                    not label.touches(other.anchor) and label.to(other.anchor) < own - 0.1:
                yield f"{label.words()!r} is nearer to what {other.words()!r} names"


def collisions(figure):
    """All of them, in words."""
    texts = [text for text in figure.texts() if text.words]
    marks = Marks(figure)
    labels = labels_of(figure, texts, marks)
    return [*overlapping(texts), *crossed(texts, marks), *texts_off(figure), *lines_off(figure, marks),
            *in_the_title(figure, texts, marks), *misplaced(labels, marks)]


# ---- every figure -----------------------------------------------------------------------------------

def nothing_collides(checks, name, figure):
    if is_placed(figure):
        found = collisions(figure)
        checks.that(f"{name}: no label collides", not found, "\n    ".join(found))


def labels_are_clear(checks, program, name, options):
    for shape in SHAPES:
        nothing_collides(checks, f"{name}, {shape}, {' '.join(map(str, options))}",
                         Figure(program, name, *options, settings=f"shape='{shape}'"))


def drawn(checks, program, name, options, shape, crowded=False):
    """A figure in this shape: nothing is cut off or, if it is not crowded, collides; its words name its numbers."""
    figure = Figure(program, name, *options, settings=f"shape='{shape}'")
    said = f"{name}, {shape}, {' '.join(map(str, options))}"
    checks.that(f"{said}: there is text", len(figure.labels()) > 0)
    for holds in (on_the_canvas, told_in_words, *([] if crowded else [nothing_collides])):
        holds(checks, said, figure)
    return figure


def holds_for_every(checks, program, name, *options, crowded=False):
    """Everything that each figure needs, in both shapes."""
    for shape in SHAPES:
        figure = drawn(checks, program, name, options, shape, crowded)
    steps_only_add(checks, program, name, int(figure.variables.get("steps", "1")), *options)
