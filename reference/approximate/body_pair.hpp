// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies made ready for many rays: on one lattice, with the position of O, hulls and their
// hierarchies; and conversions from lattice
// units to results.  [AGHRS, section 3]
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/depth/apart.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {

/// Neither copied nor moved: hierarchies refer to hulls.
class BodyPair {
 public:
  /// Throws std::invalid_argument when a body is empty, and Interrupted.
  BodyPair(kernels::Context& context, std::span<const Point> a, std::span<const Point> b);
  BodyPair(const BodyPair&) = delete;
  BodyPair& operator=(const BodyPair&) = delete;

  [[nodiscard]] const polytope::PlacedPair& placed() const { return placed_; }
  [[nodiscard]] const BodyFacts& facts() const { return facts_; }
  /// nullopt if the bodies penetrate.
  [[nodiscard]] const std::optional<Separation>& separation() const { return separation_; }

  // The rest only if penetrating.

  [[nodiscard]] const polytope::Hierarchy& a() const { return solid_->hierarchy_a; }
  [[nodiscard]] const polytope::Hierarchy& b() const { return solid_->hierarchy_b; }
  /// factor * u, from the lattice's unit to that of the input.
  [[nodiscard]] Point translation(const mpq_class& factor, const Vector& u) const;
  /// The contact in direction n, the outward normal of a facet of P, and points a and b of it with
  /// b - a = t: nullopt if the faces moved by t do not meet.
  struct Meeting {
    Contact contact;
    std::optional<Witness> witness;
  };
  [[nodiscard]] Meeting meeting(const Vector& n, const Point& t) const;

 private:
  struct Solid {
    explicit Solid(depth::Hulls of_both) : hulls(std::move(of_both)), hierarchy_a(hulls.a), hierarchy_b(hulls.b) {}
    depth::Hulls hulls;
    polytope::Hierarchy hierarchy_a, hierarchy_b;
  };

  polytope::PlacedPair placed_;
  BodyFacts facts_;
  std::optional<Separation> separation_;
  std::unique_ptr<const Solid> solid_;
};

}  // namespace fathom
