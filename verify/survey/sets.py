# SPDX-License-Identifier: GPL-3.0-or-later
"""The input of the survey: sets of cases, each with the command that makes it, and the settings that are tried besides the defaults."""
import dataclasses
import hashlib
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRIMITIVES = ("spheres", "capsules", "capsule_box", "rounded_boxes", "cylinders", "cones", "ellipsoids")


@dataclasses.dataclass
class Set:
    title: str
    about: str
    count: int = 0         # of generated cases
    size: int = 20         # points a body; 0: as is usual for each family
    kind: str = ""         # of all families: an option of `fathom cases`
    dimension: int = 3     # of the bodies: 2 is put to subjects of the plane, and to no others
    families: tuple = ()   # generated one after another; empty: all in turn
    file: str = ""         # of existing cases
    program: str = ""      # of this folder, with its arguments, that prints the cases
    manifolds: dict = dataclasses.field(default_factory=dict)  # {adapter: KEY=VALUE,...} of those whose contacts are asked for

    @property
    def by_case(self):
        """Returns whether each case, and not each family, is a row of the tables."""
        return not self.count

    def commands(self):
        """Returns the command lines that print the cases."""
        if self.file:
            return [["cat", self.file]]
        if self.program:
            return [self.program.split()]
        each = self.count // len(self.families) if self.families else self.count
        return [["fathom", "cases", "--family", family, *filter(None, [self.kind]), "--count", str(each), *self.of_points(), "--seed", "1"]
                for family in self.families or ("all",)]

    def of_points(self):
        return [] if self.families or not self.size else ["--size", str(self.size)]

    def command(self):
        """Returns the same as text for a shell."""
        lines = self.commands()
        if len(lines) == 1:
            return " ".join(lines[0])
        return f"for f in {' '.join(self.families)}; do {' '.join(lines[0]).replace(self.families[0], '$f', 1)}; done"


SETS = {
    "real": Set("Real cases, as hulls", "Pairs from issue trackers and test suites of such libraries, each body as the hull of its "
                "vertices: a sample of trouble, not of daily use.", file="tests/data/real_cases.jsonl"),
    "shapes": Set("Real cases, as in their reports", "The same pairs as the shapes that the reports are about: 47 are of two boxes, which "
                  "a subject gets as its own boxes; the other 16 are of hulls or meshes, and stay hulls.",
                  file="tests/data/real_shapes.jsonl"),
    "claims": Set("Published claims", "The pairs about which other projects' tests and issues state something, most of them shapes.",
                  file="verify/claims/claims.jsonl"),
    "worst": Set("Worst cases", "One small case for each class of error, picked where libraries go wrong.",
                 program="verify/worst/make.py --lines"),
    "20": Set("All families, 20 points", "Every way for two polytopes to be special that fathom knows, made to find errors.", count=920),
    "200": Set("All families, 200 points", "The same families with larger bodies.", count=184, size=200),
    "primitives": Set("Primitives", "Spheres, capsules, boxes, cylinders, cones and ellipsoids by name, to subjects that have them; many "
                      "pairs are shallow, touching or special by intent.", count=1400, families=PRIMITIVES),
    "plane": Set("Bodies of the plane", "Polygons, circles and capsules: every way for two of them to be special that fathom knows.",
                 count=1500, size=0, kind="--plane", dimension=2),
}
# # The adapters of engines of the plane.
PLANE = ("planck", "matter", "box2d", "rapier2d-contact", "rapier2d-world")

# # The subjects that are asked for whole manifolds: engines with hulls, and all with their own boxes, of which FCL, ODE and Bullet make
# # several contacts.
OF_HULLS = {"jolt-world": "positions=1", "rapier-world": "positions=1", "physx-scene": "positions=1", "mujoco-native": "positions=1,most=4",
            "cannon-contact": "positions=1"}
OF_BOXES = {"fcl-collide": "positions=1,num_max_contacts=4", "bullet-world": "positions=1", "bullet64-world": "positions=1",
            "ode-collide": "positions=1", **OF_HULLS, "mujoco-native": "positions=1"}
