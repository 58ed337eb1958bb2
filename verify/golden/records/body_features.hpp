// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of a record with the hulls and measures of its bodies, from which flags are decided.
#pragma once

#include <vector>

#include "reference/polytope/polytope.hpp"
#include "verify/golden/records/faces.hpp"
#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// A body's measures.
struct BodyLook {
  std::vector<Vector> distinct;  ///< its points, each once, in lexicographic order
  polytope::Polytope hull;
  std::vector<Vector> edges;    ///< primitive directions with a positive first component that is not 0, sorted
  std::vector<Vector> normals;  ///< of facets, outward, sorted
  mpq_class shortest, longest;  ///< sides of the axis-parallel bounding box

  BodyLook(const std::vector<Vector>& points, const mpz_class& denominator);
};

struct Look {
  const Facts& facts;
  Integers integers;
  BodyLook a, b;
  mpz_class greatest, least;  ///< magnitudes of coordinates other than 0, in the unit of `integers`; 0 if there are none

  explicit Look(const Facts& facts);

  [[nodiscard]] const mpq_class& extent() const { return a.longest < b.longest ? b.longest : a.longest; }
};

/// Whether two sorted lists share a vector.
bool meet(const std::vector<Vector>& u, const std::vector<Vector>& v);

}  // namespace fathom::golden
