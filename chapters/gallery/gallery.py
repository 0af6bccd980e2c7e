"""gallery.py - makes BUILT/gallery/index.html: every picture, figure and animation that is there.

    gallery.py BUILT SCENES-FOLDER

A page that needs no network and no script, in the order of the lecture: chapters/gallery/contents.txt. What is there
and not in that list comes after it. Each picture is also described in words: a figure by BUILT/figures/NAME/NAME.txt,
an animation by BUILT/animations/NAME/NAME.txt, a picture in the list or by the first comment of its scene.
"""
import html
import re
import shutil
import struct
import sys
from pathlib import Path

from jobs import is_newer

FORMATS = {"svg": "SVG", "pdf": "PDF", "png": "PNG", "tex": "TeX"}
VIDEOS = {"mp4": "MP4", "webm": "WebM", "gif": "GIF", "apng": "APNG"}
NARROW, DARK = "(max-width: 600px)", "(prefers-color-scheme: dark)"
# Of the deck's figures; a handout has them in build/.
LAYOUTS = sorted(path for folder in (Path(), Path("build")) for path in folder.glob("chapters/*/figures/*.gp"))


def escaped(text):
    return html.escape(text, quote=False).replace('"', "&quot;")


def href(name):
    """A link to a file whose name may have letters that mean something in a link."""
    return escaped(re.sub("[%#?]", lambda letter: f"%{ord(letter[0]):02X}", name))


def read_words(path):
    """Of a text: its first line, and all that follows in one line; nothing if it is not there."""
    if not path.is_file():
        return None
    title, _, words = path.read_text(encoding="utf-8").partition("\n")
    return title, " ".join(words.split())


def read_heading(path):
    """The text after '# ' in the first line of a file; "" if the line does not begin with it."""
    if not path.is_file():
        return ""
    with path.open(encoding="utf-8") as file:
        line = file.readline()
    return line[1:].strip() if line.startswith("#") else ""


def size(path):
    """The width and height of a PNG or an SVG, for HTML."""
    if path.suffix == ".png":
        found = struct.unpack(">II", path.read_bytes()[16:24])
    else:
        found = re.search(r'viewBox="0 0 (\d+) (\d+)', path.read_text(encoding="utf-8")).groups()
    return f'width="{found[0]}" height="{found[1]}"'


def link(to, label, title, variant):
    """The title and the variant are for those who hear only the link."""
    return (f'<li><a href="{href(to)}" download><span class="aloud">{escaped(title)}, {variant}, </span>'
            f"{label}</a></li>")


