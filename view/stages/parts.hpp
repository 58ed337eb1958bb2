// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the stages that have files of their own. For stages_of alone.
#pragma once

#include <span>

#include "kernels/context.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {

/// The scale for bodies around `origin`, whose coordinates differ from it by at most `extent`.
StagedScale scale_of(const Point& origin, const mpq_class& extent);
/// A length, and one by its square, in the unit of places.
double scaled(const mpq_class& value, const StagedScale& scale);
double scaled_root(const mpq_class& squared, const StagedScale& scale);

/// From lattice and input to places.
class Placing {
 public:
  /// Of the points of both bodies.
  explicit Placing(const polytope::PlacedPair& pair);

  [[nodiscard]] const StagedScale& scale() const { return scale_; }
  /// The place of a lattice point; of a lattice vector, such as b - a: without the center.
  [[nodiscard]] Place point(const Vector& lattice) const;
  [[nodiscard]] Place vector(const Vector& lattice) const;
  /// The same of rational points and vectors in the unit of the input.
  [[nodiscard]] Place point(const Point& p) const;
  [[nodiscard]] Place vector(const Point& v) const;
  /// A length in the unit of the input, by its square.
  [[nodiscard]] double length(const mpq_class& squared) const;

 private:
  StagedScale scale_;
  const polytope::PlacedPair* pair_;
};

/// The unit vector in a direction that is not 0.
Place unit(const Vector& direction);

/// What the parts are made from. `exact` has hulls, diagrams, charts and canonical subsets whatever the status.
struct StagesSource {
  const Body &a, &b;
  const polytope::PlacedPair& pair;
  const depth::ExactStages& exact;
  const Placing& placing;
  kernels::Context& context;
};

// Each fills its fields of `stages`, in which those before it are filled.

/// a, b.
void add_bodies(const StagesSource& subject, Stages& stages);
/// contact, depth, squared, status.
void add_contact(const Depth& depth, const Placing& placing, Stages& stages);
/// charts.
void add_charts(const StagesSource& subject, Stages& stages);
/// pairs.
void add_pairs(const StagesSource& subject, Stages& stages);
/// winner, and its pair's closest lines, exactly.
void add_winner(const StagesSource& subject, const Depth& depth, Stages& stages);
/// cutting.
void add_cutting(const StagesSource& subject, Stages& stages);
/// sum.
void add_sum(const StagesSource& subject, Stages& stages);
/// coincidences, with decided_by; decided.
void add_coincidences(const StagesSource& subject, Stages& stages);
/// bounds.
void add_bounds(const StagesSource& subject, Stages& stages);

/// sum, of shapes: from the meshes of their outlines.
void add_sampled_sum(Stages& stages);
/// coincidences, of shapes: names and counts.
void add_shape_coincidences(const Shape& a, const Shape& b, const StageOptions& options, Stages& stages);

/// The stages of two bodies one of which is no polytope: outlines and contact.
Stages stages_of_shapes(const Body& a, const Body& b, const StageOptions& options);

}  // namespace fathom::stages
