"""test_submissions.py - what is a submission, what it is called, when it has changed; and what learning platforms
export, as they export it.
"""
import gzip
import os
import shutil
import socket
import unicodedata
import unittest
from types import SimpleNamespace
from unittest import mock

from grade.collect import folders, names, submissions
from grade.visible import brief, spelled
from .fixtures import FIVE, STEMS, Scratch, tarred, zipped


class Visible(unittest.TestCase):
    def test_plain_names_stay_as_they_are(self):
        for name in ("anna", "Zoë Müller-Łukasz", "李小龙", "week 3/05-quadratic.c", "-rf",
                     "it's \"so\""):
            self.assertEqual(spelled(name), name)

    def test_what_moves_or_hides_text_is_escaped(self):
        for raw, shown in ((b"a\nb", "a\\nb"), (b"\x1b[2J", "\\x1b[2J"), (b"\xff", "\\udcff"),
                           ("a\u202eb".encode(), "a\\u202eb"), ("\u2066".encode(), "\\u2066"),
                           ("\u200b".encode(), "\\u200b"), ("\u2028".encode(), "\\u2028"),
                           ("\u3164".encode(), "\\u3164"), (b"\x7f", "\\x7f"),
                           ("\U000e0041".encode(), "\\U000e0041"), (b"\r\t", "\\r\\t")):
            self.assertEqual(spelled(names.decoded(raw)), shown)

    def test_spaces_that_a_reader_would_lose_are_escaped(self):
        self.assertEqual(spelled(" a  b "), "\\x20a \\x20b\\x20")

    def test_what_looks_like_an_escape_is_not_one(self):
        self.assertEqual(spelled("a\\nb"), "a\\\\nb")

    def test_no_two_short_names_are_shown_alike(self):
        alphabet = [b"\\", b"n", b"\n", b" ", b"\xc3\xa9", b"e\xcc\x81", b"\xff", b"x20"]
        raws = {a + b + c for a in alphabet for b in alphabet for c in alphabet}
        self.assertEqual(len(set(names.shown(sorted(raws)))), len(raws))

    def test_two_codings_of_a_letter_are_shown_apart(self):
        self.assertEqual(names.shown(["é".encode(), "e\u0301".encode(), "ö".encode()]),
                         ["\\xe9", "e\\u0301", "ö"])

    def test_a_long_text_keeps_its_ends(self):
        cut = brief("a" * 500 + "b" * 500)
        self.assertEqual((len(cut), cut[0], cut[-1]), (160, "a", "b"))


class Folders(unittest.TestCase):
    def folders(self, *entries):
        suffixes = {"zip": 4, "gz": 7}
        return names.folders([(raw if isinstance(raw, bytes) else raw.encode(),
                               suffixes.get(str(raw).rsplit(".")[-1], 0)) for raw in entries])

    def test_an_archive_loses_its_suffix(self):
        self.assertEqual(self.folders("anna.zip", "bob.tar.gz", "carl"), ["anna", "bob", "carl"])

    def test_an_archive_keeps_its_suffix_beside_its_folder(self):
        self.assertEqual(self.folders("anna", "anna.zip"), ["anna", "anna.zip"])
        self.assertEqual(self.folders("anna.tar.gz", "anna.zip"), ["anna.tar.gz", "anna.zip"])

    def test_names_that_a_file_system_may_hold_stay(self):
        for name in ("-rf", " a b ", "a\nb", "it's \"so\"", "李小龙", "..a"[2:] + "..", "=1+1"):
            self.assertEqual(self.folders(name), [name])

    def test_no_folder_is_hidden_or_leads_elsewhere(self):
        for name in (".", "..", "..zip", ".zip", ".git", "...", "..tar.gz"):
            folder, = self.folders(name)
            self.assertFalse(folder.startswith(".") or folder == "" or "/" in folder, folder)

    def test_no_folder_takes_the_name_of_a_report(self):
        for name in ("grades.csv", "JUnit.XML", "grades.tap", "index.html", "ｉndex.html"):
            folder, = self.folders(name)
            self.assertNotIn(folder.lower(),
                             ("grades.csv", "junit.xml", "grades.tap", "index.html"))
        self.assertEqual(self.folders("index.html.zip"), ["index.html.zip"])

    def test_no_two_folders_are_one_where_case_and_coding_are_ignored(self):
        entries = ["anna", "ANNA", "Anna.zip", "anna.zip.zip", "é", "e\u0301", "É", "straße",
                   "STRASSE", "anna.ZIP", b"a\xff", "a%FF", "x" * 250, "x" * 251, "é" * 120]
        for _ in range(3):  # and somebody who knows what the others become
            entries = list(dict.fromkeys([*entries, *self.folders(*entries)]))
        folders = self.folders(*entries)
        self.assertEqual(len({unicodedata.normalize("NFD", folder.casefold())
                              for folder in folders}), len(entries))

    def test_a_folder_is_well_formed_and_not_long(self):
        for name in ("x" * 255, "é" * 127, "x" * 251 + ".zip", b"\xff" * 255):
            folder, = self.folders(name)
            self.assertLessEqual(len(folder.encode()), 200)

    def test_a_long_name_keeps_its_beginning(self):
        self.assertTrue(self.folders("x" * 255)[0].startswith("x" * 180))

    def test_a_name_depends_on_no_other_and_no_order(self):
        entries = ["anna", "ANNA", "bob.zip", "carl"]
        self.assertEqual(self.folders(*entries), self.folders(*entries[::-1])[::-1])
        self.assertEqual(self.folders("bob.zip"), self.folders(*entries)[2:3])


