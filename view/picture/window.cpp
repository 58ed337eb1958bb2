// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picture/polygon.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

constexpr int margin = 22;           // pixels
constexpr int strip = 18;            // pixels below, where the scale bar stands
constexpr int much_longer = 100;     // the axes are scaled apart beyond this ratio
constexpr double safe_pixels = 1e6;  // within these, doubles are exact enough for tenths of pixels

Dot rounded(const Spot& p) { return {p.x.get_d(), p.y.get_d()}; }
bool is_safe(const Dot& d) { return std::abs(d.x) <= safe_pixels && std::abs(d.y) <= safe_pixels; }

/// "1.5", "-0" never.
std::string number(double x) {
  const std::string text = fmt::format("{:.1f}", x);
  const std::string_view shown = text.ends_with(".0") ? std::string_view(text).substr(0, text.size() - 2) : std::string_view(text);
  return std::string(shown == "-0" ? "0" : shown);
}

}  // namespace

void Bounds2::add(const Spot& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

void Bounds2::add(const Bounds2& box) {
  add(box.low);
  add(box.high);
}

Bounds2 Bounds2::plus(const Bounds2& box) const {
  return {{mpq_class(low.x + box.low.x), mpq_class(low.y + box.low.y)}, {mpq_class(high.x + box.high.x), mpq_class(high.y + box.high.y)}};
}

Window Window::around(const View& view, const Bounds2& box, const PixelSize& size) {
  const mpq_class width = box.width(), height = box.height();
  const mpq_class across = static_cast<long>(size.width) - 2 * margin, down = static_cast<long>(size.height) - 2 * margin - strip;
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
  const Spot low{mpq_class(-size_.width), mpq_class(-size_.height)}, high{mpq_class(2 * size_.width), mpq_class(2 * size_.height)};
  for (const Spot& p : clipped(std::move(places), closed, low, high)) dots.push_back(rounded(p));
  return dots;
}

std::vector<Dot> Window::segment(const Point& from, const Point& to) const { return cut({pixels(from), pixels(to)}, false); }

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
  if (!result.empty() && dots.size() > 1 && result.find('L') == std::string::npos) result += "L" + last;  // a dot, by its round ends
  return result.empty() || !closed ? result : result + "Z";
}

}  // namespace fathom::picture
