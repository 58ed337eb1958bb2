// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of unions: against the naive twin, against convex bodies that were cut, and by the laws
// that any depth obeys.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/unions/naive_union.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::unions {
namespace {

UnionDepth depth_of(const Pieces& a, const Pieces& b) { return union_depth(a, b); }

// What cases were among those compared.
struct Seen {
  std::size_t penetrating = 0, between = 0, tied = 0;
};

void expect_naive(const Pieces& a, const Pieces& b, Seen& seen) {
  const UnionDepth depth = depth_of(a, b);
  const NaiveUnion naive = naive_union(a, b);
  ASSERT_TRUE(depth.complete);
  EXPECT_EQ(depth.squared(), naive.squared);
  if (depth.status != Status::penetrating) return;
  EXPECT_EQ(places(depth), naive.optima) << "law: all ties";
  EXPECT_LE(depth.bounds->deepest_pair, depth.squared());
  EXPECT_LE(depth.squared(), depth.bounds->hulls);
  ++seen.penetrating;
  seen.between += depth.bounds->deepest_pair < depth.squared() && depth.squared() < depth.bounds->hulls;
  seen.tied += depth.optima.size() > 1;
}

TEST(UnionDepth, IsThatOfTheNaiveTwin) {
  Seen seen;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const unsigned size = std::vector<unsigned>{3, 4, 6, 40}[seed % 4];
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pieces a = random_pieces(random, 1 + seed % 2, 4, size, size / 2);
    const Pieces b = random_pieces(random, 1 + seed / 2 % 3, 4, size, size / 2);
    expect_naive(a, b, seen);
  }
  EXPECT_GT(seen.penetrating, 40U);
  EXPECT_GT(seen.between, 5U);
}

TEST(UnionDepth, OfBoxesIsThatOfTheNaiveTwinWithAllTies) {
  Seen seen;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pieces a = random_boxes(random, 1 + seed % 2, 6), b = random_boxes(random, 1 + seed % 4, 6);
    expect_naive(a, b, seen);
  }
  EXPECT_GT(seen.penetrating, 150U);
  EXPECT_GT(seen.between, 20U);
  EXPECT_GT(seen.tied, 20U);
}

// The depth of the whole, with the same places of all optima, however it is cut.
void expect_whole(const Pieces& a, const Pieces& b) {
  const UnionDepth cut = depth_of(a, b);
  const Depth whole = penetration_depth(joined(a), joined(b));
  ASSERT_EQ(cut.status, whole.status());
  EXPECT_EQ(cut.squared(), whole.squared());
  std::set<std::tuple<mpq_class, mpq_class, mpq_class>> expected;
  for (const Optimum& o : whole.optima()) {
    const Point t = o.translation();
    expected.emplace(t.x, t.y, t.z);
  }
  if (cut.status == Status::penetrating) {
    EXPECT_EQ(places(cut), expected);
  }
  for (const UnionOptimum& o : cut.optima) EXPECT_TRUE(o.clearance);
}

TEST(UnionDepth, OfConvexBodiesCutIntoConesIsThatOfTheWhole) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    std::mt19937_64 random(seed);
    const unsigned size = seed % 2 == 0 ? 6 : 1000;
    const std::vector<Point> a = random_piece(random, 8, size), b = random_piece(random, 8, size);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_whole(cones(a), cones(b));
    expect_whole(cones(a), {b, b});
    expect_whole({a}, cones(b));
  }
}

TEST(UnionDepth, OfBoxesCutIntoGridsIsThatOfTheWhole) {
  const Point o{0, 0, 0}, c{1, 1, 1};
  for (const Point& t :
       {o, Point{mpq_class(1, 2), 0, 0}, Point{mpq_class(1, 3), mpq_class(1, 7), mpq_class(1, 5)}, c, Point{3, 0, 0}}) {
    for (const int cells : {1, 2, 3}) {
      expect_whole(moved(grid(o, c, cells), t), grid(o, c, 2));
      expect_whole(moved(grid(o, {1, 2, 3}, cells), t), grid(o, c, 1));
    }
  }
}

