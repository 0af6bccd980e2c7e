"""streams.py - a file that somebody else made, and a compressed archive as the tar that is in it, piece by piece.

gzip is read here. All others are read by bsdtar (libarchive), which writes what they hold as a tar; it runs where
compilers run, with nothing but the archive to read.
"""
import io
import os
import resource
import shutil
import stat
import subprocess
import tarfile
import zlib
from contextlib import contextmanager

from grade.confine.machine import CRASHES, LIMITS, GraderFailed, limit, must_be_its_own, statuses_of
from grade.visible import visible, why

# Should it have become a fifo since it was looked at, opening it must not wait.
FILE = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC


class Enough(Exception):
    """Nothing more is looked at; the words say why."""


class File(io.FileIO):
    def readinto(self, buffer):
        try:
            return super().readinto(buffer)
        except OSError as error:
            must_be_its_own(error)
            raise


def opened_file(name, folder=None):
    """A regular file; OSError where it is something else."""
    try:
        file = io.BufferedReader(File(os.open(name, FILE, dir_fd=folder)))
    except OSError as error:
        must_be_its_own(error)
        raise
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(0, "it is not a file")
    return file


# ---- compressed ---------------------------------------------------------------------------------


CHUNK = 64 * 1024
STREAMS = 1000              # compressed streams, one after the other, in one file
SECONDS, MEMORY = 10, 1 << 30   # of work for bsdtar, and its memory
# The first bytes of a file, and the format that they mean.
KINDS = {b"\x1f\x8b": "gzip", b"\xfd7zXZ\0": "xz", b"BZh": "bzip2", b"7z\xbc\xaf\x27\x1c": "7-Zip",
         b"Rar!\x1a\x07": "RAR", b"\x28\xb5\x2f\xfd": "Zstandard"}


# How bsdtar ends if it can read an archive, or if something is wrong with that.
ENDINGS = {0, 1} | statuses_of(CRASHES | LIMITS) | {-number for number in CRASHES | LIMITS}


class Unreadable(Exception):
    """An archive that a program cannot read; the words say why."""


class NotHere(Unreadable):
    """An archive that could be read if this machine had what it takes: no fault of the archive's."""


def kind_of(head: bytes):
    return next((kind for magic, kind in KINDS.items() if head.startswith(magic)), None)


class Inflated:
    """The decompressed contents of a gzip file, of all its streams. The gzip module would read a header's comment, of any
    length, byte by byte."""
    def __init__(self, file):
        self.file = file
        self.engine = zlib.decompressobj(31)
        self.streams = 1

    def read(self, size: int) -> bytes:
        while True:
            if self.engine.eof:
                raw = (self.engine.unused_data or self.file.read(CHUNK)).lstrip(b"\0")
                if not raw:
                    return b""
                self.streams += 1
                if self.streams > STREAMS:
                    raise Enough(f"is made of more than {STREAMS} compressed streams; "
                                 "no more was read")
                self.engine = zlib.decompressobj(31)
            else:
                raw = self.engine.unconsumed_tail or self.file.read(CHUNK)
            piece = self.engine.decompress(raw, size)
            if piece:
                return piece
            if not raw and not self.engine.eof:
                raise EOFError("it ends in the middle")


# ---- by a program -------------------------------------------------------------------------------

def limited() -> None:
    for what, most in ((resource.RLIMIT_CPU, SECONDS), (resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CORE, 0)):
        limit(what, most)


def as_file(file):
    """A descriptor of its own, at the beginning: an archive inside is in memory only."""
    try:
        handle = os.dup(file.fileno())
    except OSError:     # io.UnsupportedOperation is one
        handle = os.memfd_create("archive", os.MFD_CLOEXEC)
        left = memoryview(file.getbuffer())
        while left:
            left = left[os.write(handle, left):]
    os.lseek(handle, 0, os.SEEK_SET)
    return handle


def started(command: list, archive: int, said) -> subprocess.Popen:
    try:
        return subprocess.Popen(command, stdin=archive, stdout=subprocess.PIPE, stderr=said, preexec_fn=limited,
                                env={"LC_ALL": "C.UTF-8", "PATH": "/usr/bin:/bin"})
    except (OSError, subprocess.SubprocessError) as error:
        raise GraderFailed(f"bsdtar cannot be started: {why(error)}") from None


@contextmanager
def by_bsdtar(kind: str, file, opener):
    program = shutil.which("bsdtar")
    if program is None:
        raise NotHere(f"it takes bsdtar to read {kind} ('make setup FOR=instructor' installs it)")
    # Links and devices are not followed or made: it only writes a tar.
    command = [os.path.realpath(program), "-c", "-f", "-", "--format=pax", "@-"]
    handle, words = as_file(file), os.memfd_create("words", os.MFD_CLOEXEC)
    with open(words, "r+b") as said:
        try:
            process = started(opener(command) if opener else command, handle, said)
        finally:
            os.close(handle)
        broken = None
        try:
            try:
                yield process.stdout
            except (Enough, MemoryError):
                raise
            except Exception as error:  # perhaps the tar is cut off: then how bsdtar ended says why
                broken = error
            for _ in iter(lambda: process.stdout.read(CHUNK), b""):
                pass    # a tar is filled up with zeros
            status = process.wait()
            said.seek(0)
            lines = visible(said.read(2000).decode("utf-8", "replace").strip(), lines=True).splitlines()
            if status not in ENDINGS:
                raise GraderFailed(f"reading {kind}: {lines[-1][:200] if lines else f'bsdtar ended with {status}'}")
            if status != 0:
                raise Unreadable(f"the {kind} archive cannot be read: "
                                 + (lines[0].removeprefix("bsdtar: ")[:200] if lines else "it takes too much work"))
            if broken:
                raise Unreadable(f"the archive is broken: {why(broken)}")
        finally:
            process.kill()
            process.wait()
            process.stdout.close()


def must_read_something_right(opener) -> None:
    """The canary of by_bsdtar: a small archive. GraderFailed if that cannot be read either."""
    known = io.BytesIO()
    with tarfile.open(fileobj=known, mode="w") as archive:
        archive.addfile(tarfile.TarInfo("right"))
    try:
        with by_bsdtar("an archive", known, opener) as stream, tarfile.open(fileobj=stream, mode="r|") as archive:
            if archive.getnames() == ["right"]:
                return
    except (Unreadable, tarfile.TarError):
        pass
    raise GraderFailed("bsdtar also refused a correct archive")


@contextmanager
def opened(kind: str, file, opener):
    """The tar in a compressed file."""
    if kind == "gzip":
        yield Inflated(file)
    else:
        with by_bsdtar(kind, file, opener) as stream:
            yield stream
