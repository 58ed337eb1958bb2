// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "fathom/numbers.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/polygon.hpp"

namespace fathom::picture {
namespace {

/// The square root of the sum of squares, to within a few roundings, for numbers of any size.
mpq_class root_of_squares(const std::vector<mpq_class>& values) {
  mpq_class largest = 0;
  for (const mpq_class& value : values) largest = std::max(largest, mpq_class(abs(value)));
  if (largest == 0) return 0;
  double squares = 0;
  for (const mpq_class& value : values) {
    const double share = mpq_class(value / largest).get_d();
    squares += share * share;
  }
  return mpq_class(largest * exact_value(std::sqrt(squares)));
}

Bounds2 box_of(const Atom& atom, const View& view) {
  std::vector<mpq_class> x, y;
  for (const Point& axis : atom.axes) {
    const Spot at = view.place(axis);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  const mpq_class right = root_of_squares(x), up = root_of_squares(y);
  return Bounds2::of(view.place(atom.center)).plus({{mpq_class(-right), mpq_class(-up)}, {right, up}});
}

/// An atom in pixels.
struct FlatAtom {
  Dot center;  // from that of the first of its term
  std::vector<Dot> axes;

  /// The farthest point in the direction u, and how far it is.
  [[nodiscard]] Dot farthest(const Dot& u, double& reach) const {
    Dot result = center;
    std::vector<double> shares;
    double squares = 0;
    for (const Dot& axis : axes) {
      shares.push_back(axis.x * u.x + axis.y * u.y);
      squares += shares.back() * shares.back();
    }
    for (std::size_t i = 0; i < axes.size() && squares > 0; ++i) {
      result.x += axes[i].x * shares[i] / std::sqrt(squares);
      result.y += axes[i].y * shares[i] / std::sqrt(squares);
    }
    reach = result.x * u.x + result.y * u.y;
    return result;
  }
};

/// A body in pixels: the sum of a place and terms.
struct FlatBody {
  Dot base;
  std::vector<std::vector<FlatAtom>> terms;

  [[nodiscard]] Dot farthest(const Dot& u) const {
    Dot result = base;
    for (const std::vector<FlatAtom>& term : terms) {
      double best = -std::numeric_limits<double>::infinity(), reach = 0;
      Dot found;
      for (const FlatAtom& atom : term)
        if (const Dot d = atom.farthest(u, reach); reach > best) best = reach, found = d;
      result = {result.x + found.x, result.y + found.y};
    }
    return result;
  }
};

FlatBody flat(const Curved& body, const Window& window, const Point& by) {
  FlatBody result;
  Point base = by;
  for (const Term& term : body.terms) {
    const Point& first = term.atoms.front().center;
    base = base + first;
    result.terms.emplace_back();
    for (const Atom& atom : term.atoms) {
      FlatAtom made{window.shift(atom.center - first), {}};
      for (const Point& axis : atom.axes) made.axes.push_back(window.shift(axis));
      result.terms.back().push_back(std::move(made));
    }
  }
  result.base = window.dot(base);
  const double right = mpq_class(body.radius * window.scale().x).get_d(), up = mpq_class(body.radius * window.scale().y).get_d();
  if (body.radius > 0) result.terms.push_back({FlatAtom{{0, 0}, {{right, 0}, {0, up}}}});
  return result;
}

/// Unit vectors all around, ever closer ones near the way out: a close-up sees nothing else of the body. By rational points of the circle,
/// which are the same on every machine.
std::vector<Dot> directions() {
  constexpr int most_halvings = 30, steps = 24;
  std::vector<double> tangents{0};
  for (int k = most_halvings; k > 5; --k) tangents.push_back(std::ldexp(1, -k));
  for (int i = 1; i <= steps; ++i) tangents.push_back(i / static_cast<double>(steps));
  std::vector<Dot> result;
  for (const double t : tangents) {
    const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    for (const Dot& d : {Dot{x, y}, Dot{-x, y}, Dot{x, -y}, Dot{-x, -y}}) result.push_back(d);
  }
  return result;
}

}  // namespace

Bounds2 curved_box(const Curved& body, const View& view) {
  Bounds2 result = Bounds2::of({0, 0});
  for (const Term& term : body.terms) {
    Bounds2 box = box_of(term.atoms.front(), view);
    for (const Atom& atom : term.atoms) box.add(box_of(atom, view));
    result = result.plus(box);
  }
  return result.plus({{mpq_class(-body.radius), mpq_class(-body.radius)}, {body.radius, body.radius}});
}

std::vector<Dot> curved_outline(const Curved& body, const Window& window, const Point& by) {
  const FlatBody in_pixels = flat(body, window, by);
  std::vector<Dot> dots;
  for (const Dot& u : directions()) dots.push_back(in_pixels.farthest(u));
  return window.cut(outline(std::move(dots)), true);
}

Point farthest(const Shape& shape, const Point& u) {
  const Point way = exact_point(unit_vector(u));
  Point result = shape.radius * way;
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    std::optional<mpq_class> best;
    Point found;
    for (const Atom& atom : term.atoms) {
      std::vector<mpq_class> shares;
      for (const Point& axis : atom.axes) shares.push_back(dot(axis, way));
      const mpq_class length = root_of_squares(shares), reach = dot(atom.center, way) + length;
      if (best && reach <= *best) continue;
      best = reach;
      found = atom.center;
      for (std::size_t i = 0; i < shares.size() && length > 0; ++i) found = found + (shares[i] / length) * atom.axes[i];
    }
    result = result + found;
  }
  return result;
}

}  // namespace fathom::picture
