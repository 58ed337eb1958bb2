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
