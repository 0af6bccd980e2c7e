"""watch_screen.py - what a terminal of 24 x 80 shows after its last clearing: watch_screen.py COMMAND...

The command runs until it watches, and is ended by Ctrl-C; what it says then is printed as well. What has
scrolled off the upper edge is not printed.
"""
import fcntl
import os
import pty
import re
import select
import struct
import sys
import termios

ROWS, COLUMNS, LONGEST_WAIT = 24, 80, 120

pid, terminal = pty.fork()
if pid == 0:
    fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, COLUMNS, 0, 0))
    os.environ["TERM"] = "xterm"
    os.execvp(sys.argv[1], sys.argv[1:])


def read_until(words: bytes) -> str:
    """What is written up to these words, or to the end of the command."""
    written = b""
    while words not in written and select.select([terminal], [], [], LONGEST_WAIT)[0]:
        try:
            written += os.read(terminal, 65536)
        except OSError:  # the command has ended
            break
    return re.sub(r"\x1b\[[0-9;]*m|\r", "", written.decode())


text = read_until(b"Ctrl-C ends.").rpartition("\x1b[2J\x1b[H")[2]
os.write(terminal, b"\x03")
afterwards = read_until(b"nothing ends it").replace("^C", "").strip()
os.waitpid(pid, 0)
rows = [row for line in text.rstrip("\n").split("\n") for row in re.findall(f".{{1,{COLUMNS}}}", line) or [""]]
print("\n".join(rows[1 - ROWS:]))  # the cursor is in the last row
print(afterwards, end="")
