"""make_slides.py - writes the slides of a lecture (lecture.py) as LaTeX, and has pdflatex make PDFs of them.

    make_slides.py --ready                    fails if there is no LaTeX
    make_slides.py --figures LECTURE          the figures that it shows, a line each: NAME:below or NAME:beside
    make_slides.py LECTURE NUMBERS.json FIGURES SHAPE THEME OUTPUT.pdf
    make_slides.py LECTURE NUMBERS.json SLIDES.pdf SHAPE VERSION OUTPUT.pdf

SHAPE 16:9 or 4:3; THEME light or dark. VERSION: what is made of light slides for paper or for two screens: handout,
questions or notes. In the environment: ADDRESS, where the site is; QUESTIONS, a lecture of those that slides ask the class. The
same sources give the same bytes.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import lecture as lectures
from lecture import Wrong

# Letters of our texts that LaTeX does not know as they are; outside mathematics.
SIGNS = {"\\": r"\textbackslash{}", "%": r"\%", "&": r"\&", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}", "~": r"\~{}",
         "−": "$-$", "\u2002": r"\enspace{}", "·": r"$\cdot$", "…": r"\ldots{}"}

def plain(text):
    return "".join(SIGNS.get(letter, letter) for letter in text)


WRITERS = {"math": lambda tex: tex, "code": lambda text: rf"\texttt{{{plain(text)}}}", "bold": lambda text: rf"\textbf{{{words(text)}}}",
           "emph": lambda text: rf"\emph{{{words(text)}}}", "url": lambda text: rf"\url{{{text}}}",
           "quote": lambda text: f"``{words(text)}''", "letter": plain}


def words(text):
    """Words of the lecture as LaTeX."""
    return lectures.in_pieces(text, WRITERS)


def item(each):
    kind = each.kind
    if kind == "formula":
        return rf"\formula{{{each.text}}}"
    command = {"bullet": r"\bulletitem", "code": r"\codeline", "question": r"\question", "answer": r"\answer",
               "text": r"\plainline"}[kind]
    level = f"{{{each.level}}}" if kind in ("bullet", "code") else ""
    return f"{command}{level}{{{words(each.text)}}}"


class Slides:
    """Writes LaTeX for a lecture in one shape."""

    def __init__(self, lecture, shape):
        self.lecture, self.wide = lecture, shape == "16:9"

    def footer(self, slide):
        exercise = slide.practised_by() if self.wide else slide.practised_by().partition(":")[0].partition(",")[0]
        shown = [plain(exercise)] * bool(exercise)
        if slide.added:
            shown.append("added to the deck")
        where = [plain(slide.part)] * self.wide + [f"{slide.number} of {len(self.lecture.slides)}"]
        dot = r" \textperiodcentered\ "
        return f"{{{dot.join(shown)}}}{{{dot.join(where)}}}"

    def page_items(self, slide, count):
        """What a page shows; a narrow slide has only room for the newest words, and the question before them."""
        if self.wide or not (slide.figure or slide.picture):
            return slide.items(count)
        asked = [[each for each in page.items if each.kind == "question"] for page in slide.pages[:count - 1]]
        return next(filter(None, reversed(asked)), []) + slide.pages[count - 1].items or slide.items(count)

    def page(self, slide, count, figures, theme):
        """The page after so many steps of a slide."""
        lines = [item(each) for each in self.page_items(slide, count)]
        fullest = slide.most(lambda each: self.page_items(slide, each)) if self.wide else self.page_items(slide, count)
        below = slide.below or not self.wide
        shown = ""
        if slide.figure:
            step = slide.pages[count - 1].step
            name = slide.figure + ("" if self.wide and below else "-4x3") + f"-step{step}" + ("-dark" if theme == "dark" else "")
            if not (figures / slide.figure / f"{name}.tex").exists():
                raise Wrong(f"the figure {slide.figure} has no step {step}: slide '{slide.name}'")
            shown = rf"\figure{'below' if below else 'beside'}{{{slide.figure}/{name}}}"
        elif slide.picture:
            files = slide.picture.split()
            pictures = r"\vfil".join(rf"\onepicture{{{1.06 / len(files) - 0.06:.2g}}}{{{file}}}" for file in files)
            shown = rf"\picture{'below' if below else 'beside'}{{{pictures}}}"
        address = os.environ.get("ADDRESS", "").rstrip("/")
        layout = "full" if not shown else "below" if below else "beside"
        if slide.code and address:
            shown = rf"\slidecode{{{shown}}}{{{plain(f'{address}/{slide.place_on_site()}')}}}"
        is_title = slide.number == 1
        heading = [rf"\lecturetitle{{{words(self.lecture.title)}}}"] * is_title
        reserve = "\n".join(heading + [item(each) for each in fullest])
        title = "" if is_title else words(slide.title)
        body = "\n".join(heading + lines)
        return (rf"\lecturepage{{{title}}}{self.footer(slide)}{{{shown}}}{{{reserve}}}{{{layout}}}{{%"
                f"\n{body}}}\n")

    def outline(self):
        """The outline of the PDF, by its page numbers: parts, and in each its slides."""
        lines, page = [], 1
        starts = {}
        for slide in self.lecture.slides:
            starts[slide.name] = page
            page += len(slide.pages)
        for part in self.lecture.parts():
            of = [slide for slide in self.lecture.slides if slide.part == part]
            lines.append(rf"\outline{{{starts[of[0].name]}}}{{{-len(of)}}}{{{plain(part)}}}")
            lines += [rf"\outline{{{starts[slide.name]}}}{{0}}{{{plain(slide.title.replace('…', '...'))}}}" for slide in of]
        return "\n".join(lines)

    def slides(self, figures, theme):
        pages = [self.page(slide, count + 1, figures, theme) for slide in self.lecture.slides for count in range(len(slide.pages))]
        return rf"""\documentclass[t,hyperref={{bookmarks=false}}]{{beamer}}
