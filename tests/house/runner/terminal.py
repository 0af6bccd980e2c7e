"""terminal.py - runs a command on a terminal of 24 x 80.

    terminal.py COMMAND...                  runs until it watches, and is ended by Ctrl-C. Printed is what the terminal shows
                                            after its last clearing, and what the command says at the end.
    terminal.py --until PATTERN COMMAND...  runs until it has said this; fails if it does not.
"""
import fcntl
import os
import pty
import re
import select
import signal
import struct
import sys
import termios

ROWS, COLUMNS, LONGEST_WAIT = 24, 80, 120

until, command = (sys.argv[2], sys.argv[3:]) if sys.argv[1] == "--until" else ("", sys.argv[1:])
pid, terminal = pty.fork()
if pid == 0:
    fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, COLUMNS, 0, 0))
    os.environ["TERM"] = "xterm"
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends it also where a shell started the tests with '&'
    os.execvp(command[0], command)


def read_until(pattern):
    """What is written up to this, or to the end of the command."""
    written = b""
    while not re.search(pattern.encode(), written) and select.select([terminal], [], [], LONGEST_WAIT)[0]:
        try:
            written += os.read(terminal, 65536)
        except OSError:  # the command has ended
            break
    return re.sub(r"\x1b\[[0-9;]*m|\r", "", written.decode(errors="replace"))


if until:
    text = read_until(until)
    os.kill(pid, signal.SIGKILL)
    print(text)
    sys.exit(not re.search(until, text))
text = read_until("Ctrl-C ends.").rpartition("\x1b[2J\x1b[H")[2]
os.write(terminal, b"\x03")
afterwards = read_until("nothing ends it").replace("^C", "").strip()
os.waitpid(pid, 0)
rows = [row for line in text.rstrip("\n").split("\n") for row in re.findall(f".{{1,{COLUMNS}}}", line) or [""]]
print("\n".join(rows[1 - ROWS:]))  # the cursor is in the last row
print(afterwards, end="")
