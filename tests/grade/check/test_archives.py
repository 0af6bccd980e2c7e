"""test_archives.py - answers in archives of every kind, and in archives inside them; and archives that lead out, are
cut off, damaged, or lie.
"""
import bz2
import gzip
import io
import lzma
import os
import shutil
import signal
import stat
import struct
import subprocess
import tarfile
import unittest
import zipfile
import zlib
from unittest import mock

from grade.collect import archives, streams, submissions
from grade.confine.machine import GraderFailed
from .fixtures import FIVE, MB, STEMS, Archive, central, header, member, tarred, zipped


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


ONE = "01-corners.c"


def rar(name: str, content: bytes) -> bytes:
    """A RAR of version 4 with one member, as it is, by the format's description."""
    def block(kind: int, flags: int, fields: bytes, more: bytes = b"") -> bytes:
        head = struct.pack("<BHH", kind, flags, 7 + len(fields)) + fields
        return struct.pack("<H", zlib.crc32(head) & 0xffff) + head + more
    raw = name.encode()
    file = struct.pack("<LLBLLBBHL", len(content), len(content), 3, zlib.crc32(content), 0x5a21_0000, 29, 0x30,
                       len(raw), 0o100644) + raw
    return b"Rar!\x1a\x07\0" + block(0x73, 0, bytes(6)) + block(0x74, 0x8000, file, content) + block(0x7b, 0x4000, b"")


def by_bsdtar(form: str, tar: bytes) -> bytes:
    return subprocess.run(["bsdtar", "-c", "-f", "-", f"--format={form}", "@-"], input=tar, check=True,
                          stdout=subprocess.PIPE).stdout


def nested(depth: int, content: bytes = b"x") -> bytes:
    raw = zipped((FIVE, content))
    for _ in range(depth):
        raw = zipped(("inner.zip", raw))
    return raw


