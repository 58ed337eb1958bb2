// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances of the planes that pairs of edges span, for tests that measure how near near ties
// are.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::testing {

/// The plane <normal, x> = height along an edge of B and against one of A, oriented away from O:
/// normal is not primitive.
struct SpannedPlane {
  Vector normal;
  mpz_class height;

  /// Squared distance from O, in the unit of the coordinates.
  [[nodiscard]] mpq_class squared() const {
    mpq_class result(height * height, dot(normal, normal));
    result.canonicalize();
    return result;
  }
};

/// The plane along (q, q2) of B and (p, p2) of A.
inline SpannedPlane spanned_plane(const Vector& p, const Vector& p2, const Vector& q, const Vector& q2) {
  SpannedPlane plane{cross(p2 - p, q2 - q), 0};
  plane.height = dot(plane.normal, q - p);
  if (plane.height < 0) plane = {-plane.normal, mpz_class(-plane.height)};
  return plane;
}

/// A crossing of an edge of A and an edge of B, with the ends of both as indices of the input
/// points, ascending.
struct MeasuredCrossing {
  std::array<std::uint32_t, 2> of_a, of_b;
  SpannedPlane plane;
};

inline std::vector<MeasuredCrossing> measured_crossings(const Prepared& p) {
  const auto ends = [](const polytope::Polytope& body, const chart::ChartArc& arc) {
    const polytope::Edge& edge = body.edges[arc.arc.value];
    const auto [low, high] = std::minmax(body.input_ids[edge.from], body.input_ids[edge.to]);
    return std::array<std::uint32_t, 2>{low, high};
  };
  std::vector<MeasuredCrossing> result;
  kernels::Context context;
  for (const chart::Charts& charts : p.charts) {
    const canonical::CanonicalSubsets subsets = canonical::canonical_subsets(context, charts);
    for (std::size_t k = 0; k < subsets.size(); ++k)
      for (const chart::ChartArcOfA i : subsets[k].a)
        for (const chart::ChartArcOfB j : subsets[k].b) {
          const auto a = ends(p.a, charts.of.a.arcs[chart::ChartArcId(i.value)]),
                     b = ends(p.b, charts.of.b.arcs[chart::ChartArcId(j.value)]);
          result.push_back(
              {a, b, spanned_plane(p.placed.a[a[0]], p.placed.a[a[1]], p.placed.b[b[0]], p.placed.b[b[1]])});
        }
  }
  return result;
}

/// The least and the greatest squared distance so far.
struct Spread {
  mpq_class least, greatest;
  std::size_t count = 0;

  void add(const mpq_class& squared) {
    least = count ? std::min(least, squared) : squared;
    greatest = count ? std::max(greatest, squared) : squared;
    ++count;
  }
  /// Whether the distances agree up to the factor 1 + share.
  [[nodiscard]] bool within(const mpq_class& share) const { return greatest <= least * (1 + share) * (1 + share); }
};

}  // namespace fathom::testing

// Depths at rounding boundaries, deep and hair-thin pairs, long and thin bodies: that each has what
// its name says.

