"""class.py - a class to measure grading with: class.py FOLDER COUNT

Submissions of six files, no two the same: two thirds of the files are right, the others have a sign or a
number changed, lack a function, or are blank, as half a class's are.
"""
import random
import re
import sys
from pathlib import Path


def body_spans(text: str) -> list[tuple[int, int]]:
    return [match.span(1) for match in re.finditer(r"// BEGIN SOLUTION\n(.*?)// END SOLUTION", text, re.S)]


def slipped(text: str, chance: random.Random) -> str:
    """One sign or number of one answer is another."""
    start, end = chance.choice(body_spans(text))
    places = [m for m in re.finditer(r"(?<= )[-+*](?= )|\b[0-9]+(?:\.[0-9]+)?\b", text[start:end])]
    if not places:
        return text
    place = chance.choice(places)
    new = {"-": "+", "+": "-", "*": "+"}.get(place[0]) or f"{float(place[0]) + 1:g}"
    return text[:start + place.start()] + new + text[start + place.end():]


def main(folder: Path, count: int) -> None:
    chance = random.Random(2015)
    solutions = sorted(Path("solutions").glob("*.c"))
    for n in range(count):
        submission = folder / f"student-{n:04d}"
        submission.mkdir(parents=True)
        for path in solutions:
            text = path.read_text()
            kind = chance.random()
            if kind > 0.9:
                text = Path("build/blanks", path.name).read_text()
            elif kind > 0.67:
                text = slipped(text, chance)
            (submission / path.name).write_text(f"// {n}: {path.stem}\n{text}")


main(Path(sys.argv[1]), int(sys.argv[2]))
