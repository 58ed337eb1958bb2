// SPDX-License-Identifier: GPL-3.0-or-later
// An oracle that shares nothing with the cutter: bodies made of boxes and tetrahedra by CGAL's Nef
// polyhedra. The mesh of what CGAL made is a solid of the volume that inclusion and exclusion find;
// so are the volumes of its coverage; and its depth is that of parts.
#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "fathom/solid.hpp"
#include "fathom/union.hpp"
#include "tests/solids/meshes.hpp"

namespace fathom::solids {
namespace {

using Kernel = CGAL::Cartesian<CGAL::Gmpq>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Hull = std::vector<Point>;

Nef nef_of(const Hull& hull) {
  const auto number = [](const mpq_class& q) { return CGAL::Gmpq(q.get_mpq_t()); };
  std::vector<Kernel::Point_3> points;
  for (const Point& p : hull) points.emplace_back(number(p.x), number(p.y), number(p.z));
  Polyhedron polyhedron;
  CGAL::convex_hull_3(points.begin(), points.end(), polyhedron);
  return Nef(polyhedron);
}

Nef nef_of(const Pieces& pieces) {
  Nef all(Nef::EMPTY);
  for (const Hull& hull : pieces) all += nef_of(hull);
  return all;
}

/// Its boundary, by the cycles of its facets: a facet with holes is a fan of all of them.
Mesh mesh_of(const Nef& nef) {
  Mesh mesh;
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark()) continue;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      Nef::SHalfedge_const_handle e = cycle;
      Nef::SHalfedge_around_facet_const_circulator step(e), end(step);
      std::vector<std::uint32_t> face;
      CGAL_For_all(step, end) {
        const Kernel::Point_3& p = step->source()->center_vertex()->point();
        face.push_back(static_cast<std::uint32_t>(mesh.points.size()));
        mesh.points.push_back({mpq_class(p.x().mpq()), mpq_class(p.y().mpq()), mpq_class(p.z().mpq())});
      }
      mesh.faces.push_back(std::move(face));
    }
  }
  return mesh;
}

/// The volume of what all of the hulls have in common: of the hull of its vertices, by tetrahedra
/// from one of them.
mpq_class common_volume(const Pieces& hulls) {
  Nef common = nef_of(hulls[0]);
  for (std::size_t i = 1; i < hulls.size(); ++i) common = (common * nef_of(hulls[i])).regularization();
  if (common.is_empty()) return 0;
  std::vector<Kernel::Point_3> points;
  for (auto v = common.vertices_begin(); v != common.vertices_end(); ++v) points.push_back(v->point());
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  CGAL::Gmpq sum = 0;
  for (auto f = hull.facets_begin(); f != hull.facets_end(); ++f) {
    auto h = f->halfedge();
    const Kernel::Point_3 first = h->vertex()->point();
    for (h = h->next(); h->next() != f->halfedge(); h = h->next())
      sum += CGAL::volume(points[0], first, h->vertex()->point(), h->next()->vertex()->point());
  }
  return abs(mpq_class(sum.mpq()));
}

/// The volume of what lies in all of `in` and in one of `hulls`, by inclusion and exclusion.
mpq_class union_volume(const Pieces& hulls, const Pieces& in = {}) {
  mpq_class sum;
  for (unsigned chosen = 1; chosen < 1U << hulls.size(); ++chosen) {
    Pieces all = in;
    int sign = -1;
    for (std::size_t i = 0; i < hulls.size(); ++i)
      if ((chosen >> i & 1U) != 0) all.push_back(hulls[i]), sign = -sign;
    sum += sign * common_volume(all);
  }
  return sum;
}

Hull random_hull(std::mt19937& random) {
  const auto coordinate = [&](unsigned size) { return mpq_class(static_cast<unsigned long>(random() % size)); };
  if (random() % 2 == 0) {
    const mpq_class x = coordinate(4), y = coordinate(4), z = coordinate(4);
    const mpq_class w = 1 + coordinate(4), d = 1 + coordinate(4), h = 1 + coordinate(4);
    return box_mesh({x, y, z}, {x + w, y + d, z + h}).points;
  }
  for (;;) {
    Hull hull;
    for (int i = 0; i < 4; ++i) {
      const mpq_class x = coordinate(8), y = coordinate(8), z = coordinate(8);
      hull.push_back({x, y, z});
    }
    if (dot(cross(hull[1] - hull[0], hull[2] - hull[0]), hull[3] - hull[0]) != 0) return hull;
  }
}

