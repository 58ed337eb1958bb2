// SPDX-License-Identifier: GPL-3.0-or-later
// The naive check of proved bounds: in rationals, by the definitions, over all pairs of facets and
// vertices.
#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/expanding/expanding_polytope.hpp"

namespace fathom::curved {
namespace {

// The square with the sign.
mpq_class square(const mpq_class& q) { return q * abs(q); }

class Check {
 public:
  Check(const CurvedBounds& bounds, const Shape& a, const Shape& b)
      : bounds_(bounds),
        p_(bounds.bracket),
        a_(a),
        b_(b),
        n_{p_.direction.x, p_.direction.y, p_.direction.z},
        rho_(a.radius + b.radius) {}

  kernels::Report run() {
    report_.expect(bounds_.low <= bounds_.high, "the bounds are in the wrong order");
    if (!report_.expect(dot(n_, n_) > 0, "the direction is zero")) return report_;
    const mpq_class height = height_of(a_, -n_, p_.heights_a) + height_of(b_, n_, p_.heights_b);
    report_.expect(square(height) <= square(bounds_.high - rho_) * dot(n_, n_),
                   "the direction does not show the upper bound");
    inner_points(a_, p_.inner_a, points_a_);
    inner_points(b_, p_.inner_b, points_b_);
    if (!report_.ok()) return report_;
    if (std::holds_alternative<HalfSpace>(a_.core) || std::holds_alternative<HalfSpace>(b_.core)) half_space();
    else if (p_.around) outline(*p_.around);
    else if (p_.polytope.facets.empty()) weights();
    else polytope();
    return report_;
  }

 private:
  mpq_class height_of(const Shape& shape, const Point& s, const std::vector<mpq_class>& heights) {
    if (const auto* plane = std::get_if<HalfSpace>(&shape.core)) {
      report_.expect(cross(s, plane->normal) == Point{} && dot(s, plane->normal) > 0,
                     "not the direction of the half-space");
      return plane->offset * dot(s, plane->normal) / dot(plane->normal, plane->normal);
    }
    const auto& terms = std::get<std::vector<Term>>(shape.core);
    if (!report_.expect(heights.size() == terms.size(), "not one height for each term")) return 0;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      for (const Atom& atom : terms[t].atoms) {
        mpq_class reach;
        for (const Point& axis : atom.axes) reach += dot(s, axis) * dot(s, axis);
        const mpq_class beyond = heights[t] - dot(s, atom.center);
        report_.expect(beyond >= 0 && beyond * beyond >= reach, "an atom is higher than its term");
      }
    }
    return std::accumulate(heights.begin(), heights.end(), mpq_class());
  }

  void inner_points(const Shape& shape, const std::vector<InnerPoint>& inner, std::vector<Point>& points) {
    if (std::holds_alternative<HalfSpace>(shape.core)) return;
    const auto& terms = std::get<std::vector<Term>>(shape.core);
    for (const InnerPoint& point : inner) {
      Point place;
      if (!report_.expect(point.size() == terms.size(), "an inner point without a part in each term")) return;
      for (std::size_t t = 0; t < terms.size(); ++t) {
        if (!report_.expect(point[t].atom < terms[t].atoms.size(), "an inner point of no atom")) return;
        const Atom& atom = terms[t].atoms[point[t].atom];
        if (!report_.expect(point[t].local.size() == atom.axes.size(),
                            "an inner point with other parameters than its atom"))
          return;
        mpq_class length;
        place = place + atom.center;
        for (std::size_t k = 0; k < atom.axes.size(); ++k) {
          length += point[t].local[k] * point[t].local[k];
          place = place + point[t].local[k] * atom.axes[k];
        }
        report_.expect(length <= 1, "an inner point outside its atom");
      }
      points.push_back(place);
    }
  }

  void half_space() {
    const bool plane_is_a = std::holds_alternative<HalfSpace>(a_.core);
    const HalfSpace& plane = std::get<HalfSpace>(plane_is_a ? a_.core : b_.core);
    const Point s = plane_is_a ? n_ : -n_;
    const std::vector<Point>& points = plane_is_a ? points_b_ : points_a_;
    if (!report_.expect(!points.empty(), "no inner point")) return;
    mpq_class most = dot(s, points.front());
    for (const Point& p : points) most = std::max(most, dot(s, p));
    const mpq_class low = most + plane.offset * abs(dot(n_, plane.normal)) / dot(plane.normal, plane.normal);
    report_.expect(square(low) >= square(bounds_.low - rho_) * dot(n_, n_), "no inner point shows the lower bound");
  }

