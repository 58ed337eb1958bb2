#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/measurements.md, measured and printed as Markdown.

    tables.py NAME... [--build DIR] [--before DIR] [--repeat N]

NAME is one of the tables below, or `all`. DIR is a build folder of the preset `bench`; build/bench unless given.
With --before both builds are measured in turns, N times each, the least time of either counts, and each cell
that holds a time reads "now (before)". Times are for reading: nothing passes or fails here.
"""
import argparse
import json
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COUNTERS = ("facets", "facets visited", "records/s", "ms_p90", "cores_us", "ratio_median", "ratio_p90",
            *(f"{what}_{which}" for what in ("calls", "bytes") for which in ("median", "p90", "max")))


def run(command, **options):
    print("+", " ".join(map(str, command)), file=sys.stderr, flush=True)
    return subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def google_benchmark(build, program, pattern=None):
    """{name: processor time in seconds} of a program by Google Benchmark, with its counters under (name, counter).
    Where a program takes the time itself, that is the time, and the name is the one that it gave."""
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        chosen = [f"--benchmark_filter={pattern}"] if pattern else []
        run([build / "tests/benchmark" / program, f"--benchmark_out={out.name}", "--benchmark_out_format=json", *chosen])
        measured = json.load(open(out.name))["benchmarks"]
    figures = {}
    for entry in measured:
        name, *own_time = entry["name"].split("/iterations:")
        figures[name] = entry["real_time" if own_time else "cpu_time"] * unit[entry["time_unit"]]
        for counter in COUNTERS:
            if counter in entry:
                figures[name, counter] = entry[counter]
    return figures


def seconds(value):
    """A time in two digits, in the unit that suits it.

    >>> [seconds(x) for x in (1.64e-5, 0.00996, 0.0994, 0.123, 15.3, 123.4)]
    ['16 µs', '10 ms', '99 ms', '0.12 s', '15 s', '123 s']
    """
    unit, size = ("s", 1.0) if value >= 0.0995 else ("ms", 1e-3) if value >= 0.995e-3 else ("µs", 1e-6)
    return f"{two_digits(value / size)} {unit}"


def two_digits(value):
    """
    >>> [two_digits(x) for x in (0.0123, 1.26, 28.4, 1234.5)]
    ['0.012', '1.3', '28', '1234']
    """
    return f"{value:.0f}" if value >= 99.5 else f"{float(f'{value:.2g}'):g}"


def count(value):
    """
    >>> [count(x) for x in (7, 7100, 4.29e9)]
    ['7', '7100', '4.3e9']
    """
    return f"{value:.1e}".replace("e+0", "e").replace("e+", "e") if value >= 10000 else f"{value:.0f}"


class Pair:
    """What was measured of today's build and, where asked for, of the one before.

    >>> p = Pair(lambda build: {"a": build * 1e-3, "b": 2e-3}, 3, 6, 2)
    >>> p.cell("a"), p.ratio("a", "b"), p.cell("c")
    ('3 ms (6 ms)', '1.5 (3)', '')
    """

    def __init__(self, measure, now, before, repeat):
        runs = {"now": [], "before": []}
        for _ in range(repeat if before else 1):
            if before:
                runs["before"].append(measure(before))
            runs["now"].append(measure(now))
        self.now = self.least(runs["now"])
        self.before = self.least(runs["before"]) if before else {}

    @staticmethod
    def least(runs):
        keys = set().union(*runs)
        return {key: min(r[key] for r in runs if key in r) for key in keys}

    def cell(self, key, form=seconds):
        if key not in self.now:
            return ""
        text = form(self.now[key])
        return f"{text} ({form(self.before[key])})" if key in self.before else text

    def ratio(self, key, base, form=two_digits):
        """The value of `key` as a multiple of that of `base`. Nothing where one of them was not measured."""
        if key not in self.now or base not in self.now:
            return ""
        text = form(self.now[key] / self.now[base])
        if key in self.before and base in self.before:
            text += f" ({form(self.before[key] / self.before[base])})"
        return text


def table(head, rows):
    for row in (head, ["---"] * len(head), *rows):
        print("| " + " | ".join(row) + " |" if row[0] != "---" else "|" + "|".join(row) + "|")
    print(flush=True)


def certificates(pair):
    rows = [("random_sphere", 20), ("random_sphere", 64), ("random_sphere", 200), ("random_sphere", 1000), ("random_sphere", 100000),
            ("needles", 1000), ("crossed_fans", 1000)]
    contenders = ("answer", "text", "check", "pipeline", "bullet_epa")
    sizes = "|".join(f"{name}/{size}" for name, size in rows)
    p = pair(lambda build: google_benchmark(build, "certificate_benchmark", f"^({sizes})/({'|'.join(contenders)})$"))
    table(["pairs, vertices a side", "facets", "answer", "with text", "check", "`exact`", "Bullet's EPA"],
          [[f"{name}, {size:,}", count(p.now.get((f"{name}/{size}/answer", "facets"), 0)),
            *(p.cell(f"{name}/{size}/{c}") for c in contenders)] for name, size in rows])
    bullet(pair)


def bullet(pair):
    """All families with 20 points a side as multiples of Bullet's EPA; those that the page names, and the mean."""
    named = ("random_sphere", "boxes_aligned", "boxes_posed", "exact_ties", "near_ties", "contact_edge_edge", "contact_facet_facet",
             "needles", "huge_coordinates", "uneven_coordinates", "wild_coordinates")
    kinds = ("answer", "text", "check")
    p = pair(lambda build: google_benchmark(build, "certificate_benchmark", "^[^/]*/20/(answer|text|check|bullet_epa)$"))
    ratios = lambda family: [p.ratio(f"{family}/20/{kind}", f"{family}/20/bullet_epa") for kind in kinds]
    rows = [[f"`{family}`", *ratios(family)] for family in named]
    families = sorted({name.split("/")[0] for name in p.now if isinstance(name, str) and name.endswith("/20/bullet_epa")})
    for side in filter(None, (p.now, p.before)):
        mean = lambda kind: statistics.geometric_mean([side[f"{f}/20/{kind}"] / side[f"{f}/20/bullet_epa"] for f in families
                                                       if f"{f}/20/{kind}" in side])
        rows.append([f"all {len(families)}" + (" (before)" if side is p.before else ""), *(two_digits(mean(kind)) for kind in kinds)])
    table(["family", "answer", "with text", "check"], rows)


