// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures of unions show: every pair of pieces whose differences reach into the ball, with
// its exact distance; the facets that hold the end of a way; pieces as they are. Twins go through
// all pairs, and through all facets by exact fractions.
#include "view/stages/union_stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "fathom/numbers.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::stages {
namespace {

using unions::box;

struct Staged {
  Pieces a, b;
  UnionDepth depth = union_depth(a, b);
  UnionStages stages = stages_of(a, b, depth);
};

Pieces random_union(std::mt19937_64& random, std::size_t pieces) {
  Pieces result;
  for (std::size_t i = 0; i < pieces; ++i) {
    std::vector<Point> piece = unions::random_piece(random, 8, 8);
    const mpq_class x = static_cast<unsigned long>(random() % 6), y = static_cast<unsigned long>(random() % 6);
    for (Point& p : piece) p.x += x, p.y += y;
    result.push_back(std::move(piece));
  }
  return result;
}

double length(const Place& p) { return std::hypot(p[0], p[1], p[2]); }
double dot(const Place& p, const Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

/// The pairs that reach into the ball or touch, one by one.
std::set<std::pair<Index, Index>> naive_sums(const Staged& it) {
  std::set<std::pair<Index, Index>> result;
  for (Index i = 0; i < it.a.size(); ++i)
    for (Index j = 0; j < it.b.size(); ++j) {
      const Depth pair = penetration_depth(it.a[i], it.b[j], {.method = Method::naive});
      const bool touches = std::ranges::any_of(it.depth.optima, [&](const UnionOptimum& o) {
        return std::ranges::any_of(o.contacts, [&](const PieceContact& c) { return c.a == i && c.b == j; });
      });
      const bool near = pair.distance() == nullptr || pair.distance()->squared < it.depth.low;
      if (touches || near) result.emplace(i, j);
    }
  return result;
}

void check(const Staged& it) {
  ASSERT_EQ(it.stages.a.size(), it.a.size());
  ASSERT_EQ(it.stages.ways.size(), std::max<std::size_t>(1, it.depth.optima.size()));
  for (std::size_t k = 0; k < it.depth.optima.size(); ++k) {
    const Point& t = it.depth.optima[k].translation;
    EXPECT_EQ(it.stages.ways[k].translation, (Place{round_binary64(t.x), round_binary64(t.y), round_binary64(t.z)}));
  }
  std::set<std::pair<Index, Index>> found;
  mpq_class deepest = 0;
  for (const PieceSum& sum : it.stages.sums) {
    EXPECT_TRUE(found.emplace(sum.a, sum.b).second);
    if (sum.inside) deepest = std::max(deepest, sum.squared);
    EXPECT_NEAR(sum.distance, root_binary64(sum.squared), 1e-12);
    if (sum.facets.empty()) continue;
    double nearest = 1e300, farthest = -1e300;  // from O to the facets, outward
    for (std::size_t f = 0; f < sum.facets.size(); ++f) {
      const double height = dot(sum.normals[f], sum.vertices[sum.facets[f].front()]);
      nearest = std::min(nearest, height);
      farthest = std::max(farthest, -height);
      for (const Place& v : sum.vertices)
        EXPECT_LE(dot(sum.normals[f], v), height + 1e-9) << "law: a facet has all vertices behind it";
    }
    if (sum.inside) EXPECT_NEAR(nearest, sum.distance, 1e-9) << "law: O is so deep inside";
    else EXPECT_LE(farthest, sum.distance + 1e-9);
    std::set<Index> ends;
    for (const auto& [facet, way] : sum.through) {
      ends.insert(way);
      EXPECT_NEAR(dot(sum.normals[facet], it.stages.ways[way].translation),
                  dot(sum.normals[facet], sum.vertices[sum.facets[facet].front()]), 1e-9)
          << "law: the way ends in the plane of the facet";
    }
    EXPECT_EQ(ends, std::set<Index>(sum.touches.begin(), sum.touches.end()))
        << "law: where pieces touch, the way ends on the boundary";
  }
  if (it.depth.status == Status::penetrating) {
    EXPECT_EQ(found, naive_sums(it)) << "law: all that reach into the ball";
    EXPECT_EQ(deepest, it.depth.bounds->deepest_pair) << "law: the deepest pair is among them";
    EXPECT_FALSE(it.stages.sums.front().touches.empty()) << "law: those that touch come first";
  } else {
    EXPECT_TRUE(it.stages.sums.empty());
  }
}

TEST(UnionStages, OfRandomUnions) {
  std::mt19937_64 random(3);
  int overlapping = 0;
  for (int round = 0; round < 12; ++round) {
    const Staged it{random_union(random, 1 + random() % 3), random_union(random, 1 + random() % 3)};
    overlapping += it.depth.status == Status::penetrating;
    check(it);
  }
  EXPECT_GT(overlapping, 6);
}

TEST(UnionStages, TiesHaveWaysOfTheirOwn) {
  const Staged it{{box({-1, -1, -1}, {1, 1, 1})}, {box({-9, -9, -2}, {9, 9, 0}), box({-9, -9, 0}, {9, 9, 2})}};
  EXPECT_EQ(it.stages.ways.size(), 2u) << "up and down";
  check(it);
}

TEST(UnionStages, TouchingAndDisjoint) {
  const Staged touching{{box({0, 0, 0}, {1, 1, 1})}, {box({1, 0, 0}, {2, 1, 1}), box({5, 5, 5}, {6, 6, 6})}};
  check(touching);
  EXPECT_EQ(length(touching.stages.ways.front().translation), 0);
  const Staged apart{{box({0, 0, 0}, {1, 1, 1})}, {box({9, 0, 0}, {10, 1, 1}), box({3, 0, 0}, {4, 1, 1})}};
  check(apart);
  EXPECT_EQ(apart.stages.ways.front().translation, (Place{2, 0, 0}));
  EXPECT_EQ(apart.stages.ways.front().touching.front().b, 1u);
}

TEST(UnionStages, FarAndHugeBodiesKeepTheirPixels) {
  const mpq_class unit = exact_value(1e300);
  const auto big = [&](const Point& low, const Point& high) {
    std::vector<Point> result = box(low, high);
    for (Point& p : result) p.x *= unit, p.y *= unit, p.z *= unit;
    return result;
  };
  const Staged it{{big({0, 0, 0}, {1, 1, 1})},
                  {big({mpq_class(1, 2), -1, -1}, {2, 2, 2}), big({2, -1, -1}, {3, 2, 2})}};
  EXPECT_LT(it.stages.scale.exponent, -900);
  for (const StagedPiece& piece : it.stages.b)
    for (const Place& p : piece.vertices) EXPECT_LT(length(p), 1e10);
  EXPECT_GT(length(it.stages.ways.front().translation), 0);
}

TEST(UnionStages, ManyPairsAreLeftOutWithASentence) {
  Pieces many;
  for (int i = 0; i < 50; ++i) many.push_back(box({2 * i, 0, 0}, {2 * i + 1, 9, 9}));
  Pieces bars;
  for (int i = 0; i < 41; ++i) bars.push_back(box({-1, mpq_class(i) / 8, 4}, {200, mpq_class(i + 1) / 8, 5}));
  const UnionDepth depth = union_depth(bars, many, {nullptr, false});
  const UnionStages staged = stages_of(bars, many, depth);
  const auto says = [&](const char* words) {
    return std::ranges::any_of(staged.left_out,
                               [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("There are 2050 pairs of pieces"));
  EXPECT_TRUE(says("are not drawn")) << "law: what is not drawn is said";
  std::size_t drawn = 0;
  for (const PieceSum& sum : staged.sums) {
    EXPECT_FALSE(sum.touches.empty());
    drawn += !sum.facets.empty();
  }
  EXPECT_EQ(drawn, 40u);
}

TEST(UnionStages, AStoppedSearchHasNone) {
  Staged it{{box({0, 0, 0}, {1, 1, 1})}, {box({0, 0, 0}, {1, 1, 1})}};
  it.depth.complete = false;
  EXPECT_THROW(stages_of(it.a, it.b, it.depth), std::invalid_argument);
}

TEST(UnionStages, JsonSaysTheSame) {
  const Staged it{{box({0, 0, 0}, {1, 1, 1})},
                  {box({mpq_class(1, 2), -3, -3}, {1, 4, 4}), box({-3, mpq_class(3, 4), -3}, {1, 1, 4})}};
  check(it);
  const nlohmann::json json = nlohmann::json::parse(to_json(it.stages));
  EXPECT_EQ(json["sums"].size(), it.stages.sums.size());
  EXPECT_EQ(json["sums"][0]["distance_squared"], exact_text(it.stages.sums[0].squared));
  EXPECT_EQ(json["ways"][0]["contacts"].size(), it.depth.optima[0].contacts.size());
  EXPECT_EQ(json["a"][0]["vertices"].size(), 8u);
}

}  // namespace
}  // namespace fathom::stages