namespace fathom::families {
namespace {

Depth solved(const Case& input) { return penetration_depth(input.a.points, input.b.points); }

template <class F>
void for_each_coordinate(const Case& input, F f) {
  for (const Body* body : {&input.a, &input.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) f(*x);
}

bool in_binary64(const Case& input) {
  bool all = true;
  for_each_coordinate(input, [&](const mpq_class& x) {
    const double nearest = round_binary64(x, Rounding::rn);
    all = all && std::isfinite(nearest) && mpq_class(nearest) == x;
  });
  return all;
}

// --- Rounding boundaries

/// What a format rounds a depth to. Numbers beyond the greatest are taken as one ulp more.
template <class T>
struct Neighbours {
  mpq_class below, above, middle;
  explicit Neighbours(const mpq_class& squared) {
    const double down = root(squared, Rounding::rd), up = root(squared, Rounding::ru);
    constexpr double greatest = std::numeric_limits<T>::max();
    below = std::isinf(down) ? mpq_class(greatest) : mpq_class(down);
    above = std::isinf(up) ? mpq_class(greatest) + times_power_of_two(1, std::numeric_limits<T>::max_exponent -
                                                                             std::numeric_limits<T>::digits)
                           : mpq_class(up);
    middle = (below + above) / 2;
  }
  static double root(const mpq_class& squared, Rounding mode) {
    if constexpr (std::is_same_v<T, double>) return root_binary64(squared, mode);
    else return root_binary32(squared, mode);
  }
};

struct Closeness {
  bool on_it = false;
  long k = 0;  ///< within 2^-k of the distance between neighbours
};

/// How near the root of `squared` is to `boundary`, as a share of `ulp`: no root is taken.
Closeness closeness(const mpq_class& squared, const mpq_class& boundary, const mpq_class& ulp) {
  if (boundary * boundary == squared) return {true, 0};
  const auto within = [&](long k) {
    const mpq_class reach = times_power_of_two(ulp, -k), low = boundary - reach, high = boundary + reach;
    return (low <= 0 || low * low <= squared) && squared <= high * high;
  };
  long k = 0;
  while (k < 300 && within(k + 1)) ++k;
  return {false, k};
}

template <class T>
void expect_hard_to_round(const char* family) {
  std::set<long> seen;
  std::map<std::string, int> kinds;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Case input = find_family(family)->make(seed, seed % 3 ? 6 : 14);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::penetrating) << input.id;
    EXPECT_EQ(depth.optima().size(), 1U) << input.id;
    const Neighbours<T> around(depth.squared());
    const mpq_class ulp =
        around.below == around.above ? mpq_class(around.below) : mpq_class(around.above - around.below);
    Closeness best;
    for (const mpq_class* boundary : {&around.below, &around.above, &around.middle}) {
      const Closeness here = closeness(depth.squared(), *boundary, ulp);
      best = {best.on_it || here.on_it, std::max(best.k, here.k)};
    }
    EXPECT_TRUE(best.on_it || best.k >= 1) << input.id;
    EXPECT_LE(best.k, 202) << input.id;
    if (best.on_it) ++kinds["on it"];
    else seen.insert(best.k);
    if (around.below < std::numeric_limits<T>::min()) ++kinds["subnormal"];
    if (around.above > std::numeric_limits<T>::max()) ++kinds["overflow"];
    if (in_binary64(input)) ++kinds["in binary64"];
  }
  EXPECT_GT(seen.size(), 60U);
  EXPECT_GE(*seen.rbegin(), 190);
  for (const char* kind : {"on it", "in binary64"}) EXPECT_GE(kinds[kind], 40) << kind;
  for (const char* kind : {"subnormal", "overflow"}) EXPECT_GE(kinds[kind], 1) << kind;
}

TEST(RoundingBoundary, Binary32) { expect_hard_to_round<float>("rounding_binary32"); }
TEST(RoundingBoundary, Binary64) { expect_hard_to_round<double>("rounding_binary64"); }

// --- Extremes

TEST(Hair, OverlapsByAPowerOfTwoWithOneOptimumOfAnyKind) {
  std::set<ContactKind> kinds;
  long thinnest = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Case input = find_family("hair_overlap")->make(seed, 8);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.optima().size(), 1U) << input.id;
    kinds.insert(depth.contact()->kind);
    const mpq_class share = depth.squared() / dot(depth.direction(), depth.direction());
    const long log = kernels::binary_order(share) / 2;
    EXPECT_LE(log, -38) << input.id;
    thinnest = std::min(thinnest, log);
    EXPECT_GT(*second_nearest_squared(input.a.points, input.b.points, *depth.penetration()),
              times_power_of_two(depth.squared(), 40))
        << input.id;
  }
  EXPECT_EQ(kinds.size(), 6U);
  EXPECT_LT(thinnest, -180);
}

