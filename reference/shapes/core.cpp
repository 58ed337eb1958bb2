// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of a valid shape, whether it is flat, and its support.
#include "reference/shapes/core.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "kernels/float_environment.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::shapes {

namespace {

bool is_origin(const Point& p) { return p == Point{}; }

void require_numbers(const Point& p) {
  for (const mpq_class* x : {&p.x, &p.y, &p.z}) kernels::require_lowest_terms(*x);
}

void require_numbers(const Atom& atom) {
  require_numbers(atom.center);
  for (const Point& axis : atom.axes) require_numbers(axis);
}

void require_axes(const Atom& atom) {
  if (const std::size_t axes = atom.axes.size(); axes != 0 && axes != 2 && axes != 3)
    throw std::invalid_argument("an atom has " + std::to_string(axes) +
                                " axes: a point has none, a disc two, a ball three");
}

// Returns whether it is one hull of points, whose numbers are not looked at.
bool require_core(const std::vector<Term>& terms) {
  if (terms.empty()) throw std::invalid_argument("a shape has no term");
  bool points = terms.size() == 1;
  for (const Term& term : terms) {
    if (term.atoms.empty()) throw std::invalid_argument("a hull of no points was given");
    for (const Atom& atom : term.atoms) {
      require_axes(atom);
      points = points && atom.axes.empty();
    }
  }
  if (points) return true;
  for (const Term& term : terms)
    for (const Atom& atom : term.atoms) require_numbers(atom);
  return false;
}

bool require_core(const HalfSpace& half) {
  require_numbers(half.normal);
  kernels::require_lowest_terms(half.offset);
  if (is_origin(half.normal)) throw std::invalid_argument("the normal of a half-space is 0");
  return false;
}

// The radius of a ball whose axes are orthogonal, of one rational length.
std::optional<mpq_class> round_radius(const Atom& atom) {
  if (atom.axes.size() != 3) return std::nullopt;
  const Point &u = atom.axes[0], &v = atom.axes[1], &w = atom.axes[2];
  const mpq_class square = dot(u, u);
  if (dot(v, v) != square || dot(w, w) != square) return std::nullopt;
  if (dot(u, v) != 0 || dot(v, w) != 0 || dot(w, u) != 0) return std::nullopt;
  return kernels::rational_root(square);
}

using kernels::RationalInterval;

/// <u,center>, and the length of the slopes of u along the axes.
RationalInterval support(const Atom& atom, const Point& u, unsigned bits) {
  mpq_class square = 0;
  for (const Point& axis : atom.axes) {
    const mpq_class slope = dot(u, axis);
    square += slope * slope;
  }
  return kernels::enclosed({dot(u, atom.center), square}, bits);
}

}  // namespace

bool require_all_but_points(const Shape& shape) {
  kernels::require_lowest_terms(shape.radius);
  if (shape.radius < 0) throw std::invalid_argument("the radius of a shape is negative: " + shape.radius.get_str());
  return std::visit([](const auto& core) { return require_core(core); }, shape.core);
}

void require_shape(const Shape& shape) {
  if (!require_all_but_points(shape)) return;
  for (const Atom& atom : std::get<std::vector<Term>>(shape.core).front().atoms) require_numbers(atom);
}

void require_width(const Shape& shape) {
  if (std::holds_alternative<HalfSpace>(shape.core))
    throw std::invalid_argument("a half-space has no width: it is infinite");
}

Shape simplified(Shape shape) {
  auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (terms == nullptr) return shape;
  for (Term& term : *terms) {
    for (Atom& atom : term.atoms)
      if (std::all_of(atom.axes.begin(), atom.axes.end(), is_origin)) atom.axes.clear();
    if (term.atoms.size() != 1) continue;
    Atom& atom = term.atoms.front();
    if (const std::optional<mpq_class> radius = round_radius(atom)) {
      atom.axes.clear();
      shape.radius += *radius;
    }
  }
  return shape;
}

std::optional<std::vector<Point>> polytope_points(const Shape& shape, std::size_t most) {
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (terms == nullptr) return std::nullopt;
  std::size_t count = 1;
  for (const Term& term : *terms) {
    for (const Atom& atom : term.atoms)
      if (!atom.axes.empty()) return std::nullopt;
    if (terms->size() > 1 && term.atoms.size() > most / count) return std::nullopt;
    count *= term.atoms.size();
  }
  std::vector<Point> points;
  points.reserve(terms->front().atoms.size());
  for (const Atom& atom : terms->front().atoms) points.push_back(atom.center);
  for (std::size_t i = 1; i < terms->size(); ++i) {
    std::vector<Point> sums;
    sums.reserve(points.size() * (*terms)[i].atoms.size());
    for (const Point& p : points)
      for (const Atom& atom : (*terms)[i].atoms) sums.push_back(p + atom.center);
    points = std::move(sums);
  }
  return points;
}

