// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of what two convex polygons in one plane share are corners of one that lie in the
// other, and crossings of their edges: all of this is told by on which side of which edge each
// given corner is.
#include "reference/patch/patch.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polygon.hpp"

namespace fathom::patch {
namespace {

// ---- faces on a lattice ----

/// Points of both bodies on one lattice.
struct PlacedCorners {
  std::vector<Vector> a, b;
  Point origin;
  mpz_class denominator = 1;
};

std::vector<GivenPoint> chosen(const polytope::Points& body, std::span<const std::uint32_t> ids) {
  std::vector<GivenPoint> points;
  points.reserve(ids.size());
  for (const std::uint32_t i : ids) points.push_back(body[i]);
  return points;
}

/// Points in binary64 of similar sizes need no rationals.
std::optional<PlacedCorners> placed_by_words(const std::vector<GivenPoint>& a, const std::vector<GivenPoint>& b) {
  std::vector<double> numbers;
  numbers.reserve(3 * (a.size() + b.size()));
  for (const auto* points : {&a, &b})
    for (const GivenPoint& p : *points) {
      const auto* const given = std::get_if<std::array<double, 3>>(&p.coordinates);
      if (given == nullptr) return std::nullopt;
      numbers.insert(numbers.end(), given->begin(), given->end());
    }
  const std::optional<polytope::AlignedNumbers> aligned = polytope::aligned(numbers);
  if (!aligned) return std::nullopt;
  const long exponent = aligned->exponent;
  PlacedCorners placed;
  if (exponent < 0) placed.denominator <<= static_cast<mp_bitcnt_t>(-exponent);
  const auto coordinate = [&](std::size_t k) {
    mpz_class c(aligned->integers[k]);
    if (exponent > 0) c <<= static_cast<mp_bitcnt_t>(exponent);
    return c;
  };
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    (k < 3 * a.size() ? placed.a : placed.b).push_back({coordinate(k), coordinate(k + 1), coordinate(k + 2)});
  return placed;
}

PlacedCorners place_corners(const std::vector<GivenPoint>& a, const std::vector<GivenPoint>& b) {
  if (std::optional<PlacedCorners> placed = placed_by_words(a, b)) return std::move(*placed);
  const auto exact = [](const std::vector<GivenPoint>& points) {
    std::vector<Point> result;
    for (const GivenPoint& p : points) result.push_back(p.exact());
    return result;
  };
  const polytope::PlacedPair pair = polytope::place(exact(a), exact(b));
  return {pair.a.points(), pair.b.points(), pair.origin, pair.denominator};
}

/// In the order of Corners, with the corners' ids.
Corners in_order(std::vector<Vector> points, std::span<const std::uint32_t> ids, const Vector& n) {
  std::vector<std::uint32_t> all(points.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  Corners corners;
  for (const std::uint32_t i : polytope::polygon_corners(points, std::move(all), n)) {
    corners.points.push_back(points[i]);
    corners.ids.push_back(ids[i]);
  }
  return corners;
}

MeetingFaces meeting(const Vector& n, PlacedCorners placed, std::span<const std::uint32_t> of_a,
                     std::span<const std::uint32_t> of_b) {
  return {n,
          in_order(std::move(placed.a), of_a, n),
          in_order(std::move(placed.b), of_b, n),
          std::move(placed.origin),
          std::move(placed.denominator),
          1,
          {}};
}

// ---- seen along the direction ----

/// A point of the plane; counter-clockwise is as seen from the tip of the direction.
struct Seen {
  mpz_class x, y;
};

/// Drops a coordinate along which the plane is not.
Seen seen(const Vector& p, const Vector& n) {
  const bool along_z = n.z != 0, along_x = !along_z && n.x != 0;
  const int side = along_z ? sgn(n.z) : along_x ? sgn(n.x) : sgn(n.y);
  Seen s = along_z ? Seen{p.x, p.y} : along_x ? Seen{p.y, p.z} : Seen{p.z, p.x};
  if (side < 0) std::swap(s.x, s.y);
  return s;
}

/// Inside are the points with x * px + y * py >= level.
struct HalfPlane {
  mpz_class x, y, level;
  [[nodiscard]] mpz_class beyond(const Seen& p) const { return x * p.x + y * p.y - level; }
};

HalfPlane through(const Seen& p, mpz_class x, mpz_class y) {
  mpz_class level = x * p.x + y * p.y;
  return {std::move(x), std::move(y), std::move(level)};
}

/// A polygon in the plane with the half-planes that it is the intersection of: side i is left of
/// the edge from corner i to the next. Of a segment, sides 0 and 1 are left and right of it, and
/// sides 2 and 3 end at corners 0 and 1; of a point there are four.
struct Polygon {
  std::vector<Seen> corners;
  std::vector<HalfPlane> sides;

  [[nodiscard]] std::size_t size() const { return corners.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  /// How many edges there are to be crossed.
  [[nodiscard]] std::size_t edges() const { return size() > 2 ? size() : size() - 1; }
};

Polygon polygon(std::vector<Seen> corners) {
  Polygon result{std::move(corners), {}};
  const std::vector<Seen>& c = result.corners;
  if (c.size() == 1) {
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) result.sides.push_back(through(c[0], x, y));
    return result;
  }
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Seen& q = c[result.next(i)];
    result.sides.push_back(through(c[i], c[i].y - q.y, q.x - c[i].x));
  }
  if (c.size() == 2) {
    result.sides.push_back(through(c[0], c[1].x - c[0].x, c[1].y - c[0].y));
    result.sides.push_back(through(c[1], c[0].x - c[1].x, c[0].y - c[1].y));
  }
  return result;
}

/// How far the corners of one polygon are beyond the sides of another one: [corner][side].
using Beyond = std::vector<std::vector<mpz_class>>;

Beyond all_beyond(const Polygon& of, const Polygon& sides) {
  Beyond result(of.size());
  for (std::size_t i = 0; i < of.size(); ++i)
    for (const HalfPlane& side : sides.sides) result[i].push_back(side.beyond(of.corners[i]));
  return result;
}

/// Where a point of a polygon is on its boundary: at a corner, inside the edge after it, or not.
struct OnBoundary {
  enum class Where : std::uint8_t { corner, edge, nowhere } where = Where::nowhere;
  std::size_t index = 0;

