// SPDX-License-Identifier: GPL-3.0-or-later
// A facet of P with normal u is F_B - F_A for faces F_A, F_B of the bodies, so its plane is spanned
// by two of the differences between points of one body. All cross products of two such differences,
// with both signs, are therefore enough when P is solid. The unit vectors join the differences for
// the sake of a flat P: it is the intersection, over t > 0, of the solid bodies P + [-t,t]^3, whose
// normals are then among the candidates, and O lies in all of them iff h(u) >= 0 for all candidates
// u.
#include "tests/oracles/brute_oracle.hpp"

#include <algorithm>
#include <set>

namespace fathom::oracles {

namespace {

/// One of each pair of opposite vectors.
void add_up_to_sign(Directions& set, const Vector& v) {
  if (is_zero(v)) return;
  const Vector direction = primitive(v);
  const Vector opposite = -direction;
  set.insert(lexicographically_less(opposite, direction) ? direction : opposite);
}

Directions candidates(const IntegerBodies& bodies) {
  Directions differences{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::vector<Vector>* points : {&bodies.a, &bodies.b})
    for (const Vector& p : *points)
      for (const Vector& q : *points) add_up_to_sign(differences, p - q);
  Directions normals;
  for (auto d = differences.begin(); d != differences.end(); ++d)
    for (auto e = std::next(d); e != differences.end(); ++e) add_up_to_sign(normals, cross(*d, *e));
  return normals;
}

mpz_class highest(const std::vector<Vector>& points, const Vector& u) {
  mpz_class best = dot(points.front(), u);
  for (const Vector& p : points) best = std::max(best, dot(p, u));
  return best;
}

/// The plane that supports P with outward normal u: <u,x> = max_b <u,b> - min_a <u,a>.
HalfSpace supporting(const IntegerBodies& bodies, const Vector& u) {
  mpq_class offset(highest(bodies.b, u) + highest(bodies.a, -u), bodies.denominator);
  offset.canonicalize();
  return {u, offset};
}

}  // namespace

OracleAnswer brute_oracle(std::span<const Point> a, std::span<const Point> b) {
  const IntegerBodies bodies = integer_bodies(a, b);
  std::vector<HalfSpace> half_spaces;
  for (const Vector& u : candidates(bodies)) {
    half_spaces.push_back(supporting(bodies, u));
    half_spaces.push_back(supporting(bodies, -u));
  }
  return nearest_half_spaces(half_spaces);
}

}  // namespace fathom::oracles