Pieces random_hulls(std::mt19937& random, std::size_t count) {
  Pieces all;
  while (all.size() < count) all.push_back(random_hull(random));
  return all;
}

TEST(SolidNef, UnionsHaveTheVolumeAndTheDepthOfTheirParts) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Pieces parts = random_hulls(random, 2 + seed % 2), other{random_hull(random)};
    const Nef whole = nef_of(parts);
    const Solid solid = solid_of(mesh_of(whole).body());
    const mpq_class size = union_volume(parts);
    EXPECT_EQ(volume(solid), size);
    mpq_class of_parts;
    for (const Hull& hull : parts) of_parts += common_volume({hull});
    const PieceCoverage found = coverage(solid, parts);
    EXPECT_TRUE(found.same_union());
    EXPECT_EQ(found.overlap, of_parts - size);
    const UnionDepth depth = union_depth(pieces_of(solid), other), by_parts = union_depth(parts, other);
    EXPECT_EQ(depth.status, by_parts.status);
    EXPECT_EQ(depth.squared(), by_parts.squared());
    EXPECT_EQ(depth.optima.size(), by_parts.optima.size());
  }
}

// With cavities, notches and parts that fall apart.
TEST(SolidNef, DifferencesAndTheirCoverage) {
  std::size_t missing = 0, outside = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Hull block = box_mesh({0, 0, 0}, {6, 6, 6}).points;
    const Pieces given = random_hulls(random, 1 + seed % 3), taken = random_hulls(random, 2);
    const Solid solid = solid_of(mesh_of((nef_of(block) - nef_of(taken)).regularization()).body());
    const mpq_class left = common_volume({block}) - union_volume(taken, {block});
    EXPECT_EQ(volume(solid), left);
    Pieces away = taken;
    away.insert(away.end(), given.begin(), given.end());
    const PieceCoverage found = coverage(solid, given);
    const mpq_class uncovered = common_volume({block}) - union_volume(away, {block});
    EXPECT_EQ(found.missing, uncovered);
    EXPECT_EQ(found.outside, union_volume(given) - (left - uncovered));
    missing += found.missing != 0;
    outside += found.outside != 0;
  }
  EXPECT_GT(missing, 8U);
  EXPECT_GT(outside, 8U);
}

// A box without one in its interior, or in its side: six slabs around what was taken, or fewer.
TEST(SolidNef, ABoxLessABoxHasTheDepthOfSlabs) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::array<std::array<int, 2>, 3> taken;
    for (auto& [low, high] : taken)
      low = static_cast<int>(random() % 5), high = low + 1 + static_cast<int>(random() % 4);
    const auto at = [&](int side) { return Point{taken[0][side], taken[1][side], taken[2][side]}; };
    Pieces slabs;
    std::array<std::array<int, 2>, 3> rest{{{0, 7}, {0, 7}, {0, 7}}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<std::array<int, 2>, 3> slab = rest;
        slab[axis][1 - side] = std::min(taken[axis][side], 7);
        if (slab[axis][0] < slab[axis][1])
          slabs.push_back(box_mesh({slab[0][0], slab[1][0], slab[2][0]}, {slab[0][1], slab[1][1], slab[2][1]}).points);
      }
      rest[axis] = {taken[axis][0], std::min(taken[axis][1], 7)};
    }
    const Nef block = nef_of(box_mesh({0, 0, 0}, {7, 7, 7}).points), hole = nef_of(box_mesh(at(0), at(1)).points);
    const Solid solid = solid_of(mesh_of((block - hole).regularization()).body());
    EXPECT_TRUE(coverage(solid, slabs).tiles());
    const Pieces other{random_hull(random)};
    EXPECT_EQ(union_depth(pieces_of(solid), other).squared(), union_depth(slabs, other).squared());
  }
}

}  // namespace
}  // namespace fathom::solids
