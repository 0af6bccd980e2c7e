"""test_grade.py - what the whole grader says of a small class, and that it is fair."""
from __future__ import annotations

import tempfile
from pathlib import Path

from .sentences import Sentences
from .small_class import STEMS, build_class, grade, records


def function(record: dict, name: str) -> dict:
    return next(f for stem in record["stems"] for f in stem["functions"] if f["name"] == name)


def score(record: dict, stem: str) -> tuple[float, float]:
    return next((s["score"], s["max"]) for s in record["stems"] if s["stem"] == stem)


def has_all(record: dict, stems: list[str]) -> bool:
    return all(score(record, stem)[0] == score(record, stem)[1] > 0 for stem in stems)


class Grade(Sentences):
    def says_what_is_right(self, found: dict[str, dict]) -> None:
        best = found["all right"]
        self.check("all right: all marks", best["score"] == best["max"] == 100, best)
        self.check("the status of what could be judged is graded", best["status"] == "graded", best["status"])
        self.check("files are found at any depth", has_all(found["deep"], STEMS[:2]), found["deep"])
        self.check("Windows line ends and a byte-order mark cost nothing",
                   has_all(found["from windows"], STEMS[:3]), found["from windows"])
        self.check("blanks earn nothing", found["blanks"]["score"] == 0, found["blanks"]["score"])
        one = function(found["one function"], "upper_right")
        self.check("functions that are missing are not answered",
                   one["state"] == "unanswered" and score(found["one function"], "01-corners") == (2, 10),
                   found["one function"]["stems"][0])

    def says_what_is_wrong(self, found: dict[str, dict]) -> None:
        mirrored, endless, crash = found["mirrored"], found["endless"], found["crash"]
        self.check("a known mistake is named", function(mirrored, "image_plane_vector")["mistake"] is not None)
        cost = score(mirrored, "01-corners")
        self.check("one mistake costs one function", cost == (8, 10), cost)
        self.check("an endless loop is 'timed out'", endless["status"] == "timed out", endless["status"])
        self.check("and costs its function only", score(endless, "01-corners") == (8, 10))
        self.check("a crash is 'crashed'", crash["status"] == "crashed", crash["status"])
        no_text = found["no text"]
        self.check("what does not compile says so, in the compiler's words",
                   no_text["status"] == "does not compile"
                   and "expected expression" in no_text["stems"][0]["words"], no_text["stems"][0])
        no_assembler = found["no assembler"]["stems"][0]["words"]
        self.check("the assembler's words are the same in every run and every sandbox",
                   "error" in no_assembler.lower() and "/" not in no_assembler, no_assembler)
        self.check("its other chapters have their marks", score(no_text, "03-screen") == (9, 9))
        self.check("two files of one name are reported, and the grader does not guess",
                   found["two of one name"]["stems"][0]["state"] == "twice")

    def knows_who_waits(self, found: dict[str, dict]) -> None:
        waits = function(found["waits"], "upper_right")
        self.check("what fails only for an earlier function has its marks",
                   (waits["state"], waits["score"], waits["waiting_for"]) == ("waiting", 2, ["upper_left"]), waits)
        across = function(found["mirrored"], "across_30_up_10")
        self.check("and so has a function that fails only for a later one that the reference also calls",
                   (across["state"], across["score"], across["waiting_for"]) == ("waiting", 2, ["image_plane_vector"]),
                   across)
        later = function(found["waits for a later one"], "upper_left")
        self.check("what calls another later one has none", (later["state"], later["score"]) == ("wrong", 0), later)
        both = [function(found["each other"], name)["score"] for name in ("upper_left", "upper_right")]
        self.check("two that wait for each other have none", both == [0, 0], both)

    def has_a_result_for_the_odd(self, found: dict[str, dict]) -> None:
        broken, zipped = found["broken"], found["zipped"]
        self.check("no file: empty", found["nothing"]["status"] == "empty")
        self.check("a broken archive is a result too", broken["status"] == "empty" and broken["words"] != "", broken)
        self.check("an archive is read; what would escape from it is not",
                   score(zipped, "04-pixel-ray")[0] > 0 and score(zipped, "03-screen")[0] == 0, zipped)

    def keeps_hidden_inputs(self, found: dict[str, dict]) -> None:
        hidden = [f for record in found.values() for stem in record["stems"]
                  for f in stem["functions"] if f["hidden"]]
        self.check("values of hidden inputs are in no record",
                   not any(f["given"] or f["expected"] or f["yours"] for f in hidden))

    def test_class(self) -> None:
        with tempfile.TemporaryDirectory() as work:
            folder, out = Path(work, "class"), Path(work, "out")
            build_class(folder)
            done = grade(folder, out)
            found = records(out)
        self.check("every submission has one result", done.returncode == 0 and len(found) == 18, done.stderr[-600:])
        self.check("a file that is not a submission is mentioned", "read me.txt" in done.stderr)
        self.check("nothing acts on the terminal", "\x1b" not in done.stdout + done.stderr)
        for tested in (self.says_what_is_right, self.says_what_is_wrong, self.knows_who_waits,
                       self.has_a_result_for_the_odd,
                       self.keeps_hidden_inputs):
            tested(found)
