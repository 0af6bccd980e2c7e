"""test_submissions.py - what is a submission, what it is called, when it has changed; and what learning platforms
export, as they export it.
"""
import gzip
import os
import socket
import unicodedata
import unittest
from types import SimpleNamespace
from unittest import mock

from grade.collect import archives, names, submissions
from grade.visible import brief, spelled
from .fixtures import FIVE, ONE, STEMS, Scratch, locked, tarred, zipped


class Visible(unittest.TestCase):
    def test_plain_names_stay_and_what_moves_or_hides_text_is_escaped(self):
        for name in ("anna", "Zoë Müller-Łukasz", "李小龙", "week 3/05-quadratic.c", "-rf", "it's \"so\""):
            self.assertEqual(spelled(name), name)
        for raw, shown in ((b"a\nb", "a\\nb"), (b"\x1b[2J", "\\x1b[2J"), (b"\xff", "\\udcff"),
                           ("a\u202eb".encode(), "a\\u202eb"), ("\u2066".encode(), "\\u2066"),
                           ("\u200b".encode(), "\\u200b"), ("\u2028".encode(), "\\u2028"),
                           ("\u3164".encode(), "\\u3164"), (b"\x7f", "\\x7f"),
                           ("\U000e0041".encode(), "\\U000e0041"), (b"\r\t", "\\r\\t"),
                           (b" a  b ", "\\x20a \\x20b\\x20"), (b"a\\nb", "a\\\\nb")):
            self.assertEqual(spelled(names.decoded(raw)), shown)

    def test_no_two_names_are_shown_alike(self):
        alphabet = [b"\\", b"n", b"\n", b" ", b"\xc3\xa9", b"e\xcc\x81", b"\xff", b"x20"]
        raws = {a + b + c for a in alphabet for b in alphabet for c in alphabet}
        self.assertEqual(len(set(names.shown(sorted(raws)))), len(raws))
        self.assertEqual(names.shown(["é".encode(), "e\u0301".encode(), "ö".encode()]), ["\\xe9", "e\\u0301", "ö"])

    def test_a_long_text_keeps_its_ends(self):
        cut = brief("a" * 500 + "b" * 500)
        self.assertEqual((len(cut), cut[0], cut[-1]), (160, "a", "b"))


class Folders(unittest.TestCase):
    def folders(self, *entries):
        suffixes = {"zip": 4, "gz": 7}
        return names.folders([(raw if isinstance(raw, bytes) else raw.encode(),
                               suffixes.get(str(raw).rsplit(".")[-1], 0)) for raw in entries])

    def test_each_has_its_name_without_the_suffix_unless_that_is_taken(self):
        for entries, wanted in ((("anna.zip", "bob.tar.gz", "carl"), ["anna", "bob", "carl"]),
                                (("anna", "anna.zip"), ["anna", "anna.zip"]),
                                (("anna.tar.gz", "anna.zip"), ["anna.tar.gz", "anna.zip"]),
                                (("index.html.zip",), ["index.html.zip"])):
            self.assertEqual(self.folders(*entries), wanted)
        for name in ("-rf", " a b ", "a\nb", "it's \"so\"", "李小龙", "..a"[2:] + "..", "=1+1"):
            self.assertEqual(self.folders(name), [name])

    def test_no_folder_is_hidden_leads_elsewhere_is_long_or_takes_the_name_of_a_report(self):
        for name in (".", "..", "..zip", ".zip", ".git", "...", "..tar.gz", "grades.csv", "JUnit.XML",
                     "index.html", "ｉndex.html", "figures", "Figures.zip", "x" * 255, "é" * 127, "x" * 251 + ".zip", b"\xff" * 255):
            folder, = self.folders(name)
            self.assertFalse(folder.startswith(".") or folder == "" or "/" in folder or len(folder.encode()) > 200, folder)
            self.assertNotIn(folder.lower(), ("grades.csv", "junit.xml", "index.html", "figures"))
        self.assertTrue(self.folders("x" * 255)[0].startswith("x" * 180))

    def test_no_two_folders_are_one_where_case_and_coding_are_ignored(self):
        entries = ["anna", "ANNA", "Anna.zip", "anna.zip.zip", "é", "e\u0301", "É", "straße",
                   "STRASSE", "anna.ZIP", b"a\xff", "a%FF", "x" * 250, "x" * 251, "é" * 120]
        for _ in range(3):  # and somebody who knows what the others become
            entries = list(dict.fromkeys([*entries, *self.folders(*entries)]))
        folders = self.folders(*entries)
        self.assertEqual(len({unicodedata.normalize("NFD", folder.casefold()) for folder in folders}), len(entries))

    def test_a_name_depends_on_no_other_and_no_order(self):
        entries = ["anna", "ANNA", "bob.zip", "carl"]
        self.assertEqual(self.folders(*entries), self.folders(*entries[::-1])[::-1])
        self.assertEqual(self.folders("bob.zip"), self.folders(*entries)[2:3])


