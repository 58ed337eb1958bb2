// SPDX-License-Identifier: GPL-3.0-or-later
// Where bodies are, without their depth. A polytope Q grows inside P only until O lies in it, or
// below no facet of P, on a narrow lattice. What is left open, and every proof, the exact searches
// find, which share nothing with it.            [proofs/expanding.md, "O in Q"; proofs/position.md]
#include "fathom/overlap.hpp"

#include <stdexcept>
#include <utility>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/contact.hpp"
#include "reference/expanding/expander.hpp"  // what a Workspace holds
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/narrow_lattice.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {
namespace {

using polytope::Position;

/// What a narrow lattice shows: where the bodies are, and of those that are apart a plane between
/// them, whose distance from O the bodies' distance is at least.
struct Seen {
  Status status;
  mpq_class least_square = 0;  ///< of that distance
};

/// nullopt if it leaves open where they are, or there is no such lattice.
std::optional<Seen> seen_on_narrow_lattice(kernels::Context& context, const polytope::Points& a,
                                           const polytope::Points& b, Workspace& workspace, bool measured) {
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.pair)) return std::nullopt;
  return polytope::with_narrow_bodies(parts.pair, a, b, parts.scan, [&](const auto& bodies) -> std::optional<Seen> {
    const expanding::OriginExpansion found = expanding::locate_origin(context, bodies, &workspace, measured);
    if (found.end == expanding::ExpansionEnd::proved) return Seen{Status::penetrating};
    if (found.side >= 0) return std::nullopt;
    Seen seen{Status::disjoint};
    if (measured) {
      const mpq_class unit = bodies.unit();
      seen.least_square = kernels::ratio(found.height * found.height, dot(found.normal, found.normal)) * unit * unit;
    }
    return seen;
  });
}

polytope::PlacedPair placed(kernels::Context& context, const Body& a, const Body& b) {
  return polytope::place(a.points.exact(), b.points.exact(), &context);
}

/// How the depth is found of bodies whose denominators share little: a lattice of both would be
/// long.
Options by_depth(const OverlapOptions& options, Workspace& workspace) {
  Options result;
  result.monitor = options.monitor;
  result.workspace = &workspace;
  return result;
}

Overlap exact_overlap(const polytope::PlacedPair& pair) {
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
  const Status status = origin.position == Position::inside     ? Status::penetrating
                        : origin.position == Position::boundary ? Status::touching
                                                                : Status::disjoint;
  OverlapProof proof{origin.normal, std::nullopt, origin.surrounding};
  if (status != Status::disjoint) proof.common = depth::combination(pair, pair.a.points(), origin.a);
  return {status, std::move(proof)};
}

/// The points of bodies that are apart are nearest ones.
Closeness exact_closeness(const polytope::PlacedPair& pair, const mpq_class& distance) {
  const Overlap where = exact_overlap(pair);
  if (where.status != Status::disjoint)
    return {true, ClosenessProof{Witness{*where.proof->common, *where.proof->common}, {}}};
  const polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
  const mpq_class square =
      kernels::ratio(nearest.height * nearest.height, dot(nearest.normal, nearest.normal)) * pair.unit() * pair.unit();
  if (square >= distance * distance) return {false, ClosenessProof{{}, nearest.normal}};
  return {true, ClosenessProof{Witness{depth::combination(pair, pair.a.points(), nearest.a),
                                       depth::combination(pair, pair.b.points(), nearest.b)},
                               {}}};
}

bool polytopes(const Body& a, const Body& b) { return !a.shape && !a.pieces && !b.shape && !b.pieces; }

/// The answer about bodies that are not both polytopes.
Answer whole_answer(const Body& a, const Body& b, const OverlapOptions& options) {
  if (options.proof)
    throw std::invalid_argument("a proof of overlap is of polytopes; the certificate of the depth proves it of others");
  Question question;
  question.options.monitor = options.monitor;
  question.options.workspace = options.workspace;
  question.bits = options.bits;
  question.union_bounds = false;
  return exact_answer(a, b, question);
}

/// Calls f with the workspace of the caller, or one of its own.
template <class F>
auto with_workspace(const OverlapOptions& options, F f) {
  if (options.workspace != nullptr) return f(*options.workspace);
  Workspace own;
  return f(own);
}

}  // namespace

Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options) {
  if (!polytopes(a, b)) return {whole_answer(a, b, options).status(), std::nullopt};
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  if (options.proof) return exact_overlap(placed(context, a, b));
  return with_workspace(options, [&](Workspace& workspace) {
    if (const auto seen = seen_on_narrow_lattice(context, a.points, b.points, workspace, false))
      return Overlap{seen->status, std::nullopt};
    if (const auto pair = polytope::place_if_slim(a.points.exact(), b.points.exact(), &context))
      return Overlap{exact_overlap(*pair).status, std::nullopt};
    return Overlap{penetration_depth(a, b, by_depth(options, workspace)).status(), std::nullopt};
  });
}

Closeness closer_than(const Body& a, const Body& b, const mpq_class& distance, const OverlapOptions& options) {
  if (!kernels::in_lowest_terms(distance) || distance <= 0)
    throw std::invalid_argument("expected a distance above 0, in lowest terms");
  const mpq_class square = distance * distance;
  if (!polytopes(a, b)) {
    const Answer answer = whole_answer(a, b, options);
    const mpq_class farthest = -distance;  // the signed depth of closer bodies is above it
    if (compare(answer.low(), farthest) > 0) return {true, std::nullopt};
    if (compare(answer.high(), farthest) <= 0) return {false, std::nullopt};
    return {std::nullopt, std::nullopt};
  }
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  if (options.proof) return exact_closeness(placed(context, a, b), distance);
  return with_workspace(options, [&](Workspace& workspace) {
    const auto seen = seen_on_narrow_lattice(context, a.points, b.points, workspace, true);
    if (seen && seen->status != Status::disjoint) return Closeness{true, std::nullopt};
    if (seen && seen->least_square >= square) return Closeness{false, std::nullopt};
    if (const auto pair = polytope::place_if_slim(a.points.exact(), b.points.exact(), &context))
      return Closeness{exact_closeness(*pair, distance).closer, std::nullopt};
    return Closeness{signed_square(penetration_depth(a, b, by_depth(options, workspace))) > -square, std::nullopt};
  });
}

}  // namespace fathom
