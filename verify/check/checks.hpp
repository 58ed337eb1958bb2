// SPDX-License-Identifier: Apache-2.0
// The checks of FORMAT.md, sections 4 and 12 to 17. Each returns if all is proved and throws a
// Fault otherwise.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "certificate.hpp"
#include "limits.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

namespace fathom_check {

/// A bound of h(n)/|n|, squared with its sign, in the units of the scaled points, in lowest terms.
struct Bound {
  mpz_class num, den;
};

/// All of it: the claim of `certificate` is proved by its parts.
void check_claim(const Certificate& certificate, Arithmetic arithmetic = Arithmetic::fixed_where_it_fits);

/// The upper side (section 5): each direction's height compared as the claim demands. If a core is
/// a half-space, the lower side too.
void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& low, const Bound& high);

/// The sum of weight * point, over a common denominator of the weights.
struct Combination {
  MutableVector sum;
  mpz_class den = 1;
};
/// Throws Fault (refused, on `line`) unless the weights are positive, of points that exist, and sum
/// to 1.
Combination convex_combination(const Weight* begin, const Weight* end, const Points& points, std::size_t line);

/// The weights are convex, and yield points of A and of B that are so near to each other that
/// h(n)/|n| is at least `low`.
void check_weights(const Certificate& certificate, const Points& a, const Points& b, const Bound& low);

/// <normal, x> = c: the plane of a facet, whose normal points outward.
struct Plane {
  Vector normal;
  Integer c;
};

/// Returns the vertices from number `first` to `last`, as differences of these points; their digits
/// lie in `integers`.
std::vector<Vector> differences(const Part<std::vector<Pair>>& vertices, std::size_t first, std::size_t last,
                                const Points& a, const Points& b, Arena& integers);

/// The facets of a polytope: those from number `first` to `last`, which `line` announces.
struct FacetRange {
  const Part<Facets>* part;
  std::size_t first, last, line;
};

/// Is called with each facet that is exactly as near to O as the polytope claims.
using NearestFacet = std::function<void(std::size_t line, const MutableVector& normal)>;

/// The inner polytope of these vertices: it holds a ball of squared radius `squared` around O.
/// Returns the planes of its facets, whose digits lie in `integers`.
std::vector<Plane> check_polytope(const std::vector<Vector>& vertices, const FacetRange& facets, const Bound& squared,
                                  const NearestFacet& nearest, Arena& integers, const Units& units = {});

/// The inner polytope holds a ball of squared radius `squared` around O; with `all`, no direction
/// is missing.
void check_inner(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

/// No vector has h = 0 but those of the cone.
void check_cone(const Certificate& certificate, const Scaled& bodies);

/// Section 13: each patch is the hull of its corners, and the rates follow.
void check_patches(const Certificate& certificate, const Scaled& bodies);

/// Section 14: the pieces of this solid tile what its mesh encloses.
void check_solid(const Body& body);

/// Section 15, once it is known that the number of the claim is positive. `low` is that of the
/// claim, negative if they are apart.
void check_two_bodies(const Certificate& certificate, const Bound& low);

/// Section 17: the bodies are apart where the claim says so, and meet where it does.
void check_motions(const Certificate& certificate, Arithmetic arithmetic);

/// Section 12, once it is known that the number of the claim is positive.
void check_unions(const Certificate& certificate, const Scaled& bodies, const Bound& low);

// What a certificate proves, if it is accepted.

mpq_class value(const Rational& r);

/// The sum of both radii.
mpq_class radii(const Certificate& certificate);

/// "penetrating", "touching", "disjoint", or, for bounds that leave it open, "undecided": of the
/// bodies, radii included.
const char* status(const Certificate& certificate);

/// Whether the signed depth is sqrt(|c|) + radii, the root with the sign of c, and not just within
/// bounds; if so, c.
bool is_exact(const Certificate& certificate);
mpq_class squared_of_cores(const Certificate& certificate);

// The checks of unions, one by one.                                 [FORMAT.md, sections 12 and 15]

/// Throws Fault (refused, on `line`) unless A has a piece i, and B a piece j.
void require_pieces(const Certificate& certificate, std::size_t i, std::size_t j, std::size_t line);

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

/// The x with <n,x> >= c.
struct Constraint {
  MutableVector n;
  mpz_class c;
};

/// The sum of multiples >= 0 of the constraints, at most four, that the adjugate of their Gram
/// matrix yields. Returns nullopt if it yields none, or a negative multiplier. Positive multiples
/// of the constraints yield a positive multiple of the same.
std::optional<Constraint> combined(const std::vector<Constraint>& constraints);

/// The tree leaves no place for another optimum, nor for a nearer one. `squared` is q in the units
/// of the scaled points; `work`, of format 5, may be absent.
void check_tree(const Certificate& certificate, const std::vector<Plane>& facets, const Bound& squared,
                WorkOfTree* work = nullptr);

}  // namespace fathom_check
