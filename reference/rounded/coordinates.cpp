// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rounded/coordinates.hpp"

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"

namespace fathom::rounded {
namespace {

/// from + length n/|n|.
Coordinates beyond(const Point& from, const mpq_class& length, const Vector& n) {
  const mpz_class factor = length.get_num() * abs(length.get_num()),
                  divisor = length.get_den() * length.get_den() * dot(n, n);
  const auto coordinate = [&](const mpq_class& start, const mpz_class& n_i) {
    if (sgn(length) == 0 || sgn(n_i) == 0) return Surd{start, 0};
    return Surd{start, kernels::ratio(factor * n_i * abs(n_i), divisor)};
  };
  return {coordinate(from.x, n.x), coordinate(from.y, n.y), coordinate(from.z, n.z)};
}

/// length n/|n|, if that is rational.
std::optional<Point> along(const Vector& n, const mpq_class& length) {
  if (length == 0) return Point{};
  const std::optional<mpq_class> size = kernels::rational_root(mpq_class(dot(n, n)));
  return size ? std::optional((length / *size) * n) : std::nullopt;
}

double nearest(const Surd& value) {
  return sgn(value.root) == 0 ? round_binary64(value.rational) : round_binary64(value);
}

}  // namespace

Coordinates coordinates(const Point& p) { return {Surd{p.x, 0}, Surd{p.y, 0}, Surd{p.z, 0}}; }

Coordinates coordinates(const AlongNormal& vector) {
  return beyond(vector.alpha * vector.normal, vector.beta, vector.normal);
}

Coordinates coordinates(const RoundedPoint& point) { return beyond(point.core, point.distance, point.normal); }

Coordinates unit(const Vector& n) { return beyond({}, 1, n); }

CoordinatePair coordinates(const Witness& witness) { return {coordinates(witness.a), coordinates(witness.b)}; }
CoordinatePair coordinates(const RoundedWitness& witness) { return {coordinates(witness.a), coordinates(witness.b)}; }

std::array<double, 3> nearest_binary64(const Coordinates& values) {
  return {nearest(values[0]), nearest(values[1]), nearest(values[2])};
}

std::array<double, 3> nearest_binary64(const Point& p) {
  return {round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)};
}

std::array<double, 3> nearest_binary64(const AlongNormal& vector) { return nearest_binary64(coordinates(vector)); }
std::array<double, 3> nearest_binary64(const RoundedPoint& point) { return nearest_binary64(coordinates(point)); }

std::array<double, 3> nearest_unit(const Vector& n) {
  const mpz_class square = dot(n, n);
  const auto rounded = [&square](const mpz_class& c) {
    const double size = root_binary64(mpq_class(mpz_class(c * c), square));
    return sgn(c) < 0 ? -size : size;
  };
  return {rounded(n.x), rounded(n.y), rounded(n.z)};
}

std::optional<Point> rational_point(const AlongNormal& vector) {
  const std::optional<Point> rest = along(vector.normal, vector.beta);
  return rest ? std::optional(vector.alpha * vector.normal + *rest) : std::nullopt;
}

std::optional<Point> rational_point(const RoundedPoint& point) {
  const std::optional<Point> rest = along(point.normal, point.distance);
  return rest ? std::optional(point.core + *rest) : std::nullopt;
}

}  // namespace fathom::rounded
