// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of signed depths, format 2: proofs about the cores, found as for point sets, and the
// radii beside them; the naive check of them; and their text.              [verify/check/FORMAT.md]
#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::certificate {
namespace {

// The same core as one hull.
void set_points(Shape& shape, const std::vector<Point>& points) {
  if (std::get<std::vector<Term>>(shape.core).size() > 1) shape.core = hull(points).core;
}

void prove(const Depth& cores, const SignedDepth& answer, ShapeCertificate& certificate, Monitor* monitor) {
  const std::vector<Point> a = points_of(certificate.a), b = points_of(certificate.b);
  set_points(certificate.a, a);
  set_points(certificate.b, b);
  Certificate of_points = make_certificate(a, b, cores, monitor);
  certificate.claim = cores.touch() ? ShapeClaim::touching : cores.distance() ? ShapeClaim::apart : ShapeClaim::depth;
  certificate.low = of_points.low;
  certificate.high = of_points.high;
  certificate.directions = std::move(of_points.directions);
  certificate.complete = cores.penetration() != nullptr && of_points.complete;
  certificate.inner = std::move(of_points.inner);
  certificate.weights_a = std::move(of_points.weights_a);
  certificate.weights_b = std::move(of_points.weights_b);
  if (!answer.cone) return;
  certificate.directions = {answer.direction()};
  certificate.cone = prove_cone(a, b, *answer.cone);
}

void prove(const PlaneSupport& plane, const SignedDepth& answer, ShapeCertificate& certificate, Monitor*) {
  const bool half_is_a = std::holds_alternative<HalfSpace>(certificate.a.core);
  Shape& convex = half_is_a ? certificate.b : certificate.a;
  const HalfSpace& half = std::get<HalfSpace>((half_is_a ? certificate.a : certificate.b).core);
  set_points(convex, points_of(convex));
  const rounded::Side where = half_is_a ? rounded::Side::a : rounded::Side::b;
  const PlaneSupport found = rounded::plane_support(half, where, std::get<std::vector<Term>>(convex.core));
  if (found.direction != plane.direction || found.support != plane.support) contradiction("another support");
  const int side = sgn(plane.support);
  certificate.claim = side > 0 ? ShapeClaim::depth : side < 0 ? ShapeClaim::apart : ShapeClaim::touching;
  certificate.low = certificate.high = abs(answer.exact()->root);
  certificate.directions = {plane.direction};
}

void prove(const Bracket& bracket, const SignedDepth& answer, ShapeCertificate& certificate, Monitor* monitor) {
  if (bracket.around) {
    // No format has room for an outline: what is proved is what the search without it finds.
    SignedDepthOptions wider;
    wider.cores.monitor = monitor;
    wider.coaxial = false;
    const SignedDepth found = signed_depth(certificate.a, certificate.b, wider);
    prove(std::get<Bracket>(found.core), found, certificate, monitor);
    return;
  }
  certificate.claim = ShapeClaim::signed_bounds;
  if (const Bounds* bounds = answer.bounds()) {
    certificate.low = bounds->low;
    certificate.high = bounds->high;
  } else {
    if (answer.exact()->root != 0) contradiction("bounds that are a root");
    certificate.low = certificate.high = answer.exact()->rational;
  }
  certificate.directions = {bracket.direction};
  certificate.heights_a = bracket.heights_a;
  certificate.heights_b = bracket.heights_b;
  certificate.inner_a = bracket.inner_a;
  certificate.inner_b = bracket.inner_b;
  certificate.inner = bracket.polytope;
  certificate.weights_a = bracket.weights_a;
  certificate.weights_b = bracket.weights_b;
}

// ---- the naive check: in rationals, by the definitions; what is about points alone is left to
// that of format 1 ----

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
      if (report_.expect(parallel, "the direction is not the normal of the half-space"))
        side.most = half->offset * square / along;
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
      if (!report_.expect(place.local.size() == atom.axes.size(), "a place has not one parameter for each axis"))
        return;
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
    add(validate({{},
                  a.points,
                  b.points,
                  claim,
                  c_.low,
                  c_.high,
                  c_.directions,
                  c_.complete,
                  c_.inner,
                  c_.weights_a,
                  c_.weights_b}));
    if (c_.cone) add(validate(*c_.cone, a.points, b.points));
  }

  void bounds(const Side& a, const Side& b) {
    const mpq_class rho = c_.a.radius + c_.b.radius, square = dot(c_.directions.front(), c_.directions.front());
    report_.expect(c_.low <= c_.high, "the bounds are the wrong way round");
    report_.expect(compare(Surd{rho, signed_square(*a.most + *b.most) / square}, c_.high) <= 0,
                   "the upper bound is too low");
    if (a.half() != nullptr || b.half() != nullptr) {
      report_.expect(compare(Surd{rho, signed_square(a.least() + b.least()) / square}, c_.low) >= 0,
                     "the lower bound is too high");
    } else if (c_.inner.vertices.empty()) {
      report_.expect(compare(Surd{rho, -squared_gap(a.points, b.points)}, c_.low) >= 0, "the lower bound is too high");
    } else {
      const mpq_class low = std::max(mpq_class(0), mpq_class(c_.low - rho)), height = a.least() + b.least();
      add(validate({{},
                    a.points,
                    b.points,
                    ClaimKind::bounds,
                    low * low,
                    signed_square(height) / square,
                    c_.directions,
                    false,
                    c_.inner,
                    {},
                    {}}));
    }
  }

  [[nodiscard]] mpq_class squared_gap(const std::vector<Point>& a, const std::vector<Point>& b) {
    const Point gap =
        polytope::convex_combination(report_, b, c_.weights_b) - polytope::convex_combination(report_, a, c_.weights_a);
    return dot(gap, gap);
  }

  void add(const kernels::Report& report) {
    report_.faults.insert(report_.faults.end(), report.faults.begin(), report.faults.end());
  }

  const ShapeCertificate& c_;
  kernels::Report report_;
};

