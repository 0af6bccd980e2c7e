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
from .fixtures import FIVE, MB, ONE, STEMS, Archive, central, header, member, tarred, zipped


def renamed(name: str) -> zipfile.ZipInfo:
    """With a name that zipfile itself would change."""
    info = zipfile.ZipInfo("x")
    info.filename = name
    return info


def zip64(name: str, content: bytes) -> bytes:
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w") as archive, archive.open(name, "w", force_zip64=True) as file:
        file.write(content)
    return memory.getvalue()


def gz(*members, **options) -> bytes:
    return gzip.compress(tarred(*members, **options))


def nested(depth: int, content: bytes = b"x") -> bytes:
    raw = zipped((FIVE, content))
    for _ in range(depth):
        raw = zipped(("inner.zip", raw))
    return raw


X, LONG = (FIVE, b"x"), "long/" * 19 + FIVE
OF_A_MAC = [(name + FIVE, b"x") for name in ("__MACOSX/", "__MACOSX/._", "._")]
# A sentence, an archive, and of the answer in it to 05: its state, its file and its text.
ARCHIVES = [
    *[("a zip and a tar are read at any depth", name, pack(("week 3/é/" + FIVE, b"int a;\r\n"), (ONE, b"int b;\n")),
       "found", "week 3/é/" + FIVE, b"int a;\n") for name, pack in (("anna.zip", zipped), ("anna.tar.gz", gz))],
    *[("every kind of tar is read", name, pack(tarred((LONG, b"x"), format=form)), "found", LONG, b"x")
      for form in (tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT)
      for name, pack in (("a.tar", bytes), ("a.tgz", gzip.compress), ("a.TAR.GZ", gzip.compress))],
    ("a stored zip is read", "anna.zip", zipped(X, method=zipfile.ZIP_STORED), "found", FIVE, b"x"),
    ("a zip64 is read", "anna.zip", zip64(*X), "found", FIVE, b"x"),
    ("Windows separators are separators", "anna.zip", zipped((renamed("week\\" + FIVE), b"x")), "found", "week/" + FIVE, b"x"),
    ("the contents count, not the name", "anna.tar.gz", zipped(X), "found", FIVE, b"x"),
    ("the contents count, not the name", "anna.zip", gz(X), "found", FIVE, b"x"),
    ("the contents count, not the name", "anna.zip", tarred(X), "found", FIVE, b"x"),
    *[("a tar may begin like another kind", "anna.tar.gz", tarred((f"{folder}/{FIVE}", b"x")), "found", f"{shown}/{FIVE}", b"x")
      for folder, shown in (("PK\3\4", r"PK\x03\x04"), ("BZhang", "BZhang"), ("Rar!", "Rar!"))],
    *[("files added by a Mac are not answers", name, pack(*OF_A_MAC), "missing", "", b"")
      for name, pack in (("anna.zip", zipped), ("anna.tar.gz", gz))],
    ("a folder is not an answer", "anna.zip", zipped((FIVE + "/", b"")), "missing", "", b""),
    ("a folder is not an answer", "anna.tar.gz", gz((member(FIVE, tarfile.DIRTYPE), b"")), "missing", "", b""),
    *[("two that differ are not guessed between", name, pack(("a/" + FIVE, b"x"), ("b/" + FIVE, b"y")), "twice", "", b"")
      for name, pack in (("anna.zip", zipped), ("anna.tar.gz", gz))],
    *[("two that are the same count as one", name, pack(("a/" + FIVE, b"x"), ("b/" + FIVE, b"x")), "found", "a/" + FIVE, b"x")
      for name, pack in (("anna.zip", zipped), ("anna.tar.gz", gz))],
    *[("an archive in an archive is read to depth 2", "anna.zip", nested(depth), "found", "inner.zip/" * depth + FIVE, b"x")
      for depth in range(3)],
    *[("every kind is read in every other", outer, pack((f"mine/{name}", raw)), "found", f"mine/{name}/{FIVE}", b"x")
      for name, raw in (("a.zip", zipped(X)), ("a.tar", tarred(X)), ("a.tar.gz", gz(X)), ("a.tgz", gz(X)))
      for outer, pack in (("anna.zip", zipped), ("anna.tar", tarred))],
]


