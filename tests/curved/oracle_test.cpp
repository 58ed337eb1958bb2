// SPDX-License-Identifier: GPL-3.0-or-later
// The support from both sides.
#include "reference/curved/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/vector.hpp"
#include "tests/support/random_shapes.hpp"

namespace fathom::curved {
namespace {

using testing::ShapeMaker;

const std::vector<Term>& terms(const Shape& shape) { return std::get<std::vector<Term>>(shape.core); }

// The support of a term, rounded down and up to a multiple of `unit`: by the definition.
struct Around {
  mpq_class low, high;
};
Around support(const Term& term, const Vector& n, const mpq_class& unit) {
  std::optional<Around> greatest;
  for (const Atom& atom : term.atoms) {
    mpq_class square;
    for (const Point& axis : atom.axes) square += dot(n, axis) * dot(n, axis);
    const mpq_class scaled = square / (unit * unit);
    const mpz_class whole = scaled.get_num() / scaled.get_den(), root = sqrt(whole);
    const mpq_class low = dot(n, atom.center) + root * unit, high = root * root == scaled ? low : mpq_class(low + unit);
    greatest = greatest ? Around{std::max(greatest->low, low), std::max(greatest->high, high)} : Around{low, high};
  }
  return *greatest;
}

// Whether no point of the term is higher: as checkers decide it.
bool is_above(const Term& term, const Vector& n, const mpq_class& height) {
  return std::all_of(term.atoms.begin(), term.atoms.end(), [&](const Atom& atom) {
    mpq_class square;
    for (const Point& axis : atom.axes) square += dot(n, axis) * dot(n, axis);
    const mpq_class beyond = height - dot(n, atom.center);
    return beyond >= 0 && beyond * beyond >= square;
  });
}

TEST(Oracle, HeightsAreThoseOfTheDefinitionAndPointsAreInside) {
  ShapeMaker make{families::Random(2), 8};
  for (int i = 0; i < 300; ++i) {
    const Shape a = make.posed(make.any_shape(), 1), b = make.posed(make.any_shape(), 1);
    const Lattice both = lattice(terms(a), terms(b), 40);
    kernels::Context context;
    Oracle oracle(context, both, 100);
    const Vector n{make.random.between(-1000, 1000), make.random.between(-1000, 1000),
                   make.random.between(-1000, 1000)};
    if (is_zero(n)) continue;
    const mpq_class size = abs(n.x) + abs(n.y) + abs(n.z);
    const polytope::Difference d = oracle.ask(n, 40);
    const std::vector<TermHeight> heights = oracle.heights(n);
    ASSERT_EQ(heights.size(), terms(a).size() + terms(b).size());
    const mpq_class unit = size / (mpz_class(1) << 50);
    mpq_class sum, low;
    for (std::size_t t = 0; t < heights.size(); ++t) {
      const bool of_a = t < terms(a).size();
      const Around naive = of_a ? support(terms(a)[t], -n, unit) : support(terms(b)[t - terms(a).size()], n, unit);
      EXPECT_TRUE(is_above(of_a ? terms(a)[t] : terms(b)[t - terms(a).size()], of_a ? -n : n, heights[t].height)) << i;
      EXPECT_LE(heights[t].height, naive.high + size * both.unit / (mpz_class(1) << 40));
      if (heights[t].exact) {
        EXPECT_LE(heights[t].height, naive.high);
      }
      sum += heights[t].height;
      low += naive.low;
    }
    EXPECT_EQ(sum, mpq_class(oracle.height()) * both.fine_unit);
    // The point is the difference of the inner points, whose parameters lie in the unit ball, and
    // it falls short of the height by little.
    Point place;
    for (const bool of_a : {true, false}) {
      const InnerPoint inner = oracle.inner_point(d.first, of_a);
      const std::vector<Term>& core = terms(of_a ? a : b);
      ASSERT_EQ(inner.size(), core.size());
      for (std::size_t t = 0; t < core.size(); ++t) {
        const Atom& atom = core[t].atoms[inner[t].atom];
        mpq_class length;
        Point p = atom.center;
        for (std::size_t k = 0; k < atom.axes.size(); ++k) {
          const mpq_class& y = inner[t].local[k];
          length += y * y;
          p = {p.x + y * atom.axes[k].x, p.y + y * atom.axes[k].y, p.z + y * atom.axes[k].z};
        }
        EXPECT_LE(length, 1);
        place = of_a ? place - p : place + p;
      }
    }
    const Vector& integral = oracle[d];
    EXPECT_EQ(place, (Point{integral.x * both.fine_unit, integral.y * both.fine_unit, integral.z * both.fine_unit}));
    EXPECT_LE(dot(n, place), sum);
    EXPECT_GE(dot(n, place), low - size * 20 / (mpz_class(1) << 38));
  }
}

TEST(Oracle, RationalSupportIsExact) {
  const Shape can = cylinder(5, 2);
  const Lattice one = lattice({}, terms(can), 30);
  kernels::Context context;
  Oracle oracle(context, one, 10);
  for (const Vector& n : {Vector{0, 0, 1}, Vector{3, 4, 0}, Vector{-4, 3, 7}, Vector{1, 0, -1}}) {
    ASSERT_EQ(oracle.heights(n).size(), 1U);
    EXPECT_TRUE(oracle.heights(n)[0].exact);
    const mpz_class root = sqrt(mpz_class(n.x * n.x + n.y * n.y));
    EXPECT_EQ(oracle.heights(n)[0].height, 5 * root + 2 * abs(n.z));
  }
  EXPECT_FALSE(oracle.heights({1, 1, 0})[0].exact);
}

TEST(Oracle, ManyPointsAreScannedAsFewAre) {
  ShapeMaker make{families::Random(4), 8};
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back(make.point(3));
  Shape many = hull(points);
  std::get<std::vector<Term>>(many.core)[0].atoms.insert(std::get<std::vector<Term>>(many.core)[0].atoms.begin() + 20,
                                                         Atom{{1, 1, 1}, {{1, 0, 0}, {0, 1, 0}}});
  const Lattice cloud = lattice(terms(many), {}, 30);
  ASSERT_EQ(cloud.terms[0].cloud.size(), 60U);
  kernels::Context context;
  Oracle oracle(context, cloud, 1000);
  for (int i = 0; i < 200; ++i) {
    const Vector n{make.random.between(-9, 9), make.random.between(-9, 9), make.random.between(1, 9)};
    const TermHeight height = oracle.heights(n)[0];
    const Around naive = support(terms(many)[0], -n, mpq_class(1, mpz_class(1) << 40));
    EXPECT_GE(height.height, naive.low);
    EXPECT_LE(height.height, naive.high + mpq_class(1, 1 << 20));
    const InnerPoint inner = oracle.inner_point(oracle.ask(n, 30).first, true);
    const Atom& atom = terms(many)[0].atoms[inner[0].atom];
    if (atom.axes.empty()) {
      EXPECT_EQ(dot(-n, atom.center), height.height);
    }
  }
}

}  // namespace
}  // namespace fathom::curved
