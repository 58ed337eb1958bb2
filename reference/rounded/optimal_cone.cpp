// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rounded/optimal_cone.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/solve/deciding_points.hpp"

namespace fathom::rounded {
namespace {

// p u + q v, primitive.
Vector combined(const mpz_class& p, const Vector& u, const mpz_class& q, const Vector& v) {
  return primitive({p * u.x + q * v.x, p * u.y + q * v.y, p * u.z + q * v.z});
}

// A point over its common denominator.
struct Fraction {
  mpz_class denominator;
  Vector numerators;
};

Fraction fraction(const Point& p) {
  const mpz_class &x = p.x.get_den(), &y = p.y.get_den(), &z = p.z.get_den();
  if (x == y && y == z) return {x, {p.x.get_num(), p.y.get_num(), p.z.get_num()}};
  const mpz_class unit = lcm(lcm(x, y), z);
  return {unit, {p.x.get_num() * (unit / x), p.y.get_num() * (unit / y), p.z.get_num() * (unit / z)}};
}

// p - q, times both denominators.
Vector between(const Fraction& q, const Fraction& p) {
  const auto along = [&](const mpz_class& to, const mpz_class& from) { return mpz_class(to * q.denominator - from * p.denominator); };
  return {along(p.numerators.x, q.numerators.x), along(p.numerators.y, q.numerators.y), along(p.numerators.z, q.numerators.z)};
}

// One line leaves the lineality: the half of it below g becomes a ray, everything else is moved along it into the plane of g.
void cut_line(ClippedCone& cone, std::size_t i, const Vector& g) {
  Vector ray = std::move(cone.lines[i]);
  cone.lines.erase(cone.lines.begin() + static_cast<std::ptrdiff_t>(i));
  mpz_class below = -dot(g, ray);
  if (below < 0) (below = -below, ray = -ray);
  for (std::vector<Vector>* const all : {&cone.lines, &cone.rays})
    for (Vector& v : *all) v = combined(below, v, dot(g, v), ray);
  cone.rays.push_back(std::move(ray));
}

void cut_rays(ClippedCone& cone, const Vector& g) {
  if (std::all_of(cone.rays.begin(), cone.rays.end(), [&](const Vector& ray) { return dot(g, ray) <= 0; })) return;
  std::vector<mpz_class> height;
  for (const Vector& ray : cone.rays) height.push_back(dot(g, ray));
  std::vector<Vector> kept;
  const std::size_t size = cone.rays.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (height[i] <= 0) kept.push_back(cone.rays[i]);
    const std::size_t next = (i + 1) % size;
    if (size == 2 && next == 0) break;  // two rays are neighbours once
    if (sgn(height[i]) * sgn(height[next]) < 0) kept.push_back(combined(abs(height[next]), cone.rays[i], abs(height[i]), cone.rays[next]));
  }
  cone.rays = std::move(kept);
}

// The greater one of v and -v.
Vector upper(const Vector& v) { return lexicographically_less(v, -v) ? -v : v; }

Vector lower(const Vector& v) { return lexicographically_less(v, -v) ? v : -v; }

// The sign of h(u).
int support_sign(std::span<const Point> a, std::span<const Point> b, const Vector& u) {
  const Point &p = a[solve::extreme_points(a, -u).front()], &q = b[solve::extreme_points(b, u).front()];
  return sgn(mpq_class(u.x * (q.x - p.x) + u.y * (q.y - p.y) + u.z * (q.z - p.z)));
}

}  // namespace

ClippedCone whole_space() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}}; }

void clip(ClippedCone& cone, const Vector& g) {
  for (std::size_t i = 0; i < cone.lines.size(); ++i)
    if (dot(g, cone.lines[i]) != 0) return cut_line(cone, i, g);
  cut_rays(cone, g);
}

