// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of a certificate of unions: each reason for which it is refused, on unions whose
// differences are boxes.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/check/edits.hpp"
#include "tests/check/union_texts.hpp"
#include "tests/support/property.hpp"
#include "verify/check/check.hpp"
#include "verify/check/checks.hpp"
#include "verify/check/limits.hpp"

namespace fathom_check {
namespace {

using Nodes = std::vector<std::string>;

const std::string split_on_six = "split 0 0 1 2 3 4 5";
const Nodes six_leaves{split_on_six, "leaf 0", "leaf 1", "leaf 2", "leaf 3", "leaf 4", "leaf 5"};

// What is in none of the three is x <= -1, y <= -2, z <= -2, or far away: the nearest place is the
// corner, 3 away.
const std::vector<DifferenceBox> slabs{{{-1, -9, -9}, {9, 9, 9}}, {{-9, -2, -9}, {9, 9, 9}}, {{-9, -9, -2}, {9, 9, 9}}};
const Triple corner{-1, -2, -2};
const Nodes to_the_corner{"split 0 0", "split 1 2", "split 2 4", "leaf 0 1 2"};

std::string said(const UnionText& text) {
  const Verdict verdict = verify(text.text());
  return verdict.accepted()                      ? "accepted"
         : verdict.outcome == Outcome::malformed ? "malformed: " + verdict.reason
                                                 : verdict.reason;
}
std::string of_cube(const Nodes& tree, const std::vector<Triple>& optima = six, const std::string& q = "1") {
  return said(boxes(q, {cube}, optima, tree));
}
std::string of_slabs(const Nodes& tree, const std::vector<Triple>& optima = {corner}, const std::string& q = "9") {
  return said(boxes(q, slabs, optima, tree));
}

const std::string not_listed = "a facet that is not done is not among the children",
                  nearer = "these constraints leave a place that is nearer, or not listed",
                  no_multipliers = "these constraints have no multipliers that are not negative",
                  ends = "the tree ends before this node",
                  goes_on = "behind this node the tree goes on: a child is missing",
                  no_constraint = "the path has no constraint of this number";

TEST(CheckTree, Accepts) {
  EXPECT_EQ(of_cube({"split 0"}), "accepted");
  EXPECT_EQ(of_cube(six_leaves), "accepted");
  EXPECT_EQ(of_slabs(to_the_corner), "accepted");
  EXPECT_EQ(of_cube({"split 0 3", "leaf 0"}), "accepted") << "what is done may be listed";
  EXPECT_EQ(of_cube({"split 0 3 3 3", "leaf 0", "leaf 1", "leaf 2"}), "accepted") << "twice does no harm";
  EXPECT_EQ(of_cube({"split 0 3", "split 0 3", "split 0"}), "accepted") << "a polytope may split again";
  EXPECT_EQ(verdict_line(verify(boxes("9", slabs, {corner}, to_the_corner).text()), "x"),
            "s VERIFIED penetrating depth_squared=9 optima=1 pieces=1x3 boxes");
}

TEST(CheckTree, FacetsThatAreNotDone) {
  EXPECT_EQ(of_slabs({"split 0", "split 1 2", "split 2 4", "leaf 0 1 2"}), not_listed);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1", "split 2 4", "leaf 0 1 2"}), not_listed);
  EXPECT_EQ(of_slabs({"split 0 1", "split 1 2", "split 2 4", "leaf 0 1 2"}), not_listed) << "another facet";
  // Done is what is beyond the depth, or at the depth and listed.
  for (std::size_t k = 0; k < six.size(); ++k) {
    std::vector<Triple> five = six;
    five.erase(five.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(of_cube({"split 0"}, five), not_listed) << k;
    EXPECT_EQ(of_cube(six_leaves, five), nearer) << k;
  }
  EXPECT_EQ(said(boxes("1", {{{-1, -2, -2}, {2, 2, 2}}}, {{-1, 0, 0}}, {"split 0"})), "accepted")
      << "one at the depth, five beyond it";
  EXPECT_EQ(said(boxes("4", {{{-1, -2, -2}, {2, 2, 2}}}, {{-2, 0, 0}}, {"split 0"})), not_listed) << "one before it";
}

// <N,x> >= d with d <= 0 holds O and more: it is never done, however far away the plane is.
TEST(CheckTree, AFacetBehindOIsNotDone) {
  const DifferenceBox far{{10, -9, -9}, {20, 9, 9}};
  EXPECT_EQ(said(boxes("16", {{{-5, -5, -5}, {5, 5, 5}}, far}, {}, {"split 1"})), "there is no optimum");
  EXPECT_EQ(said(boxes("16", {{{-4, -5, -5}, {5, 5, 5}}, far}, {{-4, 0, 0}}, {"split 1"})), not_listed);
  EXPECT_EQ(said(boxes("16", {{{-4, -5, -5}, {5, 5, 5}}, far}, {{-4, 0, 0}}, {"split 1 0", "leaf 0"})), no_multipliers);
  EXPECT_EQ(said(boxes("16", {{{-4, -5, -5}, {5, 5, 5}}, far}, {{-4, 0, 0}}, {"split 1 0", "split 0"})), "accepted");
  const DifferenceBox at{{0, -9, -9}, {20, 9, 9}};
  EXPECT_EQ(said(boxes("16", {{{-4, -5, -5}, {5, 5, 5}}, at}, {{-4, 0, 0}}, {"split 1"})), not_listed) << "d = 0";
}

// A child twice is one facet; it does not stand for another.
TEST(CheckTree, AChildTwiceDoesNotCountTwice) {
  const std::vector<DifferenceBox> two{{{-1, -1, -9}, {9, 9, 9}}, {{-9, -9, -9}, {9, 9, 9}}};
  EXPECT_EQ(said(boxes("81", two, {{-9, 0, 0}, {0, -9, 0}, {0, 0, -9}, {0, 0, 9}, {0, 9, 0}, {9, 0, 0}},
                       {"split 0 0 2", "split 1", "split 1"})),
            "accepted");
  for (const char* split : {"split 0 0 0", "split 0 2 2", "split 0 0", "split 0 0 1"}) {
    Nodes tree(std::string(split).size() > 9 ? 3 : 2, "split 1");
    tree[0] = split;
    EXPECT_EQ(said(boxes("81", two, {{-9, 0, 0}, {0, -9, 0}, {0, 0, -9}, {0, 0, 9}, {0, 9, 0}, {9, 0, 0}}, tree)),
              not_listed)
        << split;
  }
}

TEST(CheckTree, IsOneTree) {
  EXPECT_EQ(of_cube({}), "a tree has a root");
  EXPECT_EQ(of_cube({"split 0", "split 0"}), ends);
  Nodes more = six_leaves, fewer = six_leaves;
  more.emplace_back("leaf 0");
  fewer.pop_back();
  EXPECT_EQ(of_cube(more), ends);
  EXPECT_EQ(of_cube(fewer), goes_on);
  EXPECT_EQ(of_cube({split_on_six}), goes_on);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4"}), goes_on);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "leaf 0 1 2", "split 0 0"}), ends);
  const UnionText text = boxes("1", {cube}, six, more);
  EXPECT_EQ(verify(text.text()).line + 1, verify(edited(text.text(), "end 1", "end 2")).line)
      << "that of the node too many, before 'end'";
}

TEST(CheckTree, IndicesAreInRange) {
  EXPECT_EQ(of_cube({"split 1"}), "there is no polytope of this number");
  EXPECT_EQ(of_cube({"split 4294967295"}), "there is no polytope of this number");
  EXPECT_EQ(of_cube({"split 99999999999999999999"}), "there is no polytope of this number");
  EXPECT_EQ(of_cube({"split 0 6", "leaf 0"}), "the polytope has no facet of this number");
  EXPECT_EQ(of_slabs({"split 0 6", "split 1 2", "split 2 4", "leaf 0 1 2"}), "the polytope has no facet of this number")
      << "that of the next";
  EXPECT_EQ(of_cube({split_on_six, "leaf 1", "leaf 1", "leaf 2", "leaf 3", "leaf 4", "leaf 5"}), no_constraint);
  EXPECT_EQ(of_cube({split_on_six, "leaf 0", "leaf 2", "leaf 2", "leaf 3", "leaf 4", "leaf 5"}), no_constraint);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "leaf 0 1 3"}), no_constraint);
  EXPECT_EQ(of_cube({"leaf 0"}), no_constraint) << "the path of the root is empty";
}

