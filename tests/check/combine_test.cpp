// SPDX-License-Identifier: GPL-3.0-or-later
// The multipliers of a leaf, beside a naive twin: systems of equations over rationals, by
// elimination.
#include "verify/check/combine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/property.hpp"

namespace fathom_check {
namespace {

using Numbers = std::vector<mpq_class>;

/// Brings [m | right] to its reduced form, in place; returns the columns of m that have a leading
/// one.
std::vector<std::size_t> eliminate(std::vector<Numbers>& m, std::size_t columns) {
  std::vector<std::size_t> leading;
  for (std::size_t column = 0, top = 0; column < columns && top < m.size(); ++column) {
    const auto pivot = std::find_if(m.begin() + static_cast<std::ptrdiff_t>(top), m.end(),
                                    [&](const Numbers& row) { return row[column] != 0; });
    if (pivot == m.end()) continue;
    std::swap(*pivot, m[top]);
    const mpq_class scale = m[top][column];
    for (mpq_class& x : m[top]) x /= scale;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const mpq_class factor = m[i][column];
      for (std::size_t k = 0; i != top && k < m[i].size(); ++k) m[i][k] -= factor * m[top][k];
    }
    leading.push_back(column);
    ++top;
  }
  return leading;
}

/// n is a sum of l_i n_i, c of l_i c_i: the x with <n,x> >= c.
struct Sum {
  mpq_class x = 0, y = 0, z = 0, c = 0;
};

std::optional<Sum> sum_of(const std::vector<Constraint>& constraints, const Numbers& l) {
  Sum result;
  for (std::size_t i = 0; i < l.size(); ++i) {
    if (l[i] < 0) return std::nullopt;
    result.x += l[i] * constraints[i].n.x;
    result.y += l[i] * constraints[i].n.y;
    result.z += l[i] * constraints[i].n.z;
    result.c += l[i] * constraints[i].c;
  }
  return result;
}

/// The nearest point of all planes is that of the sum, where there is one; if the normals depend on
/// each other in one way alone, this way.
std::optional<Sum> combined_naive(const std::vector<Constraint>& constraints) {
  const std::size_t size = constraints.size();
  std::vector<Numbers> gram(size, Numbers(size + 1));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      mpz_class product;
      dot(product, constraints[i].n, constraints[k].n);
      gram[i][k] = product;
    }
    gram[i][size] = constraints[i].c;
  }
  const std::vector<std::size_t> leading = eliminate(gram, size);
  Numbers l(size);
  if (leading.size() == size) {
    for (std::size_t i = 0; i < size; ++i) l[i] = gram[i][size];
    return sum_of(constraints, l);
  }
  if (leading.size() + 1 < size) return std::nullopt;
  std::size_t free = 0;
  while (free < leading.size() && leading[free] == free) ++free;
  l[free] = 1;
  for (std::size_t i = 0; i < leading.size(); ++i) l[leading[i]] = -gram[i][free];
  if (const std::optional<Sum> sum = sum_of(constraints, l)) return sum;
  for (mpq_class& x : l) x = -x;
  return sum_of(constraints, l);
}

Constraint constraint(long x, long y, long z, long c) { return {{x, y, z}, c}; }

/// Whether the two say the same, up to a positive factor.
void compare(const std::vector<Constraint>& constraints) {
  const std::optional<Constraint> found = combined(constraints);
  const std::optional<Sum> expected = constraints.empty() ? std::nullopt : combined_naive(constraints);
  RC_ASSERT(found.has_value() == expected.has_value());
  if (!found) return;
  RC_ASSERT(sgn(found->c) == sgn(expected->c));
  RC_ASSERT(found->n.x * expected->c == found->c * expected->x);
  RC_ASSERT(found->n.y * expected->c == found->c * expected->y);
  RC_ASSERT(found->n.z * expected->c == found->c * expected->z);
  if (found->c == 0) RC_ASSERT(is_zero(found->n));
}

