// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the position of O share: small sets, the brute-force twin, bodies with a chosen
// feature in front.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/polytope/position.hpp"

namespace fathom::polytope::position_test {

using Small = Vec3<long>;
using SmallSet = std::vector<Small>;

inline bool none(const Small& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// The naive twin. u is admissible if u != 0 and <u, p> <= 0 for all differences p. If the
// differences span R^3, the admissible u form a cone without lines, whose extreme rays are normal
// to two differences each: list them all. If they do not, they do together with +-n for a basis n
// of their orthogonal complement, which only keeps the admissible u of their span. O is outside iff
// the sum of the rays is negative on every difference (some admissible u must be, and it is a sum
// of rays).
inline Position position_naive(const SmallSet& a, const SmallSet& b) {
  SmallSet differences, basis;
  for (const Small& p : a)
    for (const Small& q : b) differences.push_back(q - p);
  const auto independent = [&basis](const Small& v) {
    return basis.empty()       ? !none(v)
           : basis.size() == 1 ? !none(cross(basis[0], v))
                               : basis.size() == 2 && det(basis[0], basis[1], v) != 0;
  };
  for (const Small& p : differences)
    if (independent(p)) basis.push_back(p);
  const bool flat = basis.size() < 3;
  SmallSet constraints = differences;
  const auto add_line = [&](const Small& n) {
    constraints.push_back(n);
    constraints.push_back(-n);
    basis.push_back(n);
  };
  if (basis.empty()) return Position::boundary;
  if (basis.size() == 1) {
    const Small e = none(cross(basis[0], Small{1, 0, 0})) ? Small{0, 1, 0} : Small{1, 0, 0};
    add_line(cross(basis[0], e));
  }
  if (basis.size() == 2) {
    add_line(cross(basis[0], basis[1]));
  }
  Small sum{0, 0, 0};
  bool admissible = false;
  for (const Small& p : constraints) {
    for (const Small& q : constraints) {
      const Small u = cross(p, q);
      if (none(u) ||
          std::any_of(constraints.begin(), constraints.end(), [&u](const Small& r) { return dot(u, r) > 0; }))
        continue;
      admissible = true;
      sum = sum + u;
    }
  }
  if (std::all_of(differences.begin(), differences.end(), [&sum](const Small& p) { return dot(sum, p) < 0; }))
    return Position::outside;
  return flat || admissible ? Position::boundary : Position::inside;
}

inline Vector exact(const Small& p) { return {p.x, p.y, p.z}; }

inline std::vector<Vector> exact(const SmallSet& set) {
  std::vector<Vector> points;
  for (const Small& p : set) points.push_back(exact(p));
  return points;
}

// Solves, checks the proof, and returns the answer.
inline PositionOfOrigin proved(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  const long exponent = std::max(kernels::binary_exponent(a), kernels::binary_exponent(b));
  const PositionOfOrigin answer =
      position_of_origin(kernels::PointCloud(a, exponent), kernels::PointCloud(b, exponent));
  for (const std::string& fault : validate(answer, a, b).faults) ADD_FAILURE() << fault;
  if (answer.position == Position::inside) {
    EXPECT_GE(answer.surrounding.size(), 4U);
    EXPECT_LE(answer.surrounding.size(), 6U) << "law: Steinitz";
  }
  return answer;
}

inline Position position(const SmallSet& a, const SmallSet& b) {
  const PositionOfOrigin answer = proved(exact(a), exact(b));
  SmallSet surrounding;
  for (const auto& [i, j] : answer.surrounding) surrounding.push_back(b[j] - a[i]);
  if (answer.position == Position::inside) {
    EXPECT_EQ(position_naive({{0, 0, 0}}, surrounding), Position::inside);
  }
  return answer.position;
}

inline rc::Gen<SmallSet> lattice_set() {
  const auto c = rc::gen::element(-2L, -1L, 0L, 1L, 2L);
  const auto point = rc::gen::map(rc::gen::tuple(c, c, c), [](const auto& t) {
    return Small{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
  return rc::gen::mapcat(rc::gen::element<std::size_t>(1, 2, 3, 4, 5, 6),
                         [point](std::size_t n) { return rc::gen::container<SmallSet>(n, point); });
}

// Each kind of feature as a face of a solid body that lies in z <= 0 (A), or in z >= 0 when
// mirrored (B).
inline SmallSet solid_with(const std::string& feature) {
  if (feature == "vertex") return {{0, 0, 0}, {3, 0, -3}, {-3, 2, -3}, {-3, -2, -3}};
  if (feature == "edge") return {{-4, -1, 0}, {4, 1, 0}, {1, -4, -3}, {-1, 4, -3}};
  return {{-4, -3, 0}, {4, -3, 0}, {1, 4, 0}, {0, 0, -5}};
}

inline SmallSet mirrored(const SmallSet& set, long lift) {
  SmallSet r;
  for (const Small& p : set) r.push_back({-p.y, p.x, lift - p.z});
  return r;
}

}  // namespace fathom::polytope::position_test
