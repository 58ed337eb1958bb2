// SPDX-License-Identifier: GPL-3.0-or-later
// Each degradation breaks what its name says: shown on the hulls of the result, by exact equalities
// that fail on the generic pair.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

/// Both hulls on one lattice, with their edge directions and facet normals.
struct Shape {
  polytope::PlacedPair placed;
  polytope::Polytope a, b;
};

Shape shape(const Case& pair) {
  Shape result{polytope::place(pair.a.points, pair.b.points), {}, {}};
  result.a = polytope::convex_hull(result.placed.a.points());
  result.b = polytope::convex_hull(result.placed.b.points());
  return result;
}

std::vector<Vector> directions(const polytope::Polytope& p) {
  std::vector<Vector> result;
  for (const polytope::Edge& e : p.edges) result.push_back(primitive(p.vertices[e.to] - p.vertices[e.from]));
  return result;
}

std::vector<Vector> normals(const polytope::Polytope& p) {
  std::vector<Vector> result;
  for (const polytope::Facet& f : p.facets) result.push_back(f.normal);
  return result;
}

mpz_class offset(const polytope::Polytope& p, const polytope::Facet& f) {
  return dot(f.normal, p.vertices[p.corners[f.begin]]);
}

template <class Law>
bool any(const std::vector<Vector>& list, Law law) {
  return std::ranges::any_of(list, law);
}

template <class Law>
bool any(const std::vector<Vector>& of_a, const std::vector<Vector>& of_b, Law law) {
  return any(of_a, [&](const Vector& p) { return any(of_b, [&](const Vector& q) { return law(p, q); }); });
}

/// Whether both bodies have one.
template <class Law>
bool each(const std::vector<Vector>& of_a, const std::vector<Vector>& of_b, Law law) {
  return any(of_a, law) && any(of_b, law);
}

bool parallel(const Vector& p, const Vector& q) { return is_zero(cross(p, q)); }

bool has_duplicates(const std::vector<Vector>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::find(points.begin() + static_cast<long>(i) + 1, points.end(), points[i]) != points.end()) return true;
  return false;
}

bool has_point_inside_an_edge(const std::vector<Vector>& points, const polytope::Polytope& hull) {
  return std::ranges::any_of(hull.edges, [&](const polytope::Edge& e) {
    const Vector &from = hull.vertices[e.from], &to = hull.vertices[e.to];
    return std::ranges::any_of(points, [&](const Vector& p) {
      return p != from && p != to && parallel(p - from, to - from) && dot(p - from, p - to) < 0;
    });
  });
}

bool has_facet_of_five_points(const std::vector<Vector>& points, const polytope::Polytope& hull) {
  return std::ranges::any_of(hull.facets, [&](const polytope::Facet& f) {
    const auto on_it =
        std::ranges::count_if(points, [&](const Vector& p) { return dot(f.normal, p) == offset(hull, f); });
    return f.end - f.begin >= 4 && on_it >= 5;
  });
}

bool has_node_on_arc(const Shape& s) {
  return any(normals(s.a), [&](const Vector& n) {
    return std::ranges::any_of(s.b.edges, [&](const polytope::Edge& e) {
      const Vector &left = s.b.facets[e.left].normal, &right = s.b.facets[e.right].normal;
      const Vector circle = cross(left, right);
      return dot(circle, n) == 0 && dot(cross(left, -n), circle) > 0 && dot(cross(-n, right), circle) > 0;
    });
  });
}

bool have_coplanar_facets(const Shape& s) {
  return std::ranges::any_of(s.a.facets, [&](const polytope::Facet& f) {
    return std::ranges::any_of(
        s.b.facets, [&](const polytope::Facet& g) { return f.normal == g.normal && offset(s.a, f) == offset(s.b, g); });
  });
}

/// Opposite optima, all of them.
bool ties_come_in_pairs(const Case& pair) {
  const Depth depth = penetration_depth(pair.a.points, pair.b.points);
  std::vector<Vector> found;
  for (const Optimum& o : depth.optima()) found.push_back(o.direction);
  return !found.empty() &&
         std::ranges::all_of(found, [&](const Vector& n) { return std::ranges::find(found, -n) != found.end(); });
}

