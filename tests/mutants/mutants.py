#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the code in one small way after another, and shows that the tests see it.

    tests/mutants/mutants.py                 all of them; it takes hours
    tests/mutants/mutants.py 7 12            these numbers
    tests/mutants/mutants.py reference       those in files whose path holds this word
    tests/mutants/mutants.py --list          prints them; --check demands that the text of each stands in its file once
    --build FOLDER                           a configured build of the release preset with tests (build/release)

Each mutant is put into the file, the tests that may catch it are built and run, at least one of them must fail, and the
file becomes what it was, also where this is interrupted. One that does not compile shows nothing: it has to be replaced.
The tree must be clean before.

Exit codes: 0 all caught; 1 some survived, or their text is gone; 2 wrong words, or a tree that is not clean."""
import argparse
import pathlib
import signal
import subprocess
import sys
import time
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Mutant(NamedTuple):
    path: str
    text: str
    by: str
    tests: str  # names in CTest; one that fails is enough


MUTANTS = [Mutant(*fields) for fields in [
    # numbers, filters, predicates, the perturbation
    ("kernels/number/rational.cpp", "half && (below || odd)", "half && (below || !odd)", "kernels_tests"),
    ("kernels/number/rational.cpp", "{-positive.rn, -positive.ru, -positive.rd}", "{-positive.rn, -positive.rd, -positive.ru}",
     "kernels_tests"),
    ("kernels/filters/support.cpp", "if (near.size() == 1 || v.slack == 0) return std::move(near);",
     "if (!near.empty()) return std::move(near);", "kernels_tests"),
    ("kernels/filters/support.cpp", "if (value <= bar) return;", "if (value < bar) return;", "kernels_tests"),
    ("kernels/filters/line_filter.cpp", "if (least[0] > 0 && least[1] > 0) continue;", "if (least[0] > 0) continue;",
     "kernels_tests"),
    ("kernels/predicates/perturbation.cpp", "(-(e(tilt_a) * e(tilt_c)) - e(tilt_b))", "(-(e(tilt_a) * e(tilt_c)) + e(tilt_b))",
     "kernels_tests"),
    ("kernels/predicates/perturbation.cpp", "cross(m[2], m[0]), cross(m[0], m[1])", "cross(m[0], m[2]), cross(m[0], m[1])",
     "kernels_tests"),
    # the lattice, distances, the expander, contacts
    ("reference/polytope/narrow_lattice.cpp", "low + static_cast<long>(zeros);", "low;", "polytope_tests"),
    ("reference/polytope/lattice.cpp", "return q.get_num() * factor_;", "return abs(q.get_num()) * factor_;", "polytope_tests"),
    ("reference/polytope/distance.cpp", "if (sgn(w) <= 0 || sgn(rest) <= 0) return std::nullopt;",
     "if (sgn(w) <= 0) return std::nullopt;", "polytope_tests"),
    ("kernels/number/wide_float.cpp", "rest + error >= whole", "rest + error > whole", "kernels_tests"),
    ("kernels/number/wide_float.hpp", "b.value_.order() + a.error_, ", "", "kernels_tests"),
    ("reference/expanding/expander.hpp", "enclosure(p.exact)) + surface_", "enclosure(p.exact)) - surface_",
     "expanding_tests"),
    ("reference/expanding/expander.hpp", "if (order > 0) return true;", "if (order >= 0) return true;", "expanding_tests"),
    ("reference/expanding/expander.hpp", "return or_equal ? order >= 0 : order > 0;", "return order >= 0;", "expanding_tests"),
    ("reference/depth/contact.cpp", "corners_of_a == 1 ? ContactKind::vertex_facet : ContactKind::edge_facet",
     "corners_of_a == 2 ? ContactKind::vertex_facet : ContactKind::edge_facet", "depth_tests"),
    # growth distances
    ("reference/approximate/metric.cpp", "meet(*result.touch, a, b, (1 - exit.factor) * c);",
     "meet(*result.touch, a, b, (exit.factor - 1) * c);", "approximate_tests"),
    ("reference/approximate/metric.cpp", "return placed.position(sum, hull.vertices.size());",
     "return placed.position(sum, points.size());", "approximate_tests"),
    ("reference/approximate/metric.cpp", "report.expect(room > 0,", "report.expect(room >= 0,", "approximate_tests"),
    # first contacts: a gap of 0, the end alone, a plane's side, the grid, the cell's end, a motion through 0
    ("reference/motion/motion.cpp", "if (sgn(value(k, i, j)) > 0) continue;", "if (sgn(value(k, i, j)) >= 0) continue;", "motion_tests"),
    ("reference/motion/motion.cpp", "for (std::size_t k = gap.constant.size(); k-- > 0;) {",
     "for (std::size_t k = gap.constant.size(); k-- > 1;) {", "motion_tests"),
    ("reference/motion/motion.cpp", "extreme_points(a_.points, -gap.of_a[k]).front(),", "extreme_points(a_.points, gap.of_a[k]).front(),",
     "motion_tests"),
    ("reference/motion/motion.cpp", "multiple(result[0], result[1], -1))", "multiple(result[0], result[1], 1))", "motion_tests"),
    ("reference/motion/impact.cpp", "Moment next = at(now.t + cell_);", "Moment next = at(now.t + cell_ / 2);", "motion_tests"),
    ("reference/motion/impact.cpp", "if (stuck && from->squared_distance()", "if (stuck || from->squared_distance()",
     "motion_tests"),
    # contact patches and derivatives: the faces for the patch, one corner, the first optimum, the wrong order
    ("reference/patch/patch.cpp", "if (sign < 0) return std::nullopt;", "if (sign <= 0) return std::nullopt;", "patch_tests"),
    ("reference/patch/patch.cpp", "return enters(p) && !enters(q);", "return enters(q) && !enters(p);", "patch_tests"),
    ("reference/patch/patch.cpp", "if (of_a > 1 && of_b > 1 && of_a + of_b > 4) return shared(faces, support);", "", "patch_tests"),
    ("reference/patch/derivative.cpp", "Integer(best->second.over * rate.under)) <= 0) continue;",
     "Integer(best->second.over * rate.under)) <= 2) continue;", "patch_tests"),
    ("reference/patch/derivative.cpp", "(geometry.of_unions ? -1 : 1) < 0)", "(geometry.of_unions ? -1 : 1) < -2)", "patch_tests"),
    ("reference/patch/derivative.cpp", "if (geometry.cone) return patch::by_cone(geometry, of_a, of_b);", "", "patch_tests"),
    ("reference/certificate/patch_certificate.cpp", "add(b, true);", "", "certificate_tests"),
    # unions, curved shapes, what is rounded
    ("reference/unions/union_search.cpp", "kernels::compare(cell.nearest, *best_) <= 0) split(cell)",
     "kernels::compare(cell.nearest, *best_) < 0) split(cell)", "unions_tests"),
    ("reference/unions/pieces.cpp", "(1 - 0x1p-39)", "(1 - 0x1p-47)", "unions_tests"),
    ("reference/unions/pair_table.cpp", "of_separation * largest(u) * (1 + largest(at))", "-0.01", "unions_tests"),
    ("reference/unions/union_prover.cpp", "return dot(u, p_.v) >= h * p_.w;", "return dot(u, p_.v) > h * p_.w;", "unions_tests"),
    ("reference/unions/union_prover.cpp", "return h < 0 && h * h >= squared_ * dot(u, u);", "return h < 0;", "unions_tests"),
    ("reference/unions/pieces.cpp", "height / shared, {}}", "height, {}}", "unions_tests"),
    ("reference/unions/union_search.cpp", "if (to == 0 || to == -way) return CellEnd::infeasible;",
     "if (to == 0) return CellEnd::infeasible;", "unions_tests"),
    ("reference/answer/plane.cpp", "while (power <= sum) power *= 2;", "while (power < sum) power *= 2;", "plane_tests"),
    ("reference/answer/plane.cpp", "extent_along_x(a) + extent_along_x(b);", "extent_along_x(a);", "plane_tests"),
    ("reference/answer/plane.cpp", "id % static_cast<std::uint32_t>(count)", "id", "plane_tests"),
    ("reference/answer/plane.cpp", "distance.witness.a.z = distance.witness.b.z = 0;", "", "plane_tests"),
    ("reference/answer/plane.cpp", "if (cone.lineality == Lineality::plane) cone", "if (cone.lineality == Lineality::line) cone", "plane_tests"),
    ("reference/answer/plane.cpp", "a.pieces || b.pieces ? raised(a, height)", "a.pieces ? raised(a, height)", "plane_tests"),
    ("reference/answer/plane.cpp", "return x * (p.y - o.y) == y * (p.x - o.x);", "return x == p.x - o.x;", "plane_tests"),
    ("reference/answer/plane.cpp", "plane->normal = primitive(Vector{plane->normal.x, plane->normal.y, 0});", "", "plane_tests"),
    ("reference/answer/plane.cpp", "abs(v.x));", "64 * abs(v.x));", "plane_tests"),
    ("reference/answer/plane.cpp", "static_cast<std::uint32_t>(count)] += w.weight", "static_cast<std::uint32_t>(count)] = w.weight", "plane_tests"),
    ("reference/patch/geometry.cpp", "body_a.dimension == 2 ? shared(faces, optimum.support)", "false ? shared(faces, optimum.support)",
     "plane_tests"),
    ("reference/patch/geometry.cpp", "if (dimension == 2) return of_a.size() > 1 || of_b.size() > 1;", "", "plane_tests"),
    ("reference/files/svg.cpp", "if (drawn) here = start;", "", "plane_tests"),
    ("reference/files/svg.cpp", "product(around.pose, function(at, name, numbers))", "product(function(at, name, numbers), around.pose)",
     "plane_tests"),
    ("reference/files/svg.cpp", "result.shape->radius *= *scale", "result.shape->radius *= 1", "plane_tests"),
    ("reference/files/pose.cpp", "if (given.plane && body.dimension != 2)", "if (given.plane && body.dimension == 1)", "files_tests"),
    ("reference/files/body_fields.cpp", "if (half_angle) result.turn.z", "if (half_angle) result.turn.x", "plane_tests"),
    ("reference/solids/arrangement.cpp", "    times -= sum;", "    times += sum;", "solids_tests"),
    ("reference/solids/arrangement.cpp", "if (overlap(space_, boxes[i].first, boxes[k].first)) groups",
     "if (i == k) groups", "solids_tests"),
    ("reference/solids/solid.cpp", "if (volume < 0) turn();", "", "solids_tests"),
    ("reference/solids/convex_parts.cpp", "for (const PlaneId plane : middle_planes(points)) consider(plane);", ";", "solids_tests"),
    ("reference/solids/coverage.cpp", "if (facet.side.reversed) std::swap(above, below);", "", "solids_tests"),
    ("reference/patch/mesh_features.cpp", "part.size() > 2 && area_vector(part) != Point{}", "part.size() > 2", "patch_tests"),
    ("reference/patch/mesh_features.cpp", "  if (!found.empty()) return found;", "", "patch_tests"),
    ("reference/patch/patch.hpp", "b_->features(places(patch, &Patch::b))", "b_->features(places(patch, &Patch::a))", "patch_tests"),
    ("reference/solids/convex_parts.cpp", "&& is_below(b, a, common);", ";", "solids_tests"),
    ("reference/curved/assembly.cpp", "if (up && rest != 0) ++result;", "if (rest != 0) ++result;", "curved_tests"),
    ("reference/curved/assembly.cpp", "if (auto found = of_one_disc(Choices(a_, b_))) return found;", "", "curved_tests"),
    ("reference/curved/assembly.cpp", "return edges ? in_edges() : std::nullopt;", "return std::nullopt;", "curved_tests"),
    ("reference/curved/curved_bounds.cpp", "if (plane.height <= 0) return std::nullopt;", "if (plane.height == 0) return std::nullopt;",
     "curved_tests"),
    ("reference/curved/coaxial.cpp", "bits_ + spare_bits).high;", "bits_ + spare_bits).low;", "curved_tests"),
    ("reference/curved/coaxial.cpp", "for (const int side : {1, -1})", "for (const int side : {1, 1})", "curved_tests"),
    ("reference/rounded/optimal_cone.cpp", "if (size == 2 && next == 0) break;", "if (size == 3 && next == 0) break;",
     "rounded_tests"),
    ("reference/rounded/optimal_cone.cpp", "if (below < 0) (below = -below, ray = -ray);",
     "if (below > 0) (below = -below, ray = -ray);", "rounded_tests"),
    # readers and writers
    ("reference/files/stl.cpp", "facet + normal_size + 12 * corner", "facet + 12 * corner", "files_tests"),
    ("reference/files/case_fields.cpp", "if (fields.fault.empty()) fields.fault = sentence;", "fields.fault = sentence;",
     "files_tests"),
    ("reference/files/pose.cpp", "result[i % 3][i / 3] = pose[i / 4][i % 4];", "result[i / 3][i % 3] = pose[i / 4][i % 4];",
     "files_tests"),
    ("reference/output/answer_json.cpp", "if (low == high) return length(low * low, digits);",
     "if (low == high) return length(low, digits);", "cli_transcript_shapes"),
    # certificates: the writer, and the checkers, which share nothing with it
    ("reference/certificate/certificate.cpp", "certificate.weights_b = std::move(origin.b);",
     "certificate.weights_b = certificate.weights_a;", "certificate_tests"),
    ("reference/certificate/cone_proof.cpp", "for (const Vector& side : {w, -w})", "for (const Vector& side : {w, w})",
     "certificate_tests"),
    ("verify/check/check_inner.cpp", "if (height_ != c_of_plane_) throw", "if (height_ > c_of_plane_) throw", "check_tests"),
    ("verify/check/fixed.hpp", "(middle >> 64) + (other >> 64)", "(middle >> 64)", "check_tests"),
    ("verify/check/vectors.hpp", "if (size <= 63)", "if (size <= 64)", "check_tests"),
    ("verify/check/check_inner.cpp", "return most <= most_bits_of_vertices(s) ?", "return most <= 63 ?", "check_tests"),
    ("verify/check/scaled.cpp", "static_cast<long>(common) - static_cast<long>(largest())", "0", "check_tests"),
    ("verify/check/check_cone.cpp", "if (ends[r] < 2) throw", "if (ends[r] < 1) throw", "check_tests"),
    ("verify/check/check_unions.cpp", "if (listed != open_[s]) throw", "if (listed > open_[s]) throw", "check_tests"),
    ("verify/check/check_patches.cpp", "product_ != lowest_ * p.den) throw", "product_ < lowest_ * p.den) throw", "check_tests"),
    ("verify/check/check_patches.cpp", "if (compare(order[k - 1], order[k]) == 0)", "if (compare(order[k - 1], order[k]) > 0)",
     "check_tests"),
    ("verify/check/solids.cpp", "below = below || side < 0", "below = true", "check_tests"),
    ("verify/check/check_solids.cpp", "if (product_ * largest.den <= other_) continue;",
     "if (product_ <= largest.num) continue;", "check_forgeries_of_two_bodies"),
    ("verify/check/check_solids.cpp", "const mpz_class factor = w / divisor;", "const mpz_class factor = 1;",
     "check_forgeries_of_two_bodies"),
    ("verify/check/check_solids.cpp", "    throw Fault(*fault);", "    return;", "check_tests"),
    ("verify/check/solids.cpp", "return std::binary_search(begin, end, number) ?", "return number < points_.size() ?", "check_tests"),
    ("verify/check/solids.cpp", "std::size_t middle = (whole.first + whole.last) / 2;",
     "std::size_t middle = (whole.first + whole.last + 1) / 2;", "check_tests"),
    ("verify/check/check_unions.cpp", "reached_ *= den * den;", "reached_ *= den;", "check_forgeries_of_two_bodies"),
    ("verify/check/limits.cpp", "cost(5 * p, 5 * p)", "cost(4 * p, 4 * p)", "check_two_body_limits"),
    ("verify/check/check_impact.cpp", "if (height <= 0) throw", "if (height < 0) throw", "check_tests"),
    ("verify/check/check_impact.cpp", "if (near && before) throw", "if (near && parts.line == 0) throw", "check_tests"),
    ("verify/check/check_impact.cpp", "begin.get_den() * at(end)", "end.get_den() * at(end)", "check_forgeries_of_motions"),
    ("verify/check/limits.cpp", "12 * b + 2 * u + 32", "12 * b + 2 * u + 31", "check_impact_limits"),
    ("verify/check/check.py", "demand(h > 0,", "demand(h >= 0,", "check_forgeries_of_motions"),
    ("verify/check/check_claim.cpp", "value(c.high) >= left * left)", "value(c.high) > left * left)", "check_forgeries_of_the_plane"),
    ("verify/check/check.py", "demand(left > 0,", "demand(left >= 0,", "check_forgeries_of_the_plane"),
    ("verify/check/check.py", "demand(not fault, fault)", "pass", "check_forgeries_of_two_bodies"),
    ("verify/check/check.py", "halves = whole[len(whole) // 2:], whole[:len(whole) // 2]",
     "halves = whole[(len(whole) + 1) // 2:], whole[:(len(whole) + 1) // 2]", "check_forgeries_of_two_bodies"),
    ("verify/check/check_solids.cpp", "if (last && sum != 0)", "if (last && sum > 0)", "check_tests"),
    ("verify/check/check.py", "demand(not any(flags.values()),", "demand(not sum(flags.values()),", "check_forgeries_of_solids"),
    ("verify/check/check.py", "demand(len(set(normals)) == len(facets) > 0,", "demand(len(facets) > 0,", "check_forgeries_of_solids"),
    ("verify/check/check.py", "demand(sum(p * p for p in y) <= 1,", "demand(sum(p * p for p in y) <= 2,",
     "check_forgeries_of_format_2"),
    ("verify/check/check.py", "demand(dot(n, cross(before, m)) > 0,", "demand(dot(n, cross(before, m)) >= 0,",
     "check_forgeries_of_patches"),
    # the judge and the harness
    ("verify/families/small_world.cpp", "(*image)[b] >= b;", "(*image)[b] > b;", "families_tests"),
    ("verify/families/small_world.cpp", "separating = minus(separating, negative(u));", "separating = u;", "families_tests"),
    ("verify/judge/judge.cpp", "if (claim_.overlap && conventions_.touching == Touching::separate)",
     "if (claim_.overlap && conventions_.touching == Touching::either)", "doors_tests"),
    ("verify/judge/manifold.cpp", "return rise == 1 && deeper(*fault.contact, limit);",
     "return rise == 1 || deeper(*fault.contact, limit);", "judge_tests"),
    ("verify/judge/manifold.cpp", "if (!here || deeper(contact, here->factor)) {", "if (!here) {", "judge_tests"),
    ("verify/judge/manifold.cpp", "!most_ || *most_ > 1;", "!most_ || *most_ > 0;", "doors_tests"),
    ("verify/judge/manifold.cpp", "slack_ ? mpq_class(near_ + *slack_) : near_", "near_", "judge_tests"),
    ("verify/judge/manifold.cpp", "found.covered_squared = share * share;", "found.covered_squared = share;", "judge_tests"),
    ("reference/patch/local_depth.cpp", "squared / length_squared}", "squared}", "patch_tests"),
    ("verify/judge/manifold.cpp", "if (is(-squared_))", "if (is(squared_))", "judge_tests"),
    ("verify/judge/manifold.cpp", "share * largest_speed(a, b, motion)), rounding)", "share), rounding)", "judge_tests"),
    ("reference/patch/local_depth.cpp", "costs[i] = -a_[i].height;", "costs[i] = a_[i].height;", "patch_tests"),
    ("verify/judge/claim.cpp", "exponent_of_root(squared) - digits.bits + 1,", "exponent_of_root(squared) - digits.bits + 2,",
     "judge_tests"),
    ("verify/harness/seen_case.cpp", "(most && *other <= *most)", "(most && *other >= *most)", "harness_tests"),
    ("verify/harness/journal.cpp", "seen.emplace(outcome->id, outcome->variant)", 'seen.emplace(outcome->id, "")', "harness_tests"),
    ("verify/judge/truth.cpp", "return Between{low, std::nextafter(beyond, -infinity)};", "return Between{low, beyond};",
     "subject_requests"),
    ("verify/judge/truth.cpp", "result.depth = {-result.depth.high, -result.depth.low};",
     "result.depth = {-result.depth.low, -result.depth.high};", "subject_requests"),
    # golden data
    ("verify/golden/records/prove.cpp", "if (found->certificate.id != id)", "if (found->certificate.id.empty())", "golden_tests"),
    ("verify/golden/shards/plan.cpp", "case Level::L0: return {3, 12, 0};", "case Level::L0: return {3, 11, 0};", "golden_tests"),
    # the bindings and the command line
    ("bindings/c/boundary.cpp", "if (index < count) return;", "if (index <= count) return;", "c_tests"),
    ("bindings/c/answers.cpp", "std::erase(text, ' ');", "std::erase(text, '+');", "c_tests"),
    ("bindings/python/src/questions.cpp", "root_binary64(found.bound_squared(), Rounding::rd)",
     "root_binary64(found.bound_squared(), Rounding::ru)", "python"),
    ("cli/commands/depth.cpp", "*request.form.digits * 3322UL / 1000 + 4;", "*request.form.digits * 332UL / 1000 + 4;",
     "cli_transcript_shapes"),
    ("cli/io/output.cpp", "if (!names_.insert(name).second) refuse", "if (names_.count(name) > 2) refuse",
     "cli_transcript_certificate"),
]]


def problems():
    """The mutants whose text does not stand in its file exactly once, as sentences."""
    for number, mutant in enumerate(MUTANTS, 1):
        path = ROOT / mutant.path
        count = path.read_text().count(mutant.text) if path.is_file() else 0
        if count != 1:
            yield f"mutant {number}: {mutant.path} has {count} times: {mutant.text}"


def targets(test):
    """What a test needs built: programs of C++ tests are called as their tests."""
    if test.endswith("_tests"):
        return [test]
    if test == "python":
        return ["fathom", "fathom_python"]
    return ["fathom", "fathom-check"]


def fate(mutant, build):
    """Of the mutant, which is in the tree: `caught` by a test, `does not compile`, or `SURVIVED`."""
    for test in mutant.tests.split():
        made = subprocess.run(["cmake", "--build", build, "--target", *targets(test)], capture_output=True, text=True)
        if made.returncode:
            return "does not compile"
        ran = subprocess.run(["ctest", "--test-dir", build, "-R", f"^{test}$", "--no-tests=error", "--timeout", "1500"],
                             capture_output=True, text=True)
        if ran.returncode:
            return f"caught by {test}"
    return "SURVIVED"


def try_out(number, mutant, build):
    path = ROOT / mutant.path
    whole = path.read_text()
    began = time.monotonic()
    print(f"{number:>3}  {mutant.path}: {mutant.by}", end="", flush=True)
    try:
        path.write_text(whole.replace(mutant.text, mutant.by))
        found = fate(mutant, build)
    finally:
        path.write_text(whole)
    print(f"\n     {found}, {time.monotonic() - began:.0f} s", flush=True)
    return found


def chosen(words):
    for number, mutant in enumerate(MUTANTS, 1):
        if not words or any(word == str(number) or (not word.isdigit() and word in mutant.path) for word in words):
            yield number, mutant


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    given = parser.parse_args()
    found = list(problems())
    if found:
        print(*found, sep="\n")
        return 1
    if given.check:
        return 0
    mutants = list(chosen(given.which))
    if given.list:
        for number, mutant in mutants:
            print(f"{number:>3}  {mutant.path}: {mutant.text}  ->  {mutant.by}  [{mutant.tests}]")
        return 0
    dirty = subprocess.run(["git", "status", "--porcelain", "--untracked-files=no"], cwd=ROOT, capture_output=True, text=True)
    if not mutants or dirty.returncode or dirty.stdout:
        print("mutants.py: " + ("the tree is not clean" if mutants else "no mutant is called so"), file=sys.stderr)
        return 2
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(130))  # then too the file becomes what it was
    fates = {number: try_out(number, mutant, given.build) for number, mutant in mutants}
    survivors = [number for number, found in fates.items() if found == "SURVIVED"]
    caught = sum(found.startswith("caught") for found in fates.values())
    print(f"{caught} of {len(fates)} caught" + (f"; survivors: {', '.join(map(str, survivors))}" if survivors else ""))
    return 1 if caught < len(fates) else 0


if __name__ == "__main__":
    sys.exit(main())