class Gallery:
    def __init__(self, built, scenes):
        self.built, self.scenes, self.answers = built, scenes, built.name
        self.shown = set()  # what is on the page already: ("figure", NAME), ("picture", NAME)
        self.sections = []  # headings, and the cards below them

    # ---- pictures ------------------------------------------------------------------------------

    def picture(self, file, title, words, is_copy=False):
        """A picture by its file's path from the page. A chart has text, which a narrow screen must not shrink."""
        chart = file.endswith(".svg")
        # A wrong answer draws another picture.
        by_reader = "" if is_copy or self.answers == "solutions" else \
            f"Drawn by the answers in {escaped(self.answers)}/. What it should show: "
        kind = "measured" if chart else "cast"
        # The caption's words are the picture's own: a screen reader must not read them twice.
        return f"""<figure{' class="chart"' if chart else ''}>
<a href="{href(file)}"><img src="{href(file)}" alt="{by_reader}{escaped(words)}" {size(self.built / "gallery" / file)} loading="lazy"></a>
<figcaption><h3>{escaped(title)}</h3>
<p class="words" aria-hidden="true">{escaped(words)}</p>
<dl><dt>{kind}</dt><dd><ul>{link(file, "SVG" if chart else "PNG", title, kind)}</ul></dd></dl>
</figcaption></figure>
"""

    def words_of_scene(self, name):
        """A scene's own words, from its first comment."""
        files = [*sorted(Path("chapters").glob(f"*/{name}.nff")), self.scenes / f"{name}.nff"]
        words = next(filter(None, map(read_heading, files)), f"The picture {name}.png, drawn from a scene.")
        return name, words

    def show_picture(self, name, title="", words=""):
        """A picture of the gallery by its name; with the words of the list, if it has any."""
        if ("picture", name) in self.shown:
            return ""
        self.shown.add(("picture", name))
        if not (self.built / "gallery" / f"{name}.png").exists():
            return ""
        if not title:
            title, words = self.words_of_scene(name)
        return self.picture(f"{name}.png", title, words)

    def show_copy(self, path, title, words):
        """A file of the tree, which the page must have beside it."""
        path = Path(path)
        copy = self.built / "gallery/copies" / path.name
        if not path.exists():
            return ""
        if not copy.exists() or is_newer(path, copy):
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(path, copy)
        return self.picture(f"copies/{path.name}", title, words, is_copy=True)

    # ---- figures -------------------------------------------------------------------------------

    def row(self, name, suffix, variant, title):
        """A row of links to all formats of one shape, step and theme; nothing if there is none. Figures of an older
        script are not linked."""
        links = ""
        for ending, label in FORMATS.items():
            file = f"figures/{name}/{name}{suffix}"
            if is_newer(self.built / f"{file}.{ending}", self.built / f"figures/.drawn/{name}.gp"):
                links += link(f"../{file}.{ending}", label, title, variant)
                if ending == "tex":
                    links += link(f"../{file}-tex.pdf", "its PDF", title, f"{variant}, TeX")
        return f"<dt>{variant}</dt><dd><ul>{links}</ul></dd>" if links else ""

    def more_rows(self, name, title):
        steps = self.built / f"figures/.drawn/{name}.steps"
        count = int(steps.read_text(encoding="utf-8")) if steps.exists() else 0
        rows = self.row(name, "-4x3", "4:3", title) + self.row(name, "-4x3-dark", "4:3, dark", title)
        for suffix, shape in (("", ""), ("-4x3", ", 4:3")):
            for step in range(1, count + 1):
                for theme, dark in (("", ""), ("-dark", ", dark")):
                    rows += self.row(name, f"{suffix}-step{step}{theme}", f"step {step}{shape}{dark}", title)
        # Own figures are made by another command.
        command = f"<p><code>make figures FIGURE={name} STEPS=1 FORMAT=svg,pdf,png,tex</code> draws all of them.</p>" \
            if any(layout.stem == name for layout in LAYOUTS) else ""
        return (rows or command) and f"""<details><summary>Steps, shapes and formats<span class="aloud"> of {escaped(title)}</span></summary>{rows and f"<dl>{rows}</dl>"}{command}</details>
"""

    def source(self, name, variant, media):
        """On a narrow screen the text of the shape 4:3 is a third larger."""
        file = self.built / f"figures/{name}/{name}{variant}.svg"
        return f'<source media="{media}" srcset="../figures/{name}/{file.name}" {size(file)}>\n' if file.exists() else ""

    def show_figure(self, name, scene=""):
        home = self.built / "figures" / name
        svg, described = home / f"{name}.svg", read_words(home / f"{name}.txt")
        if ("figure", name) in self.shown or not svg.exists() or not described:
            return ""
        self.shown.add(("figure", name))
        title, words = described
        at = f"../figures/{name}/{name}"
        own = f'<p class="words">It has a scene of its own, whatever the example is: {escaped(scene)}.</p>\n' if scene else ""
        return f"""<figure>
<a href="{at}.svg"><picture>
{self.source(name, "-4x3-dark", f"{NARROW} and {DARK}")}{self.source(name, "-4x3", NARROW)}{self.source(name, "-dark", DARK)}\
<img src="{at}.svg" alt="{escaped(words)}" {size(svg)} loading="lazy"></picture></a>
<figcaption><h3>{escaped(title)}</h3>
{own}<dl>{self.row(name, "", "light", title)}{self.row(name, "-dark", "dark", title)}
<dt>also</dt><dd><ul>{link(f"{at}.txt", "in words", title, "words")}
{link(f"{at}.gp", "script", title, "gnuplot")}</ul></dd></dl>
{self.more_rows(name, title)}</figcaption></figure>
"""

    # ---- animations ----------------------------------------------------------------------------

    def videos(self, name, suffix, variant, title):
        """A row of links to the videos of one theme; nothing if there is none."""
        files = {label: f"animations/{name}/{name}{suffix}.{ending}" for ending, label in VIDEOS.items()}
        links = "".join(link(f"../{file}", label, title, variant)
                        for label, file in files.items() if (self.built / file).exists())
        return f"<dt>{variant}</dt><dd><ul>{links}</ul></dd>" if links else ""

    def video(self, name, suffix, theme, words):
        """A video in one theme; nothing if there is none. Nothing moves before the reader wants it: until then the
        last frame is shown."""
        frames = sorted((self.built / f"animations/{name}/frames{suffix}").glob("*.png"))
        if not frames:
            return ""
        files = {ending: f"animations/{name}/{name}{suffix}.{ending}" for ending in ("webm", "mp4")}
        sources = "".join(f'<source src="../{file}" type="video/{ending}">\n'
                          for ending, file in files.items() if (self.built / file).exists())
        return f"""<video{theme} controls loop muted playsinline preload="none" width="1280" height="720" \
poster="../animations/{name}/frames{suffix}/{frames[-1].name}" aria-label="{escaped(words)}">
{sources}</video>
"""

    def show_animation(self, name):
        home = self.built / "animations" / name
        light, dark = (home / "frames").exists(), (home / "frames-dark").exists()
        described = read_words(home / f"{name}.txt")
        if ("animation", name) in self.shown or not (light or dark) or not described:
            return ""
        self.shown.add(("animation", name))
        title, words = described
        return f"""<figure>
{self.video(name, "", ' class="in-light"' if dark else "", words)}{self.video(name, "-dark", ' class="in-dark"' if light else "", words)}\
<figcaption><h3>{escaped(title)}</h3>
<p class="words" aria-hidden="true">{escaped(words)}</p>
<dl>{self.videos(name, "", "light", title)}{self.videos(name, "-dark", "dark", title)}</dl>
</figcaption></figure>
"""

    # ---- the sections --------------------------------------------------------------------------

    def show_list(self, contents):
        """Entries 'section HEADING', 'figure NAME', 'animation NAME', 'picture NAME' and 'copy FILE'; indented lines
        below a picture are its title and its words, below a figure what its own scene is."""
        for entry in re.split(r"\n(?! |$)", contents):
            first, *rest = entry.split("\n")
            kind, _, name = first.partition(" ")
            title, *words = [line.strip() for line in rest if line.strip()] or [""]
            if kind == "section":
                self.sections.append([name.strip(), ""])
            elif kind == "animation":
                self.sections[-1][1] += self.show_animation(name.strip())
            elif kind == "figure":
                self.sections[-1][1] += self.show_figure(name.strip(), title)
            elif kind in ("picture", "copy"):
                self.sections[-1][1] += getattr(self, f"show_{kind}")(name.strip(), title, " ".join(words))

    def show_rest(self):
        for chapter in sorted(Path("chapters").glob("[0-9]*/")):
            figures = [self.show_figure(layout.stem) for layout in LAYOUTS if layout.parts[-3] == chapter.name]
            self.sections.append([read_heading(chapter / "README.md"), "".join(figures)])
        for heading, files, show in (("Your own figures", "figures/*/*.txt", self.show_figure),
                                     ("More animations", "animations/*/*.txt", self.show_animation),
                                     ("More pictures", "gallery/*.png", self.show_picture)):
            self.sections.append([heading, "".join(show(file.stem) for file in sorted(self.built.glob(files)))])

    # ---- the page ------------------------------------------------------------------------------

    def page(self):
        """Sections without a card are left out."""
        style = Path("chapters/gallery/gallery.css").read_text(encoding="utf-8")
        by = "the solutions" if self.answers == "solutions" else f"the answers in {escaped(self.answers)}/"
        # Not in a handout.
        videos = " <code>make animations</code> adds videos." if Path(".make/toolkit/lecture.mk").exists() else ""
        drawn = "" if any(self.built.glob("figures/*/*.svg")) else "<p>No figure is drawn yet.</p>"
        sections = [(number, escaped(heading), cards) for number, (heading, cards) in enumerate(self.sections, 1) if cards]
        contents = "".join(f'<li><a href="#section-{number}">{heading}</a></li>\n' for number, heading, _ in sections)
        cards = "".join(f"""<section aria-labelledby="section-{number}">
<h2 id="section-{number}">{heading}</h2>
<div class="cards">
{cards}</div></section>
""" for number, heading, cards in sections)
        return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Ray casting, step by step: pictures and figures</title>
<link rel="icon" href="data:,">
<style>
{style}</style>
</head>
<body>
<a class="skip" href="#pictures">To the pictures</a>
<header>
<h1>Ray casting, step by step: pictures and figures</h1>
<p>Cast and computed by {by}, in the order of the lecture. Figures come light and dark; <code>make
figures</code> draws them in more formats, <code>STEPS=1</code> in steps for slides,
<code>SHAPE=4:3</code> in another shape.{videos}</p>
{drawn}
</header>
<nav aria-label="The lecture"><ul>
{contents}</ul></nav>
<main id="pictures">
{cards}</main>
</body>
</html>
"""


def main():
    built, scenes = map(Path, sys.argv[1:])
    (built / "gallery").mkdir(parents=True, exist_ok=True)
    gallery = Gallery(built, scenes)
    gallery.show_list(Path("chapters/gallery/contents.txt").read_text(encoding="utf-8"))
    gallery.show_rest()
    # Under another name first: the page appears whole or not at all.
    new = built / "gallery/.index.html"
    new.write_text(gallery.page(), encoding="utf-8")
    new.replace(built / "gallery/index.html")


main()