class Find(Scratch):
    def test_folders_and_archives_are_submissions_in_the_order_of_their_bytes(self):
        for name in ("b", "B", "é", "-rf", "a b"):
            (self.room / name).mkdir()
        for name in ("c.zip", "d.tar.gz", "e.tgz", "f.tar", "g.ZIP"):
            (self.room / name).write_bytes(b"")
        found, others = submissions.find(self.room)
        self.assertEqual([s.name for s in found],
                         ["-rf", "B", "a b", "b", "c.zip", "d.tar.gz", "e.tgz", "f.tar", "g.ZIP",
                          "é"])
        self.assertEqual([s.folder for s in found], ["-rf", "B~" + found[1].folder[2:], "a b",
                         found[3].folder, "c", "d", "e", "f", "g", "é"])
        self.assertEqual([s.kind for s in found if s.name[1:2] == "."], ["archive"] * 5)
        self.assertEqual(others, [])

    def test_what_nobody_hands_in_is_named(self):
        clutter = [".DS_Store", "Read me.txt", "Thumbs.db", "desktop.ini", "gradebook.csv", "readme.md",
                   "submission_metadata.yml", "05-quadratic.c"]
        for name in clutter:
            (self.room / name).write_bytes(b"")
        (self.room / ".git").mkdir()
        (self.room / "__MACOSX").mkdir()
        self.assertEqual(submissions.find(self.room, STEMS), ([], sorted([*clutter, ".git", "__MACOSX"])))

    def test_whoever_handed_in_anything_is_there(self):
        loose = [f"{name}.{kind}" for name in "abcdefgh" for kind in ("pdf", "docx", "c", "txt", "rar")]
        for name in (*loose, "e\nvil.c"):
            (self.room / name).write_bytes(b"")
        (self.room / "readme.d").mkdir()
        os.mkfifo(self.room / "pipe.zip")
        with socket.socket(socket.AF_UNIX) as listening:
            listening.bind(str(self.room / "socket"))
        found, others = submissions.find(self.room, STEMS)
        self.assertEqual([s.name for s in found],
                         [name.replace("\n",
                                       "\\n") for name in sorted([*loose, "e\nvil.c", "readme.d", "pipe.zip",
                                                                  "socket"])])
        self.assertEqual(others, [])
        for submission in found:
            collected = submissions.collect(submission, STEMS)
            self.assertTrue(collected.empty and collected.words, submission)
        self.assertEqual(submissions.collect(found[0], STEMS).words,
                         "a loose file, and neither a folder nor an archive")

    def test_names_of_any_bytes_have_one_result_each(self):
        for name in (b"\xff", b"\xfe\n", b"a\nb", b"\x1b]0;x\x07", b"=1+1", b"%41", b"x" * 255):
            os.mkdir(os.path.join(os.fsencode(self.room), name))
        found, _ = submissions.find(self.room)
        self.assertEqual(len({s.name for s in found}), 7)
        self.assertEqual(len({s.folder for s in found}), 7)
        self.assertIn("a\\nb", [s.name for s in found])
        for submission in found:
            self.assertTrue(submissions.collect(submission, STEMS).empty)

    def test_what_cannot_even_be_asked_is_a_submission_too(self):
        def fails():
            raise OSError(5, "Input/output error")
        self.assertEqual(submissions.kind_of(SimpleNamespace(is_symlink=fails)),
                         ("unreadable", "cannot be read: Input/output error"))
        collected = submissions.collect(submissions.Submission(
            b"/nowhere", "anna", "anna", "unreadable", "cannot be read: Input/output error"), STEMS)
        self.assertEqual((collected.empty, collected.words),
                         (True, "cannot be read: Input/output error"))

    def test_a_link_is_empty_and_not_followed(self):
        (self.top / "secret").mkdir()
        (self.top / "secret" / "05-quadratic.c").write_bytes(b"secret")
        (self.room / "anna").symlink_to(self.top / "secret")
        collected = self.collect()
        self.assertTrue(collected.empty)
        self.assertEqual(collected.words, "a symbolic link, not followed")
        self.assertEqual(collected.answers["05-quadratic"].text, b"")

    def test_a_folder_that_became_a_link_is_not_followed(self):
        self.put("05-quadratic.c")
        found, _ = submissions.find(self.room)
        os.rename(self.room / "anna", self.top / "moved")
        (self.room / "anna").symlink_to(self.top / "moved")
        collected = submissions.collect(found[0], STEMS)
        self.assertTrue(collected.empty)
        self.assertIn("cannot be read", collected.words)

    def test_one_that_is_gone_is_empty_with_words(self):
        self.put("05-quadratic.c")
        found, _ = submissions.find(self.room)
        shutil.rmtree(self.room / "anna")
        self.assertIn("cannot be read: No such file", submissions.collect(found[0], STEMS).words)


