// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"
#include "view/picture/polygon.hpp"

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

/// Unit vectors, so that no facet of a box that stands along the axes is seen from its edge, nor
/// two of its edges behind one another. From above, the first first.
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

/// How much of the edge that is seen least is seen if `up` points up: from 0, end on, to 1. What
/// lies along the way counts not.
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

constexpr int margin = 22;           // pixels
constexpr int strip = 18;            // pixels below, where the scale bar stands
constexpr int much_longer = 100;     // the axes are scaled apart beyond this ratio
constexpr double safe_pixels = 1e6;  // within these, doubles are exact enough for tenths of pixels

Dot rounded(const Spot& p) { return {p.x.get_d(), p.y.get_d()}; }
bool is_safe(const Dot& d) { return std::abs(d.x) <= safe_pixels && std::abs(d.y) <= safe_pixels; }

/// "1.5", "-0" never.
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

/// The greatest power of ten that is not above x > 0.
long exponent_of(const mpq_class& x) {
  const auto digits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 10)); };
  long result = digits(x.get_num()) - digits(x.get_den()) + 1;  // or up to 3 less
  while (power_of_ten(result) > x) --result;
  return result;
}

std::string text_of(unsigned long digit, long exponent) {
  if (exponent > 4 || exponent < -4) return fmt::format("{}e{}", digit, exponent);
  if (exponent >= 0) return fmt::format("{}{}", digit, std::string(static_cast<std::size_t>(exponent), '0'));
  return fmt::format("0.{}{}", std::string(static_cast<std::size_t>(-exponent - 1), '0'), digit);
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
    result += "L" + last;  // a dot, by its round ends
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

}  // namespace fathom::picture
