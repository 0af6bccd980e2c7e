"""test_folders.py - which answers a folder holds, and that nothing leads out of it."""
import errno
import os
import time
import unittest
from unittest import mock

from grade.collect import answers, folders, streams
from grade.confine.machine import GraderFailed
from .fixtures import Scratch


class Folder(Scratch):
    def test_an_answer_is_found_at_any_depth(self):
        self.put("week 3/é/05-quadratic.c", b"int five;\n")
        self.put("01-corners.c", b"int one;\n")
        collected = self.collect()
        self.assertEqual([(a.state, a.file, a.text, a.words) for a in collected.answers.values()],
                         [("found", "01-corners.c", b"int one;\n", ""),
                          ("found", "week 3/é/05-quadratic.c", b"int five;\n", "")])
        self.assertEqual((collected.empty, collected.words), (False, ""))

    def test_an_empty_folder_says_so(self):
        (self.room / "anna").mkdir()
        self.assertEqual(self.collect().words, "holds no 01-corners.c ... 05-quadratic.c")

    def test_what_differs_is_not_guessed_between(self):
        for i in range(8):
            self.put(f"{i}/05-quadratic.c", b"int a%d;" % i)
        answer = self.answer()
        self.assertEqual((answer.state, answer.text), ("twice", b""))
        self.assertEqual(answer.words, "8 files are called 05-quadratic.c and are not the same: " +
                         ", ".join(f"{i}/05-quadratic.c" for i in range(5)) + " and 3 more")

    def test_the_same_text_twice_counts_as_one(self):
        self.put("b/05-quadratic.c", b"int a;\r\n")
        self.put("c/05-quadratic.c", b"int a;\r")
        self.put("a/05-quadratic.c", b"int a;\n")
        answer = self.answer()
        self.assertEqual((answer.state, answer.file, answer.text),
                         ("found", "a/05-quadratic.c", b"int a;\n"))
        self.assertIn("3 files with the same text count as one", answer.words)

    def test_one_that_cannot_be_read_makes_two(self):
        self.put("a/05-quadratic.c")
        self.put("b/05-quadratic.c", b"\0")
        self.assertEqual(self.answer().state, "twice")

    def test_links_are_said_and_not_followed(self):
        self.put("x.txt")
        (self.top / "secret").mkdir()
        (self.top / "secret" / "05-quadratic.c").write_bytes(b"secret")
        (self.room / "anna" / "05-quadratic.c").symlink_to(self.top / "secret" / "05-quadratic.c")
        (self.room / "anna" / "folder").symlink_to(self.top / "secret")
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
        self.put("05-quadratic.c")
        (self.top / "secret").write_bytes(b"secret")
        was = folders.read

        def swapped(name, folder):
            os.unlink(name, dir_fd=folder)
            os.symlink(self.top / "secret", name, dir_fd=folder)
            return was(name, folder)
        folders.read = swapped
        self.addCleanup(setattr, folders, "read", was)
        answer = self.answer()
        self.assertEqual((answer.state, answer.text), ("unreadable", b""))

    def test_a_folder_that_becomes_a_link_while_it_waits_is_not_followed(self):
        self.put("a/05-quadratic.c")
        (self.top / "secret").mkdir()
        (self.top / "secret" / "05-quadratic.c").write_bytes(b"secret")
        was = folders.look_in

        def swapped(search, folder, parts, *more):
            below = was(search, folder, parts, *more)
            if not parts:
                os.rename(self.room / "anna" / "a", self.room / "anna" / "b")
                (self.room / "anna" / "a").symlink_to(self.top / "secret")
            return below
        folders.look_in = swapped
        self.addCleanup(setattr, folders, "look_in", was)
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

    def test_a_folder_may_be_called_like_an_answer(self):
        self.put("05-quadratic.c/05-quadratic.c")
        self.assertEqual(self.answer().file, "05-quadratic.c/05-quadratic.c")

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

    def test_a_file_that_nobody_may_read_is_said(self):
        os.chmod(self.put("05-quadratic.c"), 0)
        os.chmod(self.top, 0o755)
        if os.geteuid() == 0:
            os.seteuid(65534)
            self.addCleanup(os.seteuid, 0)
        answer = self.answer()
        self.assertEqual((answer.state, answer.words),
                         ("unreadable", "05-quadratic.c cannot be read: Permission denied"))

    def test_a_folder_that_nobody_may_read_is_said(self):
        self.put("05-quadratic.c")
        self.put("closed/01-corners.c")
        os.chmod(self.room / "anna" / "closed", 0)
        os.chmod(self.top, 0o755)
        self.addCleanup(os.chmod, self.room / "anna" / "closed", 0o755)
        if os.geteuid() == 0:
            os.seteuid(65534)
            self.addCleanup(os.seteuid, 0)
        collected = self.collect()
        self.assertEqual(collected.answers["05-quadratic"].state, "found")
        self.assertEqual(collected.words, "closed cannot be read: Permission denied")

    def test_too_many_entries_end_the_search_at_a_folder(self):
        self.put("05-quadratic.c")
        self.put("many/01-corners.c")
        self.addCleanup(setattr, folders, "ENTRIES", folders.ENTRIES)
        folders.ENTRIES = 200
        for i in range(200):
            self.put(f"many/{i}", b"")
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

    def test_what_cannot_be_the_answer_tells_why_there_is_none(self):
        self.put("05-Quadratic.c")
        self.put("5-quadratic (1).c")
        self.put("01-corners.txt")
        self.assertEqual(self.answer().words, "there is 05-Quadratic.c, 5-quadratic (1).c; "
                                              "the name must be 05-quadratic.c")
        self.assertEqual(self.answer("01-corners").words, "")
        self.put("01-corners.c.txt")  # Windows hides how a name ends
        self.put("01-corners.cpp")
        self.assertEqual(self.answer("01-corners").words, "there is 01-corners.c.txt, 01-corners.cpp; "
                                                          "the name must be 01-corners.c")

    def test_files_added_by_a_mac_are_not_answers(self):
        self.put("__MACOSX/05-quadratic.c")
        self.put("._05-quadratic.c")
        self.assertEqual(self.answer().state, "missing")

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

    def test_places_are_one_visible_line(self):
        self.put(b"a\n\xff/05-quadratic.c")
        self.assertEqual(self.answer().file, "a\\n\\udcff/05-quadratic.c")

    def test_the_time_is_that_of_the_newest_answer(self):
        for name, when in (("01-corners.c", 1000), ("05-quadratic.c", 2000), ("x.txt", 3000),
                           ("later/01-corners.c", 500)):
            os.utime(self.put(name), (0, when))
        self.assertEqual(self.collect().when, 2000)


class Text(unittest.TestCase):
    def test_line_ends_and_marks_are_those_of_the_house(self):
        for raw in (b"a\nb\n", b"a\r\nb\r\n", b"a\rb\r", b"\xef\xbb\xbfa\nb\n",
                    b"\xff\xfea\0\r\0\n\0b\0\n\0", b"\xfe\xff\0a\0\n\0b\0\n"):
            self.assertEqual(answers.as_text(raw), b"a\nb\n")

    def test_text_of_another_coding_stays(self):
        self.assertEqual(answers.as_text(b"// \xe9\n"), b"// \xe9\n")

    def test_what_holds_nothing_but_bytes_is_not_text(self):
        for raw in (b"a\0b", b"\xff\xfea", b"\xff\xfe\0\xd8", b"\xff\xfea\0\0\0", b"\x7fELF\0"):
            self.assertIsNone(answers.as_text(raw))