\def\theme{{{theme}}}\def\shape{{{'16:9' if self.wide else '4:3'}}}
\usepackage{{lecture}}
\title{{{plain(self.lecture.title)}}}\author{{{plain(self.lecture.about.get('author', ''))}}}
\begin{{document}}
{self.outline()}
{''.join(pages)}\end{{document}}
"""

    # ---- what is made of the slides -------------------------------------------------------------

    def last_pages(self):
        """Of each slide, the number of its last page; and of the last one before its answer."""
        before = 0
        for slide in self.lecture.slides:
            yield slide, before + len(slide.pages), before + slide.unanswered()
            before += len(slide.pages)

    def handout(self):
        return "".join(rf"\halfsheet{{{last}}}" + "\n" for _, last, _ in self.last_pages())

    @staticmethod
    def tasks(slide):
        return "".join(rf"{words(each.text)}\par " for each in slide.items(len(slide.pages)) if each.kind == "question")

    def questions(self):
        asked = [each for each in self.last_pages() if each[0].asks()]
        return "".join(rf"\asked{{{unanswered}}}{{{self.tasks(slide)}}}" + "\n" for slide, _, unanswered in asked) + "\\answers\n" + \
            "".join(rf"\smallanswer{{{last}}}" + "\n" for _, last, _ in asked)

    def notes(self):
        lines, so_far, page = [], 0, 0
        slides = self.lecture.slides
        for i, slide in enumerate(slides):
            so_far += slide.minutes
            said = "\n".join((rf"\said{{{label}:}}" if label else r"\par ") + words(text) for label, text in slide.notes)
            following = words(slides[i + 1].title) if i + 1 < len(slides) else "the end"
            for count in range(len(slide.pages)):
                page += 1
                steps = len(slide.pages)
                then = f"Next: {following}" if count + 1 == steps else f"Next: step {count + 2} of {steps}, then {following}"
                lines.append(rf"\notespage{{{page}}}{{{slide.number} of {len(slides)}\quad {slide.minutes} min, until {so_far}}}{{{then}}}{{{said}}}")
        return "\n".join(lines) + "\n"

    def version(self, name, slides):
        return rf"""\documentclass{{article}}
\def\theme{{light}}\def\shape{{{'16:9' if self.wide else '4:3'}}}\def\version{{{name}}}\def\slides{{{slides}}}
\usepackage{{lecture}}
\pdfinfo{{/Title ({plain(self.lecture.title)}: {name})}}
\begin{{document}}
{getattr(self, name)()}\end{{document}}
"""


# ---- LaTeX ----------------------------------------------------------------------------------------

def ready():
    for need in ("pdflatex", "beamer.cls", "lmodern.sty", "qrcode.sty"):
        there = shutil.which(need) if need == "pdflatex" else shutil.which("kpsewhich") and \
            subprocess.run(["kpsewhich", need], stdout=subprocess.PIPE, check=False).stdout
        if not there:
            raise Wrong(f"make slides: LaTeX lacks {need}: 'make setup FOR=lecturer' installs it.")


def run_latex(text, output, folders):
    """Makes the PDF, whole or not at all."""
    work = output.parent / ".work" / output.stem
    work.mkdir(parents=True, exist_ok=True)
    source = work / f"{output.stem}.tex"
    source.write_text(text, encoding="utf-8")
    os.environ.update(TEXINPUTS=":".join([*map(str, folders), ".", ""]), SOURCE_DATE_EPOCH="0", FORCE_SOURCE_DATE="1",
                      max_print_line="1000")
    said = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-output-directory", work, source],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if said.returncode != 0:
        lines = said.stdout.decode("utf-8", "replace").splitlines()
        first = next((i for i, line in enumerate(lines) if line.startswith("!")), len(lines) - 20)
        raise Wrong("\n".join(lines[max(first, 0):][:9]))
    (work / output.name).replace(output)


def main(arguments):
    if arguments == ["--ready"]:
        return ready()
    if arguments[0] == "--figures":
        slides = lectures.read(arguments[1]).slides
        print("\n".join(sorted({f"{slide.figure}:{'below' if slide.below else 'beside'}" for slide in slides if slide.figure})))
        return None
    path, numbers, drawn, shape, kind, output = arguments
    questions = lectures.read(os.environ["QUESTIONS"]) if "QUESTIONS" in os.environ else None
    lecture = lectures.read(path, json.loads(Path(numbers).read_text(encoding="utf-8")), questions)
    slides, style = Slides(lecture, shape), Path(__file__).parent
    if kind in ("light", "dark"):
        run_latex(slides.slides(Path(drawn), kind), Path(output), [style, drawn, *sorted(Path(drawn).glob("*/"))])
    else:
        run_latex(slides.version(kind, Path(drawn).name), Path(output), [style, Path(drawn).parent])
    return None


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Wrong as error:
        sys.exit(str(error))
