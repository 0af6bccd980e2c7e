"""show_mistakes.py - what a known mistake does to the pictures and the figures of the lecture, on a page.

    show_mistakes.py list BUILD           names of mistakes, their words, and a page with their pictures
    show_mistakes.py show BUILD NAME      the pictures, and each figure that differs, with 'solid: expected, dashed: yours'
    show_mistakes.py questions BUILD      questions to the class (questions.txt): BUILD/questions/questions.txt is a lecture of
                                          them (chapters/slides/lecture.py), with their pictures beside it
    show_mistakes.py gallery BUILD        the questions of each chapter for its gallery in a page, without the right answers (JSON)

NAME: of names.txt, or FUNCTION/ID. BUILD/tests/mistaken/NN-stem is the program of each chapter, by any of the mistakes
(tests/proof/mistaken_figures.c); BUILD/solutions has the right pictures and figures. All of it is in BUILD/mistakes/.
"""
import html
import json
import os
import re
import shutil
import subprocess
import sys
import textwrap
from collections import namedtuple
from functools import cache
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

HERE = Path(__file__).parent
PROGRAM_TIME = 60  # seconds: a mistake may never come to an end
SIZE = "320x240"
# The last picture of the lecture, flat and with light.
PICTURES = (("flat", "06-ray-casting", ()), ("shaded", "07-shading", ("chapters/06-ray-casting/three-spheres.nff",)))

Mistake = namedtuple("Mistake", "number stem function id formula why picture words")


def known(build):
    listed = subprocess.run([build / "tests/mistaken/06-ray-casting", "list"], capture_output=True, text=True, check=True)
    lines = [line.split("\t") for line in listed.stdout.splitlines()]
    return [Mistake(number, *each, f"{each[1]} looks like {each[3]}: {each[4]}") for number, each in enumerate(lines)]


def names():
    """NAME: (FUNCTION, ID)"""
    lines = (HERE / "names.txt").read_text(encoding="utf-8").splitlines()
    return {name: (function, mistake) for name, function, mistake in
            (line.split() for line in lines if line and not line.startswith("#"))}


def find(mistakes, name):
    function, mistake = names().get(name) or (name.partition("/")[::2])
    found = [each for each in mistakes if (each.function, each.id) == (function, mistake)]
    if not found:
        sys.exit(f"make mistake NAME={name}: there is no such mistake. 'make mistakes' lists those with a name; "
                 "others are FUNCTION/ID, as in tests/NN-stem/wrong.c")
    return found[0]


def wrapped(words):
    """For a terminal."""
    return textwrap.fill(words, 78, initial_indent="  ", subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def run(*command):
    """What a program prints; None if it fails, as it may by a mistake."""
    try:
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, timeout=PROGRAM_TIME)
    except (subprocess.TimeoutExpired, UnicodeDecodeError):
        return None
    return done.stdout if done.returncode == 0 else None


@cache
def right_picture(program, scene):
    """In bytes: cast once for all mistakes."""
    with TemporaryDirectory() as folder:
        picture = Path(folder) / "right.png"
        run(program, -1, "-o", picture, "-s", SIZE, *scene)
        return picture.read_bytes()


def casts(build, mistake, folder):
    """The pictures by the mistake, yours-KIND.png, and right-KIND.png; those that differ, one after the other."""
    for kind, stem, scene in PICTURES:
        yours, right = (folder / f"{who}-{kind}.png" for who in ("yours", "right"))
        yours.unlink(missing_ok=True)
        program = build / "tests/mistaken" / stem
        right.write_bytes(right_picture(program, scene))
        run(program, mistake.number, "-o", yours, "-s", SIZE, *scene)
        if yours.exists() and yours.read_bytes() != right.read_bytes():
            yield kind


def scripts(build, mistake, folder):
    """The scripts of the figures that differ, FOLDER/NAME/NAME.gp; their names in the order of the chapters."""
    drawn = []
    for layout in sorted(Path("chapters").glob("0*/figures/*.gp")):
        stem, name = layout.parts[1], layout.stem
        right = build / "solutions/figures" / name / f"{name}.gp"
        if stem < mistake.stem or not right.exists():
            continue
        script = run(build / "tests/mistaken" / stem, mistake.number, "--figure", name, "--beside", right,
                     "--note", mistake.words)
        if script and "\nwrong = 1\n" in script:
            (folder / name).mkdir()
            (folder / name / f"{name}.gp").write_text(script, encoding="utf-8")
            drawn.append(name)
    return drawn


def draw(folder, figures):
    """SVGs for the page; and a PDF of each, which is a slide."""
    settings = {"FORMAT": "svg,pdf", "THEME": "light,dark", "SHAPE": "16:9", "STEPS": "0"}
    subprocess.run([sys.executable, "-B", "chapters/gallery/draw_figures.py", folder, *figures],
                   env={**os.environ, **settings}, check=True, stdout=subprocess.DEVNULL)


# ---- the page -------------------------------------------------------------------------------------

STYLE = """body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; font: 1.1rem/1.5 system-ui, sans-serif }
img { max-width: 100%; height: auto } figure { margin: 1.5rem 0 } .pair { display: flex; flex-wrap: wrap; gap: 1rem }
.pair figure { margin: 0; flex: 1 1 16rem } code { font-size: 0.95em }
:root { color-scheme: light dark; background: Canvas; color: CanvasText }"""


def page(path, title, body):
    path.write_text(f"<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                    f"content=\"width=device-width\">\n<title>{html.escape(title)}</title>\n<style>{STYLE}</style>\n"
                    f"<h1>{html.escape(title)}</h1>\n{body}", encoding="utf-8")


def picture(file, words):
    return f'<figure><img src="{file}" alt="{html.escape(words)}"><figcaption>{html.escape(words)}</figcaption></figure>'