  [[nodiscard]] bool nowhere() const { return where == Where::nowhere; }
  [[nodiscard]] bool at_corner() const { return where == Where::corner; }
};
using Where = OnBoundary::Where;

/// Of a point that is `beyond` the sides of the polygon; nullopt if it is outside.
std::optional<OnBoundary> place_in(const Polygon& polygon, const std::vector<mpz_class>& beyond) {
  std::vector<std::size_t> on;
  for (std::size_t s = 0; s < beyond.size(); ++s) {
    if (beyond[s] < 0) return std::nullopt;
    if (beyond[s] == 0) on.push_back(s);
  }
  if (polygon.size() == 1) return OnBoundary{Where::corner, 0};
  if (polygon.size() == 2) return on.size() > 2 ? OnBoundary{Where::corner, on[2] - 2} : OnBoundary{Where::edge, 0};
  if (on.empty()) return OnBoundary{};
  if (on.size() == 1) return OnBoundary{Where::edge, on[0]};
  return OnBoundary{Where::corner, polygon.next(on[0]) == on[1] ? on[1] : on[0]};
}

/// A corner of what both share: where it is on either.
struct Shared {
  OnBoundary a, b;
};

/// All corners, in no order: those of A in B, those of B in A that are not of A as well, and
/// crossings.
std::vector<Shared> shared_corners(const Polygon& a, const Polygon& b, const Beyond& a_beyond, const Beyond& b_beyond) {
  std::vector<Shared> found;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (const auto on_b = place_in(b, a_beyond[i])) found.push_back({{Where::corner, i}, *on_b});
  for (std::size_t j = 0; j < b.size(); ++j)
    if (const auto on_a = place_in(a, b_beyond[j]); on_a && !on_a->at_corner())
      found.push_back({*on_a, {Where::corner, j}});
  const auto apart = [](const mpz_class& p, const mpz_class& q) { return sgn(p) * sgn(q) < 0; };
  for (std::size_t i = 0; i < a.edges(); ++i)
    for (std::size_t j = 0; j < b.edges(); ++j)
      if (apart(a_beyond[i][j], a_beyond[a.next(i)][j]) && apart(b_beyond[j][i], b_beyond[b.next(j)][i]))
        found.push_back({{Where::edge, i}, {Where::edge, j}});
  return found;
}

/// Whether A's edge that holds the corner comes from outside of B there.
bool enters(const Shared& corner, const Polygon& b, const Beyond& a_beyond) {
  const std::vector<mpz_class>& from = a_beyond[corner.a.index];
  return from[corner.b.index] < 0 || (corner.b.at_corner() && from[b.before(corner.b.index)] < 0);
}

/// Three or more corners around the polygon that both share: along A's boundary, and between two of
/// these along B's where it is inside A.
std::vector<Shared> around(std::vector<Shared> corners, const Polygon& b, const Beyond& a_beyond) {
  const auto inside =
      std::stable_partition(corners.begin(), corners.end(), [](const Shared& corner) { return !corner.a.nowhere(); });
  std::sort(corners.begin(), inside, [&](const Shared& p, const Shared& q) {
    if (p.a.index != q.a.index) return p.a.index < q.a.index;
    if (p.a.where != q.a.where) return p.a.at_corner();
    return enters(p, b, a_beyond) && !enters(q, b, a_beyond);
  });
  if (inside == corners.begin()) return corners;  // all of B, in its order
  std::vector<bool> inner(b.size(), false);
  for (auto corner = inside; corner != corners.end(); ++corner) inner[corner->b.index] = true;
  std::vector<Shared> cycle;
  for (auto corner = corners.begin(); corner != inside; ++corner) {
    cycle.push_back(*corner);
    if (corner->b.nowhere()) continue;
    for (std::size_t j = b.next(corner->b.index); inner[j]; j = b.next(j)) cycle.push_back({{}, {Where::corner, j}});
  }
  return cycle;
}

/// The ids of the least face that holds a point, ascending.
std::vector<std::uint32_t> least_face(const Corners& face, const OnBoundary& at) {
  if (at.at_corner()) return {face.ids[at.index]};
  std::vector<std::uint32_t> ids = face.ids;
  if (at.where == Where::edge) ids = {face.ids[at.index], face.ids[at.index + 1 == ids.size() ? 0 : at.index + 1]};
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// The patch's corner: its place on A from that of A's corner, of B's, or of the edge that crosses.
PatchCorner corner_of(const MeetingFaces& faces, const Shared& at, const Beyond& a_beyond) {
  PatchCorner corner{least_face(faces.a, at.a), least_face(faces.b, at.b), {}, 1};
  if (at.a.at_corner()) {
    corner.numerator = faces.a.points[at.a.index];
  } else if (at.b.at_corner()) {
    corner.numerator = faces.divisor * faces.b.points[at.b.index] - faces.shift;
    corner.divisor = faces.divisor;
  } else {
    const std::size_t next = at.a.index + 1 == faces.a.points.size() ? 0 : at.a.index + 1;
    const mpz_class from = abs(a_beyond[at.a.index][at.b.index]), to = abs(a_beyond[next][at.b.index]);
    corner.numerator = to * faces.a.points[at.a.index] + from * faces.a.points[next];
    corner.divisor = from + to;
  }
  return corner;
}

bool lexicographically_before(const PatchCorner& p, const PatchCorner& q) {
  for (int axis = 0; axis < 3; ++axis) {
    const mpz_class left = kernels::coordinate(p.numerator, axis) * q.divisor,
                    right = kernels::coordinate(q.numerator, axis) * p.divisor;
    if (const int order = cmp(left, right)) return order < 0;
  }
  return false;
}

/// The patch of these corners, which begins with the least of them.
Patch patch_with(std::vector<PatchCorner> corners, const MeetingFaces& faces) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), lexicographically_before),
              corners.end());
  Patch patch;
  patch.direction = faces.direction;
  patch.corners = std::move(corners);
  patch.origin = faces.origin;
  patch.denominator = faces.denominator;
  patch.shift = faces.shift;
  patch.shift_divisor = faces.divisor;
  return patch;
}

}  // namespace

