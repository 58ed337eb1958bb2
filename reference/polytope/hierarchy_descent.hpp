// SPDX-License-Identifier: GPL-3.0-or-later
// One way down a hierarchy, level by level, with the highest vertex in a direction that may change on the way. For Hierarchy, and for
// searches that descend two hierarchies at once.                                                        [proofs/hierarchy.md]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/filters/support.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::polytope {

/// Refers to the hierarchy, which must outlive it. Each step down takes a constant number of sign decisions.
class HierarchyDescent {
 public:
  explicit HierarchyDescent(const Hierarchy& hierarchy);

  /// The vertices of the coarsest level; all of them if there is but one level.
  [[nodiscard]] std::vector<VertexId> coarsest() const;
  /// Starts at the coarsest level, with direction u, which must not be zero.
  void start(const Vector& u);

  [[nodiscard]] VertexId highest() const;
  [[nodiscard]] bool at_finest() const { return level_ == 0; }
  /// Goes to the next finer level. Returns whether one of its vertices is strictly higher: then it is `highest`, and its last level is this
  /// one.
  bool step_down();
  /// Goes on with another direction, in which `highest`, new at this level, is still highest among the vertices of this level.
  void turn_to(const Vector& u);
  /// Returns the neighbours of `highest` at this level, if it is new at this level.
  [[nodiscard]] std::vector<VertexId> neighbours() const;

  /// Rank 3, at the finest level: another highest vertex, adjacent to `highest`, if there is one.
  [[nodiscard]] const VertexId* tied() const { return left_.level ? &left_.other : right_.level ? &right_.other : nullptr; }
  /// The sign of <u, v - highest>: positive if v is higher. One step.
  kernels::Sign rise(VertexId v) { return ++steps_, view_->rise(highest_.value, v.value); }
  [[nodiscard]] Steps steps() const { return steps_; }

 private:
  /// An edge at the highest vertex. A level edge ends in another highest vertex: then it serves as left and as right.
  struct Side {
    VertexId other;  // the vertex at its other end
    std::uint32_t change = no_change;
    bool level = false;
  };

  kernels::Sign turn(VertexId p, VertexId q) { return ++steps_, view_->turn(highest_.value, p.value, q.value); }
  bool climb(VertexId v);
  void choose_sides();
  void collect(Side& s);
  bool hides(VertexId apex, const Side& s, kernels::Sign sense);
  Side side_to(VertexId apex);
  bool step_down_solid();
  bool step_down_polygon();

  const Hierarchy* hierarchy_;
  const Coarsening* c_;
  std::optional<kernels::PlanarView> view_;
  Steps steps_ = 0;
  std::uint32_t level_ = 0;
  VertexId highest_;
  // Rank 3.
  Side left_, right_;
  std::array<VertexId, 4> apexes_{};
  std::uint32_t count_ = 0;
  // Rank 2: level k holds every 2^k-th corner of the cycle; `highest` stands at this one.
  std::uint32_t position_ = 0;
};

}  // namespace fathom::polytope
