// SPDX-License-Identifier: GPL-3.0-or-later
// Depths of solids, tried on the meshes alone: after a shorter translation some point has positive
// winding numbers in both meshes, after a shortest one none of the same candidates has. And laws:
// what the answer is does not depend on how a mesh is written and cut, on the order of the bodies,
// or on where both are.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "fathom/solid.hpp"
#include "fathom/union.hpp"
#include "tests/solids/meshes.hpp"
#include "tests/support/stated_cases.hpp"

namespace fathom::solids {
namespace {

UnionDepth depth_of(const Mesh& a, const Mesh& b) {
  return union_depth(pieces_of(solid_of(a.body())), pieces_of(solid_of(b.body())), {nullptr, false});
}

using Triangle = std::array<Point, 3>;

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (const std::vector<std::uint32_t>& face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      all.push_back({mesh.points[face[0]], mesh.points[face[i]], mesh.points[face[i + 1]]});
  return all;
}

/// Where the segment from p to q meets the triangle, in its interior.
std::optional<Point> meeting(const Point& p, const Point& q, const Triangle& t) {
  const Point n = cross(t[1] - t[0], t[2] - t[0]);
  const mpq_class at_p = dot(n, p - t[0]), at_q = dot(n, q - t[0]);
  if (sgn(at_p) * sgn(at_q) >= 0) return std::nullopt;
  const Point x = p + mpq_class(at_p / (at_p - at_q)) * (q - p);
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(n, cross(t[(i + 1) % 3] - t[i], x - t[i])) <= 0) return std::nullopt;
  return x;
}

/// Corners of both meshes, and where edges of one meet faces of the other: a part in common has one
/// of these, if it has a volume and lies in no part in common of the boundaries.
std::vector<Point> corners_of_common(const Mesh& a, const Mesh& b) {
  std::vector<Point> all = a.points;
  all.insert(all.end(), b.points.begin(), b.points.end());
  const std::vector<Triangle> of_a = triangles_of(a), of_b = triangles_of(b);
  for (const auto& [edges, faces] : {std::pair(&of_a, &of_b), {&of_b, &of_a}})
    for (const Triangle& e : *edges)
      for (std::size_t i = 0; i < 3; ++i)
        for (const Triangle& t : *faces)
          if (const std::optional<Point> x = meeting(e[i], e[(i + 1) % 3], t)) all.push_back(*x);
  return all;
}

/// A point inside both meshes, beside one of the corners; nullopt if none is found. Common parts
/// are about 1 / parts wide.
std::optional<Point> common_point(const Mesh& a, const Mesh& b, long parts, std::size_t& tried) {
  std::mt19937 random(3);
  for (const Point& corner : corners_of_common(a, b))
    for (const long step : {3L, 101L})
      for (int i = 0; i < 10; ++i) {
        const auto beside = [&] { return mpq_class(static_cast<long>(random() % 2003) - 1001, 1013 * step * parts); };
        const mpq_class x = beside(), y = beside(), z = beside();
        const Point candidate = corner + Point{x, y, z};
        ++tried;
        if (winding_number(a, candidate) > 0 && winding_number(b, candidate) > 0) return candidate;
      }
  return std::nullopt;
}

// No plane is along an axis, and no two of different bodies are parallel.
Mesh tilted(Mesh mesh, const Point& t) {
  for (Point& p : mesh.points) p = Point{p.x + p.y / 3, p.y - p.z / 5, p.z + p.x / 7} + t;
  return mesh;
}

std::vector<std::pair<Mesh, Mesh>> overlapping_pairs() {
  const Mesh house = tilted(prism({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 2), {0, 0, 0});
  std::vector<std::pair<Mesh, Mesh>> pairs{{schoenhardt(), moved(house, 1, {-2, mpq_class(-1, 3), 1})},
                                           {tilted(ring_mesh(true), {0, 0, 0}), moved(ring_mesh(false), 1, {-2, 1, 2})},
                                           {house, moved(house, mpq_class(1, 2), {1, 1, mpq_class(1, 2)})}};
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    const Mesh a = cells_mesh(random_cells(random, 5, 3)), b = cells_mesh(random_cells(random, 4, 3));
    pairs.emplace_back(tilted(a, {0, 0, 0}), moved(b, 1, {mpq_class(1, 3), mpq_class(-1, 7), mpq_class(1, 11)}));
  }
  return pairs;
}

TEST(SolidDepth, ShorterTranslationsOverlapOnTheMeshesAlone) {
  std::size_t shorter = 0, at_optimum = 0;
  for (const std::pair<Mesh, Mesh>& pair : overlapping_pairs()) {
    const Mesh &a = pair.first, &b = pair.second;
    const UnionDepth depth = depth_of(a, b);
    ASSERT_EQ(depth.status, Status::penetrating);
    std::mt19937 random(3);
    std::size_t tried = 0;
    const auto expect_overlap = [&](const Point& t, long parts) {
      EXPECT_TRUE(common_point(moved(a, 1, t), b, parts, tried)) << "law: shorter translations overlap";
      ++shorter;
    };
    for (const UnionOptimum& optimum : depth.optima) {
      for (const long parts : {2L, 50L, 1000L})
        expect_overlap(mpq_class(parts - 1, parts) * optimum.translation, parts);
      EXPECT_FALSE(common_point(moved(a, 1, optimum.translation), b, 50, at_optimum)) << "law: optima separate";
    }
    for (int drawn = 0; drawn < 4;) {
      const auto coordinate = [&] { return mpq_class(static_cast<long>(random() % 2001) - 1000, 500); };
      const mpq_class x = coordinate(), y = coordinate(), z = coordinate();
      if (x * x + y * y + z * z >= depth.squared()) continue;
      expect_overlap({x, y, z}, 2);
      ++drawn;
    }
  }
  EXPECT_GE(shorter, 42U);
  EXPECT_GT(at_optimum, 2000U);
}

using Place = std::tuple<mpq_class, mpq_class, mpq_class>;

/// The translations, each changed.
template <class Change>
std::vector<Place> places(const UnionDepth& depth, Change change) {
  std::vector<Place> all;
  for (const UnionOptimum& optimum : depth.optima) {
    const Point t = change(optimum.translation);
    all.emplace_back(t.x, t.y, t.z);
  }
  std::ranges::sort(all);
  return all;
}

/// The same surface by triangles with corners of their own, in another order.
Mesh shuffled(const Mesh& mesh, std::mt19937& random) {
  Mesh result = soup(mesh);
  for (std::size_t i = result.faces.size(); i > 1; --i) std::swap(result.faces[i - 1], result.faces[random() % i]);
  Mesh reordered;
  for (std::vector<std::uint32_t> face : result.faces) {
    for (std::uint32_t& corner : face) {
      reordered.points.push_back(result.points[corner]);
      corner = static_cast<std::uint32_t>(reordered.points.size() - 1);
    }
    reordered.faces.push_back(std::move(face));
  }
  return reordered;
}

TEST(SolidDepth, ObeysTheLawsOfCutSwapAndMotion) {
  const auto same = [](const Point& t) { return t; };
  const auto opposite = [](const Point& t) { return -t; };
  const auto turned_about = [](const Point& t) -> Point {
    return {(3 * t.x - 4 * t.y) / 5, (4 * t.x + 3 * t.y) / 5, t.z};
  };
  std::size_t cut_otherwise = 0;
  for (const auto& [a, b] : overlapping_pairs()) {
    const UnionDepth depth = depth_of(a, b), swapped = depth_of(b, a);
    EXPECT_EQ(places(swapped, opposite), places(depth, same)) << "law: swap";
    const auto placed = [&](Mesh mesh) {
      for (Point& p : mesh.points) p = turned_about(p) + Point{mpq_class(1, 3), -7, 2};
      return mesh;
    };
    EXPECT_EQ(places(depth_of(placed(a), placed(b)), same), places(depth, turned_about)) << "law: motion";
    std::mt19937 random(11);
    const Mesh c = shuffled(a, random);
    const Solid first = solid_of(a.body()), second = solid_of(c.body());
    const PieceCoverage across = coverage(first, pieces_of(second));
    EXPECT_TRUE(across.tiles()) << "law: both tile the same solid";
    cut_otherwise += pieces_obj(first) != pieces_obj(second);
    EXPECT_EQ(places(depth_of(c, b), same), places(depth, same)) << "law: decomposition";
  }
  EXPECT_GT(cut_otherwise, 0U) << "some mesh was cut in two ways";
}

TEST(SolidDepth, ReportsOfMeshesHaveTheStatedAnswers) {
  std::size_t cases = 0;
  for (const auto& [pair, line, answer] : testing::stated_cases({"report_solids.jsonl"})) {
    SCOPED_TRACE(pair.id);
    EXPECT_TRUE(pair.a.solid || pair.b.solid);
    for (const Body* body : {&pair.a, &pair.b})
      if (body->solid) {
        EXPECT_TRUE(coverage(*body->solid, *body->pieces).tiles());
      }
    const UnionDepth depth = union_depth(pieces_of(pair.a), pieces_of(pair.b));
    EXPECT_EQ(name(depth.status), answer["status"]);
    EXPECT_EQ(depth.squared().get_str(), answer["depth_squared"]);
    std::vector<Point> translations;
    for (const UnionOptimum& optimum : depth.optima) translations.push_back(optimum.translation);
    EXPECT_EQ(testing::translation_texts(translations), answer["translations"]);
    ++cases;
  }
  EXPECT_EQ(cases, 8U);
}

}  // namespace
}  // namespace fathom::solids
