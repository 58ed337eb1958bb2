# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to damage a certificate. Each is a function of a genuine certificate, cut into its parts, and a random source, and yields the text
of a forgery, or None where it does not apply. A forgery may happen to be genuine still: who uses it must judge what it claims."""
import random
from fractions import Fraction

import patch_forging
from parts import Parts

CLAIMS = {"1": {"depth": 1, "bounds": 2, "touching": 0, "disjoint": 0}, "2": {"depth": 1, "touching": 0, "apart": 1, "signed_bounds": 2},
          "4": {"depth": 1, "touching": 0, "apart": 1}}


def some_row(parts, rng, *names):
    names = [name for name in names or parts.rows if parts.rows.get(name)]
    return rng.choice(parts.rows[rng.choice(names)]) if names else None


def nudged(word, rng):
    """Another number near a number, or one of the awkward ones."""
    if not word.lstrip("-").replace("/", "", 1).isdigit() or word.endswith("/"):
        return word + "1"
    value = Fraction(word)
    if "/" not in word or rng.random() < 0.5:
        return str(rng.choice([value + 1, value - 1, -value, 2 * value, value + Fraction(1, 10**20), value - Fraction(1, 3), Fraction(0),
                               value + 10**30, value / 2 + 1]))
    return rng.choice([word + "0", word.split("/")[0], word[:-1] or "0", f"{value.denominator}/{value.numerator or 1}"])


def number(parts, rng):
    """One number of one row, anywhere."""
    parts = parts.copy()
    row = some_row(parts, rng)
    k = rng.randrange(len(row))
    row[k] = nudged(row[k], rng)
    return parts.text()


def index(parts, rng):
    """One index of a vertex, facet or weight becomes another, in range or not."""
    parts = parts.copy()
    indexed = [part for part in ("vertices", "facets", "weights_a", "weights_b", "differences", "inner_a", "inner_b") if part in parts.rows]
    row = some_row(parts, rng, *indexed) if indexed else None
    if row is None:
        return None
    k = rng.randrange(len(row)) if "facets" in parts.rows or "differences" in parts.rows else 0
    row[k] = rng.choice([str(rng.randrange(12)), str(int(Fraction(row[k])) + 1), "18446744073709551616", "4294967296", "4294967295", "-1"])
    return parts.text()


def swapped_words(parts, rng):
    """Two words of one row change places: corners, indices, coordinates."""
    parts = parts.copy()
    row = some_row(parts, rng)
    i, k = rng.randrange(len(row)), rng.randrange(len(row))
    row[i], row[k] = row[k], row[i]
    return parts.text()


def swapped_rows(parts, rng):
    parts = parts.copy()
    rows = parts.rows[rng.choice([part for part in parts.rows if parts.rows[part]])]
    i, k = rng.randrange(len(rows)), rng.randrange(len(rows))
    rows[i], rows[k] = rows[k], rows[i]
    return parts.text()


def dropped_row(parts, rng):
    """With all counts repaired."""
    parts = parts.copy()
    rows = parts.rows[rng.choice([part for part in parts.rows if parts.rows[part]])]
    del rows[rng.randrange(len(rows))]
    return parts.text()


def doubled_row(parts, rng):
    parts = parts.copy()
    rows = parts.rows[rng.choice([part for part in parts.rows if parts.rows[part]])]
    rows.insert(rng.randrange(len(rows) + 1), list(rng.choice(rows)))
    return parts.text()


def reversed_facet(parts, rng):
    """Corners clockwise; of one facet, or of all."""
    if not parts.rows.get("facets"):
        return None
    parts = parts.copy()
    facets = parts.rows["facets"]
    for row in facets if rng.random() < 0.3 else [rng.choice(facets)]:
        row[1:] = row[:0:-1]
    return parts.text()


def cut_corner(parts, rng):
    """A facet loses a corner, or is split along a diagonal; the count of corners fits."""
    if not parts.rows.get("facets"):
        return None
    parts = parts.copy()
    facets = parts.rows["facets"]
    row = rng.choice(facets)
    corners = row[1:]
    if len(corners) > 3 and rng.random() < 0.5:
        facets.append(["3", corners[0], corners[1], corners[2]])
        corners.pop(1)
    else:
        corners.pop(rng.randrange(len(corners)))
    row[:] = [str(len(corners)), *corners]
    return parts.text()


def claimed(parts, rng):
    """Another claim over genuine parts: a little more, a little less, other words."""
    parts = parts.copy()
    words = parts.claim
    if len(words) > 1 and rng.random() < 0.7:
        k = rng.randrange(1, len(words))
        q = Fraction(words[k])
        near = [q * (1 + Fraction(s, 10**e)) for s in (1, -1) for e in (0, 1, 3, 9, 30)]
        words[k] = str(rng.choice(near + [-q, 4 * q, q + 1]))
        if words[0] == "depth" and parts.format == "1" and rng.random() < 0.4:
            q = Fraction(words[1])
            low, high = q * rng.choice([0, Fraction(1, 2), 1]), q * rng.choice([1, Fraction(3, 2)])
            words[:] = ["bounds", *map(str, sorted([low, high]))]
            parts.which = "some"
            parts.rows["directions"] = parts.rows["directions"][:1]
    else:
        word = rng.choice(list(CLAIMS[parts.format]))
        words[:] = [word, *["1", "2"][:CLAIMS[parts.format][word]]]
    return parts.text()


def direction(parts, rng):
    """n = 0, -n, 2n, n permuted; `some` and `all` exchanged; a direction more."""
    parts = parts.copy()
    rows = parts.rows["directions"]
    row = rng.choice(rows)
    how = rng.randrange(6)
    if how == 0:
        row[:] = ["0", "0", "0"]
    elif how == 1:
        row[:] = [str(-int(x)) for x in row]
    elif how == 2:
        row[:] = [str(2 * int(x)) for x in row]
    elif how == 3:
        row[:] = row[1:] + row[:1]
    elif how == 4:
        parts.which = "all" if parts.which == "some" else "some"
    else:
        rows.append([str(rng.randrange(-2, 3)) for _ in range(3)])
    return parts.text()


def exchanged_bodies(parts, rng):
    """The points of A for those of B; sometimes the indices of vertices too, which turns P around."""
    if "a" not in parts.rows or "b" not in parts.rows:
        return None
    parts = parts.copy()
    parts.rows["a"], parts.rows["b"] = parts.rows["b"], parts.rows["a"]
    if rng.random() < 0.5:
        for row in parts.rows.get("vertices", []):
            row.reverse()
    if rng.random() < 0.5:
        parts.rows["directions"] = [[str(-int(x)) for x in row] for row in parts.rows["directions"]]
    return parts.text()


def moved_body(parts, rng):
    """All points of one body shifted or scaled."""
    parts = parts.copy()
    rows = parts.rows.get(rng.choice("ab"))
    if rows is None:
        return None
    shift, scale = Fraction(rng.choice([0, 0, 1, -1]), rng.choice([1, 2, 10**12])), rng.choice([1, 1, 2, -1, Fraction(1, 2)])
    axis = rng.randrange(3)
    for row in rows:
        row[:] = [str(Fraction(x) * scale + (shift if k == axis else 0)) for k, x in enumerate(row)]
    return parts.text()


def near(parts, rng):
    """One number of the claim, of a radius, half-space, height or inner point, or a weight: a little more or less, or with the other
    sign."""
    parts = parts.copy()
    places = [(parts.claim, k) for k in range(1, len(parts.claim))]
    first = {"radius": 0, "halfspace": 0, "heights": 0, "inner": 1, "weights": 1}
    for part, rows in parts.rows.items():
        if part.split("_")[0] in first:
            places += [(row, k) for row in rows for k in range(first[part.split("_")[0]], len(row)) if k % 4 or "inner" not in part]
    if not places:
        return None
    row, k = rng.choice(places)
    value = Fraction(row[k])
    row[k] = str(rng.choice([-value, value * 2, Fraction(0)] + [value + Fraction(s, 10**e) for s in (1, -1) for e in (0, 2, 9, 30)]))
    return parts.text()


def another_body(parts, rng):
    """A radius gone or come, a term or an atom gone, a point for an atom, a half-space turned round."""
    parts = parts.copy()
    name = rng.choice("ab")
    shape, plane, rounding = (parts.rows.get(part + name) for part in ("shape_", "halfspace_", "radius_"))
    if rounding and rng.random() < 0.4:
        rounding.clear()
    elif shape and rng.random() < 0.6:
        k = rng.randrange(len(shape))
        if rng.random() < 0.5:
            del shape[k]
        elif shape[k] != ["term"]:
            shape[k] = ["point", *shape[k][1:4]]
    elif plane:
        plane[0][:3] = [str(-Fraction(x)) for x in plane[0][:3]] if rng.random() < 0.7 else ["0", "0", "0"]
    else:
        return None
    return parts.text()


def cone(parts, rng):
    """Rays and lineality: one more, one less, one longer, one turned."""
    parts = parts.copy()
    part = rng.choice(["lineality", "rays", "rays"])
    if part not in parts.rows:
        return None
    rows, how = parts.rows[part], rng.randrange(5)
    if how == 0 or not rows:
        rows.append([str(rng.randint(-2, 2)) for _ in range(3)])
    elif how == 1:
        del rows[rng.randrange(len(rows))]
    else:
        row = rng.choice(rows)
        row[:] = [str(int(x) * rng.choice([2, -1])) for x in row] if how < 4 else row[1:] + row[:1]
    rows.sort(key=lambda row: list(map(int, row)))
    return parts.text()


# On the text alone: mostly malformed, and every checker should say so.

def truncated(text, rng):
    return text[:rng.randrange(len(text))]


def line_gone(text, rng):
    lines = text.split("\n")
    del lines[rng.randrange(len(lines) - 1)]
    return "\n".join(lines)


def line_twice(text, rng):
    lines = text.split("\n")
    k = rng.randrange(len(lines) - 1)
    return "\n".join(lines[:k + 1] + lines[k:])


def lines_exchanged(text, rng):
    lines = text.split("\n")
    i, k = rng.randrange(len(lines) - 1), rng.randrange(len(lines) - 1)
    lines[i], lines[k] = lines[k], lines[i]
    return "\n".join(lines)


def byte(text, rng):
    k = rng.randrange(len(text))
    put = rng.choice(["", "0", "9", " ", "\n", "-", "/", "#", "%", "\r", "\x00", "é", "+", ".", "e"])
    return text[:k] + put + text[k + rng.randrange(2):]


def word_nudged(text, rng):
    """Any word of any line, counts, version and footer included."""
    lines = text.split("\n")
    k = rng.randrange(len(lines) - 1)
    words = lines[k].split(" ")
    i = rng.randrange(len(words))
    words[i] = nudged(words[i], rng)
    lines[k] = " ".join(words)
    return "\n".join(lines)


ON_PARTS = (number, number, index, swapped_words, swapped_rows, dropped_row, doubled_row, reversed_facet, cut_corner, claimed, claimed,
            direction, exchanged_bodies, moved_body)
ON_FORMAT_2 = (near, near, near, another_body, cone, cone)
ON_FORMAT_4 = patch_forging.NEVER + patch_forging.MAYBE
NEVER_ACCEPTED = {kind.__name__ for kind in patch_forging.NEVER}
ON_TEXT = (truncated, line_gone, line_twice, lines_exchanged, byte, word_nudged)


def foreign(parts, others, rng):
    """This proof under another case's points."""
    other = rng.choice(others)
    parts = parts.copy()
    for body in rng.choice(["ab", "a", "b"]):
        if body not in parts.rows or body not in other.rows:
            return None
        parts.rows[body] = other.rows[body]
    return parts.text()


def forgeries(text, others, count, seed):
    """(name, text) of forgeries of `text`: all truncations if there are no more than `count`, then `count` others. `others`: the Parts of
    other cases."""
    rng, parts = random.Random(seed), Parts(text)
    on_parts = ON_PARTS + {"1": (), "2": ON_FORMAT_2, "4": ON_FORMAT_2 + ON_FORMAT_4}[parts.format]
    genuine = parts.text()
    if len(genuine) <= count:
        yield from (("truncated", genuine[:k]) for k in range(len(genuine)))
    left = count
    while left > 0:
        kind = rng.choice(on_parts + ON_TEXT + (foreign,))
        forged = foreign(parts, others, rng) if kind is foreign else kind(parts if kind in on_parts else genuine, rng)
        left -= 1
        if forged is not None and forged != genuine:
            yield kind.__name__, forged
