// SPDX-License-Identifier: GPL-3.0-or-later
// The naive check of a certificate of shapes: in rationals, by the definitions. What is about points alone is left to that of format 1.
#include <algorithm>
#include <optional>
#include <span>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/certificate/cone_proof.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::certificate {
namespace {

// The square with the sign of x.
mpq_class signed_square(const mpq_class& x) { return x * abs(x); }

// What is known of one of the two bodies.
struct Side {
  const Shape& shape;
  Vector outward;                 // n for B, -n for A
  std::vector<Point> points;      // of the core: its own, or inner points
  std::optional<mpq_class> most;  // an upper bound of <outward,x> over the core

  [[nodiscard]] const HalfSpace* half() const { return std::get_if<HalfSpace>(&shape.core); }
  [[nodiscard]] mpq_class least() const {  // a lower bound of the greatest <outward,x>
    if (half() != nullptr) return *most;
    mpq_class result = dot(outward, points.front());
    for (const Point& p : points) result = std::max(result, dot(outward, p));
    return result;
  }
};

class ShapeCheck {
 public:
  explicit ShapeCheck(const ShapeCertificate& certificate) : c_(certificate) {}

  kernels::Report run() {
    for (const Shape* shape : {&c_.a, &c_.b}) shapes::require_shape(*shape);
    if (!report_.expect(!c_.directions.empty() && !is_zero(c_.directions.front()), "no direction")) return report_;
    const Vector& n = c_.directions.front();
    Side a{c_.a, -n, {}, {}}, b{c_.b, n, {}, {}};
    if (!report_.expect(a.half() == nullptr || b.half() == nullptr, "two half-spaces")) return report_;
    look_at(a, c_.heights_a, c_.inner_a);
    look_at(b, c_.heights_b, c_.inner_b);
    if (!report_.ok()) return report_;
    if (c_.claim == ShapeClaim::signed_bounds) bounds(a, b);
    else if (a.half() != nullptr || b.half() != nullptr) plane(*a.most + *b.most);
    else of_points(a, b);
    return report_;
  }

 private:
  void look_at(Side& side, const std::vector<mpq_class>& heights, const std::vector<InnerPoint>& inner) {
    if (const HalfSpace* half = side.half()) {
      const mpq_class along = dot(side.outward, half->normal), square = dot(side.outward, side.outward);
      const bool parallel = along > 0 && along * along == square * dot(half->normal, half->normal);
      if (report_.expect(parallel, "the direction is not the normal of the half-space")) side.most = half->offset * square / along;
      return;
    }
    const std::vector<Term>& terms = std::get<std::vector<Term>>(side.shape.core);
    if (c_.claim == ShapeClaim::signed_bounds) {
      supports(side, terms, heights);
      for (const InnerPoint& point : inner) add_inner(side, terms, point);
      report_.expect(!side.points.empty(), "no inner points");
      return;
    }
    const std::optional<std::vector<Point>> points = shapes::polytope_points(side.shape, most_expanded_points);
    if (!report_.expect(points && terms.size() == 1, "a core is not one hull of points")) return;
    side.points = *points;
    side.most = side.least();
  }

  // Cauchy and Schwarz: <s,c> + the length of the axes' products is the support of an atom.
  void supports(Side& side, const std::vector<Term>& terms, const std::vector<mpq_class>& heights) {
    if (!report_.expect(heights.size() == terms.size(), "not one height for each term")) return;
    side.most = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      *side.most += heights[i];
      for (const Atom& atom : terms[i].atoms) {
        const mpq_class over = heights[i] - dot(side.outward, atom.center);
        mpq_class square;
        for (const Point& axis : atom.axes) square += dot(side.outward, axis) * dot(side.outward, axis);
        report_.expect(signed_square(over) >= square, "a height is too low");
      }
    }
  }

