// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/body_features.hpp"

#include <algorithm>

#include "kernels/number/ratio.hpp"

namespace fathom::golden {
namespace {

void sort_uniquely(std::vector<Vector>& vectors) {
  std::ranges::sort(vectors, lexicographically_less);
  vectors.erase(std::unique(vectors.begin(), vectors.end()), vectors.end());
}

/// v or -v, whichever comes later in lexicographic order.
Vector without_sense(Vector v) {
  const int sign = v.x != 0 ? sgn(v.x) : v.y != 0 ? sgn(v.y) : sgn(v.z);
  return sign < 0 ? -v : v;
}

}  // namespace

BodyLook::BodyLook(const std::vector<Vector>& points, const mpz_class& denominator)
    : distinct(points), hull(polytope::convex_hull(points)) {
  sort_uniquely(distinct);
  for (const polytope::Edge& edge : hull.edges)
    edges.push_back(without_sense(primitive(hull.vertices[edge.to] - hull.vertices[edge.from])));
  for (const polytope::Facet& facet : hull.facets) normals.push_back(facet.normal);
  sort_uniquely(edges);
  sort_uniquely(normals);
  const mpz_class Vector::*const axes[] = {&Vector::x, &Vector::y, &Vector::z};
  std::vector<mpz_class> sides;
  for (const auto axis : axes) {
    const auto [low, high] =
        std::ranges::minmax_element(hull.vertices, {}, [axis](const Vector& v) -> const mpz_class& { return v.*axis; });
    sides.emplace_back((*high).*axis - (*low).*axis);
  }
  shortest = kernels::ratio(*std::ranges::min_element(sides), denominator);
  longest = kernels::ratio(*std::ranges::max_element(sides), denominator);
}

Look::Look(const Facts& f)
    : facts(f),
      integers(integers_of(f.points.a.points, f.points.b.points)),
      a(integers.a, integers.denominator),
      b(integers.b, integers.denominator) {
  for (const std::vector<Vector>* points : {&integers.a, &integers.b}) {
    for (const Vector& p : *points) {
      for (const mpz_class* c : {&p.x, &p.y, &p.z}) {
        if (*c == 0) continue;
        const mpz_class size = abs(*c);
        if (size > greatest) greatest = size;
        if (least == 0 || size < least) least = size;
      }
    }
  }
}

bool meet(const std::vector<Vector>& u, const std::vector<Vector>& v) {
  auto i = u.begin(), j = v.begin();
  while (i != u.end() && j != v.end()) {
    if (lexicographically_less(*i, *j)) ++i;
    else if (lexicographically_less(*j, *i)) ++j;
    else return true;
  }
  return false;
}

}  // namespace fathom::golden
