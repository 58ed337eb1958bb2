// SPDX-License-Identifier: GPL-3.0-or-later
// Of patch.hpp: what of a mesh holds a contact.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/patch/patch.hpp"

namespace fathom {

std::string_view name(MeshFeature::Kind kind) {
  constexpr std::array<std::string_view, 3> names{"face", "edge", "vertex"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace fathom

namespace fathom::patch {
namespace {

using FeatureKind = MeshFeature::Kind;

auto by_coordinates(const Point& p) { return std::tie(p.x, p.y, p.z); }

/// Twice the area, along the normal: what the fan from the first corner sums to.
Point area_vector(std::span<const Point> corners) {
  Point sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

bool is_in_plane(const Point& x, const Point& normal, const Point& origin) { return dot(normal, x - origin) == 0; }

bool is_between(const Point& x, const Point& p, const Point& q) {
  return cross(q - p, x - p) == Point{} && dot(x - p, x - q) <= 0;
}

/// Whether a point of its plane lies on the boundary of a polygon, or where that goes around it.
bool goes_around(std::span<const Point> polygon, const Point& normal, const Point& x) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (is_between(x, p, q)) return true;
    // Seen along the normal; half-open in a coordinate that is not constant in the plane.
    const int axis = normal.x != 0 || normal.y != 0 ? 2 : 1;
    const auto height = [&](const Point& at) -> const mpq_class& { return axis == 2 ? at.z : at.y; };
    const bool up = height(p) <= height(x) && height(x) < height(q);
    const bool down = height(q) <= height(x) && height(x) < height(p);
    const int side = up || down ? sgn(dot(normal, cross(q - p, x - p))) : 0;
    if (up && side > 0) ++winding;
    if (down && side < 0) --winding;
  }
  return winding != 0;
}

/// Where the line p + s (q - p) meets an edge in a point, or the ends of one that lies in it.
void add_meetings(const Point& p, const Point& q, const Point& u, const Point& v, std::vector<mpq_class>& at) {
  const Point d = q - p, e = v - u, n = cross(d, e);
  if (n == Point{}) {
    if (cross(d, u - p) != Point{}) return;
    for (const Point* end : {&u, &v}) at.emplace_back(dot(*end - p, d) / dot(d, d));
  } else if (dot(n, u - p) == 0) {
    at.emplace_back(dot(cross(u - p, e), n) / dot(n, n));
  }
}

void sort_once(std::vector<MeshFeature>& features) {
  std::ranges::sort(features);
  features.erase(std::unique(features.begin(), features.end()), features.end());
}

}  // namespace

CornerBox::CornerBox(std::span<const Point> points) : low(points[0]), high(points[0]) {
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
}

bool CornerBox::meets(const CornerBox& other) const {
  return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
         low.z <= other.high.z && other.low.z <= high.z;
}

MeshSurface::MeshSurface(const std::vector<Point>& points, const MeshFaces& faces) : points_(points) {
  const auto before = [&](std::uint32_t i, std::uint32_t k) {
    return by_coordinates(points_[i]) < by_coordinates(points_[k]);
  };
  std::set<std::uint32_t, decltype(before)> known(before);
  std::set<std::uint32_t> corners;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < points.size(); ++i) known.insert(i);
  std::uint32_t number = 0;
  files::for_each_face(faces, points.size(), [&](std::span<const std::uint32_t> given) {
    std::vector<std::uint32_t> face;
    for (const std::uint32_t i : given) face.push_back(*known.find(i));
    for (std::size_t i = 0; i < face.size(); ++i)
      if (const auto ends = std::minmax(face[i], face[(i + 1) % face.size()]); ends.first != ends.second)
        edges.insert(ends);
    corners.insert(face.begin(), face.end());
    add_face(number++, face);
  });
  corners_.assign(corners.begin(), corners.end());
  for (const auto& [low, high] : edges)
    edges_.push_back({low, high, CornerBox(std::array{points_[low], points_[high]})});
}

void MeshSurface::add_face(std::uint32_t number, const std::vector<std::uint32_t>& corners) {
  std::vector<Point> face;
  for (const std::uint32_t i : corners) face.push_back(points_[i]);
  std::vector<std::vector<Point>> triangles;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
  const auto add = [&](const std::vector<Point>& polygon) {
    polygons_.push_back({number, polygon, CornerBox(polygon)});
  };
  const Point sum = triangles.size() > 1 ? area_vector(face) : Point{};
  const bool flat = sum != Point{} && std::ranges::all_of(triangles, [&](const std::vector<Point>& triangle) {
                      return cross(sum, area_vector(triangle)) == Point{};
                    });
  if (flat) add(face);
  else std::ranges::for_each(triangles, add);
}

std::vector<MeshFeature> MeshSurface::features(std::span<const Point> corners) const {
  if (corners.size() == 1) return at_point(corners[0]);
  return corners.size() == 2 ? along_segment(corners[0], corners[1]) : under_polygon(corners);
}

std::vector<MeshFeature> MeshSurface::at_point(const Point& x) const {
  for (const std::uint32_t i : corners_)
    if (points_[i] == x) return {{FeatureKind::vertex, {i}}};
  const CornerBox box(std::span(&x, 1));
  std::vector<MeshFeature> found;
  for (const Edge& e : edges_)
    if (e.box.meets(box) && is_between(x, points_[e.low], points_[e.high]))
      found.push_back({FeatureKind::edge, {e.low, e.high}});
  if (!found.empty()) return found;
  for (const Polygon& face : polygons_) {
    if (!face.box.meets(box)) continue;
    const Point normal = area_vector(face.corners);
    if (normal != Point{} && is_in_plane(x, normal, face.corners[0]) && goes_around(face.corners, normal, x))
      found.push_back({FeatureKind::face, {face.face}});
  }
  sort_once(found);
  return found;
}

// Between places where edges meet it, all points of a segment lie on the same features.
std::vector<MeshFeature> MeshSurface::along_segment(const Point& p, const Point& q) const {
  const CornerBox box(std::array{p, q});
  std::vector<mpq_class> at{0, 1};
  for (const Polygon& face : polygons_)
    for (std::size_t i = 0; face.box.meets(box) && i < face.corners.size(); ++i)
      add_meetings(p, q, face.corners[i], face.corners[(i + 1) % face.corners.size()], at);
  std::erase_if(at, [](const mpq_class& s) { return s < 0 || s > 1; });
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end()), at.end());
  std::vector<MeshFeature> found;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const std::vector<MeshFeature> there = at_point(p + mpq_class((at[i] + at[i + 1]) / 2) * (q - p));
    found.insert(found.end(), there.begin(), there.end());
  }
  sort_once(found);
  return found;
}

// Clipping may join the parts of a polygon that is not convex by seams, which have no area.
std::vector<MeshFeature> MeshSurface::under_polygon(std::span<const Point> patch) const {
  const CornerBox box(patch);
  const Point normal = area_vector(patch);
  std::vector<MeshFeature> found;
  for (const Polygon& face : polygons_) {
    if (!face.box.meets(box) || !is_in_plane(face.corners[0], normal, patch[0])) continue;
    if (cross(normal, area_vector(face.corners)) != Point{}) continue;
    std::vector<Point> part = face.corners;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const Point inward = cross(normal, patch[(i + 1) % patch.size()] - patch[i]);
      part = clipped(part, [&](const Point& x) { return dot(inward, x - patch[i]); });
    }
    if (part.size() > 2 && area_vector(part) != Point{}) found.push_back({FeatureKind::face, {face.face}});
  }
  sort_once(found);
  return found;
}

}  // namespace fathom::patch
