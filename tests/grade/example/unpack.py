"""unpack.py - lays the files of class.txt into a folder: unpack.py FOLDER."""
import re
import sys
from pathlib import Path

from grade import exercises
from grade.shorthand import answer

prototypes = exercises.prototypes(exercises.read())
text = Path(__file__).with_name("class.txt").read_text(encoding="utf-8")
for name, windows, words in re.findall(r"^==== (.*?\.c)(, with Windows' line ends)?\n((?:(?!==== ).*\n)*)", text, re.M):
    path = Path(sys.argv[1], name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(answer(path.stem, words, prototypes[path.stem]), newline="\r\n" if windows else "\n")
