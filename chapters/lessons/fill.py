"""fill.py - puts the numbers of the example into a lesson, in the place of those that are there.

    fill.py NUMBERS OUTPUT.txt README.md [marked]       from the top of the project

Prints the lesson README.md; its lines with numbers are in lines.txt. NUMBERS: the program that gives them. OUTPUT: what
the chapter's program prints. With 'marked', each number is between private characters, so that a page finds it
(chapters/book/site/lesson.mjs): U+E000 NAME U+E001 NUMBER U+E002. Numbers come as people write them; in formulas they
become LaTeX.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

LINES = Path("chapters/lessons/lines.txt")
FORMULA = re.compile(r"```math\n.*?^```|(```|~~~).*?^\1|`[^`\n]*`|\$[^$]*\$", re.MULTILINE | re.DOTALL)
PLAIN = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
NAME = re.compile(r"\[\[(.*?)\]\]")


def as_latex(formula):
    """The numbers of a formula: −10,000 is -10{,}000, and 1.2 · 10⁻⁶ is 1.2 \\cdot 10^{-6}."""
    formula = re.sub(r"(?<=\d),(?=\d{3})", "{,}", formula.replace("−", "-")).replace(" · 10", r" \cdot 10")
    return re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda raised: f"^{{{raised[0].translate(PLAIN)}}}", formula)


def in_formulas(text):
    return FORMULA.sub(lambda part: as_latex(part[0]) if part[0][0] == "$" or part[0].startswith("```math") else part[0], text)


class Lesson:
    def __init__(self, numbers, output, lesson, marked):
        self.numbers = json.loads(subprocess.run([numbers], stdout=subprocess.PIPE, check=True).stdout)
        self.path, self.marked, self.errors = Path(lesson), marked, []
        self.output, self.lesson = (Path(path).read_text(encoding="utf-8") for path in (output, lesson))

    def lines(self):
        """(number, line) of each line of this lesson that has numbers."""
        stem = ""
        for number, line in enumerate(LINES.read_text(encoding="utf-8").splitlines(), 1):
            if line.startswith("= "):
                stem = line[2:]
            elif line and stem == self.path.parent.name:
                yield number, line

    def wrong(self, number, words):
        self.errors.append(f"{LINES}:{number}: {words}")
        return ""

    def number(self, name, line):
        if name not in self.numbers:
            return self.wrong(line, f"no number has the name '{name}'")
        text = self.numbers[name]
        return f"\ue000{name}\ue001{text}\ue002" if self.marked else text

    @staticmethod
    def section(heading, text, begin=0):
        """Where a text has the lines below a heading, up to an empty line or the end of the block."""
        return re.compile(rf"^{re.escape(heading)}.*?(?=\n*\Z|\n\n|\n```)", re.M | re.S).search(text, begin)

    def new_line(self, line, number, begin):
        """Where the lesson has this line, and what it is now."""
        output = re.fullmatch(r"\[\[output (.*)\]\]", line)
        if output:
            printed = self.section(output[1], self.output)
            return self.section(output[1], self.lesson, begin), printed[0] if printed else \
                self.wrong(number, f"the program prints no line that begins with '{output[1]}'")
        pattern = ".*?".join(map(re.escape, NAME.split(line)[::2]))
        return re.compile(f"^{pattern}$", re.M).search(self.lesson, begin), \
            NAME.sub(lambda found: self.number(found[1], number), line)

    def fill(self):
        parts, end = [], 0
        for number, line in self.lines():
            place, new = self.new_line(line, number, end)
            if place:
                parts += [self.lesson[end:place.start()], new]
                end = place.end()
            else:
                self.wrong(number, f"{self.path} has no such line, or not in this order: change it in both")
        return in_formulas("".join(parts) + self.lesson[end:])


def main():
    lesson = Lesson(*sys.argv[1:4], marked=sys.argv[4:] == ["marked"])
    sys.stdout.write(lesson.fill())
    print("\n".join(lesson.errors), file=sys.stderr, end="\n" * bool(lesson.errors))
    return 1 if lesson.errors else 0


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.exit(main())