// ---- the text ----

class ShapeWriter {
 public:
  explicit ShapeWriter(const ShapeCertificate& certificate) : c_(certificate), out_(4000) {}

  std::string text() {
    write_header(out_, c_.patches.empty() ? 2 : 4, c_.id);
    body(c_.a, "a", "shape_a", "halfspace_a", "radius_a");
    body(c_.b, "b", "shape_b", "halfspace_b", "radius_b");
    claim();
    if (c_.claim == ShapeClaim::signed_bounds) bracket();
    if (!of_half_space()) lower_side();
    if (c_.cone) cone(*c_.cone);
    if (!c_.patches.empty()) patches();
    write_end(out_, counts_);
    return out_.take();
  }

 private:
  [[nodiscard]] bool of_half_space() const {
    return std::holds_alternative<HalfSpace>(c_.a.core) || std::holds_alternative<HalfSpace>(c_.b.core);
  }

  // Begins a line with a count, which the last line repeats.
  Writer& announce(std::string_view name, std::size_t count) {
    counts_.push_back(count);
    return out_.word(name).word(count);
  }

  void body(const Shape& shape, std::string_view points, std::string_view terms, std::string_view half,
            std::string_view radius) {
    if (const HalfSpace* core = std::get_if<HalfSpace>(&shape.core))
      out_.word(half).words(core->normal).word(core->offset).end();
    else if (const auto& all = std::get<std::vector<Term>>(shape.core); c_.claim == ShapeClaim::signed_bounds)
      write_terms(all, terms);
    else write_hull(all.front(), points);
    if (shape.radius != 0) out_.word(radius).word(shape.radius).end();
  }

  void write_hull(const Term& term, std::string_view name) {
    announce(name, term.atoms.size()).end();
    for (const Atom& atom : term.atoms) out_.words(atom.center).end();
  }

  void write_terms(const std::vector<Term>& terms, std::string_view name) {
    announce(name, terms.size()).end();
    for (const Term& term : terms) {
      announce("term", term.atoms.size()).end();
      for (const Atom& atom : term.atoms) {
        out_.word(atom.axes.empty() ? "point" : atom.axes.size() == 2 ? "disc" : "ball").words(atom.center);
        for (const Point& axis : atom.axes) out_.words(axis);
        out_.end();
      }
    }
  }

  void claim() {
    out_.word("claim");
    switch (c_.claim) {
      case ShapeClaim::depth: out_.word("depth").word(c_.low).end(); break;
      case ShapeClaim::touching: out_.word("touching").end(); break;
      case ShapeClaim::apart: out_.word("apart").word(c_.low).end(); break;
      case ShapeClaim::signed_bounds: out_.word("signed_bounds").word(c_.low).word(c_.high).end(); break;
    }
    announce("directions", c_.directions.size()).word(c_.complete ? "all" : "some").end();
    for (const Vector& n : c_.directions) out_.words(n).end();
  }

  // The heights and inner points of the cores that are sums of terms.
  void bracket() {
    const bool a = !std::holds_alternative<HalfSpace>(c_.a.core), b = !std::holds_alternative<HalfSpace>(c_.b.core);
    if (a) heights("heights_a", c_.heights_a);
    if (b) heights("heights_b", c_.heights_b);
    if (a) inner_points("inner_a", c_.inner_a);
    if (b) inner_points("inner_b", c_.inner_b);
  }

