// SPDX-License-Identifier: Apache-2.0
// Polytopes inside the differences of two pieces.
#include "budget.hpp"
#include "unions.hpp"

namespace fathom_check {
namespace {

/// The vertices, less their mean, times their number.
std::vector<Vector> around_the_mean(const std::vector<Vector>& vertices, Arena& integers) {
  MutableVector sum;
  for (const Vector& v : vertices) add(sum, copied(v));
  std::vector<Vector> result;
  result.reserve(vertices.size());
  const mpz_class count = static_cast<unsigned long>(vertices.size());
  MutableVector moved;
  for (const Vector& v : vertices) {
    const auto move = [&count](mpz_class& to, const Integer& from, const mpz_class& of_sum) {
      mpz_mul(to.get_mpz_t(), from.get_mpz_t(), count.get_mpz_t());
      to -= of_sum;
    };
    move(moved.x, v.x, sum.x);
    move(moved.y, v.y, sum.y);
    move(moved.z, v.z, sum.z);
    result.push_back(kept(integers, moved));
  }
  return result;
}

/// The same plane where the vertices were, for a primitive normal.
Plane moved_back(const Plane& plane, const Vector& corner, Arena& integers) {
  MutableVector normal = copied(plane.normal);
  mpz_class c;
  find_gcd(c, normal);
  divide(normal, c);
  dot(c, normal, corner);
  return {kept(integers, normal), integers.keep(c)};
}

}  // namespace

std::vector<Plane> check_polytopes(const Certificate& c, const Scaled& bodies, Arena& integers) {
  std::vector<Plane> result;
  result.reserve(c.facets.items.size());
  List vertices{0, 0}, facets{0, 0};  // of the polytope before
  for (const InnerPolytope& polytope : c.of_unions.polytopes) {
    if (polytope.i >= c.a.pieces.size()) throw refused(polytope.line, "a has no piece of this number");
    if (polytope.j >= c.b.pieces.size()) throw refused(polytope.line, "b has no piece of this number");
    Arena here;
    const std::vector<Vector> corners =
        differences(c.vertices, vertices.end, polytope.vertices.end, piece(c.a, bodies.a, polytope.i),
                    piece(c.b, bodies.b, polytope.j), here);
    const FacetRange range{&c.facets, facets.end, polytope.facets.end, polytope.facets.line};
    const std::vector<Plane> planes = check_polytope(around_the_mean(corners, here), range, {0, 1}, {}, here);
    for (std::size_t f = 0; f < planes.size(); ++f) {
      const std::uint32_t first = c.facets.items.corners[c.facets.items.begin_of(range.first + f)];
      result.push_back(moved_back(planes[f], corners[first], integers));
    }
    vertices = polytope.vertices;
    facets = polytope.facets;
  }
  return result;
}

}  // namespace fathom_check
