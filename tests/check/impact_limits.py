#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of verify/check/FORMAT.md, section 17, as limits.py has those of section 8; with the same options."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from limits import NUMBERS, ZERO, Certificate, bits, cost, fraction, main, numbers_of, pair, width  # noqa: E402

WIDE = f"1/{2**50_000} {7**20_000} 5/{3**30_000}"
REST = ["1 0 0 0", "1 0 0 0", ZERO, ZERO]
EARLY = "-1 b 0 0 1"  # ends before it begins


class Moving(Certificate):
    """Proves nothing: the first piece ends before it begins, or there is none. A piece is a row, with weights behind it if it is near."""

    def __init__(self, a=(ZERO,), claim="apart", pieces=(EARLY,), motion=REST, weights=()):
        self.a, self.claim, self.pieces, self.motion, self.weights = a, claim, pieces, motion, list(weights)

    def lines(self):
        counts = [len(self.a), 1, len(self.pieces)]

        def both(weights):
            for word, rows in (("weights_a", weights), ("weights_b", ["0 1"])):
                counts.append(len(rows))
                yield from (f"{word} {len(rows)}", *rows)

        yield from ("fathom-certificate 6", f"a {len(self.a)}", *self.a, "b 1", ZERO, "motion_a", *self.motion, "motion_b", *REST)
        yield from (f"claim {self.claim}", f"pieces {len(self.pieces)}")
        for piece in self.pieces:
            yield piece
            if "near" in piece:
                yield from both(["0 1"])
        if "contact" in self.claim:
            yield from both(self.weights)
        yield "end " + " ".join(map(str, counts))

    def size_and_work(self):
        """The page's formulas, from the page's definitions."""
        near, rows_of = sum("near" in piece for piece in self.pieces), [piece.split(" ") for piece in set(self.pieces)]
        n, k, e = len(self.a) + 1, len(self.pieces) - near, near + ("contact" in self.claim)
        rows = (self.weights + ["0 1"] if "contact" in self.claim else []) + ["0 1"] * 2 * near
        w, x = width(numbers_of(self.a) + numbers_of(self.motion[2:] + [ZERO])), width(numbers_of(rows, 1))
        y = width(numbers_of(self.motion[:2] + REST[:2]))
        u = max((bits(int(number)) for _, kind, *numbers in rows_of if kind != "near" for number in numbers), default=0)
        times = {row[0] for row in rows_of} | {row[2] for row in rows_of if row[1] == "near"} | set(self.claim.split(" ")[1:])
        b = max((bits(q.numerator) + bits(q.denominator) for q in map(fraction, times)), default=1)
        z = 2 * w + 4 * y + 12 * b + 2 * u + 32
        work = 6 * n * k * cost(z, w) + (200 * k + 8 * n * e) * cost(z, z) + 4 * len(rows) * cost(z + x, z + x)
        return (n + 4) * w + 4 * y + len(rows) * x + 2 * k * u, work


def sizes():
    yield from pair("points", lambda k: Moving([WIDE, *[ZERO] * k], pieces=[]), 1_000, 60_000)
    yield from pair("weights", lambda k: Moving(claim="contact 1/2", pieces=[], weights=[f"0 1/{3**9_000}"] + ["0 1"] * k), 1_000, 900_000)


def works():
    places = ["1 0 0 0", f"1/{3**900} 0 0 1", ZERO, f"{5**900} 0 0"]
    yield from pair("pieces", lambda k: Moving(pieces=[EARLY] + ["1/2 a 0 0 1"] * k, motion=places), 10, 90_000)
    yield from pair("points and pieces", lambda k: Moving([f"1/{7**300} 0 0"] * k, pieces=[EARLY, "1/2 ab 0 0 1 0 1 0"] * 40), 10, 900_000)
    yield from pair("long directions", lambda k: Moving(pieces=[EARLY] + [f"1/2 ab 0 {-7**900} 1 0 1 0"] * k), 10, 900_000)
    yield from pair("long times", lambda k: Moving(pieces=[EARLY] + [f"1/{3**900} b 0 0 1"] * k), 10, 900_000)
    yield from pair("long distances", lambda k: Moving(["0 0 1/7"] * 90, pieces=[EARLY] + [f"1/2 near {7**900}"] * k), 10, 900_000)
    yield from pair("a contact", lambda k: Moving([f"{5**9_000} 0 0"] * k, f"contact 1/{2**90}", [], weights=["0 1/3"] * 9), 10, 900_000)
    yield from pair("weights", lambda k: Moving([f"{5**900} 0 0"], "contact 1/2", [], weights=[f"0 1/{3**3_000}"] + ["0 1"] * k), 10,
                    900_000)


def numbers():
    count = 300_000
    for more in (0, 1):
        left = NUMBERS + more - 3 - 3 - 28 - 4 - 2 * 4 - count * 7  # points, motions, pieces, weights
        text = list(Moving([ZERO] * (1 + left % 2), "contact 1/2", [EARLY] + ["1/2 ab 0 0 1 0 1 0"] * count,
                           weights=["0 1"] * ((left - 3 * (left % 2) + 6) // 2)).lines())
        yield f"{NUMBERS + more} numbers", text, len(text) - 1 if more else None  # that of b's weight


if __name__ == "__main__":
    sys.exit(main((sizes, works), (numbers,)))
