# SPDX-License-Identifier: GPL-3.0-or-later
"""fathom cases: every family and the catalogue feed depth. Options, numbers, and cases from meshes: transcripts/cases.md."""
import fractions
import json
import subprocess
import sys
import unittest

from harness import EXECUTABLE, PATIENCE, ROOT, CliTest



class CasesTest(CliTest):
    def cases(self, *arguments):
        return [json.loads(line) for line in self.answer("cases", *arguments).splitlines()]

    def families(self, *options):
        return [line.split()[0] for line in self.answer("cases", "--list", *options).splitlines()]

    def depths(self, lines):
        return [json.loads(line) for line in self.answer("depth", "--json", "-", stdin=lines).splitlines()]


class Families(CasesTest):
    def test_list(self):
        lines = self.answer("cases", "--list").splitlines()
        self.assertGreater(len(lines), 60)
        for line in lines:
            self.assertRegex(line, r"^[a-z0-9_]+  +\S")
        self.assertTrue({"catalogue", "approaching", "degraded_shared_vertex", "random_ball"} <= set(self.families()))

    def test_every_family_feeds_depth(self):
        lines = self.answer("cases", "--family", "all", "--count", 3 * len(self.families()), "--size", 7)
        cases, results = [json.loads(line) for line in lines.splitlines()], self.depths(lines)
        self.assertEqual(len(cases), 3 * len(self.families()))
        self.assertEqual([case["id"] for case in cases], [result["id"] for result in results])
        self.assertEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in results})
        naive = self.answer("depth", "--json", "--method", "naive", "-", stdin=lines).splitlines()
        for case, result, twin in zip(cases, results, naive):
            self.assertEqual(result["depth"], json.loads(twin)["depth"], case["id"])

    def test_all_families_in_turn(self):
        names = self.families()
        self.assertNotIn("all", names)
        cases = self.cases("--family", "all", "--count", 2 * len(names) + 1, "--seed", 5, "--size", 6)
        self.assertEqual([case["source"]["family"] for case in cases], names + names + names[:1])
        self.assertEqual([case["source"]["seed"] for case in cases], ["5"] * len(names) + ["6"] * len(names) + ["7"])
        self.assertEqual(len({case["id"] for case in cases}), len(cases))
        for case in cases[::20]:
            self.assertEqual(self.cases("--family", case["source"]["family"], "--seed", case["source"]["seed"], "--size", 6), [case])
        usual, = self.cases("--family", "all")
        self.assertEqual(self.cases("--family", names[0]), [usual])

    def test_numbers_are_exact_for_every_reader(self):
        """What a program in doubles reads is the coordinate itself: a number when it is one, a string when it is not."""
        kinds = set()
        for family in ("random_ball", "boxes_posed", "wild_coordinates", "catalogue"):
            for case in self.cases("--family", family, "--count", 20):
                for x in (x for body in "ab" for vertex in case[body]["vertices"] for x in vertex):
                    kinds.add(type(x))
                    if isinstance(x, str):
                        exact = fractions.Fraction(x)
                        self.assertTrue(abs(exact) > 1e308 or fractions.Fraction(float(exact)) != exact, x)
        self.assertEqual(kinds, {int, float, str})

    def test_endless_output_ends_with_its_reader(self):
        with subprocess.Popen([EXECUTABLE, "cases", "--family", "point_point", "--count", "1000000000"], stdout=subprocess.PIPE) as process:
            self.assertIn("point_point-n6-s1", process.stdout.readline().decode())
            process.stdout.close()
            self.assertNotEqual(process.wait(PATIENCE), 0)


class Shapes(CasesTest):
    def test_families_are_a_kind_of_their_own(self):
        names = self.families("--shapes")
        self.assertGreater(len(names), 40)
        self.assertTrue({"capsules", "cylinder_box", "inverse_rim_on_face"} <= set(names))
        self.assertFalse(set(names) & set(self.families()))
        cases = self.cases("--family", "all", "--shapes", "--count", 2 * len(names), "--seed", 5)
        self.assertEqual([case["source"]["family"] for case in cases], names + names)
        for case in cases:
            self.assertEqual("signed_depth" in case["source"], case["source"]["family"].startswith("inverse_"))
        self.assertEqual(self.cases("--family", names[3], "--seed", 6), [cases[len(names) + 3]])

    def test_they_are_answered(self):
        lines = self.answer("cases", "--family", "all", "--shapes", "--count", 150)
        results = self.depths(lines)
        self.assertEqual([json.loads(line)["id"] for line in lines.splitlines()], [result["id"] for result in results])
        self.assertTrue({"penetrating", "touching", "disjoint"} <= {result["status"] for result in results})

    def test_numbers_of_random_families_are_doubles(self):
        for family in ("capsules", "cylinder_box", "ellipsoids", "shapes_halfspace", "sums", "shapes_stretched"):
            self.assertNotIn('/', self.answer("cases", "--family", family, "--count", 30).replace("fathom/case/1", ""), family)

    def test_catalogue(self):
        lines = self.answer("cases", "--catalogue", "--shapes")
        cases = [json.loads(line) for line in lines.splitlines()]
        found = {result["id"]: result for result in self.depths(lines)}
        self.assertGreaterEqual(len(cases), 80)
        for case in cases:
            self.assertTrue(case["comment"])
            if case["source"]["signed_depth"].count("sqrt") == 0:
                known, bounds = fractions.Fraction(case["source"]["signed_depth"]), found[case["id"]]["signed_depth"]
                self.assertTrue(bounds["low"] <= known <= bounds["high"], case["id"])
        ulp_deep, = (case for case in cases if case["id"] == "spheres_one_ulp_deep")
        self.assertEqual(ulp_deep["a"]["radius"], 2 + 2**-51)
        self.assertEqual(ulp_deep["source"]["signed_depth"], f"{5 * 2**51 + 1}/{2**51} - sqrt(25)")


