"""archives.py - looks for answers in an archive that somebody else made, and in archives inside it.

Members are read as streams, and nothing is written to disk: no name in an archive leads anywhere.
The sizes in a header are not believed: the bytes that come out are counted, and limited. All
archives of one submission share these limits.
"""
import io
import os
import re
import stat
import tarfile
import zipfile
from collections import deque
from dataclasses import dataclass, field

from grade.visible import brief, why
from . import answers, streams
from .streams import Enough, opened_file

ENTRIES = 20000             # of folders
MEMBERS = 50000
KEPT = 64 * 1024 * 1024     # bytes of answers, and of archives inside
STREAM = 512 * 1024 * 1024  # bytes that are decompressed: a copy of the toolkit with all that was built
FILE = 256 * 1024 * 1024    # of an archive
ARCHIVES = 50               # inside, of one submission
LEVELS = 3                  # an archive, one inside it, and one inside that
DIRECTORY = 8 * 1024 * 1024  # the table at the end of a zip
ZIP = (b"PK\3\4", b"PK\5\6", b"PK\7\10")  # a member, an empty archive, one in parts
LEADS_OUT = "a member's path leads out of the archive; it is refused"
SUFFIXES = (".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tbz2", ".tar.zst", ".tar", ".zip", ".7z", ".rar")


@dataclass
class Room:
    """The rest of the limits, and the inner archives that wait to be read."""
    opener: object = None   # how a program that unpacks is started: a command to a command
    kept: int = field(default_factory=lambda: KEPT)
    stream: int = field(default_factory=lambda: STREAM)
    entries: int = field(default_factory=lambda: ENTRIES)
    members: int = field(default_factory=lambda: MEMBERS)
    archives: int = field(default_factory=lambda: ARCHIVES)
    waiting: deque = field(default_factory=deque)   # (parts, bytes, level)

    def keep(self, size: int) -> None:
        self.kept -= size
        if self.kept < 0:
            raise Enough(f"holds more than {KEPT >> 20} MB of answers and archives; no more was read")

    def pass_over(self, size: int) -> None:
        self.stream -= size
        if self.stream < 0:
            raise Enough(f"decompresses to more than {STREAM >> 20} MB; no more was read")

    def look_at(self, entries: int) -> None:
        self.entries -= entries
        if self.entries < 0:
            raise Enough(f"holds more than {ENTRIES} entries; no more were looked at")

    def member(self) -> None:
        self.members -= 1
        if self.members < 0:
            raise Enough(f"holds more than {MEMBERS} members; no more were looked at")


@dataclass(frozen=True)
class Place:
    """The place of an archive: the prefix of its members' names, and its depth."""
    parts: tuple
    level: int


def suffix_of(name: str) -> str:
    return next((name[-len(suffix):] for suffix in SUFFIXES if name.lower().endswith(suffix)), "")


def is_called_one(base: str) -> bool:
    return suffix_of(base) != "" and not base.startswith("._")


def put_by(search, room: Room, parts, raw: bytes, level: int) -> bool:
    """Keeps an inner archive for later, unless it is too large or too deep, or there are too many."""
    if level > LEVELS:
        answers.not_read(search, f"an archive {LEVELS} deep in others is not opened: {answers.place_of(parts)}")
    elif room.archives == 0:
        answers.not_read(search, f"holds more than {ARCHIVES} archives; no more were opened")
    elif len(raw) > room.kept:
        answers.not_read(search, f"{answers.place_of(parts)} is larger than {KEPT >> 20} MB, with what else there is; "
                                 "it was not read")
    else:
        room.keep(len(raw))
        room.archives -= 1
        room.waiting.append((tuple(parts), raw, level))
        return True
    return False


# ---- members ------------------------------------------------------------------------------------

def parts_of(search, place: Place, name: str) -> list:
    """Folders and name of a member that is an answer or an archive; [] where it is neither."""
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if name.startswith("/") or ".." in parts or re.match("[A-Za-z]:", name):
        answers.note(search, f"{LEADS_OUT}: {brief(name)}")
        return []
    if not parts or "__MACOSX" in parts:
        return []
    parts = [*place.parts, *parts]
    if answers.stem_of(search, parts[-1]):
        return parts
    answers.passed(search, parts)
    answers.bystander(search, parts)
    return parts if is_called_one(parts[-1]) else []


def read_member(search, room: Room, place: Place, parts, size: int, read) -> None:
    """A member that is an answer or an archive. read(most): its bytes, at most that number."""
    if not answers.stem_of(search, parts[-1]):
        if place.level == LEVELS:
            put_by(search, room, parts, b"", place.level + 1)   # which says why it is not opened
        else:
            put_by(search, room, parts, read(max(room.kept, 0) + 1), place.level + 1)
        return
    if size > answers.LARGEST:
        answers.unreadable(search, parts, f"is larger than {answers.LARGEST // 1024} KB", place.level)
        return
    try:
        raw = read(answers.LARGEST + 1)
    except (Enough, MemoryError):
        raise
    except Exception as error:  # whatever the libraries make of what is broken on purpose
        answers.unreadable(search, parts, f"cannot be read: {why(error)}", place.level)
        room.keep(answers.LARGEST)
        return
    if len(raw) != size:
        answers.unreadable(search, parts, "cannot be read: it is not as long as the archive says", place.level)
    else:
        answers.found(search, parts, raw, place.level)
    room.keep(len(raw))


# ---- zip ----------------------------------------------------------------------------------------