class Find(Scratch):
    def test_folders_and_archives_are_submissions_in_the_order_of_their_bytes(self):
        self.lay({**{f"{name}/": b"" for name in ("b", "B", "é", "-rf", "a b")},
                  **{name: b"" for name in ("c.zip", "d.tar.gz", "e.tgz", "f.tar", "g.ZIP")}})
        found, others = submissions.find(self.room)
        self.assertEqual([s.name for s in found],
                         ["-rf", "B", "a b", "b", "c.zip", "d.tar.gz", "e.tgz", "f.tar", "g.ZIP", "é"])
        self.assertEqual([s.folder for s in found], ["-rf", "B~" + found[1].folder[2:], "a b",
                         found[3].folder, "c", "d", "e", "f", "g", "é"])
        self.assertEqual([s.kind for s in found if s.name[1:2] == "."], ["archive"] * 5)
        self.assertEqual(others, [])

    def test_what_nobody_hands_in_is_named(self):
        clutter = [".DS_Store", "Read me.txt", "Thumbs.db", "desktop.ini", "gradebook.csv", "readme.md",
                   "submission_metadata.yml", FIVE]
        self.lay({**{name: b"" for name in clutter}, ".git/": b"", "__MACOSX/": b""})
        self.assertEqual(submissions.find(self.room, STEMS), ([], sorted([*clutter, ".git", "__MACOSX"])))

    def test_whoever_handed_in_anything_is_there(self):
        loose = [*(f"{name}.{kind}" for name in "abcdefgh" for kind in ("pdf", "docx", "c", "txt", "rar")), "e\nvil.c"]
        self.lay({**{name: b"" for name in loose}, "readme.d/": b""})
        os.mkfifo(self.room / "pipe.zip")
        with socket.socket(socket.AF_UNIX) as listening:
            listening.bind(str(self.room / "socket"))
        found, others = submissions.find(self.room, STEMS)
        self.assertEqual([s.name for s in found],
                         [name.replace("\n", "\\n") for name in sorted([*loose, "readme.d", "pipe.zip", "socket"])])
        self.assertEqual(others, [])
        for submission in found:
            collected = submissions.collect(submission, STEMS)
            self.assertTrue(collected.empty and collected.words, submission)

    def test_names_of_any_bytes_have_one_result_each(self):
        for name in (b"\xff", b"\xfe\n", b"a\nb", b"\x1b]0;x\x07", b"=1+1", b"%41", b"x" * 255):
            os.mkdir(os.path.join(os.fsencode(self.room), name))
        found, _ = submissions.find(self.room)
        self.assertEqual((len({s.name for s in found}), len({s.folder for s in found})), (7, 7))
        self.assertIn("a\\nb", [s.name for s in found])
        for submission in found:
            self.assertTrue(submissions.collect(submission, STEMS).empty)

    def test_what_cannot_even_be_asked_is_a_submission_too(self):
        def fails():
            raise OSError(5, "Input/output error")
        words = "cannot be read: Input/output error"
        self.assertEqual(submissions.kind_of(SimpleNamespace(is_symlink=fails)), ("unreadable", words))
        collected = submissions.collect(submissions.Submission(
            "anna", "anna", (submissions.Part(b"/nowhere", "unreadable", words=words),)), STEMS)
        self.assertEqual((collected.empty, collected.words), (True, words))

    def test_a_link_is_empty_and_not_followed(self):
        (self.room / "anna").symlink_to(self.secret(FIVE).parent)
        collected = self.collect()
        self.assertEqual((collected.empty, collected.words, collected.answers["05-quadratic"].text),
                         (True, "a symbolic link, not followed", b""))

    def test_a_folder_that_became_a_link_or_is_gone_is_not_followed(self):
        self.put(FIVE)
        found, _ = submissions.find(self.room)
        os.rename(self.room / "anna", self.work / "moved")
        (self.room / "anna").symlink_to(self.work / "moved")
        collected = submissions.collect(found[0], STEMS)
        self.assertTrue(collected.empty)
        self.assertIn("cannot be read", collected.words)
        os.unlink(self.room / "anna")
        self.assertIn("cannot be read: No such file", submissions.collect(found[0], STEMS).words)


