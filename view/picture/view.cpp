// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "fathom/numbers.hpp"

namespace fathom::picture {
namespace {

using Triple = Vec3<double>;

/// Returns the multiple whose greatest component is 1 or -1; zero for zero.
Point shortened(const Point& v) {
  const mpq_class size = largest(v);
  return size == 0 ? v : (1 / size) * v;
}

Triple rounded(const Point& v) { return {v.x.get_d(), v.y.get_d(), v.z.get_d()}; }

Triple normalised(const Triple& v) {
  const double l = length(v);
  return l > 0 ? Triple{v.x / l, v.y / l, v.z / l} : Triple{};
}

/// Returns the component of v orthogonal to the unit vector u.
Triple across(const Triple& v, const Triple& u) {
  const double along = dot(u, v);
  return {v.x - along * u.x, v.y - along * u.y, v.z - along * u.z};
}

/// Returns the direction of the axis that is the least aligned with u.
Triple least_aligned(const Triple& u) {
  const double x = std::abs(u.x), y = std::abs(u.y), z = std::abs(u.z);
  if (z <= x && z <= y) return {0, 0, 1};
  return y <= x ? Triple{0, 1, 0} : Triple{1, 0, 0};
}

/// A rotation about the way, by its cosine and sine.
struct Turn {
  double cosine, sine;
};

/// Rotations in which no facet of a box along the axes is seen from its edge, and no two of its
/// edges coincide. The views are from above; the first is preferred.
constexpr std::array<Turn, 8> turns{{{0.92, 0.392},
                                     {0.8, 0.6},
                                     {0.98, 0.199},
                                     {0.92, -0.392},
                                     {0.6, 0.8},
                                     {0.8, -0.6},
                                     {0.352, 0.936},
                                     {0.352, -0.936}}};

Triple turned(const Triple& up, const Triple& beside, const Turn& turn) {
  return normalised({turn.cosine * up.x + turn.sine * beside.x, turn.cosine * up.y + turn.sine * beside.y,
                     turn.cosine * up.z + turn.sine * beside.z});
}

/// Returns the smallest share of an edge's length that is seen if `up` points up: from 0, end on,
/// to 1. Edges along the way do not count.
double seen(const Triple& right, const Triple& up, std::span<const Point> edges) {
  double least = 1;
  for (const Point& edge : edges) {
    const Triple beside = normalised(across(unit_vector(edge), right));
    if (length(beside) > 0) least = std::min(least, std::abs(dot(beside, up)));
  }
  return least;
}

/// Returns the upward direction if no second direction must lie in the plane.
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

constexpr int margin = 22;           // pixels
constexpr int strip = 18;            // pixels at the bottom, for the scale bar
constexpr int much_longer = 100;     // beyond this ratio the axes are scaled differently
constexpr double safe_pixels = 1e6;  // within these, doubles are exact enough for tenths of pixels

Dot rounded(const Spot& p) { return {p.x.get_d(), p.y.get_d()}; }
bool is_safe(const Dot& d) { return std::abs(d.x) <= safe_pixels && std::abs(d.y) <= safe_pixels; }

/// Returns "1.5"; never "-0".
std::string number(double x) {
  const std::string text = fmt::format("{:.1f}", x);
  const std::string_view shown =
      text.ends_with(".0") ? std::string_view(text).substr(0, text.size() - 2) : std::string_view(text);
  return std::string(shown == "-0" ? "0" : shown);
}

mpq_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? mpq_class(mpz_class(1), power) : mpq_class(power);
}

/// Returns the exponent of the greatest power of ten that is at most x > 0.
long exponent_of(const mpq_class& x) {
  const auto digits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 10)); };
  long result = digits(x.get_num()) - digits(x.get_den()) + 1;  // an upper bound, too large by up to 3
  while (power_of_ten(result) > x) --result;
  return result;
}

std::string text_of(unsigned long digit, long exponent) {
  if (exponent > 4 || exponent < -4) return fmt::format("{}e{}", digit, exponent);
  if (exponent >= 0) return fmt::format("{}{}", digit, std::string(static_cast<std::size_t>(exponent), '0'));
  return fmt::format("0.{}{}", std::string(static_cast<std::size_t>(-exponent - 1), '0'), digit);
}

template <class P>
using Number = std::remove_cvref_t<decltype(P::x)>;

template <class P>
Number<P> turn(const P& p, const P& q, const P& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Returns the part of a path where `inside`, which is linear, is not negative.
template <class P, class Inside>
std::vector<P> half(const std::vector<P>& path, bool closed, const Inside& inside) {
  std::vector<P> result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const P& p = path[i];
    const Number<P> at_p = inside(p);
    if (at_p >= 0) result.push_back(p);
    if (i + 1 == path.size() && !closed) break;
    const P& q = path[(i + 1) % path.size()];
    const Number<P> at_q = inside(q);
    if ((at_p < 0) == (at_q < 0)) continue;
    const Number<P> t = at_p / (at_p - at_q);
    result.push_back({Number<P>(p.x + t * (q.x - p.x)), Number<P>(p.y + t * (q.y - p.y))});
  }
  return result;
}