// A wall with a slot of the given width along x, and a plate of width 1 that stands in it askew to
// its middle.
Pieces wall(const mpq_class& width) { return {box({-9, -5, -5}, {0, 5, 5}), box({width, -5, -5}, {width + 9, 5, 5})}; }

TEST(UnionDepth, ASlotAsWideAsTheBodyIsAnEscapeWithoutClearance) {
  const Pieces plate = {box({mpq_class(4, 5), -1, -1}, {mpq_class(9, 5), 1, 1})};
  const UnionDepth fit = depth_of(plate, wall(1));
  EXPECT_EQ(fit.squared(), mpq_class(16, 25));
  ASSERT_EQ(fit.optima.size(), 1U);
  EXPECT_FALSE(fit.optima[0].clearance);
  ASSERT_EQ(fit.optima[0].contacts.size(), 2U);
  EXPECT_EQ(fit.optima[0].contacts[0].contact.kind, ContactKind::facet_facet);
  EXPECT_EQ(fit.optima[0].contacts[0].direction, (Vector{1, 0, 0}));
  EXPECT_EQ(fit.optima[0].contacts[1].direction, (Vector{-1, 0, 0}));
  const UnionDepth wide = depth_of(plate, wall(1 + mpq_class(1, 65536)));
  ASSERT_EQ(wide.optima.size(), 1U);
  EXPECT_TRUE(wide.optima[0].clearance);
  EXPECT_EQ(wide.squared(), mpq_class(16, 25) - 2 * mpq_class(4, 5) / 65536 + mpq_class(1, 65536) / 65536);
  const UnionDepth narrow = depth_of(plate, wall(1 - mpq_class(1, 65536)));
  EXPECT_EQ(narrow.squared(), 36) << "only the way out along y or z is left";
  EXPECT_EQ(narrow.optima.size(), 4U);
  const UnionDepth placed = depth_of({box({0, -1, -1}, {1, 1, 1})}, wall(1));
  EXPECT_EQ(placed.status, Status::touching);
  ASSERT_EQ(placed.optima.size(), 1U);
  EXPECT_FALSE(placed.optima[0].clearance);
}

TEST(UnionDepth, LinkedRingsHaveADepthBetweenThatOfPairsAndThatOfHulls) {
  const UnionDepth apart = depth_of(ring(12, false, 0), ring(12, true, 20));
  EXPECT_EQ(apart.status, Status::disjoint) << "linked, and none touches the other";
  EXPECT_GT(apart.apart->distance.squared, 0);
  const UnionDepth depth = depth_of(ring(12, false, 0), ring(12, true, 26));
  ASSERT_EQ(depth.status, Status::penetrating);
  EXPECT_LT(depth.bounds->deepest_pair, depth.squared());
  EXPECT_LT(depth.squared(), depth.bounds->hulls);
  EXPECT_LT(depth.counters.pairs_touched, depth.counters.pairs);
}

// Each pair of pieces, by the method for two convex bodies.
bool overlap(const Pieces& a, const Pieces& b) {
  for (const std::vector<Point>& p : a)
    for (const std::vector<Point>& q : b)
      if (penetration_depth(p, q).status() == Status::penetrating) return true;
  return false;
}

TEST(UnionDepth, OptimaSeparateAndShorterTranslationsDoNot) {
  std::size_t shorter = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    const Pieces a = random_pieces(random, 4, 8, 100, 40), b = random_pieces(random, 5, 8, 100, 40);
    const UnionDepth depth = depth_of(a, b);
    if (depth.status != Status::penetrating) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (const UnionOptimum& o : depth.optima) {
      EXPECT_FALSE(overlap(moved(a, o.translation), b));
      const mpq_class s(4095, 4096);
      EXPECT_TRUE(overlap(moved(a, {s * o.translation.x, s * o.translation.y, s * o.translation.z}), b));
    }
    for (int i = 0; i < 40; ++i) {
      const auto coordinate = [&] { return mpq_class(static_cast<long>(random() % 201) - 100); };
      const Point t{coordinate(), coordinate(), coordinate()};
      if (t.x * t.x + t.y * t.y + t.z * t.z >= depth.squared()) continue;
      EXPECT_TRUE(overlap(moved(a, t), b));
      ++shorter;
    }
  }
  EXPECT_GT(shorter, 10U);
}

