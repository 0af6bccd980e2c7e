"""test_folders.py - which answers a folder holds, and that nothing leads out of it."""
import errno
import os
import time
import unittest
from unittest import mock

from grade.collect import answers, archives, folders, streams
from grade.confine.machine import GraderFailed
from .fixtures import FIVE, ONE, Scratch


# A sentence, the files of a folder, and of the answer to 05: its state, its file and what is said of it.
FOLDERS = [
    ("an answer is found at any depth", {"week 3/é/05-quadratic.c": b"a", ONE: b"b"}, "found", "week 3/é/05-quadratic.c", ""),
    ("what differs is not guessed between", {f"{i}/{FIVE}": b"int a%d;" % i for i in range(8)}, "twice", "",
     "8 files are called 05-quadratic.c and are not the same: " + ", ".join(f"{i}/{FIVE}" for i in range(5))
     + " and 3 more"),
    ("the same text twice counts as one",
     {f"b/{FIVE}": b"int a;\r\n", f"c/{FIVE}": b"int a;\r", f"a/{FIVE}": b"int a;\n"}, "found", f"a/{FIVE}",
     f"3 files with the same text count as one: a/{FIVE}, b/{FIVE}, c/{FIVE}"),
    ("one that cannot be read makes two", {f"a/{FIVE}": b"x", f"b/{FIVE}": b"\0"}, "twice", "",
     f"2 files are called 05-quadratic.c and are not the same: a/{FIVE}, b/{FIVE}"),
    ("a folder may be called like an answer", {f"{FIVE}/{FIVE}": b"x"}, "found", f"{FIVE}/{FIVE}", ""),
    ("what cannot be the answer tells why there is none",
     {"05-Quadratic.c": b"x", "5-quadratic (1).c": b"x", "01-corners.txt": b"x"}, "missing", "",
     "there is 05-Quadratic.c, 5-quadratic (1).c; the name must be 05-quadratic.c"),
    ("Windows hides how a name ends", {"05-quadratic.c.txt": b"x", "05-quadratic.cpp": b"x"}, "missing", "",
     "there is 05-quadratic.c.txt, 05-quadratic.cpp; the name must be 05-quadratic.c"),
    ("another suffix is not a slip", {"05-quadratic.txt": b"x"}, "missing", "", ""),
    ("files added by a Mac are not answers", {f"__MACOSX/{FIVE}": b"x", f"._{FIVE}": b"x"}, "missing", "", ""),
    ("places are one visible line", {f"a\n\udcff/{FIVE}": b"x"}, "found", f"a\\n\\udcff/{FIVE}", ""),
]


