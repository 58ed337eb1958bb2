// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of what two convex polygons in one plane share are corners of one that lie in the
// other, and crossings of their edges: all of this is told by on which side of which edge each
// given corner is.
#include "reference/patch/patch.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "kernels/number/rational.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::patch {

// ---- points as integers ----

std::optional<BinaryRange> binary_range(std::span<const GivenPoint> given) {
  BinaryRange range;
  for (const GivenPoint& p : given) {
    const auto* const binary64 = std::get_if<std::array<double, 3>>(&p.coordinates);
    if (binary64 == nullptr) return std::nullopt;
    for (const double x : *binary64) {
      const long exponent = kernels::dyadic(x).exponent;
      range.low = std::min(range.low, exponent);
      range.high = std::max(range.high, exponent + 53);
    }
  }
  return range;
}

Scaled scaled(std::span<const GivenPoint> given) {
  const auto shifted = [](long word, unsigned by) { return mpz_class(mpz_class(word) << by); };
  if (const auto range = binary_range(given)) return over_power_of_two<mpz_class>(given, range->low, shifted);
  Scaled result;
  std::vector<Point> exact;
  for (const GivenPoint& p : given) {
    exact.push_back(p.exact());
    for (const mpq_class* c : {&exact.back().x, &exact.back().y, &exact.back().z})
      if (!mpz_divisible_p(result.denominator.get_mpz_t(), c->get_den_mpz_t()))
        result.denominator = lcm(result.denominator, c->get_den());
  }
  const auto integer = [&](const mpq_class& c) {
    if (c.get_den() == result.denominator) return c.get_num();
    return mpz_class(c.get_num() * (result.denominator / c.get_den()));
  };
  for (const Point& p : exact) result.points.push_back({integer(p.x), integer(p.y), integer(p.z)});
  return result;
}

namespace {

using kernels::Integer127;
using kernels::Integer255;

std::vector<GivenPoint> all_corners(const MeetingFaces& faces) {
  std::vector<GivenPoint> points;
  points.reserve(faces.of_a.size() + faces.of_b.size());
  for (const std::uint32_t i : faces.of_a) points.push_back(faces.a[i]);
  for (const std::uint32_t j : faces.of_b) points.push_back(faces.b[j]);
  return points;
}

// ---- seen along the direction ----

/// A point of the plane; counter-clockwise is as seen from the tip of the direction.
template <class Integer>
struct Seen {
  Integer x, y;
};

/// Two vectors orthogonal to n, as coordinates: a translation along n does not change them. Their
/// cross product is a positive multiple of n.
template <class Integer>
Seen<Integer> seen(const Vec3<Integer>& p, const Vec3<Integer>& n) {
  const auto across = [](const Integer& n_i, const Integer& p_j, const Integer& n_j, const Integer& p_i) {
    return Integer(n_i * p_j - n_j * p_i);
  };
  const bool along_z = sgn(n.z) != 0, along_x = !along_z && sgn(n.x) != 0;
  const int side = along_z ? sgn(n.z) : along_x ? sgn(n.x) : sgn(n.y);
  Seen<Integer> s = along_z   ? Seen<Integer>{across(n.z, p.x, n.x, p.z), across(n.z, p.y, n.y, p.z)}
                    : along_x ? Seen<Integer>{across(n.x, p.y, n.y, p.x), across(n.x, p.z, n.z, p.x)}
                              : Seen<Integer>{across(n.y, p.z, n.z, p.y), across(n.y, p.x, n.x, p.y)};
  if (side < 0) std::swap(s.x, s.y);
  return s;
}

/// Coordinates of points with |c| < 2^point_bits, along a direction with |n_i| < 2^direction_bits,
/// have point_bits + direction_bits + 1 bits; how far one is beyond a side, twice as many and 3.
template <class Integer>
bool holds(long point_bits, long direction_bits) {
  return 2 * (point_bits + direction_bits + 1) + 3 <= Integer::most_bits;
}

/// A polygon in the plane, and the half-planes that it is the intersection of: side i is left of
/// the edge from corner i to the next. Of a segment, sides 0 and 1 are left and right of it, and
/// sides 2 and 3 end at corners 0 and 1; of a point there are four.
template <class Integer>
class Polygon {
 public:
  explicit Polygon(std::vector<Seen<Integer>> corners) : corners_(std::move(corners)) {
    const auto& c = corners_;
    if (size() == 1) {
      for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) add_side(c[0], Integer(x), Integer(y));
      return;
    }
    for (std::size_t i = 0; i < size(); ++i) {
      const Seen<Integer>& q = c[next(i)];
      add_side(c[i], c[i].y - q.y, q.x - c[i].x);
    }
    if (size() > 2) return;
    add_side(c[0], c[1].x - c[0].x, c[1].y - c[0].y);
    add_side(c[1], c[0].x - c[1].x, c[0].y - c[1].y);
  }

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] std::size_t sides() const { return sides_.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  /// How many edges there are to be crossed.
  [[nodiscard]] std::size_t edges() const { return size() > 2 ? size() : size() - 1; }
  [[nodiscard]] const Seen<Integer>& operator[](std::size_t i) const { return corners_[i]; }
  /// 1 inside of a side, 0 on it, -1 outside.
  [[nodiscard]] int side_of(const Seen<Integer>& p, std::size_t side) const {
    const HalfPlane& h = sides_[side];
    const int sign = sgn(Integer(h.x * p.x + h.y * p.y - h.level));
    return (sign > 0) - (sign < 0);
  }

 private:
  struct HalfPlane {
    Integer x, y, level;
  };
  void add_side(const Seen<Integer>& p, Integer x, Integer y) {
    Integer level(x * p.x + y * p.y);
    sides_.push_back({std::move(x), std::move(y), std::move(level)});
  }

  std::vector<Seen<Integer>> corners_;
  std::vector<HalfPlane> sides_;
};