TEST(Hair, GapsAreBetweenTheFeatures) {
  std::set<std::pair<std::size_t, std::size_t>> features;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Case input = find_family("hair_gap")->make(seed, 8);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::disjoint) << input.id;
    const Vector& n = depth.distance()->direction;
    EXPECT_LE(kernels::binary_order(depth.distance()->squared / dot(n, n)) / 2, -58) << input.id;
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    const std::size_t a = kernels::extreme_points_naive(placed.a.points(), -n).size(),
                      b = kernels::extreme_points_naive(placed.b.points(), n).size();
    features.emplace(std::min<std::size_t>(a, 3), std::min<std::size_t>(b, 3));
  }
  EXPECT_EQ(features.size(), 9U);
}

TEST(Deep, IsNearlyTheSumOfTheRadii) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Case input = find_family("deep")->make(seed, 60);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::penetrating);
    EXPECT_GT(depth.squared(), ratio(1, 4)) << input.id;
    EXPECT_LT(*second_nearest_squared(input.a.points, input.b.points, *depth.penetration()),
              depth.squared() * ratio(3, 2))
        << input.id;
  }
}

TEST(Stretched, ReachesARatioOfABillion) {
  double greatest = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case input = find_family("stretched")->make(seed, 12);
    const Depth thickness = fathom::testing::exact_depth(input.a.points, input.a.points);
    const double ratio = 1 / std::sqrt(thickness.squared().get_d());
    EXPECT_GT(ratio, 1e3) << input.id;
    greatest = std::max(greatest, ratio);
  }
  EXPECT_GT(greatest, 4e8);
}

TEST(ApproachingDegraded, IsLeftBehind) {
  std::size_t rank = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case input = find_family("approaching_degraded")->make(seed, 8);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    rank += polytope::affine_rank(placed.a.points()) == 3 && polytope::affine_rank(placed.b.points()) == 3 ? 1U : 0U;
    EXPECT_LE(solved(input).optima().size(), 1U) << input.id << ": ties are gone";
  }
  EXPECT_EQ(rank, 40U);
}

}  // namespace
}  // namespace fathom::families

// How near the n^2 near ties are, in exact arithmetic; and that nothing else of P comes near them.

namespace {

using namespace fathom;
using namespace fathom::testing;
using families::find_family;
using families::ratio;

/// The spread of the distances that the family's description promises, for n edges a chain.
mpq_class promised(std::string_view family, unsigned long n) {
  if (family == "crossed_ties") return ratio(1, 8UL << 20);  // (1/32)^4 / 8
  if (family == "crossed_shrinking_ties") return ratio(1, mpz_class(n) * n * 32);
  return ratio(1, mpz_class(n) * n * n * n * 8);
}

constexpr const char* tie_families[] = {"crossed_ties", "crossed_shrinking_ties", "crossed_vanishing_ties"};

class TiePatch : public ::testing::TestWithParam<const char*> {};

TEST_P(TiePatch, TheWholeGridTiesNearlyAndNothingElseDoes) {
  for (const unsigned n : {16U, 64U, 200U}) {
    const Case input = find_family(GetParam())->make(n, n);
    const auto p = prepare(input);
    ASSERT_EQ(p->a.vertices.size(), n + 3) << input.id << ": every point of the chain is extreme";
    ASSERT_EQ(p->b.vertices.size(), n + 3) << input.id;
    Spread grid, others;
    for (const MeasuredCrossing& c : measured_crossings(*p)) {
      const bool chains = c.of_a[1] == c.of_a[0] + 1 && c.of_a[1] <= n && c.of_b[1] == c.of_b[0] + 1 && c.of_b[1] <= n;
      (chains ? grid : others).add(c.plane.squared());
    }
    EXPECT_EQ(grid.count, std::size_t{n} * n) << input.id;
    EXPECT_TRUE(grid.within(promised(GetParam(), n) * ratio(11, 10))) << input.id;
    EXPECT_FALSE(grid.within(promised(GetParam(), n) / 2)) << input.id << ": a saddle, not a plain";
    EXPECT_LT(others.count, 16 * n) << input.id;
    EXPECT_GT(others.least, 2 * grid.greatest) << input.id;
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points);
    EXPECT_EQ(depth.squared(), grid.least / (p->placed.denominator * p->placed.denominator)) << input.id;
    EXPECT_EQ(depth.contact()->kind, ContactKind::edge_edge) << input.id;
  }
}

