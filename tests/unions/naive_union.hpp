// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twin: of every one, two and three facet planes of all P_ij the point nearest to O, and
// of these the nearest that lie in no interior. For tiny bodies of integers.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::unions {

struct NaiveUnion {
  mpq_class squared = 0;
  std::set<std::tuple<mpq_class, mpq_class, mpq_class>> optima;  // if the unions penetrate
};

class NaiveSearch {
 public:
  NaiveSearch(const Pieces& a, const Pieces& b) {
    for (const std::vector<Point>& p : a)
      for (const std::vector<Point>& q : b) add(integers(p), integers(q));
  }

  /// How many different planes there are: the time grows with the third power.
  [[nodiscard]] std::size_t planes() const { return distinct_.size(); }

  NaiveUnion run() {
    if (free({0, 0, 0}, 1)) return {};
    const std::vector<Plane> all(distinct_.begin(), distinct_.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      one(all[i]);
      for (std::size_t j = 0; j < i; ++j) {
        two(all[i], all[j]);
        for (std::size_t k = 0; k < j; ++k) three(all[i], all[j], all[k]);
      }
    }
    return {*best_, optima_};
  }

 private:
  struct Plane {
    Vector n;
    mpz_class h;
    bool operator<(const Plane& o) const { return std::tie(n.x, n.y, n.z, h) < std::tie(o.n.x, o.n.y, o.n.z, o.h); }
  };

  void add(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    std::vector<Vector> differences;
    for (const Vector& p : a)
      for (const Vector& q : b) differences.push_back(q - p);
    const polytope::Polytope hull = polytope::convex_hull(differences);
    std::vector<Plane>& planes = pairs_.emplace_back();
    for (const polytope::Facet& f : hull.facets)
      planes.push_back({f.normal, dot(f.normal, hull.vertices[hull.corners[f.begin]])});
    distinct_.insert(planes.begin(), planes.end());
  }

  [[nodiscard]] bool free(const Vector& v, const mpz_class& w) const {
    return std::none_of(pairs_.begin(), pairs_.end(), [&](const std::vector<Plane>& planes) {
      return std::all_of(planes.begin(), planes.end(), [&](const Plane& f) { return dot(f.n, v) < f.h * w; });
    });
  }

  void one(const Plane& f) { consider(f.h * f.n, dot(f.n, f.n)); }
  void two(const Plane& f, const Plane& g) {
    const Vector d = cross(f.n, g.n);
    if (!is_zero(d)) consider(f.h * cross(g.n, d) + g.h * cross(d, f.n), dot(d, d));
  }
  void three(const Plane& f, const Plane& g, const Plane& e) {
    const mpz_class w = det(f.n, g.n, e.n);
    if (w != 0) consider(f.h * cross(g.n, e.n) + g.h * cross(e.n, f.n) + e.h * cross(f.n, g.n), w);
  }

  void consider(Vector v, mpz_class w) {
    if (w < 0) {
      v = -v;
      w = -w;
    }
    const mpz_class numerator = dot(v, v), denominator = w * w;
    if (best_ && numerator * best_->get_den() > best_->get_num() * denominator) return;
    if (!free(v, w)) return;
    mpq_class squared(numerator, denominator);
    squared.canonicalize();
    if (!best_ || squared < *best_) optima_.clear();
    best_ = squared;
    mpq_class x(v.x, w), y(v.y, w), z(v.z, w);
    for (mpq_class* c : {&x, &y, &z}) c->canonicalize();
    optima_.emplace(x, y, z);
  }

  std::vector<std::vector<Plane>> pairs_;
  std::set<Plane> distinct_;
  std::optional<mpq_class> best_;
  std::set<std::tuple<mpq_class, mpq_class, mpq_class>> optima_;
};

inline NaiveUnion naive_union(const Pieces& a, const Pieces& b) { return NaiveSearch(a, b).run(); }

inline std::set<std::tuple<mpq_class, mpq_class, mpq_class>> places(const UnionDepth& depth) {
  std::set<std::tuple<mpq_class, mpq_class, mpq_class>> result;
  for (const UnionOptimum& o : depth.optima) result.emplace(o.translation.x, o.translation.y, o.translation.z);
  return result;
}

}  // namespace fathom::unions