class Read(Scratch):
    """Whether a submission could be read at all: if not, it has no score."""
    ZIP = zipped(("01-corners.c", b"x"), ("05-quadratic.c", b"y"))

    def status(self) -> tuple:
        collected = self.collect()
        return collected.status, collected.words

    def of(self, name: str, content: bytes) -> tuple:
        path = self.put(name, content, who="")
        told = self.status()
        os.unlink(path)
        return told

    def test_what_cannot_be_read_says_so_and_why(self):
        for name, content, words in (
                ("anna.zip", b"no archive", "the archive is broken: File is not a zip file"),
                ("anna.zip", self.ZIP[:-30], "the archive is broken: File is not a zip file"),
                ("anna.zip", b"%PDF-1.7\n", "the archive is broken: File is not a zip file"),
                ("anna.pdf", b"%PDF-1.7\n", "a loose file, and neither a folder nor an archive"),
                ("anna.docx", self.ZIP, "a loose file, and neither a folder nor an archive"),
                ("anna.zip", zipped(("word/document.xml", b"x"), ("img.png", b"x")),
                 "holds no 01-corners.c ... 05-quadratic.c, only word/document.xml, img.png"),
                ("doe_1_2_report.pdf", b"%PDF-1.7\n", "holds no 01-corners.c ... 05-quadratic.c, only report.pdf"),
                ("Doe_1_assignsubmission_file_/=a.docx", b"x",
                 "holds no 01-corners.c ... 05-quadratic.c, only =a.docx"),
                ("anna/02_cameras.c", b"x", "holds no 01-corners.c ... 05-quadratic.c, only 02_cameras.c"),
                ("anna/5-quadratic.c", b"x", "there is 5-quadratic.c; the name must be 05-quadratic.c"),
                ("anna/05-quadratic.c", b"\0", "05-quadratic.c is not text")):
            self.assertEqual(self.of(name, content), ("cannot be read", words), name)
            shutil.rmtree(self.room)
            self.room.mkdir()

    def test_an_archive_with_a_password_cannot_be_read(self):
        raw = bytearray(self.ZIP)
        for at in (i for i in range(len(raw)) if raw[i:i + 4] == b"PK\1\2"):
            raw[at + 8] |= 1
        self.assertEqual(self.of("xaver.zip", bytes(raw)),
                         ("cannot be read", "01-corners.c cannot be read: it is encrypted; and 1 more like this"))

    def test_an_empty_one_is_empty(self):
        (self.room / "anna" / "week 1").mkdir(parents=True)
        self.put("README.md")
        self.put(".DS_Store")
        self.assertEqual(self.status(), ("empty", "holds no 01-corners.c ... 05-quadratic.c"))

    def test_what_is_read_in_part_says_so(self):
        self.put("01-corners.c")
        self.assertEqual(self.status(), ("", ""))
        self.put("all.zip", b"no archive")
        self.assertEqual(self.status(), ("partly read", "all.zip: the archive is broken: File is not a zip file"))
        self.put("05-quadratic.c")
        self.assertEqual(self.status()[0], "")
        self.put("05-quadratic.c", b"\0")
        os.unlink(self.room / "anna" / "all.zip")
        self.assertEqual(self.status(), ("partly read", "05-quadratic.c is not text"))