MeetingFaces faces_along(const Vector& n, const polytope::Points& a, std::span<const std::uint32_t> of_a,
                         const polytope::Points& b, std::span<const std::uint32_t> of_b) {
  MeetingFaces faces = meeting(n, place_corners(chosen(a, of_a), chosen(b, of_b)), of_a, of_b);
  const mpz_class height = dot(n, faces.b.points.front() - faces.a.points.front()), square = dot(n, n),
                  shared = gcd(height, square);
  faces.divisor = square / shared;
  faces.shift = mpz_class(height / shared) * n;
  return faces;
}

MeetingFaces faces_after(const Point& t, const Vector& n, const polytope::Points& a,
                         std::span<const std::uint32_t> of_a, const polytope::Points& b,
                         std::span<const std::uint32_t> of_b) {
  MeetingFaces faces = meeting(n, place_corners(chosen(a, of_a), chosen(b, of_b)), of_a, of_b);
  const Point moved = mpq_class(faces.denominator) * t;
  faces.divisor = lcm(lcm(moved.x.get_den(), moved.y.get_den()), moved.z.get_den());
  const auto scaled = [&](const mpq_class& c) { return mpz_class(c.get_num() * (faces.divisor / c.get_den())); };
  faces.shift = {scaled(moved.x), scaled(moved.y), scaled(moved.z)};
  return faces;
}

