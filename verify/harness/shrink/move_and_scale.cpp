// SPDX-License-Identifier: GPL-3.0-or-later
// Passes that move bodies to the origin and scale them by powers of two.
#include <algorithm>
#include <optional>
#include <utility>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/shrink/passes.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t vertices_tried = 8;
constexpr auto axes = {&Point::x, &Point::y, &Point::z};

/// Corners and centres of the box of all points, and their mean.
std::vector<Point> centres(const Case& pair) {
  std::vector<Point> points = pair.a.points;
  points.insert(points.end(), pair.b.points.begin(), pair.b.points.end());
  Point low, middle, mean;
  for (const auto axis : axes) {
    const auto less = [axis](const Point& p, const Point& q) { return p.*axis < q.*axis; };
    const auto [least, most] = std::ranges::minmax_element(points, less);
    low.*axis = (*least).*axis;
    middle.*axis = ((*least).*axis + (*most).*axis) / 2;
    for (const Point& p : points) mean.*axis += p.*axis;
    mean.*axis /= static_cast<unsigned long>(points.size());
  }
  return {low, middle, mean};
}

/// The case moved by -to. What is not exact is rounded.
std::optional<Case> moved(Case pair, const Point& to, Precision precision) {
  for (Body* body : {&pair.a, &pair.b})
    for (Point& p : body->points.edit())
      for (const auto axis : axes) {
        const std::optional<mpq_class> value = rounded(mpq_class(p.*axis - to.*axis), precision);
        if (!value) return std::nullopt;
        p.*axis = *value;
      }
  return pair;
}

}  // namespace

void move_to_origin(Search& search) {
  const Case before = search.best();
  std::vector<Point> places = centres(before);
  for (const Body* body : {&before.a, &before.b})
    for (std::size_t i = 0; i < std::min(body->points.size(), vertices_tried); ++i) places.push_back(body->points[i]);
  // On one axis at a time as well: a case may need its place along another.
  for (const Point& place : places) {
    if (std::optional<Case> candidate = moved(before, place, search.precision())) search.offer(*std::move(candidate));
    for (const auto axis : axes) {
      Point along;
      along.*axis = place.*axis;
      if (std::optional<Case> candidate = moved(search.best(), along, search.precision())) search.offer(*std::move(candidate));
    }
  }
}

void rescale(Search& search) {
  const mpq_class largest = largest_coordinate(search.best());
  if (largest == 0) return;
  std::optional<long> finest;
  for_each_coordinate(search.best(), [&](const mpq_class& value) {
    if (value != 0) finest = std::min(finest.value_or(lowest_bit(value)), lowest_bit(value));
  });
  for (const long exponent : {-*finest, -exponent_of(largest)}) {
    Case candidate = search.best();
    for_each_coordinate(candidate, [&](mpq_class& value) { value = scaled(value, exponent); });
    search.offer(std::move(candidate));
  }
}

}  // namespace fathom::harness
