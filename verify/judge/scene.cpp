// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "kernels/number/rational.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::judging {
namespace {

/// A triangle, counter-clockwise seen from outside: O lies below its plane.
using Triangle = std::array<Vector, 3>;

/// Returns whether the ray from O along u meets the triangle, including its boundary.
bool meets(const Triangle& t, const Vector& u) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (det(t[k], t[(k + 1) % 3], u) < 0) return false;
  }
  return det(t[0], t[1], t[2]) > 0;
}

/// Searches for a triangle of points of P that contains the point where the ray leaves P. The ray
/// passes through a triangle. If its plane supports P, the search is done; otherwise a point of P
/// lies beyond it, and the ray leaves the tetrahedron of the four points through another triangle,
/// which is next.
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

  /// Returns a point of P with the greatest <n, p>.
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

/// most = max(most, length).
void raise(mpq_class& most, const mpq_class& length) {
  if (length > most) most = length;
}

}  // namespace

std::optional<mpq_class> way_out(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u,
                                 unsigned patience) {
  return Search(placed, inside, u).run(patience);
}

Sizes sizes_of(std::span<const Point> a, std::span<const Point> b, unsigned dimension) {
  polytope::require_bodies(a, b);
  Sizes sizes;
  constexpr std::array axes = {&Point::x, &Point::y, &Point::z};
  for (const auto axis : std::span(axes).first(dimension)) {
    const auto range = [axis](std::span<const Point> body) {
      const auto [low, high] = std::ranges::minmax_element(
          body, [](const mpq_class& p, const mpq_class& q) { return p < q; }, axis);
      return std::pair<const mpq_class&, const mpq_class&>((*low).*axis, (*high).*axis);
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    raise(sizes.extent, high_a - low_a);
    raise(sizes.extent, high_b - low_b);
    for (const mpq_class* low : {&low_a, &low_b}) raise(sizes.farthest, -*low);
    for (const mpq_class* high : {&high_a, &high_b}) raise(sizes.farthest, *high);
    raise(sizes.reach, high_b - low_a);
    raise(sizes.reach, high_a - low_b);
  }
  return sizes;
}

Sizes sizes_of(const Pieces& a, const Pieces& b, unsigned dimension) {
  for (const Pieces* body : {&a, &b})
    for (const std::vector<Point>& piece : *body) polytope::require_bodies(piece, piece);
  return sizes_of(polytope::joined(a), polytope::joined(b), dimension);
}

Sizes sizes_of(const Shape& a, const Shape& b, unsigned bits, unsigned dimension) {
  Sizes sizes;
  const std::array<Point, 3> axes = {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  for (const Point& axis : std::span(axes).first(dimension)) {
    std::array<std::array<mpq_class, 2>, 2> reach;  // of each body, in both directions
    for (const Shape* body : {&a, &b}) {
      if (shapes::is_halfspace(*body)) continue;
      auto& [low, high] = reach[body == &b ? 1 : 0];
      low = shapes::support(*body, {-axis.x, -axis.y, -axis.z}, bits).high;
      high = shapes::support(*body, axis, bits).high;
      sizes.extent = std::max(sizes.extent, mpq_class(low + high));
      sizes.farthest = std::max({sizes.farthest, low, high});
    }
    sizes.reach = std::max({sizes.reach, mpq_class(reach[1][1] + reach[0][0]), mpq_class(reach[0][1] + reach[1][0])});
  }
  return sizes;
}

Scene::Scene(const Truth& truth) : truth_(truth), placed_(polytope::place(truth.a, truth.b)) {}
Scene::~Scene() = default;

mpq_class Scene::separating_distance_squared(const Vector& u) const {
  mpz_class low = dot(u, placed_.a[0]), high = dot(u, placed_.b[0]);
  for (const Vector& p : placed_.a.points()) low = std::min(low, dot(u, p));
  for (const Vector& p : placed_.b.points()) high = std::max(high, dot(u, p));
  const mpz_class height = high - low, size = abs(height);
  return kernels::ratio(height * size, placed_.denominator * placed_.denominator * dot(u, u));
}

mpq_class Scene::exit_distance_squared(const Vector& u) {
  const Penetration* const penetration = truth_.depth.penetration();
  if (!penetration) return 0;
  std::optional<mpq_class> out;
  if (penetration->inner) out = way_out(placed_, *penetration->inner, u);
  if (!out) {
    kernels::Context context;
    if (!pair_) pair_ = std::make_unique<const BodyPair>(context, truth_.a, truth_.b);
    out = approximate::shoot_ray(pair_->a(), pair_->b(), u).factor;
  }
  const mpq_class factor = *out / placed_.denominator;
  return factor * factor * dot(u, u);
}

std::optional<Outside> outside_of(const Point& point, std::span<const Point> body) {
  const auto search = [](const auto& pair) -> std::optional<Outside> {
    std::optional<polytope::NearestPoints> nearest = polytope::nearest_points_if_apart(pair.differences());
    if (!nearest) return std::nullopt;
    const mpz_class &height = nearest->height, square = dot(nearest->normal, nearest->normal);
    const mpq_class unit = pair.unit();
    return Outside{unit * unit * kernels::ratio(height * height, square), std::move(nearest->normal)};
  };
  const polytope::Points alone(std::span(&point, 1)), points(body);
  polytope::NarrowMemory placed;
  kernels::ScanMemory scans;
  if (polytope::place_narrow(alone, points, placed))
    return polytope::with_searched_pair(placed, alone, points, scans, search);
  return search(polytope::place({&point, 1}, body));
}

mpq_class squared_distance(const Point& point, std::span<const Point> body) {
  const std::optional<Outside> outside = outside_of(point, body);
  return outside ? outside->squared : mpq_class(0);
}

mpq_class squared_distance(const Point& point, const Pieces& body) {
  std::optional<mpq_class> least;
  for (const std::vector<Point>& piece : body) {
    mpq_class squared = squared_distance(point, std::span<const Point>(piece));
    if (!least || squared < *least) least = std::move(squared);
  }
  return *least;
}

}  // namespace fathom::judging
