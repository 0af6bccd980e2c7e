"""draw_figures.py - has gnuplot draw scripts of figures: every format, theme, shape and step wanted.

    draw_figures.py FOLDER NAME...
    draw_figures.py --one FOLDER NAME     FOLDER/NAME.gp as FOLDER/NAME.svg alone, light

Each figure has a folder: FOLDER/NAME/NAME.gp becomes FOLDER/NAME/NAME[-4x3][-stepN][-dark].FORMAT. What has been
drawn from the same script is left alone. In the environment: FORMAT, THEME, SHAPE (lists with commas), STEPS (1: also
a picture for each step). Pictures appear whole or not at all; the same script gives the same bytes. Exit status: 1 if
something could not be drawn, 2 wrong usage, 3 no gnuplot.
"""
import html
import os
import re
import shutil
import sys
import tempfile
from collections import namedtuple
from pathlib import Path

import latex_picture
from jobs import beside_each_other, end_with_programs, is_newer, run, wanted

ALL_STEPS = 1000
AT_ONCE = 16  # pictures by one gnuplot, which takes as long to begin as to draw one
SAID = b"\x1e\n"  # between what it says of each
SOURCES = [Path(__file__), Path(latex_picture.__file__)]

Picture = namedtuple("Picture", "name output format theme shape step")


class NotDrawn(Exception):
    """With its message."""


def has_font():
    """Without a font cairo leaves out all text without a message: then a letter leaves no mark."""
    if shutil.which("fc-list") and run(["fc-list"])[1]:
        return True
    empty, letter = (run(["gnuplot", "-d", "-e", "set terminal pngcairo size 60,30; "
                          f"set label '{text}' at 0,0; plot [-1:1] [-1:1] 2"])[1] for text in ("", "W"))
    return empty != letter


def tidy_words(text):
    """Spaces that stand for nothing go: what a sentence is left out of has one too many."""
    return re.sub(" +", " ", text).replace(" \n", "\n")


def finished_svg(svg, words):
    """The SVG that gnuplot has drawn, as one that can be read aloud, and that shows the same everywhere: fonts get a
    family to fall back on; and rings and crosses are hairlines in gnuplot 5.4, whatever their width. Groups of
    nothing go: their colors are those of the picture before. A page does the same (chapters/book/figure.js)."""
    title, _, rest = words.partition("\n")
    title, description = (html.escape(text, quote=False) for text in (title, " ".join(rest.split("\n")).strip()))
    svg = svg.replace("<svg", '<svg role="img" aria-labelledby="title description" xml:space="preserve"', 1)
    svg = svg.replace('font-family="DejaVu Sans"', 'font-family="DejaVu Sans, Verdana, sans-serif"')
    svg = svg.replace('font-family="DejaVu Serif"', 'font-family="DejaVu Serif, Georgia, serif"')
    svg = re.sub(r"(id=.gpPt.*?stroke-width=')[\d.]+", r"\g<1>0.6", svg)
    svg = re.sub(r"<g fill[^>]*>\n</g>\n", "", svg)
    svg = re.sub(".*<title>.*", lambda _: f'<title id="title">{title}</title>', svg, count=1)
    return re.sub(".*<desc>.*", lambda _: f'<desc id="description">{description}</desc>', svg, count=1)


