// SPDX-License-Identifier: GPL-3.0-or-later
// Every symmetry keeps the points exact, or it is not applied: so the depth of a variant is known from that of the case, by the law.
#include "verify/harness/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "verify/families/random.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

constexpr long exponents[] = {10, -10, 3, -3, 1, -1};  // of scale, in the order in which they are tried
constexpr long bulky = 20;                             // coordinates from 2^bulky on are made smaller rather than larger
constexpr std::uint64_t seed = 7;                      // of all permutations

constexpr std::array axes = {&Point::x, &Point::y, &Point::z};

/// The coordinates of points; of a body that has words, of its place.
template <class Fits>
bool all_coordinates(const Case& pair, std::size_t axis, Fits fits) {
  for (const Body* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      if (!fits(place_along(words, axis))) return false;
      continue;
    }
    bool all = true;
    for_each_hull(*body, [&](const std::vector<Point>& points) {
      for (const Point& p : points) all = all && fits(p.*axes[axis]);
    });
    if (!all) return false;
  }
  return true;
}

/// A power of two, or its negative, that can be added to all coordinates on this axis: the largest up to eight times the largest of them.
std::optional<mpq_class> shift(const Case& pair, std::size_t axis, const NumberFormat& format) {
  mpq_class largest = 0;
  std::optional<long> finest;
  all_coordinates(pair, axis, [&](const mpq_class& value) {
    largest = std::max(largest, mpq_class(abs(value)));
    if (value != 0) finest = std::min(finest.value_or(lowest_bit(value)), lowest_bit(value));
    return true;
  });
  if (!finest) return scaled(1, -format.exponent);
  const long highest = exponent_of(largest) + 3;
  for (long exponent = highest; exponent >= *finest && exponent > highest - 64; --exponent)
    for (const int sign : {1, -1}) {
      const mpq_class step = scaled(sign, exponent);
      if (all_coordinates(pair, axis, [&](const mpq_class& value) { return representable(value + step, format); })) return step;
    }
  return std::nullopt;
}

std::optional<Variant> swapped(Variant variant) {
  std::swap(variant.seen.a, variant.seen.b);
  variant.swapped = true;
  return variant;
}

std::optional<Variant> translated(Variant variant) {
  const Case original = variant.seen;
  bool moved = false;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (const std::optional<mpq_class> step = shift(original, axis, variant.format)) {
      moved = true;
      for (Body* body : {&variant.seen.a, &variant.seen.b}) {
        if (body->words) {
          files::NamedBody words = *body->words;
          place_along(words, axis) += *step;
          *body = files::body_of(std::move(words));
        } else {
          for_each_hull(*body, [&](std::vector<Point>& points) {
            for (Point& p : points) p.*axes[axis] += *step;
          });
        }
      }
    }
  return moved ? std::optional(variant) : std::nullopt;
}

bool shuffle(std::vector<Point>& points, families::Random& random) {
  const std::vector<Point> original = points;
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1))]);
  if (points == original) std::rotate(points.begin(), points.begin() + (points.size() > 1 ? 1 : 0), points.end());
  return points != original;
}

bool shuffle(Body& body, families::Random& random) {
  if (!body.words) {
    bool other = false;
    for_each_hull(body, [&](std::vector<Point>& points) { other = shuffle(points, random) || other; });
    return other;
  }
  files::NamedBody words = *body.words;
  const bool other = shuffle(words.fields.vertices, random);
  if (other) body = files::body_of(std::move(words));
  return other;
}

std::optional<Variant> permuted(Variant variant) {
  families::Random random(seed);
  const bool a = shuffle(variant.seen.a, random), b = shuffle(variant.seen.b, random);
  return a || b ? std::optional(variant) : std::nullopt;
}

std::optional<Variant> rescaled(Variant variant) {
  const mpq_class largest = largest_coordinate(variant.seen);
  if (largest == 0) return std::nullopt;
  const long sign = exponent_of(largest) + variant.format.exponent >= bulky ? -1 : 1;
  for (const long size : exponents) {
    const long exponent = sign * size;
    bool exact = true;
    for_each_coordinate(std::as_const(variant.seen),
                        [&](const mpq_class& value) { exact = exact && representable(scaled(value, exponent), variant.format); });
    if (!exact) continue;
    for_each_coordinate(variant.seen, [&](mpq_class& value) { value = scaled(value, exponent); });
    variant.exponent = exponent;
    return variant;
  }
  return std::nullopt;
}

std::optional<Variant> made(std::string_view name, const Case& as_seen, const NumberFormat& format) {
  Variant variant{std::string(name), as_seen, false, 0, format};
  if (name == "swap") return swapped(std::move(variant));
  if (name == "translate") return translated(std::move(variant));
  if (name == "permute") return permuted(std::move(variant));
  if (name == "scale") return rescaled(std::move(variant));
  return variant;  // once more
}

}  // namespace

std::vector<Variant> variants(const Case& as_seen, const NumberFormat& format, std::span<const std::string> names,
                              std::vector<std::string>* left_out) {
  std::vector<Variant> result;
  for (const std::string_view name : variant_names) {
    if (std::ranges::find(names, name) == names.end()) continue;
    if (std::optional<Variant> variant = made(name, as_seen, format)) result.push_back(*std::move(variant));
    else if (left_out)
      left_out->push_back(
          fmt::format("no {} other than the case itself keeps its coordinates exact in {}", name, fathom::name(format.points)));
  }
  return result;
}

mpq_class depth_squared_of(const Variant& variant, const mpq_class& of_original) { return scaled(of_original, 2 * variant.exponent); }

Examine examine_variant(ExamineInUnit examine, std::string name, NumberFormat format, Tolerance tolerance, std::optional<mpq_class> fit) {
  return [=](const Case& pair) {
    const std::string names[] = {name};
    const long exponent = exponent_to_fit(pair, fit);
    const Outcome original = examine(pair, exponent);
    const std::vector<Variant> found = variants(pair, in_unit(format, exponent), names);
    return found.empty() ? original : compare_variant(original, examine(found.front().seen, exponent), found.front(), tolerance);
  };
}

}  // namespace fathom::harness
