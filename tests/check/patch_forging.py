# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to damage the patches and rates of a certificate of format 4, as those of forging.py. Of NEVER none is accepted: what they say is
untrue, or is not proved. MAYBE may say the same as before."""
from fractions import Fraction


def cut(parts):
    """[(corners, sides)] of each patch; a corner is [[index, weight, ..] of A, the same of B]."""
    found = []
    for row in parts.rows["patches"]:
        if row == ["patch"]:
            found.append(([], []))
        elif row[0] in ("a", "b"):
            found[-1][1].append(list(row))
        else:
            k = 1 + 2 * int(row[0])
            found[-1][0].append([row[1:k], row[k + 1:]])
    return found


def with_patches(parts, patches):
    parts = parts.copy()
    parts.rows["patches"] = []
    for corners, sides in patches:
        rows = [[str(len(a) // 2), *a, str(len(b) // 2), *b] for a, b in corners]
        parts.rows["patches"] += [["patch"], *rows, *(list(map(str, side)) for side in sides)]
    return parts.text()


def on_patches(change):
    """Of all patches, in the order of the directions; None if it does not apply."""
    def forged(parts, rng):
        patches = change(cut(parts), rng)
        return None if patches is None else with_patches(parts, patches)

    forged.__name__ = change.__name__
    return forged


def on_one(change):
    """Of the corners and sides of one patch."""
    def changed(patches, rng):
        k = rng.randrange(len(patches))
        patches[k] = change(*patches[k], rng)
        return None if patches[k] is None else patches

    changed.__name__ = change.__name__
    return on_patches(changed)


def moved(sides, to):
    """With the corner's number k made to(k)."""
    return [[*side[:4], to(int(side[4]))] for side in sides]


@on_patches
def no_patches(patches, rng):
    return []


@on_patches
def patch_gone(patches, rng):
    del patches[rng.randrange(len(patches))]
    return patches


@on_patches
def patch_twice(patches, rng):
    return patches + [rng.choice(patches)]


@on_patches
def patches_exchanged(patches, rng):
    return patches[1:] + patches[:1] if len(patches) > 1 else None


@on_one
def no_corners(corners, sides, rng):
    return [], sides if rng.random() < 0.5 else []


@on_one
def no_sides(corners, sides, rng):
    return corners, []


@on_one
def corner_gone(corners, sides, rng):
    i, n = rng.randrange(len(corners)), len(corners)
    return corners[:i] + corners[i + 1:], moved(sides, lambda k: min(k, n - 2) if n > 1 else 0)


@on_one
def corner_gone_with_its_sides(corners, sides, rng):
    i = rng.randrange(len(corners))
    return corners[:i] + corners[i + 1:], moved([side for side in sides if int(side[4]) != i], lambda k: k - (k > i))


@on_one
def corner_twice(corners, sides, rng):
    named = [[*sides[-1][:4], len(corners)]] if rng.random() < 0.5 else []
    return corners + [rng.choice(corners)], sides + named


@on_one
def all_twice(corners, sides, rng):
    return corners * 2, sides + moved(sides, lambda k: k + len(corners))


def between(corner, other):
    """With half of the weights of each."""
    halves = lambda words: [w if k % 2 == 0 else str(Fraction(w) / 2) for k, w in enumerate(words)]
    return [halves(u) + halves(v) for u, v in zip(corner, other)]


@on_one
def middle_for_a_corner(corners, sides, rng):
    i = rng.randrange(len(corners))
    middle = between(corners[i], corners[i - 1])
    return (corners[:i] + [middle] + corners[i + 1:], sides) if len(corners) > 1 else None


@on_one
def middle_more(corners, sides, rng):
    i = rng.randrange(len(corners))
    if len(corners) == 1:
        return None
    more = [corners[:i] + [between(corners[i], corners[i - 1])] + corners[i:], moved(sides, lambda k: k + (k >= i))]
    line = next(side for side in more[1] if side[4] == i + 1)
    more[1].insert(more[1].index(line), [*line[:4], i])
    return more


@on_one
def corners_in_another_order(corners, sides, rng):
    return (corners[1:] + corners[:1] if rng.random() < 0.5 else corners[::-1], sides) if len(corners) > 1 else None


@on_one
def weight_changed(corners, sides, rng):
    words = rng.choice([words for corner in corners for words in corner if words])
    k = rng.randrange(1, len(words), 2)
    words[k] = str(Fraction(words[k]) * rng.choice([0, -1, 2, Fraction(1, 2), 1 + Fraction(1, 10**20)]))
    return corners, sides


@on_one
def negative_weight(corners, sides, rng):
    words = rng.choice([words for corner in corners for words in corner if words])
    words += [words[0], "1", words[0], "-1"]
    return corners, sides


@on_one
def index_too_large(corners, sides, rng):
    words = rng.choice([words for corner in corners for words in corner if words])
    words[rng.randrange(0, len(words), 2)] = rng.choice(["1000", "4294967295", "4294967296", "18446744073709551616"])
    return corners, sides


