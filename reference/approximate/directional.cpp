// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/directional.hpp"

#include "kernels/float_environment.hpp"
#include "kernels/number/lowest_terms.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom {
namespace {

/// The primitive integer vector of the same direction; direction = `unit` times it.
Vector integral(const Point& direction, mpq_class& unit) {
  const mpz_class d = lcm(lcm(direction.x.get_den(), direction.y.get_den()), direction.z.get_den());
  const Vector v{mpq_class(d * direction.x).get_num(), mpq_class(d * direction.y).get_num(), mpq_class(d * direction.z).get_num()};
  unit = mpq_class(gcd(gcd(v.x, v.y), v.z), d);
  unit.canonicalize();
  return primitive(v);
}

}  // namespace

DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction,
                                   const ReportProgress& progress) {
  const DefaultFloatEnvironment environment;
  for (const mpq_class* component : {&direction.x, &direction.y, &direction.z}) require_lowest_terms(*component);
  if (direction == Point{0, 0, 0}) throw std::invalid_argument("the direction of a ray may not be zero");
  const BodyPair pair(a, b, progress);
  DirectionalDepth result;
  result.status = pair.status();
  result.normal = pair.separating();
  result.flat_a = pair.flat_a();
  result.flat_b = pair.flat_b();
  if (pair.status() != Status::penetrating) return result;
  report(progress, "ray");
  mpq_class unit;
  const Vector u = integral(direction, unit);
  const RayHit hit = shoot_ray(pair.a(), pair.b(), u);
  if (!hit.hits || sgn(hit.factor) <= 0) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  result.translation = pair.translation(hit.factor, u);
  result.factor = hit.factor / (unit * pair.lattice().denominator);
  const Point& t = result.translation;
  result.squared = t.x * t.x + t.y * t.y + t.z * t.z;
  result.normal = hit.normal;
  result.contact = pair.contact(hit.normal);
  result.witness = pair.witness(hit.normal, t);
  result.steps = hit.steps;
  return result;
}

}  // namespace fathom
