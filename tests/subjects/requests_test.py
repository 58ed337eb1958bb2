# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of requests, and verify/examples/replay.py, which puts them to adapters without fathom: what it says is what `fathom certify` says
of the same answers, and the bounds in the file are the last numbers that pass."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
os.environ.setdefault("FATHOM_ROOT", str(ROOT))
sys.path.insert(0, str(ROOT / "tests" / "cli"))
import schemas  # noqa: E402

FATHOM = os.environ["FATHOM_EXECUTABLE"]
FOLDER = pathlib.Path(os.environ["FATHOM_SUBJECTS"])
REPLAY = ROOT / "verify" / "examples" / "replay.py"
ADAPTERS = {"libccd-epa": [FOLDER / "fathom-subject-libccd", "epa"],  # binary64, depths above 0
            "bullet-epa": [FOLDER / "fathom-subject-bullet", "epa"]}  # binary32, depths below 0
ENDS = ("crash", "silent", "garbage", "time-out")  # no answers, which replay.py keeps as failures
# # What is said of the status and of the number; the rest needs a direction, or points.
TOLD = {"false-separation", "false-overlap", "too-deep", "too-shallow", "too-far", "too-near"}


def run(*words, codes=(0,)):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    assert done.returncode in codes, (words, done.returncode, done.stdout[-500:], done.stderr[-500:])
    return done


def lines(text):
    return [json.loads(line) for line in text.splitlines()]


def verdicts(*words):
    """{id: the line of the case}"""
    return {line["id"]: line for line in lines(run(FATHOM, "certify", "--jobs", 1, "--json", *words, codes=(0, 1)).stdout)
            if line["type"] == "case"}


def is_outside(case):
    """Whether certify says of a case what replay.py can see."""
    said = case.get("judgement", {"findings": [], "sentence": ""})
    lengths = [f"the {field} {wrong}" for field in ("depth", "distance") for wrong in ("has the wrong sign", "is nan", "is inf", "is -inf")]
    if "reply" not in case:
        return case["verdict"] != "unsupported"
    return bool(TOLD & set(said["findings"])) or any(text in said["sentence"] for text in lengths)


