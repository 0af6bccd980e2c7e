"""verdicts.py - the verdicts on chapters, kept by what they depend on: the chapter's text, the seed, and all that judges.

So an unchanged chapter of a submission that was handed in again, and a blank, are not judged twice. An answer is judged
with the reference for all other chapters: its own text is all that counts. Its object file is kept as well,
because the picture is drawn by all chapters together.
"""
from __future__ import annotations

import hashlib
import json
import shutil
from dataclasses import dataclass
from pathlib import Path

from grade.report import files


@dataclass(frozen=True)
class Verdict:
    state: str              # judged, does not compile, cannot be linked
    words: str              # of the compiler or the linker
    functions: list         # without marks
    object: bytes = b""     # none, if it is no program


class Verdicts:
    def __init__(self, folder: Path, circumstances: str, again: frozenset = frozenset()):
        """circumstances: changes with everything that judges. again: chapters that are judged though there is a verdict."""
        self.top, self.folder, self.again = folder, folder / circumstances[:16], again

    def begin(self) -> None:
        """Those of other circumstances are of no more use."""
        self.folder.mkdir(parents=True, exist_ok=True)
        for other in self.top.iterdir():
            if other != self.folder:
                shutil.rmtree(other, ignore_errors=True)
        files.clear(str(self.folder))

    def name(self, stem: str, text: bytes) -> str:
        return f"{stem}-{hashlib.sha256(text).hexdigest()}"

    def find(self, stem: str, text: bytes) -> Verdict | None:
        if stem in self.again:
            return None
        name = self.name(stem, text)
        try:
            kept = json.loads((self.folder / f"{name}.json").read_text(encoding="utf-8"))
            return Verdict(kept["state"], kept["words"], kept["functions"],
                           (self.folder / f"{name}.o").read_bytes() if kept["state"] == "judged" else b"")
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def keep(self, stem: str, text: bytes, verdict: Verdict) -> None:
        """The object first: where the verdict is, all is."""
        name = self.name(stem, text)
        if verdict.state == "judged":
            files.put(str(self.folder), f"{name}.o", verdict.object)
        words = {"state": verdict.state, "words": verdict.words, "functions": verdict.functions}
        files.put(str(self.folder), f"{name}.json", json.dumps(words))
