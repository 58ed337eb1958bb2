// SPDX-License-Identifier: GPL-3.0-or-later
// Of patch.hpp: what of a mesh holds a contact.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "fathom/solid.hpp"
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

/// What of a surface may meet a box: the faces whose boxes do, and their edges and vertices.
class Nearby {
 public:
  Nearby(const std::vector<Point>& points, const std::vector<std::vector<std::uint32_t>>& faces, const CornerBox& box)
      : points_(points) {
    for (std::uint32_t i = 0; i < faces.size(); ++i)
      if (!misses(faces[i], box)) add(i, faces[i]);
  }

  [[nodiscard]] std::vector<MeshFeature> at_point(const Point& x) const;
  /// The places s, from 0 to 1, where edges meet the segment of the points p + s (q - p).
  [[nodiscard]] std::vector<mpq_class> meetings(const Point& p, const Point& q) const;
  [[nodiscard]] std::vector<MeshFeature> under_polygon(std::span<const Point> patch) const;

 private:
  // A flat face; or a triangle of one that is not flat.
  struct Polygon {
    std::uint32_t face;
    std::vector<Point> corners;
  };

  [[nodiscard]] bool misses(const std::vector<std::uint32_t>& face, const CornerBox& box) const {
    const auto all = [&](auto is_beyond) {
      return std::ranges::all_of(face, [&](std::uint32_t i) { return is_beyond(points_[i]); });
    };
    return all([&](const Point& p) { return p.x < box.low.x; }) ||
           all([&](const Point& p) { return p.x > box.high.x; }) ||
           all([&](const Point& p) { return p.y < box.low.y; }) ||
           all([&](const Point& p) { return p.y > box.high.y; }) ||
           all([&](const Point& p) { return p.z < box.low.z; }) ||
           all([&](const Point& p) { return p.z > box.high.z; });
  }

  void add(std::uint32_t number, const std::vector<std::uint32_t>& corners) {
    std::vector<Point> face;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      if (low != high) edges_.emplace(low, high);
      corners_.insert(corners[i]);
      face.push_back(points_[corners[i]]);
    }
    std::vector<std::vector<Point>> triangles;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
    const Point sum = triangles.size() > 1 ? area_vector(face) : Point{};
    const bool flat = sum != Point{} && std::ranges::all_of(triangles, [&](const std::vector<Point>& triangle) {
                        return cross(sum, area_vector(triangle)) == Point{};
                      });
    if (flat) polygons_.push_back({number, face});
    else
      for (const std::vector<Point>& triangle : triangles) polygons_.push_back({number, triangle});
  }

  const std::vector<Point>& points_;
  std::set<std::uint32_t> corners_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<Polygon> polygons_;
};

std::vector<MeshFeature> Nearby::at_point(const Point& x) const {
  for (const std::uint32_t i : corners_)
    if (points_[i] == x) return {{FeatureKind::vertex, {i}}};
  std::vector<MeshFeature> found;
  for (const auto& [low, high] : edges_)
    if (is_between(x, points_[low], points_[high])) found.push_back({FeatureKind::edge, {low, high}});
  if (!found.empty()) return found;
  for (const Polygon& face : polygons_) {
    const Point normal = area_vector(face.corners);
    if (normal != Point{} && is_in_plane(x, normal, face.corners[0]) && goes_around(face.corners, normal, x))
      found.push_back({FeatureKind::face, {face.face}});
  }
  sort_once(found);
  return found;
}

std::vector<mpq_class> Nearby::meetings(const Point& p, const Point& q) const {
  std::vector<mpq_class> at{0, 1};
  for (const Polygon& face : polygons_)
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      add_meetings(p, q, face.corners[i], face.corners[(i + 1) % face.corners.size()], at);
  std::erase_if(at, [](const mpq_class& s) { return s < 0 || s > 1; });
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

// Clipping may join the parts of a polygon that is not convex by seams, which have no area.
std::vector<MeshFeature> Nearby::under_polygon(std::span<const Point> patch) const {
  const Point normal = area_vector(patch);
  std::vector<MeshFeature> found;
  for (const Polygon& face : polygons_) {
    if (!is_in_plane(face.corners[0], normal, patch[0])) continue;
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
  for (std::uint32_t i = 0; i < points.size(); ++i) known.insert(i);
  files::for_each_face(faces, points.size(), [&](std::span<const std::uint32_t> given) {
    std::vector<std::uint32_t>& face = faces_.emplace_back();
    for (const std::uint32_t i : given) face.push_back(*known.find(i));
  });
}

std::vector<MeshFeature> MeshSurface::features(std::span<const Point> corners) const {
  const Nearby near(points_, faces_, CornerBox(corners));
  if (corners.size() == 1) return near.at_point(corners[0]);
  if (corners.size() > 2) return near.under_polygon(corners);
  const std::vector<mpq_class> at = near.meetings(corners[0], corners[1]);
  std::vector<MeshFeature> found;  // between these places, all points lie on the same features
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Point x = corners[0] + mpq_class((at[i] + at[i + 1]) / 2) * (corners[1] - corners[0]);
    const std::vector<MeshFeature> there = features(std::span(&x, 1));
    found.insert(found.end(), there.begin(), there.end());
  }
  sort_once(found);
  return found;
}

SolidSurfaces::SolidSurfaces(const Body& a, const Body& b) {
  for (const auto& [body, surface] : {std::pair(&a, &a_), std::pair(&b, &b_)})
    if (body->solid && body->solid->mesh_faces) surface->emplace(body->solid->mesh_points, *body->solid->mesh_faces);
}

std::vector<Point> SolidSurfaces::places(const Patch& patch, RoundedPoint (Patch::*place)(std::size_t) const) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) points.push_back((patch.*place)(k).core);
  return points;
}

}  // namespace fathom::patch
