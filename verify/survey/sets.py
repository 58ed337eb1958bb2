# SPDX-License-Identifier: GPL-3.0-or-later
"""What the survey puts to every subject: sets of cases, each with the command that makes it."""
import dataclasses
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRIMITIVES = ("spheres", "capsules", "capsule_box", "rounded_boxes", "cylinders", "cones", "ellipsoids")


@dataclasses.dataclass
class Set:
    title: str
    about: str
    count: int = 0         # of generated cases
    size: int = 20         # points a body
    families: tuple = ()   # generated one after another; empty: all in turn
    file: str = ""         # of cases that are there

    @property
    def by_case(self):
        """Whether each case is a row of its own in the tables, and not each family."""
        return bool(self.file)

    def commands(self):
        """The command lines that print the cases."""
        if self.file:
            return [["cat", self.file]]
        each = self.count // len(self.families) if self.families else self.count
        return [["fathom", "cases", "--family", family, "--count", str(each), *self.of_points(), "--seed", "1"]
                for family in self.families or ("all",)]

    def of_points(self):
        return [] if self.families else ["--size", str(self.size)]

    def command(self):
        """The same as text; a shell runs it."""
        lines = self.commands()
        if len(lines) == 1:
            return " ".join(lines[0])
        return f"for f in {' '.join(self.families)}; do {' '.join(lines[0]).replace(self.families[0], '$f', 1)}; done"


SETS = {
    "real": Set("Real cases", "Pairs from issue trackers and test suites of such libraries: a sample of trouble, not of daily use.",
                file="tests/data/real_cases.jsonl"),
    "claims": Set("Published claims", "The pairs about which other projects' tests and issues state something, most of them shapes.",
                  file="verify/claims/claims.jsonl"),
    "20": Set("All families, 20 points", "Every way for two polytopes to be special that fathom knows, made to find errors.", count=920),
    "200": Set("All families, 200 points", "The same families with larger bodies.", count=184, size=200),
    "primitives": Set("Primitives", "Spheres, capsules, boxes, cylinders, cones and ellipsoids by name, to subjects that have them; many "
                      "pairs are shallow, touching or special by intent.", count=70, families=PRIMITIVES),
}


def make(chosen, fathom, path):
    """Writes the cases of a set."""
    with path.open("wb") as file:
        for words in chosen.commands():
            if words[0] == "fathom":
                subprocess.run([fathom, *words[1:]], stdout=file, check=True)
            else:
                file.write((ROOT / words[1]).read_bytes())


def read_cases(path):
    """{id: the line} in the order of the file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return {json.loads(line)["id"]: line for line in lines if line.strip()}
