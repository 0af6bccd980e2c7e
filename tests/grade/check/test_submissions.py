"""test_submissions.py - what is a submission, and when it has changed."""
import os
import shutil
import socket
from types import SimpleNamespace

from grade.collect import submissions
from .scratch import STEMS, Scratch


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
