// SPDX-License-Identifier: GPL-3.0-or-later
// validate must accept hulls and refuse every way to damage one.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {
namespace {

using Vectors = std::vector<Vector>;

Vectors box() {
  Vectors points{{1, 1, 1}};
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 2 : 0, i & 2 ? 2 : 0, i & 4 ? 2 : 0});
  points.push_back({2, 2, 2});
  return points;
}

Vectors square() { return {{0, 0, 1}, {1, 1, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {0, 0, 1}}; }

struct Damage {
  std::string law;  // a part of the fault that must be among those reported
  std::function<void(Polytope&)> inflict;
};

void expect_all_found(const Vectors& points, const std::vector<Damage>& damages) {
  const Polytope sound = convex_hull(points);
  ASSERT_TRUE(validate(sound, points).ok());
  for (const Damage& damage : damages) {
    Polytope polytope = sound;
    damage.inflict(polytope);
    const std::vector<std::string> faults = validate(polytope, points).faults;
    const bool found =
        std::ranges::any_of(faults, [&](const std::string& f) { return f.find(damage.law) != std::string::npos; });
    EXPECT_TRUE(found) << "not found: " << damage.law << "; found: " << (faults.empty() ? "nothing" : faults[0]);
  }
}

TEST(Validate, CountsAndRanges) {
  expect_all_found(box(), {
                              {"rank is not", [](Polytope& p) { p.rank = 4; }},
                              {"rank is not", [](Polytope& p) { p.rank = -1; }},
                              {"a point has", [](Polytope& p) { p.rank = 0; }},
                              {"a segment has", [](Polytope& p) { p.rank = 1; }},
                              {"a polygon has", [](Polytope& p) { p.rank = 2; }},
                              {"V - E + F", [](Polytope& p) { p.edges.pop_back(); }},
                              {"V - E + F",
                               [](Polytope& p) {
                                 p.vertices.push_back({3, 3, 3}), p.input_ids.push_back(1);
                               }},
                              {"V - E + F", [](Polytope& p) { p = Polytope{}, p.rank = 3; }},
                              {"input ids", [](Polytope& p) { p.input_ids.pop_back(); }},
                              {"an edge has an end", [](Polytope& p) { p.edges[3].to = VertexId(8); }},
                              {"an edge has an end", [](Polytope& p) { p.edges[3].to = p.edges[3].from; }},
                              {"refers to a facet", [](Polytope& p) { p.edges[3].left = FacetId(6); }},
                              {"refers to a facet", [](Polytope& p) { p.edges[3].right = FacetId::none(); }},
                              {"corners do not follow", [](Polytope& p) { p.facets[FacetId(2)].begin = 9; }},
                              {"corners do not follow", [](Polytope& p) { p.facets[FacetId(5)].end = 25; }},
                              {"corners do not follow",
                               [](Polytope& p) { p.facets[FacetId(0)].end = 2, p.facets[FacetId(1)].begin = 2; }},
                              {"corners of no facet", [](Polytope& p) { p.facets[FacetId(5)].end = 23; }},
                              {"a corner is no vertex", [](Polytope& p) { p.corners[7] = VertexId(8); }},
                          });
}

TEST(Validate, VerticesAndIds) {
  expect_all_found(
      box(), {
                 {"do not ascend", [](Polytope& p) { std::swap(p.input_ids[VertexId(0)], p.input_ids[VertexId(1)]); }},
                 {"is not the input point", [](Polytope& p) { p.input_ids[VertexId(0)] = 0; }},
                 {"is not the input point", [](Polytope& p) { p.input_ids[VertexId(7)] = 1000; }},
                 {"has a lower index", [](Polytope& p) { p.input_ids[VertexId(7)] = 9; }},
                 {"repeats another vertex",
                  [](Polytope& p) {
                    p.vertices[VertexId(7)] = p.vertices[VertexId(6)],
                    p.input_ids[VertexId(7)] = p.input_ids[VertexId(6)];
                  }},
             });
}

TEST(Validate, Facets) {
  expect_all_found(
      box(), {
                 {"not primitive",
                  [](Polytope& p) {
                    p.facets[FacetId(1)].normal = p.facets[FacetId(1)].normal + p.facets[FacetId(1)].normal;
                  }},
                 {"not primitive",
                  [](Polytope& p) {
                    p.facets[FacetId(1)].normal = {0, 0, 0};
                  }},
                 {"off its plane",
                  [](Polytope& p) {
                    p.facets[FacetId(1)].normal = {3, 5, 7};
                  }},
                 {"strictly convex", [](Polytope& p) { p.facets[FacetId(1)].normal = -p.facets[FacetId(1)].normal; }},
                 {"strictly convex", [](Polytope& p) { std::swap(p.corners[1], p.corners[2]); }},
                 {"strictly convex", [](Polytope& p) { std::reverse(p.corners.begin(), p.corners.begin() + 4); }},
             });
}

TEST(Validate, Edges) {
  expect_all_found(
      box(), {
                 {"not a side", [](Polytope& p) { std::swap(p.edges[2].left, p.edges[2].right); }},
                 {"not a side", [](Polytope& p) { std::swap(p.edges[2].from, p.edges[2].to); }},
                 {"not a side", [](Polytope& p) { p.edges[2].right = FacetId((p.edges[2].right.value + 1) % 6); }},
                 {"repeats an earlier edge", [](Polytope& p) { p.edges[2] = p.edges[3]; }},
                 {"belongs to no edge", [](Polytope& p) { p.edges[2] = p.edges[3]; }},
             });
}

TEST(Validate, Polygons) {
  expect_all_found(
      square(),
      {
          {"has a lower index",
           [](Polytope& p) {
             p.input_ids = {2, 3, 4, 5}, std::rotate(p.vertices.begin(), p.vertices.begin() + 1, p.vertices.end());
           }},
          {"not opposite", [](Polytope& p) { p.facets[FacetId(1)].normal = p.facets[FacetId(0)].normal; }},
          {"not, reversed", [](Polytope& p) { std::reverse(p.corners.begin() + 4, p.corners.end()); }},
          {"strictly convex", [](Polytope& p) { std::swap(p.corners[0], p.corners[1]); }},
          {"with facet 0 to its left", [](Polytope& p) { std::swap(p.edges[1].left, p.edges[1].right); }},
          {"with facet 0 to its left", [](Polytope& p) { std::swap(p.edges[1].from, p.edges[1].to); }},
          {"occurs twice", [](Polytope& p) { p.edges[1] = p.edges[2]; }},
          {"differ in size", [](Polytope& p) { p.facets[FacetId(0)].end = p.facets[FacetId(1)].begin = 3; }},
      });
}

TEST(Validate, InputPointsOutside) {
  const auto faults_after = [](Vectors points, const Vector& extra, bool thorough) {
    const Polytope polytope = convex_hull(points);
    points.push_back(extra);
    return validate(polytope, points, thorough).faults.size();
  };
  EXPECT_EQ(faults_after({{0, 0, 0}}, {0, 0, 1}, false), 1u);
  EXPECT_EQ(faults_after({{0, 0, 0}, {2, 2, 2}}, {3, 3, 3}, false), 1u);
  EXPECT_EQ(faults_after({{0, 0, 0}, {2, 2, 2}}, {1, 1, 2}, false), 1u);
  EXPECT_EQ(faults_after({{0, 0, 0}, {2, 2, 2}}, {1, 1, 1}, true), 0u);
  EXPECT_EQ(faults_after(square(), {1, 1, 2}, false), 1u);
  EXPECT_EQ(faults_after(square(), {3, 1, 1}, true), 1u);
  EXPECT_EQ(faults_after(square(), {1, 2, 1}, true), 0u);
  EXPECT_EQ(faults_after(box(), {3, 1, 1}, true), 1u);
  EXPECT_EQ(faults_after(box(), {1, 2, 1}, true), 0u);
}

/// The polytope with other points in place of its vertices and normals that suit them.
Polytope with_vertices(Polytope p, const Vectors& points) {
  p.vertices.assign(points.begin(), points.end());
  for (Facet& f : p.facets) {
    const auto corner = [&](int i) { return p.vertices[p.corners[f.begin + i]]; };
    f.normal = primitive(cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  return p;
}

/// An icosahedron, and with the conjugate golden ratio the great icosahedron: a closed surface of
/// triangles, V - E + F = 2, convex at every edge, and still no polytope. Its vertices are
/// five-pointed stars.
TEST(Validate, AStarIsNoCone) {
  Vectors convex, star;
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1}) {
      convex.insert(convex.end(), {{0, s * 987, t * 1597}, {t * 1597, 0, s * 987}, {s * 987, t * 1597, 0}});
      star.insert(star.end(), {{0, s * 1597, t * -987}, {t * -987, 0, s * 1597}, {s * 1597, t * -987, 0}});
    }
  }
  const Polytope p = convex_hull(convex);
  EXPECT_TRUE(validate(with_vertices(p, convex), convex).ok());
  const std::vector<std::string> faults = validate(with_vertices(p, star), star, false).faults;
  EXPECT_EQ(faults.size(), 12u);
  for (const std::string& fault : faults)
    EXPECT_NE(fault.find("is not the apex of a convex cone"), std::string::npos) << fault;
}