class Kinds(Archive):
    def test_xz_and_bzip2_are_read(self):
        tar = tarred(("a/" + FIVE, b"int a;\r\n"))
        for name, raw in (("anna.tar.xz", lzma.compress(tar)), ("anna.txz", lzma.compress(tar) + bytes(8)),
                          ("anna.tar.bz2", bz2.compress(tar)),
                          ("anna.tbz2", bz2.compress(tar[:700]) + bz2.compress(tar[700:])),
                          ("anna.zip", lzma.compress(tar[:700]) + bytes(4) + lzma.compress(tar[700:]))):
            path = self.archive(name, raw)
            self.assertEqual(self.five(self.collect()), ("found", "a/" + FIVE, b"int a;\n"), name)
            path.unlink()

    def test_those_that_are_cut_off_or_damaged_have_words(self):
        # A text that cannot be made smaller: a byte that is missing is missing in it.
        text = b"".join(b"%x\n" % (i * i * 7919) for i in range(4000))
        for pack in (lzma.compress, bz2.compress):
            whole = pack(tarred((FIVE, text)))
            for length in range(1, len(whole) - 1, len(whole) // 23):
                self.archive("anna.tar.xz", whole[:length])
                collected = self.collect()
                self.assertIn(self.five(collected)[::2], (("found", text), ("missing", b""), ("unreadable", b"")))
                self.assertTrue(self.five(collected)[0] == "found" or collected.words, length)

    def test_bombs_of_xz_and_bzip2_are_refused(self):
        start = tarred((ONE, b"x"))[:1024] + header(FIVE, 1 << 30)
        for pack in (lzma.compress, bz2.compress):
            self.archive("anna.tar.xz", pack(start + bytes(40 * MB)))
            with mock.patch.object(archives, "STREAM", 32 * MB):
                collected = self.collect()
            self.assertEqual(collected.answers["01-corners"].text, b"x")
            self.assertEqual(collected.words, "decompresses to more than 32 MB; no more was read")
            self.assertEqual(self.five(collected)[2], b"")

    def test_an_xz_that_wants_much_memory_is_refused(self):
        filters = [{"id": lzma.FILTER_LZMA2, "dict_size": 8 * MB}]
        self.archive("anna.tar.xz", lzma.compress(tarred((FIVE, b"x")), filters=filters))
        with mock.patch.object(streams, "XZ_MEMORY", MB):
            self.assertIn("the archive is broken: Memory usage limit", self.collect().words)


@unittest.skipUnless(shutil.which("bsdtar"), "7-Zip and RAR: no bsdtar (make setup FOR=instructor)")
class ByProgram(Archive):
    def test_7zip_and_rar_and_zstandard_are_read(self):
        tar = tarred(("a/é/" + FIVE, b"int a;\r\n"), (ONE, b"int b;\n"))
        self.archive("anna.7z", by_bsdtar("7zip", tar))
        collected = self.collect()
        self.assertEqual(self.five(collected), ("found", "a/é/" + FIVE, b"int a;\n"))
        self.assertEqual((collected.answers["01-corners"].text, collected.words), (b"int b;\n", ""))
        self.clear()
        self.archive("anna.rar", rar("a\\" + FIVE, b"int a;\r\n"))
        self.assertEqual(self.five(self.collect()), ("found", "a/" + FIVE, b"int a;\n"))
        self.clear()
        self.archive("anna.tar.zst",
                     subprocess.run(["zstd", "-qc"], input=tar, stdout=subprocess.PIPE, check=True).stdout
                     if shutil.which("zstd") else tar)
        self.assertEqual(self.five(self.collect())[0], "found")

    def test_they_are_read_inside_others(self):
        self.put("all.rar", rar(FIVE, b"x"))
        self.put("all.7z", by_bsdtar("7zip", tarred((ONE, b"y"))))
        collected = self.collect()
        self.assertEqual(self.five(collected), ("found", "all.rar/" + FIVE, b"x"))
        self.assertEqual(collected.answers["01-corners"].file, "all.7z/" + ONE)

    def test_what_is_damaged_has_words(self):
        for whole in (by_bsdtar("7zip", tarred((FIVE, b"int a;\n" * 50))), rar(FIVE, b"int a;\n" * 50)):
            for at in (4, len(whole) // 3, len(whole) // 2, len(whole) - 3):
                self.archive("anna.7z", whole[:at])
                collected = self.collect()
                self.assertTrue(collected.words or self.five(collected)[2] == b"int a;\n" * 50, at)

    def test_a_bomb_is_refused(self):
        self.archive("anna.7z", by_bsdtar("7zip", tarred(("zeros", bytes(40 * MB)), (FIVE, b"x"))))
        with mock.patch.object(archives, "STREAM", 32 * MB):
            self.assertEqual(self.collect().words, "decompresses to more than 32 MB; no more was read")

    def test_links_in_it_lead_nowhere(self):
        (self.top / "secret").write_bytes(b"secret")
        (self.top / "in").mkdir()
        (self.top / "in" / FIVE).symlink_to(self.top / "secret")
        subprocess.run(["bsdtar", "-c", "-f", str(self.room / "anna.7z"), "--format=7zip", "-C", str(self.top / "in"),
                        FIVE],
                       check=True)
        collected = self.collect()
        self.assertEqual(self.five(collected), ("missing", "", b""))
        self.assertIn("a link, not followed", collected.answers["05-quadratic"].words)

    def opened_by(self, *openers):
        """What is collected if each start of the program is told by the next of these, and later ones by the last."""
        self.archive("anna.7z", by_bsdtar("7zip", tarred((FIVE, b"x"))))
        found, _ = submissions.find(self.room)
        waiting = list(openers)
        return submissions.collect(found[0], STEMS,
                                   lambda command: (waiting.pop(0) if len(waiting) > 1 else waiting[0])(command))

    def test_the_program_runs_as_it_is_told(self):
        asked = []
        collected = self.opened_by(lambda command: asked.append(command) or ["sh", "-c", 'exec "$@"', "sh", *command])
        self.assertEqual((len(asked), asked[0][0].endswith("bsdtar"), self.five(collected)[0]), (1, True, "found"))

    def test_a_signal_to_the_program_is_the_grader_s_failure(self):
        for name in ("TERM", "HUP", "INT", "KILL"):
            for before in ("", '"$@" | head -c 700; '):
                with self.assertRaisesRegex(GraderFailed, "^reading 7-Zip: "):
                    self.opened_by(lambda command: ["sh", "-c", f"{before}kill -{name} $$", "sh", *command])
            with self.assertRaisesRegex(GraderFailed, "^reading 7-Zip: "):   # as the sandbox reports it
                self.opened_by(lambda command: ["sh", "-c", f"exit {128 + signal.Signals['SIG' + name]}"])

    def test_a_program_that_refuses_everything_or_is_not_there_is_the_grader_s_failure(self):
        for command in (["false"], ["sh", "-c", "exit 126"], ["/no/such/program"], ["true"]):
            with self.assertRaises(GraderFailed):
                self.opened_by(lambda _: command)

    def test_an_archive_that_is_refused_once_is_read(self):
        self.assertEqual(self.five(self.opened_by(lambda _: ["false"], lambda command: command))[0], "found")


class WithoutProgram(Archive):
    def setUp(self):
        super().setUp()
        without = mock.patch.object(streams.shutil, "which", return_value=None)
        without.start()
        self.addCleanup(without.stop)

    def test_that_is_the_grader_s_failure(self):
        for magic, kind in ((b"Rar!\x1a\7", "RAR"), (b"7z\xbc\xaf\x27\x1c", "7-Zip")):
            self.archive("anna.zip", magic + bytes(600))
            self.assertRaisesRegex(GraderFailed, f"it takes bsdtar to read {kind} .'make setup", self.collect)

    def test_it_costs_nothing_where_all_answers_are_outside(self):
        for name in (ONE, FIVE):
            self.put(name, b"x")
        self.put("old.rar", b"Rar!\x1a\7" + bytes(600))
        self.assertEqual([answer.text for answer in self.collect().answers.values()], [b"x", b"x"])


class Inside(Archive):
    def test_an_archive_in_an_archive_is_read_to_depth_2(self):
        for depth in range(4):
            self.archive("anna.zip", nested(depth))
            collected = self.collect()
            if depth <= 2:
                self.assertEqual(self.five(collected), ("found", "inner.zip/" * depth + FIVE, b"x"))
                self.assertEqual(collected.words, "")
            else:
                self.assertEqual((collected.empty, collected.words),
                                 (True, "an archive 3 deep in others is not opened: inner.zip/inner.zip/inner.zip"))

    def test_every_kind_in_every_other(self):
        tar = tarred((FIVE, b"x"))
        inside = {"a.zip": zipped((FIVE, b"x")), "a.tar": tar, "a.tar.gz": gzip.compress(tar),
                  "a.tgz": gzip.compress(tar),
                  "a.tar.xz": lzma.compress(tar), "a.tar.bz2": bz2.compress(tar)}
        for name, raw in inside.items():
            for outer, pack in (("anna.zip", zipped), ("anna.tar", tarred)):
                path = self.archive(outer, pack(("mine/" + name, raw)))
                self.assertEqual(self.five(self.collect()), ("found", f"mine/{name}/{FIVE}", b"x"), (outer, name))
                path.unlink()

    def test_a_folder_with_archives_is_read(self):
        self.put("week 1/one.zip", zipped((ONE, b"x")))
        self.put("week 2/five.tar.gz", gzip.compress(tarred((FIVE, b"y"))))
        collected = self.collect()
        self.assertEqual([(a.file, a.text) for a in collected.answers.values()],
                         [("week 1/one.zip/" + ONE, b"x"), ("week 2/five.tar.gz/" + FIVE, b"y")])

    def test_a_file_outside_counts_before_one_inside(self):
        self.put("old.zip", zipped((FIVE, b"old"), (ONE, b"one")))
        self.put(FIVE, b"new")
        collected = self.collect()
        self.assertEqual(self.five(collected), ("found", FIVE, b"new"))
        self.assertEqual(collected.answers["05-quadratic"].words,
                         "in an archive beside it there is another, which does not count: old.zip/" + FIVE)
        self.assertEqual(collected.answers["01-corners"].text, b"one")

    def test_two_archives_that_differ_are_not_guessed_between(self):
        self.put("a.zip", zipped((FIVE, b"x")))
        self.put("b.zip", zipped((FIVE, b"y")))
        self.assertEqual(self.five(self.collect())[0], "twice")

    def test_a_broken_one_inside_is_said_and_costs_nothing_else(self):
        self.put("broken.zip", b"no archive")
        self.put("good.zip", zipped((FIVE, b"x")))
        collected = self.collect()
        self.assertEqual(self.five(collected)[0], "found")
        self.assertIn("broken.zip: the archive is broken", collected.words)

    def test_a_member_that_cannot_be_read_inside_a_zip_is_said(self):
        raw = zipped(("bad.zip", nested(0)), ("good.zip", nested(0)))
        info = zipfile.ZipFile(io.BytesIO(raw)).infolist()[0]
        at = info.header_offset + 30 + len("bad.zip") + 4
        self.archive("anna.zip", raw[:at] + bytes([raw[at] ^ 0xff]) + raw[at + 1:])
        collected = self.collect()
        self.assertEqual(self.five(collected), ("found", "good.zip/" + FIVE, b"x"))
        self.assertIn("bad.zip cannot be read", collected.words)

    def test_links_that_are_called_like_archives_are_not_followed(self):
        (self.top / "secret.zip").write_bytes(nested(0))
        self.put("x.txt")
        (self.room / "anna" / "all.zip").symlink_to(self.top / "secret.zip")
        self.assertTrue(self.collect().empty)

    def test_an_archive_of_itself_ends(self):
        # Each opens a dozen more: a million, if nobody counted.
        raw = zipped((FIVE, b"x"))
        for _ in range(2):
            raw = zipped(*((f"{i}.zip", raw) for i in range(100)))
        self.archive("anna.zip", raw)
        collected = self.bounded()
        self.assertEqual(collected.words, f"holds more than {archives.ARCHIVES} archives; no more were opened")

    def test_bombs_inside_share_the_limits(self):
        bomb = zipped(("bomb.zip", bytes(9 * MB)))
        for raw in (bomb, zipped(("a.zip", bomb)),
                    zipped(*((f"{i}.zip", zipped((f"{i}.zip", bytes(MB)))) for i in range(9)))):
            self.archive("anna.zip", raw)
            with mock.patch.object(archives, "KEPT", 4 * MB):
                collected = self.collect()
            self.assertTrue(collected.empty)
            self.assertIn("is larger than 4 MB, with what else there is", collected.words)

    def test_members_are_counted_together(self):
        inner = zipped(*((f"{i}", b"") for i in range(20)))
        self.archive("anna.zip", zipped(*((f"{i}.zip", inner) for i in range(4))))
        with mock.patch.object(archives, "MEMBERS", 50):
            self.assertEqual(self.collect().words, "holds more than 50 members; no more were looked at")


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
