// SPDX-License-Identifier: GPL-3.0-or-later
// The engines against each other and against exact arithmetic on every pair; cuttings against their
// definition.
#include "reference/lines/cutting.hpp"

#include <gtest/gtest.h>

#include "tests/support/grids.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom::lines {
namespace {

using namespace fathom::testing;

// Exact arithmetic on every pair.
kernels::NearestPlanes exhaustive(const Grid& grid) {
  kernels::NearestPlanes nearest;
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) offer_arcs(grid.scene(), grid.row(i), grid.column(j), nearest);
  }
  return nearest;
}

void expect_equal(const kernels::NearestPlanes& left, const kernels::NearestPlanes& right, const std::string& where) {
  ASSERT_EQ(left.empty(), right.empty()) << where;
  if (left.empty()) return;
  EXPECT_EQ(squared_distance(left), squared_distance(right)) << where;
  EXPECT_EQ(left.directions(), right.directions()) << where;
}

// One grid under both engines, with cells so small that there is something to cut; without and with
// a good bound at the start.
void expect_engines_agree(const Grid& grid, std::uint64_t seed, const std::string& where) {
  const kernels::NearestPlanes exact = exhaustive(grid);
  for (const bool informed : {false, true}) {
    kernels::NearestPlanes cutting = informed ? exact : kernels::NearestPlanes(), sampled = cutting;
    kernels::Context context;
    LineSearch first(context, grid.scene(), cutting, seed);
    closest_by_cutting(grid, first, {.r = 2 + seed % 7, .few = 1 + seed % 3, .base = 4 + seed % 13});
    expect_equal(cutting, exact, where + ", cutting");
    LineSearch second(context, grid.scene(), sampled, seed);
    closest_by_sampling(grid, second, {.r = 2 + seed % 7, .base = 64 + seed % 13});
    expect_equal(sampled, exact, where + ", sampled");
  }
}

TEST(Engines, AgreeOnTwoThousandCanonicalPairs) {
  std::size_t pairs = 0, large = 0;
  for (unsigned seed = 1; pairs < 2000; ++seed) {
    ASSERT_LT(seed, 40U);
    for (const families::Family& family : families::families()) {
      std::size_t of_case = 0;
      PreparedGrids(family.make(seed, 16 + 3 * seed)).for_each([&](const Grid& grid) {
        const std::size_t product = grid.rows() * grid.columns();
        if (product < 12 || product > 4000 || of_case >= 12) return;
        expect_engines_agree(grid, pairs, std::string(family.name) + " " + std::to_string(seed));
        ++pairs;
        ++of_case;
        large += product > 200;
      });
    }
  }
  EXPECT_GE(pairs, 2000U);
  EXPECT_GE(large, 100U);
}

// Whole families of canonical pairs with one global best, as the pipeline runs them: every family,
// every catalogue entry.
TEST(Engines, AgreeOnFamiliesAndCatalogue) {
  std::size_t cut = 0;
  std::vector<Case> cases = cases_of_all_families(1, 48);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  for (const Case& input : cases) {
    const PreparedGrids grids(input);
    kernels::NearestPlanes found[3];
    for (const ClosestLines engine : {ClosestLines::cutting, ClosestLines::sampled, ClosestLines::naive}) {
      kernels::Context context;
      // Whatever is not cleared as a whole is cut, and into small cells.
      const ClosestLinesOptions options{
          .engine = engine, .scanned = 8, .cutting_size = {4, 2, 8}, .sampled_size = {4, 8}};
      kernels::NearestPlanes& nearest = found[static_cast<std::size_t>(engine)];
      for (std::size_t h = 0; h < 2; ++h) closest_lines(context, grids.subsets[h], grids.scenes[h], nearest, options);
      cut += context.counters.grids_cut;
    }
    expect_equal(found[0], found[2], input.id + ", cutting");
    expect_equal(found[1], found[2], input.id + ", sampled");
  }
  EXPECT_GT(cut, 100U);
}

TEST(Engines, ResultsDoNotDependOnTheSeed) {
  for (const char* name : {"crossed_fans", "crossed_parabolas", "crossed_ties", "crossed_twists"}) {
    const PreparedGrids grids(families::find_family(name)->make(1, 200));
    for (const ClosestLines engine : {ClosestLines::cutting, ClosestLines::sampled}) {
      std::optional<kernels::NearestPlanes> first;
      for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 12345678901234567ULL}) {
        kernels::NearestPlanes nearest;
        kernels::Context context;
        for (std::size_t h = 0; h < 2; ++h) {
          closest_lines(context, grids.subsets[h], grids.scenes[h], nearest, {.engine = engine, .seed = seed});
        }
        EXPECT_EQ(context.counters.seed, seed);
        EXPECT_GT(context.counters.cells, 0U) << name;
        if (first) expect_equal(nearest, *first, name);
        first = nearest;
      }
    }
  }
}

