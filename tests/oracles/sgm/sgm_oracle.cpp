// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/sgm/sgm_oracle.hpp"

#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm.h>
#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm_polyhedron_3.h>
#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm_traits.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <stdexcept>

#include "reference/polytope/polytope.hpp"

namespace fathom::oracles {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_polyhedral_sgm_traits<Kernel, -1, 0>;
using Map = CGAL::Arr_polyhedral_sgm<Traits>;
using Polyhedron = CGAL::Arr_polyhedral_sgm_polyhedron_3<Map, Traits>;
using Initializer = CGAL::Arr_polyhedral_sgm_initializer<Map, Polyhedron>;

// Where gmpxx is at hand, which the build tells CGAL, mpq_class is the exact number type of CGAL's
// kernel.
Kernel::FT number(const mpz_class& value) { return Kernel::FT(mpq_class(value)); }
mpq_class rational(const Kernel::FT& value) { return value.exact(); }

/// An integer multiple of a rotation, that of the quaternion 5 - 19i - 14j + 3k, by rows. CGAL
/// 5.5.1 builds wrong maps for some bodies of small integers (seen with facet normals on the
/// meridian y = 0 and arcs through the poles); after this turn small integer vectors lie in no
/// special place of its parametrisation.
constexpr long turn[3][3] = {{181, 502, -254}, {562, -149, 106}, {26, -274, -523}};

Vector turned(const Vector& v) {
  const auto row = [&v](const long* m) { return mpz_class(m[0] * v.x + m[1] * v.y + m[2] * v.z); };
  return {row(turn[0]), row(turn[1]), row(turn[2])};
}

/// u with <u, v> = <n, turned(v)> for all v.
Vector turned_back(const Vector& n) {
  const auto column = [&n](int c) { return mpz_class(turn[0][c] * n.x + turn[1][c] * n.y + turn[2][c] * n.z); };
  return {column(0), column(1), column(2)};
}

Vector integer_direction(const Traits::Point_2& direction) {
  const mpq_class x = rational(direction.dx()), y = rational(direction.dy()), z = rational(direction.dz());
  const mpz_class scale = lcm(x.get_den(), lcm(y.get_den(), z.get_den()));
  const auto integer = [&scale](const mpq_class& value) {
    return mpz_class(value.get_num() * (scale / value.get_den()));
  };
  return {integer(x), integer(y), integer(z)};
}

/// The facets of the body whose map this is. Each vertex of the map is a facet's normal, unless it
/// only splits a long arc (degree 2), and the faces around it hold the facet's corners. Throws when
/// corners are not on one plane.
std::vector<HalfSpace> facets(const Map& map) {
  std::vector<HalfSpace> result;
  for (auto vertex = map.vertices_begin(); vertex != map.vertices_end(); ++vertex) {
    if (vertex->degree() <= 2) continue;
    const Vector normal = integer_direction(vertex->point());
    const auto offset = [&normal](const Kernel::Point_3& p) {
      return mpq_class(rational(p.x()) * normal.x + rational(p.y()) * normal.y + rational(p.z()) * normal.z);
    };
    const auto first = vertex->incident_halfedges();
    const mpq_class common = offset(first->face()->point());
    for (auto next = first; ++next != first;)
      if (offset(next->face()->point()) != common)
        throw std::runtime_error("CGAL's Gaussian map is wrong: a facet is not planar");
    result.push_back({turned_back(normal), common});
  }
  return result;
}

/// The map of the body's hull. Throws when CGAL loses features of it.
void fill(Map& map, const std::vector<Vector>& body) {
  std::vector<Vector> placed;
  for (const Vector& v : body) placed.push_back(turned(v));
  const polytope::Polytope hull = polytope::convex_hull(placed);
  if (hull.rank != 3) throw std::invalid_argument("the Gaussian map needs a body of rank 3");
  std::vector<Kernel::Point_3> points;
  for (const Vector& v : hull.vertices) points.emplace_back(number(v.x), number(v.y), number(v.z));
  std::vector<std::vector<std::size_t>> cycles;
  for (const polytope::Facet& facet : hull.facets) {
    std::vector<std::size_t>& cycle = cycles.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) cycle.push_back(hull.corners[i].value);
  }
  Initializer initializer(map);
  Kernel::Point_3* const first = points.data();
  initializer(first, first + points.size(), points.size(), cycles.begin(), cycles.end(), cycles.size());
  if (map.number_of_vertices() != hull.vertices.size() || facets(map).size() != hull.facets.size())
    throw std::runtime_error("CGAL's Gaussian map is wrong: features of the body are missing");
}

}  // namespace

OracleAnswer sgm_oracle(std::span<const Point> a, std::span<const Point> b) {
  IntegerBodies bodies = integer_bodies(a, b);
  for (Vector& v : bodies.a) v = -v;
  Map of_minus_a, of_b, of_p;
  fill(of_minus_a, bodies.a);
  fill(of_b, bodies.b);
  of_p.minkowski_sum(of_b, of_minus_a);
  std::vector<HalfSpace> half_spaces = facets(of_p);
  for (HalfSpace& half_space : half_spaces) half_space.offset /= bodies.denominator;
  return nearest_half_spaces(half_spaces);
}

}  // namespace fathom::oracles