class Read(Scratch):
    """Whether a submission could be read at all: if not, it has no score."""
    ZIP = zipped((ONE, b"x"), (FIVE, b"y"))
    NO_ZIP = "the archive is broken: File is not a zip file"
    LOOSE = "a loose file, and neither a folder nor an archive"
    NONE = "holds no 01-corners.c ... 05-quadratic.c"

    def test_what_cannot_be_read_says_so_and_why(self):
        for files, status, words in (
                ({"anna.zip": b"no archive"}, "cannot be read", self.NO_ZIP),
                ({"anna.zip": self.ZIP[:-30]}, "cannot be read", self.NO_ZIP),
                ({"anna.zip": b"%PDF-1.7\n"}, "cannot be read", self.NO_ZIP),
                ({"anna.pdf": b"%PDF-1.7\n"}, "cannot be read", self.LOOSE),
                ({"anna.docx": self.ZIP}, "cannot be read", self.LOOSE),
                ({"anna.zip": zipped(("word/document.xml", b"x"), ("img.png", b"x"))},
                 "cannot be read", f"{self.NONE}, only word/document.xml, img.png"),
                ({"doe_1_2_report.pdf": b"%PDF-1.7\n"}, "cannot be read", f"{self.NONE}, only report.pdf"),
                ({"Doe_1_assignsubmission_file_/=a.docx": b"x"}, "cannot be read", f"{self.NONE}, only =a.docx"),
                ({"anna/02_cameras.c": b"x"}, "cannot be read", f"{self.NONE}, only 02_cameras.c"),
                ({"anna/5-quadratic.c": b"x"}, "cannot be read",
                 "there is 5-quadratic.c; the name must be 05-quadratic.c"),
                ({"anna/05-quadratic.c": b"\0"}, "cannot be read", "05-quadratic.c is not text"),
                ({"xaver.zip": locked(self.ZIP)}, "cannot be read",
                 "01-corners.c cannot be read: it is encrypted; and 1 more like this"),
                ({"anna/week 1/": b"", "anna/README.md": b"x", "anna/.DS_Store": b"x"}, "empty", self.NONE),
                ({f"anna/{ONE}": b"x"}, "", ""),
                ({f"anna/{ONE}": b"x", "anna/all.zip": b"no archive"}, "partly read", f"all.zip: {self.NO_ZIP}"),
                ({f"anna/{ONE}": b"x", f"anna/{FIVE}": b"x", "anna/all.zip": b"no archive"}, "",
                 f"all.zip: {self.NO_ZIP}"),
                ({f"anna/{ONE}": b"x", f"anna/{FIVE}": b"\0"}, "partly read", "05-quadratic.c is not text"),
                ({"zoe_506_9039_submission.zip": self.ZIP, "zoe_506_9040_submission-1.zip": b"cut off"},
                 "partly read", self.NO_ZIP),
                ({"zoe_506_9039_submission.zip": self.ZIP, "zoe_506_9040_submission-1.zip": b"cut off",
                  "zoe_506_9041_submission-2.zip": self.ZIP}, "", self.NO_ZIP)):
            with self.subTest(f"{list(files)} is {status or 'read'}: {words}"):
                self.clear()
                self.lay(files)
                collected = self.collect()
                self.assertEqual((collected.status, collected.words), (status, words))


class Digest(Scratch):
    def test_it_changes_with_every_byte_and_chapter_and_with_nothing_else(self):
        self.put(FIVE, b"int a;")
        first = submissions.digest(self.collect())
        self.put("notes.txt", b"x")
        os.utime(self.room / "anna" / FIVE, (0, 0))
        self.assertEqual(submissions.digest(self.collect()), first)
        self.put(FIVE, b"int b;")
        self.assertNotEqual(submissions.digest(self.collect()), first)
        self.put(FIVE, b"int a;")
        os.rename(self.room / "anna" / FIVE, self.room / "anna" / ONE)
        self.assertNotEqual(submissions.digest(self.collect()), first)


def packed(one=None, five=None) -> bytes:
    """A zip with these answers."""
    return zipped(*[(name, text) for name, text in ((ONE, one), (FIVE, five)) if text is not None])


METADATA = """---
submission_1001:
  :submitters:
  - :name: Jane Doe
    :sid: '42'
    :email: jane@example.org
  - :name: 'O''Neill, Zoë'
    :sid: '43'
  :created_at: 2025-11-03 09:12:44.000000000 Z
  :score: 0.0
  :history:
  - :id: 7
    :name: nobody
submission_1002:
  :submitters:
  - :name: Jane Doe (submission_1003)
  :score: 1.0
"""

