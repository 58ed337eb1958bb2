# SPDX-License-Identifier: GPL-3.0-or-later
"""The program on a terminal."""
import fcntl
import os
import pty
import signal
import struct
import subprocess
import termios

from harness import EXECUTABLE, PATIENCE


def run_on_terminal(*arguments, stop_at=None, columns=0, stdout=subprocess.PIPE, **how):
    """(exit code, stdout, what appeared on stderr, a terminal); with stdout=None that is the terminal too. SIGINT is sent once `stop_at` has
    appeared. `how`: for Popen."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    with subprocess.Popen([EXECUTABLE, *arguments], stdout=stdout or theirs, stderr=theirs, **how) as process:
        os.close(theirs)
        seen = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # how a terminal says that nobody holds its other side
                break
            if not piece:
                break
            seen += piece
            if stop_at is not None and stop_at in seen:
                process.send_signal(signal.SIGINT)
                stop_at = None
        os.close(ours)
        return process.wait(PATIENCE), process.stdout.read() if stdout else b"", seen
