// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of bodies by their definition: exact integers, one pass over all points, no hull of a body
// and no filter. Contacts and witnesses of records are proved by them, independently of the answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::golden {

/// All points of both bodies as multiples of 1 / denominator.
struct Integers {
  mpz_class denominator = 1;  ///< positive
  std::vector<Vector> a, b;
};

Integers integers_of(std::span<const Point> a, std::span<const Point> b);

/// The face of a body in a direction.
struct SupportingFace {
  mpz_class height;                    ///< max <n,p>
  std::vector<std::uint32_t> corners;  ///< indices of its extreme points, ascending; of equal points the lowest
  std::vector<Vector> cycle;           ///< their positions: one, two, or a convex polygon in cyclic order
};

/// n is not zero, `points` not empty.
SupportingFace face_in_direction(std::span<const Vector> points, const Vector& n);

/// Whether the point p, whose unit is 1, lies in the face of points whose unit is 1 / denominator.
bool contains(const SupportingFace& face, const Vector& n, const mpz_class& denominator, const Point& p);

}  // namespace fathom::golden
