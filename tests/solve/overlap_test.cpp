// SPDX-License-Identifier: GPL-3.0-or-later
// Whether bodies overlap, and whether they are closer than a distance: against their depth, in
// every rounding mode; each proof by its definition.
#include "fathom/overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "kernels/vector.hpp"
#include "tests/support/rounding_modes.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

mpq_class height(const Vector& n, const Point& p) { return n.x * p.x + n.y * p.y + n.z * p.z; }

/// h(n), by its definition.
mpq_class support(const Case& pair, const Vector& n) {
  const auto below = [&](const Point& p, const Point& q) { return height(n, p) < height(n, q); };
  const std::vector<Point>&a = pair.a.points.exact(), &b = pair.b.points.exact();
  return height(n, *std::max_element(b.begin(), b.end(), below)) -
         height(n, *std::min_element(a.begin(), a.end(), below));
}

Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
mpq_class square(const Point& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

Body body_of(std::vector<Point> points) {
  Body body;
  body.points = std::move(points);
  return body;
}

bool holds(const Body& body, const Point& p) {
  return penetration_depth(body, body_of({p})).status() != Status::disjoint;
}

void expect_proof(const Case& pair, Status status) {
  const Overlap proved = overlap(pair.a, pair.b, {.proof = true});
  ASSERT_EQ(proved.status, status) << pair.id;
  const OverlapProof& proof = *proved.proof;
  ASSERT_EQ(proof.normal.has_value(), status != Status::penetrating) << pair.id;
  ASSERT_EQ(proof.common.has_value(), status != Status::disjoint) << pair.id;
  EXPECT_EQ(proof.around.empty(), status != Status::penetrating) << pair.id;
  if (proof.normal) {
    EXPECT_EQ(sgn(support(pair, *proof.normal)), status == Status::touching ? 0 : -1) << pair.id;
  }
  if (proof.common) {
    EXPECT_TRUE(holds(pair.a, *proof.common) && holds(pair.b, *proof.common)) << pair.id;
  }
  if (proof.around.empty()) return;
  std::vector<Point> differences;
  for (const auto& [i, j] : proof.around)
    differences.push_back(minus(pair.b.points.exact()[j], pair.a.points.exact()[i]));
  EXPECT_EQ(penetration_depth(body_of({{0, 0, 0}}), body_of(differences)).status(), Status::penetrating) << pair.id;
}

void expect_close(const Case& pair, const mpq_class& distance, bool closer) {
  EXPECT_EQ(closer_than(pair.a, pair.b, distance).closer, closer) << pair.id << " " << distance;
  const Closeness proved = closer_than(pair.a, pair.b, distance, {.proof = true});
  ASSERT_EQ(proved.closer, closer) << pair.id << " " << distance;
  const ClosenessProof& proof = *proved.proof;
  ASSERT_EQ(proof.points.has_value(), closer);
  ASSERT_EQ(proof.normal.has_value(), !closer);
  if (closer) {
    EXPECT_TRUE(holds(pair.a, proof.points->a) && holds(pair.b, proof.points->b)) << pair.id;
    EXPECT_LT(square(minus(proof.points->b, proof.points->a)), distance * distance) << pair.id;
  } else {
    const mpq_class h = support(pair, *proof.normal);
    EXPECT_LT(h, 0) << pair.id;
    EXPECT_GE(h * h, distance * distance * mpq_class(dot(*proof.normal, *proof.normal))) << pair.id;
  }
}

class EveryFamily : public ::testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] static std::vector<Case> cases() {
    std::vector<Case> all;
    for (const unsigned size : {8U, 20U})
      for (unsigned seed = 1; seed <= 2; ++seed) all.push_back(families::families()[GetParam()].make(seed, size));
    return all;
  }
};

