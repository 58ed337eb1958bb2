#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the worst cases, one small file for each class of error, from the places in this project where their bodies are: what is picked,
and what each shows, is the table below; the answers are fathom's. `verify/survey/survey.py --sets worst` then asks every library about
them, and `verify/survey/tables.py` makes the table of README.md.

make.py            writes the files NAME.json beside this program, and removes others
make.py --check    writes nothing; exit code 1, and names, if one is not what it would write
make.py --lines    prints them as JSON Lines, as they are
"""
import argparse
import dataclasses
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
REAL, SHAPES = "tests/data/real_cases.jsonl", "tests/data/real_shapes.jsonl"
REPORTS, CLAIMS, CATALOGUE = "tests/data/report_cases.jsonl", "verify/claims/claims.jsonl", "fathom cases --catalogue"
MUJOCO_BOXES = "google-deepmind/mujoco@a7255075b, test/engine/engine_collision_box_test.cc"


@dataclasses.dataclass
class Pick:
    name: str
    shows: str
    place: str       # where the bodies are: a file, or a command
    case: str        # the id there
    source: str      # who found it: a project and number or file, or a page of this project
    stated: str = ""  # what goes wrong, in which library, as the source says


def own(name, folder, shows, stated):
    """One of the project's own reports."""
    return Pick(name, shows, f"verify/reports/{folder}/case.json", folder, f"verify/reports/{folder}/README.md", stated)


PICKS = [
    own("half-overlap", "mujoco-half-overlap", "cubes that overlap by half",
        "MuJoCo 3.12.0 to 3.14.0 find no contact between the meshes"),
    own("same-place", "physx-same-place", "a body and its equal at the same place",
        "PhysX 5.6.1 answers 0.577 along a diagonal where 1 along an axis is right"),
    own("same-centre", "mujoco-same-centre", "a small body in the middle of a large one",
        "MuJoCo 3.3.8 to 3.14.0 find no contact between the meshes"),
    Pick("common-faces", "a body inside another, five faces in common", REPORTS, "report::fcl-628", "flexible-collision-library/fcl#628",
         "the depth is 1, or 0, for 0.2"),
    Pick("three-way-tie", "a corner in a corner: three ways out are equally short", SHAPES, "real::drake-1668",
         "RobotLocomotion/drake#1668", "FCL has 20 contacts of depth 1 between the meshes, with normals along all three axes"),
    Pick("whole-face", "cubes that touch in a whole face", REAL, "real::fcl-503", "flexible-collision-library/fcl#503",
         "depths of 0.33, 1.03, 1.84 between meshes that only touch"),
    Pick("one-ulp", "corners that overlap by one unit in the last place", REPORTS, "report::coal-325-ulp-in-all",
         "coal-library/coal#325"),
    Pick("thin-plates", "plates at an angle, the overlap thinner than either", CLAIMS, "mujoco-box-ThinBoxShallowPenetration",
         f"{MUJOCO_BOXES} ThinBoxShallowPenetration"),
    Pick("needle", "a ball on a triangle of 50 m by 2 m", REPORTS, "report::newton-sliver-needle",
         "newton-physics/newton@41a5392c, newton/tests/test_narrow_phase.py"),
    Pick("far-from-origin", "hulls thousands of metres from the origin", REPORTS, "report::jolt-hull-bank-far-thin",
         "jrouwe/JoltPhysics, Assets/convex_hulls.bin", "hulls of games, collected as a regression test"),
    Pick("small-on-huge", "a capsule on a ball of 50 m, 0.1 mm deep", REPORTS, "report::godot-70615-0.1mm", "godotengine/godot#70615",
         "the normal of the contact jitters"),
    Pick("tiny-sliver", "a triangle of millimetres with hardly any area", REAL, "real::jolt-41-tiny-triangle", "jrouwe/JoltPhysics#41",
         "an assertion fails: a vector is nearly zero"),
    Pick("underflow", "a body of 1e-23, whose squares are no numbers of binary32", REPORTS, "report::parry-49-self", "dimforge/parry#49",
         "the builder of hulls panics"),
    Pick("coplanar-faces", "walls that overlap along one axis, all other faces coplanar", REPORTS, "report::ifcopenshell-4594-aligned",
         "IfcOpenShell/IfcOpenShell#4594", "no clash is found; moved by 2 mm sideways it is"),
    Pick("nearly-aligned", "boxes turned by 0.01 against each other", CLAIMS, "mujoco-box-NearAligned-1e-2",
         f"{MUJOCO_BOXES} NearAlignedManifoldIsExact"),
    own("crossing-edges", "mujoco-multiccd-normal", "the shortest way out is across two edges",
        "MuJoCo 3.12.0 to 3.14.0 turn the normal to that of a face"),
    Pick("nearly-parallel-edges", "two segments, nearly parallel in projection, 5e-7 apart", REPORTS, "report::ipc-slow1-level",
         "ipc-sim/ipc-toolkit, tests/src/tests/ccd/test_edge_edge_ccd.cpp", "the slow case of a continuous test"),
    Pick("repeated-points", "every point given twice and more", CATALOGUE, "duplicate_points_both",
         "verify/families/catalogue.cpp"),
    Pick("flat-triangles", "two triangles, a corner of one on the other", REAL, "real::parry-253-triangles", "dimforge/parry#253",
         "the expanding polytope panics"),
    own("deep-balls", "libccd-spheres", "two balls, deeper than a radius", "libccd 2.1 answers the depth 0"),
    Pick("crossed-capsules", "capsules whose axes cross", CLAIMS, "genesis-capsules-perpendicular_center",
         "Genesis-Embodied-AI/Genesis, tests/test_rigid_physics_analytical_vs_gjk.py",
         "the test allows the two methods to differ by 10 %"),
    Pick("cylinder-rim", "the rim of a cylinder in the end of another", CLAIMS, "drake-char-Cylinder-Cylinder-cap-rim",
         "RobotLocomotion/drake@be259df7, geometry/proximity/test/characterization_utilities.cc",
         "a worst error of 2 mm is documented, as large as the depth"),
    Pick("ellipsoids", "two ellipsoids, 0.2 mm deep", CLAIMS, "mujoco-gjk-EllipsoidEllipsoidPenetrating",
         "google-deepmind/mujoco@a7255075b, test/engine/engine_collision_gjk_test.cc EllipsoidEllipsoidPenetrating"),
    own("sunk-pyramid", "cannon-pyramid", "a pyramid that has sunk through a slab by less than half",
        "cannon-es 0.20.0 pushes it down, the longer way"),
    own("abort", "fcl-abort", "tetrahedra, deep across two edges", "FCL 0.7.0 ends the process: an assertion fails"),
    Pick("seam", "a plate in the seam of two pieces: the union is deeper than any pair", REPORTS, "report::mujoco-436-seam",
         "google-deepmind/mujoco#436", "a rope goes through between the hulls of a vessel"),
]


