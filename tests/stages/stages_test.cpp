// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages say of the exact method, against its naive twins.
#include "view/stages/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "reference/canonical/canonical_subsets.hpp"
#include "tests/stages/staged_cases.hpp"

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

}  // namespace
}  // namespace fathom::stages
