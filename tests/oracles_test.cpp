// SPDX-License-Identifier: GPL-3.0-or-later
// The oracles against answers known by hand, against each other, and against the naive twin: over
// every family of cases.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/oracles/brute_oracle.hpp"
#include "tests/oracles/cdd_oracle.hpp"
#include "tests/oracles/naive_answer.hpp"
#include "tests/oracles/oracle.hpp"
#include "tests/oracles/width_oracle.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace {

using namespace fathom;
using namespace fathom::oracles;
using families::Family;

// --- Known answers

struct Known {
  std::string name;
  Body a, b;
  OracleAnswer answer;
};

mpq_class ratio(long p, long q) { return families::ratio(p, q); }

const OracleAnswer touching{Status::touching, 0, {}}, disjoint{Status::disjoint, 0, {}};

std::vector<Known> solids() {
  const Body cube = families::cube(), octahedron = families::octahedron();
  const auto at = [&](const mpq_class& x, const mpq_class& y, const mpq_class& z) {
    return families::translated(cube, {x, y, z});
  };
  const std::vector<Vector> axes{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  const std::vector<Vector> corners{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
                                    {1, -1, -1},  {1, -1, 1},  {1, 1, -1},  {1, 1, 1}};
  return {
      {"cube in itself", cube, cube, {Status::penetrating, 4, axes}},
      {"octahedron in itself", octahedron, octahedron, {Status::penetrating, ratio(4, 3), corners}},
      {"cubes overlapping by 1/10", cube, at(ratio(19, 10), 0, 0), {Status::penetrating, ratio(1, 100), {{-1, 0, 0}}}},
      {"cubes overlapping by 1/3 along two axes",
       cube,
       at(ratio(5, 3), 0, ratio(-5, 3)),
       {Status::penetrating, ratio(1, 9), {{-1, 0, 0}, {0, 0, 1}}}},
      {"cubes that share a facet's plane", cube, at(2, 1, 1), touching},
      {"cubes that share an edge's line", cube, at(2, 2, 1), touching},
      {"cubes that share a corner", cube, at(2, 2, 2), touching},
      {"cubes apart by a hair", cube, at(2, 2, mpq_class(2 + families::times_power_of_two(1, -300))), disjoint}};
}

std::vector<Known> flats() {
  const Body cube = families::cube(), origin{{{0, 0, 0}}},
             square{{{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 0}}};
  const Body segment{{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}}}, crossing{{{0, 0, -1}, {0, 0, 1}}},
      lifted{{{0, 0, 1}, {0, 0, 2}}};
  return {{"a point and itself", origin, origin, touching},
          {"a point and another", origin, {{{0, 0, 1}}}, disjoint},
          {"a point in a segment", origin, segment, touching},
          {"a point at a segment's end", {{{1, 0, 0}}}, segment, touching},
          {"a point beyond a segment's end", {{{ratio(3, 2), 0, 0}}}, segment, disjoint},
          {"a point beside a segment", {{{0, ratio(1, 2), 0}}}, segment, disjoint},
          {"a point in a square", {{{ratio(1, 2), ratio(-1, 3), 0}}}, square, touching},
          {"a point on a square's edge", {{{1, ratio(-1, 3), 0}}}, square, touching},
          {"a point beside a square, in its plane", {{{2, 0, 0}}}, square, disjoint},
          {"a point above a square", {{{0, 0, ratio(1, 9)}}}, square, disjoint},
          {"a point in a cube", {{{0, 0, ratio(1, 2)}}}, cube, {Status::penetrating, ratio(1, 4), {{0, 0, 1}}}},
          {"a segment through a square",
           crossing,
           square,
           {Status::penetrating, 1, {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}}},
          {"a segment that stands on a square", families::translated(crossing, {0, 0, 1}), square, touching},
          {"a segment above a square", lifted, square, disjoint},
          {"collinear segments that overlap", segment, families::translated(segment, {1, 0, 0}), touching},
          {"collinear segments apart", segment, families::translated(segment, {3, 0, 0}), disjoint},
          {"squares in one plane", square, families::translated(square, {1, 1, 0}), touching},
          {"squares in parallel planes", square, families::translated(square, {0, 0, 1}), disjoint}};
}