/// At most `most` different values of each coordinate.
bool is_coarse(const Case& pair, std::size_t most) {
  std::set<std::string> values;
  for (const Body* body : {&pair.a, &pair.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) values.insert(x->get_str());
  return values.size() <= most;
}

using Law = std::function<bool(const Case&)>;

const std::map<Degradation, Law>& laws() {
  static const Vector pole{0, 0, 1}, upright{0, 1, 0};
  static const auto on_shape = [](bool (*law)(const Shape&)) {
    return [law](const Case& pair) { return law(shape(pair)); };
  };
  static const std::map<Degradation, Law> all{
      {Degradation::duplicate_points, on_shape([](const Shape& s) {
         return has_duplicates(s.placed.a.points()) && has_duplicates(s.placed.b.points());
       })},
      {Degradation::collinear_points, on_shape([](const Shape& s) {
         return has_point_inside_an_edge(s.placed.a.points(), s.a) &&
                has_point_inside_an_edge(s.placed.b.points(), s.b);
       })},
      {Degradation::coplanar_points, on_shape([](const Shape& s) {
         return has_facet_of_five_points(s.placed.a.points(), s.a) &&
                has_facet_of_five_points(s.placed.b.points(), s.b);
       })},
      {Degradation::shared_vertex,
       on_shape([](const Shape& s) { return any(s.a.vertices, s.b.vertices, std::equal_to<Vector>()); })},
      {Degradation::shared_edge_direction,
       on_shape([](const Shape& s) { return any(directions(s.a), directions(s.b), parallel); })},
      {Degradation::shared_facet_normal,
       on_shape([](const Shape& s) { return any(normals(s.a), normals(s.b), std::equal_to<Vector>()); })},
      {Degradation::opposite_facet_normals, on_shape([](const Shape& s) {
         return any(normals(s.a), normals(s.b), [](const Vector& n, const Vector& m) { return n == -m; });
       })},
      {Degradation::coplanar_facets, on_shape(have_coplanar_facets)},
      {Degradation::axis_aligned_facet, on_shape([](const Shape& s) {
         return each(normals(s.a), normals(s.b), [](const Vector& n) { return dot(n, n) == 1; });
       })},
      {Degradation::normal_at_pole, on_shape([](const Shape& s) {
         return each(normals(s.a), normals(s.b), [](const Vector& n) { return parallel(n, pole); });
       })},
      {Degradation::normal_on_equator, on_shape([](const Shape& s) {
         return each(normals(s.a), normals(s.b), [](const Vector& n) { return n.z == 0; });
       })},
      {Degradation::arc_on_equator, on_shape([](const Shape& s) {
         return each(directions(s.a), directions(s.b), [](const Vector& d) { return parallel(d, pole); });
       })},
      {Degradation::vertical_edge, on_shape([](const Shape& s) {
         return each(directions(s.a), directions(s.b), [](const Vector& d) { return d.y == 0; });
       })},
      {Degradation::nodes_on_one_vertical, on_shape([](const Shape& s) {
         return any(normals(s.a), normals(s.b),
                    [](const Vector& n, const Vector& m) { return det(n, m, upright) == 0; });
       })},
      {Degradation::normal_on_arc, on_shape(has_node_on_arc)},
      {Degradation::flattened_body, on_shape([](const Shape& s) { return s.a.rank == 2 || s.b.rank == 2; })},
      {Degradation::identical_bodies, [](const Case& pair) { return pair.a.points == pair.b.points; }},
      {Degradation::tie_by_reflection, ties_come_in_pairs},
      {Degradation::touching_translation,
       [](const Case& pair) { return penetration_depth(pair.a.points, pair.b.points).status() == Status::touching; }},
      {Degradation::snapped_to_lattice, [](const Case& pair) { return is_coarse(pair, 40); }},
  };
  return all;
}

class EveryWay : public ::testing::TestWithParam<DegradationName> {};

TEST_P(EveryWay, BreaksWhatItSays) {
  const Law& law = laws().at(GetParam().way);
  for (const std::string_view family : {"random_sphere", "random_ball", "random_disjoint"})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Case generic = find_family(family)->make(seed, 14), broken = degrade(generic, GetParam().way, seed);
      EXPECT_FALSE(law(generic)) << generic.id << ": the law must be able to fail";
      EXPECT_TRUE(law(broken)) << broken.id;
      EXPECT_EQ(broken.id, generic.id + "-" + std::string(GetParam().name));
      const Shape s = shape(broken);
      EXPECT_TRUE(GetParam().way == Degradation::flattened_body || (s.a.rank == 3 && s.b.rank == 3)) << broken.id;
    }
}

TEST_P(EveryWay, IsReproducible) {
  const Case generic = find_family("random_ball")->make(1, 9);
  const Case once = degrade(generic, GetParam().way, 6), again = degrade(generic, GetParam().way, 6);
  EXPECT_TRUE(once.a.points == again.a.points && once.b.points == again.b.points);
}

TEST_P(EveryWay, LeavesBodiesWithoutTheFeatureAlone) {
  for (const char* family : {"point_point", "point_segment", "segment_polygon", "polygon_solid"})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Case broken = degrade(find_family(family)->make(seed, 5), GetParam().way, seed);
      EXPECT_FALSE(broken.a.points.empty() || broken.b.points.empty()) << broken.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Degrade, EveryWay,
                         ::testing::ValuesIn(std::vector<DegradationName>(degradations().begin(),
                                                                          degradations().end())),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Degrade, NamesAreInOrder) {
  EXPECT_GE(degradations().size(), 10U);
  EXPECT_EQ(degradations().size(), laws().size());
  for (std::size_t i = 0; i < degradations().size(); ++i) {
    const DegradationName& name = degradations()[i];
    EXPECT_EQ(static_cast<std::size_t>(name.way), i) << name.name;
    EXPECT_NE(find_family("degraded_" + std::string(name.name)), nullptr) << name.name;
  }
}

}  // namespace

