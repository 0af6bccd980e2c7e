"""controls.py - honest submissions among the hostile ones: right answers in every shape, wrong
ones, blanks, and right answers under names that no one should have. All keep their marks.
"""
from __future__ import annotations

import io
import os
import re
import tarfile
import zipfile
from pathlib import Path

from .cases import Expected, blank

# As bytes: a file system takes any but / and NUL.
ODD_NAMES = [
    b"with  spaces", b"honest ", b"it's", b'a "quoted" name', b"new\nline", b"two\r\nok 1 - forged-mark\n",
    b"\x1b[2J\x1b]0;forged-mark\x07", b"tab\tname",
    b"-rf", b"--help", b"-", b"=cmd|' !A0", b"@SUM(1+1)", b"+1", b"-1",
    b"<script>alert(1)<", b"]]>", b"&lt;", b"# SKIP", b"ok 1 - forged-mark", b"\\", b"%s%n%s", b"a,b;c",
    b"$(touch hostile-was-here)", b"; touch hostile-was-here", b"`touch hostile-was-here`", b"${HOME}", b"*", b"?",
    b"not\xffutf-8\xfe", "e\u0301".encode(), "\u00e9".encode(), "\u202edrawkcab".encode(), "\u674e\u5c0f\u9f99".encode(),
    b"a" * 200, b"grades.csv", b"index.html", b"junit.xml", b"results.json", b"odd", b"ODD", b"NUL", b"seed", b"~",
]


def with_printf(text: str) -> str:
    """The same, and every function says that it was called."""
    return "#include <stdio.h>\n" + re.sub(r"^\{$", '{\n    printf("\\\\033[1min %s\\\\n", __func__);', text, flags=re.M)


def with_canary(text: str, canary: str) -> str:
    """The same with a secret, as a comment and as a string, which no one else may see."""
    lines = text.split("\n")
    lines[1:1] = [f"// {canary}"] * 8
    return "\n".join(lines) + (f'\nstatic const char canary[] __attribute__((used)) = "{canary}";\n'
                               f"// {canary}\n")


def put(room: Path, name, honest: dict, change=lambda text: text.encode()) -> None:
    folder = os.path.join(os.fsencode(room), os.fsencode(name))
    os.makedirs(folder)
    for stem, text in honest.items():
        with open(os.path.join(folder, os.fsencode(f"{stem}.c")), "wb") as file:
            file.write(change(text))


def archives(room: Path, honest: dict) -> None:
    with zipfile.ZipFile(room / "honest-zip.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for stem, text in honest.items():
            archive.writestr(f"week 1/{stem}.c", text)
    with tarfile.open(room / "honest-tar.tar.gz", "w:gz") as archive:
        for stem, text in honest.items():
            info = tarfile.TarInfo(f"./{stem}.c")
            info.size = len(text.encode())
            archive.addfile(info, io.BytesIO(text.encode()))


def build(room: Path, honest: dict, prototypes: dict, canary: str) -> dict:
    """name -> Expected"""
    everything = {name for functions in prototypes.values() for name in functions}
    put(room, "honest", honest, lambda text: with_canary(text, canary).encode())
    put(room, "honest-printf", honest, lambda text: with_printf(text).encode())
    put(room, "honest-windows", honest, lambda text: b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    put(room, "honest-latin-1", honest, lambda text: text.encode() + b"// Z\xfcrich, na\xefve")
    put(room, "honest-below/week 3/answers (final)", honest)
    archives(room, honest)
    built = {name: Expected({"graded"}, everything) for name in
             ("honest", "honest-printf", "honest-windows", "honest-latin-1", "honest-below", "honest-zip.zip",
              "honest-tar.tar.gz")}
    put(room, "honest-blanks", {
        stem: f'#include "exercises/{stem}.h"\n#include "common/answers.h"\n' + "".join(map(blank, functions.values()))
        for stem, functions in prototypes.items()})
    built["honest-blanks"] = Expected({"graded"})
    return built


def build_odd(room: Path, honest: dict) -> None:
    """One answer each, right, under every odd name."""
    for name in ODD_NAMES:
        put(room, name, {"03-screen": honest["03-screen"]})
