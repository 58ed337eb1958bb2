// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of every family by the laws that any depth obeys: convex bodies are what they were before
// they were cut, all shorter translations overlap, bodies may be exchanged, moved and scaled
// together, and the checker accepts every proof.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "fathom/certificate.hpp"
#include "kernels/vector.hpp"
#include "tests/unions/naive_union.hpp"
#include "tests/unions/pieces.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"

namespace fathom::unions {
namespace {

using families::Family;
using Places = std::set<std::tuple<mpq_class, mpq_class, mpq_class>>;

bool is_cut(const Family& family) { return family.name.starts_with("cut_"); }

/// Each pair of pieces, by the method for two convex bodies; those with a plane between them along
/// an axis are not asked.
bool overlap(const Pieces& a, const Pieces& b) {
  const auto apart = [](const std::vector<Point>& p, const std::vector<Point>& q, mpq_class Point::*c) {
    const auto by = [c](const Point& x, const Point& y) { return x.*c < y.*c; };
    const auto [p_low, p_high] = std::minmax_element(p.begin(), p.end(), by);
    const auto [q_low, q_high] = std::minmax_element(q.begin(), q.end(), by);
    return (*p_high).*c <= (*q_low).*c || (*q_high).*c <= (*p_low).*c;
  };
  for (const std::vector<Point>& p : a)
    for (const std::vector<Point>& q : b) {
      if (apart(p, q, &Point::x) || apart(p, q, &Point::y) || apart(p, q, &Point::z)) continue;
      if (penetration_depth(p, q).status() == Status::penetrating) return true;
    }
  return false;
}

Places reversed(const Places& all) {
  Places result;
  for (const auto& [x, y, z] : all) result.emplace(-x, -y, -z);
  return result;
}

/// Runs `test` on some cases of each family.
template <class Test>
void for_each_case(std::uint64_t seeds, unsigned size, Test test) {
  for (const Family& family : families::families(families::Kind::unions))
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      const Case pair = family.make(seed, std::min(size, family.usual_size));
      SCOPED_TRACE(pair.id);
      test(*pair.a.pieces, *pair.b.pieces);
    }
}

TEST(UnionTorture, ConvexBodiesAreWhatTheyWereBeforeTheyWereCut) {
  std::size_t penetrating = 0, cases = 0;
  for (const Family& family : families::families(families::Kind::unions)) {
    for (std::uint64_t seed = 200; is_cut(family) && seed < 240; ++seed) {
      const Case pair = family.make(seed, 2 + static_cast<unsigned>(seed % 7));
      SCOPED_TRACE(pair.id);
      const UnionDepth cut = union_depth(*pair.a.pieces, *pair.b.pieces);
      const Depth whole = penetration_depth(joined(*pair.a.pieces), joined(*pair.b.pieces));
      ASSERT_EQ(cut.status, whole.status());
      EXPECT_EQ(cut.squared(), whole.squared());
      ++cases;
      if (cut.status != Status::penetrating) continue;
      ++penetrating;
      Places expected;
      for (const Optimum& o : whole.optima()) {
        const Point t = o.translation();
        expected.emplace(t.x, t.y, t.z);
      }
      EXPECT_EQ(places(cut), expected) << "law: all ties";
      for (const UnionOptimum& o : cut.optima) EXPECT_TRUE(o.clearance) << "law: convex bodies have room beside them";
    }
  }
  EXPECT_EQ(cases, 280U);
  EXPECT_GT(penetrating, 180U);
}

TEST(UnionTorture, ShorterTranslationsOverlapAndOptimaSeparate) {
  std::size_t shorter = 0;
  std::mt19937_64 random(1);
  for_each_case(5, 5, [&](const Pieces& a, const Pieces& b) {
    const UnionDepth depth = union_depth(a, b, {nullptr, false});
    EXPECT_EQ(overlap(a, b), depth.status == Status::penetrating);
    if (depth.status != Status::penetrating) return;
    for (const UnionOptimum& o : depth.optima) {
      EXPECT_FALSE(overlap(moved(a, o.translation), b));
      EXPECT_TRUE(overlap(moved(a, mpq_class(65535, 65536) * o.translation), b));
    }
    for (int i = 0; i < 12; ++i) {
      const auto coordinate = [&random] { return static_cast<long>(random() % 201) - 100; };
      const long x = coordinate(), y = coordinate(), z = coordinate();
      const double length = std::sqrt(static_cast<double>(x * x + y * y + z * z));
      if (length == 0) continue;
      const mpq_class s(std::sqrt(depth.squared().get_d()) / length *
                        (i % 3 == 0 ? 0.9999 : std::cbrt(static_cast<double>(random() % 1000) / 1000)));
      const Point t = s * Point{x, y, z};
      if (dot(t, t) >= depth.squared()) continue;
      EXPECT_TRUE(overlap(moved(a, t), b)) << "law: what is shorter than the depth overlaps";
      ++shorter;
    }
  });
  EXPECT_GT(shorter, 600U);
}

TEST(UnionTorture, BodiesMayBeExchangedMovedScaledAndRepeated) {
  for_each_case(4, 4, [&](const Pieces& a, const Pieces& b) {
    const UnionDepth depth = union_depth(a, b);
    const Point by{mpq_class(1, 3), -1000, mpq_class(7, 5)};
    const UnionDepth exchanged = union_depth(b, a), elsewhere = union_depth(moved(a, by), moved(b, by));
    const UnionDepth larger = union_depth(scaled(a, mpq_class(3, 7)), scaled(b, mpq_class(3, 7)));
    Pieces twice = a;
    twice.insert(twice.end(), a.rbegin(), a.rend());
    const UnionDepth repeated = union_depth(twice, b);
    for (const UnionDepth* other : {&exchanged, &elsewhere, &larger, &repeated}) {
      EXPECT_EQ(other->status, depth.status);
      EXPECT_EQ(other->optima.size(), depth.optima.size());
    }
    EXPECT_EQ(exchanged.squared(), depth.squared());
    EXPECT_EQ(elsewhere.squared(), depth.squared());
    EXPECT_EQ(larger.squared(), depth.squared() * mpq_class(9, 49));
    EXPECT_EQ(reversed(places(exchanged)), places(depth));
    EXPECT_EQ(places(elsewhere), places(depth));
    EXPECT_EQ(places(repeated), places(depth));
    for (std::size_t i = 0; i < depth.optima.size(); ++i) {
      EXPECT_EQ(elsewhere.optima[i].clearance, depth.optima[i].clearance);
      EXPECT_EQ(repeated.optima[i].clearance, depth.optima[i].clearance);
    }
    if (!depth.apart) return;
    EXPECT_EQ(exchanged.apart->distance.squared, depth.apart->distance.squared);
    EXPECT_EQ(elsewhere.apart->distance.squared, depth.apart->distance.squared);
  });
}

TEST(UnionTorture, TheCheckerAcceptsEveryProof) {
  std::size_t proofs = 0;
  for_each_case(8, 6, [&](const Pieces& a, const Pieces& b) {
    const UnionDepth depth = union_depth(a, b);
    const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(a, b, depth));
    ASSERT_TRUE(verdict.accepted()) << verdict.line << ": " << verdict.reason;
    EXPECT_EQ(verdict.format, 3);
    EXPECT_EQ(verdict.status, depth.status == Status::penetrating ? "penetrating"
                              : depth.status == Status::touching  ? "touching"
                                                                  : "disjoint");
    if (depth.status == Status::penetrating) {
      EXPECT_EQ(verdict.depth_squared, depth.squared().get_str());
      EXPECT_EQ(verdict.optima, depth.optima.size());
    } else if (depth.apart) {
      EXPECT_EQ(verdict.distance_squared, depth.apart->distance.squared.get_str());
    }
    ++proofs;
  });
  EXPECT_EQ(proofs, 8 * families::families(families::Kind::unions).size());
}

}  // namespace
}  // namespace fathom::unions