class Requests(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.cases = cls.folder / "cases.jsonl"
        with cls.cases.open("w") as file:
            file.write(run(FATHOM, "cases", "--family", "all", "--size", 8, "--count", 60).stdout)
            file.write(run(FATHOM, "cases", "--family", "all", "--shapes", "--count", 23).stdout)
            file.write(run(FATHOM, "cases", "--family", "all", "--unions", "--count", 5).stdout)

    def written(self, adapter, *words):
        """The file of requests for an adapter, and its lines."""
        path = self.folder / "requests"
        run(FATHOM, "certify", "--adapter", adapter, *words, "--write-requests", path, self.cases)
        return path, lines(path.read_text(encoding="utf-8"))

    def test_adapters(self):
        """Law: the same cases are outside as fail by status or number, and the answers that are kept get the same verdicts."""
        for adapter, command in ADAPTERS.items():
            path, (header, *requests) = self.written(adapter)
            answers = self.folder / "answers.jsonl"
            said = run(sys.executable, "-B", REPLAY, path, answers, *command, codes=(1,)).stdout.splitlines()
            ids = {request["id"] for request in requests}
            outside = {name for line in said if (name := line.split(": ")[0]) in ids}
            asked = verdicts("--adapter", adapter, self.cases)
            whole = {name: case for name, case in asked.items() if name in ids}
            self.assertEqual(header["subject"]["name"], adapter)
            self.assertEqual(outside & set(whole), {name for name, case in whole.items() if is_outside(case)})
            self.assertGreater(len(outside & set(whole)), 3)
            self.assertLess(len(outside), len(ids) / 2)
            self.assertIn(f"{len(ids)} requests: ", said[-1])
            again = verdicts("--replay", answers, self.cases)
            self.assertEqual({name: case["verdict"] for name, case in again.items()},
                             {name: "failed" if case["verdict"] in ENDS else case["verdict"] for name, case in asked.items()})

    def test_schema(self):
        """Law: each line obeys the schema; a pair of pieces is a request of its own; who is left out is said."""
        path, (_, *requests) = self.written("libccd-epa")
        schemas.check_lines(path.read_text(encoding="utf-8"))
        self.assertTrue(any(request["id"].endswith("[0,1]") for request in requests))
        self.assertEqual(len({request["run"]["id"] for request in requests}), len(requests))
        statuses = {request["truth"]["status"] for request in requests}
        self.assertLessEqual({"penetrating", "touching", "disjoint"}, statuses)

    def test_bounds(self):
        """Law: the bounds pass and the numbers beyond them do not, at other tolerances and sizes too; both ways to claim are taken or
        refused as the file says."""
        for words in ((), ("--tol-rel", 0, "--tol-abs", 0, "--fit", 64)):
            _, (header, *requests) = self.written("bullet64-epa", *words)
            ends = 0
            self.cases_of = {request["id"]: request for request in requests if "[" not in request["id"]}
            for overlap, field in ((True, "depth"), (False, "distance")):
                for end, way in (("low", -math.inf), ("high", math.inf)):
                    for beyond in (False, True):
                        ends += self.judged(header, overlap, field, end, way if beyond else None, words)
            self.assertGreater(ends, 500)

    def judged(self, header, overlap, field, end, way, words):
        """Judges the claims at one end of all requests, or just beyond it; returns how many there are."""
        claims = {name: value if way is None else math.nextafter(value, way) for name, request in self.cases_of.items()
                  if math.isfinite(value := float(request["accepted"][field][end]))}
        replies = [{"type": "reply", "id": name, "overlap": overlap, field: claim} for name, claim in claims.items()]
        file, cases = self.folder / "claims.jsonl", self.folder / "claimed.jsonl"
        file.write_text("\n".join(map(json.dumps, [header["subject"], *replies])) + "\n")
        cases.write_text("".join(line + "\n" for line in self.cases.read_text().splitlines() if json.loads(line)["id"] in claims))
        for name, case in verdicts("--replay", file, *words, cases).items():
            accepted = self.cases_of[name]["accepted"]["overlap" if overlap else "apart"]
            found = set(case["judgement"]["findings"])
            if way is None:  # with a number that is too large an overlap of bodies that are nearly one is false too
                self.assertEqual(accepted, not found & {"false-overlap", "false-separation"}, case)
            wrong = found & {"wrong-sign", "too-deep", "too-shallow", "too-far", "too-near"}
            self.assertEqual(bool(wrong), way is not None, (name, claims[name], case))
        return len(claims)

    def test_refusals(self):
        path, _ = self.written("libccd-epa")
        done = run(sys.executable, "-B", REPLAY, path, self.folder / "none", *ADAPTERS["bullet-epa"], codes=(2,))
        self.assertIn('declares {"precisions": ["binary64", "binary64"]', done.stderr)
        self.assertEqual(run(sys.executable, "-B", REPLAY, path, codes=(2,)).stderr.split(":")[0], "usage")
        no_file, empty, kept = (self.folder / name for name in ("no file", "empty", "kept"))
        empty.write_text("")
        kept.write_text("answers")
        for given, said in ((no_file, "No such file"), (empty, "empty: expected what fathom certify --write-requests writes")):
            done = run(sys.executable, "-B", REPLAY, given, kept, "true", codes=(2,))
            self.assertRegex(done.stderr, f"^replay.py: .*{said}.*\n$")
            self.assertEqual(kept.read_text(), "answers")
        dead = run(sys.executable, "-B", REPLAY, path, self.folder / "none", "sh", "-c",
                   f"sed -u 2q | {' '.join(map(str, ADAPTERS['libccd-epa']))}", codes=(1,))
        self.assertIn(": no answer: ''", dead.stdout)


if __name__ == "__main__":
    unittest.main()
