// SPDX-License-Identifier: GPL-3.0-or-later
// One way down a hierarchy, level by level, with the highest vertex in a direction that may change on the way. For Hierarchy, and for
// searches that descend two hierarchies at once.                                                        [proofs/hierarchy.md]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/filters/planar_view.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::polytope {

/// Refers to the hierarchy, which must outlive it. Each step down takes a constant number of sign decisions.
class HierarchyDescent {
 public:
  explicit HierarchyDescent(const Hierarchy& hierarchy);

  /// The vertices of the coarsest level; all of them if there is but one level.
  [[nodiscard]] std::vector<std::uint32_t> coarsest() const;
  /// Starts at the coarsest level, with direction u, which must not be zero.
  void start(const Vector& u);

  [[nodiscard]] std::uint32_t highest() const;
  [[nodiscard]] bool at_finest() const { return level_ == 0; }
  /// Goes to the next finer level. Returns whether one of its vertices is strictly higher: then it is `highest`, and its last level is this
  /// one.
  bool step_down();
  /// Goes on with another direction, in which `highest`, new at this level, is still highest among the vertices of this level.
  void turn_to(const Vector& u);
  /// Returns the neighbours of `highest` at this level, if it is new at this level.
  [[nodiscard]] std::vector<std::uint32_t> neighbours() const;

  /// Rank 3, at the finest level: another highest vertex, adjacent to `highest`, if there is one.
  [[nodiscard]] const std::uint32_t* tied() const { return left_.level ? &left_.other : right_.level ? &right_.other : nullptr; }
  [[nodiscard]] const kernels::PlanarView& view() const { return *view_; }
  [[nodiscard]] Steps steps() const { return steps_; }

 private:
  /// An edge at the highest vertex. A level edge ends in another highest vertex: then it serves as left and as right.
  struct Side {
    std::uint32_t other = 0;  // the vertex at its other end
    std::uint32_t change = no_change;
    bool level = false;
  };

  kernels::Sign rise(std::uint32_t p, std::uint32_t q) { return ++steps_, view_->rise(p, q); }
  kernels::Sign turn(std::uint32_t p, std::uint32_t q) { return ++steps_, view_->turn(highest_, p, q); }
  bool climb(std::uint32_t v);
  void choose_sides();
  void collect(Side& s);
  bool hides(std::uint32_t apex, const Side& s, kernels::Sign sense);
  Side side_to(std::uint32_t apex);
  bool step_down_solid();
  bool step_down_polygon();

  const Hierarchy* hierarchy_;
  const Coarsening* c_;
  std::optional<kernels::PlanarView> view_;
  Steps steps_ = 0;
  std::uint32_t level_ = 0;
  std::uint32_t highest_ = 0;
  // Rank 3.
  Side left_, right_;
  std::array<std::uint32_t, 4> apexes_{};
  std::uint32_t count_ = 0;
  // Rank 2: level k holds every 2^k-th corner of the cycle; `highest` stands at this one.
  std::uint32_t position_ = 0;
};

}  // namespace fathom::polytope
