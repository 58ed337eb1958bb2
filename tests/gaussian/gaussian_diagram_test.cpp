// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian diagrams against the definition: over the interior of an arc exactly its edge is
// extreme, beside it exactly its face's vertex. And each mutation of a diagram is refused.

#include "reference/gaussian/gaussian_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
#include "tests/support/property.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::gaussian {
namespace {

using namespace fathom::testing;

struct Body {
  std::string name;
  polytope::Polytope polytope;
};

std::vector<Vector> corners(const std::vector<int>& coordinates) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  return points;
}

std::vector<Body> make_bodies() {
  std::vector<Body> result;
  const auto add = [&](const std::string& name, const std::vector<Vector>& points) {
    result.push_back({name, polytope::convex_hull(points)});
  };
  add("point", corners({1, 2, 3}));
  add("segment", corners({1, 2, 3, 4, 6, 8}));
  add("triangle", corners({0, 0, 0, 3, 0, 1, 0, 4, 1}));
  add("square", corners({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0}));
  add("tetrahedron", corners({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
  add("cube", corners({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}));
  add("pyramid", corners({0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 1, 1, 1}));
  add("prism", corners({0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 5, 2, 0, 5, 0, 3, 5}));
  std::mt19937_64 random(1);
  for (int i = 0; i < 12; ++i) {
    std::vector<Vector> points, flat;
    const unsigned long size = i % 3 == 0 ? 2 : i % 3 == 1 ? 20 : 700;
    const Vector u = random_direction(random, size), v = random_direction(random, size);
    for (int k = 0; k < 15; ++k) {
      points.push_back(random_vector(random, size));
      flat.push_back(random_integer(random, 4) * u + random_integer(random, 4) * v);
    }
    add("random " + std::to_string(i), points);
    add("random flat " + std::to_string(i), flat);
  }
  return result;
}

GaussianDiagram diagram_of(const polytope::Polytope& polytope, Colour colour) {
  return colour == Colour::a ? gaussian_diagram_of_reflection(polytope) : gaussian_diagram(polytope);
}

std::vector<Vector> points_of(const polytope::Polytope& polytope, Colour colour) {
  std::vector<Vector> points = polytope.vertices;
  if (colour == Colour::a) {
    for (Vector& p : points) p = -p;
  }
  return points;
}

/// Calls law(name, diagram, polytope, colour) for all bodies and both diagrams.
void for_all(const std::function<void(const GaussianDiagram&, const polytope::Polytope&, Colour)>& law) {
  static const std::vector<Body> bodies = make_bodies();
  for (const Body& body : bodies) {
    for (const Colour colour : both_colours) {
      SCOPED_TRACE(body.name + (colour == Colour::a ? ", reflected" : ""));
      law(diagram_of(body.polytope, colour), body.polytope, colour);
    }
  }
}

/// A direction in the interior of the arc.
Vector middle(const GaussianDiagram& diagram, const Arc& arc) {
  if (diagram.rank == 1)
    return cross(arc.circle.exact(), arc.circle.exact().x == 0 ? Vector{1, 0, 0} : Vector{0, 1, 0});
  if (diagram.rank == 2) return cross(arc.circle.exact(), diagram.nodes[arc.from].exact());
  return diagram.nodes[arc.from].exact() + diagram.nodes[arc.to].exact();
}

std::vector<VertexId> sorted_pair(VertexId i, VertexId j) { return {std::min(i, j), std::max(i, j)}; }

std::vector<VertexId> extreme_naive(std::span<const Vector> points, const Vector& u) {
  return kernels::to_ids<VertexId>(kernels::extreme_points_naive(points, u));
}

TEST(GaussianDiagram, ArcsAreTheNormalsOfTheirEdges) {
  for_all([](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
    const std::vector<Vector> points = points_of(polytope, colour);
    ASSERT_EQ(diagram.rank, polytope.rank);
    ASSERT_EQ(diagram.arcs.size(), polytope.edges.size());
    for (const ArcId i : diagram.arcs.ids()) {
      const Arc& arc = diagram.arcs[i];
      const polytope::Edge& edge = polytope.edges[i.value];
      const Vector u = middle(diagram, arc), d = arc.circle.exact();
      EXPECT_EQ(extreme_naive(points, u), sorted_pair(arc.above, arc.below));
      EXPECT_EQ(sorted_pair(edge.from, edge.to), sorted_pair(arc.above, arc.below));
      // A little to either side. The step is small against every difference of products, which are
      // integers.
      mpz_class k = 1;
      for (const Vector& p : points) k += 2 * abs(dot(p, d));
      EXPECT_EQ(extreme_naive(points, k * u + d), std::vector{arc.above});
      EXPECT_EQ(extreme_naive(points, k * u - d), std::vector{arc.below});
    }
  });
}

TEST(GaussianDiagram, NodesAreTheNormalsOfTheirFacets) {
  for_all([](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
    const std::vector<Vector> points = points_of(polytope, colour);
    ASSERT_EQ(diagram.nodes.size(), polytope.facets.size());
    for (const NodeId i : diagram.nodes.ids()) {
      const polytope::Facet& facet = polytope.facets[facet_of(i)];
      std::vector<VertexId> corners(polytope.corners.begin() + facet.begin, polytope.corners.begin() + facet.end);
      std::sort(corners.begin(), corners.end());
      EXPECT_EQ(extreme_naive(points, diagram.nodes[i].exact()), corners);
    }
  });
}

TEST(GaussianDiagram, OfASquare) {
  const polytope::Polytope square = polytope::convex_hull(corners({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0}));
  const GaussianDiagram d = gaussian_diagram(square);
  ASSERT_EQ(d.nodes.size(), 2U);
  ASSERT_EQ(d.arcs.size(), 4U);
  EXPECT_EQ(d.nodes[NodeId(0)].exact(), -d.nodes[NodeId(1)].exact());
  for (const Arc& arc : d.arcs) {
    EXPECT_EQ(arc.from, NodeId(0));
    EXPECT_EQ(arc.to, NodeId(1));
  }
}

TEST(Validate, AcceptsEveryDiagram) {
  for_all([](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
    const kernels::Report report = validate(diagram, polytope, colour);
    EXPECT_TRUE(report.ok()) << report.faults.front();
  });
}

TEST(Validate, TellsADiagramFromThatOfTheReflection) {
  for_all([](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
    EXPECT_EQ(validate(diagram, polytope, other(colour)).ok(), polytope.rank == 0);
  });
}

/// One way to spoil an arc; false if the diagram has no room for it.
struct Mutation {
  std::string name;
  std::function<bool(GaussianDiagram&, ArcId)> spoil;
};

std::vector<Mutation> mutations_of_arcs() {
  return {
      {"negated circle",
       [](GaussianDiagram& d, ArcId i) {
         return d.arcs[i].circle = kernels::Direction(-d.arcs[i].circle.exact()), true;
       }},
      {"above and below exchanged",
       [](GaussianDiagram& d, ArcId i) { return std::swap(d.arcs[i].above, d.arcs[i].below), true; }},
      {"from and to exchanged",
       [](GaussianDiagram& d, ArcId i) { return std::swap(d.arcs[i].from, d.arcs[i].to), d.rank > 1; }},
      {"above is below", [](GaussianDiagram& d, ArcId i) { return d.arcs[i].above = d.arcs[i].below, true; }},
      {"another arc's circle",
       [](GaussianDiagram& d, ArcId i) {
         const kernels::Direction old = d.arcs[i].circle;
         d.arcs[i].circle = d.arcs[ArcId((i.value + 1) % static_cast<std::uint32_t>(d.arcs.size()))].circle;
         return !same_direction(old.exact(), d.arcs[i].circle.exact());
       }},
      {"another node",
       [](GaussianDiagram& d, ArcId i) {
         return d.rank > 1 &&
                (d.arcs[i].from = NodeId((d.arcs[i].from.value + 1) % static_cast<std::uint32_t>(d.nodes.size())),
                 true);
       }},
      {"a node on a full circle, none on another",
       [](GaussianDiagram& d, ArcId i) { return d.arcs[i].to = d.rank == 1 ? NodeId(0) : NodeId::none(), true; }},
      {"a vertex that is not there",
       [](GaussianDiagram& d, ArcId i) { return d.arcs[i].above = VertexId(1000000), true; }},
      {"the arc is missing",
       [](GaussianDiagram& d, ArcId i) {
         return d.arcs.erase(d.arcs.begin() + static_cast<std::ptrdiff_t>(i.value)), true;
       }},
      {"the faces of a parallel edge of the same length",
       [](GaussianDiagram& d, ArcId i) {
         for (const Arc& other : d.arcs) {
           if (&other == &d.arcs[i] || !(other.circle.exact() == d.arcs[i].circle.exact())) continue;
           return d.arcs[i].above = other.above, d.arcs[i].below = other.below, true;
         }
         return false;
       }},
  };
}

TEST(Validate, RefusesEveryMutationOfAnArc) {
  for (const Mutation& mutation : mutations_of_arcs()) {
    int tried = 0;
    for_all([&](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
      for (const ArcId i : diagram.arcs.ids()) {
        GaussianDiagram spoiled = diagram;
        if (!mutation.spoil(spoiled, i)) continue;
        ++tried;
        ASSERT_FALSE(validate(spoiled, polytope, colour).ok()) << mutation.name << ", arc " << i.value;
      }
    });
    EXPECT_GT(tried, 0) << mutation.name;
  }
}

TEST(Validate, RefusesMutationsOfNodesAndOfTheWhole) {
  for_all([](const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
    for (const NodeId i : diagram.nodes.ids()) {
      GaussianDiagram spoiled = diagram;
      spoiled.nodes[i] = kernels::Direction(-diagram.nodes[i].exact());
      ASSERT_FALSE(validate(spoiled, polytope, colour).ok()) << "negated node " << i.value;
      spoiled = diagram;
      std::swap(spoiled.nodes[i],
                spoiled.nodes[NodeId((i.value + 1) % static_cast<std::uint32_t>(diagram.nodes.size()))]);
      ASSERT_FALSE(validate(spoiled, polytope, colour).ok()) << "exchanged node " << i.value;
      spoiled = diagram;
      spoiled.nodes.pop_back();
      ASSERT_FALSE(validate(spoiled, polytope, colour).ok());
    }
    GaussianDiagram spoiled = diagram;
    for (Arc& arc : spoiled.arcs) std::swap(arc.from, arc.to);
    ASSERT_EQ(validate(spoiled, polytope, colour).ok(), polytope.rank < 2) << "every arc reversed";
    spoiled = diagram;
    ++spoiled.rank;
    ASSERT_FALSE(validate(spoiled, polytope, colour).ok());
  });
}

// The diagram of a polytope that is none follows its facets and edges faithfully, and is refused
// all the same.
TEST(Validate, RefusesTheDiagramOfABrokenPolytope) {
  const auto expect_refused = [](const std::string& what, const polytope::Polytope& broken) {
    for (const Colour colour : both_colours)
      EXPECT_FALSE(validate(diagram_of(broken, colour), broken, colour).ok()) << what;
  };
  const polytope::Polytope segment = polytope::convex_hull(corners({1, 2, 3, 4, 6, 8})),
                           square = polytope::convex_hull(corners({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0})),
                           cube = polytope::convex_hull(
                               corners({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}));
  polytope::Polytope broken = segment;
  broken.vertices.back() = broken.vertices.front();
  expect_refused("a segment of length 0", broken);
  broken = square;
  broken.facets.back().normal = broken.facets.back().normal + Vector{0, 0, 3 * broken.facets.back().normal.z};
  EXPECT_TRUE(validate(gaussian_diagram(broken), broken, Colour::b).ok()) << "lengths carry no meaning";
  broken.facets.back().normal = broken.facets.front().normal;
  expect_refused("both sides of a polygon face up", broken);
  broken.facets.front().normal = broken.facets.front().normal + Vector{1, 0, 0};
  broken.facets.back().normal = -broken.facets.front().normal;
  expect_refused("a polygon whose normal is tilted", broken);
  broken = cube;
  broken.facets[polytope::FacetId(2)].normal =
      broken.facets[polytope::FacetId(2)].normal + Vector{0, 0, 1} + Vector{0, 1, 0} + Vector{1, 0, 0};
  expect_refused("a tilted facet", broken);
  broken = cube;
  broken.vertices.push_back({2, 2, 2});
  expect_refused("a vertex without edges", broken);
}

template <class Index>
concept Colours = requires(PerColour<int> pair, Index index) {
  pair[index];
};
static_assert(Colours<Colour> && !Colours<int> && !Colours<bool>, "only a colour tells whose");

TEST(PerColour, HoldsOneForEachColour) {
  PerColour<std::string> names{"minus a", "b"};
  EXPECT_EQ(names[Colour::a], "minus a");
  EXPECT_EQ(names[other(Colour::a)], "b");
  for (const Colour c : both_colours) names[c] += "!";
  EXPECT_EQ(names.a, "minus a!");
  EXPECT_EQ(names.b, "b!");
}

// Crossings against a construction that asks for no signs of arcs: arcs are cut into chords, chords
// meet in points with rational coordinates, and a point is on a chord if its coordinates say so.

/// One arc and the diagram that it lives in.
struct Case {
  GaussianDiagram diagram;
  [[nodiscard]] const Arc& arc() const { return diagram.arcs.front(); }
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  out << "rank " << c.diagram.rank << ", circle " << c.arc().circle.exact();
  for (const kernels::Direction& n : c.diagram.nodes) out << ", " << n.exact();
  return out;
}

Case short_arc(const Vector& from, const Vector& to) {
  return {{3,
           {kernels::Direction(from), kernels::Direction(to)},
           {{kernels::Direction(cross(from, to)), NodeId(0), NodeId(1), {}, {}}}}};
}
Case half_circle(const Vector& from, const Vector& circle) {
  return {{2,
           {kernels::Direction(from), kernels::Direction(-from)},
           {{kernels::Direction(circle), NodeId(0), NodeId(1), {}, {}}}}};
}
Case full_circle(const Vector& circle) {
  return {{1, {}, {{kernels::Direction(circle), NodeId::none(), NodeId::none(), {}, {}}}}};
}

/// The arc as a chain of directions, each less than pi from the next.
std::vector<Vector> chain(const Case& c) {
  const Vector d = c.arc().circle.exact();
  if (c.diagram.rank == 3) return {c.diagram.nodes[NodeId(0)].exact(), c.diagram.nodes[NodeId(1)].exact()};
  const Vector start =
      c.diagram.rank == 2 ? c.diagram.nodes[NodeId(0)].exact() : cross(d, d.x == 0 ? Vector{1, 0, 0} : Vector{0, 1, 0});
  const Vector quarter = cross(d, start);
  if (c.diagram.rank == 2) return {start, quarter, -start};
  return {start, quarter, -start, -quarter, start};
}

/// u = s p + t q, if p, q and u are coplanar. p and q independent.
struct Coordinates {
  mpq_class s, t;
};

std::optional<Coordinates> coordinates(const Vector& u, const Vector& p, const Vector& q) {
  const mpz_class pu[] = {p.x, p.y, p.z, p.x}, qu[] = {q.x, q.y, q.z, q.x}, uu[] = {u.x, u.y, u.z, u.x};
  for (int i = 0; i < 3; ++i) {
    const mpz_class minor = pu[i] * qu[i + 1] - pu[i + 1] * qu[i];
    if (minor == 0) continue;
    Coordinates c{mpq_class(uu[i] * qu[i + 1] - uu[i + 1] * qu[i], minor),
                  mpq_class(pu[i] * uu[i + 1] - pu[i + 1] * uu[i], minor)};
    c.s.canonicalize();
    c.t.canonicalize();
    for (int k = 0; k < 3; ++k) {
      if (mpq_class(c.s * pu[k] + c.t * qu[k]) != uu[k]) return std::nullopt;
    }
    return c;
  }
  return std::nullopt;
}

bool on_chord(const Vector& u, const Vector& p, const Vector& q) {
  const std::optional<Coordinates> c = coordinates(u, p, q);
  return c && c->s >= 0 && c->t >= 0;
}

bool on_arc(const Vector& u, const Case& c) {
  const std::vector<Vector> v = chain(c);
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    if (on_chord(u, v[i], v[i + 1])) return true;
  }
  return false;
}

bool in_interior(const Vector& u, const Case& c) {
  const auto at = [&](const kernels::Direction& n) { return same_direction(n.exact(), u); };
  return on_arc(u, c) && std::none_of(c.diagram.nodes.begin(), c.diagram.nodes.end(), at);
}

/// The points in which the arc's chords cross the plane <x,d> = 0, found on each chord p + t (q -
/// p).
std::vector<Vector> meets(const Case& c, const Vector& d) {
  std::vector<Vector> points;
  const std::vector<Vector> v = chain(c);
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const mpz_class at_p = dot(v[i], d), at_q = dot(v[i + 1], d), fall = at_p - at_q;
    if (fall == 0) continue;  // the other chords have the common points, if the planes differ
    mpq_class t(at_p, fall);
    t.canonicalize();
    if (t < 0 || t > 1) continue;
    points.push_back(t.get_den() * v[i] + t.get_num() * (v[i + 1] - v[i]));
  }
  return points;
}

std::vector<kernels::Sign> naive_crossings(const Case& e, const Case& f) {
  std::vector<kernels::Sign> signs;
  const Vector w = cross(e.arc().circle.exact(), f.arc().circle.exact());
  if (is_zero(w)) return signs;
  for (const kernels::Sign sign : {kernels::Sign::negative, kernels::Sign::positive}) {
    const Vector there = sign == kernels::Sign::negative ? -w : w;
    for (const Vector& u : meets(e, f.arc().circle.exact())) {
      if (!same_direction(u, there) || !in_interior(u, e) || !in_interior(u, f)) continue;
      signs.push_back(sign);
      break;
    }
  }
  return signs;
}

bool naive_touch(const Case& e, const Case& f) {
  if (!is_zero(cross(e.arc().circle.exact(), f.arc().circle.exact()))) {
    const std::vector<Vector> points = meets(e, f.arc().circle.exact());
    return std::any_of(points.begin(), points.end(), [&](const Vector& u) { return on_arc(u, f); });
  }
  // On one great circle: the arcs overlap if a joint of one chain lies on the other.
  const std::vector<Vector> of_e = chain(e), of_f = chain(f);
  return std::any_of(of_e.begin(), of_e.end(), [&](const Vector& u) { return on_arc(u, f); }) ||
         std::any_of(of_f.begin(), of_f.end(), [&](const Vector& u) { return on_arc(u, e); });
}

Case any_arc(Size size) {
  const int rank = *rc::gen::element(1, 2, 2, 3, 3, 3);
  const Vector d = *directions(size), other = *directions(size), c = cross(d, other);
  if (rank == 1) return full_circle(d);
  RC_PRE(!is_zero(c));
  return rank == 2 ? half_circle(d, c) : short_arc(d, other);
}

/// An arc that shares an end, the great circle, or a point up to one unit, with another.
Case related_arc(const Case& e, Size size) {
  const std::vector<Vector> joints = chain(e);
  const Vector joint = *rc::gen::elementOf(joints), d = e.arc().circle.exact(), r = *directions(size);
  const mpz_class s = *integers(size), t = *integers(size);
  const Vector on_circle = s * joints[0] + t * joints[1];
  const Vector from = *rc::gen::element(joint, -joint, on_circle, on_circle + *smallest_steps());
  const Vector to = *rc::gen::element(r, cross(d, from), -cross(d, from), r - from);
  RC_PRE(!is_zero(from));
  RC_PRE(!is_zero(cross(from, to)));
  return *rc::gen::element(short_arc(from, to), half_circle(from, cross(from, to)), full_circle(cross(from, to)),
                           full_circle(d), full_circle(-d));
}

template <class Property>
void for_all_pairs(const Property& property) {
  for (const Size size : {Size::small, Size::word, Size::mixed}) {
    EXPECT_TRUE(holds({.seed = 11, .runs = 400},
                      [&] {
                        const Case e = any_arc(size), f = any_arc(size);
                        RC_LOG() << e << "\n" << f << "\n";
                        property(e, f);
                      }))
        << "independent arcs, " << name(size);
    EXPECT_TRUE(holds({.seed = 11, .runs = 400},
                      [&] {
                        const Case e = any_arc(size), f = related_arc(e, size);
                        RC_LOG() << e << "\n" << f << "\n";
                        property(e, f);
                      }))
        << "related arcs, " << name(size);
  }
}

TEST(StrictCrossings, AreTheCommonPointsOfTheInteriors) {
  int crossing = 0;
  for_all_pairs([&](const Case& e, const Case& f) {
    const std::vector<kernels::Sign> signs =
        strict_crossings(unperturbed().kernel, e.diagram, e.arc(), f.diagram, f.arc());
    RC_ASSERT(signs == naive_crossings(e, f));
    crossing += !signs.empty();
    std::vector<kernels::Sign> opposite =
        strict_crossings(unperturbed().kernel, f.diagram, f.arc(), e.diagram, e.arc());
    for (kernels::Sign& s : opposite) s = -s;
    std::sort(opposite.begin(), opposite.end());
    RC_ASSERT(signs == opposite);
  });
  EXPECT_GT(crossing, 400);
}

/// The same arc as one of -A, which the perturbation moves.
Case as_of_a(const Case& c) {
  Case result{{c.diagram.rank, {}, {c.arc()}}};
  result.diagram.arcs.front().circle = kernels::Direction(c.arc().circle.exact(), kernels::Role::circle_of_a);
  for (const kernels::Direction& n : c.diagram.nodes)
    result.diagram.nodes.emplace_back(n.exact(), kernels::Role::node_of_a);
  return result;
}

TEST(PerturbedCrossings, KeepStrictOnesAndCloseNoGap) {
  int resolved = 0;
  for_all_pairs([&](const Case& e, const Case& f) {
    const Case moved = as_of_a(e);
    const std::vector<kernels::Sign> strict =
        strict_crossings(unperturbed().kernel, e.diagram, e.arc(), f.diagram, f.arc());
    const std::vector<kernels::Sign> all =
        perturbed_crossings(perturbed({}).kernel, moved.diagram, moved.arc(), f.diagram, f.arc());
    RC_ASSERT(std::includes(all.begin(), all.end(), strict.begin(), strict.end()));
    if (!all.empty()) RC_ASSERT(touch(e.diagram, e.arc(), f.diagram, f.arc()));
    const bool full = e.diagram.rank == 1 && f.diagram.rank == 1;
    RC_ASSERT((full ? all.size() == 2 : all.size() <= 1));
    resolved += !full && strict.empty() && !all.empty();
  });
  EXPECT_GT(resolved, 50);
}

TEST(Touch, IsACommonPointOfTheClosedArcs) {
  int touching = 0, apart = 0;
  for_all_pairs([&](const Case& e, const Case& f) {
    const bool touches = touch(e.diagram, e.arc(), f.diagram, f.arc());
    RC_ASSERT(touches == naive_touch(e, f));
    RC_ASSERT(touches == touch(f.diagram, f.arc(), e.diagram, e.arc()));
    if (!strict_crossings(unperturbed().kernel, e.diagram, e.arc(), f.diagram, f.arc()).empty()) RC_ASSERT(touches);
    ++(touches ? touching : apart);
  });
  EXPECT_GT(touching, 400);
  EXPECT_GT(apart, 400);
}

TEST(Contains, AsksForThePointOnTheArc) {
  for (const Size size : {Size::small, Size::word, Size::mixed}) {
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] {
      const Case e = any_arc(size);
      const std::vector<Vector> joints = chain(e);
      Vector u =
          *rc::gen::element(*integers(size) * joints[0] + *integers(size) * joints[1], joints.front(), joints.back());
      if (*rc::gen::arbitrary<bool>()) u = -u;
      RC_PRE(!is_zero(u));
      RC_ASSERT(contains(e.diagram, e.arc(), u) == on_arc(u, e));
    }));
  }
}

