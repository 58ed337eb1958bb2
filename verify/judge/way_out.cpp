// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle of points of P that the ray passes through: either its plane supports P, and there the ray leaves P; or a point of P lies
// beyond it, the ray runs on through the tetrahedron of the four, and leaves it through another triangle.
#include <array>
#include <cstddef>

#include "kernels/number/rational.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

/// Counter-clockwise seen from outside: O lies below its plane.
using Triangle = std::array<Vector, 3>;

/// Whether the ray from O along u meets the triangle, its boundary included.
bool meets(const Triangle& t, const Vector& u) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (det(t[k], t[(k + 1) % 3], u) < 0) return false;
  }
  return det(t[0], t[1], t[2]) > 0;
}

class Search {
 public:
  Search(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u) : placed_(placed), u_(u) {
    for (const auto& facet : inside.facets) {
      for (std::size_t k = 2; k < facet.size() && !portal_; ++k) {
        try_portal({corner(inside, facet[0]), corner(inside, facet[k - 1]), corner(inside, facet[k])});
      }
      if (portal_) return;
    }
  }

  std::optional<mpq_class> run(unsigned patience) {
    while (portal_ && patience-- > 0) {
      const Triangle t = *portal_;
      const Vector n = cross(t[1] - t[0], t[2] - t[0]), p = extreme(n);
      const mpz_class height = dot(n, t[0]);
      if (dot(n, p) == height) {
        return kernels::ratio(height, dot(n, u_));
      }
      portal_.reset();
      for (std::size_t k = 0; k < 3 && !portal_; ++k) try_portal({t[k], t[(k + 1) % 3], p});
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Vector corner(const InnerPolytope& inside, std::uint32_t k) const {
    const auto& [i, j] = inside.vertices[k];
    return placed_.b[j] - placed_.a[i];
  }

  void try_portal(Triangle triangle) {
    if (meets(triangle, u_)) portal_ = std::move(triangle);
  }

  /// A point of P with the greatest <n, p>.
  [[nodiscard]] Vector extreme(const Vector& n) const {
    const auto farthest = [](const std::vector<Vector>& points, const Vector& direction) {
      const Vector* best = &points.front();
      mpz_class height = dot(direction, *best);
      for (const Vector& p : points) {
        mpz_class other = dot(direction, p);
        if (other > height) {
          best = &p;
          height = std::move(other);
        }
      }
      return *best;
    };
    return farthest(placed_.b.points(), n) - farthest(placed_.a.points(), -n);
  }

  const polytope::PlacedPair& placed_;
  const Vector& u_;
  std::optional<Triangle> portal_;
};

}  // namespace

std::optional<mpq_class> way_out(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u, unsigned patience) {
  return Search(placed, inside, u).run(patience);
}

}  // namespace fathom::judging
