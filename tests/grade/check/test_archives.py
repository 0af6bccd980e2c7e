"""test_archives.py - answers in archives that are well made, and what would lead out of one."""
import gzip
import io
import os
import stat
import tarfile
import zipfile

from grade.collect import submissions
from .packing import FIVE, Archive, member, tarred, zipped
from .scratch import STEMS


class WellMade(Archive):
    def test_a_zip_and_a_tar_are_read_at_any_depth(self):
        for how in (self.zip, self.tar):
            collected = how(("week 3/é/" + FIVE, b"int a;\r\n"), ("01-corners.c", b"int b;\n"))
            self.assertEqual(self.five(collected), ("found", "week 3/é/" + FIVE, b"int a;\n"))
            self.assertEqual(collected.answers["01-corners"].text, b"int b;\n")
            self.assertEqual((collected.words, collected.empty), ("", False))
            self.clear()

    def test_every_kind_of_tar_is_read(self):
        for form in (tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT):
            for name, pack in (("a.tar", bytes), ("a.tgz", gzip.compress),
                               ("a.TAR.GZ", gzip.compress)):
                path = self.archive(name, pack(tarred(("long/" * 19 + FIVE, b"x"), format=form)))
                self.assertEqual(self.five(self.collect())[::2], ("found", b"x"))
                path.unlink()

    def test_an_answer_of_256_KB_is_read_and_no_more(self):
        for how in (self.zip, self.tar):
            for more, words in ((0, ""), (1, FIVE + " is larger than 256 KB"),
                                (99, FIVE + " is larger than 256 KB")):
                answer = how((FIVE, b"/" * (256 * 1024 + more))).answers["05-quadratic"]
                self.assertEqual((answer.state, answer.words),
                                 ("unreadable" if more else "found", words))
            self.clear()

    def test_a_stored_zip_is_read(self):
        self.assertEqual(self.five(self.zip((FIVE, b"x"), method=zipfile.ZIP_STORED))[0], "found")

    def test_a_zip64_is_read(self):
        memory = io.BytesIO()
        with zipfile.ZipFile(memory, "w") as archive:
            with archive.open(FIVE, "w", force_zip64=True) as file:
                file.write(b"x")
        self.archive("anna.zip", memory.getvalue())
        self.assertEqual(self.five(self.collect()), ("found", FIVE, b"x"))

    def test_windows_separators_are_separators(self):
        info = zipfile.ZipInfo("x")
        info.filename = "week\\" + FIVE
        self.assertEqual(self.five(self.zip((info, b"x"))), ("found", "week/" + FIVE, b"x"))

    def test_what_an_archive_is_counts_not_what_it_is_called(self):
        self.archive("anna.tar.gz", zipped((FIVE, b"x")))
        self.assertEqual(self.five(self.collect())[0], "found")
        for folder in ("PK\3\4", "BZhang", "Rar!"):
            self.archive("anna.tar.gz", tarred((f"{folder}/{FIVE}", b"x")))
            self.assertEqual(self.five(self.collect())[0], "found")
        self.clear()
        self.archive("anna.zip", gzip.compress(tarred((FIVE, b"x"))))
        self.assertEqual(self.five(self.collect())[0], "found")
        self.archive("anna.zip", tarred((FIVE, b"x")))
        self.assertEqual(self.five(self.collect())[0], "found")

    def test_folders_and_files_added_by_a_mac_are_not_answers(self):
        for how in (self.zip, self.tar):
            collected = how(*((name + FIVE, b"x") for name in ("__MACOSX/", "__MACOSX/._", "._")))
            self.assertTrue(collected.empty)
            self.clear()
        self.assertTrue(self.zip((FIVE + "/", b"")).empty)
        self.clear()
        self.assertTrue(self.tar((member(FIVE, tarfile.DIRTYPE), b"")).empty)

    def test_two_that_differ_are_not_guessed_between(self):
        for how in (self.zip, self.tar):
            self.assertEqual(self.five(how(("a/" + FIVE, b"x"), ("b/" + FIVE, b"y")))[0], "twice")
            self.assertEqual(self.five(how(("a/" + FIVE, b"x"), ("b/" + FIVE, b"x")))[0], "found")
            self.clear()

    def test_the_time_is_that_of_the_archive(self):
        os.utime(self.archive("anna.zip", zipped((FIVE, b"x"))), (0, 4000))
        self.assertEqual(self.collect().when, 4000)


class Escapes(Archive):
    def test_paths_that_lead_out_are_refused_and_nothing_is_written(self):
        names = ["../../" + FIVE, "/etc/" + FIVE, "a/../../" + FIVE, "..//" + FIVE]
        for how, extra in ((self.zip, ["..\\" + FIVE, "C:\\" + FIVE]), (self.tar, [])):
            for name in names + extra:
                info = name if how == self.tar else zipfile.ZipInfo("x")
                if how == self.zip:
                    info.filename = name
                before = sorted(self.top.rglob("*"))
                collected = how((info, b"x"))
                self.assertTrue(collected.empty)
                self.assertIn("leads out of the archive", collected.words)
                self.assertLessEqual(len(sorted(self.top.rglob("*"))), len(before) + 1)
            self.clear()

    def test_links_and_devices_in_a_tar_are_not_followed(self):
        (self.top / "secret").write_bytes(b"secret")
        for kind, link in ((tarfile.SYMTYPE, str(self.top / "secret")), (tarfile.LNKTYPE, "x.c"),
                           (tarfile.CHRTYPE, ""), (tarfile.FIFOTYPE, "")):
            collected = self.tar(("x.c", b"secret"), (member(FIVE, kind, link), b""))
            self.assertEqual(self.five(collected), ("missing", "", b""))
            self.assertIn(f"{FIVE} is ", collected.answers["05-quadratic"].words)

    def test_a_link_in_a_zip_is_not_followed(self):
        info = zipfile.ZipInfo(FIVE)
        info.external_attr = (stat.S_IFLNK | 0o777) << 16
        collected = self.zip((info, b"/etc/passwd"))
        self.assertEqual(self.five(collected), ("missing", "", b""))
        self.assertIn("not followed", collected.answers["05-quadratic"].words)

    def test_an_archive_that_became_a_link_or_a_fifo_is_not_opened(self):
        self.archive("anna.zip", zipped((FIVE, b"x")))
        found, _ = submissions.find(self.room)
        os.rename(self.room / "anna.zip", self.top / "x.zip")
        (self.room / "anna.zip").symlink_to(self.top / "x.zip")
        self.assertTrue(submissions.collect(found[0], STEMS).empty)
        (self.room / "anna.zip").unlink()
        os.mkfifo(self.room / "anna.zip")
        self.assertEqual(submissions.collect(found[0], STEMS).words,
                         "cannot be read: it is not a file")
