#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random pairs of bodies of the plane: each answer carries its proof, all checkers accept it with that answer, and what they print is
true by definition."""
import json
import pathlib
import random
import sys
import tempfile
import unittest

from pairs import CHECKERS, ROOT, accepted_answers, run

sys.path.insert(0, str(ROOT / "tests" / "check"))
import plane_forgeries  # noqa: E402

COUNT = 240


def points(rng, count, size=5):
    """Of which some three do not lie on a line, if there are three or more."""
    while True:
        found = [[rng.randint(-size, size), rng.randint(-size, size)] for _ in range(count)]
        if count < 3 or any(plane_forgeries.cross(plane_forgeries.sub(p, found[0]), plane_forgeries.sub(q, found[0]))
                            for p in found for q in found):
            return found


def body(rng, kind):
    if kind == "pieces":
        return {"pieces": [points(rng, 3) for _ in range(rng.randint(1, 3))]}
    if kind == "halfplane":
        return {"shape": "halfplane", "normal": rng.choice([[1, 0], [0, -2], [3, 4], [-1, 2]]), "offset": rng.randint(-6, 6)}
    if kind == "circle":
        x, y = points(rng, 1)[0]
        return {"shape": "circle", "radius": rng.randint(1, 5), "pose": [[1, 0, x], [0, 1, y]]}
    found = {"vertices": points(rng, rng.randint(1, 6))}
    if kind == "rounded":
        found["margin"] = rng.choice([1, 2, "1/3"])
    if rng.randrange(3) == 0:
        found["pose"] = {"half_angle": rng.choice(["1/2", "-1/3", "2/7"]), "translation": points(rng, 1)[0]}
    return found


def cases(rng):
    kinds = [("polygon", "polygon"), ("polygon", "rounded"), ("rounded", "circle"), ("circle", "circle"), ("polygon", "halfplane"),
             ("halfplane", "rounded"), ("pieces", "polygon"), ("pieces", "pieces")]
    for k in range(COUNT):
        of_a, of_b = kinds[k % len(kinds)]
        a, b = body(rng, of_a), body(rng, of_b)
        if "pieces" in a and "vertices" in b:
            b = {"vertices": points(rng, 4)}
        yield {"id": f"pair{k}", "dimension": 2, "a": a, "b": b}


class PlanePairs(unittest.TestCase):
    maxDiff = None

    def test_all_checkers_accept_the_answers(self):
        texts = [json.dumps(case) + "\n" for case in cases(random.Random(5))]
        results = accepted_answers(self, "".join(texts))
        self.assertEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in results})
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "certificates")
            path.write_text("".join(result["certificate"] for result in results))
            lines = run(*CHECKERS["fathom-check"], path).splitlines()
        self.assertEqual(len(lines), COUNT)
        for line, result in zip(lines, results):
            said, certificate = line[len("s VERIFIED "):].rsplit(" ", 1)[0], result["certificate"]
            self.assertIn("\nplane ", certificate)
            self.assertTrue(plane_forgeries.is_true(said, certificate), (line, certificate))


if __name__ == "__main__":
    unittest.main()