TEST(Oracles, AgreeWithAnswersKnownByHand) {
  for (const auto& list : {solids(), flats()})
    for (const Known& known : list) {
      EXPECT_EQ(brute_oracle(known.a.points, known.b.points), known.answer) << "brute: " << known.name;
      EXPECT_EQ(cdd_oracle(known.a.points, known.b.points), known.answer) << "cdd: " << known.name;
      EXPECT_EQ(naive_answer(known.a.points, known.b.points), known.answer) << "naive: " << known.name;
    }
}

TEST(Oracles, WidthsKnownByHand) {
  EXPECT_EQ(width_oracle(families::cube().points).squared, 4);
  EXPECT_EQ(width_oracle(families::cube().points).directions.size(), 6u);
  EXPECT_EQ(width_oracle(families::octahedron().points).squared, ratio(4, 3));
  EXPECT_EQ(width_oracle(families::octahedron().points).directions.size(), 8u);
  EXPECT_EQ(width_oracle(families::tetrahedron().points).squared, 4) << "an edge against the opposite edge";
  EXPECT_EQ(width_oracle(families::box(1, ratio(1, 7), 3).points),
            (OracleAnswer{Status::penetrating, ratio(4, 49), {{0, -1, 0}, {0, 1, 0}}}));
}

TEST(Oracles, NearestHalfSpaces) {
  const std::vector<oracles::HalfSpace> tied{{{2, 0, 0}, 2}, {{0, -1, 0}, 1}, {{0, 0, 1}, 2}, {{3, 0, 0}, 3}};
  EXPECT_EQ(nearest_half_spaces(tied), (OracleAnswer{Status::penetrating, 1, {{0, -1, 0}, {1, 0, 0}}}));
  const std::vector<oracles::HalfSpace> boundary{{{1, 0, 0}, 1}, {{0, 1, 0}, 0}};
  EXPECT_EQ(nearest_half_spaces(boundary), touching);
  const std::vector<oracles::HalfSpace> outside{{{0, 1, 0}, 0}, {{1, 0, 0}, ratio(-1, 9)}};
  EXPECT_EQ(nearest_half_spaces(outside), disjoint);
}

// --- Each other, over all families

class EveryFamily : public ::testing::TestWithParam<Family> {};

TEST_P(EveryFamily, BruteForceEqualsTheNaiveTwin) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Case pair = GetParam().make(seed, 5);
    EXPECT_EQ(brute_oracle(pair.a.points, pair.b.points), naive_answer(pair.a.points, pair.b.points)) << pair.id;
  }
}

TEST_P(EveryFamily, DoubleDescriptionEqualsTheNaiveTwin) {
  for (std::uint64_t seed = 10; seed < 13; ++seed) {
    const Case pair = GetParam().make(seed, 4);
    if (pair.a.points.size() * pair.b.points.size() > 150) continue;  // seconds
    EXPECT_EQ(cdd_oracle(pair.a.points, pair.b.points), naive_answer(pair.a.points, pair.b.points)) << pair.id;
  }
}

TEST_P(EveryFamily, WidthEqualsTheNaiveTwinOfABodyWithItself) {
  for (std::uint64_t seed = 20; seed < 22; ++seed) {
    const Case pair = GetParam().make(seed, 12);
    for (const Body* body : {&pair.a, &pair.b}) {
      const OracleAnswer naive = naive_answer(body->points, body->points);
      if (naive.status != Status::penetrating) continue;  // a flat body
      EXPECT_EQ(width_oracle(body->points), naive) << pair.id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryFamily,
                         ::testing::ValuesIn(families::families().begin(), families::families().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
