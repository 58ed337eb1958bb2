// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/vector.hpp"


#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

template <class Map>
Body mapped(const Body& body, Map map) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& point : body.points) result.points.push_back(map(point));
  return result;
}

}  // namespace

Rotation rotation(long w, long x, long y, long z) {
  const mpz_class norm = w * w + x * x + y * y + z * z;
  const auto entry = [&norm](long value) { return ratio(value, norm); };
  return {Point{entry(w * w + x * x - y * y - z * z), entry(2 * (x * y - w * z)), entry(2 * (x * z + w * y))},
          Point{entry(2 * (x * y + w * z)), entry(w * w - x * x + y * y - z * z), entry(2 * (y * z - w * x))},
          Point{entry(2 * (x * z - w * y)), entry(2 * (y * z + w * x)), entry(w * w - x * x - y * y + z * z)}};
}

Rotation random_rotation(Random& random) {
  const long w = random.between(1, 5);  // never 0, so the quaternion is not
  const long x = random.between(-5, 5);
  const long y = random.between(-5, 5);
  const long z = random.between(-5, 5);
  return rotation(w, x, y, z);
}

Body rotated(const Body& body, const Rotation& rotation) {
  return mapped(body, [&rotation](const Point& p) { return Point{dot(rotation[0], p), dot(rotation[1], p), dot(rotation[2], p)}; });
}

Body translated(const Body& body, const Point& by) {
  return mapped(body, [&by](const Point& p) { return p + by; });
}

Body scaled(const Body& body, const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return mapped(body, [&](const Point& p) { return Point{p.x * x, p.y * y, p.z * z}; });
}

Body scaled(const Body& body, const mpq_class& factor) { return scaled(body, factor, factor, factor); }

Bodies rotated(const Bodies& bodies, const Rotation& rotation) { return {rotated(bodies.a, rotation), rotated(bodies.b, rotation)}; }

Point random_shift(Random& random, long bound) {
  return {random_dyadic(random, -bound, bound, 20), random_dyadic(random, -bound, bound, 20), random_dyadic(random, -bound, bound, 20)};
}

}  // namespace fathom::families
