// SPDX-License-Identifier: GPL-3.0-or-later
// The support from both sides.

#include "reference/curved/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/random_shapes.hpp"
#include "verify/check/check.hpp"
#include "verify/families/solids.hpp"

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

// Bounds of random pairs: against the naive check, against other frames, and against prisms inside
// and outside of cylinders.

CurvedBounds bounds_40(const Shape& a, const Shape& b, std::size_t support_calls = 1000) {
  kernels::Context context;
  return signed_bounds(context, a, b, 40, support_calls);
}

TEST(CurvedPairs, OfAllKindsHaveProofs) {
  std::array<int, 3> signs{};
  for (const unsigned bits : {4U, 40U}) {
    ShapeMaker make{families::Random(bits), bits};
    for (const std::string_view kind_a : ShapeMaker::kinds) {
      for (const std::string_view kind_b : ShapeMaker::kinds) {
        const Shape a = make.posed(make.shape(kind_a), 1), b = make.posed(make.shape(kind_b), 3);
        const CurvedBounds bounds = bounds_40(a, b);
        ++signs[bounds.low > 0 ? 0 : bounds.high < 0 ? 1 : 2];
        if (bounds.bracket.polytope.facets.size() > 60)
          continue;  // the naive check takes long; the checkers see them all
        const kernels::Report report = validate(bounds, a, b);
        EXPECT_TRUE(report.ok()) << kind_a << " and " << kind_b << ": " << testing::text(report);
      }
    }
  }
  EXPECT_GT(signs[0], 60);
  EXPECT_GT(signs[1], 60);
  EXPECT_LT(signs[2], 6);
}

TEST(CurvedPairs, HaveOneDepthInAllFrames) {
  ShapeMaker make{families::Random(3), 12};
  for (int i = 0; i < 150; ++i) {
    const Shape a = make.posed(make.any_shape(), 1), b = make.posed(make.any_shape(), 2);
    const Quaternion q = make.rotation();
    const Pose pose = rigid_pose(q, make.point(5));
    const std::array<CurvedBounds, 3> bounds{bounds_40(a, b), bounds_40(b, a),
                                             bounds_40(moved(a, pose), moved(b, pose))};
    for (const CurvedBounds& x : bounds)
      for (const CurvedBounds& y : bounds) EXPECT_LE(x.low, y.high) << i;
  }
}

// Corners of a prism with its edges on a cylinder, and of one with its faces outside. `step` is a
// corner's angle.
struct Prisms {
  std::vector<Point> inside, outside;
};
Prisms prisms(const mpq_class& radius, const mpq_class& half_length, const Pose& pose) {
  constexpr unsigned corners = 24, bits = 30;
  constexpr std::int64_t one = std::int64_t{1} << bits;
  const auto posed = [&](const mpq_class& x, const mpq_class& y, const mpq_class& z) {
    Point p;
    mpq_class* const coordinates[] = {&p.x, &p.y, &p.z};
    for (std::size_t i = 0; i < 3; ++i) *coordinates[i] = pose[i][0] * x + pose[i][1] * y + pose[i][2] * z + pose[i][3];
    return p;
  };
  Prisms result;
  for (unsigned k = 0; k < corners; ++k) {
    const families::CirclePoint p = families::circle_point(k, corners, bits);
    // Two units are more than the rounding; 1/cos(pi/24) is below 1.00864.
    const mpq_class in = radius / mpq_class(one + 2), out = radius / mpq_class(one - 2) * mpq_class(3152, 3125);
    for (const int side : {-1, 1}) {
      result.inside.push_back(posed(in * mpq_class(p.cosine), in * mpq_class(p.sine), side * half_length));
      result.outside.push_back(posed(out * mpq_class(p.cosine), out * mpq_class(p.sine), side * half_length));
    }
  }
  return result;
}

TEST(CurvedPairs, OfCylindersLieBetweenThoseOfPrisms) {
  ShapeMaker make{families::Random(8), 6};
  int penetrating = 0;
  for (int i = 0; i < 40; ++i) {
    const mpq_class r = make.length(), s = make.length(), t = make.length(), u = make.length();
    const Quaternion p = make.rotation(), q = make.rotation();
    const Pose pose_a = rigid_pose(p, make.point(1)), pose_b = rigid_pose(q, make.point(3));
    const Prisms a = prisms(r, s, pose_a), b = prisms(t, u, pose_b);
    const CurvedBounds bounds = bounds_40(moved(cylinder(r, s), pose_a), moved(cylinder(t, u), pose_b));
    const Surd inside{0, signed_square(penetration_depth(a.inside, b.inside))},
        outside{0, signed_square(penetration_depth(a.outside, b.outside))};
    EXPECT_LE(compare(inside, bounds.high), 0) << i;
    EXPECT_GE(compare(outside, bounds.low), 0) << i;
    EXPECT_LT(round_binary64(outside) - round_binary64(inside), 0.02 * (r.get_d() + t.get_d()))
        << i;  // they do confine
    penetrating += bounds.low > 0 ? 1 : 0;
  }
  EXPECT_GT(penetrating, 5);
  EXPECT_LT(penetrating, 35);
}

// Certificates of random pairs of all kinds, a half-space among them, by the public functions and
// the independent checker.

struct Counts {
  int pairs = 0, penetrating = 0, disjoint = 0, long_ones = 0;
};

void check(const Shape& a, const Shape& b, const std::string& what, Counts& counts) {
  SignedDepthOptions options;
  options.support_calls = 600;
  const SignedDepth depth = signed_depth(a, b, options);
  const std::string text = certificate_text(a, b, depth, "pair");
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  const std::string line = fathom_check::verdict_line(verdict, "pair"),
                    status = depth.status() ? std::string(name(*depth.status())) : "undecided";
  EXPECT_EQ(line.substr(0, 11 + status.size()), "s VERIFIED " + status) << what << ": " << line;
  if (const Bounds* bounds = depth.bounds()) {
    const std::string proved = "signed_depth_in=[" + exact_text(bounds->low) + "," + exact_text(bounds->high) + "]";
    EXPECT_NE(line.find(proved), std::string::npos) << what << ": " << line;
  }
  ++counts.pairs;
  counts.penetrating += depth.status() == Status::penetrating ? 1 : 0;
  counts.disjoint += depth.status() == Status::disjoint ? 1 : 0;
  counts.long_ones += text.size() > 30'000 ? 1 : 0;
}

TEST(CurvedCertificates, OfAllKindsAreVerified) {
  Counts counts;
  for (const unsigned bits : {3U, 20U, 50U}) {
    ShapeMaker make{families::Random(bits), bits};
    for (const std::string_view kind_a : ShapeMaker::kinds) {
      for (const std::string_view kind_b : ShapeMaker::kinds) {
        const std::string what = std::string(kind_a) + " and " + std::string(kind_b);
        for (const std::int64_t reach : {1, 2, 4}) {
          const Shape a = make.posed(make.shape(kind_a), 0), b = make.posed(make.shape(kind_b), reach);
          check(a, b, what, counts);
        }
      }
      const Shape half = halfspace(make.point(1), make.length()), body = make.posed(make.shape(kind_a), 2);
      check(half, body, "half-space and " + std::string(kind_a), counts);
      check(body, half, std::string(kind_a) + " and half-space", counts);
    }
  }
  EXPECT_GT(counts.pairs, 1100);
  EXPECT_GT(counts.penetrating, 300);
  EXPECT_GT(counts.disjoint, 300);
  EXPECT_LT(counts.long_ones, counts.pairs / 50);
}

}  // namespace
}  // namespace fathom::curved
