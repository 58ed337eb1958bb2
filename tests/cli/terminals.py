# SPDX-License-Identifier: GPL-3.0-or-later
"""The program on a terminal."""
import fcntl
import os
import pty
import signal
import struct
import subprocess
import termios
import threading

from harness import EXECUTABLE, PATIENCE


END = b"\x1c\x1c"  # what no program here writes


def run_on_terminal(*arguments, stop_at=None, columns=0, stdout=subprocess.PIPE, **how):
    """(exit code, stdout, what appeared on stderr, a terminal); with stdout=None that is the terminal too. SIGINT is sent once `stop_at`
    has appeared. `how`: for Popen."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    with subprocess.Popen([EXECUTABLE, *arguments], stdout=stdout or theirs, stderr=theirs, **how) as process:
        def finish():
            process.wait()
            os.write(theirs, END)

        # A terminal that nobody holds any more may lose what was written last: this side holds it, and writes the end itself.
        end = threading.Thread(target=finish)
        end.start()
        seen = b""
        while not seen.endswith(END):
            seen += os.read(ours, 4096)
            if stop_at is not None and stop_at in seen:
                process.send_signal(signal.SIGINT)
                stop_at = None
        end.join()
        os.close(theirs)
        os.close(ours)
        return process.wait(PATIENCE), process.stdout.read() if stdout else b"", seen.removesuffix(END)
