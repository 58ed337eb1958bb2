// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// A rational direction in the plane: the angle 2 atan(t).
struct PlaneDirection {
  mpq_class x, y;
};

PlaneDirection plane_direction(const mpq_class& t) {
  const mpq_class norm = 1 + t * t;
  return {mpq_class((1 - t * t) / norm), mpq_class(2 * t / norm)};
}

mpq_class random_length(Random& random) { return ratio(random.between(16, 64), 32); }

void add(Body& body, const PlaneDirection& direction, const mpq_class& length) {
  body.points.push_back({mpq_class(length * direction.x), mpq_class(length * direction.y), 0});
}

/// A vertex at O, an edge with O inside, or a polygon of 3 to 6 corners with O inside; in z = 0, within a distance of 2.
Body feature_body(FeatureKind feature, const PlaneDirection& edge, Random& random) {
  Body body;
  if (feature == FeatureKind::vertex) body.points.push_back({0, 0, 0});
  if (feature == FeatureKind::edge) {
    add(body, edge, random_length(random));
    add(body, edge, mpq_class(-random_length(random)));
  }
  if (feature == FeatureKind::face) {
    // Angles of 0 and about +-120 degrees: O is inside whatever the lengths, and more corners do no harm.
    const PlaneDirection first = plane_direction(0), second = plane_direction(ratio(7, 4)), third = plane_direction(ratio(-7, 4));
    for (const PlaneDirection* direction : {&first, &second, &third}) add(body, *direction, random_length(random));
    for (std::int64_t more = random.between(0, 3); more > 0; --more) {
      const mpq_class t = ratio(random.between(-32, 32), 8);
      add(body, plane_direction(t), random_length(random));
    }
  }
  return body;
}

/// Adds a base around z = -4 that is wider than any feature.
void add_base(Body& body, Random& random, unsigned n) {
  for (unsigned i = 0; i < std::max(4u, n); ++i) {
    const int x = i % 2 ? 1 : -1, y = i / 2 % 2 ? 1 : -1;  // the four quadrants in turn
    const mpq_class across = random_length(random), along = random_length(random), down = random_length(random);
    body.points.push_back({mpq_class(x * (3 + across)), mpq_class(y * (3 + along)), mpq_class(-3 - down)});
  }
}

/// B below z = 0, A above z = -overlap.
Bodies facing(FeatureKind a, FeatureKind b, const PlaneDirection& edge_a, const PlaneDirection& edge_b, const mpq_class& overlap,
              Random& random, unsigned n) {
  Body upper = feature_body(a, edge_a, random);
  add_base(upper, random, n);
  upper = translated(scaled(upper, 1, 1, -1), {0, 0, mpq_class(-overlap)});
  Body lower = feature_body(b, edge_b, random);
  add_base(lower, random, n);
  return {upper, lower};
}

/// Now and then the axes stay where they are, so that features lie in coordinate planes.
Bodies turned(const Bodies& bodies, Random& random) {
  const bool stays = random.between(0, 3) == 0;
  return stays ? bodies : rotated(bodies, random_rotation(random));
}

Bodies apart(FeatureKind a, FeatureKind b, const mpq_class& overlap, Random& random, unsigned n) {
  const PlaneDirection edge_a = plane_direction(ratio(random.between(-4, 4), 16));   // within about 28 degrees of the x-axis
  const PlaneDirection edge_b = plane_direction(ratio(random.between(12, 20), 16));  // and of the y-axis
  return turned(facing(a, b, edge_a, edge_b, overlap, random, n), random);
}

}  // namespace

Bodies touching(FeatureKind a, FeatureKind b, Random& random, unsigned n) { return apart(a, b, 0, random, n); }

Bodies touching_parallel_edges(Random& random, unsigned n) {
  const PlaneDirection edge = plane_direction(ratio(random.between(-16, 16), 16));
  return turned(facing(FeatureKind::edge, FeatureKind::edge, edge, edge, 0, random, n), random);
}

Bodies overlapping(FeatureKind a, FeatureKind b, Random& random, unsigned n) {
  const mpq_class overlap = times_power_of_two(1, -random.between(4, 40));
  return apart(a, b, overlap, random, n);
}

Bodies nearly_touching(Random& random, unsigned n) {
  constexpr FeatureKind kinds[] = {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};
  const FeatureKind a = kinds[random.between(0, 2)], b = kinds[random.between(0, 2)];
  const mpq_class size = times_power_of_two(1, -random.between(4, 60));
  const bool overlap = random.coin();
  return apart(a, b, overlap ? size : mpq_class(-size), random, n);
}

}  // namespace fathom::families
