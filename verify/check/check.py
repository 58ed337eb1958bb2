#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""FORMAT.md as a program, to be read: check.py FILE... (- is standard input). One verdict line per certificate; exit code 0 all
accepted, 1 some refused, 2 some malformed. Needs nothing but Python. fathom-check is the fast one."""
import os
import re
import sys
from fractions import Fraction
from math import gcd, lcm

Refused, Malformed = (type(name, (Exception,), {}) for name in ("Refused", "Malformed"))
LONGEST_LINE, LONGEST_NUMBER, LONGEST_CERTIFICATE, MOST_NUMBERS = 2**24, 10**5, 10**9, 10**7
LARGEST_SIZE, MOST_WORK = 4 * 10**9, 10**14
NATURAL = re.compile("[0-9]{1,%d}" % LONGEST_NUMBER)
INTEGER = re.compile("-?" + NATURAL.pattern)
RATIONAL = re.compile(INTEGER.pattern + "(/(?!0+$)" + NATURAL.pattern + ")?")
TEXT = re.compile("([!-$&-~]|%[0-9A-Fa-f]{2})+")
NUMBERS = {"depth": 1, "bounds": 2, "touching": 0, "disjoint": 0}


def demand(true, reason, kind=Refused):
    if not true:
        raise kind(reason)


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def rational(text):
    p, _, q = text.partition("/")
    return Fraction(int(p), int(q or 1))


class Reader:
    """Section 2: the grammar. `line` is the line at hand, None behind the last one; `number` its number, from 1."""

    def __init__(self, file):
        self.file, self.number, self.line, self.bytes, self.numbers = file, 0, "", 0, 0

    def step(self):
        """To the next line. One that is too long is read as an empty one, without a line feed."""
        line = part = self.file.readline(LONGEST_LINE + 1)
        while len(part) > LONGEST_LINE and not part.endswith(b"\n"):
            line, part = b"-", self.file.readline(LONGEST_LINE + 1)
        self.number += 1
        self.line = line.decode("latin-1") if line else None

    def advance(self):
        self.step()
        while self.line and self.line.startswith("#") and self.line.endswith("\n"):
            self.step()

    def fields(self):
        return (self.line or "")[:-1].split(" ")

    def these(self, *shape):
        """The fields of the line at hand, by their shapes: a word, or a pattern."""
        found, expected = self.fields(), "expected " + " ".join(s if isinstance(s, str) else s.pattern for s in shape[:6])
        demand(self.line and self.line.endswith("\n") and len(found) == len(shape), expected, Malformed)
        demand(all(f == s if isinstance(s, str) else s.fullmatch(f) for f, s in zip(found, shape)), expected, Malformed)
        self.bytes += len(self.line) - 1
        demand(self.bytes <= LONGEST_CERTIFICATE, f"a certificate of more than {LONGEST_CERTIFICATE} bytes", Malformed)
        return found

    def next(self, *shape):
        self.advance()
        return self.these(*shape)

    def row(self, *shape):
        self.advance()
        found = self.these(*shape or [NATURAL] * len(self.fields()))
        self.numbers += len(found)
        demand(self.numbers <= MOST_NUMBERS, f"a certificate of more than {MOST_NUMBERS} numbers", Malformed)
        return found

    def rows(self, count, shape, number):
        return [tuple(map(number, self.row(*shape))) for _ in range(count)]

    def part(self, word, shape, number):
        return self.rows(int(self.next(word, NATURAL)[1]), shape, number)

    def facet(self):
        found = self.row()
        demand(int(found[0]) == len(found) - 1, "expected as many corners as announced", Malformed)
        return tuple(map(int, found[1:]))

    def certificate(self, c):
        self.bytes = self.numbers = 0
        self.these("fathom-certificate", "1")
        self.advance()
        if self.fields()[0] == "id":
            c["id"] = self.these("id", TEXT)[1]
            self.advance()
        c["a"] = self.rows(int(self.these("a", NATURAL)[1]), [RATIONAL] * 3, rational)
        c["b"] = self.part("b", [RATIONAL] * 3, rational)
        self.advance()
        word = (self.fields() + [""])[1]
        demand(word in NUMBERS, "expected a claim", Malformed)
        c["claim"], *bounds = self.these("claim", word, *[RATIONAL] * NUMBERS[word])[1:]
        c["bounds"] = [rational(x) for x in bounds]
        _, count, c["which"] = self.next("directions", NATURAL, re.compile("some|all"))
        c["directions"] = self.rows(int(count), [INTEGER] * 3, int)
        if bounds:
            c["vertices"] = self.part("vertices", [NATURAL] * 2, int)
            c["facets"] = [self.facet() for _ in range(int(self.next("facets", NATURAL)[1]))]
        elif word == "touching":
            c["weights_a"] = self.part("weights_a", [NATURAL, RATIONAL], rational)
            c["weights_b"] = self.part("weights_b", [NATURAL, RATIONAL], rational)
        counts = [len(c["a"]), len(c["b"]), len(c["directions"])]
        counts += [len(c["vertices"] + c["weights_a"]), len(c["facets"] + c["weights_b"])]
        demand(list(map(int, self.next("end", *[NATURAL] * 5)[1:])) == counts, "expected the counts of the parts again", Malformed)


def widest(numbers):
    return max((abs(n).bit_length() for n in numbers), default=0)


def common_denominator(numbers, vectors):
    """Of these numbers, and how wide they become over it."""
    common = 1
    for denominator in {x.denominator for x in numbers}:
        common = lcm(common, denominator)
        demand(vectors * common.bit_length() <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    return common, common.bit_length() + widest(x.numerator for x in numbers)


def cost(s, t):
    return (256 + max(s, t)) * (256 + min(s, t, 4000))


def require_limits(c):
    """Section 8: size and work. From here on the points and the weights are integers, over common denominators."""
    points, weights = c["a"] + c["b"], c["weights_a"] + c["weights_b"]
    vectors = len(points) + len(c["vertices"]) + 3 * len(c["facets"])
    c["unit"], w = common_denominator([x for p in points for x in p], vectors)
    c["whole"], x = common_denominator([weight for _, weight in weights], len(weights))
    demand(vectors * w + len(weights) * x <= LARGEST_SIZE, f"a certificate of a size above {LARGEST_SIZE}", Malformed)
    work = len(points) * len(c["directions"]) * cost(w, widest(n for row in c["directions"] for n in row))
    work += (len(points) + 4 * sum(len(corners)**2 for corners in c["facets"])) * cost(w, w)
    work += 4 * (len(c["directions"]) + len(c["facets"])) * cost(w, widest(n for q in c["bounds"] for n in q.as_integer_ratio()))
    work += 4 * len(weights) * cost(w + x, w + x)
    demand(work <= MOST_WORK, f"a certificate of work above {MOST_WORK}", Malformed)
    for body in "ab":
        c[body] = [tuple(x.numerator * (c["unit"] // x.denominator) for x in p) for p in c[body]]
        c["weights_" + body] = [(int(i), w.numerator * (c["whole"] // w.denominator)) for i, w in c["weights_" + body]]


def check_inner(c, q):
    """The polytope Q inside P holds the ball of squared radius q."""
    for j, i in c["vertices"]:
        demand(j < len(c["b"]) and i < len(c["a"]), "a vertex without a point")
    vertices = [tuple(y - x for x, y in zip(c["a"][i], c["b"][j])) for j, i in c["vertices"]]
    demand(c["facets"], "no facet")
    planes, across, listed = [], {}, set(c["directions"])
    for f, corners in enumerate(c["facets"]):
        demand(len(corners) >= 3 and max(corners) < len(vertices), "a facet without corners")
        v = [vertices[k] for k in corners]
        normal = tuple(map(sum, zip(*(cross(v[k - 1], v[k]) for k in range(len(v))))))
        plane = dot(normal, v[0])
        planes.append((normal, plane))
        reached, needed = plane * plane * q.denominator, q.numerator * dot(normal, normal)
        demand(plane > 0 and reached >= needed, "a facet nearer than claimed")
        demand(all(dot(normal, w) == plane for w in v), "corners not on one plane")
        demand(all(dot(v[0], cross(v[k], v[k + 1])) > 0 for k in range(1, len(v) - 1)), "corners do not turn one way")
        for k in range(len(corners)):
            across.setdefault((corners[k], corners[k - 1]), f)  # seen from the other side; the first facet counts
        if c["which"] == "all" and reached == needed:
            demand(tuple(x // gcd(*normal) for x in normal) in listed, "a nearest facet that is not listed")
    for corners in c["facets"]:
        for k in range(len(corners)):
            u, v = corners[k - 1], corners[k]
            demand((u, v) in across, "an edge with one facet")
            normal, plane = planes[across[u, v]]
            demand(dot(normal, vertices[u]) == plane == dot(normal, vertices[v]), "an edge off the plane across")
            inward = cross(vertices[u], vertices[v])  # det(u, v, w) = <u x v, w>
            demand(any(dot(inward, vertices[w]) > 0 and dot(normal, vertices[w]) < plane for w in corners), "not convex across an edge")
    demand(any(dot(normal, planes[0][0]) < 0 for normal, _ in planes), "no facet faces away from the first")


def combination(weights, points, whole):
    demand(all(i < len(points) and w > 0 for i, w in weights), "weights are positive, of points that exist")
    demand(sum(w for _, w in weights) == whole, "weights sum to 1")
    return [sum(w * points[i][k] for i, w in weights) for k in range(3)]


def check(c):
    """Section 4. What is proved, for the verdict line."""
    claim, bounds, directions = c["claim"], c["bounds"], c["directions"]
    demand(c["a"] and c["b"] and directions, "no points, or no direction")
    demand(claim == "depth" or (len(directions) == 1 and c["which"] == "some"), "exactly one direction, and some")
    squared = [x * c["unit"]**2 for x in bounds]
    for n in directions:
        demand(any(n), "a direction that is zero proves nothing")
        h = max(dot(n, b) for b in c["b"]) - min(dot(n, a) for a in c["a"])
        if claim in ("depth", "bounds"):
            reached, allowed = h * h * squared[-1].denominator, squared[-1].numerator * dot(n, n)
            demand(h > 0 and (reached == allowed or (claim == "bounds" and reached < allowed)), "not the distance claimed")
        else:
            demand(h == 0 if claim == "touching" else h < 0, "O not on, or not above, the plane")
    if c["which"] == "all":
        demand(all(gcd(*n) == 1 for n in directions), "a direction that is not primitive")
        demand(all(n < m for n, m in zip(directions, directions[1:])), "directions not in ascending order")
    if claim == "touching":
        common = [combination(c["weights_" + x], c[x], c["whole"]) for x in "ab"]
        demand(common[0] == common[1], "weights of different points")
    if claim in ("touching", "disjoint"):
        return claim + " depth_squared=0"
    demand(0 <= bounds[0] <= bounds[-1] > 0 and (claim == "bounds" or bounds[0] > 0), "not the bounds of a depth")
    check_inner(c, squared[0])
    if claim == "bounds":
        return "penetrating depth_squared_in=[%s,%s]" % tuple(bounds)
    return f"penetrating depth_squared={bounds[0]}" + (f" optima={len(directions)}" if c["which"] == "all" else "")


def verdicts(file, name):
    """One (exit code, line) per certificate; at least one."""
    reader, any_yet = Reader(file), False
    reader.advance()
    while reader.line is not None or not any_yet:
        any_yet, first = True, reader.number
        c = {"id": "", "bounds": [], "vertices": [], "facets": [], "weights_a": [], "weights_b": []}
        try:
            reader.certificate(c)
            require_limits(c)
            yield 0, f"s VERIFIED {check(c)} {c['id'] or name}"
            reader.advance()
        except Refused as error:
            yield 1, f"s REFUSED {c['id'] or name}:{reader.number}: {error}"
            reader.advance()
        except (Malformed, MemoryError) as error:
            yield 2, f"s MALFORMED {c['id'] or name}:{reader.number}: {error or 'out of memory'}"
            if reader.number == first:
                reader.step()
            while reader.line is not None and not reader.line.startswith("fathom-certificate"):
                reader.step()


def judged(name):
    label = b"<stdin>" if name == "-" else re.sub(rb"[^!-$&-~]", lambda m: b"%%%02X" % m[0][0], os.fsencode(name))
    try:
        with open(0 if name == "-" else name, "rb", closefd=name != "-") as file:
            yield from verdicts(file, label.decode())
    except OSError as error:
        yield 2, f"s MALFORMED {label.decode()}:0: {error.strerror}"


def main(names):
    worst = 0
    if not names or sys.stdout is None:
        expected = "standard output, which is closed" if names else "certificates: files, or - for standard input"
        sys.stderr.write(f"check.py: expected {expected}\n")
        return 2
    for code, line in (verdict for name in names for verdict in judged(name)):
        try:
            print(line, flush=True)
        except OSError as error:
            sys.stderr.write(f"check.py: cannot write to standard output: {error.strerror}\n")
            os._exit(2)  # Python would try once more to write
        worst = max(worst, code)
    return worst


if __name__ == "__main__":
    getattr(sys, "set_int_max_str_digits", int)(0)  # no limit
    sys.exit(main(sys.argv[1:]))
