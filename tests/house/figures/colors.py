"""colors.py - the colors of both themes can be read, and told apart, also by who sees fewer of them; lines also in grey."""
import itertools
import math
import pathlib
import re
import subprocess

from check import Checks, color, contrast, linear

INKS = ("ink", "grey", "blue", "orange", "green", "pink")
LEGIBLE = 4.5
APART = 15  # in CIELAB, where about 2 can be told apart side by side
LAYOUTS = ("chapters/*/figures", "chapters/animations", "tests/judge/layouts")
WIDER = 1.35  # so much wider a line is another one

# What linear red, green and blue become for others (Machado, Oliveira and Fernandes 2009, severity 1).
SEEN = {"everybody": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
        "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
        "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
        "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900))}
XYZ = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))  # of linear sRGB
WHITE = (0.9505, 1, 1.089)


def changed(matrix, vector):
    return [min(1, max(0, sum(a * b for a, b in zip(row, vector)))) for row in matrix]


def lab(rgb):
    """Of linear red, green and blue, CIELAB: its distances are those that are seen."""
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116
               for t in (a / b for a, b in zip(changed(XYZ, rgb), WHITE)))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def variables(name):
    """Those of common/figure/plot.gp, read by gnuplot itself."""
    done = subprocess.run(["gnuplot", "-e", f"name='none'; format='txt'; theme='{name}'; load 'common/figure/plot.gp'; "
                           "show variables all"], capture_output=True, text=True, check=True, timeout=60)
    return dict(re.findall(r'^\s*(\w+) = "(.*)"$', done.stderr, re.M))


def theme(checks, name):
    known = variables(name)
    colors = {each: color(known[each]) for each in (*INKS, "background", "surface")}
    for i, ink in enumerate(INKS):
        for ground in ("background", "surface"):
            ratio = contrast(colors[ink], colors[ground])
            checks.that(f"{name}: {ink} can be read on {ground}", ratio >= LEGIBLE, f"{ratio:.2f} to 1")
        for other in INKS[:i]:
            for who, matrix in SEEN.items():
                away = math.dist(*(lab(changed(matrix, linear(colors[each]))) for each in (ink, other)))
                checks.that(f"{name}, {who}: {ink} is not {other}", away >= APART, f"{away:.1f} apart, expected {APART}")
    grey = {ink: lab(linear(colors[ink]))[0] for ink in INKS}
    for layout in sorted(layout for there in LAYOUTS for layout in pathlib.Path().glob(f"{there}/*.gp")):
        alike = {(a[0], b[0]) for a, b in itertools.combinations(kinds_of_lines(layout.read_text(encoding="utf-8"), known), 2)
                 if a[0] != b[0] and abs(grey[a[0]] - grey[b[0]]) < APART and a[2:] == b[2:] and max(a[1], b[1]) < WIDER * min(a[1], b[1])}
        checks.that(f"{name}: {layout}, in grey all kinds of lines can be told apart", not alike, f"{alike}")


def kinds_of_lines(script, known):
    """Of each line and arrow of a layout: its color, width, head and dashes."""
    script = script.replace("\\\n", " ")
    known = {**known, **dict(re.findall(r'^(\w+) = "(.*)"$', script, re.M))}
    for _ in range(3):
        script = re.sub(r"@(\w+)", lambda name: known.get(name[1], ""), script)
    for style in re.findall(r" with ((?:lines|vectors) .*?)(?: title |$)", script, re.M):
        ink = re.search(r"\blc rgb \(?(?:who == 0 \? )?(\w+)", style)
        if ink and ink[1] in INKS:
            width, head, dashes = (re.search(rf"\b{what}", style) for what in (r"lw ([\d.]+)", r"heads? .*?size ([\d.,]+)", r"dt (\(.*?\)|\d)"))
            yield ink[1], float(width[1]) if width else 1, head and head[1], dashes and dashes[1]


def main():
    checks = Checks("colors of figures")
    theme(checks, "light")
    theme(checks, "dark")
    checks.end()


main()
