"""transcript.py - runs the commands of a text file and compares what they print: transcript.py FILE.txt

    # A comment
    $ command             in one shell, in a folder of its own; a line that begins with > continues it
    what it prints        all of stdout, without empty lines. In a line, ... stands for any words; alone, for any lines
    ! what it says        all of stderr, below stdout
    exit 2                its exit status, if that is not 0

Where only some words matter, there is nothing but them, and the exit status:

    + these words         are somewhere in what it prints and says, however it is wrapped
    - these words         are not

A script beside the text may define functions: FILE.sh calls this program, and is read by the shell as well if it
asks for TRANSCRIPT.
HERE is the top of the tree; the chapters' programs are in PATH. ACCEPT=1 writes what came into the text, for a
reviewer to read.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path


def blocks(text):
    """Commands, and what is between them: (the lines of each, the lines of its answer)."""
    found = []
    for line in text.splitlines():
        in_command = found and found[-1][0][0].startswith("$ ")
        if in_command and line.startswith("> ") and not found[-1][1]:
            found[-1][0].append(line)
        elif in_command and line and not line.startswith(("$ ", "#")):
            found[-1][1].append(line)
        else:
            found.append(([line], []))
    return found


def fits(expected, found):
    pattern = "".join(r"(.*\n)*" if line == "..." else ".*".join(map(re.escape, line.split("..."))) + r"\n"
                      for line in expected)
    return re.fullmatch(pattern, "".join(line + "\n" for line in found)) is not None


def answer(folder, number):
    out, err, status = (file.read_text("utf-8", "backslashreplace") if file.exists() else "the shell has ended\n"
                        for file in (folder / f"{number}.{part}" for part in ("out", "err", "status")))
    lines = out.splitlines() + [f"! {line}" for line in err.splitlines()]
    return [line for line in lines if line] + ([f"exit {status.strip()}"] if status.strip() != "0" else [])


def holds(expected, found):
    words = [line for line in expected if line.startswith(("+ ", "- "))]
    if not words:
        return fits(expected, found)
    ends = [[line for line in lines if line.startswith("exit ")] for lines in (expected, found)]
    said = " ".join(" ".join(line.removeprefix("! ") for line in found).split())
    return ends[0] == ends[1] and all((" ".join(line[2:].split()) in said) == (line[0] == "+") for line in words)


def main():
    path, top = Path(sys.argv[1]), os.getcwd()
    parts = blocks(path.read_text("utf-8"))
    commands = [part for part in parts if part[0][0].startswith("$ ")]
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        folder, script = Path(folder), ["cd work"]
        (folder / "work").mkdir()
        functions = path.with_suffix(".sh")
        if functions.exists() and "TRANSCRIPT" in functions.read_text("utf-8"):
            script.insert(0, f". {top}/{functions}")
        for number, (lines, _) in enumerate(commands):
            command = "\n".join(line[2:] for line in lines)
            script.append(f"{{\n{command}\n}} >{folder}/{number}.out 2>{folder}/{number}.err </dev/null\n"
                          f"echo $? >{folder}/{number}.status")
        programs = os.path.join(top, os.environ.get("PROGRAMS", "build/solutions"))
        environment = {**os.environ, "HERE": top, "BUILD": os.path.join(top, os.environ.get("BUILD", "build")),
                       "PROGRAMS": programs,
                       "TRANSCRIPT": "yes", "LC_ALL": "C", "PATH": programs + ":" + os.environ["PATH"]}
        subprocess.run(["sh", "-c", "\n".join(script)], cwd=folder, env=environment, check=False)
        for number, part in enumerate(commands):
            found = answer(folder, number)
            if holds(part[1], found):
                continue
            failed.append(part)
            print(f"not ok: {' '.join(part[0])}\n" + "".join(f"    {line}\n" for line in
                  ["expected:", *part[1], "came:", *found[:40]]), end="")
            if "ACCEPT" in os.environ:
                words = [line for line in part[1] if line.startswith(("+ ", "- "))]
                part[1][:] = words + [line for line in found if not words or line.startswith("exit ")]
    if "ACCEPT" in os.environ:
        path.write_text("".join(f"{line}\n" for lines, came in parts for line in lines + came), "utf-8")
    print(f"{path.stem}: {len(commands) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


sys.exit(main())