class Unions(CasesTest):
    def test_families_are_a_kind_of_their_own(self):
        names = self.families("--unions")
        self.assertGreater(len(names), 15)
        self.assertTrue({"cut_cones", "slots_narrow", "rings_linked"} <= set(names))
        self.assertFalse(set(names) & (set(self.families()) | set(self.families("--shapes"))))
        cases = self.cases("--family", "all", "--unions", "--count", 2 * len(names), "--seed", 5, "--size", 4)
        self.assertEqual([case["source"]["family"] for case in cases], names + names)
        for case in cases:
            self.assertTrue(case["a"]["pieces"] and case["b"]["pieces"])
        self.assertEqual(self.cases("--family", names[3], "--seed", 6, "--size", 4), [cases[len(names) + 3]])

    def test_they_are_answered_with_proofs(self):
        lines = self.answer("cases", "--family", "all", "--unions", "--count", 60, "--size", 4)
        results = self.answer("depth", "--json", "--embed-certificate", "-", stdin=lines)
        found = [json.loads(line) for line in results.splitlines()]
        self.assertEqual([json.loads(line)["id"] for line in lines.splitlines()], [result["id"] for result in found])
        self.assertEqual({"penetrating", "touching", "disjoint"}, {result["status"] for result in found})
        self.assertEqual(self.answer("check", "--results", self.file("results.jsonl", results)).count("s VERIFIED "), len(found))

    def test_catalogue(self):
        lines = self.answer("cases", "--catalogue", "--unions")
        found = {result["id"]: result for result in self.depths(lines)}
        cases = [json.loads(line) for line in lines.splitlines()]
        self.assertGreaterEqual(len(cases), 30)
        for case in cases:
            result, known = found[case["id"]], case["source"]
            squared = result["apart"]["distance"]["squared"] if "distance_squared" in known else result["depth"]["squared"]
            self.assertEqual(squared, known.get("distance_squared", known.get("depth_squared")), case["id"])
            self.assertEqual("distance_squared" in known, result["status"] == "disjoint", case["id"])
        proofs = self.folder / "proofs"
        self.answer("depth", "--certificate", proofs, self.file("catalogue.jsonl", lines))
        reader = subprocess.run([sys.executable, "-B", ROOT / "verify" / "check" / "check.py", *sorted(proofs.glob("*.cert"))],
                                stdout=subprocess.PIPE, timeout=PATIENCE, check=True)
        self.assertEqual(reader.stdout.count(b"s VERIFIED "), len(cases))


class SmallWorld(CasesTest):
    LAST = 6463187

    def test_three_checkers_accept_a_slice(self):
        lines = "".join(self.answer("cases", "--small-world", first, "--count", 4) for first in range(0, self.LAST, 307_770))
        cases = [json.loads(line) for line in lines.splitlines()]
        self.assertEqual({point for case in cases for body in "ab" for vertex in case[body]["vertices"] for point in vertex}, {0, 1, 2})
        proofs = self.folder / "proofs"
        self.answer("depth", "--certificate", proofs, self.file("small.jsonl", lines))
        certificates = sorted(proofs.glob("*.cert"))
        self.assertEqual(len(certificates), len(cases))
        reader = subprocess.run([sys.executable, "-B", ROOT / "verify" / "check" / "check.py", *certificates], stdout=subprocess.PIPE,
                                timeout=PATIENCE, check=True)
        self.assertEqual(reader.stdout.count(b"s VERIFIED "), len(cases))
        self.assertEqual(self.answer("check", *certificates).count("s VERIFIED "), len(cases))

    def test_numbers_and_kinds(self):
        first, = self.cases("--small-world", 3)
        self.assertEqual(first["id"], "small_world::3")
        self.assertEqual(first["source"]["small_world"], "3")
        words = first["source"]["kinds"].split()
        self.assertEqual(words[0], "touching_face_face")
        self.assertIn("flat_a", words)
        last = self.cases("--small-world", self.LAST, "--count", 5)
        self.assertEqual([case["id"] for case in last], [f"small_world::{self.LAST}"])


class Catalogue(CasesTest):
    def test_all_entries(self):
        lines = self.answer("cases", "--catalogue")
        cases, results = [json.loads(line) for line in lines.splitlines()], self.depths(lines)
        self.assertGreaterEqual(len(cases), 40)
        self.assertEqual(len({case["id"] for case in cases}), len(cases))
        found = {result["id"]: result for result in results}
        for case in cases:
            self.assertTrue(case["comment"])
            if case["id"].startswith("touching_"):
                self.assertEqual(found[case["id"]]["status"], "touching")
        for kind in ("facet-vertex", "vertex-facet", "facet-edge", "edge-facet", "facet-facet", "edge-edge"):
            self.assertEqual(found["contact_" + kind.replace("-", "_")]["contact"]["kind"], kind)
        self.assertEqual(found["nearly_touching_deep"]["depth"]["squared"], f"1/{2**2000}")


if __name__ == "__main__":
    unittest.main()