/// On which side of a polygon's sides the corners of another one are.
class Sides {
 public:
  template <class Integer>
  Sides(const Polygon<Integer>& of, const Polygon<Integer>& polygon) : sides_(polygon.sides()) {
    signs_.reserve(of.size() * sides_);
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t s = 0; s < sides_; ++s) signs_.push_back(static_cast<std::int8_t>(polygon.side_of(of[i], s)));
  }
  /// 1 inside, 0 on the side, -1 outside.
  [[nodiscard]] int operator()(std::size_t corner, std::size_t side) const { return signs_[corner * sides_ + side]; }
  [[nodiscard]] std::size_t count() const { return sides_; }

 private:
  std::size_t sides_;
  std::vector<std::int8_t> signs_;
};

/// Where a point of a polygon is on its boundary: at a corner, inside the edge after it, or not.
struct OnBoundary {
  enum class Where : std::uint8_t { corner, edge, nowhere } where = Where::nowhere;
  std::size_t index = 0;

  [[nodiscard]] bool nowhere() const { return where == Where::nowhere; }
  [[nodiscard]] bool at_corner() const { return where == Where::corner; }
};
using Where = OnBoundary::Where;

/// Of corner i of the other polygon; nullopt if it is outside.
template <class Integer>
std::optional<OnBoundary> place_in(const Polygon<Integer>& polygon, const Sides& sides, std::size_t i) {
  std::array<std::size_t, 4> on{};  // sides; of a point all four
  std::size_t count = 0;
  for (std::size_t s = 0; s < sides.count(); ++s) {
    const int sign = sides(i, s);
    if (sign < 0) return std::nullopt;
    if (sign == 0) on[count++] = s;
  }
  if (polygon.size() == 1) return OnBoundary{Where::corner, 0};
  if (polygon.size() == 2) return count > 2 ? OnBoundary{Where::corner, on[2] - 2} : OnBoundary{Where::edge, 0};
  if (count == 0) return OnBoundary{};
  if (count == 1) return OnBoundary{Where::edge, on[0]};
  return OnBoundary{Where::corner, polygon.next(on[0]) == on[1] ? on[1] : on[0]};
}