def link_in_zip() -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(FIVE)
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    return info


def with_a_bad_member() -> bytes:
    raw = zipped(("bad.zip", nested(0)), ("good.zip", nested(0)))
    at = zipfile.ZipFile(io.BytesIO(raw)).infolist()[0].header_offset + 30 + len("bad.zip") + 4
    return raw[:at] + bytes([raw[at] ^ 0xff]) + raw[at + 1:]


TEXT = b"int a;\n" * 100
# A sentence, what is handed in, the state of its answer to 05, and what is said of it.
SAID = [
    *[("a link or a device in a tar is not followed", {"anna.tar.gz": gz(("x.c", b"secret"), (member(FIVE, kind, link), b""))},
       "missing", f"{FIVE} is ")
      for kind, link in ((tarfile.SYMTYPE, "/etc/passwd"), (tarfile.LNKTYPE, "x.c"), (tarfile.CHRTYPE, ""),
                         (tarfile.FIFOTYPE, ""))],
    ("a link in a zip is not followed", {"anna.zip": zipped((link_in_zip(), b"/etc/passwd"))}, "missing", "not followed"),
    ("an encrypted member is said", {"anna.zip": central(zipped(X), flags=1)}, "unreadable", "it is encrypted"),
    *[("a method that nobody reads is said", {"anna.zip": zipped(X, method=method)}, "unreadable", "expected deflate")
      for method in (zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA)],
    ("a method that does not exist is said", {"anna.zip": central(zipped(X), method=99)}, "unreadable", ""),
    *[("a size, a sum or a place that lies is said", {"anna.zip": central(zipped((FIVE, TEXT)), **lie)}, "unreadable",
       "cannot be read")
      for lie in ({"size": 7, "sum": zlib.crc32(b"int a;\n")}, {"size": 701}, {"size": 0}, {"sum": 1}, {"packed": 3},
                  {"offset": 7}, {"offset": 1 << 31})],
    ("a size of 2 GB that lies is said", {"anna.zip": central(zipped((FIVE, TEXT)), size=1 << 31)}, "unreadable",
     "is larger than 256 KB"),
    ("a broken archive inside costs nothing else", {"anna/broken.zip": b"no archive", "anna/good.zip": zipped(X)}, "found",
     "broken.zip: the archive is broken"),
    ("a member of a zip that cannot be read costs nothing else", {"anna.zip": with_a_bad_member()}, "found",
     "bad.zip cannot be read"),
    ("two archives that differ are not guessed between", {"anna/a.zip": zipped(X), "anna/b.zip": zipped((FIVE, b"y"))},
     "twice", "2 files are called"),
    ("a broken header in the middle of a tar is said",
     {"anna.tar": tarred(X)[:1024] + b"y" * 512 + tarred((ONE, b"x"))}, "found", "the archive is broken after 1 members"),
    ("why the search ended comes before what is odd",
     {"anna.tar": tarred(*((f"../{i}", b"x") for i in range(20)))[:20 * 1024] + b"y" * 512}, "missing",
     "the archive is broken after 20 members; a member's path leads out"),
    ("a file outside counts before one inside", {"anna/old.zip": zipped((FIVE, b"old"), (ONE, b"one")), f"anna/{FIVE}": b"new"},
     "found", "in an archive beside it there is another, which does not count: old.zip/" + FIVE),
    ("an archive 3 deep in others is not read", {"anna.zip": nested(3)}, "missing",
     "an archive 3 deep in others is not opened: inner.zip/inner.zip/inner.zip"),
]


