// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of a finished expansion, by definition: every vertex of Q against every facet, all points against every direction.
#include <algorithm>
#include <set>

#include "reference/expanding/expanding_polytope.hpp"

namespace fathom::expanding {
namespace {

class Check {
 public:
  Check(const Expansion& expansion, const kernels::PointCloud& a, const kernels::PointCloud& b) : expansion_(expansion), a_(a), b_(b) {}

  kernels::Report run() {
    if (!report_.expect(expansion_.end == ExpansionEnd::proved && !expansion_.nearest.empty(), "nothing is proved")) return report_;
    if (!resolve()) return report_;
    for (const std::vector<std::uint32_t>& facet : expansion_.inner.facets) check(facet);
    check_edges();
    const auto& directions = expansion_.nearest.directions();
    report_.expect(std::equal(tight_.begin(), tight_.end(), directions.begin(), directions.end()),
                   "the nearest facets of Q are not those of P");
    for (const Vector& n : directions) check(n);
    return report_;
  }

 private:
  bool resolve() {
    for (const auto& [i, j] : expansion_.inner.vertices) {
      if (!report_.expect(i < a_.size() && j < b_.size(), "a vertex of Q has an index out of range")) return false;
      vertices_.push_back(b_[j] - a_[i]);
    }
    for (const std::vector<std::uint32_t>& facet : expansion_.inner.facets) {
      const bool in_range = std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) { return v < vertices_.size(); });
      if (!report_.expect(facet.size() >= 3 && in_range, "a facet of Q is no cycle of its vertices")) return false;
    }
    return true;
  }

  // The sign of the distance of the plane <n,x> = height, less that of the nearest ones. height > 0.
  [[nodiscard]] int order(const Vector& n, const mpz_class& height) const {
    return cmp(mpz_class(height * height * expansion_.nearest.denominator()), mpz_class(expansion_.nearest.numerator() * dot(n, n)));
  }

  void check(const std::vector<std::uint32_t>& facet) {
    const Vector& p = vertices_[facet[0]];
    const Vector n = cross(Vector(vertices_[facet[1]] - p), Vector(vertices_[facet[2]] - p));
    const mpz_class height = dot(n, p);
    if (!report_.expect(height > 0, "O is not below a facet of Q")) return;
    report_.expect(order(n, height) >= 0, "a facet of Q is nearer than the nearest of P");
    if (order(n, height) == 0) tight_.insert(primitive(n));
    std::size_t on_plane = 0;
    for (const Vector& v : vertices_) {
      const int side = cmp(dot(n, v), height);
      report_.expect(side <= 0, "a vertex of Q lies above a facet");
      on_plane += side == 0 ? 1U : 0U;
    }
    report_.expect(on_plane == facet.size(), "the corners of a facet of Q are not the vertices on its plane");
    for (std::size_t k = 0, size = facet.size(); k < size; ++k) {
      const Vector &u = vertices_[facet[k]], &v = vertices_[facet[(k + 1) % size]], &w = vertices_[facet[(k + 2) % size]];
      report_.expect(dot(n, cross(Vector(v - u), Vector(w - v))) > 0, "the corners of a facet of Q do not turn left");
    }
  }

  void check_edges() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const std::vector<std::uint32_t>& facet : expansion_.inner.facets)
      for (std::size_t k = 0; k < facet.size(); ++k)
        report_.expect(edges.insert({facet[k], facet[(k + 1) % facet.size()]}).second, "two facets of Q run along an edge in one sense");
    for (const auto& [u, v] : edges) report_.expect(edges.contains({v, u}), "an edge of Q has a facet on one side only");
  }

  void check(const Vector& n) {
    const mpz_class height = dot(n, b_[kernels::extreme_points_naive(b_.points(), n).front()]) -
                             dot(n, a_[kernels::extreme_points_naive(a_.points(), -n).front()]);
    report_.expect(height > 0 && order(n, height) == 0, "a direction is not that of a nearest plane");
  }

  const Expansion& expansion_;
  const kernels::PointCloud& a_;
  const kernels::PointCloud& b_;
  kernels::Report report_;
  std::vector<Vector> vertices_;
  std::set<Vector, kernels::NearestPlanes::LexicographicOrder> tight_;
};

}  // namespace

kernels::Report validate(const Expansion& expansion, const kernels::PointCloud& a, const kernels::PointCloud& b) {
  return Check(expansion, a, b).run();
}

}  // namespace fathom::expanding