  void add_inner(Side& side, const std::vector<Term>& terms, const InnerPoint& point) {
    if (!report_.expect(point.size() == terms.size(), "an inner point has not one place in each term")) return;
    Point sum;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const AtomPoint& place = point[i];
      if (!report_.expect(place.atom < terms[i].atoms.size(), "an inner point names no atom")) return;
      const Atom& atom = terms[i].atoms[place.atom];
      if (!report_.expect(place.local.size() == atom.axes.size(), "a place has not one parameter for each axis")) return;
      mpq_class square;
      sum = sum + atom.center;
      for (std::size_t k = 0; k < place.local.size(); ++k) {
        square += place.local[k] * place.local[k];
        sum = sum + place.local[k] * atom.axes[k];
      }
      report_.expect(square <= 1, "a place outside of its atom");
    }
    side.points.push_back(sum);
  }

  // Of points against a half-space: the height is exact.
  void plane(const mpq_class& height) {
    const mpq_class square = signed_square(height) / dot(c_.directions.front(), c_.directions.front());
    report_.expect(c_.directions.size() == 1 && !c_.complete, "more than one direction of a half-space");
    switch (c_.claim) {
      case ShapeClaim::depth: report_.expect(square == c_.low && c_.low > 0, "another depth"); break;
      case ShapeClaim::touching: report_.expect(square == 0, "no touch"); break;
      default: report_.expect(square == -c_.low && c_.low > 0, "another distance"); break;
    }
  }

  void of_points(const Side& a, const Side& b) {
    if (c_.claim == ShapeClaim::apart) {
      plane(*a.most + *b.most);
      report_.expect(squared_gap(a.points, b.points) == c_.low, "the weighted points are at another distance");
      return;
    }
    const ClaimKind claim = c_.claim == ShapeClaim::depth ? ClaimKind::depth : ClaimKind::touching;
    add(validate({{}, a.points, b.points, claim, c_.low, c_.high, c_.directions, c_.complete, c_.inner, c_.weights_a, c_.weights_b}));
    if (c_.cone) add(validate(*c_.cone, a.points, b.points));
  }

  void bounds(const Side& a, const Side& b) {
    const mpq_class rho = c_.a.radius + c_.b.radius, square = dot(c_.directions.front(), c_.directions.front());
    report_.expect(c_.low <= c_.high, "the bounds are the wrong way round");
    report_.expect(compare(Surd{rho, signed_square(*a.most + *b.most) / square}, c_.high) <= 0, "the upper bound is too low");
    if (a.half() != nullptr || b.half() != nullptr) {
      report_.expect(compare(Surd{rho, signed_square(a.least() + b.least()) / square}, c_.low) >= 0, "the lower bound is too high");
    } else if (c_.inner.vertices.empty()) {
      report_.expect(compare(Surd{rho, -squared_gap(a.points, b.points)}, c_.low) >= 0, "the lower bound is too high");
    } else {
      const mpq_class low = std::max(mpq_class(0), mpq_class(c_.low - rho)), height = a.least() + b.least();
      add(validate(
          {{}, a.points, b.points, ClaimKind::bounds, low * low, signed_square(height) / square, c_.directions, false, c_.inner, {}, {}}));
    }
  }

  [[nodiscard]] mpq_class squared_gap(const std::vector<Point>& a, const std::vector<Point>& b) {
    const Point gap = combined(b, c_.weights_b) - combined(a, c_.weights_a);
    return dot(gap, gap);
  }

  Point combined(const std::vector<Point>& points, const std::vector<Weight>& weights) {
    Point sum;
    mpq_class total;
    for (const Weight& w : weights) {
      if (!report_.expect(w.index < points.size() && w.weight > 0, "a weight that is none")) continue;
      total += w.weight;
      sum = sum + w.weight * points[w.index];
    }
    report_.expect(total == 1, "weights do not sum to 1");
    return sum;
  }

  void add(const kernels::Report& report) { report_.faults.insert(report_.faults.end(), report.faults.begin(), report.faults.end()); }

  const ShapeCertificate& c_;
  kernels::Report report_;
};

}  // namespace

kernels::Report validate(const ShapeCertificate& certificate) { return ShapeCheck(certificate).run(); }

}  // namespace fathom::certificate