class WellMade(Archive):
    def test_each_archive_has_its_answer(self):
        for sentence, name, raw, *wanted in ARCHIVES:
            with self.subTest(sentence):
                self.clear()
                self.archive(name, raw)
                self.assertEqual([*self.five(self.collect())], wanted, name)

    def test_there_is_nothing_to_say_of_a_good_one(self):
        for how in (self.zip, self.tar):
            collected = how(("week 3/é/" + FIVE, b"int a;\r\n"), (ONE, b"int b;\n"))
            self.assertEqual((collected.answers["01-corners"].text, collected.words, collected.empty), (b"int b;\n", "", False))
            self.clear()

    def test_what_is_wrong_is_said(self):
        for sentence, files, state, words in SAID:
            with self.subTest(sentence):
                self.clear()
                self.lay(files)
                collected = self.collect()
                answer = collected.answers["05-quadratic"]
                said = f"{collected.words}; {answer.words}"
                self.assertEqual(answer.state, state, said)
                self.assertTrue(words in said and len(said) > 2 and said.isprintable(), said)
                self.assertIn(answer.text, (b"", b"x", b"new"))

    def test_an_answer_of_256_KB_is_read_and_no_more(self):
        for how in (self.zip, self.tar):
            for more, words in ((0, ""), (1, FIVE + " is larger than 256 KB"),
                                (99, FIVE + " is larger than 256 KB")):
                answer = how((FIVE, b"/" * (256 * 1024 + more))).answers["05-quadratic"]
                self.assertEqual((answer.state, answer.words),
                                 ("unreadable" if more else "found", words))
            self.clear()

    def test_the_time_is_that_of_the_archive(self):
        os.utime(self.archive("anna.zip", zipped((FIVE, b"x"))), (0, 4000))
        self.assertEqual(self.collect().when, 4000)