/// A polygon of rank 2 on these corners, in this order.
Polytope polygon(const Vectors& corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  Polytope p;
  p.rank = 2;
  p.vertices.assign(corners.begin(), corners.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    p.input_ids.push_back(i);
    p.corners.emplace_back(i);
    p.edges.push_back({VertexId(i), VertexId((i + 1) % n), FacetId(0), FacetId(1)});
  }
  p.corners.emplace_back(0);
  for (std::uint32_t i = n; i-- > 1;) p.corners.emplace_back(i);
  p.facets = {{{0, 0, 1}, 0, n}, {{0, 0, -1}, n, 2 * n}};
  return p;
}

/// The double pyramid over a cycle of corners with z = 0; each apex finds its triangles in an order
/// that ends with `last`.
Polytope double_pyramid(const Vectors& corners, std::uint32_t last) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  Polytope p;
  p.rank = 3;
  p.vertices.assign(corners.begin(), corners.end());
  p.vertices.insert(p.vertices.end(), {{0, 0, 5}, {0, 0, -5}});
  for (std::uint32_t i = 0; i < n + 2; ++i) p.input_ids.push_back(i);
  const auto add_facet = [&](VertexId u, VertexId v, VertexId w) {
    const FacetId added(static_cast<std::uint32_t>(p.facets.size()));
    const auto begin = static_cast<std::uint32_t>(p.corners.size());
    p.corners.insert(p.corners.end(), {u, v, w});
    p.facets.push_back(
        {primitive(cross(p.vertices[v] - p.vertices[u], p.vertices[w] - p.vertices[u])), begin, begin + 3});
    return added;
  };
  const auto corner = [&](std::uint32_t i) { return VertexId(i % n); };
  const VertexId top(n), bottom(n + 1);
  std::vector<FacetId> upper(n), lower(n);
  for (std::uint32_t step = 1; step <= n; ++step) {
    const std::uint32_t i = (last + step) % n;
    upper[i] = add_facet(top, corner(i), corner(i + 1));
    lower[i] = add_facet(bottom, corner(i + 1), corner(i));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t before = (i + n - 1) % n;
    p.edges.insert(p.edges.end(), {{corner(i), corner(i + 1), upper[i], lower[i]},
                                   {top, corner(i), upper[i], upper[before]},
                                   {bottom, corner(i), lower[before], lower[i]}});
  }
  return p;
}