class Drawing:
    """Draws pictures of the scripts in a folder, with a folder for what is not whole yet."""

    def __init__(self, folder, only_one, work):
        self.folder, self.only_one, self.drawn, self.work = folder, only_one, folder / ".drawn", work
        self.failed = set()  # names
        self.messages = []

    def home(self, name):
        return self.folder if self.only_one else self.folder / name

    def is_drawn(self, picture):
        """Whether it is newer than the copy of the script that it was drawn from, and than this program."""
        path = self.home(picture.name) / f"{picture.output}.{picture.format}"
        return is_newer(path, self.drawn / f"{picture.name}.gp", *SOURCES)

    def complaint(self, name, said):
        """gnuplot's messages, with the lines of the layout: gnuplot counts those of the script. For a command on
        several lines it names the last line and a place in it: the text of that place is shown."""
        script = self.home(name) / f"{name}.gp"
        lines = script.read_text(encoding="utf-8").split("\n")
        layout = re.search(r'^layout_file = "([^"]*)', "\n".join(lines[:3]), re.MULTILINE)
        first = lines.index("# ---- the layout") + 1 if "# ---- the layout" in lines else 0
        found, near, before = "", "", ""
        for line in said.split("\n"):
            message = re.search(r"\bline (\d+): (.*)", line)
            if line.strip(" ") == "^":
                near = before[max(len(line) - 31, 0):][:60]
            elif message:
                place = f"{script}:{message[1]}"
                if layout and int(message[1]) - first - 1 > 0:
                    length = len(Path(layout[1]).read_text(encoding="utf-8").splitlines())
                    place = f"{layout[1]}:{min(int(message[1]) - first - 1, length)}"
                found += f"{place}: gnuplot: {message[2]}\n" + (f"    near: {near}\n" if near else "")
                near = ""
            before = line
        if found:
            return found
        return f"{script}: gnuplot says:\n" + "".join(f"  {line}\n" for line in said.splitlines()) if said else \
            f"{script}: gnuplot crashes\n"

    def finish(self, picture, place):
        """Makes the wanted files of those that gnuplot has drawn in a folder."""
        drawn = place / f"{picture.output}.{picture.format}"
        if picture.format == "txt":
            drawn.write_text(tidy_words(drawn.read_text(encoding="utf-8")), encoding="utf-8")
            (place / "steps").replace(self.drawn / f"{picture.name}.steps")
            return
        if picture.format in ("svg", "tex"):
            words = (self.home(picture.name) / f"{picture.name}.txt").read_text(encoding="utf-8")
        if picture.format == "svg":
            drawn.write_text(finished_svg(drawn.read_text(encoding="utf-8"), words), encoding="utf-8")
        if picture.format == "tex":
            # LaTeX draws its text over a PDF, which needs another name than the figure's own PDF.
            (place / f"{picture.output}.pdf").replace(place / f"{picture.output}-tex.pdf")
            text = latex_picture.latex_picture(drawn.read_text(encoding="utf-8"), words, f"{picture.output}-tex")
            drawn.write_text(text, encoding="utf-8")
        for pdf in place.glob("*.pdf"):
            # Another date of the same length: a PDF says where in it things are.
            pdf.write_bytes(re.sub(rb"(?<=CreationDate \(D:)\d{14}", b"19700101000000", pdf.read_bytes()))
        drawn.stat()

    def place(self, picture):
        return self.work / f"{picture.output}.{picture.format}"

    def ask_gnuplot(self, pictures):
        """One gnuplot draws them all: its exit status, and what it says of each."""
        command = ["gnuplot", "-d"]
        for picture in pictures:
            place = self.place(picture)
            place.mkdir(exist_ok=True)
            settings = "; ".join(f"{name}='{getattr(picture, name)}'" for name in ("format", "theme", "shape", "output"))
            command += ["-e", "reset session", "-e", f"cd '../{place.name}'; {settings}; step={picture.step}",
                        os.path.relpath(self.home(picture.name) / f"{picture.name}.gp", place),
                        "-e", 'set print "steps"; print steps; set print; print "\\036"']
        status, said = run(command, self.place(pictures[0]))
        return status, said.split(SAID)

    def take(self, picture, status, said):
        """What gnuplot has to say of it, in words; NotDrawn, also with words, if there is no picture."""
        place, known, words = self.place(picture), self.drawn / f"{picture.name}.words", ""
        # A warning about the data comes with each format; it is printed once.
        if status != 0 or (said and not (known.exists() and known.read_bytes() == said)):
            words = self.complaint(picture.name, said.decode("utf-8", "replace"))
        if status != 0:
            raise NotDrawn(words)
        try:
            self.finish(picture, place)
        except (OSError, latex_picture.Misplaced) as error:
            why = "" if isinstance(error, OSError) else f"{error}\n"
            file = self.home(picture.name) / f"{picture.output}.{picture.format}"
            raise NotDrawn(f"{words}{why}{file} could not be made of what gnuplot drew\n") from error
        if picture.format == "txt":
            known.write_bytes(said)
        for file in place.iterdir():
            if file.name != "steps":
                file.replace(self.home(picture.name) / file.name)
        return words

    def try_to_draw(self, pictures):
        """Each with whether it is drawn, and words. gnuplot ends at a fault: then each is drawn on its own."""
        status, said = self.ask_gnuplot(pictures)
        if (status != 0 or len(said) <= len(pictures)) and len(pictures) > 1:
            return [result for picture in pictures for result in self.try_to_draw([picture])]
        results = []
        for picture, each in zip(pictures, said):
            try:
                results.append((picture, True, self.take(picture, status, each)))
            except NotDrawn as error:
                results.append((picture, False, str(error)))
        return results

    def draw_all(self, pictures):
        """Draws those that are not drawn yet; how many these are."""
        pictures = [picture for picture in pictures if not self.is_drawn(picture)]
        size = max(1, min(AT_ONCE, len(pictures) // (2 * os.cpu_count())))
        batches = [pictures[i:i + size] for i in range(0, len(pictures), size)]
        for _, results in beside_each_other("figures", self.try_to_draw, batches, len):
            for picture, drawn, words in results:
                self.messages.append(words)
                if not drawn:
                    self.failed.add(picture.name)
        return len(pictures)

    def begin(self, name):
        """The figure in words, which the other formats contain."""
        script, copy = self.home(name) / f"{name}.gp", self.drawn / f"{name}.gp"
        if not copy.exists() or copy.read_bytes() != script.read_bytes():
            shutil.copyfile(script, self.work / "new")
            (self.work / "new").replace(copy)
        return Picture(name, name, "txt", "light", "16:9", ALL_STEPS)

    def pictures(self, name, formats, themes, shapes, in_steps):
        count = int((self.drawn / f"{name}.steps").read_text(encoding="utf-8")) if in_steps else 0
        for step in (ALL_STEPS, *range(1, count + 1)):
            for shape in shapes:
                for theme in themes:
                    output = name + ("" if shape == "16:9" else "-4x3") + \
                        ("" if step == ALL_STEPS else f"-step{step}") + ("" if theme == "light" else "-dark")
                    for format in formats:
                        yield Picture(name, output, format, theme, shape, step)


def main(arguments):
    only_one = arguments[:1] == ["--one"]
    folder, *names = arguments[only_one:]
    folder = Path(folder)
    if only_one:
        os.environ.update(FORMAT="svg", THEME="light", SHAPE="16:9", STEPS="0")
    formats = wanted("FORMAT", "svg,pdf,png", ("svg", "pdf", "png", "tex"))
    themes = wanted("THEME", "light,dark", ("light", "dark"))
    shapes = wanted("SHAPE", "16:9", ("16:9", "4:3"))
    in_steps = wanted("STEPS", "0", ("0", "1")) == ["1"]
    if not shutil.which("gnuplot"):
        print("gnuplot is missing, so no figure is drawn: 'make setup' installs it.\n"
              f"The scripts are written: {folder}/{'' if only_one else '*/'}*.gp", file=sys.stderr)
        return 3
    end_with_programs()
    # Numbers and letters are the same everywhere; and cairo writes its date without a zone.
    os.environ.update(LC_ALL="C.UTF-8", TZ="UTC", SOURCE_DATE_EPOCH="0")
    (folder / ".drawn").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".", dir=folder / ".drawn") as work:
        drawing = Drawing(folder, only_one, Path(work))
        # Without a script there is no figure.
        names = [name for name in names if (drawing.home(name) / f"{name}.gp").exists()]
        drawing.draw_all([drawing.begin(name) for name in names])
        if {"pdf", "png"} & set(formats) and not has_font():
            drawing.messages.append("There is no font, so PDFs and PNGs would have no text and are not drawn: "
                                    "'make setup' installs one.\n")
            formats = [format for format in formats if format not in ("pdf", "png")]
            drawing.failed.add("pictures with text")
        drawn = drawing.draw_all([picture for name in names if name not in drawing.failed
                                  for picture in drawing.pictures(name, formats, themes, shapes, in_steps)])
    sys.stderr.write("".join(drawing.messages))
    if drawing.failed:
        return 1
    if not only_one:
        print(f"Figures: {len(names)} as {' '.join(formats)} in {folder}/ ({drawn} drawn now)")
    return 0


sys.exit(main(sys.argv[1:]))
