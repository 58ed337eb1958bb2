#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user sees stays as it is: `anchor.py --fathom PROGRAM` compares all outputs with the record beside this file,
anchor.txt.

It runs every command over all families, the catalogues, shapes, unions and the files in tests/data: as text, as JSON,
with each option that changes what is printed; it makes the golden data L0, P0, U0, C0 and F0, reads the help pages, and has
subjects judged that lie. (What is refused stands in tests/cli/refusals.jsonl.) A row of the record is a command and what
it was asked: its name, how many lines came out, and their SHA-256, shortened. What came out is the exit code, stdout,
stderr and all files that were written.

    anchor.py --fathom PROGRAM                 prints each row that differs; exit code 1 if there is one
    anchor.py --fathom PROGRAM --keep FOLDER   and keeps what came out, a file for each row: two programs are compared
                                               by `diff -r FOLDER OTHER_FOLDER`
    anchor.py --fathom PROGRAM --only WORDS    rows whose name holds WORDS alone
    anchor.py --fathom PROGRAM --write         makes the record again; with --only, those rows of it

Who changes an output on purpose makes the record again, and names what changed in the commit: its difference shows
nothing else. Nothing here judges whether an output is right; the other tests do."""
import argparse
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RECORD = HERE / "anchor.txt"
KINDS = {"": "polytopes", "--shapes": "shapes", "--unions": "unions"}
SEEDS = 2  # of each family

# All that is masked: what differs between versions, runs and folders.
MASKS = [(rb'("seconds": ?|\btime="|&quot;seconds&quot;:)[0-9.e+-]+', rb"\1TIME"),
         (rb'("fathom": ?"|name="fathom" value="|\bfathom )[0-9]+\.[0-9]+\.[0-9]+', rb"\1VERSION")]

# Asked of every stream of cases.
STREAMS = """
depth
depth --exact --digits 30
depth --json
depth --json --embed-certificate
depth --json --optima 2 --digits 20
depth --json --counters
depth --json --method exact --counters
depth --json --method exact --closest-lines sampled --seed 7
depth --json --method shallow
depth --json --method naive
depth --json --bits 10
depth --patch --twist 1,1/2,0,1/3,0,1
depth --exact --twist 0,0,0,1,-2,1/3
depth --json --embed-certificate --patch --twist 1,1/2,0,1/3,0,1 --twist-b 0,0,1,0,-1,0
width
width --exact --digits 30
width --json --embed-certificate
width --json --method exact --counters
width --json --delta 1/10
approx --delta 1/10
approx --exact --digits 20 --delta 1/3
approx --json --delta 1/10
ray --direction=1,-2,1/3
ray --exact --digits 20 --direction=1,-2,1/3
ray --json --direction=1,-2,1/3
ray --growth --json
metric --ball q.off
metric --exact --ball q.off
metric --json --ball q.off
study
study --all
study --csv
study --json
stages
stages --json
"""

# Asked once, in a folder with the files of examples/data, and tests/data as `data`; OUT is a folder for files.
SINGLES = """
depth a.off b.stl
depth --exact a.obj b.ply
depth --certificate OUT/proof --svg OUT/picture.svg a.off b.stl
depth --json --exact-decimals a.obj b.obj
depth --pose-b 'xyz=0,0,1.5 rpy=0,0,45deg' --digits 20 a.off b.off
depth --json --certificate OUT/proof data/cube.off data/icosahedron.off
depth --case corner cases.jsonl
depth --along 1,0,0 --steps 8 a.off b.off
depth --along 1,0,0 --steps 8 --exact a.off b.off
depth --along 1,0,0 --steps 8 --json --svg OUT/curve.svg a.off b.off
depth --along 1,0,0 --steps 8 --csv a.off b.off
depth --along 1,0,0,0,1,1/2 --steps 4 --json a.off b.off
depth --along 3,1,1 --steps 4 sphere:r=1 capsule:r=1/2,h=2
depth --along 3,1,1 --steps 4 --json sphere:r=1 capsule:r=1/2,h=2
depth --along 3,1,1 --steps 4 --csv sphere:r=1 ellipsoid:1,2,3
depth sphere:r=1 box:1,2,3
depth --json --svg OUT/picture.svg cone:r=1,h=2 ellipsoid:1,2,3
depth --pieces data/comb.obj data/key.obj
depth --pieces --exact data/comb.obj data/key.obj
depth --pieces --json --certificate OUT/proof --svg OUT/picture.svg data/comb.obj data/key.obj
depth --pieces --counters data/decompositions/mug data/key.obj
depth data/comb.obj data/key.obj
depth --require-convex data/comb.obj data/key.obj
depth --json data/wedge_big.ply data/wedge_binary.stl
depth --json data/wedge_text.stl data/wedge.pts
robot arm.urdf
robot --json --exact-decimals --joints shoulder=1/4,elbow=3,grip=0.05 arm.urdf
depth --joints elbow=3 --certificate OUT/proof arm.urdf#upper arm.urdf#left
depth --pose-b 'xyz=0,0,1.5 euler=intrinsic zxz 10,20,30deg' a.off b.off
width a.off
width --certificate OUT/proof --json a.stl
width cylinder:r=1,h=2
approx a.off b.stl
ray --direction 0,0,1 a.off b.stl
ray --growth a.off b.stl
ray --growth --center-a 0,0,0 --center-b 1,0,0 --json a.off b.stl
metric --ball q.off a.off b.stl
study --html OUT/page.html a.off b.stl
study data/comb.obj data/key.obj
study --sweep crossed_fans --sizes 10..50
study --sweep crossed_fans --sizes 10..20 --closest-lines cutting,sampled,naive --json
study --sweep random_sphere --sizes 10..50 --csv --svg OUT/chart.svg
stages a.off b.stl
stages --svg OUT/charts.svg a.off b.stl
explain a.off b.stl -o OUT/page.html
explain --twist 0,0,1,0,1/2,0 a.off b.stl -o OUT/page.html
explain sphere:r=1 box:half=1:2:3 -o OUT/page.html
explain --pieces data/comb.obj data/key.obj -o OUT/page.html
cases --list
cases --list --shapes
cases --list --unions
cases --from a.off b.stl
cases --from --exact-decimals --pose-a 'xyz=1,2,3' a.obj b.obj
cases --from-fcl error.log
cases --small-world 6463000 --count 1000
check proof.cert
check --echo --case case.json proof.cert
check data/certificates/two_in_one_file.cert data/certificates/depth_cubes.cert
golden export --format json cases.jsonl
golden export --format csv cases.jsonl
golden export --format c --certificates OUT/own.cert cases.jsonl
golden export --format rust cases.jsonl
golden export --format json --count 9 --exclude disjoint data/golden
golden export --format c --count 9 --max-points 8 data/golden
golden export --format csv data/golden
certify --claims data/claims.jsonl
certify --claims data/claims.jsonl --json
certify --replay replies.jsonl cases.jsonl
certify --replay replies.jsonl --expect-fail known.txt --method exact --method naive cases.jsonl
certify --replay replies.jsonl --certificates OUT/proofs --all-rows cases.jsonl
certify --subject ./mine --print-input corner cases.jsonl
certify --subject ./mine --jobs 1 --shrink OUT/small --write-expect-fail OUT/known.txt cases.jsonl
certify --subject ./mine --jobs 1 --fit 100 --metamorphic --json cases.jsonl
"""

SHAPES = "sphere capsule tapered_capsule box cylinder cone frustum ellipsoid hull triangle halfspace sum margin pieces".split()

# Ways of tests/harness/liar.py.
LIES = """honest too-deep too-shallow negative-depth turned-direction nan infinite separation zero-direction failed
unsupported crash abort exit silent garbage empty-line noise no-fields wrong-types array other-id no-id null-depth
null-apart second-hello hang twice one-shot crash-at-stop fail-at-stop hello-silent
hello-garbage hello-without-unit hello-precision hello-late""".split()


def masked(data):
    for pattern, with_what in MASKS:
        data = re.sub(pattern, with_what, data)
    return data


class Anchor:
    def __init__(self, options, folder):
        self.fathom = pathlib.Path(options.fathom).resolve()
        self.threads, self.only, self.keep = options.threads, options.only, options.keep
        self.folder, self.rows = folder, {}

    def asked(self, name):
        return not self.only or self.only in name

    def row(self, name, data):
        if not self.asked(name):
            return
        assert name not in self.rows, name
        data = masked(data)
        self.rows[name] = f"{data.count(10)} {hashlib.sha256(data).hexdigest()[:16]}"
        if self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            (self.keep / re.sub(r"[^\w.,=+-]+", "_", name)).write_bytes(data)

    def run(self, words, stdin=b"", folder=None):
        """What came out: exit code, stdout, stderr."""
        done = subprocess.run([self.fathom, *words], input=stdin, cwd=folder or self.folder, capture_output=True,
                              timeout=600, check=False, env={**os.environ, "COLUMNS": "100", "LC_ALL": "C.UTF-8"})
        return done.returncode, done.stdout, done.stderr

    def ran(self, name, words, stdin=b"", also=(), folder=None):
        """A row of all that came out, files in OUT and `also` among it."""
        if not self.asked(name):
            return b""
        out = self.folder / "OUT"
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir()
        code, stdout, stderr = self.run(words, stdin, folder)
        parts = [stdout, b"--- stderr\n" + stderr, b"--- exit code %d\n" % code]
        for path in [*sorted(path for path in out.rglob("*") if path.is_file()), *also]:
            parts.append(b"--- %s\n" % str(path.relative_to(self.folder)).encode() + path.read_bytes())
        self.row(name, b"".join(parts))
        return stdout

    def streams(self):
        """Cases by name: families with a first word in common, the catalogues, files."""
        for option, kind in KINDS.items():
            names = [line.split()[0] for line in self.run(["cases", "--list", *option.split()])[1].decode().splitlines()]
            groups = {}
            for name in names:
                groups.setdefault(name.split("_")[0].removesuffix("s"), []).append(name)
            for word in [word for word in groups if len(groups[word]) < 3]:
                groups.setdefault("others", []).extend(groups.pop(word))
            for word, families in groups.items():
                words = ["cases", "--family", ",".join(families), "--count", str(SEEDS * len(families))]
                yield f"{kind}/{word}", self.run(words)[1]
            yield f"{kind}/catalogue", self.run(["cases", "--catalogue", *option.split()])[1]
        for name in ("real_cases.jsonl", "real_shapes.jsonl", "unions.jsonl", "posed_boxes.json"):
            yield name, (ROOT / "tests" / "data" / name).read_bytes()

    def answers(self):
        for name, cases in self.streams():
            self.row(f"cases {name}", cases)
            for form in STREAMS.split("\n")[1:-1]:
                results = self.ran(f"{form} {name}", [*form.split(), "--threads", self.threads, "-"], cases)
                if "certificate" in form:
                    width = ["--width"] * form.startswith("width")
                    self.ran(f"check {form} {name}", ["check", "--results", "-", *width, "--threads", self.threads], results)
            if "catalogue" in name:
                for form in ("depth --certificate OUT --svg OUT", "width --certificate OUT", "stages --svg OUT",
                             "study --html OUT/page.html"):
                    self.ran(f"{form} {name}", [*form.split(), "-"], cases)
                self.judged(name, cases)

    def judged(self, name, cases):
        """Replies that are right, and wrong in many ways, in turn: made of the true answers."""
        if not self.asked(f"certify {name}"):
            return
        replies = [{"type": "hello", "protocol": "fathom/subject/1", "name": "parrot", "version": "1", "precision": "binary64",
                    "conventions": {"touching": "either", "depth": "positive", "moves": "a", "unit": True},
                    "capabilities": {"shapes": SHAPES}}]
        for i, line in enumerate(self.run(["depth", "--json", "-"], cases)[1].splitlines()):
            result = json.loads(line)
            if "status" not in result:
                continue
            depth = result["depth"]
            reply = {"type": "reply", "id": result["id"], "overlap": result["status"] == "penetrating",
                     "depth": depth.get("value") or depth.get("high") or 0, "direction": result.get("unit_f64") or [1, 0, 0]}
            if result.get("witness_f64"):
                reply["witness"] = result["witness_f64"]
            wrong = [{}, {"depth": 1.5 * reply["depth"]}, {"depth": reply["depth"] * (1 + 1e-9)},
                     {"overlap": not reply["overlap"]}, {"depth": "nan"},
                     {"direction": [-x for x in reply["direction"]]}, {"depth": -reply["depth"]}, {"direction": [0.6, 0, 0.8]},
                     {"depth": 0.5 * reply["depth"]}, {"direction": [0, 0, 0]}, {"unsupported": "no"}, {"failed": "by itself"}]
            replies.append({**reply, **wrong[i % len(wrong)]})
        (self.folder / "parrot.jsonl").write_text("".join(json.dumps(reply) + "\n" for reply in replies))
        words = ["certify", "--replay", "parrot.jsonl", "--jobs", "1"]
        for more in ("--junit OUT/junit.xml --html OUT/page.html --report OUT/report", "--json --policy minimum --tol-ulps 4",
                     "--json --policy separating --tol-rel 0 --certificates OUT"):
            self.ran(f"certify {name} {more}", [*words, *more.split(), "-"], cases)

    def singles(self):
        for line in SINGLES.split("\n")[1:-1]:
            self.ran(line, [word.strip("'") for word in re.findall(r"'[^']*'|[^ ]+", line)])

    def lies(self):
        def box(x, far):
            return {"vertices": [[x[i & 1] + far, i >> 1 & 1, i >> 2 & 1] for i in range(8)]}

        pairs = [(box((1, 0), far), box((0.5 + i / 1000, 2), far)) for i, far in enumerate((0, 1000, 0))]
        cases = "".join(json.dumps({"id": f"box::{i}", "a": a, "b": b}) + "\n" for i, (a, b) in enumerate(pairs)).encode()
        for way in LIES:
            words = ["certify", "--jobs", "1", "--time-out", "1" if way == "hang" else "60",
                     "--subject", f"exec python3 -B liar.py {way} 0"]
            self.ran(f"certify liar {way}", [*words, "-"], cases)
            self.ran(f"certify liar {way} --json", [*words, "--json", "--junit", "OUT/junit.xml", "--html", "OUT/page.html", "--report",
                                                    "OUT/report", "-"], cases)
            if way in ("honest", "too-deep") and (self.folder / "OUT" / "report").exists():
                shutil.copy(self.folder / "OUT" / "report", self.folder / f"{way}.jsonl")
        for form in ("", "--json ", "--html OUT/page.html "):
            self.ran(f"certify diff {form}".strip(), f"certify diff {form}honest.jsonl too-deep.jsonl".split())

    def golden(self):
        for level in ("L0", "P0", "U0", "C0", "F0"):
            if not self.asked(f"golden {level}"):
                continue
            code, stdout, stderr = self.run(["golden", "generate", "--level", level, "--out", level, "--jobs", self.threads])
            self.row(f"golden {level}", stdout + stderr + b"exit code %d\n" % code)
            for path in sorted((self.folder / level).iterdir()):
                packed = path.suffix == ".zst"
                data = subprocess.run(["zstd", "-dcq", path], capture_output=True, check=True).stdout if packed else path.read_bytes()
                if packed or path.name in ("CONTENT_SHA256SUMS", "NOTES.md") or "schema" in path.name:
                    self.row(f"golden {level} {path.name.removesuffix('.zst')}", data)

    def pages(self):
        commands = re.search(r"\nCommands\n(.*?)\n\n", self.run(["--help"])[1].decode(), re.S)[1]
        for command in ["", *re.findall(r"^  (\S+)", commands, re.M), "certify diff", "golden generate", "golden verify", "golden export"]:
            self.ran(f"help {command}".strip(), ["help", *command.split()])
        self.ran("man", ["man", "--all", "OUT"])
        for shell in ("bash", "zsh", "fish"):
            self.ran(f"completion {shell}", ["completion", shell])

    def whole(self):
        for path in (ROOT / "examples" / "data").iterdir():
            shutil.copy(path, self.folder / path.name)
        shutil.copytree(ROOT / "tests" / "data", self.folder / "data")
        shutil.copy(ROOT / "verify" / "claims" / "claims.jsonl", self.folder / "data")
        shutil.copy(ROOT / "tests" / "harness" / "liar.py", self.folder)
        for part in (self.pages, self.singles, self.answers, self.lies, self.golden):
            part()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--fathom", required=True, help="the program")
    parser.add_argument("--write", action="store_true", help="make the record again")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for what came out")
    parser.add_argument("--only", help="rows whose name holds these words")
    parser.add_argument("--threads", default="1", help="of the program; the record is the same with any number")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        anchor = Anchor(options, pathlib.Path(folder))
        anchor.whole()
    before = dict(line.split("\t") for line in RECORD.read_text().splitlines()) if RECORD.exists() else {}
    if options.write:
        rows = {name: row for name, row in before.items() if not anchor.asked(name)} | anchor.rows
        RECORD.write_text("".join(f"{name}\t{row}\n" for name, row in sorted(rows.items())))
        return 0
    before = {name: row for name, row in before.items() if anchor.asked(name)}
    for name in sorted(before.keys() | anchor.rows.keys()):
        old, new = before.get(name), anchor.rows.get(name)
        if old is None or new is None:
            print(f"{name}: {'not in the record' if old is None else 'in the record alone'}")
        elif old != new:
            print(f"{name}: {old.split()[0]} lines were recorded, {new.split()[0]} other ones came")
    differing = sum(before.get(name) != anchor.rows.get(name) for name in before.keys() | anchor.rows.keys())
    print(f"{len(anchor.rows)} rows, {differing} differ" + (": see the head of tests/anchor/anchor.py" if differing else ""))
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
