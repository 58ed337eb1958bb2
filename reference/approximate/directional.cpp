// SPDX-License-Identifier: GPL-3.0-or-later
// The depth along a direction, by one ray.
#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/body_pair.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom::approximate {
namespace {

/// The primitive integer vector of the same direction; direction = `unit` times it.
Vector integral(const Point& direction, mpq_class& unit) {
  const mpz_class d = lcm(lcm(direction.x.get_den(), direction.y.get_den()), direction.z.get_den());
  const Vector v{mpq_class(d * direction.x).get_num(), mpq_class(d * direction.y).get_num(), mpq_class(d * direction.z).get_num()};
  unit = kernels::ratio(gcd(gcd(v.x, v.y), v.z), d);
  return primitive(v);
}

void require_direction(const Point& direction) {
  for (const mpq_class* component : {&direction.x, &direction.y, &direction.z}) kernels::require_lowest_terms(*component);
  if (direction == Point{0, 0, 0}) throw std::invalid_argument("the direction of a ray may not be zero");
}

}  // namespace

}  // namespace fathom::approximate

namespace fathom {

mpq_class DirectionalDepth::factor() const { return penetration() ? penetration()->factor : mpq_class(0); }

Point DirectionalDepth::translation() const { return penetration() ? penetration()->translation : Point(); }

mpq_class DirectionalDepth::squared() const {
  const Point t = translation();
  return dot(t, t);
}

const Vector& DirectionalDepth::normal() const { return penetration() ? penetration()->normal : separation()->normal; }

DirectionalDepth Hierarchies::directional_depth(const Point& direction, Monitor* monitor) const {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_direction(direction);
  const BodyPair& pair = *pair_;
  if (pair.separation()) return {{pair.facts(), *pair.separation()}};
  kernels::Context(monitor).report("ray");
  mpq_class unit;
  const Vector u = approximate::integral(direction, unit);
  const approximate::RayHit hit = approximate::shoot_ray(pair.a(), pair.b(), u);
  if (!hit.hits || sgn(hit.factor) <= 0) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  const Point t = pair.translation(hit.factor, u);
  BodyPair::Meeting meeting = pair.meeting(hit.normal, t);
  if (!meeting.witness) throw std::logic_error("a ray leaves P beside the facet that it hits");
  const mpq_class factor = hit.factor / (unit * pair.placed().denominator);
  return {{pair.facts(), RayExit{factor, t, hit.normal, std::move(meeting.contact), *meeting.witness, hit.steps}}};
}

DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_direction(direction);
  return Hierarchies(a, b, monitor).directional_depth(direction, monitor);
}

}  // namespace fathom