template <class P>
std::vector<P> inside_box(std::vector<P> path, bool closed, const P& low, const P& high) {
  path = half(path, closed, [&](const P& p) { return Number<P>(p.x - low.x); });
  path = half(path, closed, [&](const P& p) { return Number<P>(high.x - p.x); });
  path = half(path, closed, [&](const P& p) { return Number<P>(p.y - low.y); });
  return half(path, closed, [&](const P& p) { return Number<P>(high.y - p.y); });
}

template <class P>
std::vector<P> around(std::vector<P> places) {
  std::ranges::sort(places, [](const P& p, const P& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  const auto last =
      std::unique(places.begin(), places.end(), [](const P& p, const P& q) { return p.x == q.x && p.y == q.y; });
  places.erase(last, places.end());
  if (places.size() < 3) return places;
  std::vector<P> result;
  const auto add = [&](const P& p, std::size_t fixed) {
    while (result.size() >= fixed + 2 && !(turn(result[result.size() - 2], result.back(), p) > 0)) result.pop_back();
    result.push_back(p);
  };
  for (const P& p : places) add(p, 0);
  const std::size_t lower = result.size() - 1;
  for (auto p = places.rbegin() + 1; p != places.rend(); ++p) add(*p, lower);
  result.pop_back();
  return result;
}

/// A part of a segment, by its shares from 0 to 1.
struct Part {
  double from, to;
};

/// Returns the part of the segment in the closed polygon; from >= to if it is empty.     [Cyrus and
/// Beck]
Part part_inside(const Dot& p, const Dot& q, const std::vector<Dot>& polygon) {
  Part part{0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Dot &r = polygon[i], &s = polygon[(i + 1) % polygon.size()];
    const double at_p = turn(r, s, p), at_q = turn(r, s, q);
    if (at_p < 0 && at_q < 0) return {1, 0};
    if (at_p < 0) part.from = std::max(part.from, at_p / (at_p - at_q));
    else if (at_q < 0) part.to = std::min(part.to, at_p / (at_p - at_q));
  }
  return part;
}

/// Returns the parts of [0, 1] outside these parts.
std::vector<Part> rest_of(std::vector<Part> covered) {
  constexpr double least = 1e-6;  // shorter parts are due to rounding
  std::ranges::sort(covered, {}, &Part::from);
  std::vector<Part> rest;
  double reached = 0;
  for (const Part& part : covered) {
    if (part.from > reached + least) rest.push_back({reached, part.from});
    reached = std::max(reached, part.to);
  }
  if (reached < 1 - least) rest.push_back({reached, 1});
  return rest;
}

Dot between(const Dot& p, const Dot& q, double share) { return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}; }

}  // namespace

mpq_class largest(const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); }

Triple unit_vector(const Point& v) { return normalised(rounded(shortened(v))); }

Point exact_point(const Triple& v) { return {exact_value(v.x), exact_value(v.y), exact_value(v.z)}; }

