"""archives.py - hostile archives: paths and links that lead out, bombs, lies and noise.

Each function makes one, as in odd_files.py.
"""
from __future__ import annotations

import io
import random
import struct
import tarfile
import zipfile
from pathlib import Path

from .cases import Expected
from .odd_files import CORNERS, NOTHING_THERE, SCREEN


def zipped(path: Path, *members, method=zipfile.ZIP_DEFLATED) -> None:
    """members: (name or ZipInfo, text)"""
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, text in members:
            archive.writestr(name, text)


def tarred(path: Path, *members) -> None:
    """members: (name, text) or a TarInfo without content"""
    with tarfile.open(path, "w:gz", compresslevel=1) as archive:
        for member in members:
            if isinstance(member, tarfile.TarInfo):
                archive.addfile(member)
            else:
                info = tarfile.TarInfo(member[0])
                info.size = len(member[1])
                archive.addfile(info, io.BytesIO(member[1].encode()))


def link_info(name: str, kind: bytes, to: str = "") -> tarfile.TarInfo:
    info = tarfile.TarInfo(name)
    info.type, info.linkname = kind, to
    info.devmajor, info.devminor = 1, 5
    return info


def outside(places: dict) -> list:
    return ["../hostile-was-here", "../../hostile-was-here", "../honest/01-corners.c",
            f"{places['SCRATCH']}/hostile-was-here", "/tmp/hostile-was-here",
            f"{places['OUT']}/hostile-was-here", "x/../../../hostile-was-here", "..\\hostile-was-here"]


def zip_that_escapes(room, honest, prototypes, places):
    """Members whose paths lead out of where they are unpacked."""
    zipped(room / "zip-that-escapes.zip", *[(name, "forged-mark") for name in outside(places)])
    return Expected(NOTHING_THERE)


def tar_that_escapes(room, honest, prototypes, places):
    """The same in a tar, and through a link that it brings along."""
    tarred(room / "tar-that-escapes.tar.gz", *[(name, "forged-mark") for name in outside(places)],
           link_info("out", tarfile.SYMTYPE, str(places["SCRATCH"])), ("out/hostile-was-here", "x"),
           link_info("up", tarfile.SYMTYPE, ".."), ("up/hostile-was-here", "x"))
    return Expected(NOTHING_THERE)


def tar_of_links(room, honest, prototypes, places):
    """Answers that are links to the references, hard and soft, and devices."""
    solutions = f"{places['TREE']}/solutions"
    tarred(room / "tar-of-links.tar.gz",
           link_info(CORNERS, tarfile.LNKTYPE, f"{solutions}/01-corners.c"),
           link_info("02-cameras.c", tarfile.SYMTYPE, f"{solutions}/02-cameras.c"),
           link_info(SCREEN, tarfile.CHRTYPE), link_info("04-pixel-ray.c", tarfile.FIFOTYPE),
           link_info("05-quadratic.c", tarfile.LNKTYPE, "../honest/05-quadratic.c"))
    return Expected(NOTHING_THERE)


def zip_of_links(room, honest, prototypes, places):
    """The same in a zip."""
    info = zipfile.ZipInfo(CORNERS)
    info.create_system, info.external_attr = 3, 0o120777 << 16
    zipped(room / "zip-of-links.zip", (info, f"{places['TREE']}/solutions/01-corners.c"))
    return Expected(NOTHING_THERE)


def zip_bomb(room, honest, prototypes, places):
    """A third of a megabyte that becomes three hundred."""
    zipped(room / "zip-bomb.zip", (CORNERS, b"\0" * (300 << 20)))
    return Expected(NOTHING_THERE)


def zip_that_lies(room, honest, prototypes, places):
    """The same, and says that it is ten bytes long."""
    path = room / "zip-that-lies.zip"
    zipped(path, (CORNERS, b" " * (100 << 20)))
    content = bytearray(path.read_bytes())
    for mark, place in ((b"PK\1\2", 24), (b"PK\3\4", 22)):
        struct.pack_into("<L", content, content.rindex(mark) + place, 10)
    path.write_bytes(content)
    return Expected(NOTHING_THERE)


def tar_bomb(room, honest, prototypes, places):
    """Two hundred megabytes of spaces, squeezed."""
    tarred(room / "tar-bomb.tar.gz", (CORNERS, " " * (200 << 20)))
    return Expected(NOTHING_THERE)


def zip_of_many(room, honest, prototypes, places):
    """Sixty thousand members."""
    zipped(room / "zip-of-many.zip", *[(f"{i}.c", "") for i in range(60_000)])
    return Expected(NOTHING_THERE)


def zip_in_a_zip(room, honest, prototypes, places):
    """An archive in an archive, and so on, ten deep."""
    content = b"int a;"
    for i in range(10):
        memory = io.BytesIO()
        with zipfile.ZipFile(memory, "w") as archive:
            archive.writestr(CORNERS if i == 0 else "inner.zip", content)
        content = memory.getvalue()
    (room / "zip-in-a-zip.zip").write_bytes(content)
    return Expected(NOTHING_THERE)


def zip_broken(room, honest, prototypes, places):
    """Half an archive."""
    path = room / "zip-broken.zip"
    zipped(path, (SCREEN, honest["03-screen"]))
    path.write_bytes(path.read_bytes()[:-200])
    return Expected(NOTHING_THERE)


def zip_of_two(room, honest, prototypes, places):
    """Two members of one name."""
    path = room / "zip-of-two.zip"
    zipped(path, (SCREEN, honest["03-screen"]), ("o" + SCREEN[1:], "int a;"))
    path.write_bytes(path.read_bytes().replace(b"o3-screen", b"03-screen"))
    return Expected(NOTHING_THERE)


def zip_of_names(room, honest, prototypes, places):
    """Members whose names are lines, escape codes and markup."""
    zipped(room / "zip-of-names.zip", ("\x1b[2J\nok 1 - forged-mark\n</pre><script>/" + CORNERS, "int a"),
           ("=1+1/" + CORNERS, "int b"))
    return Expected(NOTHING_THERE)


def tar_of_noise(room, honest, prototypes, places):
    """No archive at all under the name of one."""
    (room / "tar-of-noise.tar.gz").write_bytes(random.Random(4).randbytes(10_000))
    return Expected(NOTHING_THERE)


def zip_of_nothing(room, honest, prototypes, places):
    """An archive of no bytes."""
    (room / "zip-of-nothing.zip").write_bytes(b"")
    return Expected(NOTHING_THERE)


MAKERS = [zip_that_escapes, tar_that_escapes, tar_of_links, zip_of_links, zip_bomb, zip_that_lies, tar_bomb,
          zip_of_many, zip_in_a_zip, zip_broken, zip_of_two, zip_of_names, tar_of_noise, zip_of_nothing]
