// SPDX-License-Identifier: GPL-3.0-or-later
// Patches from the definitions, in rationals: the twin that clips, and the laws.
#include <algorithm>
#include <tuple>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"

namespace fathom::patch {
namespace {

/// det(n, q - p, x - p): how far x is to the left of the line from p to q, seen from the tip of n.
mpq_class to_the_left(const Vector& n, const Point& p, const Point& q, const Point& x) {
  return dot(n, cross(q - p, x - p));
}

bool less(const Point& p, const Point& q) {
  if (const int x = cmp(p.x, q.x)) return x < 0;
  if (const int y = cmp(p.y, q.y)) return y < 0;
  return cmp(p.z, q.z) < 0;
}

std::vector<Point> named(const polytope::Points& body, std::span<const std::uint32_t> ids) {
  std::vector<Point> points;
  for (const std::uint32_t i : ids) points.push_back(body[i].exact());
  return points;
}

/// Corners of a polygon, counter-clockwise: from each the one that has all others on its left.
std::vector<Point> wrapped(const Vector& n, std::vector<Point> corners) {
  std::swap(corners.front(), *std::min_element(corners.begin(), corners.end(), less));
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    for (std::size_t i = k + 1; i < corners.size(); ++i)
      if (to_the_left(n, corners[k - 1], corners[k], corners[i]) < 0) std::swap(corners[k], corners[i]);
  return corners;
}

/// Without points that are repeated or between their neighbours, beginning with the least.
std::vector<Point> strict(std::vector<Point> cycle, const Vector& n) {
  cycle.erase(std::unique(cycle.begin(), cycle.end()), cycle.end());
  while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
  for (std::size_t k = 0; k < cycle.size() && cycle.size() > 2;) {
    const Point &p = cycle[(k + cycle.size() - 1) % cycle.size()], &q = cycle[k], &r = cycle[(k + 1) % cycle.size()];
    const bool between = to_the_left(n, p, r, q) == 0 && dot(q - p, q - r) <= 0;
    if (between) (cycle.erase(cycle.begin() + static_cast<std::ptrdiff_t>(k)), k = 0);
    else ++k;
  }
  if (!cycle.empty()) std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end(), less), cycle.end());
  return cycle;
}

/// Whether the point lies inside the face of these corners, relative to its plane or line.
bool inside(const Vector& n, const std::vector<Point>& given, const Point& x) {
  if (given.empty()) return false;
  if (given.size() == 1) return given[0] == x;
  const std::vector<Point> corners = wrapped(n, given);
  if (corners.size() == 2)
    return cross(corners[1] - corners[0], x - corners[0]) == Point{} && dot(x - corners[0], x - corners[1]) < 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (to_the_left(n, corners[i], corners[(i + 1) % corners.size()], x) <= 0) return false;
  return true;
}

}  // namespace

std::vector<Point> shared_naive(const Point& t, const MeetingFaces& faces) {
  const Vector& n = faces.direction;
  std::vector<Point> cycle = wrapped(n, named(faces.a, faces.of_a)), b = wrapped(n, named(faces.b, faces.of_b));
  for (Point& q : b) q = q - t;
  const auto clip = [&](const auto& height) { cycle = clipped(cycle, height); };
  if (b.size() == 1) {
    for (const int sense : {1, -1})
      for (int axis = 0; axis < 3; ++axis)
        clip([&](const Point& x) {
          const Point d = x - b[0];
          return mpq_class(sense * (axis == 0 ? d.x : axis == 1 ? d.y : d.z));
        });
    return strict(std::move(cycle), n);
  }
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Point &p = b[k], &q = b[(k + 1) % b.size()];
    clip([&](const Point& x) { return to_the_left(n, p, q, x); });
    if (b.size() == 2) clip([&](const Point& x) { return dot(q - p, x - p); });
  }
  return strict(std::move(cycle), n);
}

kernels::Report validate(const Patch& patch, const MeetingFaces& faces) {
  kernels::Report report;
  const Vector& n = patch.direction;
  std::vector<Point> corners;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const Point a = patch.a(k).core, b = patch.b(k).core;
    report.expect(inside(n, named(faces.a, patch.corners[k].on_a), a), "a corner is not inside its face of A");
    report.expect(inside(n, named(faces.b, patch.corners[k].on_b), b), "a corner is not inside its face of B");
    report.expect(b - a == patch.translation(), "a corner's points do not differ by the translation");
    corners.push_back(a);
  }
  report.expect(!corners.empty(), "a patch without corners");
  for (const PatchCorner& corner : patch.corners)
    report.expect(std::tie(patch.corners[0].on_a, patch.corners[0].on_b) <= std::tie(corner.on_a, corner.on_b),
                  "the first corner is not the least");
  for (std::size_t k = 0; corners.size() > 2 && k < corners.size(); ++k)
    report.expect(to_the_left(n, corners[k], corners[(k + 1) % corners.size()], corners[(k + 2) % corners.size()]) > 0,
                  "the corners do not turn left");
  return report;
}

}  // namespace fathom::patch
