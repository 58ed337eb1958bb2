// SPDX-License-Identifier: GPL-3.0-or-later

#include "reference/lines/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fathom/depth.hpp"
#include "kernels/filters/line_frame.hpp"
#include "reference/lines/cutting.hpp"
#include "tests/support/grids.hpp"
#include "tests/support/line_scenes.hpp"
#include "verify/families/families.hpp"

namespace fathom::lines {
namespace {

using testing::cases_of_all_families;
using testing::PreparedGrids;
using testing::text;

// With O inside P: order, hemisphere and membership at every crossing of every canonical pair,
// under several perturbations.
TEST(Grid, IsValidOnAllFamilies) {
  std::size_t grids = 0, falling = 0;
  const std::vector<kernels::Perturbation> perturbations = testing::perturbations();
  unsigned k = 0;
  for (const Case& input : cases_of_all_families(2, 14)) {
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids prepared(input, perturbations[k++ % perturbations.size()]);
    for (std::size_t h = 0; h < 2; ++h) {
      const canonical::CanonicalSubsets& subsets = prepared.subsets[h];
      for (std::size_t i = 0; i < subsets.size(); ++i) {
        const kernels::Report report = validate(Grid(subsets[i], prepared.scenes[h]));
        ASSERT_TRUE(report.ok()) << input.id << "\n" << text(report);
        ++grids;
        falling += !subsets[i].rising;
      }
    }
  }
  EXPECT_GT(grids, 1000U);
  EXPECT_GT(falling, grids / 10);
  EXPECT_LT(falling, grids - grids / 10);
}

// Each law, broken: a chain out of order, and the wrong sense.
TEST(Grid, ValidationNoticesDisorder) {
  std::size_t shuffled = 0, turned = 0;
  const PreparedGrids fans(families::find_family("crossed_fans")->make(1, 30));
  for (std::size_t h = 0; h < 2; ++h) {
    const canonical::CanonicalSubsets& subsets = fans.subsets[h];
    const auto valid = [&](const canonical::CanonicalPair& pair) { return validate(Grid(pair, fans.scenes[h])).ok(); };
    for (std::size_t i = 0; i < subsets.size(); ++i) {
      const canonical::CanonicalPair pair = subsets[i];
      if (pair.a.size() < 2 || pair.b.size() < 2) continue;
      std::vector<chart::ChartArcOfA> a(pair.a.begin(), pair.a.end());
      std::vector<chart::ChartArcOfB> b(pair.b.begin(), pair.b.end());
      std::swap(a.front(), a.back());
      EXPECT_FALSE(valid({pair.stored_of, pair.rising, pair.strip, a, pair.b}));
      std::swap(b.front(), b[1]);
      EXPECT_FALSE(valid({pair.stored_of, pair.rising, pair.strip, pair.a, b}));
      ++shuffled;
      EXPECT_FALSE(valid({pair.stored_of, !pair.rising, pair.strip, pair.a, pair.b}));
      ++turned;
    }
  }
  EXPECT_GT(shuffled, 0U);
  EXPECT_GT(turned, 0U);
}

// The laws that make the vertex test right: at each crossing the outward normal has its plane above
// O, and P nowhere beyond it.
TEST(Grid, EveryCrossingSupportsP) {
  std::size_t crossings = 0;
  for (const Case& input : cases_of_all_families(1, 10)) {
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids grids(input);
    grids.for_each([&](const Grid& grid) {
      for (std::size_t i = 0; i < grid.rows(); ++i) {
        for (std::size_t j = 0; j < grid.columns(); ++j) {
          const Vector w = cross(grid.row_direction(i), grid.column_direction(j));
          const mpz_class height = dot(grid.column_point(j) - grid.row_point(i), w);
          for (const Vector& q : grids.prepared->b.vertices) ASSERT_LE(dot(w, q - grid.column_point(j)), 0) << input.id;
          for (const Vector& p : grids.prepared->a.vertices) ASSERT_GE(dot(w, p - grid.row_point(i)), 0) << input.id;
          ASSERT_TRUE(is_zero(w) || height > 0) << input.id;
          ++crossings;
        }
      }
    });
  }
  EXPECT_GT(crossings, 1000U);
}

// The block tests against exact distances: what is cleared holds nothing as near as the bound.

using namespace fathom::testing;
using Lines = std::vector<std::uint32_t>;

// Some ascending positions of 0, ..., n - 1: a run, or every now and then any subset.
Lines some_lines(Random& random, std::size_t n) {
  std::size_t first = random() % n, last = random() % n;
  if (first > last) std::swap(first, last);
  Lines lines;
  const bool holes = random() % 8 == 0;
  for (std::size_t i = first; i <= last; ++i) {
    if (!holes || random() % 2 == 0) lines.push_back(static_cast<std::uint32_t>(i));
  }
  if (lines.empty()) lines.push_back(static_cast<std::uint32_t>(first));
  return lines;
}

// Blocks shrink as fast as the search's do, or most would be too large to be cleared.
Lines small_lines(Random& random, std::size_t n) {
  const std::size_t size = 1 + random() % std::min<std::size_t>(n, 6), first = random() % (n - size + 1);
  Lines lines(size);
  std::iota(lines.begin(), lines.end(), static_cast<std::uint32_t>(first));
  return lines;
}

struct Audit {
  std::uint64_t blocks = 0, vertex = 0, frame = 0, wide = 0, offset = 0;
};

// A threshold above the least distance, by 10^-k for k = 1, ..., 12, or by 2^-k for k = 40, 45,
// ..., 90.
mpq_class threshold_above(const mpq_class& least, int k) {
  mpz_class part;
  if (k < 40) {
    mpz_ui_pow_ui(part.get_mpz_t(), 10, static_cast<unsigned long>(k));
  } else {
    part = mpz_class(1) << static_cast<mp_bitcnt_t>(k);
  }
  return least * mpq_class(part + 1, part);
}

// The tests in wide floats, on one block. `left_nearer` counts the pairs that the offset test
// leaves and that are nearer than the threshold.
struct WideVerdict {
  bool clear = false, offset = false;
  std::uint64_t left_nearer = 0;
};

WideVerdict wide_verdict(const kernels::WideLines& a, const Lines& rows, const kernels::WideLines& b,
                         const Lines& columns, const kernels::WideFloat& bound, const GridDistances& distances,
                         std::uint32_t pivot) {
  const auto row_frame = kernels::line_frame(a, rows), column_frame = kernels::line_frame(b, columns);
  const auto margin = kernels::frames_margin(row_frame, column_frame, bound);
  const auto smooth = kernels::margin_model(row_frame.smooth(), column_frame.smooth(), bound);
  WideVerdict verdict{margin && *margin > 0};
  if (!smooth) return verdict;
  const auto left = kernels::pairs_left({a, rows, row_frame}, {b, columns, column_frame}, bound, *smooth,
                                        rows.size() * columns.size());
  if (!left) return verdict;
  verdict.offset = left->size() < rows.size() * columns.size();
  for (const auto& [i, j] : *left) verdict.left_nearer += distances.rank(i, j) < pivot;
  return verdict;
}

// Random blocks of one grid, thresholds from 1e-1 to 2^-90 above its least distance, each block
// under all tests.
void audit(const Grid& grid, int blocks, Random& random, Audit& sums, const std::string& where) {
  const GridDistances distances(grid);
  if (distances.empty()) return;
  const Clearing clearing(grid);
  const kernels::WideLines wide_rows = grid.wide_rows(), wide_columns = grid.wide_columns();
  constexpr int thresholds[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 90};
  for (const int k : thresholds) {
    const kernels::NearestPlanes nearest =
        plane_at(k % 3 == 0 ? distances.least() : threshold_above(distances.least(), k));
    const kernels::WideFloat wide_bound =
        kernels::wide_bound(nearest.numerator(), nearest.denominator(), grid.scene().a.images().exponent());
    const kernels::LineBound bound =
        kernels::line_bound(nearest.numerator(), nearest.denominator(), grid.scene().a.images().exponent());
    const std::uint32_t pivot = distances.rank_above(squared_distance(nearest));
    for (int n = 0; n < blocks / static_cast<int>(std::size(thresholds)); ++n) {
      const RoundingMode mode(rounding_modes[n % 4]);
      const Lines rows = n % 3 ? small_lines(random, grid.rows()) : some_lines(random, grid.rows());
      const Lines columns = n % 3 ? small_lines(random, grid.columns()) : some_lines(random, grid.columns());
      std::uint32_t least = UINT32_MAX;
      std::uint64_t nearer = 0;
      for (const std::uint32_t i : rows) {
        for (const std::uint32_t j : columns) {
          least = std::min(least, distances.rank(i, j));
          nearer += distances.rank(i, j) < pivot;
        }
      }
      const bool vertex = clearing.vertex_clears({side_of(rows), side_of(columns)}, nearest, bound);
      const bool frame = kernels::frames_beyond(kernels::line_frame(clearing.rows(), rows),
                                                kernels::line_frame(clearing.columns(), columns), bound.above);
      // Wide floats take their time.
      WideVerdict wide;
      if (n % 7 == 0) wide = wide_verdict(wide_rows, rows, wide_columns, columns, wide_bound, distances, pivot);
      ++sums.blocks;
      sums.vertex += vertex;
      sums.frame += frame;
      ASSERT_TRUE(!vertex || least >= pivot) << where << ": the vertex test cleared a nearer pair";
      sums.wide += wide.clear;
      sums.offset += wide.offset;
      ASSERT_TRUE(!frame || least >= pivot) << where << ": the frame test cleared a nearer pair";
      ASSERT_TRUE(!wide.clear || least >= pivot) << where << ": the frame test in wide floats cleared a nearer pair";
      ASSERT_TRUE(!wide.offset || wide.left_nearer == nearer) << where << ": the offset test threw out a nearer pair";
    }
  }
}

TEST(Clearing, NeverClearsANearerPair) {
  Random random(5);
  Audit sums;
  constexpr const char* names[] = {"crossed_fans",           "crossed_parabolas", "crossed_random_parabolas",
                                   "crossed_twists",         "crossed_prisms",    "crossed_random_prisms",
                                   "crossed_bands",          "crossed_ties",      "crossed_shrinking_ties",
                                   "crossed_vanishing_ties", "crossed_fillets",   "crossed_patch",
                                   "crossed_noisy_ties"};
  for (const char* name : names) {
    const families::Family* family = families::find_family(name);
    ASSERT_NE(family, nullptr) << name;
    int audited = 0;
    for (unsigned seed = 1; audited < 2 && seed <= 6; ++seed) {
      const Case made = family->make(seed, 40);
      int of_this = 0;
      PreparedGrids(seed % 2 == 0 ? turned(made) : made).for_each([&](const Grid& grid) {
        if (of_this >= 2 || grid.rows() * grid.columns() < 64) return;
        ++of_this;
        ++audited;
        audit(grid, 14000, random, sums, name);
      });
    }
  }
  EXPECT_GE(sums.blocks, 250000U);
  EXPECT_GE(sums.vertex, sums.blocks / 20);
  EXPECT_GE(sums.frame, sums.blocks / 20);
  EXPECT_GE(sums.wide, sums.frame / 7);
  EXPECT_GE(sums.offset, sums.blocks / 140);
  for (const auto& [what, count] : {std::pair("all", sums.blocks),
                                    {"vertex", sums.vertex},
                                    {"frame", sums.frame},
                                    {"wide", sums.wide},
                                    {"offset", sums.offset}}) {
    RecordProperty(what, std::to_string(count));
  }
}

// On small integers many distances tie, lines are parallel, and corners vanish.
TEST(Clearing, NeverClearsATie) {
  Random random(6);
  Audit sums;
  for (const char* name : {"lattice", "random_lattice", "boxes", "crossed_parabolas", "platonic"}) {
    const families::Family* family = families::find_family(name);
    if (family == nullptr) continue;
    for (unsigned seed = 1; seed <= 30; ++seed) {
      PreparedGrids(family->make(seed, 20)).for_each([&](const Grid& grid) {
        if (grid.rows() * grid.columns() > 1) audit(grid, 120, random, sums, name);
      });
    }
  }
  EXPECT_GE(sums.blocks, 10000U);
  EXPECT_GE(sums.vertex, 100U);
}

// The whole pair, without images of its chains, as with them.
TEST(Clearing, WholePairIsTheBlockOfAll) {
  std::size_t clear = 0, kept = 0;
  for (const Case& input : cases_of_all_families(1, 24)) {
    PreparedGrids(input).for_each([&](const Grid& grid) {
      const GridDistances distances(grid);
      if (distances.empty()) return;
      const Clearing clearing(grid);
      for (const int k : {1, 2, 4}) {
        const kernels::NearestPlanes nearest = plane_at(distances.least() / k);
        const kernels::LineBound bound =
            kernels::line_bound(nearest.numerator(), nearest.denominator(), grid.scene().a.images().exponent());
        const bool whole = vertex_clears(grid, nearest, bound);
        const kernels::Block all{side_of(all_indices(grid.rows())), side_of(all_indices(grid.columns()))};
        EXPECT_EQ(whole, clearing.vertex_clears(all, nearest, bound)) << input.id;
        ++(whole ? clear : kept);
      }
    });
  }
  EXPECT_GE(clear, 100U);
  EXPECT_GE(kept, 100U);
}

// The engines against each other and against exact arithmetic on every pair; cuttings against their
// definition.

using namespace fathom::testing;

// Exact arithmetic on every pair.
kernels::NearestPlanes exhaustive(const Grid& grid) {
  kernels::NearestPlanes nearest;
  for (std::size_t i = 0; i < grid.rows(); ++i) {
    for (std::size_t j = 0; j < grid.columns(); ++j) offer_arcs(grid.scene(), grid.row(i), grid.column(j), nearest);
  }
  return nearest;
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

TEST(Engines, AgreeOnAThousandCanonicalPairs) {
  std::size_t pairs = 0, large = 0;
  for (unsigned seed = 1; pairs < 1000; ++seed) {
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
  EXPECT_GE(pairs, 1000U);
  EXPECT_GE(large, 50U);
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
