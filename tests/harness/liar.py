#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A subject for axis-parallel boxes that misbehaves on request: liar.py WAY [SECONDS].

It answers rightly, except for cases that are marked: the first point of A lies at x >= 1000. WAY is a key of WAYS below, or
"honest"; ways that concern the hello or the end need no mark. SECONDS: each answer takes so long."""
import json
import os
import random
import signal
import sys
import time

HELLO = {"type": "hello", "protocol": "fathom/subject/1", "name": "liar", "version": "1", "precision": "binary64",
         "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}}
WAY = sys.argv[1]
DELAY = float(sys.argv[2]) if len(sys.argv) > 2 else 0


def write(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def say(message, end="\n"):
    write(json.dumps(message) + end)


def truth(a, b):
    """Of boxes: the least way along an axis."""
    ways = []
    for axis in range(3):
        for sign in (-1, 1):
            reach = max(sign * p[axis] for p in b["vertices"]) - min(sign * p[axis] for p in a["vertices"])
            ways.append((reach, [sign * (i == axis) for i in range(3)]))
    depth, direction = min(ways)
    return {"overlap": depth > 0, "depth": max(depth, 0), "direction": direction}


def reply(run, **changes):
    return {"type": "reply", "id": run["id"], **truth(run["a"], run["b"]), **changes}


def kill(number):
    sys.stderr.write("about to go\n")
    sys.stderr.flush()
    os.kill(os.getpid(), number)


def linger(run):
    """A child keeps the pipes open."""
    if os.fork() == 0:
        time.sleep(60)
        os._exit(0)
    os._exit(9)


def flood(run):
    while True:
        os.write(2, b"warning: something is not as it should be\n" * 100)


def flood_of_lines():
    while True:
        write("loading\n" * 1000)


def close_output(run):
    os.close(1)
    time.sleep(60)


def dribble(run, pause):
    for c in json.dumps(reply(run)) + "\n":
        write(c)
        time.sleep(pause)


def raw(data):
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()


WAYS = {
    "too-deep": lambda run: say(reply(run, depth=1.5 * truth(run["a"], run["b"])["depth"])),
    "too-shallow": lambda run: say(reply(run, depth=0.5 * truth(run["a"], run["b"])["depth"])),
    "negative-depth": lambda run: say(reply(run, depth=-truth(run["a"], run["b"])["depth"])),
    "turned-direction": lambda run: say(reply(run, direction=[-x for x in truth(run["a"], run["b"])["direction"]])),
    "nan": lambda run: write('{"type":"reply","id":"%s","overlap":true,"depth":-nan,"direction":[nan,NaN,-nan(0x8000)]}\n' % run["id"]),
    "infinite": lambda run: write('{"type":"reply","id":"%s","overlap":true,"depth":inf,"direction":[1,0,0]}\n' % run["id"]),
    "separation": lambda run: say({"type": "reply", "id": run["id"], "overlap": False}),
    "zero-direction": lambda run: say(reply(run, direction=[0, 0, 0])),
    "failed": lambda run: say({"type": "reply", "id": run["id"], "failed": "std::logic_error: no \"hull\""}),
    "unsupported": lambda run: say({"type": "reply", "id": run["id"], "unsupported": "x >= 1000"}),
    "crash": lambda run: kill(signal.SIGSEGV),
    "abort": lambda run: kill(signal.SIGABRT),
    "exit": lambda run: sys.exit(3),
    "silent": lambda run: sys.exit(0),
    "hang": lambda run: time.sleep(60),
    "busy": lambda run: [None for _ in iter(int, 1)],
    "garbage": lambda run: write("Segmentation fault?\n"),
    "empty-line": lambda run: write("\n"),
    "noise": lambda run: raw(bytes(range(256)) * 64 + b"\n"),
    "no-fields": lambda run: say({"type": "reply", "id": run["id"]}),
    "wrong-types": lambda run: say(reply(run, depth=[1], direction="up")),
    "array": lambda run: say([reply(run)]),
    "nested": lambda run: raw(b"[" * 3_000_000 + b"\n"),
    "huge-line": lambda run: raw(b"x" * (17 << 20)),
    "half-line": lambda run: [say(reply(run), end=""), os._exit(0)],
    "cut-line": lambda run: [write(json.dumps(reply(run))[:-20]), os._exit(0)],
    "other-id": lambda run: say(reply(run, id="99999")),
    "no-id": lambda run: say({k: v for k, v in reply(run).items() if k != "id"}),
    "twice": lambda run: write(2 * (json.dumps(reply(run)) + "\n")),
    "no-newline": lambda run: [say(reply(run), end=""), time.sleep(60)],
    "null-depth": lambda run: say(reply(run, depth=None)),
    "null-apart": lambda run: say({"type": "reply", "id": run["id"], "overlap": False, "direction": None}),
    "close-output": close_output,
    "linger": linger,
    "flood": flood,
    "dribble": lambda run: dribble(run, 0.001),
    "dribble-forever": lambda run: dribble(run, 1),
    "second-hello": lambda run: say(HELLO),
}
# With each good answer, whatever is asked: what was not asked for yet, guessed.
UNASKED = {"guesses": lambda run: write("".join(json.dumps(reply(run, id=str(int(run["id"]) + k))) + "\n" for k in (0, 1)))}
# After each good answer, 0 to 20 ms later.
SOON = {
    "dies-soon": lambda run: kill(signal.SIGSEGV),
    "exits-soon": lambda run: sys.exit(3),
    "talks-soon": lambda run: write("done\n"),
    "talks-and-dies-soon": lambda run: [write("done\n"), time.sleep(random.uniform(0, 0.02)), kill(signal.SIGSEGV)],
    "answers-again-soon": lambda run: say(reply(run)),
}
WAYS["dies-soon"] = lambda run: kill(signal.SIGABRT)
DURING_HELLO = {
    "hello-never": lambda: time.sleep(60),
    "hello-silent": lambda: sys.exit(0),
    "hello-crash": lambda: kill(signal.SIGSEGV),
    "hello-garbage": lambda: [write("liar 1.0, ready\n"), sys.exit(0)],
    "hello-half": lambda: write('{"type":\n'),
    "hello-flood": flood_of_lines,
    "hello-late": lambda: [write("liar 1.0\n\n[1]\n"), say(HELLO)],
    "hello-without-name": lambda: say({k: v for k, v in HELLO.items() if k != "name"}),
    "hello-without-unit": lambda: say({**HELLO, "conventions": {"touching": "either", "depth": "positive", "moves": "a"}}),
    "hello-other-protocol": lambda: say({**HELLO, "protocol": "fathom/subject/2"}),
    "hello-precision": lambda: say({**HELLO, "precision": "binary16"}),
    "hello-changes": lambda: say({**HELLO, "version": str(os.getpid())}),
    "hello-unflushed": lambda: [say(HELLO, end=""), time.sleep(60)],
    "hello-then-crash": lambda: [say(HELLO), kill(signal.SIGSEGV)],
    "hello-then-deaf": lambda: [say(HELLO), time.sleep(60)],
    "early": lambda: [say(HELLO), say({"type": "reply", "id": "1", "overlap": False})],
}


def main():
    for line in sys.stdin:
        message = json.loads(line)
        if message["type"] == "hello":
            DURING_HELLO.get(WAY, lambda: say({**HELLO, "precision": "binary32" if WAY == "binary32" else "binary64"}))()
        elif message["type"] == "stop":
            if WAY == "ignore-stop":
                signal.signal(signal.SIGTERM, signal.SIG_IGN)
                time.sleep(60)
            if WAY == "crash-at-stop":
                kill(signal.SIGSEGV)
            if WAY == "fail-at-stop":
                sys.exit(3)
            return
        else:
            time.sleep(DELAY)
            marked = message["a"]["vertices"][0][0] >= 1000
            if marked and WAY in WAYS:
                WAYS[WAY](message)
            else:
                UNASKED.get(WAY, lambda run: say(reply(run)))(message)
            if WAY == "one-shot":
                return
            if WAY == "twice-late":
                time.sleep(0.02)
                say(reply(message))
            if WAY == "deaf":
                time.sleep(60)
            if WAY in SOON and not marked:
                time.sleep(random.uniform(0, 0.02))
                SOON[WAY](message)


if __name__ == "__main__":
    main()