Patch shared(const MeetingFaces& faces) {
  std::vector<Seen> seen_a, seen_b;
  for (const Vector& p : faces.a.points) seen_a.push_back(seen(faces.divisor * p + faces.shift, faces.direction));
  for (const Vector& p : faces.b.points) seen_b.push_back(seen(faces.divisor * p, faces.direction));
  const Polygon a = polygon(std::move(seen_a)), b = polygon(std::move(seen_b));
  const Beyond a_beyond = all_beyond(a, b), b_beyond = all_beyond(b, a);
  std::vector<Shared> found = shared_corners(a, b, a_beyond, b_beyond);
  if (found.empty()) throw std::logic_error("the faces in an optimal direction do not meet");
  if (found.size() > 2) found = around(std::move(found), b, a_beyond);
  std::vector<PatchCorner> corners;
  corners.reserve(found.size());
  for (const Shared& at : found) corners.push_back(corner_of(faces, at, a_beyond));
  return patch_with(std::move(corners), faces);
}

Patch on_plane(const Vector& n, const polytope::Points& body, std::span<const std::uint32_t> face,
               const mpq_class& support, bool half_space_is_a) {
  const mpq_class share = support / dot(n, n);
  const MeetingFaces faces = faces_after(share * n, n, body, face, body, face);  // both are the body's
  const Corners& own = faces.a;
  std::vector<PatchCorner> corners;
  for (std::size_t k = 0; k < own.ids.size(); ++k) {
    PatchCorner corner{{}, {}, own.points[k], 1};
    if (half_space_is_a) {
      corner.numerator = faces.divisor * own.points[k] - faces.shift;
      corner.divisor = faces.divisor;
    }
    (half_space_is_a ? corner.on_b : corner.on_a) = {own.ids[k]};
    corners.push_back(std::move(corner));
  }
  return patch_with(std::move(corners), faces);
}

// ---- from the definitions ----

namespace {

Point position(const MeetingFaces& faces, const Vector& numerator, const mpz_class& divisor) {
  const mpz_class below = faces.denominator * divisor;
  return faces.origin + Point{kernels::ratio(numerator.x, below), kernels::ratio(numerator.y, below),
                              kernels::ratio(numerator.z, below)};
}

/// det(n, q - p, x - p): how far x is to the left of the line from p to q, seen from the tip of n.
mpq_class to_the_left(const Vector& n, const Point& p, const Point& q, const Point& x) {
  return dot(n, cross(q - p, x - p));
}

/// The corners of a face, moved by t.
std::vector<Point> cycle_of(const MeetingFaces& faces, const Corners& face, const Point& t) {
  std::vector<Point> cycle;
  for (const Vector& p : face.points) cycle.push_back(position(faces, p, 1) + t);
  return cycle;
}

/// The part of a convex polygon, segment or point where `height` is not negative.
template <class Height>
std::vector<Point> clipped(const std::vector<Point>& cycle, const Height& height) {
  std::vector<Point> kept;
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const Point &p = cycle[k], &q = cycle[(k + 1) % cycle.size()];
    const mpq_class s = height(p), r = height(q);
    if (s >= 0) kept.push_back(p);
    if (s * r < 0) kept.push_back(p + mpq_class(s / (s - r)) * (q - p));
  }
  return kept;
}

bool less(const Point& p, const Point& q) {
  if (const int x = cmp(p.x, q.x)) return x < 0;
  if (const int y = cmp(p.y, q.y)) return y < 0;
  return cmp(p.z, q.z) < 0;
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

/// Whether the point lies in the face of these corners, and in no face of it with fewer.
bool least_face_holds(const Vector& n, std::vector<Point> corners, const Point& x) {
  if (corners.size() == 1) return corners.front() == x;
  if (corners.size() == 2)
    return cross(corners[1] - corners[0], x - corners[0]) == Point{} && dot(x - corners[0], x - corners[1]) < 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (to_the_left(n, corners[i], corners[(i + 1) % corners.size()], x) <= 0) return false;
  return true;
}

/// The corners of a face with these ids, in the face's order.
std::vector<Point> named(const MeetingFaces& faces, const Corners& face, const std::vector<std::uint32_t>& ids) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < face.ids.size(); ++k)
    if (std::ranges::count(ids, face.ids[k]) > 0) points.push_back(position(faces, face.points[k], 1));
  return points;
}

}  // namespace