/// A corner of what both share: where it is on either.
struct Shared {
  OnBoundary a, b;
};

/// What two polygons share, as corners around it.
template <class Integer>
class Overlay {
 public:
  Overlay(std::vector<Seen<Integer>> a, std::vector<Seen<Integer>> b)
      : a_(std::move(a)), b_(std::move(b)), a_sides_(a_, b_), b_sides_(b_, a_) {}

  [[nodiscard]] std::vector<Shared> corners() const {
    std::vector<Shared> found = all();
    return found.size() > 2 ? around(std::move(found)) : found;
  }

 private:
  /// In no order: those of A in B, those of B in A that are not of A as well, and crossings.
  [[nodiscard]] std::vector<Shared> all() const {
    std::vector<Shared> found;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (const auto on_b = place_in(b_, a_sides_, i)) found.push_back({{Where::corner, i}, *on_b});
    for (std::size_t j = 0; j < b_.size(); ++j)
      if (const auto on_a = place_in(a_, b_sides_, j); on_a && !on_a->at_corner())
        found.push_back({*on_a, {Where::corner, j}});
    for (std::size_t i = 0; i < a_.edges(); ++i)
      for (std::size_t j = 0; j < b_.edges(); ++j)
        if (a_sides_(i, j) * a_sides_(a_.next(i), j) < 0 && b_sides_(j, i) * b_sides_(b_.next(j), i) < 0)
          found.push_back({{Where::edge, i}, {Where::edge, j}});
    return found;
  }

  /// Whether A's edge that holds the corner comes from outside of B there.
  [[nodiscard]] bool enters(const Shared& corner) const {
    const std::size_t from = corner.a.index, side = corner.b.index;
    return a_sides_(from, side) < 0 || (corner.b.at_corner() && a_sides_(from, b_.before(side)) < 0);
  }

  /// Of three or more: along A's boundary, and between two of these along B's where it is inside A.
  [[nodiscard]] std::vector<Shared> around(std::vector<Shared> corners) const {
    const auto inside =
        std::stable_partition(corners.begin(), corners.end(), [](const Shared& corner) { return !corner.a.nowhere(); });
    std::sort(corners.begin(), inside, [&](const Shared& p, const Shared& q) {
      if (p.a.index != q.a.index) return p.a.index < q.a.index;
      if (p.a.where != q.a.where) return p.a.at_corner();
      return enters(p) && !enters(q);
    });
    if (inside == corners.begin()) return corners;  // all of B, in its order
    std::vector<bool> inner(b_.size(), false);
    for (auto corner = inside; corner != corners.end(); ++corner) inner[corner->b.index] = true;
    std::vector<Shared> cycle;
    for (auto corner = corners.begin(); corner != inside; ++corner) {
      cycle.push_back(*corner);
      if (corner->b.nowhere()) continue;
      for (std::size_t j = b_.next(corner->b.index); inner[j]; j = b_.next(j))
        cycle.push_back({{}, {Where::corner, j}});
    }
    return cycle;
  }

  Polygon<Integer> a_, b_;
  Sides a_sides_, b_sides_;  // of A's corners against B's sides, and the other way round
};

// ---- corners ----

/// Both faces, their corners counter-clockwise, and what they share.
struct Overlaid {
  std::vector<std::uint32_t> a, b;  ///< places in MeetingFaces::of_a and of_b
  std::vector<Shared> corners;
};

/// The corners counter-clockwise, by their places among the `count` points that begin at `first`.
template <class Integer>
std::vector<std::uint32_t> cycle_of(const std::vector<Vec3<Integer>>& points, std::size_t first, std::size_t count,
                                    const Vec3<Integer>& n) {
  std::vector<std::uint32_t> ids(count);
  std::iota(ids.begin(), ids.end(), static_cast<std::uint32_t>(first));
  ids = polytope::polygon_corners(points, std::move(ids), n);
  for (std::uint32_t& i : ids) i -= static_cast<std::uint32_t>(first);
  return ids;
}