// Far beyond the sizes of the other tests, from the chains' points alone: every 37th edge of
// either.
TEST_P(TiePatch, LargeChainsTieAsPromised) {
  const unsigned n = 5000;
  const Case input = find_family(GetParam())->make(1, n);
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  Spread grid;
  for (unsigned i = 0; i < n; i += 37)
    for (unsigned j = 0; j < n; j += 37)
      grid.add(spanned_plane(placed.a[i], placed.a[i + 1], placed.b[j], placed.b[j + 1]).squared());
  const bool rounded = std::string_view(GetParam()) == "crossed_vanishing_ties";
  EXPECT_TRUE(grid.within(promised(GetParam(), n) * (rounded ? 4 : ratio(11, 10))));
  EXPECT_FALSE(grid.within(promised(GetParam(), n) / 2));
}

TEST_P(TiePatch, CoordinatesAreBinary64UpToTheSizeStated) {
  const unsigned log = std::string_view(GetParam()) == "crossed_ties"             ? 14
                       : std::string_view(GetParam()) == "crossed_vanishing_ties" ? 11
                                                                                  : 15;
  const Case input = find_family(GetParam())->make(1, 1U << log);
  for (const Body* body : {&input.a, &input.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) ASSERT_EQ(mpq_class(x->get_d()), *x);
}

// The noise reaches from far above the smooth ties' spread to far below it.
TEST(NoisyTies, AreAsNearAsTheNoiseAllows) {
  const unsigned n = 200;
  std::size_t above = 0, below = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Case input = find_family("crossed_noisy_ties")->make(seed, n);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    Spread grid;
    for (unsigned i = 0; i < n; i += 7)
      for (unsigned j = 0; j < n; j += 7)
        grid.add(spanned_plane(placed.a[i], placed.a[i + 1], placed.b[j], placed.b[j + 1]).squared());
    EXPECT_TRUE(grid.within(ratio(1, mpz_class(1) << 28))) << input.id;
    // Five times a rotation by 3/5, 4/5: coordinates are multiples of the noise.
    mpz_class unit = 1;
    for (const Point& p : input.a.points) unit = std::max(unit, p.z.get_den());
    const auto bits = mpz_sizeinbase(unit.get_mpz_t(), 2) - 1;
    EXPECT_GE(bits, 46U) << input.id;
    EXPECT_LE(bits, 90U) << input.id;
    above += bits < 56;
    below += bits > 80;
    const auto p = prepare(input);
    EXPECT_EQ(p->a.vertices.size(), n + 3) << input.id << ": every point of the chain is extreme";
    EXPECT_EQ(p->b.vertices.size(), n + 3) << input.id;
  }
  EXPECT_GT(above, 0U);
  EXPECT_GT(below, 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, TiePatch, ::testing::ValuesIn(tie_families),
                         [](const auto& info) { return std::string(info.param); });

// All crossed bundles, at sizes beyond those of the tests over all families: Theta(n^2) crossings,
// one of which decides, and the pipeline against its twins.

struct Bundle {
  const char* family;
  double share;  ///< of n^2 that are crossings, about
};

constexpr Bundle bundles[] = {{"crossed_fans", 1},
                              {"crossed_parabolas", 1},
                              {"crossed_random_parabolas", 1},
                              {"crossed_twists", 1},
                              {"crossed_patch", 1},
                              {"crossed_prisms", 0.5},
                              {"crossed_random_prisms", 0.5},
                              {"crossed_ties", 1},
                              {"crossed_shrinking_ties", 1},
                              {"crossed_vanishing_ties", 1},
                              {"crossed_noisy_ties", 1},
                              {"crossed_fillets", 0.25}};

class Bundles : public ::testing::TestWithParam<Bundle> {};

TEST_P(Bundles, EqualTheHullOfAllDifferences) {
  for (const unsigned n : {16U, 100U}) {
    const Case input = find_family(GetParam().family)->make(n, n);
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points, {.validate = true});
    const Depth twin = penetration_depth(input.a.points, input.b.points, {.method = Method::naive});
    EXPECT_EQ(depth.status(), Status::penetrating) << input.id;
    EXPECT_EQ(depth.squared(), twin.squared()) << input.id;
    EXPECT_EQ(depth.optima(), twin.optima()) << input.id;
  }
}

