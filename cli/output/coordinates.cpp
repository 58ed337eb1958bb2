// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/output/surd_output.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/surd.hpp"
#include "kernels/vector.hpp"

namespace fathom::cli {
namespace {

/// from + length n/|n|.
Coordinates beyond(const Point& from, const mpq_class& length, const Vector& n) {
  const mpz_class square = dot(n, n);
  const auto coordinate = [&](const mpq_class& start, const mpz_class& n_i) {
    if (sgn(length) == 0 || sgn(n_i) == 0) return Surd{start, 0};
    const mpq_class along = length * n_i;
    return Surd{start, mpq_class(along * abs(along) / square)};
  };
  return {coordinate(from.x, n.x), coordinate(from.y, n.y), coordinate(from.z, n.z)};
}

Point scaled(const Vector& n, const mpq_class& factor) { return {factor * n.x, factor * n.y, factor * n.z}; }

Point sum(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }

/// length n/|n|, if that is rational.
std::optional<Point> along(const Vector& n, const mpq_class& length) {
  if (length == 0) return Point{};
  const std::optional<mpq_class> size = kernels::rational_root(mpq_class(dot(n, n)));
  return size ? std::optional(scaled(n, length / *size)) : std::nullopt;
}

double nearest(const Surd& value) { return sgn(value.root) == 0 ? round_binary64(value.rational) : round_binary64(value); }

std::string decimal(const Surd& value) { return sign(value) < 0 ? "-" + surd_text({-value.rational, -value.root}) : surd_text(value); }

std::string in_full(const Point& p) { return fmt::format("({}, {}, {})", exact_text(p.x), exact_text(p.y), exact_text(p.z)); }
std::string in_full(const Vector& n) { return fmt::format("({}, {}, {})", n.x.get_str(), n.y.get_str(), n.z.get_str()); }

std::string in_full(const Point& from, const mpq_class& length, const Vector& n) {
  if (const std::optional<Point> rest = along(n, length)) return in_full(sum(from, *rest));
  return fmt::format("{} and {} along {}", in_full(from), exact_text(length), in_full(n));
}

}  // namespace

Coordinates coordinates(const Point& p) { return {Surd{p.x, 0}, Surd{p.y, 0}, Surd{p.z, 0}}; }

Coordinates coordinates(const AlongNormal& vector) { return beyond(scaled(vector.normal, vector.alpha), vector.beta, vector.normal); }

Coordinates coordinates(const RoundedPoint& point) { return beyond(point.core, point.distance, point.normal); }

Coordinates unit(const Vector& n) { return beyond({}, 1, n); }

CoordinatePair coordinates(const Witness& witness) { return {coordinates(witness.a), coordinates(witness.b)}; }
CoordinatePair coordinates(const RoundedWitness& witness) { return {coordinates(witness.a), coordinates(witness.b)}; }

std::optional<Point> rational_point(const AlongNormal& vector) {
  const std::optional<Point> rest = along(vector.normal, vector.beta);
  return rest ? std::optional(sum(scaled(vector.normal, vector.alpha), *rest)) : std::nullopt;
}

std::optional<Point> rational_point(const RoundedPoint& point) {
  const std::optional<Point> rest = along(point.normal, point.distance);
  return rest ? std::optional(sum(point.core, *rest)) : std::nullopt;
}

Json numbers(const Coordinates& values) {
  const std::array rounded = {nearest(values[0]), nearest(values[1]), nearest(values[2])};
  if (!std::ranges::all_of(rounded, [](double x) { return std::isfinite(x); })) return {};
  return Json::array({rounded[0], rounded[1], rounded[2]});
}

void add_rounded(Json& result, const Vector& direction, const std::optional<Coordinates>& translation,
                 const std::optional<CoordinatePair>& witness) {
  result["unit_f64"] = numbers(unit(direction));
  result["translation_f64"] = translation ? numbers(*translation) : Json();
  result["witness_f64"] = witness ? Json{{"a", numbers(witness->front())}, {"b", numbers(witness->back())}} : Json();
}

std::string decimals(const Coordinates& values) {
  return fmt::format("({}, {}, {})", decimal(values[0]), decimal(values[1]), decimal(values[2]));
}

std::string place_text(const Point& p, bool exact) { return exact ? in_full(p) : decimals(coordinates(p)); }

std::string place_text(const AlongNormal& vector, bool exact) {
  return exact ? in_full(scaled(vector.normal, vector.alpha), vector.beta, vector.normal) : decimals(coordinates(vector));
}

std::string place_text(const RoundedPoint& point, bool exact) {
  return exact ? in_full(point.core, point.distance, point.normal) : decimals(coordinates(point));
}

std::string way_text(const Vector& n, bool exact) { return exact ? in_full(n) : decimals(unit(n)); }

}  // namespace fathom::cli