/// Of points of A and then of B. A is moved along n only, unless it is moved by shift / divisor.
template <class Integer>
Overlaid overlaid(const std::vector<Vec3<Integer>>& points, std::size_t of_a, const Vector& direction,
                  const Vec3<Integer>* shift = nullptr, const Integer* divisor = nullptr) {
  const Vec3<Integer> n{Integer(direction.x), Integer(direction.y), Integer(direction.z)};
  Overlaid result{cycle_of(points, 0, of_a, n), cycle_of(points, of_a, points.size() - of_a, n), {}};
  const auto look = [&](std::size_t i, bool moved) {
    Seen<Integer> s = seen(points[i], n);
    if (shift == nullptr) return s;
    s = {Integer(*divisor * s.x), Integer(*divisor * s.y)};
    if (!moved) return s;
    const Seen<Integer> by = seen(*shift, n);
    return Seen<Integer>{Integer(s.x + by.x), Integer(s.y + by.y)};
  };
  std::vector<Seen<Integer>> a, b;
  for (const std::uint32_t i : result.a) a.push_back(look(i, true));
  for (const std::uint32_t j : result.b) b.push_back(look(of_a + j, false));
  result.corners = Overlay<Integer>(std::move(a), std::move(b)).corners();
  if (result.corners.empty()) throw std::logic_error("the faces in an optimal direction do not meet");
  return result;
}

/// The same by coordinate(i, axis), |c| < 2^bits, of `count` points, if the integers hold what is
/// computed.
template <class Integer, class Coordinate>
std::optional<Overlaid> overlaid_in(std::size_t count, std::size_t of_a, const Vector& n, long bits,
                                    const Coordinate& coordinate) {
  if (!holds<Integer>(bits, kernels::bit_length(n))) return std::nullopt;
  std::vector<Vec3<Integer>> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({Integer(coordinate(i, 0)), Integer(coordinate(i, 1)), Integer(coordinate(i, 2))});
  return overlaid(points, of_a, n);
}

template <class Coordinate>
std::optional<Overlaid> overlaid_in_words(std::size_t count, std::size_t of_a, const Vector& n, long bits,
                                          const Coordinate& coordinate) {
  if (auto found = overlaid_in<Integer127>(count, of_a, n, bits, coordinate)) return found;
  return overlaid_in<Integer255>(count, of_a, n, bits, coordinate);
}

/// All coordinates, if the points are in binary64.
std::optional<std::vector<double>> numbers_of(std::span<const GivenPoint> points) {
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for (const GivenPoint& p : points) {
    const auto* const given = std::get_if<std::array<double, 3>>(&p.coordinates);
    if (given == nullptr) return std::nullopt;
    numbers.insert(numbers.end(), given->begin(), given->end());
  }
  return numbers;
}

Overlaid overlaid(const std::vector<GivenPoint>& given, std::size_t of_a, const Vector& n) {
  const auto numbers = numbers_of(given);
  if (const auto words = numbers ? polytope::aligned(*numbers) : std::nullopt) {
    const auto word = [&](std::size_t i, int axis) { return words->integers[3 * i + static_cast<std::size_t>(axis)]; };
    if (auto found = overlaid_in_words(given.size(), of_a, n, words->bits, word)) return *std::move(found);
  }
  const Scaled all = scaled(given);
  long bits = 0;
  for (const Vector& p : all.points) bits = std::max(bits, kernels::bit_length(p));
  const auto integer = [&](std::size_t i, int axis) -> const mpz_class& {
    return kernels::coordinate(all.points[i], axis);
  };
  if (auto found = overlaid_in_words(given.size(), of_a, n, bits, integer)) return *std::move(found);
  return overlaid(all.points, of_a, n);
}

/// The ids of the least face that holds a point, ascending.
std::vector<std::uint32_t> least_face(std::span<const std::uint32_t> ids, const std::vector<std::uint32_t>& cycle,
                                      const OnBoundary& at) {
  if (at.at_corner()) return {ids[cycle[at.index]]};
  std::vector<std::uint32_t> face(ids.begin(), ids.end());
  if (at.where == Where::edge)
    face = {ids[cycle[at.index]], ids[cycle[at.index + 1 == cycle.size() ? 0 : at.index + 1]]};
  std::sort(face.begin(), face.end());
  return face;
}

