# SPDX-License-Identifier: GPL-3.0-or-later
"""The facets that the adapters' tests hand out: right on solids with known facets, and lawful on all real cases."""
import collections
import json
import pathlib
import unittest

import hull

DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
CUBE = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]


def laws_broken(points, rings):
    """Every edge has two facets, which run along it in opposite ways; Euler's formula; no point in front of a facet."""
    points = hull.integers(points)
    edges = collections.Counter((ring[k - 1], ring[k]) for ring in rings for k in range(len(ring)))
    broken = [edge for edge, count in edges.items() if count != 1 or edges[edge[::-1]] != 1]
    corners = {corner for ring in rings for corner in ring}
    if len(corners) - len(edges) // 2 + len(rings) != 2:
        broken.append("Euler")
    for ring in rings:
        normal = hull.cross(hull.minus(points[ring[1]], points[ring[0]]), hull.minus(points[ring[2]], points[ring[0]]))
        if any(hull.dot(normal, hull.minus(point, points[ring[0]])) > 0 for point in points):
            broken.append(ring)
    return broken


class Facets(unittest.TestCase):
    def test_cube(self):
        more = CUBE + [[0.5, 0.5, 1], [0.5, 0.5, 0.5], [0, 0, 0], [0, 0, 0.5]]  # in a facet, inside, twice, in an edge
        for points in (CUBE, more):
            rings = hull.facets(points)
            self.assertEqual(sorted(map(len, rings)), [4] * 6)
            self.assertEqual({corner for ring in rings for corner in ring}, set(range(8)))
            self.assertEqual(laws_broken(points, rings), [])
        self.assertNotEqual(laws_broken(CUBE, [ring[::-1] for ring in rings]), [])
        self.assertNotEqual(laws_broken(CUBE, rings[1:]), [])

    def test_flat(self):
        for points in ([[1, 2, 3]], CUBE[:2], CUBE[:3], CUBE[:4], [[x, x, 0] for x in range(5)]):
            self.assertEqual(hull.facets(points), [])

    def test_real_cases(self):
        with open(DATA / "real_cases.jsonl", encoding="utf-8") as lines:
            for case in map(json.loads, lines):
                for body in "ab":
                    points = case[body]["vertices"]
                    rings = hull.facets(points)
                    with self.subTest(case["id"], body=body):
                        self.assertEqual(laws_broken(points, rings) if len(points) > 3 else rings, [])


if __name__ == "__main__":
    unittest.main()