std::vector<Point> shared_naive(const MeetingFaces& faces) {
  const Vector& n = faces.direction;
  const std::vector<Point> b = cycle_of(faces, faces.b, -(position(faces, faces.shift, faces.divisor) - faces.origin));
  std::vector<Point> cycle = cycle_of(faces, faces.a, {});
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
  const Point t = patch.translation();
  std::vector<Point> corners;
  for (const PatchCorner& corner : patch.corners) {
    const Point x = position(faces, corner.numerator, corner.divisor);
    const std::vector<Point> on_a = named(faces, faces.a, corner.on_a), on_b = named(faces, faces.b, corner.on_b);
    report.expect(on_a.size() == corner.on_a.size() && on_b.size() == corner.on_b.size(), "a corner names no face");
    report.expect(least_face_holds(patch.direction, on_a, x), "a corner is not inside its least face of A");
    report.expect(least_face_holds(patch.direction, on_b, x + t), "a corner is not inside its least face of B");
    corners.push_back(x);
  }
  report.expect(!corners.empty(), "a patch without corners");
  for (std::size_t k = 1; k < corners.size(); ++k)
    report.expect(less(corners[0], corners[k]), "the first corner is not the least");
  for (std::size_t k = 0; corners.size() > 2 && k < corners.size(); ++k)
    report.expect(to_the_left(patch.direction, corners[k], corners[(k + 1) % corners.size()],
                              corners[(k + 2) % corners.size()]) > 0,
                  "the corners do not turn left");
  return report;
}

}  // namespace fathom::patch

namespace fathom {
namespace {

Point on_a(const Patch& patch, const Vector& numerator, const mpz_class& divisor) {
  const mpz_class below = patch.denominator * divisor;
  const auto coordinate = [&](const mpq_class& from, const mpz_class& above) {
    mpq_class c = kernels::ratio(above, below);
    return sgn(from) == 0 ? c : mpq_class(from + c);
  };
  return {coordinate(patch.origin.x, numerator.x), coordinate(patch.origin.y, numerator.y),
          coordinate(patch.origin.z, numerator.z)};
}

Point core_corner(const Patch& patch, std::size_t corner) {
  return on_a(patch, patch.corners[corner].numerator, patch.corners[corner].divisor);
}

}  // namespace

Point Patch::translation() const {
  const mpz_class below = denominator * shift_divisor;
  return {kernels::ratio(shift.x, below), kernels::ratio(shift.y, below), kernels::ratio(shift.z, below)};
}

RoundedPoint Patch::a(std::size_t corner) const { return {core_corner(*this, corner), direction, -radius_a}; }

RoundedPoint Patch::b(std::size_t corner) const {
  return {core_corner(*this, corner) + translation(), direction, radius_b};
}

// Of a polygon from triangles at its first corner. All their area vectors are positive multiples of
// the direction.
RoundedWitness Patch::centroid() const {
  const Point first = core_corner(*this, 0);
  Point middle = first;
  if (rank() == 1) middle = mpq_class(1, 2) * (first + core_corner(*this, 1));
  if (rank() == 2) {
    mpq_class whole;
    Point moment;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Point p = core_corner(*this, k) - first, q = core_corner(*this, k + 1) - first;
      const mpq_class part = dot(direction, cross(p, q));
      whole += part;
      moment = moment + part * (p + q);
    }
    middle = first + mpq_class(1 / (3 * whole)) * moment;
  }
  return {{middle, direction, -radius_a}, {middle + translation(), direction, radius_b}};
}

mpq_class Patch::squared() const {
  if (rank() == 0) return 0;
  const Point first = core_corner(*this, 0), along = core_corner(*this, 1) - first;
  if (rank() == 1) return dot(along, along);
  Point area;  // twice
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    area = area + cross(core_corner(*this, k) - first, core_corner(*this, k + 1) - first);
  return dot(area, area) / 4;
}

}  // namespace fathom
