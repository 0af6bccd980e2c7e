"""check_words.py - whether a copy of chapters/words.txt can be used: WORDS=FILE.

    check_words.py FILE

A text that no figure says, and words that lose a number, are named with their line. Exit status: 1 if there is one.
"""
import re
import sys
from pathlib import Path


def lines_of(path):
    """(number, line) of each line that is not empty and no comment."""
    lines = enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1)
    return [(number, line) for number, line in lines if line.strip() and not line.startswith("#")]


def places(text):
    """The numbers and names in a text: those with % have an order. And whether its mathematics ends."""
    return re.findall("%.", text), sorted(re.findall(r"\{[^}]*\}", text)), text.count("$") % 2


def faults(path):
    known, english = {line for _, line in lines_of("chapters/words.txt")}, None
    for number, line in lines_of(path):
        if not line[0].isspace():
            english = line.rstrip()
            if english not in known:
                yield number, f"'{english}': chapters/words.txt has no such text"
        elif english is None:
            yield number, "expected the English text first"
        else:
            if places(line) != places(english):
                yield number, f"expected the same numbers and names as in '{english}'"
            if re.search(r'["\\`]', line):
                yield number, 'expected words without ", \\ and `'
            english = None


def main(path):
    try:
        found = list(faults(path))
    except (OSError, UnicodeDecodeError) as error:
        sys.exit(f"WORDS={path}: {error.strerror if isinstance(error, OSError) else 'expected UTF-8'}")
    for number, fault in found:
        print(f"{path}:{number}: {fault}", file=sys.stderr)
    sys.exit(1 if found else 0)


main(sys.argv[1])
