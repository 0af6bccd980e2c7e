"""pack_submission.py - make submission: the answers of a folder in one archive, and what they lack.

    pack_submission.py ARCHIVE.zip ANSWERS BLANKS STEM...

Packs ANSWERS/STEM.c for each stem, and names the chapters that are missing or not answered. The exit status is 0 if
the archive was written, whatever its answers are. The same answers make the same bytes.
"""
import re
import sys
import zipfile
from pathlib import Path

LARGEST = 256 * 1024  # the grader reads no larger answer (tests/grade/collect/answers.py)


class CannotPack(Exception):
    """With a message."""


def blanks_in(text):
    """How many functions of a file are blank: each says so once (common/answers.h)."""
    return sum(len(re.findall(rb"\bNOT_ANSWERED", line.split(b"//")[0])) for line in text.split(b"\n"))


def like(folder, stem):
    """The newest file that may be the answer, by another name; as tests/course/show_verdicts.c finds it."""
    def letters(name):
        return re.sub("[^0-9a-z]", "", name.lower())
    files = [file for file in folder.iterdir() if file.name[0].isdigit() and letters(file.name).startswith(letters(stem))
             and file.suffix not in (".h", ".hints", ".o") and ".backup-" not in file.name and file.is_file()]
    return max(files, key=lambda file: file.stat().st_mtime).name if files else None


def read(path, blank):
    """The text of an answer, and what is to say of it; without a text, it is missing."""
    if not path.exists():
        other = path.parent.is_dir() and like(path.parent, path.stem)
        return None, f"missing: there is '{other}', rename it" if other else f"missing: there is no {path}"
    text = path.read_bytes()
    if len(text) > LARGEST:
        raise CannotPack(f"{path}: larger than {LARGEST // 1024} KB, which the grader does not read")
    left, asked = blanks_in(text), blanks_in(blank.read_bytes()) if blank.exists() else 0
    if left == 0:
        return text, ""
    return text, "still blank" if left >= asked else f"{left} of {asked} functions not answered yet"


def main():
    archive, answers, blanks = map(Path, sys.argv[1:4])
    packed, unfinished = {}, 0
    print(f"From {answers}/:")
    for name in (f"{stem}.c" for stem in sys.argv[4:]):
        text, words = read(answers / name, blanks / name)
        print(f"  {name:20} {words}".rstrip())
        unfinished += words != ""
        if text is not None:
            packed[name] = text
    if not packed:
        raise CannotPack("There is no answer to hand in.")
    new = archive.with_name(archive.name + ".new")
    with zipfile.ZipFile(new, "w") as file:
        for name, text in packed.items():
            member = zipfile.ZipInfo(name)  # of 1980, the earliest date that there is
            member.external_attr = 0o100644 << 16
            file.writestr(member, text)
    new.replace(archive)
    if unfinished:
        print(f"Not finished: {unfinished} of the chapters, see above.")
    print(f"Hand in this file: {archive} ({len(packed)} files)")


try:
    main()
except CannotPack as error:
    sys.exit(str(error))
except OSError as error:
    sys.exit(f"{error.filename}: {error.strerror}")
