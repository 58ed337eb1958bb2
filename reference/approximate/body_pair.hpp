// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies made ready for many rays: lattice, position of O, hulls and their hierarchies; and the way back from the lattice to what
// results say.                                                                                                 [AGHRS, section 3]
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "kernels/filters/support.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/depth.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {

/// Called now and then with the stage's name and the share of it that is done, in [0, 1]. Returns false to stop.
using ReportProgress = std::function<bool(const std::string& stage, double share)>;

/// A callback that may be absent, as a call. Throws Interrupted when it asks to stop.
void report(const ReportProgress& progress, const char* stage, double share = 0);

/// Neither copied nor moved: hierarchies refer to hulls.
class BodyPair {
 public:
  /// Throws std::invalid_argument when a body is empty, and Interrupted.
  BodyPair(std::span<const Point> a, std::span<const Point> b, const ReportProgress& progress = {});
  BodyPair(const BodyPair&) = delete;
  BodyPair& operator=(const BodyPair&) = delete;

  [[nodiscard]] Status status() const { return status_; }
  /// Not penetrating: a primitive u with h(u) <= 0.
  [[nodiscard]] const std::optional<Vector>& separating() const { return separating_; }
  [[nodiscard]] bool flat_a() const { return flat_a_; }
  [[nodiscard]] bool flat_b() const { return flat_b_; }
  [[nodiscard]] const Lattice& lattice() const { return lattice_; }

  // The rest only if penetrating.

  [[nodiscard]] const Hierarchy& a() const { return solid_->hierarchy_a; }
  [[nodiscard]] const Hierarchy& b() const { return solid_->hierarchy_b; }
  /// factor * u, from the lattice's unit to that of the input.
  [[nodiscard]] Point translation(const mpq_class& factor, const Vector& u) const;
  /// The contact in direction n, the outward normal of a facet of P.
  [[nodiscard]] Contact contact(const Vector& n) const;
  /// Points a and b of the faces in direction n with b - a = t; none if the faces moved by t do not meet.
  [[nodiscard]] std::optional<Witness> witness(const Vector& n, const Point& t) const;

 private:
  struct Solid {
    Solid(const Lattice& lattice, long exponent, const ReportProgress& progress);
    Polytope hull_a, hull_b;
    Hierarchy hierarchy_a, hierarchy_b;
    Bodies bodies;
  };

  Lattice lattice_;
  Status status_ = Status::disjoint;
  std::optional<Vector> separating_;
  bool flat_a_ = false, flat_b_ = false;
  std::unique_ptr<const Solid> solid_;
};

}  // namespace fathom
