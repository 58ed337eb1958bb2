// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian diagrams against the definition: over the interior of an arc exactly its edge is extreme, beside it exactly its face's vertex.
// And each mutation of a diagram is refused.
#include "reference/gaussian/gaussian_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
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
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
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
  if (diagram.rank == 1) return cross(arc.circle.exact(), arc.circle.exact().x == 0 ? Vector{1, 0, 0} : Vector{0, 1, 0});
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
      // A little to either side. The step is small against every difference of products, which are integers.
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
       [](GaussianDiagram& d, ArcId i) { return d.arcs[i].circle = kernels::Direction(-d.arcs[i].circle.exact()), true; }},
      {"above and below exchanged", [](GaussianDiagram& d, ArcId i) { return std::swap(d.arcs[i].above, d.arcs[i].below), true; }},
      {"from and to exchanged", [](GaussianDiagram& d, ArcId i) { return std::swap(d.arcs[i].from, d.arcs[i].to), d.rank > 1; }},
      {"above is below", [](GaussianDiagram& d, ArcId i) { return d.arcs[i].above = d.arcs[i].below, true; }},
      {"another arc's circle",
       [](GaussianDiagram& d, ArcId i) {
         const kernels::Direction old = d.arcs[i].circle;
         d.arcs[i].circle = d.arcs[ArcId((i.value + 1) % static_cast<std::uint32_t>(d.arcs.size()))].circle;
         return !same_direction(old.exact(), d.arcs[i].circle.exact());
       }},
      {"another node",
       [](GaussianDiagram& d, ArcId i) {
         return d.rank > 1 && (d.arcs[i].from = NodeId((d.arcs[i].from.value + 1) % static_cast<std::uint32_t>(d.nodes.size())), true);
       }},
      {"a node on a full circle, none on another",
       [](GaussianDiagram& d, ArcId i) { return d.arcs[i].to = d.rank == 1 ? NodeId(0) : NodeId::none(), true; }},
      {"a vertex that is not there", [](GaussianDiagram& d, ArcId i) { return d.arcs[i].above = VertexId(1000000), true; }},
      {"the arc is missing",
       [](GaussianDiagram& d, ArcId i) { return d.arcs.erase(d.arcs.begin() + static_cast<std::ptrdiff_t>(i.value)), true; }},
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
      std::swap(spoiled.nodes[i], spoiled.nodes[NodeId((i.value + 1) % static_cast<std::uint32_t>(diagram.nodes.size()))]);
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

// The diagram of a polytope that is none follows its facets and edges faithfully, and is refused all the same.
TEST(Validate, RefusesTheDiagramOfABrokenPolytope) {
  const auto expect_refused = [](const std::string& what, const polytope::Polytope& broken) {
    for (const Colour colour : both_colours) EXPECT_FALSE(validate(diagram_of(broken, colour), broken, colour).ok()) << what;
  };
  const polytope::Polytope segment = polytope::convex_hull(corners({1, 2, 3, 4, 6, 8})),
                           square = polytope::convex_hull(corners({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0})),
                           cube = polytope::convex_hull(corners({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}));
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

}  // namespace
}  // namespace fathom::gaussian
