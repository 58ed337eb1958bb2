// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of this room: places for pixels, and the parts of the stages that are too long
// for stages.cpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "kernels/context.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {

/// What the stages of bodies of the plane leave out.
inline constexpr const char* only_what_happens =
    "Of bodies of the plane the page has this section alone: the others are about bodies of space.";

/// Returns the scale for bodies around `origin`, whose coordinates differ from it by at most
/// `extent`.
StagedScale scale_of(const Point& origin, const mpq_class& extent);
/// Returns a length in the unit of places.
double scaled(const mpq_class& value, const StagedScale& scale);

/// The map from lattice and input to places.
class Placing {
 public:
  /// Uses the points of both bodies.
  explicit Placing(const polytope::PlacedPair& pair);

  [[nodiscard]] const StagedScale& scale() const { return scale_; }
  /// Return the place of a lattice point; and of a lattice vector, such as b - a: without the
  /// center.
  [[nodiscard]] Place point(const Vector& lattice) const;
  [[nodiscard]] Place vector(const Vector& lattice) const;
  /// Return the same for rational points and vectors in the unit of the input.
  [[nodiscard]] Place point(const Point& p) const;
  [[nodiscard]] Place vector(const Point& v) const;
  /// Returns a length, given by its square in the unit of the input.
  [[nodiscard]] double length(const mpq_class& squared) const;

 private:
  StagedScale scale_;
  const polytope::PlacedPair* pair_;
};

/// Returns the unit vector in a direction that is not 0.
Place unit(const Vector& direction);

/// Returns a multiple without -0: a coordinate may be 0.
inline Place times(double c, const Place& p) { return {c * p[0] + 0.0, c * p[1] + 0.0, c * p[2] + 0.0}; }

/// The input of the parts. `exact` has hulls, diagrams, charts and canonical subsets for any
/// status.
struct StagesSource {
  const Body &a, &b;
  const polytope::PlacedPair& pair;
  const depth::ExactStages& exact;
  const Placing& placing;
  kernels::Context& context;
  const StageOptions& options;
};

// Each function sets fields of `stages`, and needs those that precede them.

/// Sets pairs.
void add_pairs(const StagesSource& subject, Stages& stages);
/// Sets winner, and the exact closest lines of its pair.
void add_winner(const StagesSource& subject, const Depth& depth, Stages& stages);
/// Sets cutting.
void add_cutting(const StagesSource& subject, Stages& stages);
/// Sets sum.
void add_sum(const StagesSource& subject, Stages& stages);
/// Sets coincidences, with decided_by.
void add_coincidences(const StagesSource& subject, Stages& stages);
/// Sets decided.
void add_decided(const PredicateCounts& counts, Stages& stages);
/// Returns the kinds that occur, with their listed coincidences, without decided_by.
std::vector<StagedCoincidence> staged(const std::array<Coincidences, coincidence_names.size()>& found);
/// Returns the stages of two bodies one of which is no polytope: outlines and contact.
Stages stages_of_shapes(const Body& a, const Body& b, const StageOptions& options);
/// Sets the scale, the outlines and the contact. `dimension`: 2 of bodies of the plane.
void add_outlines(const Body& a, const Body& b, const SignedDepth& depth, unsigned dimension, Stages& stages);

// Input   the exact method's stages for bodies that penetrate.
// Output  every facet of P = B (+) (-A), with the features of both bodies that make it. The
//         directions are those of nodes and of crossings;
//         crossings of the perturbed arcs are those of the arcs themselves, or lie at a node.
//                                                             [AGHRS, section 2.2; proofs/depth.md]
// Size    at most the number of nodes and crossings.

/// A vertex of A and one of B: the corner b - a of P.
struct SumCorner {
  polytope::VertexId a, b;
  friend auto operator<=>(const SumCorner&, const SumCorner&) = default;
};

/// A facet of P, exactly.
struct ExactSumFacet {
  Vector normal;                         ///< outward, primitive
  mpz_class height;                      ///< h(normal) in the unit of the lattice
  std::vector<SumCorner> corners;        ///< counter-clockwise from outside, none on a line with its neighbours
  std::vector<polytope::VertexId> a, b;  ///< the faces of A and B: extreme points, ascending
  /// Canonical pairs with a crossing in this direction, ascending; those of the lower chart after
  /// those of the upper.
  Indices pairs;
};

/// Returns all facets in the order of their normals, or nullopt if there are more than `most`, or
/// far more crossings than that.
std::optional<std::vector<ExactSumFacet>> sum_facets(const depth::ExactStages& exact, std::size_t most);

}  // namespace fathom::stages