  void heights(std::string_view name, const std::vector<mpq_class>& heights) {
    announce(name, heights.size()).end();
    for (const mpq_class& height : heights) out_.word(height).end();
  }

  // A place has three parameters; those that its atom has not are 0.
  void inner_points(std::string_view name, const std::vector<InnerPoint>& points) {
    announce(name, points.size()).end();
    for (const InnerPoint& point : points) {
      for (const AtomPoint& place : point) {
        out_.word(std::size_t{place.atom});
        for (const mpq_class& y : place.local) out_.word(y);
        for (std::size_t i = place.local.size(); i < 3; ++i) out_.word("0");
      }
      out_.end();
    }
  }

  void lower_side() {
    if (!c_.inner.vertices.empty()) {
      write_inner(out_, c_.inner);
      counts_.insert(counts_.end(), {c_.inner.vertices.size(), c_.inner.facets.size()});
    } else {
      write_weights(out_, "weights_a", c_.weights_a);
      write_weights(out_, "weights_b", c_.weights_b);
      counts_.insert(counts_.end(), {c_.weights_a.size(), c_.weights_b.size()});
    }
  }

  void vectors(std::string_view name, const std::vector<Vector>& all) {
    announce(name, all.size()).end();
    for (const Vector& v : all) out_.words(v).end();
  }

  void cone(const ConeProof& proof) {
    vectors("lineality", rounded::lineality_basis(proof.cone));
    vectors("rays", proof.cone.rays);
    announce("differences", proof.differences.size()).end();
    for (const auto& [i, j] : proof.differences) out_.word(std::size_t{j}).word(std::size_t{i}).end();
  }

  void patches() {
    announce("patches", c_.patches.size()).end();
    for (const PatchProof& patch : c_.patches) {
      counts_.insert(counts_.end(), {patch.corners.size(), patch.sides.size()});
      out_.word("patch").word(patch.corners.size()).word(patch.sides.size()).end();
      for (const auto& [of_a, of_b] : patch.corners) {
        for (const auto* weights : {&of_a, &of_b}) {
          out_.word(weights->size());
          for (const Weight& w : *weights) out_.word(std::size_t{w.index}).word(w.weight);
        }
        out_.end();
      }
      for (const PatchSide& side : patch.sides)
        out_.word(side.of_b ? "b" : "a").words(side.inward).word(side.corner).end();
    }
    if (c_.rates.empty()) return;
    announce("rates", c_.rates.size()).end();
    for (const CertifiedRate& rate : c_.rates)
      out_.words(rate.motion.v)
          .words(rate.motion.w)
          .word(mpz_class(sgn(rate.value.root)))
          .word(mpq_class(abs(rate.value.root)))
          .end();
  }

  const ShapeCertificate& c_;
  Writer out_;
  std::vector<std::size_t> counts_;
};

// One hull of points without a radius.
bool bare(const Shape& shape) { return shape.radius == 0 && shapes::require_all_but_points(shape); }

}  // namespace

std::vector<Point> points_of(const Shape& shape) {
  std::optional<std::vector<Point>> points = shapes::polytope_points(shape, most_expanded_points);
  if (!points) throw std::invalid_argument("a sum has too many points to be written out, or a core is curved");
  return std::move(*points);
}

kernels::Report validate(const ShapeCertificate& certificate) {
  kernels::Report report = ShapeCheck(certificate).run();
  if (report.ok() && !certificate.patches.empty()) validate_patches(report, certificate);
  return report;
}

}  // namespace fathom::certificate

namespace fathom {

ShapeCertificate make_certificate(const Shape& a, const Shape& b, const SignedDepth& answer, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  shapes::require_shape(a);
  shapes::require_shape(b);
  ShapeCertificate certificate;
  certificate.a = shapes::simplified(a);
  certificate.b = shapes::simplified(b);
  if (certificate.a.radius != answer.radius_a || certificate.b.radius != answer.radius_b)
    certificate::contradiction("other radii");
  std::visit([&](const auto& core) { certificate::prove(core, answer, certificate, monitor); }, answer.core);
  return certificate;
}

std::string certificate_text(const ShapeCertificate& certificate) {
  return certificate::ShapeWriter(certificate).text();
}

std::string certificate_text(const Shape& a, const Shape& b, const SignedDepth& answer, std::string_view id,
                             ShapeFormat format, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const Depth* const cores = std::get_if<Depth>(&answer.core);
  if (cores != nullptr && certificate::bare(a) && certificate::bare(b) &&
      (format == ShapeFormat::shortest || !cores->touch()))
    return certificate_text(certificate::points_of(a), certificate::points_of(b), *cores, id, monitor);
  ShapeCertificate certificate = make_certificate(a, b, answer, monitor);
  certificate.id = id;
  return certificate_text(certificate);
}

}  // namespace fathom