rc::Gen<std::vector<Constraint>> constraints(int size, int largest) {
  const auto small = [largest] { return rc::gen::inRange(-largest, largest + 1); };
  return rc::gen::container<std::vector<Constraint>>(
      static_cast<std::size_t>(size), rc::gen::apply([](int x, int y, int z, int c) { return constraint(x, y, z, c); },
                                                     small(), small(), small(), small()));
}

TEST(Combine, AgreesWithElimination) {
  for (const int size : {1, 2, 3, 4})
    for (const int largest : {1, 3, 1'000'000})
      EXPECT_TRUE(fathom::holds({.seed = 7, .runs = 1000}, [=] { compare(*constraints(size, largest)); }))
          << size << " of up to " << largest;
}

// Normals in a plane, or with one constraint repeated: the Gram matrix is singular.
TEST(Combine, AgreesWhereNormalsDepend) {
  for (const int size : {2, 3, 4})
    EXPECT_TRUE(fathom::holds({.seed = 7, .runs = 1000}, [=] {
      std::vector<Constraint> flat = *constraints(size, 2);
      for (Constraint& c : flat) c.n.z = c.n.x + c.n.y;
      compare(flat);
      std::vector<Constraint> twice = *constraints(size - 1, 3);
      twice.push_back(twice.front());
      compare(twice);
      twice.back().n.x *= -2;
      twice.back().n.y *= -2;
      twice.back().n.z *= -2;
      compare(twice);
    })) << size;
}

TEST(Combine, PositiveMultiplesSayTheSame) {
  EXPECT_TRUE(fathom::holds({.seed = 7, .runs = 1000}, [] {
    const int size = *rc::gen::inRange(1, 5);
    std::vector<Constraint> some = *constraints(size, 3);
    const std::optional<Constraint> before = combined(some);
    for (Constraint& c : some) {
      const int factor = *rc::gen::inRange(1, 9);
      c.n.x *= factor;
      c.n.y *= factor;
      c.n.z *= factor;
      c.c *= factor;
    }
    const std::optional<Constraint> after = combined(some);
    RC_ASSERT(after.has_value() == before.has_value());
    if (!after) return;
    RC_ASSERT(after->n.x * before->c == before->n.x * after->c);
    RC_ASSERT(after->n.y * before->c == before->n.y * after->c);
    RC_ASSERT(after->n.z * before->c == before->n.z * after->c);
    RC_ASSERT(sgn(after->c) == sgn(before->c));
  }));
}

TEST(Combine, ByHand) {
  EXPECT_FALSE(combined({}));
  const std::optional<Constraint> one = combined({constraint(-32, 0, 0, 32)});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->n.x, -1024);
  EXPECT_EQ(one->c, 1024);
  EXPECT_FALSE(combined({constraint(1, 0, 0, -1)})) << "a multiplier of -1";
  const std::optional<Constraint> corner =
      combined({constraint(-1, 0, 0, 1), constraint(0, -1, 0, 2), constraint(0, 0, -1, 2)});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->c, 9);
  const std::optional<Constraint> empty = combined({constraint(2, 0, 0, 3), constraint(-1, 0, 0, -1)});
  ASSERT_TRUE(empty) << "2 x >= 3 and x <= 1";
  EXPECT_EQ(empty->n.x, 0);
  EXPECT_EQ(empty->c, 1);  // the first column of the adjugate is (1, 2)
  const std::optional<Constraint> four =
      combined({constraint(1, 1, 1, 1), constraint(-1, 0, 0, 0), constraint(0, -1, 0, 0), constraint(0, 0, -1, 0)});
  ASSERT_TRUE(four) << "x + y + z >= 1, and none of them is positive";
  EXPECT_TRUE(is_zero(four->n));
  EXPECT_GT(four->c, 0);
  EXPECT_FALSE(combined({constraint(1, 0, 0, 1), constraint(1, 0, 0, 1), constraint(1, 0, 0, 1)}))
      << "the adjugate is zero";
  EXPECT_FALSE(combined(std::vector<Constraint>(5, constraint(1, 0, 0, 1))));
}

}  // namespace
}  // namespace fathom_check
