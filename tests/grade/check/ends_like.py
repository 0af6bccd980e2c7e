"""ends_like.py - ends as it is told: by an exit status, or by a signal's name."""
import contextlib
import os
import signal
import sys

how = sys.argv[1]
if how.isdigit():
    sys.exit(int(how))
with contextlib.suppress(OSError):      # SIGKILL cannot be ignored anyway
    signal.signal(signal.Signals[how], signal.SIG_DFL)
os.kill(os.getpid(), signal.Signals[how])
