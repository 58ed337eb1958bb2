// SPDX-License-Identifier: GPL-3.0-or-later
// Patches from the definitions, in rationals: the twin that clips, and the laws.
#include <algorithm>
#include <tuple>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/patch/local_depth.hpp"
#include "reference/patch/patch.hpp"

namespace fathom::patch {

namespace {

/// det(n, q - p, x - p): how far x is to the left of the line from p to q, seen from the tip of n.
mpq_class to_the_left(const Vector& n, const Point& p, const Point& q, const Point& x) {
  return dot(n, cross(q - p, x - p));
}

std::vector<Point> named(const polytope::Points& body, std::span<const std::uint32_t> ids) {
  std::vector<Point> points;
  for (const std::uint32_t i : ids) points.push_back(body[i].exact());
  return points;
}

/// Corners of a polygon, counter-clockwise: from each the one that has all others on its left.
std::vector<Point> wrapped(const Vector& n, std::vector<Point> corners) {
  std::swap(corners.front(), *std::min_element(corners.begin(), corners.end(), lexicographically_less));
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
  if (!cycle.empty())
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end(), lexicographically_less), cycle.end());
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

// Local depths from the definition: on each line the least and the greatest height of a body are
// those of a triangle of its points, and near x the extremes are where segments cross. As the
// overlap is linear between crossings that are next to each other, so is where it falls below a
// level.

namespace {

/// Coordinates across v, in which lines along v are points.
struct Across {
  Vector v, e, f;

  explicit Across(const Vector& along) : v(along) {
    e = sgn(v.y) != 0 || sgn(v.z) != 0 ? cross(v, Vector{1, 0, 0}) : cross(v, Vector{0, 1, 0});
    f = cross(v, e);
  }
  /// How far x is to the left of the way from p to q.
  [[nodiscard]] mpq_class left(const Point& p, const Point& q, const Point& x) const {
    return dot(e, q - p) * dot(f, x - p) - dot(f, q - p) * dot(e, x - p);
  }
  [[nodiscard]] bool same(const Point& p, const Point& q) const { return dot(e, p - q) == 0 && dot(f, p - q) == 0; }
  /// The share of q on the segment from p to q where it meets the line through x, if it does.
  [[nodiscard]] std::optional<mpq_class> share(const Point& p, const Point& q, const Point& x) const {
    if (left(p, q, x) != 0) return std::nullopt;
    const Vector& axis = dot(e, q - p) != 0 ? e : f;
    const mpq_class whole = dot(axis, q - p);
    if (whole == 0) return same(p, x) ? std::optional<mpq_class>(0) : std::nullopt;
    mpq_class part = dot(axis, x - p) / whole;
    return part >= 0 && part <= 1 ? std::optional(std::move(part)) : std::nullopt;
  }
};

/// The least and the greatest height of the body on the line through x, in multiples of v.
std::optional<std::array<mpq_class, 2>> heights(const Across& plane, std::span<const Point> body, const Point& x) {
  std::optional<std::array<mpq_class, 2>> found;
  const auto meets = [&](const Point& p) {
    mpq_class height = dot(plane.v, p) / dot(plane.v, plane.v);
    if (!found) found = {height, height};
    (*found)[0] = std::min((*found)[0], height);
    (*found)[1] = std::max((*found)[1], height);
  };
  for (std::size_t i = 0; i < body.size(); ++i)
    for (std::size_t j = i; j < body.size(); ++j) {
      if (const auto share = plane.share(body[i], body[j], x)) {
        meets(body[i] + *share * (body[j] - body[i]));
        if (plane.same(body[i], body[j])) meets(body[j]);
      }
      for (std::size_t k = j + 1; k < body.size(); ++k) {
        const mpq_class all = plane.left(body[i], body[j], body[k]);
        if (all == 0) continue;
        const mpq_class of_k = plane.left(body[i], body[j], x) / all, of_i = plane.left(body[j], body[k], x) / all,
                        of_j = 1 - of_i - of_k;
        if (of_i >= 0 && of_j >= 0 && of_k >= 0) meets(of_i * body[i] + of_j * body[j] + of_k * body[k]);
      }
    }
  return found;
}

/// A point of each line where a segment of one set crosses one of the other, and all points.
void add_crossings(const Across& plane, std::span<const Point> p, std::span<const Point> q, std::vector<Point>& lines) {
  lines.insert(lines.end(), p.begin(), p.end());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      for (std::size_t k = 0; k < q.size(); ++k)
        for (std::size_t l = k + 1; l < q.size(); ++l) {
          const mpq_class from = plane.left(q[k], q[l], p[i]), to = plane.left(q[k], q[l], p[j]);
          if (from * to < 0 && plane.left(p[i], p[j], q[k]) * plane.left(p[i], p[j], q[l]) <= 0)
            lines.push_back(p[i] + mpq_class(from / (from - to)) * (p[j] - p[i]));
        }
}

/// Whether the line through p along v passes near x.
bool is_near(const Vector& v, const Point& p, const Point& x, const mpq_class& within) {
  std::optional<mpq_class> from, to;  // in multiples of v
  const Point apart = x - p;
  for (const auto& [along, off] : {std::pair{&v.x, &apart.x}, {&v.y, &apart.y}, {&v.z, &apart.z}}) {
    mpq_class low = *off - within, high = *off + within;
    if (*along == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    low /= *along, high /= *along;
    if (low > high) std::swap(low, high);
    if (!from || low > *from) from = low;
    if (!to || high < *to) to = high;
  }
  return *from <= *to;
}

}  // namespace

std::vector<Point> at_least_naive(const Vector& v, std::span<const Point> a, std::span<const Point> b,
                                  const mpq_class& least) {
  const Across plane(v);
  std::vector<Point> lines, met, found;
  std::vector<mpq_class> factors;
  add_crossings(plane, a, b, lines);
  lines.insert(lines.end(), b.begin(), b.end());
  for (const Point& p : lines) {
    const auto of_a = heights(plane, a, p);
    const auto of_b = of_a ? heights(plane, b, p) : std::nullopt;
    if (of_b) (met.push_back(p), factors.push_back((*of_b)[1] - (*of_a)[0]));
  }
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (factors[i] < least) continue;
    found.push_back(met[i]);
    for (std::size_t j = 0; j < met.size(); ++j)
      if (factors[j] < least) {
        const mpq_class share = (factors[i] - least) / (factors[i] - factors[j]);
        found.push_back(met[i] + share * (met[j] - met[i]));
      }
  }
  return found;
}

std::optional<std::array<mpq_class, 2>> overlaps_naive(const Vector& v, std::span<const Point> a,
                                                       std::span<const Point> b, const Point& x,
                                                       const mpq_class& within) {
  const Across plane(v);
  std::vector<Point> box, lines;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1})
      for (const int k : {-1, 1}) box.push_back({x.x + i * within, x.y + j * within, x.z + k * within});
  add_crossings(plane, a, b, lines);
  add_crossings(plane, b, box, lines);
  add_crossings(plane, box, a, lines);
  std::optional<std::array<mpq_class, 2>> found;
  for (const Point& p : lines) {
    if (!is_near(v, p, x, within)) continue;
    const auto of_a = heights(plane, a, p);
    const auto of_b = of_a ? heights(plane, b, p) : std::nullopt;
    if (!of_b) continue;
    const mpq_class factor = (*of_b)[1] - (*of_a)[0];
    if (!found) found = {factor, factor};
    (*found)[0] = std::min((*found)[0], factor);
    (*found)[1] = std::max((*found)[1], factor);
  }
  return found;
}

}  // namespace fathom::patch
