#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The limits of verify/check/FORMAT.md, section 8: what just keeps one is not malformed to any checker, what just passes it is malformed to
all, on the same line. (The limit on all bytes of a certificate is left out: it takes a gigabyte.)

limits.py COMMAND..   each a checker that takes certificates on standard input as -
"""
import re
import shlex
import subprocess
import sys

POINT = "0 0 0"


def certificate(a=(POINT,), b=("1 0 0",), claim="disjoint", which="some", directions=("-1 0 0",), parts=(("", ()), ("", ())), comment=""):
    """Its lines; parts: the names and the lines of what follows the directions."""
    lines = ["fathom-certificate 1", *([comment] if comment else []), f"a {len(a)}", *a, f"b {len(b)}", *b, f"claim {claim}",
             f"directions {len(directions)} {which}", *directions]
    for name, rows in parts:
        lines += [f"{name} {len(rows)}", *rows] if name else []
    return lines + ["end " + " ".join(str(len(rows)) for rows in (a, b, directions, *(rows for _, rows in parts)))]


def inner(vertices, facets):
    return (("vertices", vertices), ("facets", facets))


def weights(a, b):
    return (("weights_a", a), ("weights_b", b))


# ---- the formulas of the page ----
def cost(s, t):
    return (256 + max(s, t)) * (256 + min(s, t, 4000))


def work(n, k, t=0, f=0, weight=0, w=1, x=1, u=1, z=0):
    return n * k * cost(w, u) + (n + 4 * t) * cost(w, w) + 4 * (k + f) * cost(w, z) + 4 * weight * cost(w + x, w + x)


def largest(grows, limit):
    """The largest n with grows(n) <= limit."""
    low, high = 1, 1 << 40
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if grows(middle) <= limit else (low, middle - 1)
    return low


def digits():
    """A number of many digits in every place: the kept certificate, the passed one, and the line of the fault."""
    for number in (100_000, 100_001):
        long = "0" * (number - 1)
        fault = number > 100_000
        yield certificate(a=(f"0 -{long}0 0",)), 3 if fault else None
        yield certificate(a=(f"0 0 1/{long}7",)), 3 if fault else None
        yield certificate(directions=(f"-{long}1 0 0",)), 8 if fault else None
        yield certificate(claim=f"depth {long}1", parts=inner((f"{long}0 0",), (f"3 0 0 {long}0",))), 6 if fault else None
        yield certificate(claim="depth 1", parts=inner((f"{long}0 0",), ())), 10 if fault else None
        yield certificate(claim="depth 1", parts=inner((), (f"{long}1 0",))), 11 if fault else None
        yield certificate(claim="touching", parts=weights(("0 1",), (f"0 {long}1/2",))), 12 if fault else None
        counted = certificate()
        counted[1] = f"a {long}1"
        yield counted, 2 if fault else None
        counted = certificate()
        counted[-1] = counted[-1][:-1] + long + "0"
        yield counted, 9 if fault else None


def lines():
    for length in (1 << 24, (1 << 24) + 1):
        fault = length > 1 << 24
        yield certificate(comment="#" * length), 2 if fault else None
        yield certificate(comment="id " + "x" * (length - 3)), 2 if fault else None


def numbers():
    """4 for a facet of three corners, and more: 9,999,993 without the last row."""
    facets = ("3 0 0 0",) * 2_499_996
    end = len(facets) + 10  # the line of the last of them, without vertices
    for last, fault in (("6 0 0 0 0 0 0", None), ("7 0 0 0 0 0 0 0", end + 1)):
        yield certificate(claim="depth 1", parts=inner((), (*facets, last))), fault
    for vertices, fault in ((3, None), (4, end + 4)):
        yield certificate(claim="depth 1", parts=inner(("0 0",) * vertices, facets)), fault


def sizes():
    """12,500 vectors of 320,000 digits: points over a long denominator; points, vertices and facets; weights."""
    long = 1 << 319_998  # of 319,999 digits, and 1 for the denominator
    for p, fault in ((long, False), (2 * long, True)):
        yield certificate(a=(f"{p} 0 0", *(POINT,) * 12_498)), 12_507 if fault else None
        yield certificate(a=(f"0 1/{p} 0", *(POINT,) * 12_498), b=(POINT,)), 12_507 if fault else None
    for facets, fault in ((100, None), (101, 12_310)):
        yield certificate(a=(f"{long} 0 0", *(POINT,) * 5_998), claim="depth 1",
                          parts=inner(("0 0",) * 6_200, ("3 0 0 0",) * facets)), fault
    odd = (1 << 319_995) + 1  # 319,996 digits, and 3 for the denominator
    for count, fault in ((12_500, None), (12_501, 12_512)):
        yield certificate(claim="touching", parts=weights((f"0 {odd}",), (f"0 {odd}/4", *("0 1",) * (count - 2)))), fault


def works():
    limit = 100_000_000_000_000
    n = largest(lambda k: work(n=k + 1, k=k, w=2), limit)
    for more, fault in ((0, None), (1, 2 * n + 8)):
        yield certificate(a=(POINT,) * (n + more), directions=("-1 0 0",) * n), fault
    k = largest(lambda k: work(n=2, k=1, t=k * k, f=1, w=2, z=1), limit)
    for corners in (k, k + 1):
        yield certificate(claim="depth 1", parts=inner(("0 0",), (f"{corners}" + " 0" * corners,))), 13 if corners > k else None
    p = 1 << 79_998  # w = 80,000
    k = largest(lambda k: work(n=2, k=k, w=80_000, z=40_000), limit)
    for count in (k, k + 1):
        yield (certificate(a=(f"{p} 0 0",), claim=f"depth {1 << 39_999}", directions=("1 0 0",) * count, parts=inner((), ())),
               count + 10 if count > k else None)
    count = largest(lambda n: work(n=2, k=1, weight=n, w=80_000, x=2), limit)
    for total in (count, count + 1):
        yield certificate(a=(f"{p} 0 0",), claim="touching", parts=weights(("0 1",), ("0 1",) * (total - 1))), total + 11 if total > count else None


VERDICT = re.compile(r"s (VERIFIED|REFUSED|MALFORMED) .*?(?::(\d+): .*)?")


def verdict(command, text):
    done = subprocess.run([*shlex.split(command), "-"], input=text, stdout=subprocess.PIPE)
    first = done.stdout.decode(errors="replace").partition("\n")[0]
    match = VERDICT.fullmatch(first)
    if not match:
        return f"no verdict but {first[:200]!r}"
    return f"MALFORMED in line {match[2]}" if match[1] == "MALFORMED" else "not malformed"


def main():
    sys.set_int_max_str_digits(0)
    bad = False
    for family in (digits, lines, sizes, works, numbers):
        for index, (rows, line) in enumerate(family()):
            text = ("\n".join(rows) + "\n").encode()
            expected = f"MALFORMED in line {line}" if line else "not malformed"
            for command in sys.argv[1:]:
                got = verdict(command, text)
                if got != expected:
                    bad = True
                    print(f"{family.__name__} {index}: expected {expected}, but {command} says {got}")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