TEST(UnionDepth, ObeysTheLawsOfSwapMoveAndScale) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    const Pieces a = random_pieces(random, 3, 7, 50, 20), b = random_pieces(random, 4, 7, 50, 20);
    const UnionDepth depth = depth_of(a, b), swapped = depth_of(b, a);
    const Point t{mpq_class(1, 3), -7, mpq_class(5, 2)};
    const UnionDepth elsewhere = depth_of(moved(a, t), moved(b, t)),
                     larger = depth_of(scaled(a, mpq_class(3, 2)), scaled(b, mpq_class(3, 2)));
    EXPECT_EQ(swapped.squared(), depth.squared());
    EXPECT_EQ(elsewhere.squared(), depth.squared());
    EXPECT_EQ(places(elsewhere), places(depth));
    EXPECT_EQ(larger.squared(), depth.squared() * mpq_class(9, 4));
    std::set<std::tuple<mpq_class, mpq_class, mpq_class>> reversed;
    for (const auto& [x, y, z] : places(swapped)) reversed.emplace(-x, -y, -z);
    EXPECT_EQ(reversed, places(depth));
    EXPECT_EQ(depth_of(Pieces{a[2], a[0], a[1], a[0]}, b).squared(), depth.squared())
        << "law: order and repetition of pieces";
  }
}

TEST(UnionDepth, TouchingAndDisjointUnions) {
  const Pieces a = {box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 1, 1})};
  const UnionDepth touching = depth_of(a, {box({2, 2, 2}, {3, 3, 3}), box({6, 1, 1}, {7, 2, 2})});
  EXPECT_EQ(touching.status, Status::touching);
  ASSERT_EQ(touching.optima.size(), 1U);
  ASSERT_EQ(touching.optima[0].contacts.size(), 1U);
  EXPECT_EQ(touching.optima[0].contacts[0].a, 1U);
  EXPECT_EQ(touching.optima[0].contacts[0].b, 1U);
  EXPECT_EQ(touching.optima[0].contacts[0].contact.kind, ContactKind::vertex_vertex);
  EXPECT_TRUE(touching.optima[0].clearance);
  const UnionDepth apart = depth_of(a, {box({2, 2, 2}, {3, 3, 3}), box({9, 0, 0}, {10, 1, 1})});
  EXPECT_EQ(apart.status, Status::disjoint);
  EXPECT_EQ(apart.apart->distance.squared, 3);
  EXPECT_EQ(apart.apart->a, 0U);
  EXPECT_EQ(apart.apart->b, 0U);
}

