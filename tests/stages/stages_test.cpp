// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages say of the exact method, against its naive twins.

#include "view/stages/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/stages/staged_cases.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/families/families.hpp"

namespace fathom::stages {
namespace {

using testing::line_distance;
using testing::prepare;
using testing::Prepared;
using testing::staged_cases;

using EdgePair = std::pair<Index, Index>;

// And cases with large canonical pairs.
std::vector<Case> with_crossed(std::vector<Case> cases, unsigned size) {
  for (const char* name : {"crossed_fans", "crossed_parabolas", "crossed_ties", "crossed_twists", "crossed_patch"})
    cases.push_back(families::find_family(name)->make(1, size));
  return cases;
}

// C2 and C3 of the staged pairs, chart by chart.
TEST(Pairs, AreTheCrossings) {
  for (const Case& input : staged_cases({14})) {
    const auto p = prepare(input);
    const Stages stages = stages_of(input.a, input.b);
    for (Index h = 0; h < 2; ++h) {
      std::vector<EdgePair> found, expected;
      for (const StagedPair& pair : stages.pairs) {
        if (pair.chart != h) continue;
        for (const Index e : pair.a) {
          for (const Index f : pair.b) found.emplace_back(e, f);
        }
      }
      for (const auto& [e, f] : canonical::crossings_naive(p->charts[h])) expected.emplace_back(e.value, f.value);
      std::ranges::sort(found);
      EXPECT_EQ(found, expected) << input.id << ", chart " << h;
    }
  }
}

TEST(Pairs, HaveTheirClosestLines) {
  std::size_t large = 0;
  for (const Case& input : with_crossed(staged_cases({14}), 100)) {
    const Stages stages = stages_of(input.a, input.b);
    const auto p = prepare(input);
    for (const StagedPair& pair : stages.pairs) {
      if (stages.status != Status::penetrating) {
        EXPECT_FALSE(pair.closest || pair.evaluated > 0 || pair.fate != PairFate::none) << input.id;
        continue;
      }
      std::optional<mpq_class> least;
      for (const Index e : pair.a) {
        for (const Index f : pair.b) {
          const std::optional<mpq_class> squared = line_distance(*p, e, f);
          if (squared && (!least || *squared < *least)) least = squared;
        }
      }
      ASSERT_EQ(pair.closest.has_value(), least.has_value()) << input.id;
      if (!least) continue;
      EXPECT_EQ(pair.closest->squared, *least) << input.id;
      EXPECT_EQ(line_distance(*p, pair.closest->a, pair.closest->b), least) << input.id;
      EXPECT_TRUE(std::ranges::count(pair.a, pair.closest->a) == 1 && std::ranges::count(pair.b, pair.closest->b) == 1)
          << input.id;
      large += pair.crossings() > 2048;
    }
  }
  EXPECT_GT(large, 2U);
}

// The run that the stages describe is that of the exact method: the same answer, and the same work.
TEST(Counts, AreThoseOfTheExactMethod) {
  for (const Case& input : with_crossed(staged_cases({14}), 100)) {
    const Stages stages = stages_of(input.a, input.b);
    const Depth exact = penetration_depth(input.a, input.b, {.method = Method::exact});
    EXPECT_EQ(stages.status, exact.status()) << input.id;
    EXPECT_EQ(stages.squared.value_or(0), exact.squared()) << input.id;
    ASSERT_EQ(stages.contact.optima.size(), exact.optima().size()) << input.id;
    for (std::size_t i = 0; i < exact.optima().size(); ++i)
      EXPECT_EQ(stages.contact.optima[i].contact, exact.optima()[i].contact) << input.id;
    EXPECT_EQ(stages.counters.crossings, exact.counters.crossings) << input.id;
    EXPECT_EQ(stages.counters.canonical_pairs, exact.counters.canonical_pairs) << input.id;
    EXPECT_EQ(stages.counters.sum_a, exact.counters.sum_a) << input.id;
    EXPECT_EQ(stages.counters.sum_b, exact.counters.sum_b) << input.id;
    EXPECT_EQ(stages.counters.pairs_evaluated, exact.counters.pairs_evaluated) << input.id;
    EXPECT_EQ(stages.counters.block_tests, exact.counters.block_tests) << input.id;
    if (stages.status != Status::penetrating) continue;
    std::uint64_t a = 0, b = 0, crossings = 0, evaluated = 0, cut = 0;
    for (const StagedPair& pair : stages.pairs) {
      a += pair.a.size();
      b += pair.b.size();
      crossings += pair.crossings();
      evaluated += pair.evaluated;
      cut += pair.fate == PairFate::cut;
    }
    EXPECT_EQ(a, exact.counters.sum_a) << input.id;
    EXPECT_EQ(b, exact.counters.sum_b) << input.id;
    EXPECT_EQ(crossings, exact.counters.crossings) << input.id;
    EXPECT_EQ(evaluated, exact.counters.pairs_evaluated) << input.id << ": of all pairs together";
    EXPECT_EQ(cut, exact.counters.grids_cut) << input.id;
  }
}

// The features of the first optimum face each other in its direction, and edges are in the pair
// that is said to hold them.
TEST(Winner, IsTheFirstOptimum) {
  std::map<WinnerKind, int> kinds;
  int in_pairs = 0;
  for (const Case& input : staged_cases({12})) {
    const Stages stages = stages_of(input.a, input.b);
    ASSERT_EQ(stages.winner.has_value(), stages.status == Status::penetrating) << input.id;
    if (!stages.winner) continue;
    const StagedWinner& winner = *stages.winner;
    ++kinds[winner.kind];
    const Place& n = stages.contact.direction;
    if (winner.kind == WinnerKind::facet_of_a) {
      ASSERT_EQ(winner.a.kind, StagedFeatureKind::facet) << input.id;
      EXPECT_NEAR(testing::dot(stages.a.nodes[winner.a.index], n), 1, 1e-12) << input.id;
    }
    if (winner.kind == WinnerKind::facet_of_b) {
      ASSERT_EQ(winner.b.kind, StagedFeatureKind::facet) << input.id;
      EXPECT_NEAR(testing::dot(stages.b.nodes[winner.b.index], n), 1, 1e-12) << input.id;
    }
    if (winner.kind != WinnerKind::edges) continue;
    ASSERT_TRUE(winner.a.kind == StagedFeatureKind::edge && winner.b.kind == StagedFeatureKind::edge) << input.id;
    EXPECT_EQ(line_distance(*prepare(input), winner.a.index, winner.b.index), stages.squared) << input.id;
    if (!winner.pair) continue;
    const StagedPair& pair = stages.pairs[*winner.pair];
    EXPECT_TRUE(std::ranges::count(pair.a, winner.a.index) == 1 && std::ranges::count(pair.b, winner.b.index) == 1)
        << input.id;
    EXPECT_EQ(pair.closest->squared, *stages.squared) << input.id;
    ++in_pairs;
  }
  for (const WinnerKind kind : {WinnerKind::edges, WinnerKind::facet_of_a, WinnerKind::facet_of_b})
    EXPECT_GT(kinds[kind], 10);
  EXPECT_GT(in_pairs, 10);
}

struct Covering {
  std::size_t rows, columns;
  std::vector<int> cells = std::vector<int>(rows * columns);

