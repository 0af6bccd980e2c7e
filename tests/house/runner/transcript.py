"""transcript.py - runs the commands of text files and compares what they print: transcript.py [--accept] FILE.txt...

    # A comment
    $ command             in one shell, in a folder of its own; a line that begins with > continues it
    what it prints        all of stdout, without empty lines. In a line, ... stands for any words; alone, for any lines
    ! what it says        all of stderr, below stdout
    exit 2                its exit status, if that is not 0

Where only some words matter, there is nothing but them, and the exit status:

    + these words         are somewhere in what it prints and says, however it is wrapped
    - these words         are not

HERE is the top of the tree; the chapters' programs are in PATH. Texts run beside each other, so a text builds only
below answers of its own. --accept writes what the commands print now into the text, for a reviewer to read. The
comment at the top can have lines that begin with these words:

    # Once is enough:     not in a run for another compiler (BRIEF)
    # By the ordinary build: nor in such a run for a sanitizer
    # Needs gnuplot:      what is not tested if that program is missing
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOP = Path(__file__).resolve().parents[3]


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


def not_tested(text):
    """What the text does not test here, and why; or nothing."""
    for line in text.splitlines():
        needed = re.match(r"# Needs (\w+):? *(.*)", line)
        if needed and shutil.which(needed[1]) is None:
            return f"{needed[2]} {needed[1]} is missing ('make setup' installs it)"
        other = os.path.basename(os.environ.get("BUILD", "build")) != "build"
        if os.environ.get("BRIEF") and (line.startswith("# Once is") or (other and line.startswith("# By the ordinary"))):
            return line.partition(": ")[2].rstrip(".") + ": once is enough (BRIEF)"
        if not line.startswith("#"):
            return ""
    return ""


def accepted(expected, found):
    """What is in the text from now on. A line with ... that still holds is kept, and so are words."""
    words = [line for line in expected if line.startswith(("+ ", "- "))]
    if words:
        return words + [line for line in found if line.startswith("exit ")]
    parts = [line for line in expected if "..." in line and line != "..."]
    return [next((part for part in parts if fits([part], [line])), line) for line in found]


def run(commands, top):
    """In one shell: the answer to each."""
    with tempfile.TemporaryDirectory() as folder:
        folder, script = Path(folder), ["cd work"]
        (folder / "work").mkdir()
        for number, (lines, _) in enumerate(commands):
            command = "\n".join(line[2:] for line in lines)
            script.append(f"{{\n{command}\n}} >{folder}/{number}.out 2>{folder}/{number}.err </dev/null\n"
                          f"echo $? >{folder}/{number}.status")
        programs = os.path.join(top, os.environ.get("PROGRAMS", "build/solutions"))
        environment = {**os.environ, "HERE": str(top), "BUILD": os.path.join(top, os.environ.get("BUILD", "build")),
                       "PROGRAMS": programs, "LC_ALL": "C", "PATH": programs + ":" + os.environ["PATH"]}
        subprocess.run(["sh", "-c", "\n".join(script)], cwd=folder, env=environment, check=False)
        return [answer(folder, number) for number in range(len(commands))]


def test(path, accept):
    """Whether the text holds, or does from now on."""
    text = path.read_text("utf-8")
    untested = not_tested(text)
    parts = blocks(text)
    commands = [part for part in parts if part[0][0].startswith("$ ")]
    failed = rewritten = 0
    for part, found in zip(commands, run(commands, TOP) if not untested else []):
        if holds(part[1], found):
            continue
        new = accepted(part[1], found) if accept else part[1]
        if new != part[1]:
            rewritten += 1
            part[1][:] = new
        else:   # words that do not hold are changed by hand
            failed += 1
            print(f"not ok: {' '.join(part[0])}\n" + "".join(f"    {line}\n" for line in
                  ["expected:", *part[1], "came:", *found[:40]]), end="")
    if rewritten:
        path.write_text("".join(f"{line}\n" for lines, came in parts for line in lines + came), "utf-8")
    if untested:
        print(f"skipped: {untested}")
        commands = []
    print(f"{path.stem}: {rewritten} rewritten, {failed} to change by hand" if accept else
          f"{path.stem}: {len(commands) - failed} passed, {failed} failed")
    return not failed


def main():
    accept = sys.argv[1] == "--accept"
    results = [test(Path(path), accept) for path in sys.argv[1 + accept:]]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
