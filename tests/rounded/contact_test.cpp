// SPDX-License-Identifier: GPL-3.0-or-later
// The faces that a contact names: all points that are farthest in a direction, by brute force,
// whether the cores overlap, touch or are apart.
#include <gtest/gtest.h>

#include <set>

#include "fathom/signed_depth.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/random.hpp"

namespace fathom::rounded {
namespace {

using Points = std::vector<Point>;

void expect_faces(const Contact& contact, const Points& a, const Points& b, const Vector& n, const std::string& id) {
  EXPECT_EQ(contact.a, testing::face(a, -n)) << id;
  EXPECT_EQ(contact.b, testing::face(b, n)) << id;
  EXPECT_EQ(contact.kind, testing::kind_of(contact, a, b)) << id;
}

/// A direction in the relative interior of the cone, other than that of the sum of all rays.
Vector another_inside(const OptimalCone& cone, families::Random& random) {
  Vector sum;
  const auto add = [&](const mpz_class& s, const Vector& v) { sum = sum + Vector{s * v.x, s * v.y, s * v.z}; };
  for (const Vector& ray : cone.rays) add(mpz_class(random.between(1, 9)), ray);
  for (const Vector& line : lineality_basis(cone)) add(mpz_class(random.between(-9, 9)), line);
  return is_zero(sum) ? cone.direction() : primitive(sum);
}

Points random_points(families::Random& random, std::size_t most) {
  Points points(static_cast<std::size_t>(random.between(1, static_cast<std::int64_t>(most))));
  for (Point& p : points)
    p = {mpq_class(random.between(-2, 2)), mpq_class(random.between(-2, 2)), mpq_class(random.between(-2, 2))};
  return points;
}

TEST(Contact, NamesTheFacesOfCoresThatOverlapTouchOrAreApart) {
  families::Random random(7);
  std::set<std::pair<Status, ContactKind>> seen;
  for (int i = 0; i < 3000; ++i) {
    const Points a = random_points(random, 6);
    Points b = random_points(random, 6);
    const mpq_class shift(random.between(0, 6));
    for (Point& p : b) p.x += shift;
    const mpq_class r = families::ratio(random.between(0, 3), 2), s = families::ratio(random.between(0, 2), 3);
    const SignedDepth depth = signed_depth(with_margin(hull(a), r), with_margin(hull(b), s));
    const std::string id = std::to_string(i);
    ASSERT_TRUE(depth.contact()) << id;
    seen.emplace(std::get<Depth>(depth.core).status(), depth.contact()->kind);
    if (!depth.cone) {
      expect_faces(*depth.contact(), a, b, depth.direction(), id);
      continue;
    }
    expect_faces(*depth.contact(), a, b, inner_direction(*depth.cone), id);
    for (int k = 0; k < 3; ++k)
      expect_faces(*depth.contact(), a, b, another_inside(*depth.cone, random), id + ", another direction inside");
    for (const Vector& ray : depth.cone->rays) {
      const testing::Ids of_a = testing::face(a, -ray), of_b = testing::face(b, ray);
      EXPECT_GE(testing::rank_of(a, of_a) + testing::rank_of(b, of_b),
                testing::rank_of(a, depth.contact()->a) + testing::rank_of(b, depth.contact()->b))
          << id;
    }
  }
  for (const ContactKind kind : {ContactKind::vertex_vertex, ContactKind::vertex_edge, ContactKind::edge_vertex,
                                 ContactKind::edge_edge, ContactKind::vertex_facet, ContactKind::facet_vertex})
    for (const Status cores : {Status::touching, Status::disjoint})
      EXPECT_TRUE(seen.contains({cores, kind})) << name(cores) << name(kind);
}

TEST(Contact, OfCurvedBodiesAndHalfSpacesIsNone) {
  EXPECT_FALSE(signed_depth(cylinder(1, 1), box({1, 1, 1})).contact());
  EXPECT_FALSE(signed_depth(box({1, 1, 1}), halfspace({0, 0, 1}, 0)).contact());
  EXPECT_FALSE(signed_depth(ellipsoid({1, 2, 3}), halfspace({0, 0, 1}, 0)).contact());
}

TEST(Counters, SayWhatRan) {
  EXPECT_EQ(signed_depth(box({1, 1, 1}), halfspace({0, 0, 1}, 0)).counters().support_calls, 1U);
  const SignedDepth curved =
      signed_depth(moved(cone(1, 1), rigid_pose({1, 2, 3, 4}, {mpq_class(1, 3), mpq_class(1, 5), 1})), cylinder(1, 1));
  EXPECT_GT(curved.counters().support_calls, 4U);
  EXPECT_EQ(curved.counters().inner_facets, std::get<Bracket>(curved.core).polytope.facets.size());
  SignedDepthOptions few;
  few.support_calls = 10;
  EXPECT_LE(signed_depth(moved(cone(1, 1), rigid_pose({1, 2, 3, 4}, {1, 0, 0})), cylinder(1, 1), few)
                .counters()
                .support_calls,
            10U);
  const SignedDepth capsules =
      signed_depth(capsule(1, 1), moved(capsule(1, 1, Axis::x), rigid_pose({1, 0, 0, 0}, {0, 1, 0})));
  EXPECT_EQ(capsules.counters().scans, std::get<Depth>(capsules.core).counters.scans);
  EXPECT_EQ(capsules.counters().support_calls, 0U);
}

}  // namespace
}  // namespace fathom::rounded