TEST(CheckTree, LeavesOfTooFewOrTooManyConstraints) {
  EXPECT_EQ(of_cube({"leaf"}), no_multipliers);
  EXPECT_EQ(of_cube({"split 0 0", "leaf"}), no_multipliers);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "leaf 0 1"}), nearer);
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "leaf 1 2"}), nearer);
  EXPECT_EQ(of_cube({split_on_six, "leaf 0", "leaf 1", "leaf 2", "leaf 3", "leaf 4", "leaf 0 1 2 3 5"}),
            "a leaf has at most four constraints");
}

// The path: below all children listed before, in their order, and beyond the facet of the child.
TEST(CheckTree, ThePathIsThatOfTheChild) {
  // Of the child beyond facet 2, constraint 0 is -<N_0,x> >= -d_0: it holds O, and more.
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "leaf 0 0 0"}), no_multipliers)
      << "one constraint three times: the adjugate is zero";
  EXPECT_EQ(of_cube({"split 0 0 1", "leaf 0", "leaf 0"}), no_multipliers) << "l = c_0 = -1";
  EXPECT_EQ(of_cube({"split 0 0 1", "leaf 0", "leaf 1"}), "accepted");
  // The path of a child does not keep what is below the child before: there it has 0, 1, 2, here 0
  // and 1.
  EXPECT_EQ(of_cube({"split 0 0 1", "split 0 0 1", "leaf 0", "leaf 2", "leaf 1"}), "accepted");
  EXPECT_EQ(of_cube({"split 0 0 1", "split 0 0 1", "leaf 0", "leaf 2", "leaf 2"}), no_constraint);
  EXPECT_EQ(of_cube({"split 0 0 1 2", "leaf 0", "leaf 1", "leaf 1"}), no_multipliers) << "by then x is below facet 1";
  EXPECT_EQ(of_cube({"split 0 0 1 2", "leaf 0", "leaf 1", "leaf 2"}), "accepted");
}