class Digest(Scratch):
    def test_it_changes_with_every_byte_and_with_nothing_else(self):
        self.put("05-quadratic.c", b"int a;")
        first = submissions.digest(self.collect())
        self.put("notes.txt", b"x")
        os.utime(self.room / "anna" / "05-quadratic.c", (0, 0))
        self.assertEqual(submissions.digest(self.collect()), first)
        self.put("05-quadratic.c", b"int b;")
        self.assertNotEqual(submissions.digest(self.collect()), first)

    def test_it_changes_with_the_chapter(self):
        self.put("05-quadratic.c", b"int a;")
        first = submissions.digest(self.collect())
        os.rename(self.room / "anna" / "05-quadratic.c", self.room / "anna" / "01-corners.c")
        self.assertNotEqual(submissions.digest(self.collect()), first)


ONE = "01-corners.c"


class Export(Scratch):
    def lay(self, *names, content=b"int a;\n"):
        for name in names:
            path = self.room / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)

    def all(self) -> dict:
        """name -> its answers' texts, in the order of the chapters"""
        found, others = submissions.find(self.room, STEMS)
        self.assertEqual(others, [name for name in ("submission_metadata.yml",) if (self.room / name).exists()])
        self.assertEqual(len({s.folder for s in found}), len(found))
        return {s.name: [answer.text for answer in submissions.collect(s, STEMS).answers.values()] for s in found}


