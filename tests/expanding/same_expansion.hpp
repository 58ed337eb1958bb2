// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two expansions are the same in every field.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "reference/expanding/expanding_polytope.hpp"
#include "verify/families/families.hpp"

namespace fathom::expanding {

/// `finer`: the unit of y is that of x over 2^finer. Normals of triangles are squares of it.
inline void expect_same(const Expansion& x, const Expansion& y, unsigned finer = 0) {
  ASSERT_EQ(x.end, y.end);
  EXPECT_EQ(x.points, y.points);
  EXPECT_EQ(mpz_class(x.nearest.numerator() << 6 * finer), y.nearest.numerator());
  if (x.end == ExpansionEnd::proved) {
    EXPECT_EQ(mpz_class(x.nearest.denominator() << 4 * finer), y.nearest.denominator());
  }
  EXPECT_EQ(x.nearest.directions(), y.nearest.directions());
  EXPECT_EQ(x.inner.vertices, y.inner.vertices);
  EXPECT_EQ(x.inner.facets, y.inner.facets);
  EXPECT_EQ(x.sides, y.sides);
  EXPECT_EQ(x.sides_exact, y.sides_exact);
}

/// Calls in(integer) with all integers of fixed size that hold what is computed; returns how many
/// do.
template <class In>
int in_all_integers(long exponent, In in) {
  if (exponent > polytope::most_narrow_bits) return 0;
  in(polytope::NarrowInteger());
  if (exponent > polytope::most_bits_for<kernels::Integer255>) return 1;
  in(kernels::Integer255(0));
  if (exponent > polytope::most_bits_for<kernels::Integer127>) return 2;
  in(kernels::Integer127(0));
  return 3;
}

/// Compares the search in all these integers with its twin; returns how many they are.
inline int expect_same_in_all_integers(const polytope::NarrowMemory& placed, const polytope::Points& a,
                                       const polytope::Points& b, std::size_t budget, Workspace& workspace,
                                       const Expansion& twin) {
  kernels::ScanMemory memory;
  kernels::Context context;
  return in_all_integers(placed.exponent, [&]<class Integer>(Integer) {
    const auto finer = static_cast<unsigned>(std::max(placed.power, 0L));
    expect_same(nearest_by_expansion(context, placed.pair<Integer>(a, b, memory), budget, &workspace), twin, finer);
  });
}

/// Compares all ways to expand for this pair. Returns how they ended, and whether the pair lies on
/// a narrow lattice that is found in words.
inline std::pair<ExpansionEnd, bool> expect_same_expansions(const Case& input, Workspace& workspace) {
  SCOPED_TRACE(input.id);
  constexpr std::size_t budget = 500;
  kernels::Context context;
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  const Expansion twin = nearest_by_expansion_in<mpz_class>(context, clouds.a, clouds.b, budget, &workspace);
  expect_same(nearest_by_expansion(context, clouds.a, clouds.b, budget, &workspace), twin);
  expect_same(nearest_by_expansion_in<kernels::LazyInteger>(context, clouds.a, clouds.b, budget, &workspace), twin);
  in_all_integers(clouds.exponent(), [&]<class Integer>(Integer) {
    expect_same(nearest_by_expansion_in<Integer>(context, clouds.a, clouds.b, budget, &workspace), twin);
  });
  polytope::NarrowMemory placed;
  const bool in_words = polytope::place_narrow(input.a.points, input.b.points, placed);
  if (in_words) expect_same_in_all_integers(placed, input.a.points, input.b.points, budget, workspace, twin);
  return {twin.end, in_words};
}

}  // namespace fathom::expanding
