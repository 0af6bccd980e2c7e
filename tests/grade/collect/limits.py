"""limits.py - where reading what somebody else made comes to its end."""
import os
import stat

# Should it have become a fifo since it was looked at, opening it must not wait.
FILE = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC


class Enough(Exception):
    """Nothing more is looked at; the words say why."""


def opened_file(name, folder=None):
    """A regular file; OSError where it is something else."""
    file = open(os.open(name, FILE, dir_fd=folder), "rb")
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(0, "it is not a file")
    return file
