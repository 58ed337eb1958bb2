// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/surd_output.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/output/answer_output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/json_values.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/surd.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t beyond_binary64_digits = 17;

std::optional<mpq_class> rational_square(const Surd& value) {
  if (value.rational == 0) return abs(value.root);
  const std::optional<mpq_class> number = kernels::rational_value(value);
  return number ? std::optional<mpq_class>(*number * *number) : std::nullopt;
}

template <class Float>
Json in_every_direction(const Surd& value, Float (*round)(const Surd&, Rounding)) {
  return {{"rn", Json::plain(hex_text(round(value, Rounding::rn)))},
          {"rd", Json::plain(hex_text(round(value, Rounding::rd)))},
          {"ru", Json::plain(hex_text(round(value, Rounding::ru)))}};
}

}  // namespace

std::string surd_text(const Surd& value) {
  if (sign(value) == 0) return "0";
  if (const double rounded = round_binary64(value); std::isfinite(rounded) && rounded != 0) return fmt::format("{}", rounded);
  return enclose(value, beyond_binary64_digits).low;
}

Json surd_length(const Surd& value, const std::optional<unsigned>& digits) {
  const std::optional<mpq_class> square = rational_square(value);
  if (square) return length(*square, digits);
  const double nearest = round_binary64(value);
  Json result = {
      {"squared", Json()},
      {"value", std::isfinite(nearest) && nearest != 0 ? Json(nearest) : Json()},
      {"rounded", {{"f64", in_every_direction<double>(value, round_binary64)}, {"f32", in_every_direction<float>(value, round_binary32)}}}};
  if (digits) {
    const Enclosure enclosure = enclose(value, *digits);
    result["enclosure"] = Json::array({enclosure.low, enclosure.high});
  }
  return result;
}

Json exact_object(const Surd& value) {
  return {{"sign", sgn(value.root)}, {"root", Json::plain(exact_text(abs(value.root)))}, {"plus", Json::plain(exact_text(value.rational))}};
}

Json signed_depth_object(const SignedDepth& depth) {
  Json result = signed_depth_object({depth.low_binary64(), depth.high_binary64()});
  if (depth.exact()) result["exact"] = exact_object(*depth.exact());
  return result;
}

Json vector_object(const AlongNormal& vector) {
  if (const std::optional<Point> point = rational_point(vector)) return exact(*point);
  return {
      {"normal", exact(vector.normal)}, {"alpha", Json::plain(exact_text(vector.alpha))}, {"beta", Json::plain(exact_text(vector.beta))}};
}

Json point_object(const RoundedPoint& point) {
  if (const std::optional<Point> place = rational_point(point)) return exact(*place);
  return {{"core", exact(point.core)}, {"normal", exact(point.normal)}, {"distance", Json::plain(exact_text(point.distance))}};
}

}  // namespace fathom::cli