TEST_P(Bundles, CrossLikeAGridAndTwoEdgesDecide) {
  for (const unsigned n : {64U, 256U}) {
    const Case input = find_family(GetParam().family)->make(5, n);
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points);
    const double grid = GetParam().share * n * n, crossings = static_cast<double>(depth.counters.crossings);
    EXPECT_GT(crossings, grid * (1 - 8.0 / n)) << input.id;
    EXPECT_LT(crossings, grid * (1 + 32.0 / n)) << input.id;
    EXPECT_LE(depth.counters.edges_a + depth.counters.edges_b, 8 * n + 64) << input.id;
    ASSERT_EQ(depth.status(), Status::penetrating) << input.id;
    for (const Optimum& optimum : depth.optima()) EXPECT_EQ(optimum.contact.kind, ContactKind::edge_edge) << input.id;
    const auto p = fathom::testing::prepare(input);
    const kernels::NearestPlanes scan = depth::nearest_facets_scan(p->a, p->b, p->exponent);
    EXPECT_TRUE(std::ranges::equal(scan.directions(), depth.optima(), {}, {}, &Optimum::direction)) << input.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Bundles, ::testing::ValuesIn(bundles),
                         [](const auto& info) { return std::string(info.param.family); });

// Chains of tangents: as many edges as slopes, strictly convex, each on its tangent.

using namespace fathom::families;

TEST(Slopes, AscendInEqualPartsWithGapsBetween) {
  for (const unsigned n : {2U, 3U, 100U, 4096U}) {
    Random random(n);
    const mpq_class width = ratio(3, 7), part = 2 * width / n;
    const std::vector<mpz_class> slopes = spread_slopes(random, n, width);
    ASSERT_EQ(slopes.size(), n);
    for (unsigned i = 0; i < n; ++i) {
      const mpq_class x = times_power_of_two(mpq_class(slopes[i]), -slope_bits), shift = x + width - i * part;
      EXPECT_GE(shift, part * ratio(249, 1000)) << i;
      EXPECT_LE(shift, part * ratio(751, 1000)) << i;
    }
  }
}

TEST(Tangents, TouchTheOutlineAndTurnStrictly) {
  for (const unsigned n : {2U, 5U, 64U, 2000U})
    for (const mpq_class& width : {ratio(1, 1), ratio(1, 32), ratio(1, n)}) {
      Random random(n);
      const Outline outline{ratio(5, 4), ratio(-1, 16)};
      const std::vector<mpz_class> slopes = spread_slopes(random, n, width);
      const Chain chain = tangent_chain(outline, slopes, width, 3);
      ASSERT_EQ(chain.size(), n + 1);
      EXPECT_EQ(chain.front().along, -3);
      EXPECT_EQ(chain.back().along, 3);
      mpq_class last = 4;
      for (unsigned i = 0; i < n; ++i) {
        const ChainPoint &p = chain[i], &q = chain[i + 1];
        ASSERT_LT(p.along, q.along) << "n = " << n << ", width " << width << ", edge " << i;
        const mpq_class slope = (q.height - p.height) / (q.along - p.along),
                        x = times_power_of_two(mpq_class(slopes[i]), -slope_bits);
        ASSERT_LT(slope, last) << "n = " << n << ", width " << width << ", edge " << i;
        last = slope;
        EXPECT_LT(abs(mpq_class(slope + x)), width / (2 * n)) << "within half of the least gap";
        const mpq_class support = x * x / 2 * outline.quadratic + x * x * x * x * outline.quartic;
        EXPECT_LT(abs(mpq_class(p.height + x * p.along - support)), times_power_of_two(1, -49))
            << "the edge's begin is on the tangent";
        EXPECT_LT(abs(mpq_class(q.height + x * q.along - support)), times_power_of_two(1, -49)) << "and so is its end";
      }
    }
}

// The rounded bars and the twisted fans: their shape, and the two regions that compete.

