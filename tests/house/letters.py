"""letters.py - the verdicts, the hints and the lesson of a chapter use the same letters (tests/house/lessons.sh).

    letters.py NN-stem

Prints each letter that a verdict or a hint has and the lesson never introduces, with the sentence; then fails.
A lesson introduces a letter in a formula, as code, or in the words of a figure. The letters x, y and z are also the axes.
"""
import re
import sys
from pathlib import Path

LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
NAME = re.compile(r"[A-Z][A-Z0-9]*(-.*)?")   # of a mistake: Q2, C-half
# What has single letters that are not those of a formula: %s, 1e-9, ray.h, "in C", "C divides", "a hit".
OTHER = re.compile(r"%[-.\d]*[a-z]|\de-?\d|\w\.h\b|\b[Ii]n C\b|\bC (?=[a-z]{3})|\b[Aa] (?=[a-z\d]{2})")
LETTER = re.compile(r"(?<![A-Za-z_'])(?:[A-Za-z]|ac|tv)(?![\w'])")   # 2r and 4ac have some, a word has none
MATH = re.compile(r"```math\n(.*?)```|\$(.+?)\$|`(\w)`|^!\[(.*?)\]\(", re.DOTALL | re.MULTILINE)
NO_LETTERS = re.compile(r"\\[a-z]+(\{[a-z ]+\})?|_\w|[A-Za-z]{3,}")   # \mathrm{sign}, k_s, IoR


def sentences_of(stem):
    """What a student may read: all about known mistakes, laws, hints."""
    for name in ("wrong.c", "laws.c"):
        code = re.sub(r"^\s*(#\s*include|//).*$", "", Path("tests", stem, name).read_text("utf-8"), flags=re.MULTILINE)
        for literal in LITERALS.findall(code):
            text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literal))
            if not NAME.fullmatch(text):
                yield text
    for hint in re.split(r"\n(?=- )|\n\n", Path("exercises", f"{stem}.hints").read_text("utf-8")):
        yield " ".join(hint.split())


def letters_of_lesson(stem):
    found = set("xyz")
    for block, inline, code, words in MATH.findall(Path("chapters", stem, "README.md").read_text("utf-8")):
        found.update(NO_LETTERS.sub(" ", block + inline), code, "".join(LETTER.findall(words)))
    return found


def main(stem):
    known, missing = letters_of_lesson(stem), {}
    for sentence in sentences_of(stem):
        for letter in "".join(LETTER.findall(OTHER.sub(" ", sentence))):
            if letter not in known:
                missing.setdefault(letter, sentence)
    for letter, sentence in missing.items():
        print(f"{letter}: {sentence}")
    return 1 if missing else 0


sys.exit(main(*sys.argv[1:]))