def shapes(pair):
    p = pair(lambda build: google_benchmark(build, "shapes_benchmark"))
    rows = [("cylinder, cylinder", "cylinder-cylinder, doubles, deep"),
            ("the same, mostly apart", "cylinder-cylinder, doubles, mostly apart"),
            ("cone, box", "cone-box, doubles, deep"), ("cylinder, box", "cylinder-box, doubles, deep"),
            ("ellipsoid, cylinder", "ellipsoid-cylinder, doubles, deep"), ("ellipsoid, ellipsoid", "ellipsoid-ellipsoid, doubles, deep"),
            ("the same, of few digits", "ellipsoid-ellipsoid, few digits, deep")]

    def all_three(name, what):
        return ", ".join(f"{p.now[name, f'{what}_{which}']:,.0f}" for which in ("median", "p90", "max"))

    table(["pair", "time", "9 of 10", "calls", "bytes"],
          [[label, p.cell(name), p.cell((name, "ms_p90"), lambda value: seconds(1e-3 * value)), all_three(name, "calls"),
            all_three(name, "bytes")]
           for label, name in rows])
    alone = ("parallel cylinders, 1/10 off", "parallel cylinders, 1/1000 off", "coaxial cylinders", "nearly balls, 1/10 off",
             "nearly balls, concentric")
    table(["pair", "time", "support calls"], [[name, p.cell(name), p.cell((name, "calls_max"), count)] for name in alone])

    def in_cores(name):
        name = "rounded/" + name
        if name not in p.now:
            return ""
        of = seconds(1e-6 * p.now[name, "cores_us"])
        return f"{p.cell((name, 'ratio_median'), '{:.2f}'.format)}, {p.now[name, 'ratio_p90']:.2f} of {of}"

    kinds, numbers = ("hulls of 20", "boxes", "capsule and box", "capsules", "spheres"), ("doubles", "posed", "short rationals")
    rows = [[f"{kind}, {meeting}", *(in_cores(f"{kind}, {n}, {meeting}") for n in numbers)] for meeting in ("deep", "apart", "touching")
            for kind in kinds]
    table(["cores", *numbers], [row for row in rows if any(row[1:])])