def found_in(place, fathom):
    """Returns {id: case} of a file, or of what a command prints."""
    if place.startswith("fathom "):
        text = subprocess.run([fathom, *place.split()[1:]], stdout=subprocess.PIPE, check=True, text=True).stdout
    else:
        text = (ROOT / place).read_text(encoding="utf-8")
    return {case["id"]: case for case in map(json.loads, filter(str.strip, text.splitlines()))}


def answer_of(result):
    """Returns what of a result decides, exact as far as it is; as in tests/data/report_cases.jsonl. A way whose length is no rational
    number is its direction."""
    ways = [optimum["translation"] if isinstance(optimum["translation"], list) else {"along": optimum["direction"]}
            for optimum in result["optima"]]
    signed = result.get("signed_depth")
    if signed is None:  # a union
        apart = result.get("apart")
        value = result["depth"]["value"] if not apart else -apart["distance"]["value"]
        signed = {"low": value, "high": value}
    return {"status": result["status"], "depth_squared": result["depth"]["squared"], "translations": ways, "signed_depth": signed}


def source_of(pick):
    project, _, number = pick.source.partition("#")
    if number.isdecimal():
        return {"name": pick.source, "url": f"https://github.com/{project}/issues/{number}"}
    return {"name": pick.source}


def laid_out(value, indent=" "):
    """Returns JSON in which what fits into a line stands on one."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(indent) + len(flat) <= 100 or not isinstance(value, (dict, list)):
        return flat
    opening, closing = "{}" if isinstance(value, dict) else "[]"
    parts = [f"{json.dumps(key)}: " + laid_out(each, indent + " ") for key, each in value.items()] if isinstance(value, dict) else [
        laid_out(each, indent + " ") for each in value]
    return opening + "\n" + ",\n".join(indent + part for part in parts) + "\n" + indent[:-1] + closing


def made(fathom):
    """Returns {file: its text}."""
    known, cases = {}, []
    for pick in PICKS:
        if pick.place not in known:
            known[pick.place] = found_in(pick.place, fathom)
        bodies = known[pick.place][pick.case]
        cases.append({"schema": "fathom/case/1", "id": f"worst::{pick.name}", "shows": pick.shows, "source": source_of(pick),
                      **({"stated": pick.stated} if pick.stated else {}), "from": f"{pick.place} {pick.case}",
                      "a": bodies["a"], "b": bodies["b"]})
    stream = "".join(json.dumps(case) + "\n" for case in cases)
    solved = subprocess.run([fathom, "depth", "--json", "-"], input=stream, stdout=subprocess.PIPE, check=True, text=True).stdout
    for case, line in zip(cases, solved.splitlines(), strict=True):
        case["answer"] = answer_of(json.loads(line))
    return {HERE / f"{pick.name}.json": laid_out(case) + "\n" for pick, case in zip(PICKS, cases)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fathom", default=str(ROOT / "fathom"), help="the program; this project's launcher unless given")
    parser.add_argument("--check", action="store_true", help="write nothing; exit code 1, and names, if a file is another")
    parser.add_argument("--lines", action="store_true", help="print the files as they are, a line each")
    options = parser.parse_args()
    there = {path: path.read_text(encoding="utf-8") for path in sorted(HERE.glob("*.json"))}
    if options.lines:
        for text in there.values():
            print(json.dumps(json.loads(text), ensure_ascii=False))
        return 0
    files = made(options.fathom)
    other = [path for path in sorted({*there, *files}) if there.get(path) != files.get(path)]
    for path in other:
        print(f"make: {path.name}", file=sys.stderr)
        if options.check:
            continue
        if path in files:
            path.write_text(files[path], encoding="utf-8")
        else:
            path.unlink()
    return 1 if options.check and other else 0


if __name__ == "__main__":
    sys.exit(main())
