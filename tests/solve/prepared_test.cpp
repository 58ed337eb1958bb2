// SPDX-License-Identifier: GPL-3.0-or-later
// Prepared bodies in any pose: against bodies that are not prepared, in every rounding mode, on
// random walks, wherever a search begins; certificates to the byte.
#include "fathom/prepared.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "reference/solve/depth.hpp"
#include "tests/support/rounding_modes.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom {
namespace {

using families::Random;

/// The body with its points in binary64, if they all are such numbers.
std::optional<Body> in_binary64(const Body& body) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : body.points.exact()) {
    const auto x = kernels::in_binary64(p.x), y = kernels::in_binary64(p.y), z = kernels::in_binary64(p.z);
    if (!x || !y || !z) return std::nullopt;
    points.push_back({*x, *y, *z});
  }
  return Body{GivenPoints(points)};
}

/// In [-1, 1].
double coordinate(Random& random) { return std::ldexp(static_cast<double>(random.between(-(1 << 19), 1 << 19)), -19); }

/// A walk of poses: turns and shifts that grow slowly, by matrices of doubles that are hardly ever
/// rotations.
class Walk {
 public:
  explicit Walk(std::uint64_t seed, double size) : random_(seed), size_(size) {}

  Quaternion turn() const { return {exact_value(q_[0]), exact_value(q_[1]), exact_value(q_[2]), exact_value(q_[3])}; }
  Point shift() const { return {exact_value(t_[0]), exact_value(t_[1]), exact_value(t_[2])}; }
  PoseBinary64 next() {
    for (double& x : q_) x += coordinate(random_) / 64;
    for (double& x : t_) x += size_ * coordinate(random_) / 64;
    const Pose exact = rigid_pose(turn(), shift());
    PoseBinary64 pose;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) pose[i][j] = exact[i][j].get_d();
    return pose;
  }

 private:
  Random random_;
  double size_;
  std::array<double, 4> q_{1, 0, 0, 0};
  std::array<double, 3> t_{};
};

/// Of what a pose is told.
struct Seen {
  std::array<std::size_t, 3> statuses{};
};

std::string certificate_of(const Body& a, const Body& b, const Depth& depth) {
  return certificate_text(a, b, depth, "walk");
}

/// Every way to ask gives the one answer.
void expect_same(const PlacedBody& a, const PlacedBody& b, WarmStart& warm, const std::string& id, Seen& seen) {
  const Body moved_a = moved(a), moved_b = moved(b);
  Workspace workspace;
  const Depth cold = penetration_depth(moved_a, moved_b);
  ++seen.statuses[static_cast<std::size_t>(cold.status())];
  const auto expect_cold = [&](const Depth& found) {
    EXPECT_EQ(solve::disagreement(found, cold), std::nullopt) << id;
    EXPECT_FALSE(found.method || (found.penetration() && found.penetration()->inner)) << id;
    EXPECT_EQ(found.counters.expansions + found.counters.scans + found.extreme_a + found.extreme_b, 0) << id;
  };
  const std::string text = certificate_of(moved_a, moved_b, cold);
  for (const int mode : testing::rounding_modes) {
    const testing::RoundingMode rounding(mode);
    const Depth found = penetration_depth(a, b, &warm, {.workspace = &workspace});
    expect_cold(found);
    if (mode == FE_UPWARD) {
      EXPECT_EQ(certificate_of(moved_a, moved_b, found), text) << id;
    }
  }
  expect_cold(penetration_depth(a, b));
  WarmStart wrong{{{0, 0}, {0, 0}}};
  const auto last_a = static_cast<std::uint32_t>(moved_a.points.size() - 1),
             last_b = static_cast<std::uint32_t>(moved_b.points.size() - 1);
  for (std::uint32_t k = 0; k < 5; ++k) wrong.differences.emplace_back(last_a - std::min(last_a, k), last_b);
  expect_cold(penetration_depth(a, b, &wrong, {.optima = cold.optima().size() + 1, .workspace = &workspace}));
  const OverlapOptions options{.workspace = &workspace};
  EXPECT_EQ(overlap(a, b, options).status, cold.status()) << id;
  EXPECT_EQ(closer_than(a, b, mpq_class(1, 16), options).closer, closer_than(moved_a, moved_b, mpq_class(1, 16)).closer)
      << id;
}

