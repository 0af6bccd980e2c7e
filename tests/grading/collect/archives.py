"""archives.py - looks for answers in a .zip, .tar.gz or .tar that somebody else made.

Members are read as streams, and nothing is written to disk: no name in an archive leads anywhere.
What a header says of sizes is not believed: what comes out is counted, and there is an end to it.
"""
import io
import os
import re
import stat
import tarfile
import zipfile
import zlib

from visible import brief, why
from . import answers
from .folders import Enough, opened_file

MEMBERS = 50000
TOTAL = 64 * 1024 * 1024    # of the archive, and of what is decompressed
STREAMS = 1000              # gzip streams, one after the other, in one file
DIRECTORY = 8 * 1024 * 1024  # the table at the end of a zip
CHUNK = 64 * 1024
OTHERS = {b"Rar!": "RAR", b"7z\xbc\xaf": "7-Zip", b"\xfd7zX": "xz", b"BZh": "bzip2"}
ZIP = (b"PK\3\4", b"PK\5\6", b"PK\7\10")  # a member, an empty archive, one in parts
LEADS_OUT = "a member's path leads out of the archive; it is refused"


def read_whole(search, parts, size: int, read) -> int:
    """A member that is an answer; how many bytes came out of it."""
    if size > answers.LARGEST:
        answers.unreadable(search, parts, f"is larger than {answers.LARGEST // 1024} KB")
        return 0
    try:
        raw = read()
    except (Enough, MemoryError):
        raise
    except Exception as error:  # whatever the libraries make of what is broken on purpose
        answers.unreadable(search, parts, f"cannot be read: {why(error)}")
        return answers.LARGEST
    if len(raw) != size:
        answers.unreadable(search, parts, "cannot be read: it is not as long as the archive says")
    else:
        answers.found(search, parts, raw)
    return len(raw)


def parts_of(search, name: str) -> list:
    """Folders and name of a member; [] where it is nothing to look at."""
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if name.startswith("/") or ".." in parts or re.match("[A-Za-z]:", name):
        answers.note(search, f"{LEADS_OUT}: {brief(name)}")
        return []
    if not parts or "__MACOSX" in parts:
        return []
    if not answers.stem_of(search, parts[-1]):
        answers.bystander(search, parts)
        return []
    return parts


# ---- zip --------------------------------------------------------------------------------------

class Careful(io.FileIO):
    """A file of which no more is read at once than the table of an honest zip needs."""
    def read(self, size=-1):
        if size < 0:
            size = max(0, os.fstat(self.fileno()).st_size - self.tell())
        if size > DIRECTORY:
            raise Enough(f"holds a table of more than {MEMBERS} members; it was not looked at")
        return super().read(size)


def zip_member(archive, info) -> bytes:
    if info.flag_bits & 0x1:
        raise ValueError("it is encrypted")
    # Only these are decompressed piece by piece.
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError(f"compression method {info.compress_type}, expected deflate")
    # Otherwise zipfile would stop where the header says, and not notice that there is more.
    info.file_size = answers.LARGEST + 1
    with archive.open(info) as file:
        return file.read(info.file_size)


def look_in_zip(search, file) -> None:
    left = TOTAL
    with Careful(file.fileno(), closefd=False) as careful, zipfile.ZipFile(careful) as archive:
        members = archive.infolist()
        if len(members) > MEMBERS:
            answers.ended_early(search, f"holds more than {MEMBERS} members; "
                                        "no more were looked at")
        for info in members[:MEMBERS]:
            # Some write Windows' separator.
            name = info.filename.replace("\\", "/")
            parts = [] if name.endswith("/") else parts_of(search, name)
            if not parts:
                continue
            if stat.S_ISLNK(info.external_attr >> 16):
                answers.no_file(search, parts, answers.NOT_FOLLOWED)
                continue
            left -= read_whole(search, parts, info.file_size, lambda: zip_member(archive, info))
            if left < 0:
                raise Enough(f"decompresses to more than {TOTAL >> 20} MB; no more was read")


