"""ends_like.py - ends as its argument says: an exit status, or the name of a signal."""
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
