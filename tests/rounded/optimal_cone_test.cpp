// SPDX-License-Identifier: GPL-3.0-or-later
// The optimal directions of bodies that touch, from m + n generators, against the polar of all m n
// differences.

#include "reference/rounded/optimal_cone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom::rounded {
namespace {

using Vectors = std::vector<Vector>;

/// Small integers only, as long.
Vector integral(const Point& p) { return {p.x.get_num(), p.y.get_num(), p.z.get_num()}; }

/// The polar of all differences, by trying the cross products of every pair of them: cubic, and by
/// the rank of P.
class NaivePolar {
 public:
  NaivePolar(std::span<const Point> a, std::span<const Point> b) {
    for (const Point& p : a)
      for (const Point& q : b)
        if (const Vector d = integral(q) - integral(p); !is_zero(d)) all_.insert(primitive(d));
  }

  [[nodiscard]] bool holds(const Vector& u) const {
    return std::all_of(all_.begin(), all_.end(), [&](const Vector& d) { return dot(u, d) <= 0; });
  }

  [[nodiscard]] OptimalCone cone() const {
    if (all_.empty()) return {Lineality::all, {}, {}};
    const Vector first = *all_.begin();
    const auto off_line =
        std::find_if(all_.begin(), all_.end(), [&](const Vector& d) { return !is_zero(cross(first, d)); });
    if (off_line == all_.end()) return {Lineality::plane, upper(first), among({first, -first})};
    const Vector normal = primitive(cross(first, *off_line));
    const bool flat = std::all_of(all_.begin(), all_.end(), [&](const Vector& d) { return dot(normal, d) == 0; });
    Vectors candidates;
    for (const Vector& d : all_) {
      if (flat) add(candidates, cross(normal, d));
      else
        for (const Vector& e : all_) add(candidates, cross(d, e));
    }
    return {flat ? Lineality::line : Lineality::none, flat ? upper(normal) : Vector{}, among(candidates)};
  }

 private:
  static Vector upper(const Vector& v) { return lexicographically_less(v, -v) ? -v : v; }
  static void add(Vectors& candidates, const Vector& v) {
    if (!is_zero(v)) candidates.insert(candidates.end(), {v, -v});
  }
  [[nodiscard]] Vectors among(const Vectors& candidates) const {
    std::set<Vector, LexicographicOrder> found;
    for (const Vector& v : candidates)
      if (holds(v)) found.insert(primitive(v));
    return {found.begin(), found.end()};
  }

