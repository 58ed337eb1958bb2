// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/ray_portal.hpp"

#include <stdexcept>
#include <utility>

namespace fathom::approximate {

int PushedRay::side(const Vector& p, const Vector& q) const {
  const Vector across = cross(direction, q - p);
  const mpz_class at_start = dot(across, start - p);
  if (at_start != 0) return sgn(at_start);
  for (const Vector& push : pushes) {
    const mpz_class pushed = dot(across, push);
    if (pushed != 0) return sgn(pushed);
  }
  return 0;
}

Vector SupportOfSum::of_sum(const Vector& u) {
  ++queries;
  return b->polytope().vertices[b->extreme(u, &steps)] - a->polytope().vertices[a->extreme(-u, &steps)];
}

Vector SupportOfSum::operator()(const Vector& u) {
  Vector p = of_sum(u);
  for (const Vector& t : *thickness) p = dot(u, t) < 0 ? p - t : p + t;
  return {4 * p.x, 4 * p.y, 4 * p.z};
}

Portal portal_of_tetrahedron(const std::array<Vector, 4>& corners, const PushedRay& ray) {
  for (std::size_t opposite = 0; opposite < 4; ++opposite) {
    Portal side{corners[(opposite + 1) % 4], corners[(opposite + 2) % 4], corners[(opposite + 3) % 4]};
    const Vector normal = normal_of(side);
    const bool outward = dot(normal, corners[opposite] - side[0]) < 0;
    const int along = sgn(dot(normal, ray.direction));
    if (along == 0 || (along > 0) != outward) continue;
    if (!outward) std::swap(side[1], side[2]);
    if (ray.side(side[0], side[1]) > 0 && ray.side(side[1], side[2]) > 0 && ray.side(side[2], side[0]) > 0) return side;
  }
  throw std::logic_error("a ray from inside a tetrahedron that pierces none of its sides");
}

namespace {

/// The triangle of p and a side of the portal that the ray pierces: the side where the line from p through the ray leaves the portal.
Portal moved_to(const Portal& portal, const Vector& p, const PushedRay& ray) {
  const Vector across = cross(ray.start - p, ray.direction);
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = sgn(dot(portal[i] - p, across));
    if (sides[i] == 0) sides[i] = ray.side(p, portal[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] > 0 && sides[j] < 0) return {p, portal[i], portal[j]};
  }
  throw std::logic_error("a ray that misses its portal");
}

}  // namespace

std::optional<Portal> refine(Portal portal, const PushedRay& ray, const std::function<Vector(const Vector&)>& extreme, const Vector* within,
                             std::uint64_t patience) {
  for (;; --patience) {
    const Vector normal = normal_of(portal);
    if (within && dot(normal, *within - portal[0]) < 0) return portal;
    if (patience == 0) return std::nullopt;
    const Vector p = extreme(normal);
    if (dot(normal, p - portal[0]) == 0) return portal;
    portal = moved_to(portal, p, ray);
  }
}

}  // namespace fathom::approximate
