// SPDX-License-Identifier: GPL-3.0-or-later
// What cutting costs, counted. That the parts tile is for solid_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fathom/solid.hpp"
#include "reference/solids/arrangement.hpp"
#include "reference/solids/solid_values.hpp"
#include "tests/solids/meshes.hpp"

namespace fathom::solids {
namespace {

/// A sphere of 2 n (n - 1) triangles with corners on a grid, so that every second edge is reflex.
Mesh round_mesh(std::uint32_t n) {
  Mesh mesh;
  const auto add = [&](double polar, double azimuth) {
    const auto grid = [](double x) { return static_cast<int>(std::lround(1e6 * x)); };
    mesh.points.push_back(
        {grid(std::sin(polar) * std::cos(azimuth)), grid(std::sin(polar) * std::sin(azimuth)), grid(std::cos(polar))});
  };
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * n + i % n; };
  const double step = std::numbers::pi / n;
  add(0, 0);
  for (std::uint32_t ring = 1; ring < n; ++ring)
    for (std::uint32_t i = 0; i < n; ++i) add(ring * step, 2 * i * step);
  add(std::numbers::pi, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.faces.push_back({0, at(1, i), at(1, i + 1)});
    mesh.faces.push_back({at(n, 0), at(n - 1, i + 1), at(n - 1, i)});
    for (std::uint32_t ring = 1; ring + 1 < n; ++ring) {
      mesh.faces.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.faces.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return mesh;
}

CutSurface cut(const Mesh& mesh) {
  Arrangement space(21);
  std::vector<PointId> ids;
  for (const Point& p : mesh.points) ids.push_back(space.point({p.x.get_num(), p.y.get_num(), p.z.get_num()}));
  Chunk surface;
  for (const std::vector<std::uint32_t>& face : mesh.faces) {
    ChainFacet facet{*space.plane(ids[face[0]], ids[face[1]], ids[face[2]]), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const PointId p = ids[face[i]], q = ids[face[(i + 1) % 3]];
      const LineId line = space.line(p, q);
      facet.edges.push_back(space.before(line, p, q) ? ChainEdge{line, p, q, 1} : ChainEdge{line, q, p, -1});
    }
    surface.push_back(std::move(facet));
  }
  return convex_parts(space, surface);
}

TEST(ConvexParts, RoundMeshesAreCutInTheirMiddle) {
  const CutSurface coarse = cut(round_mesh(24)), fine = cut(round_mesh(48));
  EXPECT_GT(coarse.parts.size(), 100U) << "the mesh is not what the test is about";
  EXPECT_LT(fine.looked_at, 6 * coarse.looked_at) << "for 4 times the triangles";
}

TEST(ConvexParts, ThoseOfARoundMeshTile) {
  const kernels::Report report = validate(solid_of(round_mesh(16).body()));
  EXPECT_TRUE(report.ok()) << report.faults.front();
}

}  // namespace
}  // namespace fathom::solids