TEST_P(EveryFamily, OverlapIsThatOfTheDepth) {
  Workspace workspace;
  for (const Case& pair : cases()) {
    const Status status = penetration_depth(pair.a, pair.b).status();
    for (const int mode : testing::rounding_modes) {
      const testing::RoundingMode rounding(mode);
      EXPECT_EQ(overlap(pair.a, pair.b, {.workspace = &workspace}).status, status) << pair.id;
    }
    expect_proof(pair, status);
  }
}

TEST_P(EveryFamily, ClosenessIsThatOfTheDistance) {
  for (const Case& pair : cases()) {
    const Depth depth = penetration_depth(pair.a, pair.b);
    if (!depth.distance()) {
      expect_close(pair, mpq_class(1, 1'000'000'000), true);
      continue;
    }
    const Surd distance{0, depth.distance()->squared};
    for (const Rounding mode : {Rounding::rd, Rounding::ru}) {
      const double r = round_binary64(distance, mode);
      if (r > 0 && r < HUGE_VAL) expect_close(pair, mpq_class(r), compare(distance, mpq_class(r)) < 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily, ::testing::Range<std::size_t>(0, families::families().size()),
                         [](const auto& info) { return std::string(families::families()[info.param].name); });

Case cubes(const mpq_class& apart) {
  std::vector<Point> a, b;
  for (int i = 0; i < 8; ++i) {
    a.push_back({i & 1, i >> 1 & 1, i >> 2});
    b.push_back({(i & 1) + 1 + apart, i >> 1 & 1, i >> 2});
  }
  return {"cubes", body_of(a), body_of(b)};
}

TEST(Overlap, OfCubesOnEitherSideOfTouching) {
  const mpq_class little(mpz_class(1), mpz_class(1) << 400);
  for (const int sign : {-1, 0, 1}) {
    const Case pair = cubes(sign * little);
    const Status status = sign < 0 ? Status::penetrating : sign == 0 ? Status::touching : Status::disjoint;
    EXPECT_EQ(overlap(pair.a, pair.b).status, status);
    expect_proof(pair, status);
  }
}

TEST(Closeness, ExcludesTheDistanceItself) {
  const Case pair = cubes(mpq_class(3, 7));
  expect_close(pair, mpq_class(3, 7), false);
  expect_close(pair, mpq_class(3, 7) + mpq_class(1, 1'000'000'000), true);
}

TEST(Overlap, TakesEveryKindOfBody) {
  const auto ball_at = [](int x) {
    Body body;
    body.shape = with_margin(hull(std::vector<Point>{{x, 0, 0}}), 1);
    return body;
  };
  const Body left = ball_at(0), right = ball_at(3), touching = ball_at(2);
  EXPECT_EQ(overlap(left, right).status, Status::disjoint);
  EXPECT_EQ(overlap(left, touching).status, Status::touching);
  EXPECT_EQ(closer_than(left, right, 1).closer, false);
  EXPECT_EQ(closer_than(left, right, mpq_class(11, 10)).closer, true);
  const Case pair = cubes(mpq_class(-1, 2));
  Body pieces;
  pieces.pieces = std::make_shared<const Pieces>(Pieces{pair.a.points.exact()});
  EXPECT_EQ(overlap(pieces, pair.b).status, Status::penetrating);
  EXPECT_EQ(closer_than(pieces, pair.b, 1).closer, true);
  EXPECT_THROW(overlap(left, right, {.proof = true}), std::invalid_argument);
}

TEST(Overlap, RefusesWhatIsNoBody) {
  const Case pair = cubes(0);
  EXPECT_THROW(overlap(pair.a, Body()), std::invalid_argument);
  EXPECT_THROW(overlap(Body(), pair.b, {.proof = true}), std::invalid_argument);
  EXPECT_THROW(closer_than(pair.a, pair.b, 0), std::invalid_argument);
  EXPECT_THROW(closer_than(pair.a, pair.b, -1), std::invalid_argument);
}

}  // namespace
}  // namespace fathom
