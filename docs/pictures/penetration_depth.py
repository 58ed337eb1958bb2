#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what penetration depth is; prints an SVG.

    docs/pictures/penetration_depth.py build/release/fathom > docs/pictures/penetration_depth.svg

Left, two bodies and the shortest translation that separates them; right, the Minkowski sum P of B and -A. The bodies are prisms so long
that no shorter way out leads along them, drawn as their bases. Every number in the picture is fathom's answer.
"""
from fractions import Fraction
import json
import subprocess
import sys

A = [(0, 0), (3, -1), (6, 1), (6, 4), (2, 5), (-1, 3)]
B = [(4, 1), (6, -1), (10, 0), (11, 4), (7, 7), (5, 5)]
UNIT = 20  # pixels
WIDTH, HEIGHT = 800, 330
STYLE = """
  text { font: 15px sans-serif; fill: #222 }
  .name { font: italic 20px serif }
  .a { fill: #2f6fb0; fill-opacity: .25; stroke: #2f6fb0; stroke-width: 2 }
  .moved { fill: none; stroke: #2f6fb0; stroke-width: 1.5; stroke-dasharray: 5 4 }
  .b { fill: #d07a1e; fill-opacity: .25; stroke: #d07a1e; stroke-width: 2 }
  .p { fill: #3a8a4a; fill-opacity: .15; stroke: #3a8a4a; stroke-width: 2 }
  .ball { fill: none; stroke: #666; stroke-dasharray: 3 3 }
  .t { stroke: #b02020; stroke-width: 2.5 }
  .head, .dot { fill: #b02020 }"""


def solve(fathom):
    """fathom's answer about the two prisms."""
    vertices = lambda base: [[x, y, z] for z in (-99, 99) for x, y in base]
    case = {"schema": "fathom/case/1", "a": {"vertices": vertices(A)}, "b": {"vertices": vertices(B)}}
    done = subprocess.run([fathom, "depth", "--json", "-"], input=json.dumps(case), capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def hull(points):
    """The corners of a planar hull, counter-clockwise."""
    def half(points):
        chain = []
        for r in points:
            while len(chain) > 1:
                (px, py), (qx, qy) = chain[-2:]
                if (qx - px) * (r[1] - py) > (qy - py) * (r[0] - px):
                    break
                chain.pop()
            chain.append(r)
        return chain[:-1]
    points = sorted(set(points))
    return half(points) + half(points[::-1])


class Panel:
    """Maps the plane to the page, with y upwards."""
    def __init__(self, x, y):
        self.x, self.y = x, y

    def place(self, p):
        return f"{float(self.x + UNIT * p[0]):.1f}", f"{float(self.y - UNIT * p[1]):.1f}"

    def polygon(self, kind, corners):
        return f'<polygon class="{kind}" points="{" ".join(",".join(self.place(p)) for p in corners)}"/>'

    def dot(self, p):
        x, y = self.place(p)
        return f'<circle class="dot" cx="{x}" cy="{y}" r="4"/>'

    def arrow(self, p, t):
        (x, y), (u, v) = self.place(p), self.place((p[0] + t[0], p[1] + t[1]))
        return f'<line class="t" x1="{x}" y1="{y}" x2="{u}" y2="{v}" marker-end="url(#head)"/>'

    def text(self, p, words, kind=""):
        x, y = self.place(p)
        return f'<text{kind and f" class={chr(34)}{kind}{chr(34)}"} x="{x}" y="{y}">{words}</text>'


def picture(result):
    t = [Fraction(value) for value in result["translation"]]
    squared = Fraction(result["depth"]["squared"])
    assert t[2] == 0 and t[0] ** 2 + t[1] ** 2 == squared
    sum_ = hull([(b[0] - a[0], b[1] - a[1]) for a in A for b in B])
    witness = [Fraction(value) for value in result["witness"]["a"]]
    left, right = Panel(90, 215), Panel(500, 175)
    lines = [
        left.polygon("b", B), left.polygon("a", A), left.polygon("moved", [(x + t[0], y + t[1]) for x, y in A]),
        left.arrow(witness, t), left.text((.8, 1.8), "A", "name"), left.text((9, 2.7), "B", "name"),
        left.text((-2.9, 5.6), "A + t", "name"), left.text((-1.6, -5.1), "the shortest t that separates A + t from B"),
        right.polygon("p", sum_), f'<circle class="ball" cx="{right.x}" cy="{right.y}" r="{UNIT * float(squared) ** .5:.1f}"/>',
        right.arrow((0, 0), t), right.dot((0, 0)), right.text((.4, -.7), "O", "name"), right.text((3.6, 2), "P = B ⊕ (−A)", "name"),
        right.text((-2, -7.1), f"|t|² = {squared}: the nearest facet of P, exactly"),
    ]
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}">',
        "<title>Penetration depth: two overlapping bodies, and the origin in their Minkowski sum</title>", f"<style>{STYLE}\n</style>",
        '<marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="5" markerHeight="5" orient="auto">'
        '<path class="head" d="M0 0 8 4 0 8z"/></marker>',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>', *lines, "</svg>"])


if __name__ == "__main__":
    print(picture(solve(sys.argv[1])))
