"""test_broken_archives.py - archives that are cut off, damaged, or lie."""
import gzip
import os
import tarfile
import zipfile
import zlib

from .packing import FIVE, Archive, central, header, tarred, zipped


class Broken(Archive):
    def test_an_encrypted_member_is_said(self):
        self.archive("anna.zip", central(zipped((FIVE, b"x")), flags=1))
        collected = self.collect()
        self.assertEqual(self.five(collected)[0], "unreadable")
        self.assertIn("it is encrypted", collected.answers["05-quadratic"].words)

    def test_a_method_that_nobody_reads_is_said(self):
        for method in (zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
            collected = self.zip((FIVE, b"x"), method=method)
            self.assertIn("expected deflate", collected.answers["05-quadratic"].words)
        self.archive("anna.zip", central(zipped((FIVE, b"x")), method=99))
        self.assertEqual(self.five(self.collect())[0], "unreadable")

    def test_lying_sizes_and_sums_are_said(self):
        whole = zipped((FIVE, b"int a;\n" * 100))
        for lie in ({"size": 7, "sum": zlib.crc32(b"int a;\n")}, {"size": 701}, {"size": 1 << 31},
                    {"sum": 1}, {"packed": 3}, {"offset": 7},
                    {"offset": 1 << 31}, {"size": 0}):
            self.archive("anna.zip", central(whole, **lie))
            collected = self.collect()
            self.assertIn(self.five(collected)[0], ("unreadable", "missing"), lie)
            self.assertNotEqual(collected.words + collected.answers["05-quadratic"].words, "", lie)

    def test_every_truncated_archive_has_words_and_no_half_answer(self):
        text = os.urandom(3000).replace(b"\0", b"x").replace(b"\r", b"x")
        text = b"x" + text
        for name, whole in (("a.zip", zipped((FIVE, text))),
                            ("a.tar.gz", gzip.compress(tarred((FIVE, text)))),
                            ("a.tar", tarred((FIVE, text)))):
            for length in range(0, len(whole) - 1, 97):
                path = self.archive(name, whole[:length])
                collected = self.collect()
                state, _, held = self.five(collected)
                self.assertIn((state, held),
                              (("found", text), ("missing", b""), ("unreadable", b"")))
                if state != "found":
                    self.assertNotEqual(collected.words, "", (name, length))
            path.unlink()

    def test_archives_with_any_byte_wrong_stop_nobody(self):
        for name, whole in (("a.zip", zipped((FIVE, b"int a;"), ("b/" + FIVE, b"int a;"))),
                            ("a.tar.gz", gzip.compress(tarred((FIVE, b"int a;")), mtime=0)),
                            ("a.tar", tarred((FIVE, b"int a;"), format=tarfile.PAX_FORMAT)[:1536])):
            for at in range(len(whole)):
                path = self.archive(name, whole[:at] + bytes([whole[at] ^ 0x81]) + whole[at + 1:])
                self.collect()
            path.unlink()

    def test_a_tar_with_a_broken_header_in_the_middle_says_so(self):
        self.archive("anna.tar", tarred((FIVE, b"x"))[:1024] + b"y" * 512 +
                     tarred(("01-corners.c", b"x")))
        collected = self.collect()
        self.assertEqual(self.five(collected)[0], "found")
        self.assertEqual(collected.words, "the archive is broken after 1 members")

    def test_why_the_search_ended_comes_before_what_is_odd(self):
        whole = tarred(*((f"../{i}", b"x") for i in range(20)))
        self.archive("anna.tar", whole[:20 * 1024] + b"y" * 512)
        self.assertTrue(self.collect().words.startswith("the archive is broken after 20 members"))

    def test_sizes_below_zero_end(self):
        # Python's own tarfile once walked in circles here.
        for size in (-512, -1024, -(1 << 40)):
            self.archive("anna.tar", header("x", 0) + header(FIVE, size) + header("y", 0) * 2)
            self.assertIn("broken", self.bounded().words)

    def test_names_in_words_are_visible(self):
        collected = self.tar(("../\n\x1b[2J" + FIVE, b"x"))
        self.assertTrue(collected.words.isprintable())