/// Winds twice around the axis and turns left throughout. Seen from the first corner, the others
/// turn left throughout, too; of the fifth side all corners lie to the left.
Vectors double_loop() {
  return {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0}};
}

TEST(Validate, AFacetThatWindsTwice) {
  Vectors corners = double_loop();
  for (int start = 0; start < 8; ++start) {
    const std::vector<std::string> faults = validate(polygon(corners), corners, false).faults;
    ASSERT_EQ(faults.size(), 2u);
    for (const std::string& fault : faults)
      EXPECT_NE(fault.find("is not a strictly convex"), std::string::npos) << fault;
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

TEST(Validate, ADentedFacet) {
  Vectors corners{{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {4, 4, 0}, {0, 4, 0}};
  for (int start = 0; start < 5; ++start) {
    EXPECT_EQ(validate(polygon(corners), corners, false).faults.size(), 2u);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  corners[2] = {5, 1, 0};
  EXPECT_TRUE(validate(polygon(corners), corners).ok());
}

/// V - E + F = 2, and convex at every edge.
TEST(Validate, AnApexThatWindsTwice) {
  for (std::uint32_t last = 0; last < 8; ++last) {
    const Polytope p = double_pyramid(double_loop(), last);
    EXPECT_EQ(validate(p, p.vertices, false).faults,
              (std::vector<std::string>{"vertex 8 is not the apex of a convex cone",
                                        "vertex 9 is not the apex of a convex cone"}));
  }
  const Polytope p = double_pyramid({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, 0);
  EXPECT_TRUE(validate(p, p.vertices).ok());
}

/// Two double pyramids, one inside the other, that share their apexes: V - E + F = 2, and locally
/// each is convex.
TEST(Validate, TwoFansAtOneVertex) {
  Vectors points{{0, 0, 9}, {0, 0, -9}};
  const auto add_pyramid = [&](int size) {
    points.insert(points.end(), {{size, 0, 0}, {-size, size, 0}, {-size, -size, 0}});
  };
  add_pyramid(1);
  const Polytope inner = convex_hull(points);
  add_pyramid(2);
  Polytope both = convex_hull(points);  // misses vertices 2 to 4
  ASSERT_EQ(both.vertices.size(), 5u);
  const auto outer_vertex = [](VertexId& v) { v.value += v.value < 2 ? 0 : 3; };
  for (VertexId& v : both.corners) outer_vertex(v);
  for (Edge& e : both.edges) outer_vertex(e.from), outer_vertex(e.to);
  both.vertices.assign(points.begin(), points.end());
  both.input_ids = {0, 1, 2, 3, 4, 5, 6, 7};
  for (const Facet& f : inner.facets) both.facets.push_back({f.normal, f.begin + 18, f.end + 18});
  for (const Edge& e : inner.edges)
    both.edges.push_back({e.from, e.to, FacetId(e.left.value + 6), FacetId(e.right.value + 6)});
  both.corners.insert(both.corners.end(), inner.corners.begin(), inner.corners.end());

  EXPECT_TRUE(validate(inner, {points.data(), 5}).ok());
  EXPECT_EQ(validate(both, points, false).faults,
            (std::vector<std::string>{"vertex 0 has more than one fan of facets",
                                      "vertex 1 has more than one fan of facets"}));
}

/// A flat edge and a reflex one: a pyramid's apex pressed into, and through, its base's neighbour.
TEST(Validate, FlatAndReflexEdges) {
  const Vectors base{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 2, 2}};
  const Polytope p = convex_hull(base);
  ASSERT_EQ(p.facets.size(), 6u);
  for (const Vector& apex : {Vector{1, 1, 2}, Vector{1, 1, 1}}) {
    Vectors points = base;
    points[4] = apex;
    const std::vector<std::string> faults = validate(with_vertices(p, points), points, false).faults;
    const bool found = std::ranges::any_of(
        faults, [](const std::string& f) { return f.find("is flat or reflex") != std::string::npos; });
    EXPECT_TRUE(found);
  }
}

}  // namespace
}  // namespace fathom::polytope
