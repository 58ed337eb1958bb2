// SPDX-License-Identifier: GPL-3.0-or-later
// First a ray from a point inside P to the start tells where the start lies; its portal and that point make a tetrahedron that holds
// the start. From there the ray itself goes on. Positions are multiplied by 4, so that the centroid of four points is integral.
#include "reference/approximate/ray.hpp"

#include <bit>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/approximate/ray_levels.hpp"
#include "reference/approximate/ray_portal.hpp"

namespace fathom::approximate {
namespace {

const std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

Vector times_4(const Vector& v) { return {4 * v.x, 4 * v.y, 4 * v.z}; }

bool parallel(const Vector& v, const Vector& w) { return is_zero(cross(v, w)); }

/// A basis of the directions orthogonal to `span`, a list of at most two linearly independent vectors.
std::vector<Vector> orthogonal_to(const std::vector<Vector>& span) {
  if (span.empty()) return {axes.begin(), axes.end()};
  if (span.size() == 2) return {cross(span[0], span[1])};
  std::vector<Vector> basis;
  for (const Vector& axis : axes) {
    const Vector v = cross(span[0], axis);
    if (!is_zero(v) && (basis.empty() || !parallel(v, basis[0])) && basis.size() < 2) basis.push_back(v);
  }
  return basis;
}

/// Two axes that span space together with v.
std::vector<Vector> axes_across(const Vector& v) {
  if (v.x != 0) return {axes[1], axes[2]};
  if (v.y != 0) return {axes[2], axes[0]};
  return {axes[0], axes[1]};
}

/// A point of P at another height along one of the directions than `from`, if there is one.
std::optional<Vector> point_off(const Vector& from, const std::vector<Vector>& directions, SupportOfSum& support) {
  for (const Vector& u : directions) {
    for (const Vector& v : {u, -u}) {
      const Vector p = support.of_sum(v);
      if (dot(u, p - from) != 0) return p;
    }
  }
  return std::nullopt;
}

/// Where a point lies in P, thickened.
struct Location {
  int beyond = -1;                 ///< -1 inside, 0 on the boundary, 1 outside
  std::array<Vector, 4> around{};  ///< in P: corners of a tetrahedron that holds the point once it is pushed
  std::vector<Vector> pushes{};
  Portal portal{};  ///< outside: in a plane that separates
};

/// Support queries of a ray before it is left to the descent of both hierarchies.
std::uint64_t patience_of(const polytope::Hierarchy& a, const polytope::Hierarchy& b) {
  return 16 + 2 * static_cast<std::uint64_t>(std::bit_width(a.cloud().size()) + std::bit_width(b.cloud().size()));
}

Portal leave(const std::array<Vector, 4>& around, const PushedRay& ray, SupportOfSum& support, std::uint64_t patience,
             const Vector* within = nullptr) {
  if (const auto portal = refine(portal_of_tetrahedron(around, ray), ray, std::ref(support), within, patience)) return *portal;
  return refine_by_levels(around, ray, support);
}

/// By a ray from the centroid of the corners. `start` is multiplied by 4.
Location locate(const Vector& start, const std::array<Vector, 4>& corners, SupportOfSum& support, std::uint64_t patience) {
  Vector centre;
  for (const Vector& c : corners) centre = centre + Vector{c.x / 4, c.y / 4, c.z / 4};
  if (start == centre) return {-1, corners, {axes.begin(), axes.end()}, {}};
  const Vector way = start - centre;
  const std::vector<Vector> across = axes_across(way);
  const PushedRay ray{way, centre, across};
  const Portal portal = leave(corners, ray, support, patience, &start);
  const mpz_class beyond = dot(normal_of(portal), start - portal[0]);
  return {sgn(beyond), {centre, portal[0], portal[1], portal[2]}, {-way, across[0], across[1]}, portal};
}

}  // namespace

RayShooter::RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b) : RayShooter(a, b, patience_of(a, b)) {}

RayShooter::RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b, std::uint64_t patience)
    : a_(&a), b_(&b), patience_(patience) {
  const kernels::DefaultFloatEnvironment environment;
  SupportOfSum support{a_, b_, &thickness_};
  std::vector<Vector> points{support.of_sum(axes[0])}, span;
  while (span.size() < 3) {
    const std::optional<Vector> next = point_off(points[0], orthogonal_to(span), support);
    if (!next) break;
    points.push_back(*next);
    span.push_back(*next - points[0]);
  }
  if (span.size() < 3) thickness_ = orthogonal_to(span);
  for (const Vector& t : thickness_) points.push_back(points[0] + t);
  for (std::size_t i = 0; i < 4; ++i) corners_[i] = times_4(points[i]);
}

RayHit RayShooter::shoot(const Vector& direction, const Vector& start) const {
  const kernels::DefaultFloatEnvironment environment;
  if (is_zero(direction)) throw std::invalid_argument("a ray without a direction");
  SupportOfSum support{a_, b_, &thickness_};
  RayHit hit = thickness_.empty() ? shoot_solid(direction, start, support) : shoot_flat(direction, start, support);
  hit.queries = support.queries;
  hit.steps = support.steps;
  return hit;
}

RayHit RayShooter::shoot_solid(const Vector& direction, const Vector& start, SupportOfSum& support) const {
  const Vector start_4 = times_4(start);
  Location location = locate(start_4, corners_, support, patience_);
  RayHit hit;
  hit.hits = location.beyond <= 0;
  hit.interior = location.beyond < 0;
  if (hit.hits) {
    const PushedRay ray{direction, start_4, std::move(location.pushes)};
    location.portal = leave(location.around, ray, support, patience_);
  }
  hit.normal = primitive(normal_of(location.portal));
  hit.height = dot(hit.normal, location.portal[0]) / 4;
  if (hit.hits) {
    hit.factor = kernels::ratio(hit.height - dot(hit.normal, start), dot(hit.normal, direction));
  }
  return hit;
}

RayHit RayShooter::shoot_flat(const Vector& direction, const Vector& start, SupportOfSum& support) const {
  const Vector start_4 = times_4(start);
  RayHit hit;
  for (const Vector& t : thickness_) {
    const int off = sgn(dot(t, start_4 - corners_[0]));
    if (off == 0) continue;
    hit.normal = primitive(off > 0 ? t : -t);
    hit.height = dot(hit.normal, corners_[0]) / 4;
    return hit;
  }
  const Location location = locate(start_4, corners_, support, patience_);
  hit.hits = location.beyond <= 0;
  hit.normal = hit.hits ? thickness_[0] : normal_of(location.portal);
  for (const Vector& t : thickness_)
    if (hit.hits && dot(t, direction) != 0) hit.normal = dot(t, direction) > 0 ? t : -t;
  hit.normal = primitive(hit.normal);
  hit.height = dot(hit.normal, support.of_sum(hit.normal));
  return hit;
}

RayHit shoot_ray(const polytope::Hierarchy& a, const polytope::Hierarchy& b, const Vector& direction, const Vector& start) {
  return RayShooter(a, b).shoot(direction, start);
}

}  // namespace fathom::approximate
