# SPDX-License-Identifier: GPL-3.0-or-later
"""An adapter under test: its process, spoken to line by line."""
import functools
import json
import os
import pathlib
import queue
import subprocess
import threading

import hull

FOLDER = pathlib.Path(os.environ["FATHOM_SUBJECTS"])  # where the adapters are built
ROOT = pathlib.Path(__file__).resolve().parents[2]
PATIENCE = 60  # seconds until a subject counts as hung
HELLO = {"type": "hello", "protocol": "fathom/subject/1"}

# Every adapter's program, mode and name.
MODES = [("libccd", "epa"), ("libccd", "mpr"), ("fcl", "signed"), ("fcl", "collide"), ("fcl", "indep"), ("bullet", "epa"),
         ("bullet", "pair"), ("bullet", "world"), ("bullet64", "epa"), ("bullet64", "pair"), ("bullet64", "world"), ("ode", "collide")]


@functools.lru_cache(maxsize=None)
def facets(vertices):
    return hull.facets(json.loads(vertices))


class Hung(Exception):
    pass


class Client:
    """with Client("libccd", "epa") as subject: subject.hello; subject.ask(a, b). An adapter for node has a name that ends with .mjs."""

    def __init__(self, program, *arguments):
        script = program.endswith(".mjs")
        command = ["node", FOLDER / "web-subjects" / program] if script else [FOLDER / f"fathom-subject-{program}"]
        self.process = subprocess.Popen([*command, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.lines, self.talk, self.asked = queue.Queue(), [], 0
        self.readers = [threading.Thread(target=self.read, args=(self.process.stdout, self.lines.put), daemon=True),
                        threading.Thread(target=self.read, args=(self.process.stderr, self.talk.append), daemon=True)]
        for reader in self.readers:
            reader.start()

    @staticmethod
    def read(stream, keep):
        for line in stream:
            keep(line)
        keep("")

    def __enter__(self):
        self.send(HELLO)
        self.hello = self.receive()
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.wait()

    def send(self, message):
        """A line: text as it is, anything else as JSON."""
        self.process.stdin.write((message if isinstance(message, str) else json.dumps(message)) + "\n")
        self.process.stdin.flush()

    def line(self, patience=PATIENCE):
        """The next line of the subject's output; "" at its end."""
        try:
            return self.lines.get(timeout=patience)
        except queue.Empty:
            raise Hung from None

    def receive(self, patience=PATIENCE):
        return json.loads(self.line(patience))

    def ask(self, a, b, patience=PATIENCE):
        """The reply on two bodies, each a vertex list or a shape."""
        self.asked += 1
        message = {"type": "run", "id": str(self.asked)}
        for key, body in (("a", a), ("b", b)):
            message[key] = body if isinstance(body, dict) else {"vertices": body}
            if isinstance(body, list) and self.hello["capabilities"]["faces"] and (rings := facets(json.dumps(body))):
                message[key]["faces"] = rings
        self.send(message)
        reply = self.receive(patience)
        assert (reply["type"], reply["id"]) == ("reply", str(self.asked)), reply
        return reply

    def wait(self):
        """(exit code, what it said on the standard error)"""
        if not self.process.stdin.closed:
            try:
                self.process.stdin.close()
            except BrokenPipeError:
                pass
        code = self.process.wait(PATIENCE)
        for reader in self.readers:
            reader.join()
        self.process.stdout.close()
        self.process.stderr.close()
        return code, "".join(self.talk)
