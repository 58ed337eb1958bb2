// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"

namespace fathom::harness {
namespace {

/// Replaces names by the plain ones, without "rounded_", and removes margins of 0.
void make_plain(files::NamedBody& words) {
  words.shape = files::named_shape(words.shape).shape->name;
  const auto margin = words.fields.numbers.find("margin");
  if (margin != words.fields.numbers.end() && margin->second.front() == 0) words.fields.numbers.erase(margin);
  for (files::NamedBody& term : words.terms) make_plain(term);
}

}  // namespace

long exponent_of(const mpq_class& value) {
  const long guess = kernels::binary_order(value);
  return abs(value) < scaled(1, guess) ? guess - 1 : guess;
}

long lowest_bit(const mpq_class& value) {
  if (value.get_den() != 1) return 1 - kernels::bit_length(value.get_den());
  return static_cast<long>(mpz_scan1(value.get_num_mpz_t(), 0));
}

std::optional<mpq_class> rounded(const mpq_class& value, const NumberFormat& format) {
  const mpq_class there = scaled(value, format.exponent);
  const double nearest = format.points == Precision::binary32 ? static_cast<double>(round_binary32(there, Rounding::rn))
                                                              : round_binary64(there, Rounding::rn);
  if (!std::isfinite(nearest)) return std::nullopt;
  return scaled(exact_value(nearest), -format.exponent);
}

void for_each_length(files::NamedBody& words, const std::function<void(mpq_class&)>& use) {
  for (auto& [name, values] : words.fields.numbers)
    if (name != "normal")
      for (mpq_class& value : values) use(value);
  for (Point& p : words.fields.vertices)
    for (mpq_class* value : {&p.x, &p.y, &p.z}) use(*value);
  for (std::size_t axis = 0; axis < 3; ++axis) use(place_along(words, axis));
  for (files::NamedBody& term : words.terms) for_each_length(term, use);
}

void for_each_slope(files::NamedBody& words, const std::function<void(mpq_class&)>& use) {
  if (words.matrix) {
    for (auto& row : *words.matrix)
      for (std::size_t k = 0; k < 3; ++k) use(row[k]);
  } else {
    for (mpq_class* value : {&words.turn.w, &words.turn.x, &words.turn.y, &words.turn.z}) use(*value);
  }
  if (const auto normal = words.fields.numbers.find("normal"); normal != words.fields.numbers.end())
    for (mpq_class& value : normal->second) use(value);
  for (files::NamedBody& term : words.terms) for_each_slope(term, use);
}

mpq_class& place_along(files::NamedBody& words, std::size_t axis) {
  if (words.matrix) return (*words.matrix)[axis][3];
  return axis == 0 ? words.place.x : axis == 1 ? words.place.y : words.place.z;
}

std::optional<files::NamedBody> rounded(files::NamedBody words, const NumberFormat& format) {
  bool fits = true;
  const auto rounding_to = [&fits](const NumberFormat& to) {
    return [&fits, to](mpq_class& value) {
      const std::optional<mpq_class> nearest = rounded(value, to);
      fits = fits && nearest;
      if (nearest) value = *nearest;
    };
  };
  for_each_length(words, rounding_to(format));
  for_each_slope(words, rounding_to(format.points));
  make_plain(words);
  return fits ? std::optional(std::move(words)) : std::nullopt;
}

std::optional<Motion> rounded(Motion motion, const NumberFormat& format) {
  bool fits = true;
  const auto round = [&fits](Point& p, const NumberFormat& to) {
    for (const auto axis : axes) {
      const std::optional<mpq_class> nearest = rounded(p.*axis, to);
      fits = fits && nearest;
      if (nearest) p.*axis = *nearest;
    }
  };
  for (Twist* twist : {&motion.of_a, &motion.of_b}) round(twist->v, format), round(twist->w, format.points);
  return fits ? std::optional(std::move(motion)) : std::nullopt;
}

bool representable(const mpq_class& value, const NumberFormat& format) { return rounded(value, format) == value; }

std::vector<Point> core_of(const Body& body) { return files::points_of(*body.shape).value_or(std::vector<Point>()); }

Case in_unit(Case pair, long exponent) {
  if (exponent == 0) return pair;
  if (pair.motion)
    for (Twist* twist : {&pair.motion->of_a, &pair.motion->of_b})
      for (const auto axis : axes) twist->v.*axis = scaled(twist->v.*axis, exponent);
  for (Body* body : {&pair.a, &pair.b}) {
    if (body->pieces || (body->dimension == 2 && body->shape)) {
      if (body->shape) body->shape->radius = scaled(body->shape->radius, exponent);
      for_each_hull(*body,
                    [&](std::vector<Point>& points) { points = scaled(GivenPoints(std::move(points)), exponent); });
      continue;
    }
    if (!body->words) {
      body->points = scaled(body->points, exponent);
      continue;
    }
    files::NamedBody words = *body->words;
    for_each_length(words, [&](mpq_class& value) { value = scaled(value, exponent); });
    *body = files::body_of(std::move(words));
  }
  return pair;
}

Reply in_unit(Reply reply, long exponent) {
  const auto scale = [exponent](double& x) { x = std::ldexp(x, static_cast<int>(exponent)); };
  for (std::optional<double>* length : {&reply.depth, &reply.distance, &reply.derivative})
    if (*length) scale(**length);
  for (std::optional<Triple>* point : {&reply.witness_a, &reply.witness_b})
    if (*point) std::ranges::for_each(**point, scale);
  for (ContactPoint& contact : reply.contacts) {
    std::ranges::for_each(contact.position, scale);
    if (contact.depth) scale(*contact.depth);
  }
  return reply;
}

mpq_class largest_coordinate(const Case& pair) {
  mpq_class largest = 0;
  for_each_coordinate(pair, [&](const mpq_class& value) { largest = std::max(largest, mpq_class(abs(value))); });
  return largest;
}

}  // namespace fathom::harness
