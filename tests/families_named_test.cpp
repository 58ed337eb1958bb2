// SPDX-License-Identifier: GPL-3.0-or-later
// Each family is what its name and description promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "kernels/filters/support.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

polytope::Polytope hull_of_differences(const polytope::PlacedPair& placed) {
  const polytope::Polytope a = polytope::convex_hull(placed.a.points()), b = polytope::convex_hull(placed.b.points());
  std::vector<Vector> differences;
  for (const Vector& p : a.vertices)
    for (const Vector& q : b.vertices) differences.push_back(q - p);
  return polytope::convex_hull(differences);
}

mpz_class offset(const polytope::Polytope& p, const polytope::Facet& facet) {
  return dot(facet.normal, p.vertices[p.corners[facet.begin]]);
}

/// The rank of the face of the body in direction u.
int face_rank(const std::vector<Vector>& points, const Vector& u) {
  std::vector<Vector> face;
  for (const std::uint32_t i : kernels::extreme_points_naive(points, u)) face.push_back(points[i]);
  return polytope::convex_hull(face).rank;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

TEST(Families, BodiesTouchInTheNamedFeatures) {
  const std::array<std::string, 3> features{"vertex", "edge", "face"};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Case pair = find_family("touching_" + features[i] + "_" + features[j])->make(seed, 6);
        const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
        const polytope::Polytope p = hull_of_differences(placed);
        Vector inside_normal_cone{0, 0, 0};  // of the smallest face of P that holds O
        for (const polytope::Facet& facet : p.facets) {
          ASSERT_GE(offset(p, facet), 0) << pair.id;
          if (offset(p, facet) == 0) inside_normal_cone = inside_normal_cone + facet.normal;
        }
        ASSERT_FALSE(is_zero(inside_normal_cone)) << pair.id;
        EXPECT_EQ(face_rank(placed.a.points(), -inside_normal_cone), static_cast<int>(i)) << pair.id;
        EXPECT_EQ(face_rank(placed.b.points(), inside_normal_cone), static_cast<int>(j)) << pair.id;
      }
}

TEST(Families, ContactsAreOfTheNamedKindAndDepth) {
  const std::array<std::string, 3> features{"vertex", "edge", "facet"};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::uint64_t seed = 0; seed < 5 && i + j >= 2; ++seed) {
        const Case pair = find_family("contact_" + features[i] + "_" + features[j])->make(seed, 6);
        const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
        const depth::NaiveDepth depth = depth::naive_depth(placed.a.points(), placed.b.points());
        ASSERT_EQ(depth.directions.size(), 1u) << pair.id;
        EXPECT_EQ(face_rank(placed.a.points(), -depth.directions[0]), static_cast<int>(i)) << pair.id;
        EXPECT_EQ(face_rank(placed.b.points(), depth.directions[0]), static_cast<int>(j)) << pair.id;
        const mpq_class squared = depth.squared / (placed.denominator * placed.denominator);
        EXPECT_EQ(squared.get_num(), 1) << pair.id;
        const std::size_t log = mpz_scan1(squared.get_den_mpz_t(), 0);
        EXPECT_EQ(squared.get_den(), mpz_class(1) << log) << pair.id << ": the depth is a power of 2";
        EXPECT_TRUE(log % 2 == 0 && log >= 8 && log <= 80) << pair.id;
      }
}

TEST(Families, ParallelEdgesTouchInASegment) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Case pair = find_family("touching_parallel_edges")->make(seed, 6);
    const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
    EXPECT_EQ(depth::naive_depth(placed.a.points(), placed.b.points()).status, Status::touching) << pair.id;
    const polytope::Polytope p = hull_of_differences(placed);
    Vector inside_normal_cone{0, 0, 0};
    for (const polytope::Facet& facet : p.facets)
      if (offset(p, facet) == 0) inside_normal_cone = inside_normal_cone + facet.normal;
    EXPECT_EQ(face_rank(p.vertices, inside_normal_cone), 1) << pair.id << ": transversal edges would give 2";
  }
}

TEST(Families, FlatBodiesHaveTheNamedRanks) {
  const std::array<std::string, 4> names{"point", "segment", "polygon", "solid"};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4 && i + j < 6; ++j)
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Case pair =
            find_family(names[static_cast<std::size_t>(i)] + "_" + names[static_cast<std::size_t>(j)])->make(seed, 6);
        EXPECT_EQ(fathom::testing::hull_of(pair.a).rank, i) << pair.id;
        EXPECT_EQ(fathom::testing::hull_of(pair.b).rank, j) << pair.id;
      }
}

