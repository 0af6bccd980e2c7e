"""example_slides.py - a lecture of all slides that have numbers, once for each of several examples.

    example_slides.py LECTURE NUMBERS.json...    prints it: each with a picture, where the lecture has a figure
"""
import json
import re
import sys
from pathlib import Path

lecture, *examples = map(Path, sys.argv[1:])
first, *slides = re.split(r"^(?=={1,2} )", lecture.read_text(encoding="utf-8"), flags=re.M)
print(first, "== Examples\n= Examples\nname: examples", sep="")
for number, path in enumerate(examples):
    numbers = json.loads(path.read_text(encoding="utf-8"))
    for slide in slides:
        if "[[" in slide and "[[author]]" not in slide:
            slide = re.sub(r"^figure: \S+( \d+)?", "picture: chapters/06-ray-casting/sunflower.png", slide, flags=re.M)
            slide = re.sub(r"^(name: .*)", rf"\1-{number}", slide, flags=re.M)
            print(re.sub(r"\[\[(\w+)\]\]", lambda found: numbers[found[1]], slide))