@on_one
def weights_of_one_body(corners, sides, rng):
    corner, x = rng.choice(corners), rng.randrange(2)
    corner[x] = [] if corner[x] else ["0", "1"]
    return corners, sides


def on_side(change):
    def changed(corners, sides, rng):
        k = rng.randrange(len(sides))
        sides[k] = change(sides[k], len(corners), rng)
        return corners, sides

    changed.__name__ = change.__name__
    return on_one(changed)


@on_side
def side_turned_round(side, corners, rng):
    return [side[0], *(-int(x) for x in side[1:4]), side[4]]


@on_side
def side_zero(side, corners, rng):
    return [side[0], 0, 0, 0, side[4]]


@on_side
def side_of_another_corner(side, corners, rng):
    return [*side[:4], rng.choice([(int(side[4]) + 1) % (corners + 1), corners, 2**32 + int(side[4])])]


@on_one
def sides_reversed(corners, sides, rng):
    return corners, sides[::-1]


@on_one
def two_sides(corners, sides, rng):
    return corners, sides[:rng.randrange(1, 3)]


@on_one
def triangle_of_a_larger_one(corners, sides, rng):
    if len(corners) < 4:
        return None
    return corners[:3], [[*sides[0][:4], 1], [*sides[1][:4], 2], [*sides[-1][:4], 0]]


@on_one
def one_corner_for_all(corners, sides, rng):
    return ([rng.choice(corners)], moved(sides, lambda k: 0)) if len(corners) > 1 else None


def on_rate(change):
    def forged(parts, rng):
        if not parts.rows.get("rates"):
            return None
        parts = parts.copy()
        row = rng.choice(parts.rows["rates"])
        row[:] = map(str, change(row, rng) or row)
        return parts.text()

    forged.__name__ = change.__name__
    return forged


@on_rate
def sign_of_a_rate(row, rng):
    return [*row[:6], rng.choice([x for x in (-1, 0, 1, 2, -2) if x != int(row[6])]), row[7]]


@on_rate
def size_of_a_rate(row, rng):
    root = Fraction(row[7])
    return [*row[:7], rng.choice([root * 2 + 1, root + Fraction(1, 10**20), -root - 1])]


def rate_of_some_directions(parts, rng):
    """The optima that are proved become some; or a rate of rest, which is true, is added where the optima are not all proved."""
    parts = parts.copy()
    if parts.which == "all":
        parts.which = "some"
    elif parts.claim[0] == "apart" or "halfspace_a" in parts.rows or "halfspace_b" in parts.rows:
        return None
    parts.rows.setdefault("rates", []).append(["0"] * 8)
    return parts.text()


# What may say the same.

@on_one
def index_changed(corners, sides, rng):
    words = rng.choice([words for corner in corners for words in corner if words])
    words[rng.randrange(0, len(words), 2)] = str(rng.randrange(12))
    return corners, sides


@on_one
def ends_exchanged(corners, sides, rng):
    return [corner[::-1] for corner in corners], sides


@on_one
def weight_in_two(corners, sides, rng):
    words = rng.choice([words for corner in corners for words in corner if words])
    words[1] = str(Fraction(words[1]) / 2)
    words += words[:2]
    return corners, sides


@on_side
def letter_of_a_side(side, corners, rng):
    return ["ab"[side[0] == "a"], *side[1:]]


@on_side
def side_changed(side, corners, rng):
    return [side[0], *(int(x) + rng.randint(-1, 1) for x in side[1:4]), side[4]]


@on_side
def side_longer(side, corners, rng):
    return [side[0], *(int(x) * 3**40 for x in side[1:4]), side[4]]


@on_one
def side_gone(corners, sides, rng):
    del sides[rng.randrange(len(sides))]
    return corners, sides


@on_one
def side_twice(corners, sides, rng):
    k = rng.randrange(len(sides))
    return corners, sides[:k] + [sides[k]] + sides[k:]


@on_one
def sides_from_another_one_on(corners, sides, rng):
    return corners, sides[1:] + sides[:1]


@on_one
def sides_twice_round(corners, sides, rng):
    return corners, sides * 2


@on_one
def corners_renamed(corners, sides, rng):
    n = len(corners)
    return corners[1:] + corners[:1], moved(sides, lambda k: (k - 1) % n)


NEVER = (no_patches, patch_gone, patch_twice, patches_exchanged, no_corners, no_sides, corner_gone, corner_gone_with_its_sides,
         corner_twice, all_twice, middle_for_a_corner, middle_more, corners_in_another_order, weight_changed, negative_weight,
         index_too_large, weights_of_one_body, side_turned_round, side_zero, side_of_another_corner, sides_reversed, two_sides,
         triangle_of_a_larger_one, one_corner_for_all, sign_of_a_rate, size_of_a_rate, rate_of_some_directions)
MAYBE = (index_changed, ends_exchanged, weight_in_two, letter_of_a_side, side_changed, side_longer, side_gone, side_twice,
         sides_from_another_one_on, sides_twice_round, corners_renamed)
