"""fixtures.py - shared by several tests: sentences, pages that are read back, a folder for a class, and archives, good ones
and some that no tool would make.
"""
import gzip
import html.parser
import io
import os
import pickle
import re
import resource
import struct
import subprocess
import tarfile
import tempfile
import unittest
import zipfile
import zlib
from pathlib import Path

from grade.collect import submissions


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp()).resolve()
        # Python's own way does not end a nest of 1500 folders.
        self.addCleanup(subprocess.run, ["rm", "-rf", str(self.work)], check=True)


class Sentences(WithFolder):
    """A test that asserts several things of one run, each in a sentence of its own. One that does not hold is a
    failure by that name, and the others are still looked at."""
    maxDiff = None

    def check(self, sentence: str, holds, seen: object = "") -> None:
        """holds: what is asserted; seen: what was there instead."""
        with self.subTest(sentence):
            self.assertTrue(holds, f"saw {str(seen)[:600]}")

    def skip(self, why: str) -> None:
        with self.subTest(why):
            self.skipTest(why)


class Page(html.parser.HTMLParser):
    """The parts of a page: its tags, attributes, URLs and words."""

    def __init__(self, text: str):
        super().__init__(convert_charrefs=True)
        self.tags, self.attributes, self.urls, self.words, self.open = [], set(), [], [], []
        self.other = []
        self.feed(text)
        self.close()

    def handle_starttag(self, name, attributes):
        self.tags.append(name)
        self.attributes |= {key for key, _ in attributes}
        self.urls += [(key, value) for key, value in attributes if key in ("href", "src")]
        if name not in ("meta", "img"):
            self.open.append(name)

    def handle_endtag(self, name):
        assert self.open.pop() == name, name

    def handle_data(self, data):
        self.words.append(data)

    def handle_comment(self, data):
        self.other.append(data)

    def handle_pi(self, data):
        self.other.append(data)

    def unknown_decl(self, data):
        self.other.append(data)


STEMS = ["01-corners", "05-quadratic"]
ONE, FIVE = "01-corners.c", "05-quadratic.c"
MB = 1024 * 1024


def lay(folder: Path, files: dict) -> None:
    """path in the folder -> bytes; a path that ends in / is a folder."""
    for name, content in files.items():
        path = folder / name
        if name.endswith("/"):
            path.mkdir(parents=True)
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


class Scratch(WithFolder):
    def setUp(self):
        super().setUp()
        self.room = self.work / "class"
        self.room.mkdir()

    def clear(self):
        for path in self.room.iterdir():
            subprocess.run(["rm", "-rf", "--", path], check=True)

    def lay(self, files: dict):
        """In the class's folder."""
        lay(self.room, files)

    def secret(self, name) -> Path:
        """A file outside the class's folder."""
        path = self.work / "secrets" / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(b"secret")
        return path

    def put(self, name, content=b"int a;\n", who="anna"):
        path = os.path.join(os.fsencode(self.room / who), os.fsencode(name))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content)
        return path

    def collect(self):
        found, _ = submissions.find(self.room)
        self.assertEqual(len(found), 1)
        return submissions.collect(found[0], STEMS)

    def answer(self, stem="05-quadratic"):
        return self.collect().answers[stem]


def zipped(*members, method=zipfile.ZIP_DEFLATED) -> bytes:
    """members: (name or ZipInfo, bytes)"""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", method) as archive:
        for name, content in members:
            archive.writestr(name, content)
    return memory.getvalue()


def tarred(*members, mode="w", **options) -> bytes:
    """members: (name or TarInfo, bytes)"""
    memory = io.BytesIO()
    with tarfile.open(fileobj=memory, mode=mode, **options) as archive:
        for name, content in members:
            info = name if isinstance(name, tarfile.TarInfo) else tarfile.TarInfo(name)
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    return memory.getvalue()


def member(name, kind, link="") -> tarfile.TarInfo:
    info = tarfile.TarInfo(name)
    info.type, info.linkname = kind, link
    return info


def header(name, size, kind=tarfile.REGTYPE) -> bytes:
    info = member(name, kind)
    info.size = size
    return info.tobuf(tarfile.GNU_FORMAT)


def central(raw: bytes, **changes) -> bytes:
    """A zip with other numbers in the first entry of its table."""
    fields = {"flags": (8, "<H"), "method": (10, "<H"), "sum": (16, "<L"), "packed": (20, "<L"),
              "size": (24, "<L"), "offset": (42, "<L")}
    at = raw.rindex(b"PK\1\2")
    raw = bytearray(raw)
    for field, value in changes.items():
        struct.pack_into(fields[field][1], raw, at + fields[field][0], value)
    return bytes(raw)


def locked(raw: bytes) -> bytes:
    """A zip whose members all say that they are encrypted."""
    return re.sub(b"(PK\\x01\\x02.{4}).", lambda match: match[1] + b"\1", raw, flags=re.S)


def end_of_zip(size: int, offset: int) -> bytes:
    """The last record of a zip, for a table of that size."""
    return struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 9, 9, size, offset, 0)


def zeros_packed(megabytes: int) -> bytes:
    """A deflate stream of that many MB of zeros, made by repeating one piece."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    piece = packer.compress(bytes(8 * MB)) + packer.flush(zlib.Z_FULL_FLUSH)
    return piece * (megabytes // 8) + packer.flush()


class Archive(Scratch):
    def archive(self, name, content):
        (self.room / name).write_bytes(content)
        return self.room / name

    def zip(self, *members, **options):
        self.archive("anna.zip", zipped(*members, **options))
        return self.collect()

    def tar(self, *members, **options):
        self.archive("anna.tar.gz", gzip.compress(tarred(*members, **options)))
        return self.collect()

    def five(self, collected):
        answer = collected.answers["05-quadratic"]
        return answer.state, answer.file, answer.text

    def bounded(self, seconds=2, megabytes=400):
        """collect in a process of its own, that must not need more than this."""
        ours, theirs = os.pipe()
        child = os.fork()
        if child == 0:
            status = 1
            try:
                resource.setrlimit(resource.RLIMIT_AS, (megabytes * MB, megabytes * MB))
                resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
                with open(theirs, "wb") as pipe:
                    pickle.dump(self.collect(), pipe)
                status = 0
            finally:
                os._exit(status)
        os.close(theirs)
        with open(ours, "rb") as pipe:
            raw = pipe.read()
        _, status, usage = os.wait4(child, 0)
        self.assertEqual(status, 0)
        self.assertLess(usage.ru_utime + usage.ru_stime, seconds)
        return pickle.loads(raw)
