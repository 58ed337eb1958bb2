// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes that are not convex, for the tests of solids.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "kernels/vector.hpp"

namespace fathom::solids {

/// A mesh by its polygons.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;

  [[nodiscard]] Body body() const {
    MeshFaces all;
    for (const std::vector<std::uint32_t>& face : faces) {
      all.corners.insert(all.corners.end(), face.begin(), face.end());
      all.ends.push_back(static_cast<std::uint32_t>(all.corners.size()));
    }
    Body result{GivenPoints(points)};
    result.faces = std::make_shared<const MeshFaces>(std::move(all));
    return result;
  }
};

inline Mesh operator+(Mesh a, const Mesh& b) {
  const auto before = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (std::vector<std::uint32_t> face : b.faces) {
    for (std::uint32_t& corner : face) corner += before;
    a.faces.push_back(std::move(face));
  }
  return a;
}

inline Mesh turned(Mesh mesh) {
  for (std::vector<std::uint32_t>& face : mesh.faces) std::ranges::reverse(face);
  return mesh;
}

/// By x' = s x + t for each point.
inline Mesh moved(Mesh mesh, const mpq_class& s, const Point& t) {
  for (Point& p : mesh.points) p = s * p + t;
  return mesh;
}

/// Its faces as fans of triangles, each with corners of its own.
inline Mesh soup(const Mesh& mesh) {
  Mesh result;
  for (const std::vector<std::uint32_t>& face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const auto n = static_cast<std::uint32_t>(result.points.size());
      for (const std::uint32_t corner : {face[0], face[i], face[i + 1]}) result.points.push_back(mesh.points[corner]);
      result.faces.push_back({n, n + 1, n + 2});
    }
  return result;
}

inline Mesh box_mesh(const Point& low, const Point& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  return mesh;
}

/// Over a polygon in the plane z = 0, counter-clockwise from above.
inline Mesh prism(const std::vector<std::pair<int, int>>& polygon, int height) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const int z : {0, height})
    for (const auto& [x, y] : polygon) mesh.points.push_back({x, y, z});
  mesh.faces.resize(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.faces[0].push_back(n - 1 - i);
    mesh.faces[1].push_back(n + i);
    mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return mesh;
}

using Cell = std::array<int, 3>;

/// The surface of a set of unit cubes, a square for each.
inline Mesh cells_mesh(const std::set<Cell>& cells) {
  Mesh mesh;
  std::map<Cell, std::uint32_t> known;
  const auto corner = [&](const Cell& at) {
    const auto [entry, fresh] = known.try_emplace(at, static_cast<std::uint32_t>(mesh.points.size()));
    if (fresh) mesh.points.push_back({at[0], at[1], at[2]});
    return entry->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += 2 * side - 1;
        if (cells.contains(beyond)) continue;
        std::vector<std::uint32_t> face;
        for (const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
          Cell at = cell;
          at[axis] += side;
          at[(axis + 1) % 3] += u;
          at[(axis + 2) % 3] += v;
          face.push_back(corner(at));
        }
        if (side == 0) std::ranges::reverse(face);
        mesh.faces.push_back(std::move(face));
      }
  return mesh;
}

inline std::set<Cell> menger_cells(int level) {
  std::set<Cell> cells{{0, 0, 0}};
  for (; level > 0; --level) {
    std::set<Cell> finer;
    for (const auto& [x, y, z] : cells)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            if ((i == 1) + (j == 1) + (k == 1) < 2) finer.insert({3 * x + i, 3 * y + j, 3 * z + k});
    cells = std::move(finer);
  }
  return cells;
}

/// So many cells of a cube with edges of length `size`.
inline std::set<Cell> random_cells(std::mt19937& random, std::size_t count, unsigned size) {
  std::set<Cell> cells;
  while (cells.size() < count) {
    Cell cell;
    for (int& c : cell) c = static_cast<int>(random() % size);
    cells.insert(cell);
  }
  return cells;
}

/// Schoenhardt's polyhedron: no tetrahedra tile it without a further point.
inline Mesh schoenhardt() {
  return {{{4, 0, 0}, {-2, 3, 0}, {-2, -3, 0}, {3, 2, 4}, {-3, 2, 4}, {0, -4, 4}},
          {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
}

/// A ring with a square section around the z axis; or around the x axis.
inline Mesh ring_mesh(bool upright) {
  std::set<Cell> cells;
  for (int u = 0; u < 5; ++u)
    for (int v = 0; v < 5; ++v)
      if (u == 0 || u == 4 || v == 0 || v == 4) cells.insert(upright ? Cell{0, u, v} : Cell{u, v, 0});
  return cells_mesh(cells);
}

/// How often the surface goes around x, by its crossings with a ray; x lies on no plane of a face.
/// By the definition alone, in rationals.
inline int winding_number(const Mesh& mesh, const Point& x) {
  const Point v{mpq_class(1, 7), mpq_class(1009, 3001), mpq_class(-997, 1999)};  // meets no edge of tests' meshes
  int sum = 0;
  for (const std::vector<std::uint32_t>& face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Point p = mesh.points[face[0]] - x, q = mesh.points[face[i]] - x, r = mesh.points[face[i + 1]] - x;
      const Point n = cross(q - p, r - p);
      const int rise = sgn(dot(n, v));
      if (rise == 0 || rise * sgn(dot(n, p)) <= 0) continue;
      const auto left = [&](const Point& a, const Point& b) { return rise * sgn(dot(v, cross(a, b))) > 0; };
      if (left(p, q) && left(q, r) && left(r, p)) sum += rise;
    }
  return sum;
}

}  // namespace fathom::solids