class PreparedFamily : public ::testing::TestWithParam<std::size_t> {};

TEST_P(PreparedFamily, EveryPoseIsAnsweredAsIfNothingWerePrepared) {
  const families::Family& family = families::families()[GetParam()];
  Seen seen;
  for (const unsigned size : {8U, 20U}) {
    const Case given = family.make(size, size);
    const std::optional<Body> a = in_binary64(given.a), b = in_binary64(given.b);
    const PlacedBody still{Prepared(b ? *b : given.b)};
    PlacedBody moving{Prepared(a ? *a : given.a)};
    Walk walk(size, std::abs(given.b.points.exact()[0].x.get_d()));
    WarmStart warm;
    expect_same(moving, still, warm, given.id, seen);
    for (int step = 0; step < 4; ++step) {
      moving.pose = walk.next();
      expect_same(moving, still, warm, given.id + " in binary64", seen);
    }
    moving.pose = rigid_pose(walk.turn(), walk.shift());
    expect_same(moving, still, warm, given.id + " turned exactly", seen);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PreparedFamily, ::testing::Range(std::size_t{0}, families::families().size()),
                         [](const auto& info) { return std::string(families::families()[info.param].name); });

Body box(double x, double y, double z) {
  std::vector<std::array<double, 3>> points;
  for (int k = 0; k < 8; ++k) points.push_back({(k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y, (k & 4) != 0 ? z : -z});
  points.push_back({0, 0, 0});  // and one that is not extreme
  return Body{GivenPoints(points)};
}

TEST(Prepared, BoxesOnAWalkHaveFewAxes) {
  const PlacedBody still{Prepared(box(1, 0.5, 0.25))};
  PlacedBody moving{Prepared(box(0.5, 0.375, 0.3))};
  Seen seen;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Walk walk(seed, 16);
    WarmStart warm;
    for (int step = 0; step < 24; ++step) {
      moving.pose = walk.next();
      expect_same(moving, still, warm, "boxes", seen);
    }
    EXPECT_TRUE(warm.differences.empty());  // no polytope had to expand
  }
  EXPECT_GT(seen.statuses[0], 20U);
  EXPECT_GT(seen.statuses[2], 10U);
}

// Powers of two between the numbers of a matrix, up to where neither words nor 128 bits suffice.
TEST(Prepared, NumbersOfAnySizeInAPose) {
  const PlacedBody still{Prepared(box(1, 1, 1))};
  PlacedBody moving{Prepared(box(1, 0.5, 0.25))};
  Seen seen;
  for (const int power :
       {0, -1, -8, -30, -31, -32, -52, -60, -61, -62, -63, -64, -100, -124, -125, -126, -300, -1074}) {
    WarmStart warm;
    const double small = std::ldexp(1.0, power);
    for (const PoseBinary64& pose : {PoseBinary64{{{1, small, 0, 0.5}, {0, 1, 0, 0}, {0, 0, 1, small}}},
                                     PoseBinary64{{{small, 0, 0, small}, {0, small, 0, 0}, {0, 0, small, 1}}},
                                     PoseBinary64{{{1, 0, 0, 1 + small}, {0, 1, 0, -small}, {small, 0, 1, 0}}}}) {
      moving.pose = pose;
      expect_same(moving, still, warm, "2^" + std::to_string(power), seen);
    }
  }
}

TEST(Prepared, FlatPosesAndMirrors) {
  const PlacedBody still{Prepared(box(1, 1, 1))};
  PlacedBody moving{Prepared(box(1, 0.5, 0.25))};
  WarmStart warm;
  Seen seen;
  for (const PoseBinary64& pose : {PoseBinary64{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}},
                                   PoseBinary64{{{0, 0, 0, 0.5}, {0, 0, 0, 0.5}, {0, 0, 0, 0.25}}},
                                   PoseBinary64{{{0, 0, 0, 3}, {0, 0, 0, 0}, {0, 0, 0, 0}}},
                                   PoseBinary64{{{1, 0, 0, 1}, {0, 1, 0, 0.25}, {0, 0, -1, 0}}},
                                   PoseBinary64{{{1, 2, 3, 1}, {2, 4, 6, 0.25}, {1, 1, -1, 0}}}}) {
    moving.pose = pose;
    expect_same(moving, still, warm, "flat or mirrored", seen);
    expect_same(still, moving, warm, "flat or mirrored, the other way round", seen);
  }
}

