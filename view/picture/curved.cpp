// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "fathom/numbers.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/view.hpp"

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
  Dot center;  // relative to that of the first atom of its term
  std::vector<Dot> axes;

  /// Returns the farthest point in the direction u, and its distance along u in `reach`.
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
  const double right = mpq_class(body.radius * window.scale().x).get_d(),
               up = mpq_class(body.radius * window.scale().y).get_d();
  if (body.radius > 0) result.terms.push_back({FlatAtom{{0, 0}, {{right, 0}, {0, up}}}});
  return result;
}

/// Returns unit vectors in all directions, closer to each other near the way out, which fills a
/// close-up. They are rational points of the circle, so that they are the same on every machine.
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

using Triple = Vec3<double>;

constexpr int samples = 96;            // of a rim
constexpr double hardly = 1e-9;        // of the body's extent, the accuracy of places
constexpr std::size_t most_rims = 64;  // bodies with more are no cylinders

Triple operator*(double c, const Triple& v) { return {c * v.x, c * v.y, c * v.z}; }

/// An atom of a body, in units of the body's extent, relative to the first atom of its term.
struct NearAtom {
  Triple center;
  std::vector<Triple> axes;

  [[nodiscard]] double reach(const Triple& u) const {
    double squares = 0;
    for (const Triple& axis : axes) squares += dot(axis, u) * dot(axis, u);
    return dot(center, u) + std::sqrt(squares);
  }
};
using NearTerm = std::vector<NearAtom>;

class Body {
 public:
  explicit Body(const std::vector<Term>& terms) : extent_(reach_of(terms)) {
    if (extent_ == 0) return;
    const auto near = [&](const Point& v) {
      const Point share = (1 / extent_) * v;
      return Triple{share.x.get_d(), share.y.get_d(), share.z.get_d()};
    };
    for (const Term& term : terms) {
      const Point& first = term.atoms.front().center;
      base_ = base_ + first;
      NearTerm& made = terms_.emplace_back();
      for (const Atom& atom : term.atoms) {
        NearAtom& one = made.emplace_back();
        one.center = near(atom.center - first);
        for (const Point& axis : atom.axes) one.axes.push_back(near(axis));
      }
    }
  }

  [[nodiscard]] const std::vector<NearTerm>& terms() const { return terms_; }
  [[nodiscard]] double reach(const Triple& u) const {
    double result = 0;
    for (const NearTerm& term : terms_) {
      double most = -std::numeric_limits<double>::infinity();
      for (const NearAtom& atom : term) most = std::max(most, atom.reach(u));
      result += most;
    }
    return result;
  }
  /// Returns whether a plane across u touches the body at p.
  [[nodiscard]] bool is_extreme(const Triple& p, const Triple& u) const {
    return reach(u) - dot(p, u) <= hardly * length(u);
  }
  [[nodiscard]] Point place(const Triple& p) const { return base_ + extent_ * exact_point(p); }

 private:
  mpq_class extent_;
  Point base_;
  std::vector<NearTerm> terms_;
};

/// A disc that may be an end face of the body: the sum of a disc of one term and points of all
/// others.
struct Disc {
  Triple center, u, w;

  [[nodiscard]] Triple at(double turn) const { return center + std::cos(turn) * u + std::sin(turn) * w; }
  [[nodiscard]] Triple tangent(double turn) const { return std::cos(turn) * w - std::sin(turn) * u; }
};

/// Returns all sums of a disc of one term and a point of each other term.
std::vector<Disc> discs_of(const std::vector<NearTerm>& terms) {
  std::vector<Disc> result;
  for (std::size_t own = 0; own < terms.size(); ++own) {
    std::vector<Disc> found;
    for (const NearAtom& atom : terms[own])
      if (atom.axes.size() == 2 && length(cross(atom.axes[0], atom.axes[1])) > 0)
        found.push_back({atom.center, atom.axes[0], atom.axes[1]});
    for (std::size_t other = 0; other < terms.size(); ++other) {
      if (other == own) continue;
      std::vector<Disc> moved;
      for (const Disc& disc : found)
        for (const NearAtom& atom : terms[other])
          if (atom.axes.empty() && moved.size() < most_rims)
            moved.push_back({disc.center + atom.center, disc.u, disc.w});
      found = std::move(moved);
    }
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

/// Returns whether an outward normal at the place of the rim faces the viewer. The outward normals
/// are those between the normal of the end face and the last extreme one when it is turned to the
/// side.
bool is_seen(const Body& body, const Disc& disc, const Triple& face, double turn, const Triple& towards) {
  constexpr int halvings = 40;
  constexpr double from_its_edge = -1e-9;
  if (dot(face, towards) > from_its_edge) return true;
  const Triple p = disc.at(turn), along = disc.tangent(turn);
  Triple side = cross((1 / length(along)) * along, face);
  if (dot(side, p - disc.center) < 0) side = -1.0 * side;
  double low = 0, high = std::numbers::pi;
  const auto normal = [&](double angle) { return std::cos(angle) * face + std::sin(angle) * side; };
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (body.is_extreme(p, normal(middle)) ? low : high) = middle;
  }
  return dot(normal(low), towards) > from_its_edge;
}

/// Adds the rim of a disc, divided into seen and hidden parts.
void add_rim(const Body& body, const Disc& disc, const Triple& face, const Triple& towards, std::vector<Rim>& rims) {
  const auto turn = [](int i) { return 2 * std::numbers::pi * i / samples; };
  std::optional<bool> before;
  const std::size_t first = rims.size();
  for (int i = 0; i < samples; ++i) {
    const bool hidden =
        !is_seen(body, disc, face, turn(i) + turn(1) / 2, towards);  // of the piece up to the next sample
    if (before != hidden) rims.push_back({{body.place(disc.at(turn(i)))}, hidden});
    rims.back().path.push_back(body.place(disc.at(turn((i + 1) % samples))));
    before = hidden;
  }
  if (rims.size() - first < 2 || rims[first].hidden != rims.back().hidden) return;
  std::vector<Point>& last = rims.back().path;  // it continues with the first part
  last.insert(last.end(), rims[first].path.begin() + 1, rims[first].path.end());
  rims[first].path = std::move(last);
  rims.pop_back();
}

}  // namespace

mpq_class reach_of(const std::vector<Term>& terms) {
  mpq_class reach = 0;
  for (const Term& term : terms) {
    mpq_class most = 0;
    for (const Atom& atom : term.atoms) {
      mpq_class far = largest(atom.center - term.atoms.front().center);
      for (const Point& axis : atom.axes) far += largest(axis);
      most = std::max(most, far);
    }
    reach += most;
  }
  return reach;
}

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

std::vector<Rim> rims_of(const std::vector<Term>& terms, const View& view) {
  std::vector<Rim> rims;
  const Body body(terms);
  for (const Disc& disc : discs_of(body.terms())) {
    const Triple across = cross(disc.u, disc.w), face = (1 / length(across)) * across;
    const bool above = body.is_extreme(disc.center, face), below = body.is_extreme(disc.center, -1.0 * face);
    if (above && below) continue;  // a disc alone: its outline is its rim
    if (above || below) add_rim(body, disc, above ? face : -1.0 * face, view.towards(), rims);
  }
  return rims;
}

}  // namespace fathom::picture
