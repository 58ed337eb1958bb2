#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts a file of requests to a program, without fathom, and says which answers are outside of the bounds in the file.

    replay.py REQUESTS ANSWERS COMMAND [WORD..]

`fathom certify --write-requests REQUESTS` wrote the file: what a subject of that hello reads, and beside it the exact answer and which
claims pass. COMMAND speaks the protocol of verify/PROTOCOL.md. ANSWERS gets its hello and replies, by the ids of the cases, as `fathom
certify --replay` reads them. An answer outside of the bounds is wrong; one inside may still have a wrong direction or point, at which
nobody looks here. Exit codes: 0 all are inside; 1 some are outside, or are no answers; 2 wrong arguments, another file, or a program
with other conventions than those of the file. Needs Python 3.8 or later, and nothing else.
"""
import json
import math
import queue
import struct
import subprocess
import sys
import threading

PATIENCE = 60  # seconds that an answer may take


class Program:
    """The program under test, spoken to line by line; started anew after it has failed."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.lines.put(line)
        self.lines.put("")

    def ask(self, message):
        """Returns the next line; "" if there is none in time."""
        try:
            self.process.stdin.write(json.dumps(message, separators=(",", ":")) + "\n")
            return self.lines.get(timeout=PATIENCE)
        except (OSError, queue.Empty):
            return ""

    def end(self):
        try:
            self.process.stdin.write('{"type":"stop"}\n')
            self.process.stdin.close()
            self.process.wait(5)
        except (OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()


def hello_of(program):
    """Returns the hello, None if there is none in time; lines before it that are no JSON are a greeting."""
    line = program.ask({"type": "hello", "protocol": "fathom/subject/1"})
    try:
        while line and not line.startswith("{"):
            line = program.lines.get(timeout=PATIENCE)
    except queue.Empty:
        return None
    return json.loads(line) if line else None


def number(given, precision):
    """Returns the double that a number of a reply means: in binary32 what is nearest there."""
    value = float.fromhex(given) if isinstance(given, str) and "x" in given.lower() else float(given)
    if precision == "binary32" and math.isfinite(value):
        try:
            return struct.unpack("f", struct.pack("f", value))[0]
        except OverflowError:
            return math.copysign(math.inf, value)
    return value


def outside(reply, request, precision):
    """Returns what is wrong with a reply; "" if nothing that the bounds tell."""
    accepted, word = request["accepted"], "overlap" if reply["overlap"] else "apart"
    if not accepted[word]:
        return f"said to {'overlap' if reply['overlap'] else 'be apart'}: the bodies are {request['truth']['status']}"
    field = "depth" if reply["overlap"] else "distance"
    if field not in reply:
        return ""
    claimed, low, high = number(reply[field], precision), *(float(accepted[field][end]) for end in ("low", "high"))
    if math.isfinite(claimed) and low <= claimed <= high:
        return ""
    return f"the {field} {claimed!r} is not between {low!r} and {high!r}"


def precisions_of(hello):
    """Returns the precision of points, and that of answers."""
    precision = hello["precision"]
    return (precision["points"], precision["answers"]) if isinstance(precision, dict) else (precision, precision)


def decides(hello):
    """Returns what the bounds depend on."""
    conventions = hello["conventions"]
    return {"precisions": precisions_of(hello), "touching": conventions["touching"], "depth": conventions["depth"],
            "claims": conventions.get("claims", "minimum")}


def requests_of(path):
    """Returns the header and the requests of a file."""
    try:
        with open(path, encoding="utf-8") as file:
            header, *requests = map(json.loads, file)
        decides(header["subject"])
    except (ValueError, KeyError, TypeError, AttributeError):
        raise ValueError(f"{path}: expected what fathom certify --write-requests writes, found something else") from None
    return header, requests


def replay(header, requests, answers, command):
    """Returns (requests, declined, outside); writes the answers."""
    program, declined, wrong = Program(command), 0, 0
    hello = hello_of(program)
    if hello is None or decides(hello) != decides(header["subject"]):
        program.end()
        raise ValueError(f"the requests are for a program that declares {json.dumps(decides(header['subject']))}")
    answers.write(json.dumps(hello) + "\n")
    for request in requests:
        line = program.ask(request["run"])
        try:
            reply = json.loads(line)
            said = reply.get("failed") or "" if "unsupported" in reply or "failed" in reply else outside(
                reply, request, precisions_of(hello)[1])
            if int(reply["id"]) != int(request["run"]["id"]):
                raise ValueError("an answer to another request")
            declined += "unsupported" in reply
            answers.write(json.dumps({**reply, "id": request["id"]}) + "\n")
        except (ValueError, KeyError, TypeError, AttributeError):
            said = f"no answer: {line.rstrip()[:100]!r}"
            answers.write(json.dumps({"type": "reply", "id": request["id"], "failed": said}) + "\n")
            program.process.kill()
            program.end()
            program = Program(command)
            try:
                hello_of(program)
            except ValueError:
                pass  # what it answers next tells
        if said:
            wrong += 1
            print(f"{request['id']}: {said}", flush=True)
    program.end()
    return len(requests), declined, wrong


def main(words):
    if len(words) < 3:
        print("usage: replay.py REQUESTS ANSWERS COMMAND [WORD..]", file=sys.stderr)
        return 2
    try:
        header, requests = requests_of(words[0])
        with open(words[1], "w", encoding="utf-8") as answers:
            asked, declined, wrong = replay(header, requests, answers, words[2:])
    except (ValueError, KeyError, TypeError, OSError) as error:
        print(f"replay.py: {error}", file=sys.stderr)
        return 2
    print(f"{asked} requests: {asked - declined - wrong} inside of the bounds, {wrong} outside, {declined} declined")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
