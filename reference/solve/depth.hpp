// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies as points in any form, or on one lattice, and the options of
//         penetration_depth.
// Output  the answer by the method that they ask for; and where the answers of two methods differ.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/overlap.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/points.hpp"

namespace fathom::solve {

/// Throws std::invalid_argument if a body is of the plane, and says that `what` takes none.
inline void require_space(const Body& a, const Body& b, std::string_view what) {
  if (a.dimension == 2 || b.dimension == 2)
    throw std::invalid_argument(std::string(what) + " takes bodies of space, found a body of the plane");
}

/// How many points an expanding polytope may take, of bodies with so many together. Exhausting the
/// usual budget costs about one exact run.
std::size_t expansion_budget(const Options& options, std::size_t points);

/// Resets the counters of `context` first.
Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options);

/// What the search on a narrow lattice has come to; nothing if there is none, or the method does
/// not ask for it.
struct NarrowResult {
  std::optional<Depth> depth;
  /// Else the lattice on which the expanding polytope gave up: it would do so on any.
  std::optional<polytope::PlacedPair> pair;
};

/// The answer of method `certificate`, in integers of fixed size, if place_narrow places the bodies
/// and the expanding polytope ends. It equals that of depth_by_method, its naive twin, in every
/// field.
NarrowResult depth_on_narrow_lattice(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                                     const Options& options);

/// What penetration_depth says of two bodies, and the lattice on which it found the answer.
struct PlacedDepth {
  Depth depth;
  /// Both bodies on one lattice. Not set if a narrow one gave the answer, nor if the bodies'
  /// denominators share so little that deciding points did.
  std::optional<polytope::PlacedPair> pair;
};

/// Throws as penetration_depth does.
PlacedDepth placed_depth(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                         const Options& options);

/// What overlap and closer_than say of two polytopes; nullopt if the denominators of their points
/// share so little that a lattice of both would be long. Throw as they do.
std::optional<Overlap> overlap_of_points(const polytope::Points& a, const polytope::Points& b,
                                         const OverlapOptions& options);
std::optional<Closeness> closeness_of_points(const polytope::Points& a, const polytope::Points& b,
                                             const mpq_class& distance, const OverlapOptions& options);

// For bodies whose denominators share little: over a common denominator every coordinate would be
// as long as all of them together, but few points decide the answer.
//                                                              [proofs/depth.md, "Deciding points"]

/// Returns the answer for all points. It equals that of depth_by_method, except that extreme points
/// are not counted, that counters are those of the deciding points, and that it may be another one
/// where several are right (the inner polytope; the nearest points of parallel faces; direction and
/// common point of touching bodies). Returns nullopt if more than half of all points would decide.
std::optional<Depth> depth_by_deciding_points(kernels::Context& context, polytope::Positions a, polytope::Positions b,
                                              const Options& options);

/// Returns the indices of all points of a non-empty body that maximise <u, p>, ascending. Exact,
/// for any denominators.
std::vector<std::uint32_t> extreme_points(polytope::Positions body, const Vector& u);

/// Returns the first field in which the answers differ, with both values, as "optima[0].direction:
/// (1, 0, 0) and (0, 1, 0)"; nullopt if they agree. Compared is every field that must not depend on
/// the method: all but `inner`, `method`, the numbers of extreme points and the counters.
std::optional<std::string> disagreement(const Depth& x, const Depth& y);

/// Returns the method of that name which can answer beside automatic, to compare with: exact or
/// naive; nullopt for other words.
std::optional<Method> second_method(std::string_view word);

}  // namespace fathom::solve
