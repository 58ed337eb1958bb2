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
#include "reference/depth/apart.hpp"
#include "reference/expanding/expander.hpp"  // what a Workspace holds
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solve/depth.hpp"

namespace fathom {
namespace {

using polytope::Position;

/// The square of |height| / |normal|, of a plane in units of a lattice.
mpq_class square_of(const Vector& normal, const mpz_class& height, const mpq_class& unit) {
  return kernels::ratio(height * height, dot(normal, normal)) * unit * unit;
}

Status status_of(const polytope::PositionOfOrigin& origin) {
  switch (origin.position) {
    case Position::inside: return Status::penetrating;
    case Position::boundary: return Status::touching;
    case Position::outside: return Status::disjoint;
  }
  throw std::logic_error("a position that is none");
}

/// Where bodies are, and what is known of their distance if they are apart: in units of the input,
/// and at least as much as was asked for unless it is the distance itself.
struct Seen {
  Status status;
  mpq_class square = 0;
};

/// What a narrow lattice shows; nullopt if there is none. `asked` is a squared distance.
std::optional<Seen> seen_on_narrow_lattice(kernels::Context& context, const polytope::Points& a,
                                           const polytope::Points& b, Workspace* given,
                                           const std::optional<mpq_class>& asked) {
  std::optional<Workspace> own;
  Workspace& workspace = given != nullptr ? *given : own.emplace();
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.placed)) return std::nullopt;
  std::optional<Status> status;  // none if the growing polytope leaves it open
  mpq_class square;
  polytope::with_pair(parts.placed, a, b, parts.scan, [&](const auto& pair) {
    const expanding::OriginExpansion found = expanding::locate_origin(context, pair, &workspace, asked.has_value());
    if (found.end == expanding::ExpansionEnd::proved) status = Status::penetrating;
    if (found.side < 0) status = Status::disjoint;
    if (found.side < 0 && asked) square = square_of(found.normal, found.height, pair.unit());
  });
  if (status == Status::penetrating) return Seen{*status};
  polytope::with_searched_pair(parts.placed, a, b, parts.scan, [&](const auto& pair) {
    if (!status) status = status_of(polytope::position_of_origin(pair.differences()));
    if (status != Status::disjoint || !asked || square >= *asked) return;
    const polytope::NearestPoints nearest = polytope::nearest_points(pair.differences());
    square = square_of(nearest.normal, nearest.height, pair.unit());
  });
  return Seen{*status, std::move(square)};
}

/// With their proofs.
Overlap proved_overlap(const polytope::PlacedPair& pair) {
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
  OverlapProof proof{origin.normal, std::nullopt, origin.surrounding};
  if (origin.position != Position::outside)
    proof.common = depth::combination(origin.a, [&](std::size_t i) { return pair.point_of_a(i).exact(); });
  return {status_of(origin), std::move(proof)};
}

/// The points of bodies that are apart are nearest ones.
Closeness proved_closeness(const polytope::PlacedPair& pair, const mpq_class& distance) {
  const Overlap where = proved_overlap(pair);
  if (where.status != Status::disjoint)
    return {true, ClosenessProof{Witness{*where.proof->common, *where.proof->common}, {}}};
  const polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
  if (square_of(nearest.normal, nearest.height, pair.unit()) >= distance * distance)
    return {false, ClosenessProof{{}, nearest.normal}};
  return {true, ClosenessProof{depth::distance(pair, nearest).witness, {}}};
}

/// Whether both are polytopes. Throws std::invalid_argument if they are not, and a proof is asked
/// for.
bool polytopes(const Body& a, const Body& b, const OverlapOptions& options) {
  const bool in_space = a.dimension == 3 && b.dimension == 3;
  const bool both = in_space && !a.shape && !a.pieces && !b.shape && !b.pieces;
  if (options.proof && !both)
    throw std::invalid_argument(
        "a proof of overlap is of polytopes in space; the certificate of the depth proves it of others");
  return both;
}

void require_distance(const mpq_class& distance) {
  if (!kernels::in_lowest_terms(distance) || distance <= 0)
    throw std::invalid_argument("expected a distance above 0, in lowest terms");
}

/// Of bodies of other kinds, and of polytopes whose denominators share little: a lattice of both
/// would be long.
Answer by_depth(const Body& a, const Body& b, const OverlapOptions& options) {
  Question question;
  question.options.monitor = options.monitor;
  question.options.workspace = options.workspace;
  question.bits = options.bits;
  question.union_bounds = false;
  return exact_answer(a, b, question);
}

}  // namespace

std::optional<Overlap> solve::overlap_of_points(const polytope::Points& a, const polytope::Points& b,
                                                const OverlapOptions& options) {
  kernels::Context context(options.monitor);
  std::vector<Point> room_a, room_b;
  if (options.proof) return proved_overlap(polytope::place(a.exact(room_a), b.exact(room_b), &context));
  if (const auto seen = seen_on_narrow_lattice(context, a, b, options.workspace, std::nullopt))
    return Overlap{seen->status, std::nullopt};
  if (const auto pair = polytope::place_if_slim(a.exact(room_a), b.exact(room_b), &context))
    return Overlap{status_of(polytope::position_of_origin(pair->a, pair->b)), std::nullopt};
  return std::nullopt;
}

std::optional<Closeness> solve::closeness_of_points(const polytope::Points& a, const polytope::Points& b,
                                                    const mpq_class& distance, const OverlapOptions& options) {
  require_distance(distance);
  kernels::Context context(options.monitor);
  std::vector<Point> room_a, room_b;
  if (options.proof) return proved_closeness(polytope::place(a.exact(room_a), b.exact(room_b), &context), distance);
  const mpq_class square = distance * distance;
  if (const auto seen = seen_on_narrow_lattice(context, a, b, options.workspace, square))
    return Closeness{seen->status != Status::disjoint || seen->square < square, std::nullopt};
  const auto pair = polytope::place_if_slim(a.exact(room_a), b.exact(room_b), &context);
  if (!pair) return std::nullopt;
  if (polytope::position_of_origin(pair->a, pair->b).position != Position::outside)
    return Closeness{true, std::nullopt};
  const polytope::NearestPoints nearest = polytope::nearest_points(pair->a, pair->b);
  return Closeness{square_of(nearest.normal, nearest.height, pair->unit()) < square, std::nullopt};
}

Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  if (polytopes(a, b, options))
    if (const auto found = solve::overlap_of_points(a.points, b.points, options)) return *found;
  return {by_depth(a, b, options).status(), std::nullopt};
}

Closeness closer_than(const Body& a, const Body& b, const mpq_class& distance, const OverlapOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  if (polytopes(a, b, options)) {
    if (const auto found = solve::closeness_of_points(a.points, b.points, distance, options)) return *found;
  } else {
    require_distance(distance);
  }
  const Answer answer = by_depth(a, b, options);
  const mpq_class farthest = -distance;  // the signed depth of closer bodies is above it
  if (compare(answer.low(), farthest) > 0) return {true, std::nullopt};
  if (compare(answer.high(), farthest) <= 0) return {false, std::nullopt};
  return {};
}

}  // namespace fathom
