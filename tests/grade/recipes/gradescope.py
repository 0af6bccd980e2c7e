"""gradescope.py - writes the archive that Gradescope's autograder is made from: make gradescope

The files that git tracks, as they are in the working tree, under toolkit/; and at the root the two programs
that Gradescope starts. The same tree gives the same bytes.
"""
import os
import stat
import subprocess
import sys
import zipfile
from pathlib import Path

AT_THE_ROOT = Path("tests/grade/recipes/gradescope")
STARTED = ["setup.sh", "run_autograder"]
THE_SAME_DATE = (1980, 1, 1, 0, 0, 0)   # the earliest that the format has


def tracked() -> list:
    listed = subprocess.run(["git", "ls-files", "-z"], capture_output=True, check=True).stdout
    names = sorted(name for name in os.fsdecode(listed).split("\0") if name)
    gone = [name for name in names if not os.path.lexists(name)]
    if gone:
        sys.exit(f"gradescope: git tracks {gone[0]}, which is not there: commit that, or restore it")
    odd = [name for name in names if not stat.S_ISREG(os.lstat(name).st_mode)]
    if odd:
        sys.exit(f"gradescope: {odd[0]} is not a regular file, and only regular files can be packed")
    return names


def add(archive: zipfile.ZipFile, name: str, path: Path) -> None:
    info = zipfile.ZipInfo(name, THE_SAME_DATE)
    info.create_system = 3      # so that the permissions count
    mode = 0o755 if path.stat().st_mode & stat.S_IXUSR else 0o644
    info.external_attr = (stat.S_IFREG | mode) << 16
    info.compress_type = zipfile.ZIP_DEFLATED
    archive.writestr(info, path.read_bytes())


def main() -> None:
    out = Path(sys.argv[1])
    names = tracked()
    out.parent.mkdir(parents=True, exist_ok=True)
    new = out.with_suffix(".new")
    with zipfile.ZipFile(new, "w") as archive:
        for name in STARTED:
            add(archive, name, AT_THE_ROOT / name)
        for name in names:
            add(archive, f"toolkit/{name}", Path(name))
    new.replace(out)
    print(f"{out}: {len(names)} files, {out.stat().st_size // 1024} KB. It holds the solutions: not for students.")


main()
