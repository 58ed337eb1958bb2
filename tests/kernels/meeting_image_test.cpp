// SPDX-License-Identifier: GPL-3.0-or-later
// Where planes meet, by images: against exact coordinates, in every rounding mode, for planes that
// are nearly parallel or nearly meet in a line too; and that the images tell enough.
#include <gtest/gtest.h>

#include <cmath>

#include "fathom/numbers.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using testing::random_direction;
using testing::random_integer;
using testing::random_vector;
using testing::rounding_modes;
using testing::RoundingMode;
using Random = std::mt19937_64;

/// A plane through a point of coordinates below 2^bits.
OrientedPlane plane_through(const Vector& normal, const Vector& p, unsigned long bits) {
  return oriented_plane(normal, dot(normal, p), static_cast<long>(bits));
}

/// Three planes and one more, which often passes through the others' common point, or nearly so.
/// The second and the third are often nearly parallel to the first, or nearly through the line of
/// the first two.
std::array<OrientedPlane, 4> four_planes(Random& random, unsigned long bits) {
  std::array<Vector, 4> n;
  for (Vector& normal : n) normal = random_direction(random, bits);
  const auto few = [&] { return 1 + random() % bits; };
  if (random() % 3 == 0) n[1] = n[0] + random_direction(random, few());
  if (random() % 32 == 0) n[1] = -n[0];
  if (random() % 3 == 0) n[2] = n[0] + n[1] + random_direction(random, few());
  for (Vector& normal : n)
    if (is_zero(normal)) normal.x = 1;
  const Vector common = random_vector(random, bits);
  std::array<OrientedPlane, 4> planes;
  const bool meet = random() % 2 == 0;
  for (std::size_t i = 0; i < 4; ++i)
    planes[i] = plane_through(n[i], meet ? common : random_vector(random, bits), bits);
  if (meet && random() % 2 == 0) planes[3] = plane_through(n[3], common + random_vector(random, few()), bits);
  return planes;
}

/// |v / w 2^-bits - c| <= error.
bool within(const mpz_class& v, const mpz_class& w, unsigned long bits, double c, double error) {
  if (!std::isfinite(error)) return true;
  const mpq_class scale(testing::power_of_two(bits));
  return abs(mpq_class(mpq_class(v) / (w * scale) - exact_value(c))) <= exact_value(error);
}

bool within(const RationalPoint& p, unsigned long bits, const PointImage& image) {
  return within(p.v.x, p.w, bits, image.at.x, image.error) && within(p.v.y, p.w, bits, image.at.y, image.error) &&
         within(p.v.z, p.w, bits, image.at.z, image.error);
}

struct Told {
  std::size_t sides = 0, orders = 0, unsure = 0, zero = 0;
};

// The image and what is concluded from it, against the exact point.
void expect_true(const RationalPoint& p, const PointImage& image, unsigned long bits, const OrientedPlane& plane,
                 const SquaredDistance& squared, Told& told) {
  ASSERT_TRUE(within(p, bits, image)) << "law: the error bound";
  const int exact = sgn(mpz_class(dot(plane.normal, p.v) - plane.height * p.w));
  if (exact == 0) ++told.zero;
  if (const auto side = sure_side(plane.image, image)) {
    ASSERT_EQ(to_int(*side), exact) << "law: sides";
    ++told.sides;
  } else if (exact != 0) {
    ++told.unsure;
  }
  const mpz_class mine = dot(p.v, p.v) * squared.denominator, other = squared.numerator * p.w * p.w;
  if (const auto order = sure_order(image, squared.image)) {
    ASSERT_EQ(to_int(*order), cmp(mine, other) < 0 ? -1 : cmp(mine, other)) << "law: order of distances";
    ++told.orders;
  }
}

TEST(MeetingImage, ErrsByNoMoreThanItSaysInEveryRoundingMode) {
  Random random(5);
  Told told;
  std::size_t parallel = 0;
  for (int i = 0; i < 12000; ++i) {
    SCOPED_TRACE(i);
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = i % 3 == 0 ? 3 : i % 3 == 1 ? 60 : 700;
    const auto exponent = static_cast<long>(bits);
    const auto [g, h, e, f] = four_planes(random, bits);
    const SquaredDistance at = squared_distance(rational_point(f.height * f.normal, dot(f.normal, f.normal), exponent));
    expect_true(rational_point(g.height * g.normal, dot(g.normal, g.normal), exponent), foot_image(g.image), bits, f,
                at, told);
    const MeetingLine line(g.image, h.image);
    const Vector d = cross(g.normal, h.normal);
    if (is_zero(d)) {
      ++parallel;
      ASSERT_FALSE(line.surely_exists());
      continue;
    }
    const RationalPoint foot =
        rational_point(g.height * cross(h.normal, d) + h.height * cross(d, g.normal), dot(d, d), exponent);
    expect_true(foot, line.foot(), bits, f, at, told);
    expect_true(foot, line.foot(), bits, f, squared_distance(foot), told);
    const mpz_class w = dot(d, e.normal);
    const auto leads = line.leads_beyond(e.image);
    if (leads) {
      ASSERT_EQ(to_int(*leads), sgn(w)) << "law: the way of a line";
    }
    if (w == 0) continue;
    const RationalPoint meeting = rational_point(
        g.height * cross(h.normal, e.normal) + h.height * cross(e.normal, g.normal) + e.height * d, w, exponent);
    expect_true(meeting, line.meeting(e.image), bits, f, at, told);
    expect_true(meeting, line.meeting(e.image), bits, f, squared_distance(meeting), told);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(told.sides, 20000U);
  EXPECT_GT(told.orders, 10000U);
  EXPECT_GT(told.zero, 2000U);
  EXPECT_GT(told.unsure, 500U) << "too easy";
  EXPECT_GT(parallel, 20U);
}

/// Work, in counts: of planes in general position the images tell nearly all.
TEST(MeetingImage, LeavesLittleToIntegers) {
  Random random(6);
  std::size_t unsure = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<OrientedPlane, 4> p;
    for (OrientedPlane& plane : p) plane = plane_through(random_direction(random, 60), random_vector(random, 60), 60);
    const MeetingLine line(p[0].image, p[1].image);
    unsure += line.surely_exists() ? 0U : 1U;
    unsure += line.leads_beyond(p[2].image) ? 0U : 1U;
    for (const PointImage& image : {foot_image(p[0].image), line.foot(), line.meeting(p[2].image)})
      unsure += sure_side(p[3].image, image) ? 0U : 1U;
  }
  EXPECT_LT(unsure, 3U) << "of 15000";
}

}  // namespace
}  // namespace fathom::kernels
