// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fathom/numbers.hpp"

namespace fathom::picture {
namespace {

using Triple = Vec3<double>;

/// A multiple whose greatest component is 1 or -1; zero stays.
Point shortened(const Point& v) {
  const mpq_class largest = std::max({mpq_class(abs(v.x)), mpq_class(abs(v.y)), mpq_class(abs(v.z))});
  return largest == 0 ? v : (1 / largest) * v;
}

Triple rounded(const Point& v) { return {v.x.get_d(), v.y.get_d(), v.z.get_d()}; }
double length(const Triple& v) { return std::sqrt(dot(v, v)); }

Triple normalised(const Triple& v) {
  const double l = length(v);
  return l > 0 ? Triple{v.x / l, v.y / l, v.z / l} : Triple{};
}

/// What is left of v across the unit vector u.
Triple across(const Triple& v, const Triple& u) {
  const double along = dot(u, v);
  return {v.x - along * u.x, v.y - along * u.y, v.z - along * u.z};
}

/// Of the directions of the axes, the one that leaves the most across u.
Triple least_aligned(const Triple& u) {
  const double x = std::abs(u.x), y = std::abs(u.y), z = std::abs(u.z);
  if (z <= x && z <= y) return {0, 0, 1};
  return y <= x ? Triple{0, 1, 0} : Triple{1, 0, 0};
}

/// A turn about the way, by its cosine and sine.
struct Turn {
  double cosine, sine;
};

/// Unit vectors, so that no facet of a box that stands along the axes is seen from its edge, nor two of its edges behind one another.
/// From above, the first first.
constexpr std::array<Turn, 8> turns{
    {{0.92, 0.392}, {0.8, 0.6}, {0.98, 0.199}, {0.92, -0.392}, {0.6, 0.8}, {0.8, -0.6}, {0.352, 0.936}, {0.352, -0.936}}};

Triple turned(const Triple& up, const Triple& beside, const Turn& turn) {
  return normalised(
      {turn.cosine * up.x + turn.sine * beside.x, turn.cosine * up.y + turn.sine * beside.y, turn.cosine * up.z + turn.sine * beside.z});
}

/// How much of the edge that is seen least is seen if `up` points up: from 0, end on, to 1. What lies along the way counts not.
double seen(const Triple& right, const Triple& up, std::span<const Point> edges) {
  double least = 1;
  for (const Point& edge : edges) {
    const Triple beside = normalised(across(unit_vector(edge), right));
    if (length(beside) > 0) least = std::min(least, std::abs(dot(beside, up)));
  }
  return least;
}

/// Up if nothing else lies in the plane.
Triple free_up(const Triple& right, std::span<const Point> edges) {
  constexpr double enough = 0.4;
  const Triple upright = normalised(across(least_aligned(right), right)), beside = cross(upright, right);
  Triple best = turned(upright, beside, turns.front());
  for (const Turn& turn : turns) {
    const double found = seen(right, best, edges);
    if (found >= enough) return best;
    const Triple up = turned(upright, beside, turn);
    if (seen(right, up, edges) > found) best = up;
  }
  return best;
}

}  // namespace

Triple unit_vector(const Point& v) { return normalised(rounded(shortened(v))); }

Point exact_point(const Triple& v) { return {exact_value(v.x), exact_value(v.y), exact_value(v.z)}; }

View::View(const Point& along, const std::optional<Point>& second, std::span<const Point> edges) {
  constexpr double hardly = 1e-3;  // below this sine the second direction does not show
  const Point way = shortened(along);
  const Triple right = unit_vector(way);
  Triple up = second ? across(unit_vector(*second), right) : Triple{};
  up = length(up) > hardly ? normalised(up) : free_up(right, edges);
  right_ = (1 / exact_value(length(rounded(way)))) * way;
  up_ = exact_point(up);
  towards_ = cross(right, up);
  look_ = {mpq_class(right_.y * up_.z - right_.z * up_.y), mpq_class(right_.z * up_.x - right_.x * up_.z),
           mpq_class(right_.x * up_.y - right_.y * up_.x)};
}

Spot View::place(const Point& p) const { return {dot(right_, p), dot(up_, p)}; }

Dot View::project(const Point& p, const Point& centre, const mpq_class& unit) const {
  const Spot at = place((1 / unit) * (p - centre));
  return {at.x.get_d(), at.y.get_d()};
}

bool View::faces_us(const Vector& normal) const { return sees(unit_vector(rational(normal))); }

bool View::sees(const Vec3<double>& unit_normal) const {
  constexpr double from_its_edge = -1e-9;
  return dot(unit_normal, towards_) > from_its_edge;
}

}  // namespace fathom::picture