# ---- tar --------------------------------------------------------------------------------------

class Inflated:
    """What a gzip file decompresses to. The gzip module would read a header's comment, of any
    length, byte by byte."""
    def __init__(self, file):
        self.file = file
        self.engine = zlib.decompressobj(31)
        self.streams = 1

    def read(self, size: int) -> bytes:
        while True:
            if self.engine.eof:
                raw = self.engine.unused_data or self.file.read(CHUNK)
                if not raw:
                    return b""
                self.streams += 1
                if self.streams > STREAMS:
                    raise Enough(f"is made of more than {STREAMS} gzip streams; "
                                 "no more was read")
                self.engine = zlib.decompressobj(31)
            else:
                raw = self.engine.unconsumed_tail or self.file.read(CHUNK)
            piece = self.engine.decompress(raw, size)
            if piece:
                return piece
            if not raw and not self.engine.eof:
                raise EOFError("it ends in the middle")


class Forward:
    """A stream as tarfile wants it, that counts, and never goes back."""
    def __init__(self, stream):
        self.stream = stream
        self.at = 0
        self.last = b""  # what was read last: at the end, a block of zeros

    def tell(self) -> int:
        return self.at

    def piece(self, size: int) -> bytes:
        piece = self.stream.read(min(size, CHUNK))
        self.at += len(piece)
        if self.at > TOTAL:
            raise Enough(f"decompresses to more than {TOTAL >> 20} MB; no more was read")
        return piece

    def read(self, size: int) -> bytes:
        pieces = []
        while size > 0:
            piece = self.piece(size)
            if not piece:
                break
            pieces.append(piece)
            size -= len(piece)
        self.last = b"".join(pieces)
        return self.last

    def seek(self, to: int) -> None:
        if to < self.at:
            raise ValueError("a member lies before its header")
        while self.at < to and self.piece(to - self.at):
            pass


def look_in_tar(search, stream) -> None:
    forward = Forward(stream)
    archive = tarfile.TarFile(fileobj=forward, mode="r", encoding="utf-8",
                              errors="surrogateescape")
    members = 0
    while True:
        member = archive.next()
        if member is None:
            break
        archive.members.clear()
        members += 1
        if members > MEMBERS:
            raise Enough(f"holds more than {MEMBERS} members; no more were looked at")
        parts = [] if member.isdir() else parts_of(search, member.name)
        if not parts:
            continue
        if member.isreg():
            read_whole(search, parts, member.size, lambda: archive.extractfile(member).read())
        else:
            answers.no_file(search, parts, "a link, not followed" if member.issym() or
                            member.islnk() else "not a file, not read")
    # tarfile takes a header that it cannot read for the end.
    if forward.last.strip(b"\0") or len(forward.last) % tarfile.BLOCKSIZE:
        answers.ended_early(search, f"the archive is broken after {members} members")


# ---- either -----------------------------------------------------------------------------------

def look(search, path: bytes) -> None:
    with opened_file(path) as file:
        status = os.fstat(file.fileno())
        if status.st_size > TOTAL:
            answers.ended_early(search, f"the archive is larger than {TOTAL >> 20} MB; "
                                        "it was not read")
            return
        search.when = int(status.st_mtime)
        # What it is counts, not what it is called.
        head = file.read(512)
        file.seek(0)
        is_tar = head[257:262] == b"ustar"
        other = next((kind for magic, kind in OTHERS.items() if head.startswith(magic)), None)
        try:
            if other and not is_tar:
                answers.note(search, f"is a {other} archive, expected .zip or .tar.gz")
            elif head.startswith(b"\x1f\x8b"):
                look_in_tar(search, Inflated(file))
            elif not is_tar and (head.startswith(ZIP) or path.lower().endswith(b".zip")):
                look_in_zip(search, file)
            else:
                look_in_tar(search, file)
        except Enough as enough:
            answers.ended_early(search, str(enough))
        except MemoryError:
            raise
        except Exception as error:
            answers.ended_early(search, f"the archive is broken: {why(error)}")