  void weights() {
    const Point z = polytope::convex_combination(report_, points_b_, p_.weights_b) -
                    polytope::convex_combination(report_, points_a_, p_.weights_a);
    report_.expect(square(rho_ - bounds_.low) >= dot(z, z), "the inner points are too far apart for the lower bound");
  }

  void polytope() {
    const mpq_class least = std::max(mpq_class(bounds_.low - rho_), mpq_class(0));
    expanding::check_inner_polytope(
        report_, p_.polytope, points_a_, points_b_, [&](const Point& n, const mpq_class& height) {
          report_.expect(height * height >= least * least * dot(n, n), "a facet of Q is too near");
        });
  }

  // ---- an outline in the half-plane of profiles ----

  /// The factor by which M M^T stretches v: it has to lead along v.
  mpq_class stretch(const Atom& atom, const Point& v) {
    Point image;
    for (const Point& axis : atom.axes) image = image + dot(axis, v) * axis;
    report_.expect(cross(image, v) == Point{}, "an atom is not of revolution about the axis");
    return dot(image, v) / dot(v, v);
  }

  /// The point that its places sum up to.
  std::pair<mpq_class, mpq_class> spot(const std::vector<Term>& terms, const ProfilePoint& point, const Point& d) {
    std::pair<mpq_class, mpq_class> sum;
    if (!report_.expect(point.size() == terms.size(), "a profile point without a place in each term")) return sum;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const ProfilePlace& place = point[t];
      if (!report_.expect(place.atom < terms[t].atoms.size(), "a place of no atom")) return sum;
      const Atom& atom = terms[t].atoms[place.atom];
      const Point from = atom.center - terms[t].atoms.front().center,
                  e = cross(d, d.x == 0 ? Point{1, 0, 0} : Point{0, 1, 0});
      const mpq_class length = dot(d, d), along = stretch(atom, d) / length, across = stretch(atom, e) / length;
      report_.expect(across == stretch(atom, cross(d, e)) / length, "an atom is an ellipse around the axis");
      report_.expect(cross(from, d) == Point{}, "a center is not on the axis");
      report_.expect(place.r >= 0 && place.z * place.z * across + place.r * place.r * along <= along * across &&
                         place.z * place.z <= along && place.r * place.r <= across,
                     "a place outside of its atom");
      sum.first += dot(from, d) / length + place.z;
      sum.second += place.r;
    }
    return sum;
  }

  void outline(const Revolution& around) {
    const auto &a = std::get<std::vector<Term>>(a_.core), &b = std::get<std::vector<Term>>(b_.core);
    const Point d{around.axis.x, around.axis.y, around.axis.z};
    Point apart;
    for (const Term& term : b) apart = apart + term.atoms.front().center;
    for (const Term& term : a) apart = apart - term.atoms.front().center;
    if (!report_.expect(d != Point{} && cross(apart, d) == Point{}, "the bodies have no common axis")) return;
    std::vector<std::pair<mpq_class, mpq_class>> corners;
    for (const auto& [i, j] : around.outline) {
      if (!report_.expect(i < around.points_a.size() && j < around.points_b.size(), "a corner of no point")) return;
      const auto of_a = spot(a, around.points_a[i], d), of_b = spot(b, around.points_b[j], d);
      corners.emplace_back(dot(apart, d) / dot(d, d) + of_b.first - of_a.first, of_a.second + of_b.second);
    }
    if (!report_.expect(corners.size() > 2, "an outline of too few corners")) return;
    report_.expect(corners.front().first < 0 && corners.front().second == 0, "the outline does not begin behind O");
    report_.expect(corners.back().first > 0 && corners.back().second == 0, "the outline does not end before O");
    const mpq_class least = std::max(mpq_class(bounds_.low - rho_), mpq_class(0));
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      const auto& [z, r] = corners[k];
      const auto& [next_z, next_r] = corners[k + 1];
      const mpq_class turn = next_z * r - z * next_r, x = next_z - z, y = next_r - r;
      report_.expect(turn > 0, "the outline turns back");
      report_.expect(turn * turn * dot(d, d) >= least * least * (x * x + y * y), "an edge is too near");
    }
  }

  const CurvedBounds& bounds_;
  const Bracket& p_;
  const Shape &a_, &b_;
  Point n_;
  mpq_class rho_;
  kernels::Report report_;
  std::vector<Point> points_a_, points_b_;
};

}  // namespace

kernels::Report validate(const CurvedBounds& bounds, const Shape& a, const Shape& b) {
  return Check(bounds, a, b).run();
}

}  // namespace fathom::curved