  void add(const StagedBlock& block) {
    for (Index i = block.rows[0]; i < block.rows[1]; ++i) {
      for (Index j = block.columns[0]; j < block.columns[1]; ++j) ++cells.at(i * columns + j);
    }
  }
  [[nodiscard]] bool once() const {
    return std::ranges::all_of(cells, [](int n) { return n == 1; });
  }
};

// The blocks of a level partition the refined ones before it; so the others partition the grid, and
// one of them has won.
void check_cutting(const Stages& stages, const std::string& id) {
  const StagedCutting& cutting = *stages.cutting;
  const StagedPair& pair = stages.pairs[cutting.pair];
  Covering leaves{pair.a.size(), pair.b.size()};
  std::vector<int> before(leaves.cells.size(), 1);
  int won = 0;
  for (std::size_t k = 0; k < cutting.levels.size(); ++k) {
    EXPECT_EQ(cutting.levels[k].cut_a.has_value(), k > 0) << id;
    Covering all{pair.a.size(), pair.b.size()}, refined{pair.a.size(), pair.b.size()};
    for (const StagedBlock& block : cutting.levels[k].blocks) {
      all.add(block);
      (block.fate == BlockFate::refined ? refined : leaves).add(block);
      won += block.fate == BlockFate::won;
      if (block.fate != BlockFate::won) continue;
      const auto holds = [](const Indices& edges, const std::array<Index, 2>& run, Index edge) {
        return std::find(edges.begin() + run[0], edges.begin() + run[1], edge) != edges.begin() + run[1];
      };
      EXPECT_TRUE(holds(pair.a, block.rows, pair.closest->a) && holds(pair.b, block.columns, pair.closest->b)) << id;
    }
    EXPECT_EQ(all.cells, before) << id << ": level " << k << " is no partition of what was refined before";
    before = refined.cells;
  }
  EXPECT_TRUE(leaves.once()) << id;
  EXPECT_EQ(won, 1) << id;
}

TEST(Cutting, PartitionsTheGrid) {
  int searched = 0, for_picture = 0, of_winner = 0;
  for (const Case& input : with_crossed(staged_cases({14}), 100)) {
    const Stages stages = stages_of(input.a, input.b);
    if (!stages.cutting) continue;
    check_cutting(stages, input.id);
    (stages.cutting->as_searched ? searched : for_picture) += 1;
    of_winner += stages.cutting->winner;
    EXPECT_EQ(stages.cutting->winner, stages.winner->pair == stages.cutting->pair) << input.id;
  }
  EXPECT_GT(searched, 2);
  EXPECT_GT(for_picture, 10);
  EXPECT_GT(of_winner, 4);
}

// The stages of shapes: sampled outlines and the contact.

using testing::dot;

Body at(const Shape& shape, const mpq_class& x) {
  const Pose pose{{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  return files::body_of(moved(shape, pose));
}

TEST(Shapes, OutlinesLieOnTheBodies) {
  const Stages stages = stages_of(at(sphere(2), 0), at(cylinder(1, 3), 2));
  EXPECT_TRUE(stages.a.sampled && stages.b.sampled);
  for (const Place& p : stages.a.vertices) EXPECT_NEAR(std::sqrt(dot(p, p)), 2, 1e-5);
  double top = 0;
  for (const Place& p : stages.b.vertices) {
    EXPECT_NEAR(std::hypot(p[0] - 2, p[1]), 1, 1e-5);
    EXPECT_NEAR(std::abs(p[2]), 3, 1e-5);
    top = std::max(top, p[2]);
  }
  EXPECT_GT(stages.a.vertices.size(), 300U);
  EXPECT_GT(stages.b.vertices.size(), 50U);
  EXPECT_TRUE(stages.charts.empty() && stages.pairs.empty() && !stages.cutting && !stages.winner);
  EXPECT_EQ(stages.depth, 1.0);
  EXPECT_EQ(stages.squared, 1);
  EXPECT_EQ(stages.contact.direction, (Place{-1, 0, 0}));
}

TEST(Shapes, FacetsLookOutward) {
  const Stages stages = stages_of(at(cone(1, 1), 0), at(ellipsoid({1, 2, 3}), 1));
  for (const StagedBody* body : {&stages.a, &stages.b}) {
    Place middle{};
    for (const Place& p : body->vertices) {
      for (std::size_t i = 0; i < 3; ++i) middle[i] += p[i] / static_cast<double>(body->vertices.size());
    }
    for (const Indices& facet : body->facets) {
      const auto from = [&](std::size_t i) -> Place {
        const Place &p = body->vertices[facet[i]], &q = body->vertices[facet[0]];
        return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      };
      const Place u = from(1), v = from(2);
      const Place normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      const Place& p = body->vertices[facet[0]];
      EXPECT_GT(dot(normal, {p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]}), 0);
    }
  }
}

TEST(Shapes, DepthIsThatOfSignedDepth) {
  for (const families::Family& family : families::families(families::Kind::shapes)) {
    const Case input = family.make(1, family.usual_size);
    const Shape a = files::shape_of(input.a), b = files::shape_of(input.b);
    const Stages stages = stages_of(input.a, input.b);
    const SignedDepth depth = signed_depth(a, b);
    EXPECT_EQ(stages.status, depth.status()) << input.id;
    if (depth.status() == Status::penetrating) {
      if (depth.exact()) {
        EXPECT_EQ(stages.depth, round_binary64(*depth.exact())) << input.id;
      } else {
        EXPECT_EQ(stages.depth.has_value(), round_binary64(depth.bounds()->low) == round_binary64(depth.bounds()->high))
            << input.id;
      }
      const double length = std::sqrt(dot(stages.contact.translation, stages.contact.translation));
      const double expected =
          depth.exact() ? *stages.depth : mpq_class((depth.bounds()->low + depth.bounds()->high) / 2).get_d();
      EXPECT_NEAR(length / std::exp2(stages.scale.exponent) / expected, 1, 1e-9) << input.id;
    } else {
      EXPECT_FALSE(stages.depth || stages.squared) << input.id;
    }
    EXPECT_FALSE(stages.left_out.empty()) << input.id;
  }
}

TEST(Shapes, HalfSpacesHaveNoOutline) {
  const Stages stages = stages_of(at(sphere(1), 0), files::body_of(halfspace({0, 0, 1}, 0)));
  EXPECT_TRUE(stages.b.sampled && stages.b.vertices.empty());
  EXPECT_TRUE(
      std::ranges::any_of(stages.left_out, [](const std::string& s) { return s.starts_with("B is a half-space"); }));
  EXPECT_EQ(stages.depth, 1.0);
  EXPECT_EQ(stages.contact.direction, (Place{0, 0, 1}));
}

// What pictures of unions show: every pair of pieces whose differences reach into the ball, with
// its exact distance; the facets that hold the end of a way; pieces as they are. Twins go through
// all pairs, and through all facets by exact fractions.

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