def exact(pair):
    p = pair(lambda build: google_benchmark(build, "depth_benchmark"))
    instances = [f"{family}/{size}" for family, sizes in (("random_sphere", (20, 100, 400, 1000, 4000)),
                                                          ("crossed_fans", (20, 100, 400, 1000, 4000))) for size in sizes]
    others = ("hull_of_differences", "gaussian_map_overlay", "filtered_scan")
    table(["family, vertices a side", "hull of differences", "CGAL's overlay", "edge scan", "exact method"],
          [[i.replace("/", ", "), *(p.ratio(f"{i}/{c}", f"{i}/pipeline") for c in others), p.cell(f"{i}/pipeline")] for i in instances])


LINES = [("crossed_fans", (1024, 4096, 16384, 65536)), ("crossed_parabolas", (16384,)), ("crossed_random_parabolas", (16384,)),
         ("crossed_ties", (16384,)), ("crossed_shrinking_ties", (16384, 65536)), ("crossed_twists", (16384,)),
         ("crossed_fillets", (16384,)), ("crossed_random_prisms", (16384,)), ("crossed_vanishing_ties", (1024, 65536)),
         ("crossed_vanishing_ties, turned", (1024, 65536)), ("crossed_noisy_ties", (65536,))]
# The engine without wide frames compares these pair by pair.
SLOW_SAMPLED = {"crossed_vanishing_ties": 2000, "crossed_noisy_ties": 2000, "crossed_shrinking_ties": 20000}


def lines_growth(build):
    """Figures of lines_growth_benchmark under (family, edges of a bundle, column)."""
    figures = {}
    for family, sizes in LINES:
        name, *turned = family.split(", ")
        slow = SLOW_SAMPLED.get(name, 70000)
        limits = ["--naive-up-to", "2e6" if slow == 2000 else "3e8", "--sampled-up-to", slow, "--turned", len(turned), "--repeat", 3]
        text = run([build / "tests/benchmark/lines_growth_benchmark", *limits, name, *sizes])
        for line in text.splitlines():
            parts = [part.split() for part in line.split("|")]
            if len(parts) < 6 or not parts[0] or not parts[0][0].isdigit():
                continue
            size = int(parts[0][0])
            figures[family, size, "crossings"], figures[family, size, "bound"] = float(parts[0][3]), float(parts[0][6])
            for engine, part in zip(("cutting", "sampled", "naive"), parts[2:5]):
                if part[0] != "-":
                    figures[family, size, engine] = float(part[0]) * 1e-3
                    figures[family, size, engine, "pairs"] = float(part[2])
    return figures


def lines(pair):
    p = pair(lines_growth)
    table(["family", "n", "crossings", "pairs", "bound", "time", "sampled", "naive"],
          [[family, f"{size:,}", p.cell((family, size, "crossings"), count).split(" (")[0],
            p.cell((family, size, "cutting", "pairs"), count),
            p.cell((family, size, "bound"), count).split(" (")[0], p.cell((family, size, "cutting")),
            p.ratio((family, size, "sampled"), (family, size, "cutting")), p.ratio((family, size, "naive"), (family, size, "cutting"))]
           for family, sizes in LINES for size in sizes])


def rays(pair):
    def measure(build):
        text = run([build / "tests/approximate_tests", "--gtest_filter=Ray.QueriesGrow*"])
        return {(family, int(n)): float(queries)
                for family, n, queries in re.findall(r"^(\w+) vertices (\d+) queries (\d+)", text, re.MULTILINE)}
    p = pair(measure)
    table(["family", "vertices", "most support queries of 300 rays"],
          [[family, f"{n:,}", p.cell((family, n), count)] for family, n in sorted(p.now)])


def shallow(pair):
    p = pair(lambda build: google_benchmark(build, "shallow_benchmark", "pipeline|shallow|delta 1/4"))
    table(["vertices a side", "exact method", "first query", "one more query", "facets visited"],
          [[f"{size:,}", p.cell(f"spheres/{size}/pipeline"), p.cell(f"spheres/{size}/shallow"), p.cell(f"spheres/{size}/query, delta 1/4"),
            p.cell((f"spheres/{size}/query, delta 1/4", "facets visited"), two_digits)] for size in (1000, 10000, 100000)])


def golden_levels(build):
    """Seconds and bytes of making and verifying L0 and L1."""
    figures = {}
    for level in ("L0", "L1"):
        folder = Path(tempfile.mkdtemp(prefix="fathom-"))
        try:
            for what, command in (("made", ["generate", "--level", level, "--out", folder]), ("verified", ["verify", folder])):
                before = os.times().elapsed
                run([build / "fathom", "golden", *command], stderr=subprocess.DEVNULL)
                figures[level, what] = os.times().elapsed - before
            figures[level, "bytes"] = float(sum(f.stat().st_size for f in folder.rglob("*") if f.is_file()))
        finally:
            shutil.rmtree(folder)
    return figures


