// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs and right answers for tests of the judge.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "tests/support/boxes.hpp"

namespace fathom::testing {

inline std::vector<Point> cube(const mpq_class& x, const mpq_class& y = 0, const mpq_class& z = 0) {
  return box({x, y, z}, {x + 1, y + 1, z + 1});
}

/// Unit cubes, the second one 2/5 away along x: the depth is 3/5, and A moves towards -x.
inline const Truth& cubes() {
  static const Truth truth = truth_about(cube(0), cube(mpq_class(2, 5)));
  return truth;
}

inline Reply overlap(std::optional<double> depth, std::optional<Triple> direction = {}) {
  Reply reply;
  reply.overlap = true;
  reply.depth = depth;
  reply.direction = direction;
  return reply;
}

inline Reply apart(double distance, std::optional<Triple> direction = {}) {
  Reply reply;
  reply.distance = distance;
  reply.direction = direction;
  return reply;
}

/// A vector as a subject would give it, or its unit vector: each component rounded once.
inline Triple rounded(const Point& p) {
  const auto nearest = [](const mpq_class& x) { return round_binary64(x, Rounding::rn); };
  return {nearest(p.x), nearest(p.y), nearest(p.z)};
}
inline Triple unit(const Vector& n) {
  const mpz_class square = dot(n, n);
  const auto component = [&](const mpz_class& x) {
    return kernels::nearest_binary64({0, kernels::ratio(x * abs(x), square)});
  };
  return {component(n.x), component(n.y), component(n.z)};
}
inline Triple opposite(const Triple& u) { return {-u[0], -u[1], -u[2]}; }

/// The right answer with the k-th optimum; of bodies that do not penetrate, the right
/// classification (of touching ones: overlap).
inline Reply right_answer(const Depth& depth, std::size_t k = 0) {
  if (depth.status() == Status::disjoint) return {};
  if (depth.status() == Status::touching) return overlap({});
  Reply reply = overlap(root_binary64(depth.squared(), Rounding::rn), unit(depth.optima()[k].direction));
  if (k == 0 && depth.witness()) {
    reply.witness_a = rounded(depth.witness()->a);
    reply.witness_b = rounded(depth.witness()->b);
  }
  return reply;
}

}  // namespace fathom::testing