class Folder(Scratch):
    def test_each_folder_has_its_answer(self):
        for sentence, files, *wanted in FOLDERS:
            with self.subTest(sentence):
                self.clear()
                self.lay({f"anna/{name}": content for name, content in files.items()})
                answer = self.answer()
                self.assertEqual([answer.state, answer.file, answer.words], wanted)

    def test_nothing_is_said_of_what_is_found(self):
        self.put("week 3/é/05-quadratic.c", b"int five;\n")
        self.put(ONE, b"int one;\n")
        collected = self.collect()
        self.assertEqual([answer.text for answer in collected.answers.values()], [b"int one;\n", b"int five;\n"])
        self.assertEqual((collected.empty, collected.words), (False, ""))

    def test_links_are_said_and_not_followed(self):
        self.put("x.txt")
        secret = self.secret(FIVE)
        (self.room / "anna" / FIVE).symlink_to(secret)
        (self.room / "anna" / "folder").symlink_to(secret.parent)
        (self.room / "anna" / "round").symlink_to(".")
        collected = self.collect()
        answer = collected.answers["05-quadratic"]
        self.assertEqual((answer.state, answer.text), ("missing", b""))
        self.assertEqual(answer.words, "05-quadratic.c is a symbolic link, not followed")
        self.assertNotIn("cannot be read", collected.words)

    def test_a_link_beside_an_answer_does_not_hide_it(self):
        self.put("05-quadratic.c")
        (self.room / "anna" / "z").mkdir()
        (self.room / "anna" / "z" / "05-quadratic.c").symlink_to("/dev/zero")
        self.assertEqual(self.answer().state, "found")

    def test_a_file_that_becomes_a_link_while_it_is_looked_at_is_not_followed(self):
        self.put(FIVE)
        secret, was = self.secret("secret"), folders.read

        def swapped(name, folder):
            os.unlink(name, dir_fd=folder)
            os.symlink(secret, name, dir_fd=folder)
            return was(name, folder)
        with mock.patch.object(folders, "read", swapped):
            answer = self.answer()
        self.assertEqual((answer.state, answer.text), ("unreadable", b""))

    def test_a_folder_that_becomes_a_link_while_it_waits_is_not_followed(self):
        self.put(f"a/{FIVE}")
        secret, was = self.secret(FIVE).parent, folders.look_in

        def swapped(search, folder, parts, *more):
            below = was(search, folder, parts, *more)
            if not parts:
                os.rename(self.room / "anna" / "a", self.room / "anna" / "b")
                (self.room / "anna" / "a").symlink_to(secret)
            return below
        with mock.patch.object(folders, "look_in", swapped):
            collected = self.collect()
        self.assertTrue(collected.empty)
        self.assertIn("a cannot be read", collected.words)

    def test_a_fifo_stops_nobody(self):
        self.put("x.txt")
        os.mkfifo(self.room / "anna" / "05-quadratic.c")
        answer = self.answer()
        self.assertEqual((answer.state, answer.words),
                         ("missing", "05-quadratic.c is neither a file nor a folder, not opened"))

    def test_a_fifo_that_was_a_file_stops_nobody(self):
        os.mkfifo(self.room / "05-quadratic.c")
        self.assertRaises(OSError, folders.read, os.fsencode(self.room / "05-quadratic.c"))

    def test_an_answer_of_256_KB_is_read_and_no_more(self):
        self.put("01-corners.c", b"/" * answers.LARGEST)
        with open(self.put("05-quadratic.c"), "wb") as file:
            file.truncate(1 << 40)  # with holes
        started = time.monotonic()
        collected = self.collect()
        self.assertLess(time.monotonic() - started, 1)
        self.assertEqual(collected.answers["01-corners"].state, "found")
        self.assertEqual(collected.answers["05-quadratic"].state, "unreadable")
        self.assertEqual(collected.answers["05-quadratic"].words,
                         "05-quadratic.c is larger than 256 KB")

    def as_nobody(self):
        """Collected by somebody who is not root."""
        os.chmod(self.work, 0o755)
        if os.geteuid() == 0:
            os.seteuid(65534)
            self.addCleanup(os.seteuid, 0)
        return self.collect()

    def test_a_file_that_nobody_may_read_is_said(self):
        os.chmod(self.put(FIVE), 0)
        answer = self.as_nobody().answers["05-quadratic"]
        self.assertEqual((answer.state, answer.words), ("unreadable", "05-quadratic.c cannot be read: Permission denied"))

    def test_a_folder_that_nobody_may_read_is_said(self):
        self.put(FIVE)
        self.put("closed/01-corners.c")
        os.chmod(self.room / "anna" / "closed", 0)
        self.addCleanup(os.chmod, self.room / "anna" / "closed", 0o755)
        collected = self.as_nobody()
        self.assertEqual(collected.answers["05-quadratic"].state, "found")
        self.assertEqual(collected.words, "closed cannot be read: Permission denied")

    def test_too_many_entries_end_the_search_at_a_folder(self):
        self.put("05-quadratic.c")
        self.put("many/01-corners.c")
        self.lay({f"anna/many/{i}": b"" for i in range(200)})
        with mock.patch.object(archives, "ENTRIES", 200):
            collected = self.collect()
        self.assertEqual(collected.answers["05-quadratic"].state, "found")
        self.assertEqual(collected.answers["01-corners"].state, "missing")
        self.assertEqual(collected.words, "holds more than 200 entries; no more were looked at")

    def test_a_deep_nest_ends_somewhere(self):
        folder = os.open(self.room, os.O_RDONLY)
        for _ in range(1500):
            os.mkdir("anna", dir_fd=folder)
            below = os.open("anna", os.O_RDONLY, dir_fd=folder)
            os.close(folder)
            folder = below
        os.close(os.open("05-quadratic.c", os.O_CREAT, dir_fd=folder))
        os.close(folder)
        collected = self.collect()
        self.assertTrue(collected.empty)
        self.assertEqual(collected.words,
                         "holds folders more than 50 deep; those were not looked at")

    def test_thousands_of_one_name_are_counted(self):
        one = self.put("000/05-quadratic.c", b"/" * answers.LARGEST)
        for i in range(1, 300):
            os.mkdir(self.room / "anna" / f"{i:03}")
            os.link(one, self.room / "anna" / f"{i:03}" / "05-quadratic.c")
        collected = self.collect()
        self.assertIn("and 252 more", collected.answers["05-quadratic"].words)
        self.assertIn("more than 64 MB of answers", collected.words)

    def test_a_disk_that_fails_is_the_grader_s_failure(self):
        with self.assertRaisesRegex(GraderFailed, "Input/output error"), \
                streams.opened_file("/proc/self/mem") as file:    # whose first page is not there
            file.read(1)
        self.put("05-quadratic.c")
        with mock.patch("os.open", side_effect=OSError(errno.ESTALE, "Stale file handle")), \
                self.assertRaisesRegex(GraderFailed, "Stale file handle"):
            self.collect()

    def test_the_time_is_that_of_the_newest_answer(self):
        for name, when in (("01-corners.c", 1000), ("05-quadratic.c", 2000), ("x.txt", 3000),
                           ("later/01-corners.c", 500)):
            os.utime(self.put(name), (0, when))
        self.assertEqual(self.collect().when, 2000)


class Text(unittest.TestCase):
    def test_line_ends_and_marks_are_those_of_the_house(self):
        for raw, text in ((b"a\nb\n", b"a\nb\n"), (b"a\r\nb\r\n", b"a\nb\n"), (b"a\rb\r", b"a\nb\n"),
                          (b"\xef\xbb\xbfa\nb\n", b"a\nb\n"), (b"\xff\xfea\0\r\0\n\0b\0\n\0", b"a\nb\n"),
                          (b"\xfe\xff\0a\0\n\0b\0\n", b"a\nb\n"), (b"// \xe9\n", b"// \xe9\n"),    # another coding
                          (b"a\0b", None), (b"\xff\xfea", None), (b"\xff\xfe\0\xd8", None), (b"\xff\xfea\0\0\0", None),
                          (b"\x7fELF\0", None)):
            self.assertEqual(answers.as_text(raw), text)
