// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"

namespace fathom::picture {
namespace {

using Triple = Vec3<double>;

/// A multiple whose greatest component is 1 or -1; zero stays.
Point shortened(const Point& v) {
  const mpq_class largest = std::max({mpq_class(abs(v.x)), mpq_class(abs(v.y)), mpq_class(abs(v.z))});
  if (largest == 0) return v;
  return {mpq_class(v.x / largest), mpq_class(v.y / largest), mpq_class(v.z / largest)};
}

mpq_class product(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Triple rounded(const Point& v) { return {v.x.get_d(), v.y.get_d(), v.z.get_d()}; }
double length(const Triple& v) { return std::hypot(v.x, v.y, v.z); }

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

double turn(const Dot& p, const Dot& q, const Dot& r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/// The part of a path where `inside` is not negative. `inside` is linear.
template <class Inside>
std::vector<Dot> half(const std::vector<Dot>& path, bool closed, const Inside& inside) {
  std::vector<Dot> result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Dot& p = path[i];
    if (inside(p) >= 0) result.push_back(p);
    if (i + 1 == path.size() && !closed) break;
    const Dot& q = path[(i + 1) % path.size()];
    const double at_p = inside(p), at_q = inside(q);
    if ((at_p < 0) == (at_q < 0)) continue;
    const double share = at_p / (at_p - at_q);
    result.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
  }
  return result;
}

}  // namespace

Triple unit_vector(const Point& v) { return normalised(rounded(shortened(v))); }

Point point_of(const Vector& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

View::View(const Point& along, const std::optional<Point>& second) : right_(shortened(along)) {
  constexpr double hardly = 1e-3;  // below this sine the second direction does not show
  const Triple right = unit_vector(right_);
  Triple up = second ? across(unit_vector(*second), right) : Triple{};
  if (!(length(up) > hardly)) up = across(least_aligned(right), right);
  up = normalised(up);
  up_ = {exact_value(up.x), exact_value(up.y), exact_value(up.z)};
  right_length_ = length(rounded(right_));
  towards_ = cross(right, up);
}

Dot View::project(const Point& p, const Point& centre, const mpq_class& unit) const {
  const Point v{mpq_class((p.x - centre.x) / unit), mpq_class((p.y - centre.y) / unit), mpq_class((p.z - centre.z) / unit)};
  return {product(right_, v).get_d() / right_length_, product(up_, v).get_d()};
}

bool View::faces_us(const Vector& normal) const { return dot(unit_vector(point_of(normal)), towards_) > 0; }

std::vector<Dot> clipped(std::vector<Dot> path, bool closed, Dot centre, Dot limit) {
  if (!std::ranges::all_of(path, [](const Dot& d) { return std::isfinite(d.x) && std::isfinite(d.y); })) return {};
  path = half(path, closed, [&](const Dot& d) { return d.x - (centre.x - limit.x); });
  path = half(path, closed, [&](const Dot& d) { return centre.x + limit.x - d.x; });
  path = half(path, closed, [&](const Dot& d) { return d.y - (centre.y - limit.y); });
  return half(path, closed, [&](const Dot& d) { return centre.y + limit.y - d.y; });
}

std::vector<Dot> outline(std::vector<Dot> dots) {
  std::ranges::sort(dots, {}, [](const Dot& d) { return std::pair(d.x, d.y); });
  if (dots.size() < 3) return dots;
  std::vector<Dot> result;
  const auto add = [&](const Dot& d, std::size_t fixed) {
    while (result.size() >= fixed + 2 && !(turn(result[result.size() - 2], result.back(), d) > 0)) result.pop_back();
    result.push_back(d);
  };
  for (const Dot& d : dots) add(d, 0);
  const std::size_t lower = result.size() - 1;
  for (auto d = dots.rbegin() + 1; d != dots.rend(); ++d) add(*d, lower);
  result.pop_back();
  return result;
}

}  // namespace fathom::picture
