"""lecture_page.py - writes the slides of a lecture (lecture.py) as HTML, for the page's lecture.html.

    lecture_page.py LECTURE NUMBERS.json FIGURES QUESTIONS

QUESTIONS is another lecture: after each part come its slides of the part of that name, but for those that are in it. Each page of the slides is a section. What it does not show yet is there, but hidden, so all pages of a slide look alike.
Mathematics stays TeX, in elements <math-tex>, which chapters/book/site/lecture.mjs typesets. FIGURES has the words of
each figure, NAME/NAME.txt, and its script, which names its layout.
"""
import html
import json
import re
import sys
from pathlib import Path

import lecture as lectures


def escape(text):
    return html.escape(text, quote=True)


WRITERS = {"math": lambda tex: f"<math-tex>{escape(tex[1:-1])}</math-tex>", "code": lambda text: f"<code>{escape(text)}</code>",
           "bold": lambda text: f"<strong>{words(text)}</strong>", "emph": lambda text: f"<em>{words(text)}</em>",
           "url": lambda text: f'<a href="{escape(text)}" rel="noopener">{escape(text)}</a>',
           "quote": lambda text: f"“{words(text)}”", "letter": escape}


def words(text):
    return lectures.in_pieces(text, WRITERS)


def item(each, hidden):
    inside = f'<math-tex class="display">{escape(each.text)}</math-tex>' if each.kind == "formula" else words(each.text)
    level = f" level-{each.level}" if each.kind in ("bullet", "code") else ""
    later = " data-later" if hidden else ""
    return f'<p class="{"plain" if each.kind == "text" else each.kind}{level}"{later}>{inside}</p>'


class LecturePage:
    def __init__(self, lecture, figures, questions):
        self.lecture, self.figures = lecture, figures
        asked = {slide.picture for slide in lecture.slides}
        self.questions = [slide for slide in questions.slides if slide.picture not in asked]

    def stem(self, figure):
        """The chapter whose program draws a figure: the folder of its layout."""
        script = (self.figures / figure / f"{figure}.gp").read_text(encoding="utf-8")
        return re.search(r'^layout_file = ".*?([0-9][0-9]-[a-z-]+)/', script, re.MULTILINE)[1]

    def picture(self, slide, step):
        """The figure at its step, or the picture."""
        if slide.picture:
            images = "".join(f'<img src="{escape(file)}" alt="{escape(slide.title)}">' for file in slide.picture.split())
            return f'<div class="picture">{images}</div>'
        said = (self.figures / slide.figure / f"{slide.figure}.txt").read_text(encoding="utf-8")
        title, _, rest = said.partition("\n")
        shape = "16:9" if slide.below else "4:3"
        said = escape(f"{title}: step {step}. {' '.join(rest.split())}")
        narrow = "" if slide.below else "-4x3"
        file = f"lecture/{slide.figure}{narrow}-step{step}.svg"
        return f'<div class="figure" data-stem="{self.stem(slide.figure)}" data-figure="{slide.figure}" data-shape="{shape}" data-step="{step}">' \
            f'<div class="drawing"><img src="{file}" alt="{said}"></div></div>'

    def notes(self, slide):
        lines = "".join("<p>" + (f"<b>{label}:</b> " if label else "") + f"{words(text)}</p>" for label, text in slide.notes)
        return f'<aside class="notes" hidden>{lines}</aside>'

    @staticmethod
    def practice(slide):
        said, chapter = escape(slide.practised_by()), next(Path("chapters").glob(f"{slide.exercise[:2]}-*/"), None)
        return f'<a href="{chapter.name}.html#exercise">{said}</a>' if said.startswith("Exercise ") and chapter else said

    def page(self, slide, count):
        page, number = slide.pages[count - 1], "question" if slide in self.questions else f"{slide.number} of {len(self.lecture.slides)}"
        now = len(slide.items(count))
        items = "\n".join(item(each, i >= now) for i, each in enumerate(slide.items(len(slide.pages))))
        shown = self.picture(slide, page.step) if slide.figure or slide.picture else ""
        layout = "full" if not shown else "below" if slide.below else "beside"
        title = f"<h1>{words(self.lecture.title)}</h1>" if slide is self.lecture.slides[0] else f"<h2>{words(slide.title)}</h2>"
        left = f'<a href="figures.html#{slide.figure}">Figure · </a>' * bool(slide.figure) + \
            " · ".join(filter(None, [self.practice(slide), "added to the deck" * slide.added]))
        title += f'<a class="qr" href="{slide.place_on_site()}"></a>' * slide.code
        address = slide.name + (f"/{count}" if count > 1 else "")
        data = f'data-name="{slide.name}" data-slide="{number.split()[0]}" data-page="{count}" data-pages="{len(slide.pages)}" ' \
            f'data-minutes="{slide.minutes}"' + (f' data-film="{slide.film}"' if slide.film else "")
        return f"""<section class="slide {layout}" id="{address}" {data} aria-label="{escape(slide.title)}, {number}">
{title}
<div class="body"><div class="words">{items}</div>{shown}</div>
<footer><span>{left}</span><span>{escape(slide.part)} · {number}</span></footer>
{self.notes(slide) if count == 1 else ''}</section>
"""

    def html(self):
        slides = [slide for part in self.lecture.parts() for slide in [*self.lecture.slides, *self.questions] if slide.part == part]
        return "".join(self.page(slide, count + 1) for slide in slides for count in range(len(slide.pages)))


def main(path, numbers, figures, questions):
    try:
        questions = lectures.read(questions)
        lecture = lectures.read(path, json.loads(Path(numbers).read_text(encoding="utf-8")), questions)
    except lectures.Wrong as error:
        sys.exit(str(error))
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(LecturePage(lecture, Path(figures), questions).html())


if __name__ == "__main__":
    main(*sys.argv[1:])
