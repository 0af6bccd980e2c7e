"""fill.py - fills the numbers of the example into the source of a lesson.

    fill.py NUMBERS SOURCE.md OUTPUT.txt README.md [marked]

NUMBERS: the program of NN-stem.c. OUTPUT: of the chapter's program. README: the lesson as it is. With 'marked', each
number is between private characters, so that a page finds it (chapters/book/site/lesson.mjs): U+E000 NAME U+E001
NUMBER U+E002. The source, chapters/lessons/NN-stem.md, has in double brackets
  [[name]]              a number or a text that NN-stem.c gives by that name
  [[output HEADING]]    on a line of its own: what the chapter's program prints below the heading that begins so,
                        heading included
  [[figure NAME]]       on a line of its own: the line that shows a figure, as the lesson has it now; make
                        lesson-figures writes it
All other text is the lesson's. Numbers come as people write them; in formulas they become LaTeX.
"""
import json
import re
import subprocess
import sys
from pathlib import Path


FORMULA = re.compile(r"```math\n.*?^```|(```|~~~).*?^\1|`[^`\n]*`|\$[^$]*\$", re.MULTILINE | re.DOTALL)
PLAIN = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def as_latex(formula):
    """The numbers of a formula: −10,000 is -10{,}000, and 1.2 · 10⁻⁶ is 1.2 \\cdot 10^{-6}."""
    formula = re.sub(r"(?<=\d),(?=\d{3})", "{,}", formula.replace("−", "-")).replace(" · 10", r" \cdot 10")
    return re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda raised: f"^{{{raised[0].translate(PLAIN)}}}", formula)


def in_formulas(text):
    return FORMULA.sub(lambda part: as_latex(part[0]) if part[0][0] == "$" or part[0].startswith("```math") else part[0], text)


class Lesson:
    def __init__(self, numbers, source, output, lesson, marked):
        self.numbers = json.loads(subprocess.run([numbers], stdout=subprocess.PIPE, check=True).stdout)
        self.source, self.marked, self.used, self.errors = source, marked, set(), []
        self.output, self.lesson = (Path(path).read_text(encoding="utf-8") for path in (output, lesson))

    def wrong(self, number, words):
        self.errors.append(f"{self.source}:{number}: {words}")
        return ""

    def number(self, name, line):
        if name not in self.numbers:
            return self.wrong(line, f"no number has the name '{name}'")
        self.used.add(name)
        text = self.numbers[name]
        return f"\ue000{name}\ue001{text}\ue002" if self.marked else text

    def filled(self, line, number):
        figure, output = (re.fullmatch(rf"\[\[{word} (.*)\]\]", line) for word in ("figure", "output"))
        if figure:
            shown = re.search(rf"^.*\]\({re.escape(figure[1])}\.svg\).*$", self.lesson, re.M)
            return shown[0] if shown else f"![]({figure[1]}.svg)"
        if output:
            section = re.search(rf"^{re.escape(output[1])}.*?(?=\n*\Z|\n\n)", self.output, re.M | re.S)
            return section[0] if section else \
                self.wrong(number, f"the program prints no line that begins with '{output[1]}'")
        return re.sub(r"\[\[(.*?)\]\]", lambda found: self.number(found[1], number), line)

    def fill(self):
        lines = Path(self.source).read_text(encoding="utf-8").splitlines()
        text = "".join(self.filled(line, number) + "\n" for number, line in enumerate(lines, 1))
        self.errors += [f"{self.source}: does not use the number '{name}'" for name in self.numbers if name not in self.used]
        return in_formulas(text)


def main():
    lesson = Lesson(*sys.argv[1:5], marked=sys.argv[5:] == ["marked"])
    sys.stdout.write(lesson.fill())
    print("\n".join(lesson.errors), file=sys.stderr, end="\n" * bool(lesson.errors))
    return 1 if lesson.errors else 0


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.exit(main())