/// The ends of an edge.
std::array<GivenPoint, 2> ends(const polytope::Points& body, std::span<const std::uint32_t> ids,
                               const std::vector<std::uint32_t>& cycle, std::size_t edge) {
  return {body[ids[cycle[edge]]], body[ids[cycle[edge + 1 == cycle.size() ? 0 : edge + 1]]]};
}

PatchCorner corner_of(const MeetingFaces& faces, const Overlaid& overlaid, const Shared& at) {
  PatchCorner corner{least_face(faces.of_a, overlaid.a, at.a), least_face(faces.of_b, overlaid.b, at.b), {}};
  if (at.a.at_corner()) corner.meeting = CornerOfA{faces.a[corner.on_a[0]]};
  else if (at.b.at_corner()) corner.meeting = CornerOfB{faces.b[corner.on_b[0]]};
  else
    corner.meeting = CrossingEdges{ends(faces.a, faces.of_a, overlaid.a, at.a.index),
                                   ends(faces.b, faces.of_b, overlaid.b, at.b.index)};
  return corner;
}

/// The corners of a patch, the one with the least features first.
std::vector<PatchCorner> ordered(const MeetingFaces& faces, const Overlaid& overlaid) {
  std::vector<PatchCorner> corners;
  corners.reserve(overlaid.corners.size());
  for (const Shared& at : overlaid.corners) corners.push_back(corner_of(faces, overlaid, at));
  const auto least = std::ranges::min_element(corners, [](const PatchCorner& p, const PatchCorner& q) {
    return p.on_a != q.on_a ? p.on_a < q.on_a : p.on_b < q.on_b;
  });
  std::rotate(corners.begin(), least, corners.end());
  return corners;
}

Patch patch_along(const Vector& n, const mpq_class& support) {
  Patch patch;
  patch.direction = n;
  patch.by = support;
  return patch;
}

}  // namespace

Patch shared(const MeetingFaces& faces, const mpq_class& support) {
  const Vector& n = faces.direction;
  Patch patch = patch_along(n, support);
  patch.corners = ordered(faces, overlaid(all_corners(faces), faces.of_a.size(), n));
  return patch;
}

Patch shared_after(const Point& t, const MeetingFaces& faces) {
  const Scaled points = scaled(all_corners(faces));
  const Point moved = mpq_class(points.denominator) * t;
  const mpz_class divisor = lcm(lcm(moved.x.get_den(), moved.y.get_den()), moved.z.get_den());
  const auto integer = [&](const mpq_class& c) { return mpz_class(c.get_num() * (divisor / c.get_den())); };
  const Vector shift{integer(moved.x), integer(moved.y), integer(moved.z)};
  const Overlaid found = overlaid(points.points, faces.of_a.size(), faces.direction, &shift, &divisor);
  Patch patch;
  patch.direction = faces.direction;
  patch.by = t;
  patch.corners = ordered(faces, found);
  for (PatchCorner& corner : patch.corners)
    if (auto* const edges = std::get_if<CrossingEdges>(&corner.meeting))
      for (GivenPoint& end : edges->a) end = {end.exact() + t};
  return patch;
}

Patch shared_inside(const MeetingFaces& faces, const mpq_class& support) {
  const std::size_t of_a = faces.of_a.size(), of_b = faces.of_b.size();
  if (of_a > 1 && of_b > 1 && of_a + of_b > 4) return shared(faces, support);
  Patch patch = patch_along(faces.direction, support);
  PatchCorner& corner = patch.corners.emplace_back(
      PatchCorner{{faces.of_a.begin(), faces.of_a.end()}, {faces.of_b.begin(), faces.of_b.end()}, {}});
  if (of_a == 1) corner.meeting = CornerOfA{faces.a[faces.of_a[0]]};
  else if (of_b == 1) corner.meeting = CornerOfB{faces.b[faces.of_b[0]]};
  else
    corner.meeting = CrossingEdges{{faces.a[faces.of_a[0]], faces.a[faces.of_a[1]]},
                                   {faces.b[faces.of_b[0]], faces.b[faces.of_b[1]]}};
  return patch;
}