class Canvas(Export):
    def test_loose_files_belong_to_their_user(self):
        self.lay(f"doejane_123_456_{ONE}", f"roejohn_LATE_124_459_{ONE}", content=b"x")
        self.lay(f"doejane_123_457_{FIVE}", f"müllerüte_126_460_{FIVE}", content=b"y")
        self.lay("poezoe_125_458_report.pdf")
        self.assertEqual(self.all(), {"doejane_123": [b"x", b"y"], "roejohn_124": [b"x", b""],
                                      "müllerüte_126": [b"", b"y"], "poezoe_125": [b"", b""]})

    def test_a_file_that_is_handed_in_again_counts_once_the_last(self):
        self.lay(f"doejane_123_456_{FIVE}", content=b"first")
        self.lay("doejane_LATE_123_1000_05-quadratic-2.c", content=b"third")
        self.lay("doejane_123_789_05-quadratic-1.c", content=b"second")
        self.assertEqual(self.all(), {"doejane_123": [b"", b"third"]})

    def test_one_that_was_only_handed_in_again_counts(self):
        self.lay("doejane_123_456_05-quadratic-1.c", content=b"x")
        self.assertEqual(self.all(), {"doejane_123": [b"", b"x"]})

    def test_archives_count_with_loose_files(self):
        self.lay("doejane_123_456_all.zip", content=zipped((FIVE, b"x"), (ONE, b"old")))
        self.lay(f"doejane_123_457_{ONE}", content=b"new")
        self.lay("roejohn_124_458_submission-1.zip", content=zipped((FIVE, b"y")))
        self.assertEqual(self.all(), {"doejane_123": [b"new", b"x"], "roejohn_124": [b"", b"y"]})

    def test_of_two_archives_the_last_upload_counts(self):
        # Two answers that differ were "2 files are called 05-quadratic.c", and lost the chapter's marks.
        self.lay("zoe_506_9039_submission.zip", content=zipped((ONE, b"same"), (FIVE, b"first")))
        self.lay("zoe_LATE_506_9040_submission-1.zip", content=zipped((ONE, b"same"), (FIVE, b"last")))
        self.assertEqual(self.all(), {"zoe_506": [b"same", b"last"]})
        self.lay(f"doejane_123_456_{FIVE}", content=b"x")
        self.assertEqual(self.all(), {"doejane_123": [b"", b"x"], "zoe_506": [b"same", b"last"]})

    def test_the_platform_s_number_says_which_is_the_last(self):
        for first, last in (("a_1_9_hw.zip", "a_LATE_1_10_fixed.zip"), ("a_1_99_hw-1.tar.gz", "a_1_100_hw.tar.gz"),
                            ("a_1_7_hw-2.zip", "a_1_8_hw-1.zip")):
            self.lay(f"b_2_5000_{ONE}", content=b"b")
            self.lay(first, content=zipped((ONE, b"kept"), (FIVE, b"first")))
            self.lay(last, content=zipped(("mine/" + FIVE, b"last")))
            self.assertEqual(self.all(), {"a_1": [b"kept", b"last"], "b_2": [b"b", b""]})
            for name in (first, last):
                (self.room / name).unlink()

    def test_an_archive_after_a_loose_file_counts(self):
        self.lay(f"doejane_123_456_{FIVE}", content=b"first")
        self.lay("doejane_123_457_all.zip", content=zipped((FIVE, b"last")))
        self.assertEqual(self.all(), {"doejane_123": [b"", b"last"]})

    def test_if_the_last_upload_cannot_be_read_that_is_said(self):
        self.lay("zoe_506_9039_submission.zip", content=zipped((ONE, b"x"), (FIVE, b"y")))
        self.lay("zoe_506_9040_submission-1.zip", content=b"cut off")
        collected = self.collect()
        self.assertEqual((collected.status, collected.words),
                         ("partly read", "the archive is broken: File is not a zip file"))
        self.lay("zoe_506_9041_submission-2.zip", content=zipped((ONE, b"x"), (FIVE, b"z")))
        self.assertEqual((self.collect().status, self.answer().text), ("", b"z"))

    def test_a_link_among_them_is_not_followed(self):
        (self.top / "secret").write_bytes(b"secret")
        (self.room / f"doejane_123_456_{FIVE}").symlink_to(self.top / "secret")
        self.assertEqual(self.all(), {f"doejane_123_456_{FIVE}": [b"", b""]})

    def test_names_that_only_look_alike_stay_apart(self):
        archive = zipped((FIVE, b"x"))
        for names in (("week_1_2_anna.zip", "week_1_2_ben.zip"), ("ws_2025_1_anna.zip", "ws_2025_2_ben.zip"),
                      ("a_1_2_x.zip", "b_1_3_x.zip")):
            self.lay(*names, content=archive)
            self.assertEqual(self.all(), {name: [b"", b"x"] for name in names})
            for name in names:
                (self.room / name).unlink()

    def test_a_name_that_only_looks_alike_spoils_nobody_else(self):
        self.lay(f"doejane_123_456_{ONE}", f"doejane_123_457_{FIVE}", "week_1_2_anna.c", "week_1_2_ben.c", content=b"x")
        self.assertEqual(self.all(), {"doejane_123": [b"x", b"x"], "week_1_2_anna.c": [b"", b""],
                                      "week_1_2_ben.c": [b"", b""]})