class Escapes(Archive):
    def test_paths_that_lead_out_are_refused_and_nothing_is_written(self):
        names = ["../../" + FIVE, "/etc/" + FIVE, "a/../../" + FIVE, "..//" + FIVE]
        for how, extra in ((self.zip, ["..\\" + FIVE, "C:\\" + FIVE]), (self.tar, [])):
            for name in names + extra:
                before = sorted(self.work.rglob("*"))
                collected = how((renamed(name) if how == self.zip else name, b"x"))
                self.assertTrue(collected.empty)
                self.assertIn("leads out of the archive", collected.words)
                self.assertLessEqual(len(sorted(self.work.rglob("*"))), len(before) + 1)
            self.clear()

    def test_an_archive_that_became_a_link_or_a_fifo_is_not_opened(self):
        self.archive("anna.zip", zipped((FIVE, b"x")))
        found, _ = submissions.find(self.room)
        os.rename(self.room / "anna.zip", self.work / "x.zip")
        (self.room / "anna.zip").symlink_to(self.work / "x.zip")
        self.assertTrue(submissions.collect(found[0], STEMS).empty)
        (self.room / "anna.zip").unlink()
        os.mkfifo(self.room / "anna.zip")
        self.assertEqual(submissions.collect(found[0], STEMS).words,
                         "cannot be read: it is not a file")


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

    def test_xz_and_bzip2_are_read_also_of_several_streams(self):
        tar = tarred(X)
        for name, raw in (("anna.tar.xz", lzma.compress(tar)), ("anna.txz", lzma.compress(tar) + bytes(8)),
                          ("anna.tar.bz2", bz2.compress(tar)), ("anna.tbz2", bz2.compress(tar[:700]) + bz2.compress(tar[700:])),
                          ("anna.zip", lzma.compress(tar[:700]) + bytes(4) + lzma.compress(tar[700:]))):
            self.archive(name, raw)
            self.assertEqual(self.five(self.collect()), ("found", FIVE, b"x"), name)
            self.clear()

    def test_they_are_read_inside_others(self):
        self.put("all.rar", rar(FIVE, b"x"))
        self.put("all.7z", by_bsdtar("7zip", tarred((ONE, b"y"))))
        collected = self.collect()
        self.assertEqual(self.five(collected), ("found", "all.rar/" + FIVE, b"x"))
        self.assertEqual(collected.answers["01-corners"].file, "all.7z/" + ONE)

    def test_a_bomb_is_refused(self):
        tar = tarred(("zeros", bytes(40 * MB)), (FIVE, b"x"))
        for pack in (lambda tar: by_bsdtar("7zip", tar), lzma.compress, bz2.compress):
            self.archive("anna.7z", pack(tar))
            with mock.patch.object(archives, "STREAM", 32 * MB):
                self.assertEqual(self.collect().words, "decompresses to more than 32 MB; no more was read")

    def test_links_in_it_lead_nowhere(self):
        (self.work / "in").mkdir()
        (self.work / "in" / FIVE).symlink_to(self.secret("secret"))
        subprocess.run(["bsdtar", "-c", "-f", self.room / "anna.7z", "--format=7zip", "-C", self.work / "in", FIVE], check=True)
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
    def test_a_folder_with_archives_is_read(self):
        self.put("week 1/one.zip", zipped((ONE, b"x")))
        self.put("week 2/five.tar.gz", gz((FIVE, b"y")))
        collected = self.collect()
        self.assertEqual([(a.file, a.text) for a in collected.answers.values()],
                         [("week 1/one.zip/" + ONE, b"x"), ("week 2/five.tar.gz/" + FIVE, b"y")])

    def test_links_that_are_called_like_archives_are_not_followed(self):
        self.put("x.txt")
        self.secret("all.zip").write_bytes(nested(0))
        (self.room / "anna" / "all.zip").symlink_to(self.work / "secrets" / "all.zip")
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
    def test_every_truncated_archive_has_words_and_no_half_answer(self):
        # A text that cannot be made smaller: a byte that is missing is missing in it.
        text = b"".join(b"%x\n" % (i * i * 7919) for i in range(1000))
        tar = tarred((FIVE, text))
        wholes = {"a.zip": zipped((FIVE, text)), "a.tar.gz": gzip.compress(tar), "a.tar": tar}
        if shutil.which("bsdtar"):
            wholes |= {"a.7z": by_bsdtar("7zip", tar), "a.rar": rar(FIVE, text), "a.tar.xz": lzma.compress(tar)}
        for name, whole in wholes.items():
            for length in range(4, len(whole) - 1, len(whole) // (23 if name[-2:] in ("ip", "gz") else 4)):
                self.archive(name, whole[:length])
                collected = self.collect()
                state, _, held = self.five(collected)
                self.assertIn((state, held), (("found", text), ("missing", b""), ("unreadable", b"")))
                self.assertTrue(state == "found" or collected.words, (name, length))
            self.clear()

    def test_archives_with_any_byte_wrong_stop_nobody(self):
        for name, whole in (("a.zip", zipped((FIVE, b"int a;"), ("b/" + FIVE, b"int a;"))),
                            ("a.tar.gz", gzip.compress(tarred((FIVE, b"int a;")), mtime=0)),
                            ("a.tar", tarred((FIVE, b"int a;"), format=tarfile.PAX_FORMAT)[:1536])):
            for at in range(len(whole)):
                path = self.archive(name, whole[:at] + bytes([whole[at] ^ 0x81]) + whole[at + 1:])
                self.collect()
            path.unlink()

    def test_sizes_below_zero_end(self):
        # Python's own tarfile once walked in circles here.
        for size in (-512, -1024, -(1 << 40)):
            self.archive("anna.tar", header("x", 0) + header(FIVE, size) + header("y", 0) * 2)
            self.assertIn("broken", self.bounded().words)

    def test_names_in_words_are_visible(self):
        collected = self.tar(("../\n\x1b[2J" + FIVE, b"x"))
        self.assertTrue(collected.words.isprintable())