namespace fathom::families {
void PrintTo(const DegradationName& name, std::ostream* out) { *out << name.name; }

// That the answers which the bodies were built for are their answers; against the hull of all
// differences.

namespace {

Depth solved_naively(const Case& input) {
  return penetration_depth(input.a.points, input.b.points, {.method = Method::naive});
}

/// k, if the ratio is (1 + 2^-k)^2.
std::optional<std::size_t> exact_gap(const mpq_class& squared_ratio) {
  for (long k = 1; k <= 220; ++k) {
    const mpq_class factor = 1 + times_power_of_two(1, -k);
    if (squared_ratio == factor * factor) return static_cast<std::size_t>(k);
  }
  return std::nullopt;
}

const std::map<std::string_view, ContactKind> kinds{
    {"inverse_facet_vertex", ContactKind::facet_vertex}, {"inverse_vertex_facet", ContactKind::vertex_facet},
    {"inverse_facet_edge", ContactKind::facet_edge},     {"inverse_edge_facet", ContactKind::edge_facet},
    {"inverse_facet_facet", ContactKind::facet_facet},   {"inverse_edge_edge", ContactKind::edge_edge}};

TEST(Inverse, HasTheKindAndTheGapThatWereChosen) {
  for (const auto& [name, kind] : kinds) {
    std::set<std::size_t> gaps;
    for (const unsigned size : {1U, 12U, 20U}) {
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Case input = find_family(name)->make(100 * size + seed, size);
        const Depth depth = solved_naively(input);
        ASSERT_EQ(depth.optima().size(), 1U) << input.id;
        EXPECT_EQ(depth.contact()->kind, kind) << input.id;
        const std::optional<mpq_class> next = depth::second_nearest_squared_naive(input.a.points, input.b.points);
        const std::optional<std::size_t> k = exact_gap(*next / depth.squared());
        ASSERT_TRUE(k.has_value()) << input.id;
        EXPECT_TRUE(*k >= 8 && *k <= 200) << input.id;
        gaps.insert(*k);
        EXPECT_EQ(second_nearest_squared(input.a.points, input.b.points, *depth.penetration()), next) << input.id;
      }
    }
    EXPECT_GT(gaps.size(), 20U) << name;
    EXPECT_GT(*gaps.rbegin(), 150U) << name;
  }
}

// B is moved along n, past the tie: then the facet that was next is the nearest one, and of any
// kind.
TEST(Inverse, TheNextFacetLiesOppositeAndIsOfAnyKind) {
  std::set<ContactKind> seen;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Case input = find_family("inverse_edge_edge")->make(seed, 8);
    const Depth before = solved_naively(input);
    const Point& t = before.translation();
    const mpq_class part = ratio(1, 100);
    input.b = translated(input.b, {mpq_class(t.x * part), mpq_class(t.y * part), mpq_class(t.z * part)});
    const Depth after = solved_naively(input);
    ASSERT_EQ(after.optima().size(), 1U) << input.id;
    EXPECT_EQ(after.direction(), -before.direction()) << input.id;
    seen.insert(after.contact()->kind);
  }
  EXPECT_EQ(seen.size(), 6U);
}

TEST(Inverse, TiesAreExactAndOfTwoKinds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Case input = find_family("inverse_tie")->make(seed, 10);
    const Depth depth = solved_naively(input);
    ASSERT_EQ(depth.optima().size(), 2U) << input.id;
    EXPECT_EQ(depth.optima()[0].direction, -depth.optima()[1].direction) << input.id;
    EXPECT_NE(depth.optima()[0].contact.kind, depth.optima()[1].contact.kind) << input.id;
    EXPECT_GT(*depth::second_nearest_squared_naive(input.a.points, input.b.points), depth.squared() * ratio(129, 128))
        << input.id;
  }
}

/// (next / depth - 1), from the squares; to many digits, from below.
mpq_class relative_gap(const mpq_class& next, const mpq_class& depth) {
  return quotient_of_roots(next, depth, 300) - 1;
}

TEST(Inverse, RidgesHaveTheGapNearly) {
  std::set<ContactKind> seen;
  std::set<long> gaps;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Case input = find_family("inverse_ridge")->make(seed, seed % 2 ? 12 : 5);
    const Depth depth = solved_naively(input);
    ASSERT_EQ(depth.optima().size(), 1U) << input.id;
    const mpq_class gap =
        relative_gap(*depth::second_nearest_squared_naive(input.a.points, input.b.points), depth.squared());
    long k = 1;
    while (times_power_of_two(gap, k) < ratio(3, 4)) ++k;
    EXPECT_LT(abs(times_power_of_two(gap, k) - 1), ratio(1, 1 << 16)) << input.id;
    EXPECT_TRUE(k >= 8 && k <= 200) << input.id;
    gaps.insert(k);
    seen.insert(depth.contact()->kind);
  }
  EXPECT_GT(gaps.size(), 40U);
  EXPECT_EQ(seen.size(), 3U) << "points in general position";
}

}  // namespace
}  // namespace fathom::families