RationalInterval support(const Shape& shape, const Point& u, unsigned bits) {
  RationalInterval height{0, 0};
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    std::optional<RationalInterval> highest;
    for (const Atom& atom : term.atoms) {
      const RationalInterval other = support(atom, u, bits);
      highest = highest ? greater(*highest, other) : other;
    }
    height = height + *highest;
  }
  const RationalInterval radius{shape.radius, shape.radius};
  return quotient(height, kernels::enclosed({0, dot(u, u)}, bits)) + radius;
}

namespace {

Point times(const Gram& s, const Point& v) { return {dot(s[0], v), dot(s[1], v), dot(s[2], v)}; }

bool is_multiple_of_unit(const Gram& s) {
  const mpq_class& x = s[0].x;
  return s == Gram{Point{x, 0, 0}, Point{0, x, 0}, Point{0, 0, x}};
}

/// The one direction about which an ellipsoid or disc might be of revolution: that of M M^T - x I =
/// y d d^T. It is not checked.
std::optional<Vector> direction_of(const Gram& s) {
  const mpq_class &xy = s[0].y, &xz = s[0].z, &yz = s[1].z;
  const int entries = (xy != 0 ? 1 : 0) + (xz != 0 ? 1 : 0) + (yz != 0 ? 1 : 0);
  if (entries == 3) return primitive_along({xy * xz, xy * yz, xz * yz});
  if (entries == 2) return std::nullopt;
  if (xy != 0) return primitive_along({s[0].x - s[2].z, xy, 0});
  if (xz != 0) return primitive_along({s[0].x - s[1].y, 0, xz});
  if (yz != 0) return primitive_along({0, s[1].y - s[0].x, yz});
  if (s[0].x == s[1].y) return Vector{0, 0, 1};
  if (s[0].x == s[2].z) return Vector{0, 1, 0};
  if (s[1].y == s[2].z) return Vector{1, 0, 0};
  return std::nullopt;
}

std::optional<AxisLine> axis_of_term(const Term& term) {
  AxisLine axis{term.atoms.front().center, std::nullopt};
  for (const Atom& atom : term.atoms)
    if (!axis.direction && atom.center != axis.point) axis.direction = primitive_along(atom.center - axis.point);
  for (const Atom& atom : term.atoms) {
    if (axis.direction) break;
    const Gram s = gram_of(atom);
    if (is_multiple_of_unit(s)) continue;
    axis.direction = direction_of(s);
    if (!axis.direction) return std::nullopt;
  }
  if (!axis.direction) return axis;
  const Vector& d = *axis.direction;
  const bool possible = std::all_of(term.atoms.begin(), term.atoms.end(), [&](const Atom& atom) {
    return cross(Point(atom.center - axis.point), rational(d)) == Point{} && profile_about(atom, d);
  });
  return possible ? std::optional(axis) : std::nullopt;
}

}  // namespace

Gram gram_of(const Atom& atom) {
  Gram s;
  for (const Point& m : atom.axes) {
    s[0] = s[0] + m.x * m;
    s[1] = s[1] + m.y * m;
    s[2] = s[2] + m.z * m;
  }
  return s;
}

std::optional<AtomProfile> profile_about(const Atom& atom, const Vector& d) {
  if (atom.axes.empty()) return AtomProfile{0, 0};
  const Gram s = gram_of(atom);
  const Point axis = rational(d);
  const mpq_class length = dot(axis, axis), along = dot(axis, times(s, axis)) / (length * length),
                  across = (s[0].x + s[1].y + s[2].z - along * length) / (2 * length), rest = along - across;
  for (const auto part : {&Point::x, &Point::y, &Point::z}) {
    const std::size_t row = part == &Point::x ? 0 : part == &Point::y ? 1 : 2;
    Point expected = (rest * axis.*part) * axis;
    expected.*part += across * length;
    if (s[row] != expected) return std::nullopt;
  }
  return AtomProfile{across, along};
}

std::optional<AxisLine> axis_of(std::span<const Term> terms) {
  AxisLine sum;
  for (const Term& term : terms) {
    const std::optional<AxisLine> axis = axis_of_term(term);
    if (!axis) return std::nullopt;
    if (axis->direction && sum.direction && !is_zero(cross(*axis->direction, *sum.direction))) return std::nullopt;
    if (axis->direction) sum.direction = axis->direction;
    sum.point = sum.point + axis->point;
  }
  return sum;
}

}  // namespace fathom::shapes

namespace fathom {
namespace {

Vec3<mpq_class> vector(const Point& p) { return {p.x, p.y, p.z}; }

}  // namespace

bool is_flat(const Shape& shape) {
  const kernels::DefaultFloatEnvironment environment;
  shapes::require_shape(shape);
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (!terms || shape.radius > 0) return false;
  std::vector<Vec3<mpq_class>> spanning(1);  // O, and vectors that span the space of all differences of points
  for (const Term& term : *terms) {
    for (const Atom& atom : term.atoms) {
      spanning.push_back(vector(atom.center) - vector(term.atoms.front().center));
      for (const Point& axis : atom.axes) spanning.push_back(vector(axis));
    }
  }
  return polytope::affine_span<mpq_class>(spanning, spanning.size()).rank < 3;
}

}  // namespace fathom