/// The nearest crossings on either side of the plane x = y, and near the direction of z, where |x|
/// and |y| are below z / 16.
struct Regions {
  Spread right, left, middle;
};

Regions regions(const Prepared& p) {
  Regions result;
  for (const MeasuredCrossing& c : measured_crossings(p)) {
    const Vector& n = c.plane.normal;
    if (n.z <= 0) continue;
    (n.x > n.y ? result.right : result.left).add(c.plane.squared());
    if (16 * abs(n.x) < n.z && 16 * abs(n.y) < n.z) result.middle.add(c.plane.squared());
  }
  return result;
}

void expect_two_minima(const Case& input, const mpq_class& share) {
  const Regions found = regions(*prepare(input));
  Spread minima;
  minima.add(found.right.least);
  minima.add(found.left.least);
  EXPECT_TRUE(minima.within(share)) << input.id << ": " << found.right.least.get_d() / found.left.least.get_d();
  EXPECT_NE(minima.least, minima.greatest) << input.id;
  ASSERT_GT(found.middle.count, 0U) << input.id;
  EXPECT_GT(found.middle.least, minima.greatest * ratio(101, 100)) << input.id << ": a saddle";
  EXPECT_EQ(fathom::testing::exact_depth(input.a.points, input.b.points).contact()->kind, ContactKind::edge_edge)
      << input.id;
}

TEST(Fillets, TwoRegionsCompete) {
  for (const unsigned n : {32U, 64U, 128U, 256U})
    for (const std::uint64_t seed : {1U, 2U, 3U})
      expect_two_minima(find_family("crossed_fillets")->make(seed, n), ratio(1, 65536) + ratio(4, n * n));
}

TEST(Twists, TwoRegionsCompete) {
  for (const unsigned n : {32U, 64U, 128U, 256U})
    for (const std::uint64_t seed : {1U, 2U, 3U})
      expect_two_minima(find_family("crossed_twists")->make(seed, n), ratio(4, n * n));
}

TEST(Fillets, ChainEdgesHaveThreeParallelCopiesAndFlatFacesBetween) {
  const unsigned n = 40, edges = n / 2;
  const auto p = prepare(find_family("crossed_fillets")->make(1, n));
  for (const polytope::Polytope* body : {&p->a, &p->b}) {
    EXPECT_EQ(body->vertices.size(), 3 * (edges + 1) + 2) << "every point is extreme";
    EXPECT_EQ(std::ranges::count_if(body->facets, [](const polytope::Facet& f) { return f.end - f.begin == 4; }),
              2 * edges + 2)
        << "and one trapezium at each end";
    const auto chain_edges = std::ranges::count_if(body->edges, [&](const polytope::Edge& e) {
      const polytope::VertexId low = std::min(e.from, e.to), high = std::max(e.from, e.to);
      return low.value >= 2 && high == low.next();  // the two points below come first, then one copy after the other
    });
    EXPECT_EQ(chain_edges, 3 * edges);
    const std::vector<Vector>& points = body->vertices;
    for (std::uint32_t i = 2; i < 2 + edges; ++i)
      for (const std::uint32_t copy : {edges + 1, 2 * edges + 2})
        EXPECT_EQ(points[i + 1] - points[i], points[copy + i + 1] - points[copy + i]);
  }
}

TEST(Twists, NoThreeEdgesOfAChainHaveDirectionsInOnePlane) {
  const unsigned n = 24;
  const auto p = prepare(find_family("crossed_twists")->make(1, n));
  for (const polytope::Polytope* body : {&p->a, &p->b}) {
    ASSERT_EQ(body->vertices.size(), n + 2) << "every point is extreme";
    const std::vector<Vector>& points = body->vertices;
    std::vector<Vector> directions;
    for (std::size_t i = 0; i + 1 < n; ++i) directions.push_back(points[i + 1] - points[i]);
    for (std::size_t i = 0; i < n - 1; ++i)
      for (std::size_t j = i + 1; j < n - 1; ++j)
        for (std::size_t k = j + 1; k < n - 1; ++k) EXPECT_NE(det(directions[i], directions[j], directions[k]), 0);
  }
}

}  // namespace
