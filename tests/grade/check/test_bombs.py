"""test_bombs.py - archives that would fill the memory, the disk or the day."""
import gzip
import struct
import tarfile
import zipfile

from grade.collect import answers, archives
from .fixtures import FIVE, MB, Archive, central, end_of_zip, header, zeros_packed, zipped


class Bombs(Archive):
    def test_a_zip_bomb_of_4_GB_is_refused(self):
        packed = zeros_packed(4096 - 8)
        whole = zipped((FIVE, b"x"), method=zipfile.ZIP_STORED)
        local, table = whole[:30 + len(FIVE)], whole[whole.index(b"PK\1\2"):]
        local = local[:8] + struct.pack("<H", 8) + local[10:]
        for size in (100, answers.LARGEST, 4088 * MB):
            raw = central(local + packed + table, method=8, packed=len(packed), size=size)
            end = raw.rindex(b"PK\5\6")
            raw = raw[:end + 16] + struct.pack("<L", len(local) + len(packed)) + raw[end + 20:]
            self.archive("anna.zip", raw)
            collected = self.bounded(1)
            self.assertEqual(self.five(collected), ("unreadable", FIVE, b""), size)

    def test_a_gzip_bomb_of_4_GB_is_refused(self):
        zeros = gzip.compress(bytes(16 * MB))
        for name in ("big", FIVE):
            start = header("01-corners.c", 1) + b"x" + bytes(511) + header(name, 4 << 30)
            self.archive("anna.tar.gz", gzip.compress(start) + zeros * 256)
            collected = self.bounded()
            self.assertEqual(collected.answers["01-corners"].text, b"x")
            self.assertEqual(self.five(collected)[2], b"")
            self.assertIn("decompresses to more than 512 MB", collected.words)

    def test_a_gzip_bomb_in_what_describes_a_member_is_refused(self):
        for kind in (tarfile.XHDTYPE, tarfile.XGLTYPE, tarfile.GNUTYPE_LONGNAME):
            self.archive("anna.tar.gz", gzip.compress(header("x", 4 << 30, kind)) +
                         gzip.compress(bytes(16 * MB)) * 256)
            self.assertIn("64 MB", self.bounded().words)

    def test_many_small_gzip_streams_are_refused(self):
        self.archive("anna.tar.gz", gzip.compress(header("x", 0)) + gzip.compress(b"") * 200000)
        self.assertIn("compressed streams", self.bounded().words)

    def test_a_gzip_header_of_60_MB_stops_nobody(self):
        self.archive("anna.tar.gz", b"\x1f\x8b\x08\x08" + bytes(6) + b"x" * (60 * MB))
        self.assertTrue(self.bounded().empty)

    def test_a_zip_of_100000_empty_members_is_looked_at_in_part(self):
        whole = zipped(("01-corners.c", b"x"), (FIVE, b"x"), ("e", b""))
        one, five, empty = (b"PK\1\2" + entry for entry in
                            whole[:whole.index(b"PK\5\6")].split(b"PK\1\2")[1:])
        at, table = whole.index(b"PK\1\2"), five + empty * 100000 + one
        self.archive("anna.zip", whole[:at] + table + end_of_zip(len(table), at))
        collected = self.bounded()
        self.assertEqual(collected.answers["01-corners"].state, "missing")
        self.assertEqual(self.five(collected)[0], "found")
        self.assertEqual(collected.words, "holds more than 50000 members; no more were looked at")

    def test_a_zip_with_a_table_of_40_MB_is_not_looked_at(self):
        entry = zipped(("x", b""))
        entry = entry[entry.index(b"PK\1\2"):entry.index(b"PK\5\6")]
        count = 40 * MB // len(entry)
        self.archive("anna.zip", entry * count + end_of_zip(len(entry) * count, 0))
        self.assertIn("more than 50000 members", self.bounded().words)

    def test_a_tar_of_100000_empty_members_is_looked_at_in_part(self):
        self.archive("anna.tar.gz", gzip.compress(header(FIVE, 0) + header("x", 0) * 100000))
        collected = self.bounded(10)
        self.assertEqual(self.five(collected)[0], "found")
        self.assertEqual(collected.words, "holds more than 50000 members; no more were looked at")

    def test_thousands_of_one_member_are_read_up_to_64_MB(self):
        # All entries of the table name the same bytes.
        whole = zipped((FIVE, b"/" * answers.LARGEST))
        at, end = whole.index(b"PK\1\2"), whole.index(b"PK\5\6")
        self.archive("anna.zip", whole[:at] + whole[at:end] * 5000 +
                     end_of_zip((end - at) * 5000, at))
        collected = self.bounded(4)
        self.assertTrue("64 MB" in collected.words or self.five(collected)[0] != "found")

    def test_an_archive_of_more_than_256_MB_is_not_read(self):
        with open(self.room / "anna.zip", "wb") as file:
            file.truncate(archives.FILE + 1)
        self.assertEqual(self.bounded().words, "the archive is larger than 256 MB; it was not read")

    def test_a_chain_of_long_names_stops_nobody(self):
        link = header("x", 512, tarfile.GNUTYPE_LONGNAME) + b"x" * 512
        self.archive("anna.tar", link * 20000)
        self.assertTrue(self.bounded().empty)

    def test_too_little_memory_becomes_words(self):
        was = archives.look_in_zip

        def hungry(*arguments):
            was(*arguments)
            bytearray(1 << 40)
        archives.look_in_zip = hungry
        self.addCleanup(setattr, archives, "look_in_zip", was)
        self.archive("anna.zip", zipped((FIVE, b"x")))
        collected = self.bounded()
        self.assertEqual((collected.empty, collected.words),
                         (True, "reading it takes more memory than a submission may have"))
