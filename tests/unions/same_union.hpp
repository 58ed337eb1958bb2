// SPDX-License-Identifier: GPL-3.0-or-later
// Two answers about the same unions, field by field.
#pragma once

#include <gtest/gtest.h>

#include "fathom/union.hpp"

namespace fathom::unions {

inline void expect_same(const std::vector<UnionOptimum>& x, const std::vector<UnionOptimum>& y) {
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_EQ(x[i].translation, y[i].translation);
    EXPECT_EQ(x[i].clearance, y[i].clearance);
    ASSERT_EQ(x[i].contacts.size(), y[i].contacts.size());
    for (std::size_t k = 0; k < x[i].contacts.size(); ++k) {
      const PieceContact &p = x[i].contacts[k], &q = y[i].contacts[k];
      EXPECT_EQ(p.a, q.a);
      EXPECT_EQ(p.b, q.b);
      EXPECT_EQ(p.direction, q.direction);
      EXPECT_EQ(p.contact, q.contact);
    }
  }
}

/// In all but the counters.
inline void expect_same(const UnionDepth& x, const UnionDepth& y) {
  EXPECT_EQ(x.status, y.status);
  EXPECT_EQ(x.complete, y.complete);
  EXPECT_EQ(x.low, y.low);
  EXPECT_EQ(x.high, y.high);
  expect_same(x.optima, y.optima);
  ASSERT_EQ(x.apart.has_value(), y.apart.has_value());
  if (x.apart) {
    EXPECT_EQ(x.apart->a, y.apart->a);
    EXPECT_EQ(x.apart->b, y.apart->b);
    EXPECT_EQ(x.apart->distance.squared, y.apart->distance.squared);
    EXPECT_EQ(x.apart->distance.direction, y.apart->distance.direction);
    EXPECT_EQ(x.apart->distance.contact, y.apart->distance.contact);
  }
  ASSERT_EQ(x.bounds.has_value(), y.bounds.has_value());
  if (x.bounds) {
    EXPECT_EQ(x.bounds->deepest_pair, y.bounds->deepest_pair);
    EXPECT_EQ(x.bounds->a, y.bounds->a);
    EXPECT_EQ(x.bounds->b, y.bounds->b);
    EXPECT_EQ(x.bounds->hulls, y.bounds->hulls);
  }
}

}  // namespace fathom::unions
