// SPDX-License-Identifier: GPL-3.0-or-later
// O is in P iff (0, 1) is in the cone of all (p, 1). If it is, O lies in the relative interior of the hull of some differences T; T grows,
// by a dimension each time, until a supporting plane through O is found or T surrounds O.  [proofs/position.md]
#include "reference/polytope/position.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/polytope/position_search.hpp"

namespace fathom::polytope {
namespace {

// Independent vectors that span the same space.
std::vector<Vector> basis(const std::vector<Vector>& vectors) {
  std::vector<Vector> chosen;
  for (const Vector& v : vectors) {
    const bool independent = chosen.empty()       ? !is_zero(v)
                             : chosen.size() == 1 ? !is_zero(cross(chosen[0], v))
                             : chosen.size() == 2 ? det(chosen[0], chosen[1], v) != 0
                                                  : false;
    if (independent) chosen.push_back(v);
  }
  return chosen;
}

// A nonzero vector orthogonal to at most two independent ones.
Vector normal_to(const std::vector<Vector>& independent) {
  if (independent.empty()) return {1, 0, 0};
  if (independent.size() == 2) return primitive(cross(independent[0], independent[1]));
  const Vector v = cross(independent[0], Vector{1, 0, 0});
  return primitive(is_zero(v) ? cross(independent[0], Vector{0, 1, 0}) : v);
}

// Whether O is in the interior of the hull: no u != 0 has <u, p> <= 0 for all p. If the vectors span R^3 but such u exist, they form a cone
// without lines; on one of its extreme rays two independent constraints are tight, so u is normal to two of the vectors.
bool surrounds(const std::vector<Vector>& vectors) {
  if (basis(vectors).size() < 3) return false;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector u = cross(vectors[i], vectors[j]);
      if (is_zero(u)) continue;
      bool above = false, below = false;
      for (std::size_t k = 0; k < vectors.size() && !(above && below); ++k) {
        const mpz_class side = dot(u, vectors[k]);
        above = above || side > 0;
        below = below || side < 0;
      }
      if (!(above && below)) return false;
    }
  }
  return true;
}

std::vector<Vector> vectors_of(const std::vector<Difference>& list, const Differences& differences) {
  std::vector<Vector> vectors;
  for (const Difference& d : list) vectors.push_back(differences[d]);
  return vectors;
}

// Drops what the rest can do without; by Steinitz at most six remain.
std::vector<Difference> irredundant(std::vector<Difference> surrounding, const Differences& differences) {
  for (std::size_t i = surrounding.size(); surrounding.size() > 4 && i-- > 0;) {
    std::vector<Difference> rest = surrounding;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (surrounds(vectors_of(rest, differences))) surrounding = std::move(rest);
  }
  std::sort(surrounding.begin(), surrounding.end());
  return surrounding;
}

// Given O in the relative interior of the hull of `around`: decides between inside and boundary.
void decide_interior(PositionOfOrigin& answer, Differences& differences, ConeSearch& cone, std::vector<Difference> around) {
  while (true) {
    const std::vector<Vector> spanned = basis(vectors_of(around, differences));
    if (spanned.size() == 3) {
      answer.position = Position::inside;
      answer.surrounding = irredundant(std::move(around), differences);
      return;
    }
    answer.position = Position::boundary;
    answer.normal = normal_to(spanned);
    const Difference d = differences.extreme(*answer.normal);
    const Vector q = differences[d];
    if (dot(*answer.normal, q) == 0) return;
    ConeSearch::Nearest back = cone.nearest({-q, 0}, 0, around);
    if (!is_zero(back.residual.v)) {
      answer.normal = primitive(back.residual.v);
      return;
    }
    answer.normal.reset();
    around.push_back(d);
    around.insert(around.end(), back.support.begin(), back.support.end());
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }
}

void expect_normal(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b) {
  if (!report.expect(answer.normal.has_value(), "a normal is missing")) return;
  const Vector& u = *answer.normal;
  report.expect(!is_zero(u) && primitive(u) == u, "the normal is not a primitive vector");
  const mpz_class h = support_naive(a, b, u);
  if (answer.position == Position::outside) report.expect(h < 0, "the normal does not separate the bodies strictly");
  else report.expect(h == 0, "the normal does not support P in O");
}

void expect_common_point(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b) {
  const auto in_a = convex_combination(a, answer.a), in_b = convex_combination(b, answer.b);
  report.expect(in_a.has_value(), "the weights of A are not convex weights of its points");
  report.expect(in_b.has_value(), "the weights of B are not convex weights of its points");
  if (in_a && in_b) report.expect(*in_a == *in_b, "the weighted points of A and B differ");
}

void expect_surrounding(kernels::Report& report, const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b) {
  std::vector<Vector> differences;
  for (const auto& [i, j] : answer.surrounding) {
    if (!report.expect(i < a.size() && j < b.size(), "a surrounding pair has an index out of range")) return;
    differences.push_back(b[j] - a[i]);
  }
  report.expect(surrounds(differences), "the surrounding differences do not have O in the interior of their hull");
}

}  // namespace

PositionOfOrigin position_of_origin(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("position_of_origin: an empty body");
  if (a.exponent() != b.exponent()) throw std::invalid_argument("position_of_origin: the clouds differ in their exponents");
  Differences differences{a, b};
  ConeSearch cone(differences);
  PositionOfOrigin answer;
  const ConeSearch::Nearest origin = cone.nearest({{0, 0, 0}, 1}, 1, {{0, 0}});
  if (!is_zero(origin.residual.v)) {
    answer.normal = primitive(origin.residual.v);
  } else {
    answer.a = weights_of(origin.support, origin.weights, &Difference::first);
    answer.b = weights_of(origin.support, origin.weights, &Difference::second);
    decide_interior(answer, differences, cone, origin.support);
  }
  answer.scans = differences.scans;
  return answer;
}

kernels::Report validate(const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b) {
  kernels::Report report;
  if (!report.expect(!a.empty() && !b.empty(), "an empty body")) return report;
  const bool inside = answer.position == Position::inside, outside = answer.position == Position::outside;
  if (inside) report.expect(!answer.normal, "a point of the interior has no normal");
  else expect_normal(report, answer, a, b);
  if (outside) report.expect(answer.a.empty() && answer.b.empty(), "disjoint bodies have no common point");
  else expect_common_point(report, answer, a, b);
  if (inside) expect_surrounding(report, answer, a, b);
  else report.expect(answer.surrounding.empty(), "differences surround O though it is not inside");
  return report;
}

}  // namespace fathom::polytope