class Careful:
    """A file of which no more is read at once than the table of an honest zip needs."""
    def __init__(self, file):
        self.file = file
        self.size = file.seek(0, os.SEEK_END)
        self.seek, self.tell = file.seek, file.tell

    def seekable(self) -> bool:
        return True

    def read(self, size=-1):
        if size < 0:
            size = max(0, self.size - self.tell())
        if size > DIRECTORY:
            raise Enough(f"holds a table of more than {MEMBERS} members; it was not looked at")
        return self.file.read(size)


def zip_member(archive, info, most: int) -> bytes:
    if info.flag_bits & 0x1:
        raise ValueError("it is encrypted")
    # Only these are decompressed piece by piece.
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError(f"compression method {info.compress_type}, expected deflate")
    # Without this, zipfile would stop at the size in the header, and not notice that there is more.
    info.file_size = most + 1
    with archive.open(info) as file:
        return file.read(most)


def look_in_zip(search, room: Room, place: Place, file) -> None:
    with zipfile.ZipFile(Careful(file)) as archive:
        for info in archive.infolist():
            room.member()
            # Some write Windows' separator.
            name = info.filename.replace("\\", "/")
            parts = [] if name.endswith("/") else parts_of(search, place, name)
            if not parts:
                continue
            if not stat.S_ISLNK(info.external_attr >> 16):
                try:
                    read_member(search, room, place, parts, info.file_size,
                                lambda most: zip_member(archive, info, most))
                except (Enough, MemoryError):
                    raise
                except Exception as error:  # of an archive inside; the members after it are whole
                    answers.not_read(search, f"{answers.place_of(parts)} cannot be read: {why(error)}")
            elif answers.stem_of(search, parts[-1]):
                answers.no_file(search, parts, answers.NOT_FOLLOWED)


# ---- tar ----------------------------------------------------------------------------------------

class Forward:
    """A stream as tarfile wants it, that counts, and never goes back."""
    def __init__(self, stream, room: Room):
        self.stream = stream
        self.room = room
        self.at = 0
        self.last = b""  # what was read last: at the end, a block of zeros

    def tell(self) -> int:
        return self.at

    def piece(self, size: int) -> bytes:
        piece = self.stream.read(min(size, streams.CHUNK))
        self.at += len(piece)
        self.room.pass_over(len(piece))
        return piece

    def read(self, size: int) -> bytes:
        pieces, length = [], 0
        while length < size:
            piece = self.piece(size - length)
            if not piece:
                break
            pieces.append(piece)
            length += len(piece)
            # Of a member no more is asked for than there is room for: this is a header's long name.
            if length > KEPT:
                raise Enough(f"holds a name of more than {KEPT >> 20} MB; no more was read")
        self.last = b"".join(pieces)
        return self.last

    def seek(self, to: int) -> None:
        if to < self.at:
            raise ValueError("a member lies before its header")
        while self.at < to and self.piece(to - self.at):
            pass


def look_in_tar(search, room: Room, place: Place, stream) -> None:
    forward = Forward(stream, room)
    archive = tarfile.TarFile(fileobj=forward, mode="r", encoding="utf-8",
                              errors="surrogateescape")
    members = 0
    while True:
        member = archive.next()
        if member is None:
            break
        archive.members.clear()
        members += 1
        room.member()
        parts = [] if member.isdir() else parts_of(search, place, member.name)
        if not parts:
            continue
        if member.isreg():
            read_member(search, room, place, parts, member.size,
                        lambda most: archive.extractfile(member).read(min(most, member.size)))
        elif answers.stem_of(search, parts[-1]):
            answers.no_file(search, parts, "a link, not followed" if member.issym() or
                            member.islnk() else "not a file, not read")
    # tarfile takes a header that it cannot read for the end.
    if forward.last.strip(b"\0") or len(forward.last) % tarfile.BLOCKSIZE:
        said(search, place, f"the archive is broken after {members} members")


# ---- any kind -----------------------------------------------------------------------------------

def said(search, place: Place, words: str) -> None:
    """Why an archive was not read to its end."""
    if place.parts:
        answers.not_read(search, f"{answers.place_of(place.parts)}: {words}")
    else:
        answers.ended_early(search, words)


def look_in(search, room: Room, place: Place, file, called: str) -> None:
    # Its contents decide, not its name.
    head = file.read(512)
    file.seek(0)
    is_tar = head[257:262] == b"ustar"
    try:
        kind = None if is_tar else streams.kind_of(head)
        if kind:
            with streams.opened(kind, file, room.opener) as stream:
                look_in_tar(search, room, place, stream)
        elif not is_tar and (head.startswith(ZIP) or called.lower().endswith(".zip")):
            look_in_zip(search, room, place, file)
        else:
            look_in_tar(search, room, place, file)
    except (Enough, MemoryError):
        raise
    except streams.NotHere as error:
        search.lacks = search.lacks or str(error)
        said(search, place, str(error))
    except streams.Unreadable as error:
        search.refused = True
        said(search, place, str(error))
    except Exception as error:
        said(search, place, f"the archive is broken: {why(error)}")


def look_in_waiting(search, room: Room) -> None:
    """The archives inside, those that are least deep first."""
    while room.waiting:
        parts, raw, level = room.waiting.popleft()
        if not answers.is_toolkit_s(search, parts):
            look_in(search, room, Place(parts, level), io.BytesIO(raw), parts[-1])


def look(search, path: bytes, opener=None) -> None:
    room = Room(opener)
    with opened_file(path) as file:
        status = os.fstat(file.fileno())
        if status.st_size > FILE:
            answers.ended_early(search, f"the archive is larger than {FILE >> 20} MB; "
                                        "it was not read")
            return
        answers.written(search, int(status.st_mtime))
        try:
            look_in(search, room, Place((), 1), file, os.fsdecode(path))
            look_in_waiting(search, room)
        except Enough as enough:
            answers.ended_early(search, str(enough))