TEST(StrictCrossings, OfTwoFullCirclesAreTwo) {
  const Case e = full_circle({1, 0, 0}), f = full_circle({1, 2, 0}), again = full_circle({-3, 0, 0});
  EXPECT_EQ(strict_crossings(unperturbed().kernel, e.diagram, e.arc(), f.diagram, f.arc()),
            (std::vector<kernels::Sign>{kernels::Sign::negative, kernels::Sign::positive}));
  EXPECT_TRUE(strict_crossings(unperturbed().kernel, e.diagram, e.arc(), again.diagram, again.arc()).empty());
  EXPECT_TRUE(touch(e.diagram, e.arc(), again.diagram, again.arc()));
}

TEST(StrictCrossings, DoNotCountAnEndOnTheOtherArc) {
  const Case e = short_arc({1, -1, 0}, {1, 1, 0});
  const auto with = [&](const Case& f) {
    return strict_crossings(unperturbed().kernel, e.diagram, e.arc(), f.diagram, f.arc());
  };
  // e's circle is (0,0,2); those of the arcs through (1,0,0) from below to above are (0,-2,0).
  EXPECT_EQ(with(short_arc({1, 0, -1}, {1, 0, 1})), std::vector<kernels::Sign>{kernels::Sign::positive});
  EXPECT_EQ(with(short_arc({1, 0, 1}, {1, 0, -1})), std::vector<kernels::Sign>{kernels::Sign::negative});
  EXPECT_TRUE(with(short_arc({1, 0, 0}, {1, 0, 1})).empty());
  EXPECT_TRUE(with(short_arc({1, 1, -1}, {1, 1, 1})).empty());
  EXPECT_TRUE(with(short_arc({-1, 0, -1}, {-1, 0, 1})).empty());
  EXPECT_TRUE(with(short_arc({1, 0, 0}, {1, 2, 0})).empty());
  EXPECT_EQ(with(half_circle({0, 0, 1}, {0, 1, 0})), std::vector<kernels::Sign>{kernels::Sign::negative});
  EXPECT_TRUE(with(half_circle({0, 0, 1}, {0, -1, 0})).empty());
}

}  // namespace
}  // namespace fathom::gaussian
