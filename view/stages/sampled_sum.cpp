// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh near P of curved bodies: the hull of differences of their samples, each extreme in one of many directions. Part of parts.hpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/polytope/polytope.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

constexpr int latitudes = 16, longitudes = 32;
constexpr double steps = 1 << 20;  // of the lattice of the differences, across the mesh

double dot(const Place& p, const Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Place minus(const Place& p, const Place& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

const Place& extreme(const std::vector<Place>& points, const Place& u) {
  return *std::ranges::max_element(points, {}, [&](const Place& p) { return dot(p, u); });
}

/// Differences b - a that are extreme in directions all around.
std::vector<Place> differences(const std::vector<Place>& a, const std::vector<Place>& b) {
  std::vector<Place> result;
  for (int i = 0; i <= latitudes; ++i) {
    const double polar = std::numbers::pi * i / latitudes;
    for (int j = 0; j < longitudes; ++j) {
      const double turn = 2 * std::numbers::pi * j / longitudes;
      const Place u{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
      result.push_back(minus(extreme(b, u), extreme(a, {-u[0], -u[1], -u[2]})));
    }
  }
  return result;
}

StagedFacet facet_of(const polytope::Polytope& hull, const polytope::Facet& facet, const std::vector<Place>& vertices) {
  StagedFacet result;
  for (std::uint32_t i = facet.begin; i < facet.end; ++i) result.vertices.push_back(hull.corners[i].value);
  result.normal = unit(facet.normal);
  result.distance = std::max(0.0, dot(result.normal, vertices[result.vertices.front()]));
  result.kind = SumFacetKind::merged;
  return result;
}

}  // namespace

void add_sampled_sum(Stages& stages) {
  if (stages.status != Status::penetrating || stages.a.vertices.empty() || stages.b.vertices.empty()) {
    stages.left_out.emplace_back("P, the set of all differences b - a, is not drawn.");
    return;
  }
  const std::vector<Place> samples = differences(stages.a.vertices, stages.b.vertices);
  double reach = 0;
  for (const Place& p : samples) reach = std::max({reach, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  const double step = reach > 0 ? reach / steps : 1;
  std::vector<Vector> lattice;
  for (const Place& p : samples)
    lattice.push_back({mpz_class(std::round(p[0] / step)), mpz_class(std::round(p[1] / step)), mpz_class(std::round(p[2] / step))});
  const polytope::Polytope hull = polytope::convex_hull(lattice);
  if (hull.rank < 3) return;
  StagedSum& sum = stages.sum;
  sum.kind = SumKind::sampled;
  for (const Vector& v : hull.vertices) sum.vertices.push_back({v.x.get_d() * step, v.y.get_d() * step, v.z.get_d() * step});
  for (const polytope::Facet& facet : hull.facets) sum.facets.push_back(facet_of(hull, facet, sum.vertices));
  std::ranges::stable_sort(sum.facets, {}, &StagedFacet::distance);
  stages.left_out.emplace_back("P is a mesh near the set of all differences: its facets are left out of the ranking.");
}

}  // namespace fathom::stages
