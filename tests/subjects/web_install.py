# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages of the engines for the web, for the tests that need them."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from client import ROOT

WEB = ROOT / "verify" / "subjects" / "web"
SKIPPED = 77
OFFLINE = re.compile("ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|EHOSTUNREACH|ERR_SOCKET_TIMEOUT|network")


def install(*more):
    """The engines' packages beside their adapters, or the reason why they cannot be there."""
    node, npm = shutil.which("node") or shutil.which("nodejs"), shutil.which("npm")
    if not node or not npm:
        return "node 18 or later and npm are not here"
    folder = pathlib.Path(os.environ["FATHOM_SUBJECTS"])
    lock = os.open(folder / "web-subjects.lock", os.O_CREAT | os.O_WRONLY)
    os.lockf(lock, os.F_LOCK, 0)  # the tests of several engines start at once
    try:
        done = subprocess.run([WEB / "install.sh", node, npm, folder / "web-subjects", *more], capture_output=True, text=True, check=False)
    finally:
        os.close(lock)
    if done.returncode == 0:
        return None
    if OFFLINE.search(done.stderr):
        return done.stderr
    sys.exit(done.stderr)


def main(name):
    """Runs the tests of the program, or says why they are skipped."""
    missing = install()
    if missing:
        print(f"{name}: skipped: {missing}", file=sys.stderr)
        sys.exit(SKIPPED)
    unittest.main()