// A cutting by its definition: lists within the quota unless the cell is small, and whatever is in
// no list strictly farther than the best.
TEST(Cutting, QuotasHoldAndNothingIsLost) {
  std::size_t cells = 0, within = 0, lost = 0;
  for (const char* name :
       {"crossed_fans", "crossed_parabolas", "crossed_ties", "crossed_fillets", "crossed_random_prisms"}) {
    PreparedGrids(families::find_family(name)->make(2, 120)).for_each([&](const Grid& grid) {
      if (grid.rows() < 16 || grid.columns() < 16) return;
      const GridDistances distances(grid);
      for (const GridAxis side : {GridAxis::rows, GridAxis::columns}) {
        kernels::NearestPlanes nearest = plane_at(distances.least() * mpq_class(1001, 1000));
        kernels::Context context;
        LineSearch search(context, grid.scene(), nearest, 1);
        Blocks blocks(grid, std::uint64_t{1} << 40);
        const CuttingSize size{.r = 4, .few = 2, .base = 16};
        const std::vector<Cell> cutting = cut(blocks, side, CellTree::root, {CellTree::root}, size, search);
        const std::uint32_t pivot = distances.rank_above(squared_distance(nearest));
        const std::size_t across = blocks.tree(other(side)).size(CellTree::root),
                          along = blocks.tree(side).size(CellTree::root);
        std::vector<std::vector<char>> kept(along, std::vector<char>(across, 0));
        for (const Cell& cell : cutting) {
          std::uint64_t lines = 0;
          for (const CellNode run : cell.conflicts) {
            lines += blocks.tree(other(side)).size(run);
            for (const std::uint32_t x : blocks.tree(side).lines(cell.cell)) {
              for (const std::uint32_t y : blocks.tree(other(side)).lines(run)) {
                EXPECT_EQ(kept[x][y], 0) << "a block is listed twice";
                kept[x][y] = 1;
              }
            }
          }
          EXPECT_EQ(cell.lines, lines);
          EXPECT_EQ(cell.quota_reached, lines <= across / size.r);
          EXPECT_TRUE(cell.quota_reached || blocks.tree(side).size(cell.cell) <= size.few);
          ++cells;
          within += cell.quota_reached;
        }
        for (std::size_t x = 0; x < along; ++x) {
          for (std::size_t y = 0; y < across; ++y) {
            const bool near = (side == GridAxis::rows ? distances.rank(x, y) : distances.rank(y, x)) < pivot;
            lost += near && !kept[x][y];
          }
        }
      }
    });
  }
  EXPECT_EQ(lost, 0U) << "near pairs outside all conflict lists";
  EXPECT_GE(cells, 40U);
  EXPECT_GE(within, cells / 4);
}

TEST(Cutting, CellsHalve) {
  const PreparedGrids grids(families::find_family("crossed_fans")->make(1, 50));
  bool seen = false;
  grids.for_each([&](const Grid& grid) {
    if (seen || grid.rows() < 20) return;
    seen = true;
    const CellTree tree(grid.rows());
    for (CellNode k = 1; k < 2 * grid.rows(); ++k) {
      const kernels::LineRun whole = tree.run(k), left = tree.run(2 * k), right = tree.run(2 * k + 1);
      EXPECT_EQ(whole.first, left.first);
      EXPECT_EQ(left.last, right.first);
      EXPECT_EQ(right.last, whole.last);
      EXPECT_LE(std::max(left.size(), right.size()) - std::min(left.size(), right.size()), 1U);
    }
  });
  EXPECT_TRUE(seen);
}

// Hears the shares, and stops the work at the given question whether to, counted from 0; never if
// it is negative.
class Watch : public Monitor {
 public:
  explicit Watch(int last) : left_(last) {}
  void report(std::string_view stage, double share) override {
    EXPECT_EQ(stage, "closest lines");
    shares.push_back(share);
  }
  [[nodiscard]] bool stopped() override { return told = left_-- == 0; }

  std::vector<double> shares;
  bool told = false;

 private:
  int left_;
};

TEST(Engines, StopWhenAsked) {
  const PreparedGrids grids(families::find_family("crossed_vanishing_ties")->make(1, 300));
  for (const ClosestLines engine : {ClosestLines::cutting, ClosestLines::sampled, ClosestLines::naive}) {
    for (const int last : {0, 1, 2, -1}) {
      kernels::NearestPlanes nearest;
      Watch watch(last);
      kernels::Context context(&watch);
      const ClosestLinesOptions options{.engine = engine, .first_share = 0.25, .last_share = 0.75};
      bool interrupted = false;
      try {
        closest_lines(context, grids.subsets[0], grids.scenes[0], nearest, options);
      } catch (const Interrupted&) {
        interrupted = true;
      }
      EXPECT_EQ(interrupted, watch.told);
      if (last == 0) {
        EXPECT_TRUE(interrupted && nearest.empty());
      }
      if (last < 0) {
        EXPECT_FALSE(nearest.empty());
      }
      ASSERT_FALSE(watch.shares.empty());
      EXPECT_TRUE(std::ranges::is_sorted(watch.shares));
      EXPECT_EQ(watch.shares.front(), 0.25);
      EXPECT_LE(watch.shares.back(), 0.75);
    }
  }
}

}  // namespace
}  // namespace fathom::lines