def golden(pair):
    p = pair(golden_levels)
    table(["level", "bytes", "made in", "verified in"],
          [[level, f"{p.now[level, 'bytes'] / 1e6:.1f} MB", p.cell((level, "made")), p.cell((level, "verified"))]
           for level in ("L0", "L1")])
    families(pair)


def families(pair):
    def rates(build):  # seconds a record, so that less is better here too
        figures = google_benchmark(build, "golden_benchmark", "/make$")
        return {name: 1 / figures[name, "records/s"] for name in figures if not isinstance(name, tuple)}
    p = pair(rates)
    rate = lambda value: f"{1 / value:.0f}"
    chosen = ("random_ball", "boxes_posed", "needles", "inverse_edge_edge", "crossed_fans")
    rows = [[f, *(p.cell(f"{f}/{size}/make", rate) for size in (10, 20))] for f in chosen]
    for label, pick in (("median of all families", statistics.median), ("slowest", max)):
        row = [label]
        for size in (10, 20):
            both = [[v for k, v in side.items() if k.endswith(f"/{size}/make")] for side in (p.now, p.before)]
            row.append(rate(pick(both[0])) + (f" ({rate(pick(both[1]))})" if both[1] else ""))
        rows.append(row)
    table(["family, records a second and core, by points a body", "10", "20"], rows)


def processor_time(whose, work):
    """Seconds that `work` takes in this process, or in those that it waits for."""
    used = lambda: resource.getrusage(whose).ru_utime + resource.getrusage(whose).ru_stime
    begin = used()
    work()
    return used() - begin


def stream(pair):
    """One thread, beside the answer alone, on doubles that are there, and Python's json.loads of the same lines."""
    count, answer = 10000, "random_sphere/20/answer"

    def measure(build):
        cases = run([build / "fathom", "cases", "--family", "random_sphere", "--count", count, "--size", "20"])
        lines = cases.splitlines()
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
            file.write(cases)
            file.flush()
            depth = processor_time(resource.RUSAGE_CHILDREN,
                                   lambda: run([build / "fathom", "depth", "--json", "--threads", "1", file.name]))
            begin = os.times().elapsed
            run([build / "fathom", "depth", "--json", file.name])
            wall = os.times().elapsed - begin
        loads = processor_time(resource.RUSAGE_SELF, lambda: [json.loads(line) and None for line in lines])
        alone = google_benchmark(build, "certificate_benchmark", f"^{answer}$")[answer]
        return {"processor": depth / count, "wall": wall / count, "loads": loads / count, "answer": alone}
    p = pair(measure)
    rate = lambda value: f"{1 / value:,.0f}"
    table(["pairs of 20 vertices", "processor time", "of the answer alone", "of `json.loads`", "pairs a second, all cores"],
          [["random_sphere", p.cell("processor"), p.ratio("processor", "answer"), p.ratio("processor", "loads"), p.cell("wall", rate)]])


def worst(pair):
    p = pair(lambda build: google_benchmark(build, "worst_cases_benchmark"))
    inputs = list(dict.fromkeys(name.rsplit("/", 1)[0] for name in p.now if isinstance(name, str)))
    table(["input", "`certificate`", "`exact`", "`approx`, 1/100", "`study`"],
          [[i, *(p.cell(f"{i}/{c}") for c in ("automatic", "exact", "approx", "study"))] for i in sorted(inputs)])


TABLES = {f.__name__: f for f in (certificates, bullet, stream, shapes, exact, lines, rays, shallow, golden, families, worst)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", metavar="NAME", choices=[*TABLES, "all"], help=", ".join(TABLES))
    parser.add_argument("--build", type=Path, default=ROOT / "build/bench")
    parser.add_argument("--before", type=Path)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    for build in filter(None, (arguments.build, arguments.before)):
        if not (build / "tests/benchmark/depth_benchmark").exists():
            parser.error(f"expected a build with benchmarks in {build}: cmake --preset bench && cmake --build --preset bench")
    names = [name for name in TABLES if name not in ("bullet", "families")] if "all" in arguments.names else arguments.names
    for name in names:
        TABLES[name](lambda measure: Pair(measure, arguments.build.resolve(), arguments.before and arguments.before.resolve(),
                                          arguments.repeat))


if __name__ == "__main__":
    main()