# A sentence, the files of a class, and of each submission the texts of its answers to 01 and 05.
EXPORTS = [
    ("Canvas: one that was only handed in again counts",
     {"doejane_123_456_05-quadratic-1.c": b"x"}, {"doejane_123": [b"", b"x"]}),
    ("Canvas: archives count with loose files",
     {"doejane_123_456_all.zip": packed(b"old", b"x"), f"doejane_123_457_{ONE}": b"new",
      "roejohn_124_458_submission-1.zip": packed(five=b"y")},
     {"doejane_123": [b"new", b"x"], "roejohn_124": [b"", b"y"]}),
    # Two answers that differ were "2 files are called 05-quadratic.c", and lost the chapter's marks.
    ("Canvas: of two archives the last upload counts, also beside somebody else's file",
     {"zoe_506_9039_submission.zip": packed(b"same", b"first"), "zoe_LATE_506_9040_submission-1.zip": packed(b"same", b"last"),
      f"doejane_123_456_{FIVE}": b"x"}, {"doejane_123": [b"", b"x"], "zoe_506": [b"same", b"last"]}),
    *[("Canvas: the platform's number says which is the last",
       {f"b_2_5000_{ONE}": b"b", first: packed(b"kept", b"first"), last: zipped(("mine/" + FIVE, b"last"))},
       {"a_1": [b"kept", b"last"], "b_2": [b"b", b""]})
      for first, last in (("a_1_9_hw.zip", "a_LATE_1_10_fixed.zip"), ("a_1_99_hw-1.tar.gz", "a_1_100_hw.tar.gz"),
                          ("a_1_7_hw-2.zip", "a_1_8_hw-1.zip"))],
    ("Canvas: an archive after a loose file counts",
     {f"doejane_123_456_{FIVE}": b"first", "doejane_123_457_all.zip": packed(five=b"last")},
     {"doejane_123": [b"", b"last"]}),
    *[("Canvas: names that only look alike stay apart", {name: packed(five=b"x") for name in names},
       {name: [b"", b"x"] for name in names})
      for names in (("week_1_2_anna.zip", "week_1_2_ben.zip"), ("ws_2025_1_anna.zip", "ws_2025_2_ben.zip"),
                    ("a_1_2_x.zip", "b_1_3_x.zip"))],
    ("Canvas: a name that only looks alike spoils nobody else",
     {f"doejane_123_456_{ONE}": b"x", f"doejane_123_457_{FIVE}": b"x", "week_1_2_anna.c": b"x", "week_1_2_ben.c": b"x"},
     {"doejane_123": [b"x", b"x"], "week_1_2_anna.c": [b"", b""], "week_1_2_ben.c": [b"", b""]}),
    ("Moodle: a folder with files or an archive is a submission",
     {f"Jane Doe_123_assignsubmission_file_/{FIVE}": b"x",
      "Jörg Roe_124_assignsubmission_file_/mine.zip": zipped(("a/" + FIVE, b"y")),
      "Zoë Poe_125_assignsubmission_file/all.zip": zipped(("inner.zip", packed(b"z")))},
     {"Jane Doe_123": [b"", b"x"], "Jörg Roe_124": [b"", b"y"], "Zoë Poe_125": [b"z", b""]}),
    ("Moodle: text and files of one person are one submission",
     {"Jane Doe_123_assignsubmission_onlinetext_/onlinetext.html": b"", f"Jane Doe_123_assignsubmission_file_/{FIVE}": b"x",
      "Joe Roe_124_assignsubmission_onlinetext_/onlinetext.html": b""},
     {"Jane Doe_123": [b"", b"x"], "Joe Roe_124": [b"", b""]}),
    ("Moodle: loose files belong to their participant",
     {f"Jane Doe_123_assignsubmission_file_{ONE}": b"x", f"Jane Doe_123_assignsubmission_file_{FIVE}": b"y",
      "Joe_Roe_124_assignsubmission_file_all.zip": packed(five=b"z")},
     {"Jane Doe_123": [b"x", b"y"], "Joe_Roe_124": [b"", b"z"]}),
    ("Gradescope: folders have the names of their people",
     {"submission_metadata.yml": METADATA.encode(),
      **{f"submission_{number}/{FIVE}": b"%d" % number for number in (1001, 1002, 1003)}},
     {"Jane Doe, O'Neill, Zoë (submission_1001)": [b"", b"1001"],
      "Jane Doe (submission_1003) (submission_1002)": [b"", b"1002"], "submission_1003": [b"", b"1003"]}),
    ("Gradescope: no name is anybody else's",
     {f"submission_1/{FIVE}": b"x", f"Ann (submission_1)/{FIVE}": b"x",
      "submission_metadata.yml": b"submission_1:\n  :submitters:\n  - :name: Ann\n"},
     {"submission_1": [b"", b"x"], "Ann (submission_1)": [b"", b"x"]}),
    ("Gradescope: a list that is noise is not a list",
     {f"submission_1/{FIVE}": b"x", "submission_metadata.yml": os.urandom(5000)}, {"submission_1": [b"", b"x"]}),
]

