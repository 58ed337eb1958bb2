// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "view/picture/drawn.hpp"

namespace fathom::picture {
namespace {

using Triple = Vec3<double>;

constexpr int samples = 96;            // of a rim
constexpr double hardly = 1e-9;        // of the body's extent: places are no more exact than that
constexpr std::size_t most_rims = 64;  // bodies with more are no cylinders

Triple operator*(double c, const Triple& v) { return {c * v.x, c * v.y, c * v.z}; }
double length(const Triple& v) { return std::sqrt(dot(v, v)); }

/// An atom of a body, in units of the body's extent, seen from the first atom of its term.
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

mpq_class largest(const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); }

/// How far the body reaches from the sum of the first atoms' centers, at most.
mpq_class extent_of(const std::vector<Term>& terms) {
  mpq_class extent = 0;
  for (const Term& term : terms) {
    mpq_class most = 0;
    for (const Atom& atom : term.atoms) {
      mpq_class far = largest(atom.center - term.atoms.front().center);
      for (const Point& axis : atom.axes) far += largest(axis);
      most = std::max(most, far);
    }
    extent += most;
  }
  return extent;
}

class Body {
 public:
  explicit Body(const std::vector<Term>& terms) : extent_(extent_of(terms)) {
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
  /// Whether a plane across u touches the body at p.
  [[nodiscard]] bool is_extreme(const Triple& p, const Triple& u) const { return reach(u) - dot(p, u) <= hardly * length(u); }
  [[nodiscard]] Point place(const Triple& p) const { return base_ + extent_ * exact_point(p); }

 private:
  mpq_class extent_;
  Point base_;
  std::vector<NearTerm> terms_;
};

/// A disc that may end the body: the sum of one and of points of all other terms.
struct Disc {
  Triple center, u, w;

  [[nodiscard]] Triple at(double turn) const { return center + std::cos(turn) * u + std::sin(turn) * w; }
  [[nodiscard]] Triple tangent(double turn) const { return std::cos(turn) * w - std::sin(turn) * u; }
};

/// All sums of a disc of one term and a point of each other.
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
          if (atom.axes.empty() && moved.size() < most_rims) moved.push_back({disc.center + atom.center, disc.u, disc.w});
      found = std::move(moved);
    }
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

/// Whether an outward normal at the place of the rim looks at us. The outward normals are those between that of the end face and the last
/// one that is extreme when it is turned to the side.
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

/// The rim of a disc, cut where it begins or ceases to be seen.
void add_rim(const Body& body, const Disc& disc, const Triple& face, const Triple& towards, std::vector<Rim>& rims) {
  const auto turn = [](int i) { return 2 * std::numbers::pi * i / samples; };
  std::optional<bool> before;
  const std::size_t first = rims.size();
  for (int i = 0; i < samples; ++i) {
    const bool hidden = !is_seen(body, disc, face, turn(i) + turn(1) / 2, towards);  // of the piece up to the next sample
    if (before != hidden) rims.push_back({{body.place(disc.at(turn(i)))}, hidden});
    rims.back().path.push_back(body.place(disc.at(turn((i + 1) % samples))));
    before = hidden;
  }
  if (rims.size() - first < 2 || rims[first].hidden != rims.back().hidden) return;
  std::vector<Point>& last = rims.back().path;  // it goes on where the first part begins
  last.insert(last.end(), rims[first].path.begin() + 1, rims[first].path.end());
  rims[first].path = std::move(last);
  rims.pop_back();
}

}  // namespace

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