View::View(const Point& along, const std::optional<Point>& second, std::span<const Point> edges) {
  constexpr double hardly = 1e-3;  // below this sine the second direction makes no visible difference
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

void Bounds2::add(const Spot& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

void Bounds2::add(const Bounds2& box) {
  add(box.low);
  add(box.high);
}

Bounds2 Bounds2::plus(const Bounds2& box) const {
  return {{mpq_class(low.x + box.low.x), mpq_class(low.y + box.low.y)},
          {mpq_class(high.x + box.high.x), mpq_class(high.y + box.high.y)}};
}

Window Window::around(const View& view, const Bounds2& box, const PixelSize& size) {
  const mpq_class width = box.width(), height = box.height();
  const mpq_class across = static_cast<long>(size.width) - 2 * margin,
                  down = static_cast<long>(size.height) - 2 * margin - strip;
  const Spot middle{mpq_class((box.low.x + box.high.x) / 2), mpq_class((box.low.y + box.high.y) / 2)};
  Spot scale{1, 1};
  if (width > 0) scale.x = across / width;
  if (height > 0) scale.y = down / height;
  const bool apart = width > 0 && height > 0 && (width > much_longer * height || height > much_longer * width);
  if (width == 0) scale.x = scale.y;
  else if (height == 0) scale.y = scale.x;
  else if (!apart) scale.x = scale.y = std::min(scale.x, scale.y);
  return {view, middle, scale, size};
}

Window Window::close(const View& view, const Spot& centre, const mpq_class& scale, const PixelSize& size) {
  return {view, centre, {scale, scale}, size};
}

Spot Window::pixels(const Point& p) const {
  const Spot at = view_->place(p);
  const mpq_class right = (at.x - middle_.x) * scale_.x, up = (at.y - middle_.y) * scale_.y;
  return {mpq_class(size_.width / 2 + right), mpq_class((size_.height - strip) / 2 - up)};
}

Dot Window::dot(const Point& p) const { return rounded(pixels(p)); }

Dot Window::shift(const Point& v) const {
  const Spot at = view_->place(v);
  return {mpq_class(at.x * scale_.x).get_d(), -mpq_class(at.y * scale_.y).get_d()};
}

std::vector<Dot> Window::cut(std::vector<Dot> dots, bool closed) const {
  return clipped(std::move(dots), closed, Dot{-size_.width, -size_.height}, Dot{2 * size_.width, 2 * size_.height});
}

std::vector<Dot> Window::cut(std::vector<Spot> places, bool closed) const {
  std::vector<Dot> dots;
  for (const Spot& p : places) dots.push_back(rounded(p));
  if (std::ranges::all_of(dots, is_safe)) return cut(closed ? outline(std::move(dots)) : std::move(dots), closed);
  if (closed) places = outline(std::move(places));
  dots.clear();
  const Spot low{mpq_class(-size_.width), mpq_class(-size_.height)},
      high{mpq_class(2 * size_.width), mpq_class(2 * size_.height)};
  for (const Spot& p : clipped(std::move(places), closed, low, high)) dots.push_back(rounded(p));
  return dots;
}

std::vector<Dot> Window::segment(const Point& from, const Point& to) const {
  return cut({pixels(from), pixels(to)}, false);
}

std::vector<Dot> Window::hull(const std::vector<Point>& points, const Point& by) const {
  std::vector<Spot> places;
  places.reserve(points.size());
  for (const Point& p : points) places.push_back(pixels(p + by));
  return cut(std::move(places), true);
}

std::string path_data(const std::vector<Dot>& dots, bool closed) {
  std::string result, last;
  for (const Dot& d : dots) {
    std::string at = number(d.x) + " " + number(d.y);
    if (at == last) continue;
    result += (result.empty() ? "M" : "L") + at;
    last = std::move(at);
  }
  if (!result.empty() && dots.size() > 1 && result.find('L') == std::string::npos)
    result += "L" + last;  // a dot, drawn by the round ends of its line
  return result.empty() || !closed ? result : result + "Z";
}

RoundLength round_length(const mpq_class& most) {
  const long exponent = exponent_of(most);
  const mpq_class power = power_of_ten(exponent);
  unsigned long digit = 1;
  for (const unsigned long greater : {2UL, 5UL})
    if (greater * power <= most) digit = greater;
  return {mpq_class(digit * power), text_of(digit, exponent)};
}

std::vector<std::pair<Dot, Dot>> united_outline(const std::vector<std::vector<Dot>>& polygons) {
  constexpr double beside =
      0.05;  // pixels: where a side is asked about, just outside its polygon, as its neighbour over a seam is there
  std::vector<std::pair<Dot, Dot>> result;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const std::vector<Dot>& own = polygons[k];
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Dot &p = own[i], &q = own[(i + 1) % own.size()];
      const double right = q.x - p.x, up = q.y - p.y, length = std::hypot(right, up);
      if (!(length > 0)) continue;
      const Dot out{beside * up / length, -beside * right / length};
      const Dot r{p.x + out.x, p.y + out.y}, s{q.x + out.x, q.y + out.y};
      std::vector<Part> covered;
      for (std::size_t other = 0; other < polygons.size(); ++other) {
        if (other == k || polygons[other].size() < 3) continue;
        const Part part = part_inside(r, s, polygons[other]);
        if (part.from < part.to) covered.push_back(part);
      }
      for (const Part& part : rest_of(std::move(covered)))
        result.emplace_back(between(p, q, part.from), between(p, q, part.to));
    }
  }
  return result;
}

std::vector<Dot> clipped(std::vector<Dot> path, bool closed, const Dot& low, const Dot& high) {
  if (!std::ranges::all_of(path, [](const Dot& d) { return std::isfinite(d.x) && std::isfinite(d.y); })) return {};
  return inside_box(std::move(path), closed, low, high);
}

std::vector<Spot> clipped(std::vector<Spot> path, bool closed, const Spot& low, const Spot& high) {
  return inside_box(std::move(path), closed, low, high);
}

std::vector<Dot> beside(const std::vector<Dot>& polygon, const Dot& on, const Dot& along) {
  return half(polygon, true, [&](const Dot& p) { return along.x * (p.y - on.y) - along.y * (p.x - on.x); });
}

std::vector<Dot> outline(std::vector<Dot> dots) { return around(std::move(dots)); }
std::vector<Spot> outline(std::vector<Spot> places) { return around(std::move(places)); }

}  // namespace fathom::picture
