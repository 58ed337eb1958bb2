#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forgeries of certificates of format 6: every checker sees them alike; none accepts those that cannot be right, and what else is accepted
is true at many times, by definition.

impact_forgeries.py --checker PROGRAM.. [--count N] [--share K] [--seed S] CERTIFICATE..

Every K-th is shown to the checkers after the first.
"""
import argparse
import collections
import pathlib
import random
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import forgeries  # noqa: E402
import forging  # noqa: E402
import motions  # noqa: E402

SMALL = Fraction(1, 10**12)


def nudged(rng, value):
    return value + rng.choice([1, -1, SMALL, -SMALL, Fraction(1, 7)])


# ---- what never is a proof ----
def pieces_end_too_soon(m, rng):
    if m.claim[0] != "apart":
        return False
    m.pieces[-1][1] -= rng.choice([SMALL, Fraction(1, 4096)])


def piece_gone_at_the_end(m, rng):
    if m.claim[0] == "contact":
        return False
    del m.pieces[-1]


def turned_round(m, rng):
    """The plane of a piece faces the other way: f of edges, n of a body."""
    piece = rng.choice(m.pieces)
    if piece[0] == "near":
        return False
    piece[2] = [-n for n in piece[2][:3]] + piece[2][3:]


def no_direction(m, rng):
    piece = rng.choice(m.pieces)
    if piece[0] == "near":
        return False
    piece[2] = [0, 0, 0] + piece[2][3:]


def parallel_edges(m, rng):
    """At the begin of the piece, where A has not turned; so at one time alone."""
    piece = m.pieces[0]
    if any(list(map(Fraction, motion[0])) != [1, 0, 0, 0] for motion in m.motions):
        return False
    piece[0], piece[2] = "ab", piece[2][:3] * 2


def motion_through_zero(m, rng):
    """The quaternion of a body is O within the time of a piece: not within a near miss, of which nothing is claimed."""
    motion, k = rng.choice(m.motions), rng.choice([1, 2, 3])
    zero, ends = Fraction(1, 1 + k), [Fraction(0), *(end for _, end, *_ in m.pieces)]
    if m.pieces[-1][1] != 1 or any(kind == "near" and begin < zero < end for begin, (kind, end, *_) in zip(ends, m.pieces)):
        return False
    motion[1] = [-k * Fraction(x) for x in motion[0]]


def zero_quaternion(m, rng):
    rng.choice(m.motions)[0] = [0, 0, 0, 0]


def contact_before_the_end(m, rng):
    if m.claim[0] != "contact" or not m.pieces:
        return False
    m.claim[1] = rng.choice([m.pieces[-1][1], m.pieces[-1][1] / 2, Fraction(0)])


def contact_elsewhere(m, rng):
    """At another time, or with another weight."""
    if m.claim[0] != "contact":
        return False
    rng.choice(m.weights)[0][1] += rng.choice([SMALL, -SMALL, 1])


def weight_negative(m, rng):
    if m.claim[0] != "contact":
        return False
    rows = rng.choice(m.weights)
    rows += [[rows[0][0], 1], [rows[0][0], -1]]


def no_such_point(m, rng):
    if m.claim[0] != "contact":
        return False
    rng.choice(m.weights)[0][0] += 100


def begins_in_contact(m, rng):
    """Bodies that are apart, said to touch at the time 0."""
    if m.meet_at(Fraction(0)) is not False:
        return False
    m.claim, m.pieces, m.weights = ["contact", 0], [], [[[0, 1]], [[0, 1]]]


def near_without_near(m, rng):
    if any(piece[0] == "near" for piece in m.pieces):
        return False
    m.claim, m.weights = ["grazing"], None


def near_first_or_last(m, rng):
    piece = ["near", rng.choice([Fraction(0), m.pieces[0][1]]), [10**6], [[[0, 1]], [[0, 1]]]]
    if rng.random() < 0.5:
        m.pieces.insert(0, piece)
    else:
        piece[1] = m.pieces[-1][1]
        m.pieces.append(piece)


def far_said_to_be_near(m, rng):
    k = rng.randrange(len(m.pieces))
    if m.pieces[k][0] == "near":
        return False
    m.claim = ["grazing"] if m.claim[0] != "contact" else m.claim
    m.pieces[k:k + 1] = [m.pieces[k], ["near", m.pieces[k][1], [0], [[[0, 1]], [[0, 1]]]], list(m.pieces[k])]


# ---- what may be ----
def end_moved(m, rng):
    piece = rng.choice(m.pieces)
    piece[1] = max(Fraction(0), piece[1] + rng.choice([SMALL, -SMALL, Fraction(1, 1024), -Fraction(1, 1024), Fraction(1, 16)]))


def another_direction(m, rng):
    piece = rng.choice(m.pieces)
    if piece[0] == "near":
        return False
    k = rng.randrange(len(piece[2]))
    piece[2] = [int(n) + rng.choice([1, -1]) * (j == k) for j, n in enumerate(piece[2])]


def another_kind(m, rng):
    piece = rng.choice(m.pieces)
    if piece[0] not in "ab":
        return False
    piece[0] = "a" if piece[0] == "b" else "b"


def point_moved(m, rng):
    p = rng.choice(rng.choice(m.bodies))
    k = rng.randrange(3)
    p[k] = nudged(rng, Fraction(p[k]))


def motion_changed(m, rng):
    motion = rng.choice(m.motions)
    row = motion[rng.randrange(4)] = list(rng.choice(motion))
    k = rng.randrange(len(row))
    row[k] = nudged(rng, Fraction(row[k]))


def contact_later(m, rng):
    if m.claim[0] != "contact":
        return False
    m.claim[1] = nudged(rng, Fraction(m.claim[1]))


def pieces_exchanged(m, rng):
    i, k = rng.randrange(len(m.pieces)), rng.randrange(len(m.pieces))
    if i == k:
        return False
    m.pieces[i], m.pieces[k] = m.pieces[k], m.pieces[i]


def piece_gone(m, rng):
    """The next one has to do for both."""
    del m.pieces[rng.randrange(len(m.pieces))]


def piece_in_two(m, rng):
    k = rng.randrange(len(m.pieces))
    if m.pieces[k][0] == "near":
        return False
    begin = m.pieces[k - 1][1] if k else 0
    m.pieces.insert(k, [m.pieces[k][0], (begin + m.pieces[k][1]) / 2, list(m.pieces[k][2]), None])


def scaled_quaternion(m, rng):
    """Both by the same factor: the same motion."""
    motion, k = rng.choice(m.motions), rng.choice([2, Fraction(1, 3), -1])
    motion[:2] = [[k * Fraction(x) for x in row] for row in motion[:2]]


NEVER = (pieces_end_too_soon, piece_gone_at_the_end, turned_round, no_direction, parallel_edges, motion_through_zero, zero_quaternion,
         contact_before_the_end, contact_elsewhere, weight_negative, no_such_point, begins_in_contact, near_without_near,
         near_first_or_last, far_said_to_be_near)
ALWAYS = (piece_in_two, scaled_quaternion)
MAYBE = (end_moved, another_direction, another_kind, point_moved, motion_changed, contact_later, pieces_exchanged, piece_gone)


def is_true(m, rng):
    """At some times of each piece, its ends too, and at the contact."""
    begin = Fraction(0)
    for kind, end, *_ in m.pieces:
        times = [begin, end, begin + (end - begin) * Fraction(rng.randrange(1, 64), 64)]
        if kind != "near" and any(m.meet_at(t) is not False for t in rng.sample(times, 2)):
            return False
        begin = end
    return m.claim[0] != "contact" or m.meet_at(Fraction(m.claim[1])) is True


def read(text):
    """The other way round."""
    rows = [line.split(" ") for line in text.split("\n") if not line.startswith("#")]
    rows = [row for row in rows if row[0] not in ("fathom-certificate", "id")]

    def part():
        return [rows.pop(0) for _ in range(int(rows.pop(0)[1]))]

    def weights():
        return [[[int(i), Fraction(w)] for i, w in part()] for _ in "ab"]

    bodies = [part(), part()]
    moved = [[rows.pop(0) for _ in range(5)][1:] for _ in "ab"]
    m = motions.Motion(*bodies, *moved)
    m.claim = rows.pop(0)[1:]
    for _ in range(int(rows.pop(0)[1])):
        end, kind, *numbers = rows.pop(0)
        m.pieces.append([kind, Fraction(end), [Fraction(n) if kind == "near" else int(n) for n in numbers],
                         weights() if kind == "near" else None])
    m.weights = weights() if m.claim[0] == "contact" else None
    return m


def forged(rng, genuine):
    """(kind, certificate, its text, whether it must be accepted; None: nobody knows)."""
    kinds = [*((change, False) for change in NEVER), *((change, True) for change in ALWAYS), *((change, None) for change in MAYBE * 3),
             *((change, "text") for change in forging.ON_TEXT)]
    while True:
        for change, expected in kinds:
            if expected == "text":
                yield change.__name__, None, change(rng.choice(genuine).text(), rng), None
                continue
            for m in (rng.choice(genuine).copy() for _ in range(20)):  # it may not apply to some
                if m.pieces and change(m, rng) is not False:
                    yield change.__name__, m, m.text(), expected
                    break


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--checker", action="append", required=True)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    rng, faults, tries, accepted = random.Random(options.seed), [], collections.Counter(), collections.Counter()
    genuine = [read(file.read_text()) for file in options.files]
    genuine += filter(None, (motions.random_motion(rng) for _ in range(60)))
    batch = [("genuine", m, m.text(), True) for m in genuine]
    batch += [forgery for forgery, _ in zip(forged(rng, genuine), range(options.count))]

    def fault(sentence, text):
        path = pathlib.Path(tempfile.gettempdir()) / f"impact_forgery_{len(faults)}.cert"
        path.write_text(text)
        faults.append(f"{sentence}: {path}")

    with tempfile.TemporaryDirectory() as folder:
        for k in range(0, len(batch), forgeries.BATCH):
            part = batch[k:k + forgeries.BATCH]
            found = forgeries.verdicts_of(options, folder, [text for *_, text, _ in part], fault)
            for (kind, m, text, expected), name in zip(part, found):
                good = len(found[name]) == 1 and found[name][0].startswith("VERIFIED")
                tries[kind] += 1
                accepted[kind] += good
                if expected not in (None, good):
                    fault(f"{kind}: {found[name]}", text)
                elif good and m and not is_true(m, rng):
                    fault(f"{kind}: what is accepted is not true", text)
    print(f"{len(batch) - len(genuine)} forgeries of {len(genuine)}; accepted {dict(+accepted)} of {dict(tries)}")
    for sentence in faults[:20]:
        print(sentence)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
