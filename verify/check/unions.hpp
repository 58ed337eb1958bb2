// SPDX-License-Identifier: Apache-2.0
// The checks of unions, one by one.                                 [FORMAT.md, sections 12 and 15]
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "certificate.hpp"
#include "checks.hpp"
#include "limits.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

namespace fathom_check {

/// The points of piece `number`.
Points piece(const Body& body, const ScaledBody& scaled, std::size_t number);

/// Whether some four of these points, of which there may be none, do not lie in one plane.
template <class Point>
bool has_interior(const Point* begin, const Point* end) {
  MutableVector edge, other, normal;
  mpz_class height;
  for (const Point* p = begin; p != end; ++p) {
    subtract(other, *p, *begin);
    if (is_zero(edge)) {
      std::swap(edge, other);
    } else if (is_zero(normal)) {
      cross(normal, edge, other);
    } else {
      dot(height, normal, other);
      if (height != 0) return true;
    }
  }
  return false;
}

/// Whether a vector separates. `low` is -q of a claim of apart, in the units of the heights.
class Separation {
 public:
  Separation(const Certificate& certificate, const Bound& low) : c_(&certificate), low_(&low) {}

  /// With the largest <u,x> of the differences x of pieces, num / den, for the place t / den_t.
  /// Throws Fault (refused, on `line`) unless it shows what the claim demands.
  void check(const Vector& u, const mpz_class& num, const mpz_class& den, const MutableVector& t,
             const mpz_class& den_t, std::size_t line);

 private:
  const Certificate* c_;
  const Bound* low_;
  mpz_class reached_, needed_;
};

/// Is called with each optimum, by its number, that is t / den: it must be separated from all
/// interiors.
using CheckApart = std::function<void(std::size_t optimum, const MutableVector& t, const mpz_class& den)>;

/// The optima ascend, their squares are q, and each is apart.
void check_optima(const Certificate& certificate, const CheckApart& check_apart);

/// Every polytope is inside the differences of its pieces. Returns the planes of all facets, for
/// primitive normals, in the units of the scaled points; their digits lie in `integers`.
std::vector<Plane> check_polytopes(const Certificate& certificate, const Scaled& bodies, Arena& integers);

/// The tree leaves no place for another optimum, nor for a nearer one. `squared` is q in the units
/// of the scaled points; `work`, of format 5, may be absent.
void check_tree(const Certificate& certificate, const std::vector<Plane>& facets, const Bound& squared,
                WorkOfTree* work = nullptr);

}  // namespace fathom_check