// 9 <= x <= -1: no multiple of one constraint is done, the sum of both is 0 >= 10.
TEST(CheckTree, ACellThatIsEmpty) {
  const auto with_leaf = [](const std::string& leaf) {
    return of_slabs({"split 0 1 0", "split 0 0", leaf, "split 1 2", "split 2 4", "leaf 1 2 3"});
  };
  EXPECT_EQ(with_leaf("leaf 0 1"), "accepted");
  EXPECT_EQ(with_leaf("leaf 1"), nearer);
  EXPECT_EQ(with_leaf("leaf 1 1"), no_multipliers);
  // Two cells between the planes x = -1 and x = 9, where the sum is 0 >= -10.
  EXPECT_EQ(of_slabs({"split 0 1 0", "leaf 0", "split 1 2", "split 2 4", "leaf 1 2 3"}), "accepted");
  EXPECT_EQ(of_slabs({"split 0 1 0", "leaf 0", "split 1 2", "split 2 4", "leaf 0 1 2 3"}), no_multipliers);
  // Four constraints, of which two have the multiplier 0.
  EXPECT_EQ(of_slabs({"split 0 0", "split 1 2", "split 2 4", "split 0 1 0", "leaf 0 1 2 3", "leaf 0 1 2"}), "accepted");
}

// The claim is true or false by 1/1000.
TEST(CheckTree, TheDepthIsExact) {
  EXPECT_EQ(of_slabs(to_the_corner, {corner}, "9001/1000"), "the length of this translation is not the depth");
  const std::string text = boxes("9", slabs, {corner}, to_the_corner).text();
  // The place (-2,-2,-1) is inside of the second slab: not outside of W.
  EXPECT_EQ(verify(edited(text, "optimum -1 -2 -2", "optimum -2 -2 -1")).reason,
            "this direction does not separate the two pieces");
  // (-2/3,-7/3,-7/3) would be the nearest if the first slab ended there.
  std::vector<DifferenceBox> shorter = slabs;
  shorter[0].low[0] = -2;
  EXPECT_EQ(said(boxes("9", shorter, {corner}, to_the_corner)), "this direction does not separate the two pieces");
  EXPECT_EQ(said(boxes("12", shorter, {{-2, -2, -2}}, to_the_corner)), "accepted");
}

TEST(CheckTree, Nodes) {
  for (const char* node :
       {"split", "leaf ", "leaf x", "leaf 1/2", "leaf -1", "split -1", "split 0  0", "node 0", "", "0", "Leaf 0"})
    EXPECT_EQ(of_cube({node}).substr(0, 10), "malformed:") << node;
  EXPECT_EQ(of_cube({"split 0 00"}), goes_on);
}

// Of coordinates that are fractions; the optima are looked up by their values, whatever the
// denominators.
TEST(CheckTree, Fractions) {
  std::string text = boxes("1", {cube}, six, {"split 0"}).text();
  text = edited(
      text, "a 8\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n",
      "a 8\n1/3 1/5 1/7\n4/3 1/5 1/7\n1/3 6/5 1/7\n4/3 6/5 1/7\n1/3 1/5 8/7\n4/3 1/5 8/7\n1/3 6/5 8/7\n4/3 6/5 8/7\n");
  text = edited(
      text, "b 8\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n",
      "b 8\n1/3 1/5 1/7\n4/3 1/5 1/7\n1/3 6/5 1/7\n4/3 6/5 1/7\n1/3 1/5 8/7\n4/3 1/5 8/7\n1/3 6/5 8/7\n4/3 6/5 8/7\n");
  EXPECT_TRUE(verify(text).accepted()) << verify(text).reason;
  EXPECT_TRUE(verify(edited(text, "optimum -1 0 0", "optimum -2/2 0/9 0")).accepted());
  EXPECT_EQ(verify(edited(text, "b 8\n1/3 ", "b 8\n1/4 ")).outcome, Outcome::refused);
}

// The multipliers of a leaf, beside a naive twin: systems of equations over rationals, by
// elimination.

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