// Projected along its edges a box has corners at which points lie that were no corners.
TEST(Prepared, FlatPosesNameTheLowestOfEqualPoints) {
  Body body = box(1, 0.5, 0.25);
  std::vector<std::array<double, 3>> points{{1, 0.5, 0}, {-1, -0.5, 0.125}};
  points.insert(points.end(), body.points.binary64().begin(), body.points.binary64().end());
  const PlacedBody still{Prepared(box(1, 1, 1))};
  PlacedBody moving{Prepared(Body{GivenPoints(points)})};
  PlacedBody polygon{Prepared(Body{GivenPoints({{{0, 0, 0}}, {{1, 0.5, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{-1, 0, 0}}})})};
  WarmStart warm;
  Seen seen;
  for (const PoseBinary64& pose : {PoseBinary64{{{1, 0, 0, 1}, {0, 1, 0, 0.75}, {0, 0, 0, 0.25}}},
                                   PoseBinary64{{{0.25, 0, 0, 1}, {0, 0, 0, 0.75}, {0, 0, 0, 0}}}}) {
    moving.pose = polygon.pose = pose;
    expect_same(moving, still, warm, "projected", seen);
    expect_same(still, moving, warm, "projected, the other way round", seen);
    expect_same(polygon, still, warm, "a polygon", seen);
  }
  EXPECT_GT(seen.statuses[0], 0U);
}

TEST(Prepared, KnowsItsExtremePoints) {
  EXPECT_EQ(Prepared(box(1, 1, 1)).extreme_points(), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  Body twice = box(1, 1, 1);
  twice.points.push_back(Point{twice.points[3]});
  EXPECT_EQ(Prepared(twice).extreme_points().size(), 8U);
}

TEST(Prepared, RefusesWhatIsNone) {
  EXPECT_THROW(Prepared(Body{}), std::invalid_argument);
  EXPECT_THROW(Prepared(Body{.points = {}, .shape = sphere(1)}), std::invalid_argument);
  const PlacedBody cube{Prepared(box(1, 1, 1))};
  PlacedBody lost = cube;
  lost.pose = PoseBinary64{{{1, 0, 0, HUGE_VAL}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  EXPECT_THROW(penetration_depth(lost, cube), std::invalid_argument);
  EXPECT_THROW(moved(lost), std::invalid_argument);
  lost.pose = Pose{};
  std::get<Pose>(lost.pose)[0][0] = mpq_class(mpz_class(2), mpz_class(-4));
  EXPECT_THROW(penetration_depth(lost, cube), std::invalid_argument);
  WarmStart start{{{0, 9}}};
  EXPECT_THROW(penetration_depth(cube, cube, &start), std::invalid_argument);
  start.differences.assign(most_start_differences + 1, {0, 0});
  EXPECT_THROW(penetration_depth(cube, cube, &start), std::invalid_argument);
  EXPECT_THROW(penetration_depth(cube, cube, nullptr, {.optima = 0}), std::invalid_argument);
  EXPECT_THROW(closer_than(cube, cube, mpq_class(0)), std::invalid_argument);
}

}  // namespace
}  // namespace fathom
