#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A subject in 40 lines: the separating axis test over facet normals and pairs of edges, in doubles. See verify/PROTOCOL.md."""
import json
import math
import sys


def minus(p, q): return [p[i] - q[i] for i in range(3)]
def dot(p, q): return sum(p[i] * q[i] for i in range(3))
def cross(p, q): return [p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2] for i in range(3)]


def axes(bodies):
    edges = [{tuple(minus(b["vertices"][f[i]], b["vertices"][f[i - 1]])) for f in b["faces"] for i in range(len(f))} for b in bodies]
    for b in bodies:
        corners = ([b["vertices"][i] for i in f[:3]] for f in b["faces"])
        yield from (cross(minus(q, p), minus(r, p)) for p, q, r in corners)
    yield from (cross(e, f) for e in edges[0] for f in edges[1])


def solve(a, b):
    if "faces" not in a or "faces" not in b:
        return {"unsupported": "a flat body"}
    way_out = (math.inf, None)  # how far along which unit vector A must go
    for axis in axes((a, b)):
        if length := math.sqrt(dot(axis, axis)):
            for u in ([x / length for x in axis], [-x / length for x in axis]):
                way_out = min(way_out, (max(dot(u, p) for p in b["vertices"]) - min(dot(u, p) for p in a["vertices"]), u))
    return {"overlap": way_out[0] > 0, "depth": max(way_out[0], 0), "direction": way_out[1]}


for message in map(json.loads, sys.stdin):
    if message["type"] == "hello":
        answer = {"type": "hello", "protocol": "fathom/subject/1", "name": "example-python", "version": "1", "precision": "binary64",
                  "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True}, "capabilities": {"faces": True}}
    elif message["type"] == "run":
        answer = {"type": "reply", "id": message["id"], **solve(message["a"], message["b"])}
    else:
        break
    print(json.dumps(answer), flush=True)