  std::set<Vector, LexicographicOrder> all_;
};

/// On the lattice, which asks for some generators only, from any direction that is known. The faces
/// inside the cone are compared, too.
OptimalCone clever_cone(const std::vector<Point>& a, const std::vector<Point>& b, const Point& x, const Vector& known) {
  kernels::Context context;
  const polytope::PlacedPair pair = polytope::place(a, b);
  const OptimalCone cone = optimal_cone(context, pair, x, known);
  const Vector n = inner_direction(cone);
  EXPECT_EQ(contact_along(a, b, n), depth::contact_of(depth::facing_faces(pair, n)));
  return cone;
}

std::vector<Point> random_points(families::Random& random, long size, long count) {
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (Point& p : points)
    p = {mpq_class(random.between(-size, size)), mpq_class(random.between(-size, size)),
         mpq_class(random.between(-size, size))};
  return points;
}

/// u's part orthogonal to the lineality is a sum of at most three rays, or 0: by Cramer's rule.
bool described(const OptimalCone& cone, const Vector& u) {
  Vector v = u;
  if (cone.lineality == Lineality::all) return true;
  if (cone.lineality == Lineality::line || cone.lineality == Lineality::plane) {
    const mpz_class square = dot(cone.axis, cone.axis), along = dot(u, cone.axis);
    const Vector part{along * cone.axis.x, along * cone.axis.y, along * cone.axis.z};
    v = cone.lineality == Lineality::plane
            ? part
            : Vector{square * u.x - part.x, square * u.y - part.y, square * u.z - part.z};
  }
  if (is_zero(v)) return true;
  const Vectors& rays = cone.rays;
  for (const Vector& p : rays) {
    if (is_zero(cross(p, v)) && dot(p, v) > 0) return true;
    for (const Vector& q : rays) {
      const Vector n = cross(p, q);
      if (!is_zero(n) && dot(n, v) == 0 && dot(cross(p, v), n) >= 0 && dot(cross(v, q), n) >= 0) return true;
      for (const Vector& r : rays)
        if (det(p, q, r) > 0 && det(v, q, r) >= 0 && det(p, v, r) >= 0 && det(p, q, v) >= 0) return true;
    }
  }
  return false;
}

TEST(OptimalCone, EqualsThePolarOfAllDifferences) {
  families::Random random(3);
  std::map<std::pair<int, std::size_t>, int> kinds;
  for (int found = 0; found < 1500;) {
    const long size = random.between(1, 2), most = random.coin() ? 2 : 5, m = random.between(1, most),
               n = random.between(1, most);
    const std::vector<Point> a = random_points(random, size, m), b = random_points(random, size, n);
    const Depth depth = penetration_depth(a, b);
    if (!depth.touch()) continue;
    ++found;
    kernels::Context context;
    const OptimalCone cone = optimal_cone(context, a, b, depth.touch()->point);
    const NaivePolar naive(a, b);
    ASSERT_EQ(cone, naive.cone()) << testing::text(validate(cone, a, b));
    for (const Vector& known : {depth.touch()->direction, cone.direction()})
      ASSERT_EQ(clever_cone(a, b, depth.touch()->point, known), cone);
    EXPECT_TRUE(validate(cone, a, b).ok()) << testing::text(validate(cone, a, b));
    EXPECT_TRUE(naive.holds(cone.direction()));
    EXPECT_FALSE(is_zero(cone.direction()));
    for (int i = 0; i < 10; ++i) {
      const Vector u{mpz_class(random.between(-3, 3)), mpz_class(random.between(-3, 3)),
                     mpz_class(random.between(-3, 3))};
      EXPECT_EQ(naive.holds(u), described(cone, u));
    }
    ++kinds[{static_cast<int>(cone.lineality), cone.rays.size()}];
  }
  // Every kind there is, but more than five rays.
  for (const std::pair<int, std::size_t>& kind :
       {std::pair<int, std::size_t>{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}, {3, 0}})
    EXPECT_GT(kinds[kind], 0) << kind.first << " " << kind.second;
}

TEST(OptimalCone, DoesNotDependOnTheCommonPoint) {
  // The edge from (0,0,0) to (2,0,0) is common to a tent and a plate.
  const std::vector<Point> a{{0, 0, 0}, {2, 0, 0}, {1, 1, -2}, {1, -1, -2}},
      b{{0, -1, 0}, {2, -1, 0}, {0, 1, 0}, {2, 1, 0}};
  kernels::Context context;
  const OptimalCone expected = NaivePolar(a, b).cone();
  for (const mpq_class& x : {mpq_class(0), mpq_class(1, 3), mpq_class(1), mpq_class(2)})
    for (const OptimalCone& cone :
         {optimal_cone(context, a, b, {x, 0, 0}), clever_cone(a, b, {x, 0, 0}, expected.direction())})
      EXPECT_EQ(cone, expected) << x;
}

TEST(OptimalCone, OfTwoApexesHasAsManyRaysAsTheirJointPyramidHasEdges) {
  std::vector<Point> a{{0, 0, 0}}, b{{0, 0, 0}};
  std::set<std::pair<mpq_class, mpq_class>> edges;
  for (int i = -40; i <= 40; ++i) {
    const mpq_class t = families::ratio(i, 10), s = 1 + t * t, x = 2 * t / s, y = (1 - t * t) / s;
    a.push_back({x, y, -1});
    b.push_back({x, y, 1});
    edges.insert({{x, y}, {-x, -y}});
  }
  kernels::Context context;
  const OptimalCone cone = optimal_cone(context, a, b, {});
  EXPECT_EQ(clever_cone(a, b, {}, cone.direction()), cone);
  EXPECT_EQ(cone.rays.size(), edges.size());
  EXPECT_EQ(edges.size(), 152U) << "ten are shared";
  EXPECT_TRUE(validate(cone, a, b).ok());
}

TEST(OptimalCone, OfBodiesInPrint) {
  const auto cone = [](const std::vector<Point>& a, const std::vector<Point>& b) {
    return *signed_depth(hull(a), hull(b)).cone;
  };
  const Point origin{}, east{1, 0, 0}, west{-1, 0, 0}, north{0, 1, 0}, south{0, -1, 0};
  EXPECT_EQ(cone({origin}, {origin}), (OptimalCone{Lineality::all, {}, {}})) << "one point";
  EXPECT_EQ(cone({origin}, {origin}).direction(), (Vector{-1, 0, 0}));
  EXPECT_EQ(cone({east, west}, {east, west}), (OptimalCone{Lineality::plane, {1, 0, 0}, {}})) << "one segment";
  EXPECT_EQ(cone({east, west}, {east, west}).direction(), (Vector{0, -1, 0}));
  EXPECT_EQ(cone({origin}, {origin, east}), (OptimalCone{Lineality::plane, {1, 0, 0}, {{-1, 0, 0}}}))
      << "the end of a segment";
  EXPECT_EQ(cone({east, west}, {north, south}), (OptimalCone{Lineality::line, {0, 0, 1}, {}})) << "crossing segments";
  EXPECT_EQ(cone({east, west}, {north, south}).direction(), (Vector{0, 0, -1}));
  EXPECT_EQ(cone({east, west}, {origin, south}), (OptimalCone{Lineality::line, {0, 0, 1}, {{0, 1, 0}}})) << "a T";
}

TEST(OptimalCone, RefusesBodiesThatOverlap) {
  const std::vector<Point> a{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, 0, 1}};
  kernels::Context context;
  EXPECT_THROW(optimal_cone(context, a, a, {}), std::logic_error);
  const std::vector<Point> inside{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  EXPECT_THROW(clever_cone(a, inside, {}, {1, 0, 0}), std::logic_error);
}

TEST(OptimalCone, OfTheCatalogue) {
  int touching = 0;
  for (const families::CatalogueEntry& entry : families::catalogue()) {
    if (entry.status != Status::touching) continue;
    const SignedDepth depth = signed_depth(hull(entry.pair.a.points), hull(entry.pair.b.points));
    ASSERT_TRUE(depth.cone.has_value()) << entry.name;
    EXPECT_TRUE(validate(*depth.cone, entry.pair.a.points, entry.pair.b.points).ok()) << entry.name;
    kernels::Context context;
    const Point common = std::get<Depth>(depth.core).touch()->point;
    EXPECT_EQ(*depth.cone, optimal_cone(context, entry.pair.a.points, entry.pair.b.points, common)) << entry.name;
    ++touching;
  }
  EXPECT_GT(touching, 5);
}

// The faces that a contact names: all points that are farthest in a direction, by brute force,
// whether the cores overlap, touch or are apart.

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
