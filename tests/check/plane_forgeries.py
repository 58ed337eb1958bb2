#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edits certificates of bodies of the plane by the thousand, and demands that all checkers say the same of each and that what they print
is true in the plane, where it is found here by definition: from the edges of all differences of pieces.

plane_forgeries.py --checker COMMAND [--checker COMMAND].. [--count N] [--share K] [--seed S] PATH..

PATH is a folder of genuine certificates (*.cert). The first checker sees every forgery, the others each K-th one. Exit codes: 0 fine;
1 a disagreement, or something untrue is said; 2 usage, or a genuine certificate is not accepted.
"""
import itertools
import pathlib
import random
import re
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from forgeries import EXIT, campaign_arguments, run_checker  # noqa: E402

BATCH = 500


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def sub(u, v):
    return (u[0] - v[0], u[1] - v[1])


def hull(points):
    """Its corners, counter-clockwise; of points on a line the two ends."""
    points = sorted(set(points))
    if len(points) < 3:
        return points

    def half(row):
        found = []
        for p in row:
            while len(found) > 1 and cross(sub(found[-1], found[-2]), sub(p, found[-2])) <= 0:
                found.pop()
            found.append(p)
        return found[:-1]
    return half(points) + half(points[::-1])


def edges(corners):
    return list(zip(corners, corners[1:] + corners[:1]))


def inside(t, corners):
    """1 in the interior, 0 on the boundary, -1 outside."""
    if len(corners) < 3:
        p, q = corners[0], corners[-1]
        return 0 if cross(sub(q, p), sub(t, p)) == 0 and dot(sub(t, p), sub(t, q)) <= 0 else -1
    sides = [cross(sub(q, p), sub(t, p)) for p, q in edges(corners)]
    return 1 if min(sides) > 0 else 0 if min(sides) == 0 else -1


def foot(p, q):
    """Of O on the line through p and q."""
    along = sub(q, p)
    if along == (0, 0):
        return p
    k = -dot(p, along) / dot(along, along)
    return (p[0] + k * along[0], p[1] + k * along[1])


def square_of_cores(a, b):
    """The squared depth, or minus the squared distance, of unions of hulls of points of the plane; and how many ways out there are."""
    gaps = [hull([sub(q, p) for p in k for q in l]) for k in a for l in b]
    sides = [edge for corners in gaps for edge in edges(corners)]
    origin = (Fraction(0), Fraction(0))
    if any(inside(origin, corners) == 1 for corners in gaps):
        places = {foot(*edge) for edge in sides}
        for (p, q), (r, s) in itertools.combinations(sides, 2):
            turn = cross(sub(q, p), sub(s, r))
            if turn:
                k = cross(sub(r, p), sub(s, r)) / turn
                places.add((p[0] + k * (q[0] - p[0]), p[1] + k * (q[1] - p[1])))
        free = [t for t in places if all(inside(t, corners) < 1 for corners in gaps)]
        least = min(dot(t, t) for t in free)
        return least, sum(dot(t, t) == least for t in free)
    if any(inside(origin, corners) == 0 for corners in gaps):
        return Fraction(0), None
    near = [p for corners in gaps for p in corners] + [foot(p, q) for corners in gaps for p, q in edges(corners)
                                                         if p != q and dot(sub(foot(p, q), p), sub(foot(p, q), q)) <= 0]
    return -min(dot(t, t) for t in near), None


def read(text):
    """The cores, as lists of pieces or a half-plane, and the radii, of a certificate that has been accepted."""
    lines = [line.split(" ") for line in text.split("\n") if not line.startswith("#")]
    bodies, radii, k = {"a": [], "b": []}, Fraction(0), 1
    while lines[k][0] != "claim":
        word, *numbers = lines[k]
        if word in bodies:
            count = int(numbers[0])
            bodies[word].append([tuple(map(Fraction, row)) for row in lines[k + 1:k + 1 + count]])
            k += count
        elif word.startswith("halfspace_"):
            bodies[word[-1]] = tuple(map(Fraction, numbers))
        elif word.startswith("radius_"):
            radii += Fraction(numbers[0])
        k += 1
    return bodies["a"], bodies["b"], radii


def truth(text):
    """Of the cores as square_of_cores, and the radii."""
    a, b, radii = read(text)
    for half, other in ((a, b), (b, a)):
        if isinstance(half, tuple):
            m, d = half[:2], half[2]
            height = d - min(dot(m, p) for piece in other for p in piece)
            return height * abs(height) / dot(m, m), None, radii
    return *square_of_cores(a, b), radii


def is_true(said, text):
    """Whether this holds of the bodies of the certificate: 'penetrating depth_squared=1 optima=1 dimension=2'."""
    square, ways, radii = truth(text)
    words = said.split(" ")
    fields = dict(word.split("=", 1) for word in words[1:])
    if fields.pop("dimension", None) != "2" or int(fields.get("optima", ways or 0)) != (ways or 0):
        return False
    if "signed_depth" in fields:
        sign, root, plus = re.fullmatch(r"(-?)sqrt\((.*)\)\+(.*)", fields["signed_depth"]).groups()
        root = -Fraction(root) if sign else Fraction(root)
        value = Fraction(plus) * abs(Fraction(plus)) + root if root < 0 else max(Fraction(plus), root)
        status = "penetrating" if value > 0 else "disjoint" if value < 0 else "touching"
        return (root, Fraction(plus), status) == (square, radii, words[0])
    if "depth_squared_in" in fields:
        low, high = map(Fraction, fields["depth_squared_in"][1:-1].split(","))
        return square > 0 and low <= square <= high and words[0] == "penetrating"
    if "distance_squared" in fields:
        return square == -Fraction(fields["distance_squared"]) and words[0] == "disjoint"
    status = "penetrating" if square > 0 else "disjoint" if square < 0 else "touching"
    return status == words[0] and Fraction(fields["depth_squared"]) == max(square, 0)


def edited(text, others, rng):
    """With one or two edits: of a number, of a field, of a line."""
    lines = text.split("\n")[:-1]
    for _ in range(rng.choice((1, 1, 2))):
        k = rng.randrange(len(lines))
        words = lines[k].split(" ")
        i = rng.randrange(len(words))
        kind = rng.randrange(9)
        if kind < 4 and re.fullmatch(r"-?\d+(/\d+)?", words[i]):
            p = Fraction(words[i])
            words[i] = str(rng.choice((p + 1, p - 1, -p, 2 * p, p / 2, p + Fraction(1, 1000), Fraction(0), Fraction(1))))
        elif kind == 4:
            words.insert(i, rng.choice(("0", "1", "x", "")))
        elif kind == 5:
            del words[i]
        elif kind == 6:
            words = rng.choice(rng.choice(others).split("\n")[:-1]).split(" ")
        lines[k] = " ".join(words)
        if kind == 7:
            del lines[k]
        elif kind == 8:
            lines.insert(k, rng.choice((lines[k], "plane 8", "plane 0", "plane 1/1000", "radius_a 1", "radius_b 1/2")))
        if not lines:
            break
    return "\n".join(lines) + "\n"


def moved(text, rng):
    """With another height, or with other coordinates: one of the ways that may be accepted."""
    height = rng.choice(("1/10", "1", "2", "3", "7/2", "100", "1000000007/1000000000"))
    text = re.sub("^plane .*", f"plane {height}", text, flags=re.MULTILINE)
    if rng.randrange(2):
        k = rng.choice((Fraction(2), Fraction(1, 3), Fraction(5, 7)))
        head, claim, rest = re.split("^(claim .*)", text, maxsplit=1, flags=re.MULTILINE)
        rows = [line.split(" ") for line in head.split("\n")]
        scaled = [" ".join(str(k * Fraction(x)) for x in row) if re.fullmatch(r"-?\d+(/\d+)?", row[0]) else " ".join(row) for row in rows]
        text = "\n".join(scaled) + re.sub(r"\d+(/\d+)?$", lambda m: str(k * k * Fraction(m[0])), claim) + rest
    return text


def main():
    parser = campaign_arguments(4000)
    parser.add_argument("path", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    files = [file for path in options.path for file in sorted(path.glob("*.cert"))]
    genuine = [re.sub("^(#|id ).*\n", "", file.read_text(), flags=re.MULTILINE) for file in files]
    rng = random.Random(options.seed)
    texts = genuine + [(moved if k % 4 == 0 else lambda t, r: edited(t, genuine, r))(genuine[k % len(genuine)], rng)
                       for k in range(options.count)]
    faults, counts = [], dict.fromkeys(EXIT, 0)
    for first in range(0, len(texts), BATCH):
        with tempfile.TemporaryDirectory() as folder:
            names = [f"f{k}" for k in range(first, min(first + BATCH, len(texts)))]
            for name in names:
                (pathlib.Path(folder) / name).write_text(texts[int(name[1:])])
            answers = [run_checker(checker, folder, names[::options.share if n else 1]) for n, checker in enumerate(options.checker)]
        for name in names:
            text, verdicts = texts[int(name[1:])], answers[0][name]
            faults += [f"{verdicts} and {found[name]}:\n{text}" for found in answers[1:] if found.get(name, verdicts) != verdicts]
            if len(verdicts) == 1:
                word, _, said = verdicts[0].partition(" ")
                counts[word] += 1
                if int(name[1:]) < len(genuine) and word != "VERIFIED":
                    print(f"{files[int(name[1:])]}: {verdicts[0]}")
                    return 2
                if word == "VERIFIED" and ("plane" in text) != ("dimension=2" in said):
                    faults.append(f"of another dimension: {said}\n{text}")
                if "dimension=2" in said and not is_true(said, text):
                    faults.append(f"untrue: {said}\n{text}")
    print(counts)
    print("\n".join(faults[:10]))
    return 1 if faults or not all(counts.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