std::string complaint(const Pieces& a, const Pieces& b) {
  try {
    union_depth(a, b);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

TEST(UnionDepth, RefusesFlatPiecesByName) {
  const Pieces good = {box({0, 0, 0}, {1, 1, 1})};
  const std::vector<Point> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(complaint({good[0], flat}, good), "piece 1 of A is flat: the pieces of a union need interiors");
  EXPECT_EQ(complaint(good, {flat}), "piece 0 of B is flat: the pieces of a union need interiors");
  EXPECT_EQ(complaint({}, good), "body A has no pieces");
  EXPECT_EQ(complaint(good, {good[0], {}}), "piece 1 of B has no points");
}

class StopAfter final : public Monitor {
 public:
  explicit StopAfter(int calls) : left_(calls) {}
  void report(std::string_view stage, double share) override {
    if (!stage.starts_with("union")) return;
    told_.emplace(stage);
    EXPECT_GE(share, last_);
    EXPECT_LE(share, 1);
    last_ = share;
    --left_;
  }
  bool stopped() override { return left_ <= 0; }
  [[nodiscard]] const std::set<std::string>& told() const { return told_; }

 private:
  int left_;
  double last_ = 0;
  std::set<std::string> told_;
};

TEST(UnionDepth, TellsBetweenWhichBoundsItIsInTheUnitOfTheInput) {
  std::mt19937_64 random(5);
  const Pieces a = random_pieces(random, 6, 10, 100, 30), b = random_pieces(random, 6, 10, 100, 30);
  for (const mpq_class& unit : {mpq_class(1), mpq_class(1, 3), mpq_class(1L << 40)}) {
    StopAfter monitor(10000);
    const double depth = std::sqrt(union_depth(scaled(a, unit), scaled(b, unit), {&monitor, false}).squared().get_d());
    ASSERT_GT(monitor.told().size(), 1U) << "bounds close in";
    for (const std::string& text : monitor.told()) {
      double low = 0, high = 0;
      ASSERT_EQ(std::sscanf(text.c_str(), "union: depth between %lf and %lf", &low, &high), 2) << text;
      EXPECT_LE(low, depth * 1.001) << "rounded to four digits";
      EXPECT_GE(high, depth * 0.999);
    }
  }
}

class StopAtOnce final : public Monitor {
 public:
  explicit StopAtOnce(int calls) : left_(calls) {}
  void report(std::string_view, double) override {}
  bool stopped() override { return --left_ < 0; }

 private:
  int left_;
};

TEST(UnionDepth, StoppedAnywhereItEnclosesTheDepthOnceThatOfTheHullsIsKnown) {
  const Pieces a = {box({0, 0, 0}, {2, 2, 2}), box({10, 0, 0}, {20, 10, 10})};
  const Pieces b = {box({1, 0, 0}, {3, 2, 2}), box({11, 0, 0}, {21, 10, 10})};  // the second pair is the deeper one
  const UnionDepth whole = depth_of(a, b);
  std::size_t thrown = 0, between = 0, complete = 0;
  for (int calls = 0; complete == 0; ++calls) {
    StopAtOnce monitor(calls);
    try {
      const UnionDepth stopped = union_depth(a, b, {&monitor});
      EXPECT_LE(stopped.low, whole.squared());
      EXPECT_LE(whole.squared(), stopped.high);
      EXPECT_LE(stopped.bounds->deepest_pair, whole.bounds->deepest_pair);
      EXPECT_EQ(stopped.bounds->hulls, whole.bounds->hulls);
      between += !stopped.complete && stopped.bounds->deepest_pair < whole.bounds->deepest_pair;
      complete += stopped.complete;
    } catch (const Interrupted&) {
      ++thrown;
      EXPECT_EQ(between, 0U) << "law: later is not worse";
    }
  }
  EXPECT_GT(thrown, 0U);
  EXPECT_GT(between, 0U) << "stopped between pairs";
}

TEST(UnionDepth, StoppedItEnclosesTheDepth) {
  std::mt19937_64 random(5);
  const Pieces a = random_pieces(random, 6, 10, 100, 30), b = random_pieces(random, 6, 10, 100, 30);
  const mpq_class squared = depth_of(a, b).squared();
  std::size_t open = 0;
  mpq_class low = 0;
  for (const int calls : {1, 2, 4, 8, 16, 10000}) {
    StopAfter monitor(calls);
    const UnionDepth stopped = union_depth(a, b, {&monitor, false});
    EXPECT_LE(stopped.low, squared);
    EXPECT_LE(squared, stopped.high);
    EXPECT_LE(low, stopped.low) << "law: bounds close in";
    low = stopped.low;
    open += !stopped.complete;
    if (!stopped.complete) {
      EXPECT_THROW((void)stopped.squared(), std::logic_error);
    }
  }
  EXPECT_GE(open, 3U);
  EXPECT_EQ(low, squared);
}

}  // namespace
}  // namespace fathom::unions