FACES = ("faces_parallel", "faces_tilted_hair", "faces_tilted_slightly", "faces_tilted")
CONTACTS = {
    "faces": Set("Faces on faces, hulls", "Boxes, prisms and hulls of which a face lies in part in a face of the other, exactly parallel or "
                 "tilted by 1e-9, 1e-4 and 0.01.", count=400, families=FACES, manifolds=OF_HULLS),
    "boxes": Set("Faces on faces, boxes", "A box on a box, as the libraries' own boxes, at the same tilts.",
                 program="verify/survey/boxes.py tilted", manifolds=OF_BOXES),
    "real-boxes": Set("Real cases of boxes", "The 47 real cases of two boxes, as the libraries' own.",
                      program="verify/survey/boxes.py real", manifolds=OF_BOXES),
}
ALL = {**SETS, **CONTACTS}
# # The tolerances for contacts: the usual one, and one at which only errors above a thousandth of the body count.
TOLERANCES = ("1/1000000", "1/1000")

# # The sets that are put to subjects with other settings too, and the sizes to which bodies are brought: unchanged, or by `certify --fit`.
TRIED_SETS = ("real", "shapes")
FITS = ("", "1", "64")
GUESSES = ["guess=0:0:0", "guess=1:1:1", "guess=0.3:0.5:0.81"]
MARGINS = ["margin=0", "margin=0.001", "margin=0.01"]
MUJOCO = ["ccd_tolerance=1e-9", "ccd_tolerance=1e-9,ccd_iterations=500"]
COOKING = ["plane_tolerance=0", "plane_tolerance=0.00001", "tolerance_length=0.1", "tolerance_length=10"]
# # Settings that affect accuracy according to the library's documents or to our experiments. From 1e-12 on, libccd's EPA may not end.
TRIED = {
    "libccd-epa": ["epa_tolerance=1e-8", "epa_tolerance=1e-10", "first_direction=0.3:-0.81:0.5",
                   "epa_tolerance=1e-10,first_direction=0.3:-0.81:0.5"],
    "libccd-mpr": ["mpr_tolerance=1e-8", "mpr_tolerance=1e-10"],
    "fcl-signed": ["distance_tolerance=1e-8", "distance_tolerance=1e-10"],
    "fcl-collide": ["gjk_tolerance=1e-8", "gjk_tolerance=1e-10"],
    "fcl-indep": ["guess=0.3:0.5:0.81", "gjk_tolerance=1e-8", "guess=0.3:0.5:0.81,gjk_tolerance=1e-8"],
    "bullet-epa": [*GUESSES, "centre_in_binary64=1", "centre_in_binary64=1,guess=1:1:1"],
    "bullet-pair": MARGINS,
    "bullet64-epa": GUESSES,
    "bullet64-pair": MARGINS,
    "jolt": ["penetration_tolerance=1e-6", "hull_tolerance=0.00001", "penetration_tolerance=1e-6,hull_tolerance=0.00001"],
    "jolt-radius": ["max_convex_radius=0.01", "max_convex_radius=0.001", "penetration_tolerance=1e-6"],
    "rapier-contact": ["prediction=0.002"],
    "physx-gjk": COOKING,
    "physx-sweep": COOKING,
    "physx-scene": COOKING,
    "mujoco-native": MUJOCO,
    "mujoco-single": MUJOCO,
    "mujoco-libccd": MUJOCO,
    "mujoco-distance": MUJOCO,
}


def is_asked(adapter, name):
    """Returns whether the subject takes bodies of the dimension of the set."""
    return (ALL[name].dimension == 2) == (adapter in PLANE)


def deciding(adapter):
    """Returns the settings of an adapter that are tried, whose values the tables show."""
    words = [pair.partition("=")[0] for text in TRIED.get(adapter, []) for pair in text.split(",")]
    return list(dict.fromkeys(words))


def digest(path):
    """Returns a digest of the cases of a set, by which answers to other cases are recognised."""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def make(chosen, fathom, path):
    """Writes the cases of a set."""
    with path.open("wb") as file:
        for words in chosen.commands():
            if words[0] == "fathom":
                subprocess.run([fathom, *words[1:]], stdout=file, check=True)
            elif words[0] == "cat":
                file.write((ROOT / words[1]).read_bytes())
            else:
                subprocess.run([sys.executable, "-B", ROOT / words[0], *words[1:]], stdout=file, check=True)


def read_cases(path):
    """Returns {id: the line} in the order of the file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return {json.loads(line)["id"]: line for line in lines if line.strip()}
