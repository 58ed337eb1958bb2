#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forges certificates of unions, and demands that all checkers agree on each and accept none whose claim is untrue.

union_forgeries.py --checker COMMAND [--checker COMMAND].. --fathom PROGRAM [--count N] [--share K] [--seed S]

The genuine ones are made by fathom, of random boxes; what is true of boxes is found here by definition, and of other points by fathom.
Before these, forgeries that each aim at one condition of FORMAT.md, section 12. Exit codes: 0 fine; 1 a fault; 2 usage.
"""
import collections
import json
import pathlib
import random
import shlex
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import forgeries  # noqa: E402
import unions  # noqa: E402

CUBE = ((-1, -1, -1), (1, 1, 1))  # a body; with POINT the other one, P is about this
POINT = ((0, 0, 0), (1, 1, 1))
ALL_FACETS = "split 0 0 1 2 3 4 5"


def grown(box):
    """B such that P of POINT and B is the box."""
    return tuple(l + 1 for l in box[0]), box[1]


def about(q, optima, tree, *boxes):
    """A certificate about unions with these P_0j, each a polytope of its own."""
    return unions.box_certificate([POINT], [grown(box) for box in boxes], q, optima, [(0, j) for j in range(len(boxes))], tree)


def aimed():
    """(what it aims at, the text): none of them is true, but for those that are called genuine."""
    six = sorted(tuple(s * (m == k) for m in range(3)) for k in range(3) for s in (-1, 1))
    genuine = lambda: about(1, six, ["split 0"], CUBE)
    yield "genuine: a cube", genuine().text()
    far = ((10, -5, -5), (12, 5, 5))
    yield "a facet behind O is no facet far away", about(16, [(0, 4, 0)], ["split 1"], CUBE, far).text()
    slab = ((-10, -1, -1), (10, 1, 1))
    leaves = ["leaf 0", "leaf 1", "leaf 0 2", "leaf 0 3", "leaf 0 4", "leaf 0 5"]
    yield "a constraint that counts less than nothing", about(100, [(-10, 0, 0), (10, 0, 0)], [ALL_FACETS, *leaves], slab).text()
    yield "a cell that is nearer", about(Fraction(101, 100), [(Fraction(1), Fraction(1, 10), 0)],
                                         [ALL_FACETS, *map("leaf {}".format, range(6))], CUBE).text()
    yield "genuine: six leaves", about(1, six, [ALL_FACETS, *map("leaf {}".format, range(6))], CUBE).text()
    for k in range(6):
        yield "an optimum that is not listed, at a facet without a child", about(1, six[:k] + six[k + 1:], ["split 0"], CUBE).text()
        yield "an optimum that is not listed, at a leaf", about(1, six[:k] + six[k + 1:], [ALL_FACETS, *map("leaf {}".format, range(6))],
                                                                CUBE).text()
    long = ((-4, -1, -4), (4, 4, 4))
    yield "genuine: one near facet", about(1, [(0, -1, 0)], ["split 0 2", "leaf 0"], long).text()
    two_sides = ((-4, -1, -1), (4, 4, 4)), ((-4, -4, -4), (4, 0, 4))  # below y = 0 the second one hides both near facets of the first
    yield "a child twice in the place of another", about(16, [(0, 0, -4)], ["split 0 2 2", "split 1 3", "leaf 0 1", "split 1 3",
                                                                            "leaf 1 2"], *two_sides).text()
    yield "a near facet without a child", about(4, [(0, -2, 0)], ["split 0"], long).text()
    yield "no root", about(1, six, [], CUBE).text()
    yield "a child is missing", about(1, six, [ALL_FACETS, *map("leaf {}".format, range(5))], CUBE).text()
    yield "a node too many", about(1, six, [ALL_FACETS, *map("leaf {}".format, range(6)), "leaf 0"], CUBE).text()
    yield "a second tree", about(1, six, ["split 0", "split 0"], CUBE).text()
    yield "a leaf at the root", about(1, six, ["leaf"], CUBE).text()
    yield "a constraint that is not on the path", about(1, six, [ALL_FACETS, "leaf 1", *map("leaf {}".format, range(1, 6))], CUBE).text()
    yield "five constraints", about(1, six, [ALL_FACETS, *map("leaf {}".format, range(5)), "leaf 5 0 1 2 3"], CUBE).text()
    yield "a leaf of nothing", about(1, six, [ALL_FACETS, "leaf", *map("leaf {}".format, range(1, 6))], CUBE).text()
    yield "no such facet", about(1, six, ["split 0 6", "leaf 0"], CUBE).text()
    yield "no such polytope", about(1, six, ["split 1"], CUBE).text()
    yield "an optimum twice", about(1, [six[0], *six], ["split 0"], CUBE).text()
    yield "optima in another order", about(1, [*six[1:], six[0]], ["split 0"], CUBE).text()
    yield "an optimum that is farther", about(1, [*six[:-1], (2, 0, 0)], ["split 0"], CUBE).text()
    yield "an optimum inside", about(Fraction(1, 4), [(0, 0, Fraction(1, 2))], ["split 0 5", "leaf 0"], CUBE).text()
    yield "no optimum", about(Fraction(1, 4), [], ["split 0"], CUBE).text()
    yield "a depth of nothing", about(0, [], ["split 0"], CUBE).text()
    for name, change in (("a separation of nothing", lambda c: c.optima[0][1].__setitem__(0, ["0", "0", "0"])),
                         ("a separation too few", lambda c: c.optima[0][1].pop()),
                         ("a separation too many", lambda c: c.optima[0][1].append(["0", "0", "1"])),
                         ("a separation that does not separate", lambda c: c.optima[0][1].__setitem__(0, ["0", "1", "0"])),
                         ("no pieces", lambda c: c.a.clear()),
                         ("a flat piece", lambda c: (c.b.append([["9", "9", "9"], ["10", "9", "9"], ["9", "10", "9"], ["10", "10", "9"]]),
                                                     [each.append(["-1", "0", "0"]) for _, each in c.optima])),
                         ("a piece without points", lambda c: c.a.append([])),
                         ("a polytope that is open", lambda c: c.polytopes[0][2].pop()),
                         ("a polytope inside out", lambda c: [f.__setitem__(slice(1, None), f[:0:-1]) for f in c.polytopes[0][2]]),
                         ("a polytope without vertices", lambda c: c.polytopes[0][1].clear()),
                         ("a polytope without facets", lambda c: c.polytopes[0][2].clear()),
                         ("a polytope of no piece", lambda c: c.polytopes[0][0].__setitem__(0, "1")),
                         ("a vertex of no point", lambda c: c.polytopes[0][1].__setitem__(0, ["8", "7"]))):
        c = genuine()
        change(c)
        yield name, c.text()
    # The second P_ij goes on where the first one ends; the mean of this one's vertices is not O.
    two = CUBE, ((0, -1, -1), (5, 1, 1))
    five = [t for t in six if t != (1, 0, 0)]
    tree = ["split 0 1", "split 1 0", "leaf 0 1"]
    yield "genuine: two blocks", about(1, five, tree, *two).text()
    tall = [tuple(3 * x for x in t) for t in five]
    yield "the second block is too short", about(9, tall, tree, ((-3, -3, -3), (1, 3, 3)), ((0, -3, -3), (2, 3, 3))).text()


ROWS = ("a", "b", "optima", "separations", "vertices", "facets", "tree", "weights")


def rows_of(c, kind):
    return {"a": [p for piece in c.a for p in piece], "b": [p for piece in c.b for p in piece],
            "optima": [t for t, _ in c.optima if t], "separations": [u for _, each in c.optima for u in each],
            "vertices": [v for p in c.polytopes for v in [*p[1], p[0]]], "facets": [f for p in c.polytopes for f in p[2]],
            "tree": c.tree, "weights": [*c.weights_a, *c.weights_b, *([c.nearest] if c.nearest else [])]}[kind]


def parts_of(c):
    """Every list of rows that may lose one, or get one twice."""
    return [c.optima if c.claim[0] == "depth" else [], c.polytopes, c.tree, c.a, c.b, c.weights_a, c.weights_b,
            *(each for _, each in c.optima), *(p[1] for p in c.polytopes), *(p[2] for p in c.polytopes), *c.a, *c.b]


def damaged(text, rng):
    """(kind of damage, text)."""
    c = unions.Union(text)
    kind = rng.choice(("number", "number", "number", "row", "twice", "swap", "claim", "claim", "node", "child"))
    if kind == "number":
        rows = [row for row in rows_of(c, rng.choice(ROWS)) if row]
        if not rows:
            return None
        row = rng.choice(rows)
        k = rng.randrange(len(row))
        if row[k] in ("split", "leaf"):
            row[k] = "leaf" if row[k] == "split" else "split"
        else:
            value = Fraction(row[k])
            row[k] = str(rng.choice((value + 1, value - 1, -value, value + Fraction(1, 2), 0, 7, 2**32, 2**64)))
    elif kind in ("row", "twice", "swap"):
        rows = [part for part in parts_of(c) if part]
        part = rng.choice(rows)
        i, k = rng.randrange(len(part)), rng.randrange(len(part))
        if kind == "row":
            del part[i]
        elif kind == "twice":
            part.insert(k, part[i])
        else:
            part[i], part[k] = part[k], part[i]
    elif kind == "claim":
        if len(c.claim) > 1:
            q = Fraction(c.claim[1])
            c.claim[1] = str(rng.choice((q * (1 + Fraction(1, 10**9)), q * (1 - Fraction(1, 10**9)), q + 1, q / 4, 4 * q, -q, 0)))
        else:
            c.claim = ["apart", rng.choice("01")]
    elif kind == "node" and c.tree:
        c.tree.insert(rng.randrange(len(c.tree) + 1), rng.choice((["leaf", "0"], ["leaf"], ["split", "0"], list(rng.choice(c.tree)))))
    elif kind == "child":
        splits = [node for node in c.tree if node[0] == "split"]
        if not splits:
            return None
        node = rng.choice(splits)
        if len(node) > 2 and rng.random() < 0.5:
            del node[rng.randrange(2, len(node))]
        else:
            node.append(str(rng.randrange(8)))
    return kind, c.text()


def obj(pieces):
    """Each piece as a group whose faces are all triples of its points."""
    out, first = [], 1
    for k, piece in enumerate(pieces):
        out.append(f"o {k}")
        out += ["v " + " ".join(repr(float(x)) for x in p) for p in piece]
        out += [f"f {first} {first + i} {first + i + 1}" for i in range(1, len(piece) - 1)]
        first += len(piece)
    return "\n".join(out) + "\n"


def random_bodies(rng):
    def body():
        boxes = []
        for _ in range(rng.randrange(1, 4)):
            low = [rng.randrange(6) for _ in range(3)]
            boxes.append((tuple(low), tuple(l + rng.randrange(1, 4) for l in low)))
        return boxes
    return body(), body()


class Campaign:
    """Forgeries of certificates that `read` cuts into parts; `aimed` yields those that aim at one condition, `damaged` makes one."""
    read, aimed, damaged = unions.Union, staticmethod(aimed), staticmethod(damaged)

    def __init__(self, options, folder):
        self.options, self.folder = options, pathlib.Path(folder)
        self.kinds, self.verdicts, self.faults = collections.Counter(), collections.Counter(), []
        self.judged = collections.Counter()

    def fault(self, sentence, text):
        path = pathlib.Path(tempfile.gettempdir()) / f"union_forgery_{len(self.faults)}.cert"
        path.write_text(text)
        self.faults.append(f"{sentence}: {path}")

    def solve(self, a, b):
        """fathom's answer about two lists of pieces: (status, squared depth or distance, optima) and the certificate's text."""
        names = []
        for name, pieces in (("a.obj", a), ("b.obj", b)):
            names.append(str(self.folder / name))
            (self.folder / name).write_text(obj(pieces))
        done = subprocess.run([*shlex.split(self.options.fathom), "depth", "--pieces", "--json", "--embed-certificate", *names],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        if done.returncode:
            return None, None
        result = json.loads(done.stdout)
        squared = result["apart"]["distance"]["squared"] if result["apart"] else result["depth"]["squared"]
        optima = [tuple(map(Fraction, o["translation"])) for o in result["optima"]] if result["status"] == "penetrating" else []
        return ({"penetrating": "depth", "touching": "touching", "disjoint": "apart"}[result["status"]], Fraction(squared),
                optima), result["certificate"]

    def truth(self, bodies):
        boxes = [unions.boxes_of(pieces) for pieces in bodies]
        if all(boxes):
            self.judged["by definition"] += 1
            squared, optima, gap = unions.depth_of_boxes(*boxes)
            return ("depth", squared, optima) if squared else ("apart", gap, []) if gap else ("touching", Fraction(0), [])
        self.judged["by fathom"] += 1
        return self.solve(*bodies)[0]

    def genuine(self, count, seed):
        """Texts of each claim. The answers are compared with the definition on the way."""
        texts, rng, seen = [], random.Random(seed), collections.Counter()
        while len(texts) < count:
            boxes = random_bodies(rng)
            answer, text = self.solve(*([unions.corners(box) for box in body] for body in boxes))
            squared, optima, gap = unions.depth_of_boxes(*boxes)
            if answer != (("depth", squared, optima) if squared else ("apart", gap, []) if gap else ("touching", 0, [])):
                self.fault(f"fathom says {answer}, the definition {squared, optima, gap}", text or "")
            elif seen[answer[0]] < (count if answer[0] == "depth" else count // 5):
                texts.append(self.read(text).text())
                seen[answer[0]] += 1
        print(", ".join(f"{n} {claim}" for claim, n in sorted(seen.items())) + " genuine certificates")
        if len(seen) < 3:
            self.fault("not all claims are there", "")
        return texts

    def judge(self, batch):
        """batch: (kind, text, whether it is genuine; None: nobody knows)."""
        found = forgeries.verdicts_of(self.options, self.folder, [text for _, text, _ in batch], self.fault)
        for name, (kind, text, genuine) in zip(found, batch):
            self.kinds[kind.split(":")[0] if genuine is not None else kind] += 1
            verdict = found[name][0] if len(found[name]) == 1 else "several"
            self.verdicts[verdict.split()[0]] += 1
            accepted = verdict.startswith("VERIFIED")
            if genuine is not None and accepted != genuine:
                self.fault(f"{kind}: {verdict}", text)
            elif accepted:
                bodies, claim, numbers, optima = self.read(text).statement()
                true = self.truth(bodies)
                if true is None or (claim, numbers or [Fraction(0)], optima) != (true[0], [true[1]], true[2]):
                    self.fault(f"{kind}: an untrue claim is accepted, {verdict}; the truth is {true}", text)


def main(campaign=Campaign):
    parser = forgeries.campaign_arguments(2000)
    parser.add_argument("--fathom", required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        campaign = campaign(options, folder)
        campaign.judge([(name, text, name.startswith("genuine")) for name, text in campaign.aimed()])
        aimed_at = sum(campaign.kinds.values())
        texts = campaign.genuine(40, options.seed)
        campaign.judge([("genuine: of fathom", text, True) for text in texts])
        rng, batch = random.Random(options.seed), []
        while len(batch) < options.count:
            text = rng.choice(texts)
            forged = campaign.damaged(text, rng)
            if forged is not None and forged[1] != text:
                batch.append((*forged, None))
        for k in range(0, len(batch), forgeries.BATCH):
            campaign.judge(batch[k:k + forgeries.BATCH])
    print(f"{aimed_at} aimed, {len(batch)} at random; verdicts {dict(campaign.verdicts)}; accepted ones judged {dict(campaign.judged)}")
    for fault in campaign.faults:
        print(fault)
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())