def pair(folder, kind):
    return (f'<div class="pair">{picture(f"{folder}right-{kind}.png", "expected")}'
            f'{picture(f"{folder}yours-{kind}.png", "yours")}</div>\n')


def figure(name, words):
    return f"""<h2>{name}</h2>
<figure><picture><source media="(prefers-color-scheme: dark)" srcset="{name}/{name}-dark.svg">
<img src="{name}/{name}.svg" alt="{html.escape(words)}"></picture></figure>
<p>For a slide: <a href="{name}/{name}.pdf">light</a>, <a href="{name}/{name}-dark.pdf">dark</a></p>
"""


def show(build, name):
    mistake = find(known(build), name)
    folder = build / "mistakes" / name.replace("/", "-")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    kinds, figures = list(casts(build, mistake, folder)), scripts(build, mistake, folder)
    if figures:
        draw(folder, figures)
    body = f"<p>{html.escape(mistake.words)}</p>\n"
    body += "".join(pair("", kind) for kind in kinds)
    for each in figures:
        body += figure(each, (folder / each / f"{each}.txt").read_text(encoding="utf-8"))
    body += "" if kinds or figures else "<p>No picture and no figure of the lecture shows it: its numbers are too ordinary.</p>"
    page(folder / "index.html", name, body)
    print(f"{wrapped(mistake.words)}\nPictures that differ: {' '.join(kinds) or 'none'}\nFigures that differ:\n{wrapped(' '.join(figures) or 'none')}\n"
          f"A page: {folder}/index.html\nA figure, for a slide: {folder}/FIGURE/FIGURE.pdf")


def list_all(build):
    mistakes, body = known(build), ""
    for name in names():
        mistake, folder = find(mistakes, name), build / "mistakes/pictures" / name
        folder.mkdir(parents=True, exist_ok=True)
        kinds = list(casts(build, mistake, folder))
        body += f"<h2>{name}</h2>\n<p>{html.escape(mistake.words)}</p>\n"
        body += pair(f"pictures/{name}/", kinds[0]) if kinds else "<p>It is in figures, and in no picture.</p>\n"
        body += f"<p><code>make mistake NAME={name}</code></p>\n"
        print(f"{name}\n{wrapped(mistake.words)}", flush=True)
    page(build / "mistakes/index.html", "Known mistakes", body)
    print(f"Their pictures: {build}/mistakes/index.html")


# ---- questions to the class ------------------------------------------------------------------------

FIRST_QUESTION = """Questions to the class
= Questions to the class
name: questions
Which line drew the picture? Four to choose from. Vote, talk about it in pairs, and vote again.
"""


def capital(words):
    return words[:1].upper() + words[1:] if words[1:2].isalpha() else words


def with_minus(words):
    return re.sub(r"(?<![\w)])-(?=[\w(])", "−", words)


def as_formula(text):
    """Mathematics, if it has no words."""
    if re.search("[a-zA-Z]{3}|if|of", re.sub("max|min|point", "", text)):
        return with_minus(text)
    text = re.sub(r"(?<=[\w)]) (?=[\w(])", r"\\, ", text)
    return "$" + re.sub(r"(\w)\.(\w)", r"\1 \\cdot \2", text).replace("max", r"\max").replace("point", r"\mathit{point}") + "$"


def asked(mistakes):
    for line in (HERE / "questions.txt").read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            part, function, ids, right = (each.strip() for each in line.split("|", 3))
            yield part, [find(mistakes, f"{function}/{each}") for each in ids.split()], right


def question(wrong, right, number, folder, build):
    """A slide: two pictures, four lines to choose from; then which it was, and why."""
    function = wrong[0].function
    kind = next(casts(build, wrong[0], folder))
    name = f"ask-{number}-{function.replace('_', '-')}"
    for who in ("right", "yours"):
        (folder / f"{who}-{kind}.png").replace(folder / f"{name}-{who}.png")
    choices = [None, *wrong]
    Random(name).shuffle(choices)
    letter = dict(zip(choices, "ABCD"))
    formulas = "\n".join(f"**{letter[each]}** \u2002 {as_formula(each.formula if each else right)}" for each in choices)
    why = wrong[0].why if len(wrong[0].why) < 150 else wrong[0].why.partition(". ")[0] + "."
    others = "\n".join(f"{letter[each]} would show: {each.picture}. {capital(each.why)}" for each in wrong[1:])
    return f"""= Which line was it?
name: {name}
minutes: 2
exercise: {wrong[0].stem[:2]} {function}
picture: {folder}/{name}-right.png {folder}/{name}-yours.png
added
? The upper picture is right. The lower one is by a wrong `{function}`. By which?
{formulas}
answer
! It was **{letter[wrong[0]]}**: {with_minus(why)}
! Right is **{letter[None]}**.
notes
Let the room vote, discuss in pairs, and vote again.
{others}
"""


def questions(build):
    folder = build / "questions"
    folder.mkdir(exist_ok=True)
    text, before = FIRST_QUESTION, ""
    for number, (part, wrong, right) in enumerate((each for each in asked(known(build)) if each[0]), 1):
        text += f"== {part}\n" * (part != before) + question(wrong, right, number, folder, build)
        before = part
    (folder / "questions.txt").write_text(text, encoding="utf-8")


def gallery(build):
    chapters = {}
    for _, wrong, _ in asked(known(build)):
        chapters.setdefault(wrong[0].stem, []).append([each._asdict() for each in wrong])
    print(json.dumps(chapters))


def main(what, build, name=""):
    if what == "show":
        show(Path(build), name)
    else:
        {"list": list_all, "questions": questions, "gallery": gallery}[what](Path(build))


if __name__ == "__main__":
    main(*sys.argv[1:])
