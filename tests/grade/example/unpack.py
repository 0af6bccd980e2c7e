"""unpack.py - lays the files of class.txt into a folder: unpack.py class.txt FOLDER."""
import re
import sys
from pathlib import Path

text, folder = Path(sys.argv[1]).read_bytes().decode(), Path(sys.argv[2])
for name, words in re.findall(r"^==== (.*)\n((?:(?!==== ).*\n)*)", text, re.M):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(words.encode())
