// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding everything at once keeps shapes roughly as they are; replacing one value wherever it occurs keeps coplanar faces coplanar.
#include <algorithm>
#include <utility>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/shrink/passes.hpp"
#include "verify/harness/shrink/search.hpp"

namespace fathom::harness {
namespace {

constexpr auto axes = {&Point::x, &Point::y, &Point::z};
constexpr long integer_extents[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 30, 50, 100, 200, 500, 1000};
constexpr long grid_bits[] = {0, 1, 2, 3, 4, 6, 8, 11, 14, 18, 23, 30, 40};

/// The coarsest of the small integer grids on which the verdict persists.
void round_to_integers(Search& search) {
  const Case before = search.best();
  const mpq_class largest = largest_coordinate(before);
  if (largest == 0) return;
  for (const long size : integer_extents) {
    Case candidate = before;
    for_each_coordinate(candidate, [&](mpq_class& value) { value = nearest_integer(value * size / largest); });
    if (search.over() || search.offer(std::move(candidate))) return;
  }
}

/// The coarsest grid of a power of two, of the whole case or of one body, or on one axis alone.
void round_to_grids(Search& search, std::vector<Body Case::*> bodies, std::vector<mpq_class Point::*> chosen) {
  const Case before = search.best();
  const mpq_class largest = largest_coordinate(before);
  if (largest == 0) return;
  const long top = exponent_of(largest);
  for (const long bits : grid_bits) {
    Case candidate = before;
    for (Body Case::*body : bodies)
      for (Point& p : (candidate.*body).points.edit())
        for (mpq_class Point::*axis : chosen) p.*axis = to_multiple(p.*axis, top - bits);
    if (search.over() || search.offer(std::move(candidate))) return;
  }
}

/// All values on the axis, the dearest first.
std::vector<mpq_class> values_on(const Case& pair, mpq_class Point::*axis) {
  std::vector<mpq_class> values;
  for (const Body* body : {&pair.a, &pair.b})
    for (const Point& p : body->points) values.push_back(p.*axis);
  std::ranges::sort(values, [](const mpq_class& p, const mpq_class& q) {
    const std::size_t left = cost(p), right = cost(q);
    return left != right ? left > right : p < q;
  });
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Replacements for `value`: simpler numbers, and those of the axis next to it on both sides.
std::vector<mpq_class> replacements(const mpq_class& value, const std::vector<mpq_class>& on_axis) {
  std::vector<mpq_class> result = simpler(value);
  const mpq_class *below = nullptr, *above = nullptr;
  for (const mpq_class& other : on_axis) {
    if (other < value && (!below || other > *below)) below = &other;
    if (other > value && (!above || other < *above)) above = &other;
  }
  for (const mpq_class* near : {below, above})
    if (near && cost(*near) <= cost(value)) result.push_back(*near);
  return result;
}

void simplify_everywhere(Search& search, mpq_class Point::*axis) {
  const std::vector<mpq_class> values = values_on(search.best(), axis);
  for (const mpq_class& value : values)
    for (const mpq_class& other : replacements(value, values)) {
      Case candidate = search.best();
      for (Body* body : {&candidate.a, &candidate.b})
        for (Point& p : body->points.edit())
          if (p.*axis == value) p.*axis = other;
      if (search.over() || search.offer(std::move(candidate))) break;
    }
}

void simplify_singly(Search& search, Body Case::*body, mpq_class Point::*axis) {
  for (std::size_t i = 0; i < (search.best().*body).points.size(); ++i) {
    const mpq_class value = (search.best().*body).points[i].*axis;
    for (const mpq_class& other : replacements(value, values_on(search.best(), axis))) {
      Case candidate = search.best();
      (candidate.*body).points.edit()[i].*axis = other;
      if (search.over() || search.offer(std::move(candidate))) break;
    }
  }
}

}  // namespace

void round_together(Search& search) {
  round_to_integers(search);
  round_to_grids(search, {&Case::a, &Case::b}, axes);
  for (Body Case::*body : {&Case::a, &Case::b}) round_to_grids(search, {body}, axes);
  for (mpq_class Point::*axis : axes) round_to_grids(search, {&Case::a, &Case::b}, {axis});
}

void simplify_values(Search& search) {
  for (mpq_class Point::*axis : axes) simplify_everywhere(search, axis);
  for (Body Case::*body : {&Case::a, &Case::b})
    for (mpq_class Point::*axis : axes) simplify_singly(search, body, axis);
}

}  // namespace fathom::harness
