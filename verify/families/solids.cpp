// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

/// (0, +-p, +-q) and its cyclic shifts: twelve points.
void add_cyclic(Body& body, const mpq_class& p, const mpq_class& q) {
  for (const int s : {-1, 1})
    for (const int t : {-1, 1}) {
      const mpq_class u = s * p, v = t * q;
      body.points.push_back({0, u, v});
      body.points.push_back({v, 0, u});
      body.points.push_back({u, v, 0});
    }
}

void add_polygon(Body& body, unsigned n, unsigned phase, const mpq_class& z) {
  const long bits = circle_bits(n);
  for (const CirclePoint& corner : regular_polygon(n, phase))
    body.points.push_back({times_power_of_two(corner.cosine, -bits), times_power_of_two(corner.sine, -bits), z});
}

}  // namespace

Body box(const mpq_class& half_x, const mpq_class& half_y, const mpq_class& half_z) {
  Body body;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) body.points.push_back({mpq_class(x * half_x), mpq_class(y * half_y), mpq_class(z * half_z)});
  return body;
}

Body tetrahedron() { return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}; }

Body cube() { return box(1, 1, 1); }

Body octahedron() { return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}}; }

Body dodecahedron() {
  const mpq_class h = ratio(55, 89);  // the pentagons of (0, +-(1 - h^2), +-(1 + h)) with the cube are planar for every h
  Body body = cube();
  add_cyclic(body, mpq_class(1 - h * h), mpq_class(1 + h));
  return body;
}

Body icosahedron() {
  Body body;
  add_cyclic(body, 1, ratio(89, 55));
  return body;
}

Body platonic(unsigned index) {
  switch (index % 5) {
    case 0: return tetrahedron();
    case 1: return cube();
    case 2: return octahedron();
    case 3: return dodecahedron();
    default: return icosahedron();
  }
}

Body prism(unsigned n, const mpq_class& half_height, unsigned phase) {
  Body body;
  add_polygon(body, n, phase, -half_height);
  add_polygon(body, n, phase, half_height);
  return body;
}

Body antiprism(unsigned n, const mpq_class& half_height) {
  Body body;
  add_polygon(body, n, 0, -half_height);
  add_polygon(body, n, 2, half_height);
  return body;
}

}  // namespace fathom::families