OptimalCone canonical(const ClippedCone& cone) {
  OptimalCone result{static_cast<Lineality>(cone.lines.size()), {}, cone.rays};
  if (cone.lines.size() == 1) {
    const Vector& line = result.axis = upper(primitive(cone.lines[0]));
    for (Vector& ray : result.rays) ray = combined(dot(line, line), ray, -dot(ray, line), line);
  }
  if (cone.lines.size() == 2) {
    result.axis = upper(primitive(cross(cone.lines[0], cone.lines[1])));
    for (Vector& ray : result.rays) ray = dot(ray, result.axis) > 0 ? result.axis : -result.axis;
  }
  std::sort(result.rays.begin(), result.rays.end(), lexicographically_less);
  return result;
}

OptimalCone optimal_cone(kernels::Context& context, std::span<const Point> a, std::span<const Point> b, const Point& x) {
  context.report("optimal cone");
  ClippedCone cone = whole_space();
  const Fraction common = fraction(x);
  const auto clip_all = [&](std::span<const Point> points, const auto& generator) {
    for (const Point& p : points) {
      clip(cone, generator(p));
      context.check();
    }
  };
  clip_all(b, [&](const Point& p) { return between(common, fraction(p)); });
  clip_all(a, [&](const Point& p) { return between(fraction(p), common); });
  if (cone.lines.empty() && cone.rays.empty()) throw std::logic_error("no plane separates bodies that touch");
  return canonical(cone);
}

std::vector<Vector> lineality_basis(const OptimalCone& cone) {
  if (cone.lineality == Lineality::all) return whole_space().lines;
  if (cone.lineality == Lineality::line) return {cone.axis};
  std::vector<Vector> basis;
  if (cone.lineality == Lineality::plane) {
    for (const Vector& e : whole_space().lines) {
      const Vector v = primitive(cross(cone.axis, e));
      if (!is_zero(v) && (basis.empty() || (basis.size() == 1 && !is_zero(cross(basis.front(), v))))) basis.push_back(v);
    }
  }
  return basis;
}

kernels::Report validate(const OptimalCone& cone, std::span<const Point> a, std::span<const Point> b) {
  kernels::Report report;
  const bool axis = cone.lineality == Lineality::line || cone.lineality == Lineality::plane;
  report.expect(is_zero(cone.axis) != axis, "an axis of a lineality that has none, or none");
  report.expect(cone.axis == upper(primitive(cone.axis)), "the axis is not canonical");
  report.expect(std::is_sorted(cone.rays.begin(), cone.rays.end(), lexicographically_less), "the rays are not sorted");
  std::vector<Vector> optimal = cone.rays;
  for (const Vector& ray : cone.rays) {
    report.expect(!is_zero(ray) && ray == primitive(ray), "a ray is not primitive");
    if (cone.lineality == Lineality::line) report.expect(dot(ray, cone.axis) == 0, "a ray is not orthogonal to the line");
    if (cone.lineality == Lineality::plane) report.expect(is_zero(cross(ray, cone.axis)), "a ray is not orthogonal to the plane");
  }
  for (const Vector& line : lineality_basis(cone)) optimal.insert(optimal.end(), {line, -line});
  report.expect(!optimal.empty(), "no direction");
  for (const Vector& u : optimal) report.expect(support_sign(a, b, u) == 0, "a plane in an optimal direction does not separate the bodies");
  return report;
}

}  // namespace fathom::rounded

namespace fathom {

Vector OptimalCone::direction() const {
  if (!rays.empty()) return rays.front();
  if (lineality != Lineality::plane) return lineality == Lineality::line ? rounded::lower(axis) : Vector{-1, 0, 0};
  std::optional<Vector> least;
  for (const Vector& e : rounded::whole_space().lines) {
    const Vector v = rounded::lower(primitive(cross(axis, e)));
    if (!is_zero(v) && (!least || lexicographically_less(v, *least))) least = v;
  }
  return *least;
}

}  // namespace fathom