class Moodle(Export):
    def test_a_folder_with_files_or_an_archive_is_a_submission(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay("Jörg Roe_124_assignsubmission_file_/mine.zip", content=zipped(("a/" + FIVE, b"y")))
        self.lay("Zoë Poe_125_assignsubmission_file/all.zip", content=zipped(("inner.zip", zipped((ONE, b"z")))))
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Jörg Roe_124": [b"", b"y"],
                                      "Zoë Poe_125": [b"z", b""]})

    def test_text_and_files_of_one_person_are_one_submission(self):
        self.lay("Jane Doe_123_assignsubmission_onlinetext_/onlinetext.html")
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay("Joe Roe_124_assignsubmission_onlinetext_/onlinetext.html")
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Joe Roe_124": [b"", b""]})

    def test_loose_files_belong_to_their_participant(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_{ONE}", content=b"x")
        self.lay(f"Jane Doe_123_assignsubmission_file_{FIVE}", content=b"y")
        self.lay("Joe_Roe_124_assignsubmission_file_all.zip", content=zipped((FIVE, b"z")))
        self.assertEqual(self.all(), {"Jane Doe_123": [b"x", b"y"], "Joe_Roe_124": [b"", b"z"]})

    def test_people_of_one_name_stay_apart(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay(f"Jane Doe_124_assignsubmission_file_/{FIVE}", content=b"y")
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Jane Doe_124": [b"", b"y"]})


class Gradescope(Export):
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

    def test_folders_have_the_names_of_their_people(self):
        for number in (1001, 1002, 1003):
            self.lay(f"submission_{number}/{FIVE}", content=b"%d" % number)
        (self.room / "submission_metadata.yml").write_text(self.METADATA, encoding="utf-8")
        self.assertEqual(self.all(), {"Jane Doe, O'Neill, Zoë (submission_1001)": [b"", b"1001"],
                                      "Jane Doe (submission_1003) (submission_1002)": [b"", b"1002"],
                                      "submission_1003": [b"", b"1003"]})
        self.assertEqual([s.folder for s in submissions.find(self.room)[0]],
                         ["submission_1001", "submission_1002", "submission_1003"])

    def test_no_name_is_anybody_else_s(self):
        self.lay(f"submission_1/{FIVE}", f"Ann (submission_1)/{FIVE}")
        (self.room / "submission_metadata.yml").write_text("submission_1:\n  :submitters:\n  - :name: Ann\n")
        self.assertEqual(set(self.all()), {"submission_1", "Ann (submission_1)"})

    def test_a_list_that_is_a_link_or_noise_is_no_list(self):
        self.lay(f"submission_1/{FIVE}", content=b"x")
        self.lay("submission_metadata.yml", content=os.urandom(5000))
        self.assertEqual(self.all(), {"submission_1": [b"", b"x"]})
        (self.room / "submission_metadata.yml").unlink()
        (self.room / "submission_metadata.yml").symlink_to("/dev/zero")
        self.assertEqual(self.all(), {"submission_1": [b"", b"x"]})


class Copies(Export):
    """A copy of the toolkit or of the handout, of which exercises/ counts."""
    ELSEWHERE = ["solutions", "tests/handout/replay/blanks", "tests/05-quadratic", "tests", "build/blanks", "build/x/y",
                 "chapters",
                 ".make", "common"]

    def copy(self, top="", exercises=(FIVE,)) -> list:
        members = [(f"{top}{place}/{FIVE}", place.encode()) for place in self.ELSEWHERE]
        members += [(f"{top}build/submission.zip", zipped((FIVE, b"old"))), (f"{top}Makefile", b""),
                    (f"{top}exercises/05-quadratic.h", b"")]
        return members + [(f"{top}exercises/{name}", b"mine") for name in exercises]

    def lay_out(self, members):
        for name, content in members:
            self.lay(f"anna/{name}", content=content)

    def test_as_a_folder(self):
        for top in ("", "ray-casting/", "week 3/ray-casting/"):
            self.lay_out(self.copy(top))
            self.assertEqual(self.all(), {"anna": [b"", b"mine"]})
            self.assertEqual(self.answer().words, "")
            (self.room / "anna").rename(self.top / f"done{len(top)}")

    def test_as_an_archive_in_any_order(self):
        for top in ("", "ray-casting/"):
            members = self.copy(top)
            for them in (members, members[::-1]):
                for name, pack in (("anna.zip", zipped), ("anna.tar.gz", lambda *m: gzip.compress(tarred(*m)))):
                    self.lay(name, content=pack(*them))
                    self.assertEqual(self.all(), {name: [b"", b"mine"]})
                    (self.room / name).unlink()

    def test_as_an_archive_in_a_folder(self):
        self.lay("Jane_1_assignsubmission_file_/x.zip", content=zipped(*self.copy("ray-casting/")))
        self.assertEqual(self.all(), {"Jane_1": [b"", b"mine"]})

    def test_an_answer_that_is_missing_is_not_taken_from_elsewhere(self):
        self.lay_out(self.copy(exercises=()))
        self.assertEqual(self.answer().state, "missing")

    def test_a_folder_of_one_s_own_beside_exercises_is_not_passed_over(self):
        self.lay_out([*self.copy(), (f"mine/{FIVE}", b"other")])
        self.assertEqual(self.answer().state, "twice")

    def test_folders_of_these_names_without_exercises_are_folders(self):
        for name in ("solutions", "tests", "build/mine", "chapters/common"):
            self.lay(f"{name.replace('/', '-')}/{name}/{FIVE}", content=b"x")
        self.assertEqual(set(map(tuple, self.all().values())), {(b"", b"x")})

    def test_clones_may_be_large(self):
        self.lay_out(self.copy())
        for i in range(300):
            self.lay(f"anna/build/{i}/{FIVE}", f"anna/.git/objects/{i}")
        with mock.patch.object(folders, "ENTRIES", 100):
            self.assertEqual((self.answer().text, self.collect().words), (b"mine", ""))