std::vector<std::uint32_t> counter_clockwise(const Vector& n, const polytope::Points& body,
                                             std::span<const std::uint32_t> ids) {
  std::vector<GivenPoint> given;
  for (const std::uint32_t i : ids) given.push_back(body[i]);
  std::vector<std::uint32_t> cycle = cycle_of(scaled(given).points, 0, given.size(), n);
  for (std::uint32_t& i : cycle) i = ids[i];
  return cycle;
}

Patch on_plane(const Vector& n, const polytope::Points& body, std::span<const std::uint32_t> face,
               const mpq_class& support, bool half_space_is_a) {
  std::vector<std::uint32_t> cycle = counter_clockwise(n, body, face);
  std::rotate(cycle.begin(), std::ranges::min_element(cycle), cycle.end());
  Patch patch = patch_along(n, support);
  for (const std::uint32_t i : cycle) {
    PatchCorner& corner = patch.corners.emplace_back();
    if (half_space_is_a) (corner.on_b = {i}, corner.meeting = CornerOfB{body[i]});
    else (corner.on_a = {i}, corner.meeting = CornerOfA{body[i]});
  }
  return patch;
}

}  // namespace fathom::patch

namespace fathom {
namespace {

Witness meeting_of(const Patch& patch, std::size_t corner) {
  const Point t = patch.translation();
  const auto& meeting = patch.corners[corner].meeting;
  if (const auto* const a = std::get_if<CornerOfA>(&meeting)) {
    const Point p = a->point.exact();
    return {p, p + t};
  }
  if (const auto* const b = std::get_if<CornerOfB>(&meeting)) {
    const Point q = b->point.exact();
    return {q - t, q};
  }
  Witness crossing = depth::crossing_of(std::get<CrossingEdges>(meeting), patch.direction);
  if (std::holds_alternative<Point>(patch.by)) crossing.a = crossing.a - t;
  return crossing;
}

std::vector<Point> core_corners(const Patch& patch) {
  std::vector<Point> corners;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) corners.push_back(meeting_of(patch, k).a);
  return corners;
}

}  // namespace

Point Patch::translation() const {
  if (const Point* const t = std::get_if<Point>(&by)) return *t;
  return Optimum{direction, std::get<mpq_class>(by), {}}.translation();
}

RoundedPoint Patch::a(std::size_t corner) const { return {meeting_of(*this, corner).a, direction, -radius_a}; }

RoundedPoint Patch::b(std::size_t corner) const { return {meeting_of(*this, corner).b, direction, radius_b}; }

// Of a polygon from triangles at its first corner. All their area vectors are positive multiples of
// the direction.
RoundedWitness Patch::centroid() const {
  const std::vector<Point> all = core_corners(*this);
  Point middle = all[0];
  if (rank() == 1) middle = mpq_class(1, 2) * (all[0] + all[1]);
  if (rank() == 2) {
    mpq_class whole;
    Point moment;
    for (std::size_t k = 1; k + 1 < all.size(); ++k) {
      const Point p = all[k] - all[0], q = all[k + 1] - all[0];
      const mpq_class part = dot(direction, cross(p, q));
      whole += part;
      moment = moment + part * (p + q);
    }
    middle = all[0] + mpq_class(1 / (3 * whole)) * moment;
  }
  return {{middle, direction, -radius_a}, {middle + translation(), direction, radius_b}};
}

mpq_class Patch::squared() const {
  const std::vector<Point> all = core_corners(*this);
  if (rank() == 0) return 0;
  if (rank() == 1) return dot(all[1] - all[0], all[1] - all[0]);
  Point area;  // twice
  for (std::size_t k = 1; k + 1 < all.size(); ++k) area = area + cross(all[k] - all[0], all[k + 1] - all[0]);
  return dot(area, area) / 4;
}

}  // namespace fathom
