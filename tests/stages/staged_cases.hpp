// SPDX-License-Identifier: GPL-3.0-or-later
// Cases with their stages, and the same stages made by hand: what the tests of the room compare.
#pragma once

#include <cmath>
#include <vector>

#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "view/stages/stages.hpp"

namespace fathom::testing {

/// Of every family one of each size, and the catalogue.
inline std::vector<Case> staged_cases(std::initializer_list<unsigned> sizes) {
  std::vector<Case> cases;
  for (const unsigned size : sizes) {
    for (const Case& input : cases_of_all_families(1, size)) cases.push_back(input);
  }
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

inline double dot(const stages::Place& p, const stages::Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

/// The squared distance of the lines through two edges, in the unit of the input; none if they are
/// parallel.
inline std::optional<mpq_class> line_distance(const Prepared& p, stages::Index e, stages::Index f) {
  const polytope::Edge &of_a = p.a.edges[e], &of_b = p.b.edges[f];
  const Vector w =
      cross(p.a.vertices[of_a.to] - p.a.vertices[of_a.from], p.b.vertices[of_b.to] - p.b.vertices[of_b.from]);
  if (is_zero(w)) return std::nullopt;
  const mpz_class height = fathom::dot(p.b.vertices[of_b.from] - p.a.vertices[of_a.from], w);
  mpq_class squared(height * height, fathom::dot(w, w) * p.placed.denominator * p.placed.denominator);
  squared.canonicalize();
  return squared;
}

}  // namespace fathom::testing
