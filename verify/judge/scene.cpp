// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/scene.hpp"

#include <algorithm>
#include <utility>

#include "kernels/filters/support.hpp"
#include "reference/approximate/body_pair.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/polytope/distance.hpp"
#include "reference/polytope/position.hpp"
#include "verify/judge/way_out.hpp"

namespace fathom {
namespace {

mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

}  // namespace

Sizes sizes_of(std::span<const Point> a, std::span<const Point> b) {
  Sizes sizes;
  for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
    const auto range = [axis](std::span<const Point> body) {
      const auto [low, high] = std::ranges::minmax_element(
          body, [](const mpq_class& p, const mpq_class& q) { return p < q; }, axis);
      return std::pair<const mpq_class&, const mpq_class&>((*low).*axis, (*high).*axis);
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    sizes.extent = std::max({sizes.extent, mpq_class(high_a - low_a), mpq_class(high_b - low_b)});
    sizes.farthest = std::max({sizes.farthest, mpq_class(-low_a), high_a, mpq_class(-low_b), high_b});
    sizes.reach = std::max({sizes.reach, mpq_class(high_b - low_a), mpq_class(high_a - low_b)});
  }
  return sizes;
}

Scene::Scene(const Truth& truth) : truth_(truth), lattice_(common_lattice(truth.a, truth.b)), sizes_(sizes_of(truth.a, truth.b)) {}
Scene::~Scene() = default;

mpq_class Scene::price(const Vector& u) const {
  mpz_class low = dot(u, lattice_.a.front()), high = dot(u, lattice_.b.front());
  for (const Vector& p : lattice_.a) low = std::min(low, dot(u, p));
  for (const Vector& p : lattice_.b) high = std::max(high, dot(u, p));
  const mpz_class height = high - low, size = abs(height);
  return ratio(height * size, lattice_.denominator * lattice_.denominator * dot(u, u));
}

mpq_class Scene::travel(const Vector& u) {
  if (truth_.depth.status != Status::penetrating) return 0;
  if (truth_.depth.inner) {
    if (const std::optional<mpq_class> out = way_out(lattice_, *truth_.depth.inner, u)) {
      const mpq_class factor = *out / lattice_.denominator;
      return factor * factor * dot(u, u);
    }
  }
  if (!pair_) pair_ = std::make_unique<const BodyPair>(truth_.a, truth_.b);
  const RayHit hit = shoot_ray(pair_->a(), pair_->b(), u);
  const mpq_class factor = hit.factor / pair_->lattice().denominator;
  return factor * factor * dot(u, u);
}

mpq_class squared_distance(const Point& point, std::span<const Point> body) {
  const Lattice lattice = common_lattice({&point, 1}, body);
  const long exponent = std::max(binary_exponent(lattice.a), binary_exponent(lattice.b));
  const PointCloud one(lattice.a, exponent), others(lattice.b, exponent);
  if (position_of_origin(one, others).position != Position::outside) return 0;
  const NearestPoints nearest = nearest_points(one, others);
  return ratio(nearest.height * nearest.height, lattice.denominator * lattice.denominator * dot(nearest.normal, nearest.normal));
}

}  // namespace fathom