# A copy of the toolkit or of the handout, of which exercises/ counts.
ELSEWHERE = ["solutions", "tests/blanks", "tests/05-quadratic", "tests", "build/blanks", "build/x/y", "chapters",
             ".make", "common"]


def copy_of_toolkit(top="", exercises=(FIVE,)) -> list:
    return [*((f"{top}{place}/{FIVE}", place.encode()) for place in ELSEWHERE),
            (f"{top}build/submission.zip", packed(five=b"old")), (f"{top}Makefile", b""),
            (f"{top}exercises/05-quadratic.h", b""), *((f"{top}exercises/{name}", b"mine") for name in exercises)]


def in_folder(members) -> dict:
    return {f"anna/{name}": content for name, content in members}


MINE = [b"", b"mine"]
EXPORTS += [
    *[("a copy of the toolkit is read, as a folder", in_folder(copy_of_toolkit(top)), {"anna": MINE})
      for top in ("", "ray-casting/", "week 3/ray-casting/")],
    *[("a copy of the toolkit is read, as an archive in any order", {name: pack(*members[::step])}, {name: MINE})
      for members in (copy_of_toolkit(), copy_of_toolkit("ray-casting/")) for step in (1, -1)
      for name, pack in (("anna.zip", zipped), ("anna.tar.gz", lambda *m: gzip.compress(tarred(*m))))],
    ("a copy of the toolkit is read, as an archive in a folder",
     {"Jane_1_assignsubmission_file_/x.zip": zipped(*copy_of_toolkit("ray-casting/"))}, {"Jane_1": MINE}),
    ("an answer that is missing in exercises/ is not taken from elsewhere", in_folder(copy_of_toolkit(exercises=())),
     {"anna": [b"", b""]}),
    ("a folder of one's own beside exercises/ is not passed over",
     in_folder([*copy_of_toolkit(), (f"mine/{FIVE}", b"other")]), {"anna": [b"", b""]}),
    ("folders of these names without exercises/ are folders",
     {f"{name.replace('/', '-')}/{name}/{FIVE}": b"x" for name in ("solutions", "tests", "build/mine", "chapters/common")},
     {name: [b"", b"x"] for name in ("solutions", "tests", "build-mine", "chapters-common")}),
]


class Exports(Scratch):
    def all(self) -> dict:
        """name -> its answers' texts, in the order of the chapters"""
        found, others = submissions.find(self.room, STEMS)
        self.assertEqual(others, [name for name in ("submission_metadata.yml",) if (self.room / name).exists()])
        self.assertEqual(len({s.folder for s in found}), len(found))
        return {s.name: [answer.text for answer in submissions.collect(s, STEMS).answers.values()] for s in found}

    def test_each_submission_has_its_answers(self):
        for sentence, files, wanted in EXPORTS:
            with self.subTest(sentence):
                self.clear()
                self.lay(files)
                self.assertEqual(self.all(), wanted)

    def test_a_link_among_loose_files_is_not_followed(self):
        (self.room / f"doejane_123_456_{FIVE}").symlink_to(self.secret("secret"))
        self.assertEqual(self.all(), {f"doejane_123_456_{FIVE}": [b"", b""]})

    def test_gradescope_s_list_is_not_followed_as_a_link_and_names_no_folder(self):
        self.lay({f"submission_1001/{FIVE}": b"x", "submission_metadata.yml": METADATA.encode()})
        self.assertEqual([s.folder for s in submissions.find(self.room)[0]], ["submission_1001"])
        (self.room / "submission_metadata.yml").unlink()
        (self.room / "submission_metadata.yml").symlink_to("/dev/zero")
        self.assertEqual(self.all(), {"submission_1001": [b"", b"x"]})

    def test_copies_have_no_words_and_may_be_large(self):
        self.lay(in_folder(copy_of_toolkit()))
        self.assertEqual(self.answer().words, "")
        self.lay({f"anna/{place}/{i}{name}": b"int a;\n" for i in range(300)
                  for place, name in (("build", "/" + FIVE), (".git/objects", ""))})
        with mock.patch.object(archives, "ENTRIES", 100):
            self.assertEqual((self.answer().text, self.collect().words), (b"mine", ""))
        self.put(f"mine/{FIVE}", b"other")
        self.assertEqual(self.answer().state, "twice")