TEST(Families, FlatBodiesOfEveryStatus) {
  for (const std::string_view name : {"segment_segment", "point_polygon", "polygon_polygon"}) {
    std::map<Status, int> seen;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Case pair = find_family(name)->make(seed, 5);
      const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
      ++seen[depth::naive_depth(placed.a.points(), placed.b.points()).status];
    }
    EXPECT_GE(seen[Status::touching], 5) << name;
    EXPECT_GE(seen[Status::disjoint], 1) << name;
  }
}

TEST(Families, BundlesCrossLikeAGrid) {
  for (const Family& family : fathom::families::families()) {
    if (!contains(family.name, "crossed_")) continue;
    const auto facets = [&family](unsigned size) {
      const Case pair = family.make(1, size);
      return hull_of_differences(polytope::place(pair.a.points, pair.b.points)).facets.size();
    };
    const std::size_t small = facets(20), large = facets(60);
    EXPECT_GT(large, 60u * 60u / 4) << family.name;
    EXPECT_GT(2 * large, 9 * small) << family.name << ": nine times as many, nearly";
    if (contains(family.name, "fans") || contains(family.name, "parabolas") || contains(family.name, "patch")) {
      EXPECT_GE(large, 59u * 59u) << family.name << ": every pair of chain edges";
    }
  }
}

TEST(Families, ParabolasTieExactly) {
  const Case pair = find_family("crossed_parabolas")->make(0, 24);
  const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
  EXPECT_GE(depth::naive_depth(placed.a.points(), placed.b.points()).directions.size(), 4u);
}

/// Facets of P within the factor 1 + 2^-bits of the nearest, squared.
std::size_t nearly_nearest(const Case& pair, unsigned bits) {
  const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
  const mpq_class limit = depth::naive_depth(placed.a.points(), placed.b.points()).squared *
                          (1 + times_power_of_two(1, -static_cast<long>(bits)));
  const polytope::Polytope p = hull_of_differences(placed);
  std::size_t count = 0;
  for (const polytope::Facet& facet : p.facets) {
    const mpz_class c = offset(p, facet);
    count += mpq_class(c * c) <= limit * mpq_class(dot(facet.normal, facet.normal));
  }
  return count;
}

TEST(Families, NearTies) {
  EXPECT_GE(nearly_nearest(find_family("crossed_patch")->make(0, 12), 24), 9u * 9u);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Case shifted = find_family("near_ties")->make(seed, 10),
               boxes = find_family("near_tie_boxes")->make(seed, 10);
    EXPECT_GE(nearly_nearest(shifted, 6), 2u) << shifted.id;
    EXPECT_EQ(nearly_nearest(boxes, 7), 3u) << boxes.id;
    EXPECT_EQ(nearly_nearest(boxes, 300), 1u) << boxes.id;
  }
}

TEST(Families, SymmetricSolidsTieExactly) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Case pair = find_family("exact_ties")->make(seed, 10);
    EXPECT_GE(nearly_nearest(pair, 1000), 2u) << pair.id;
  }
}

TEST(Families, CoordinatesReachFarAndNoFarther) {
  const mpq_class huge("1" + std::string(300, '0')), tiny = 1 / huge;
  mpq_class least = huge, greatest = tiny;
  for (const std::string_view name : {"tiny_coordinates", "huge_coordinates", "uneven_coordinates", "wild_coordinates"})
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Case pair = find_family(name)->make(seed, 10);
      for (const Body* body : {&pair.a, &pair.b})
        for (const Point& p : body->points)
          for (const mpq_class* x : {&p.x, &p.y, &p.z}) {
            const mpq_class size = abs(*x);
            ASSERT_LE(size, huge) << pair.id;
            ASSERT_EQ(mpq_class(x->get_d()), *x) << pair.id << ": no binary64 number";
            if (size != 0) least = std::min(least, size);
            greatest = std::max(greatest, size);
          }
    }
  EXPECT_LT(least, tiny * 1000);
  EXPECT_GT(greatest, huge / 1000);
}

TEST(Families, RandomParabolasAreBinary64) {
  const Case pair = find_family("crossed_random_parabolas")->make(1, 50);
  for (const Body* body : {&pair.a, &pair.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) EXPECT_EQ(mpq_class(x->get_d()), *x);
}

}  // namespace
