// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of shapes as text: format 2.                                                                    [verify/check/FORMAT.md]
#include <utility>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "reference/certificate/writer.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::certificate {
namespace {

class ShapeWriter {
 public:
  explicit ShapeWriter(const ShapeCertificate& certificate) : c_(certificate), out_(4000) {}

  std::string text() {
    out_.word("fathom-certificate 2").end();
    if (!c_.id.empty()) out_.word("id").word(escaped(c_.id)).end();
    body(c_.a, "a", "shape_a", "halfspace_a", "radius_a");
    body(c_.b, "b", "shape_b", "halfspace_b", "radius_b");
    claim();
    if (c_.claim == ShapeClaim::signed_bounds) bracket();
    if (!of_half_space()) lower_side();
    if (c_.cone) cone(*c_.cone);
    out_.word("end");
    for (const std::size_t n : counts_) out_.word(n);
    out_.end();
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

  void body(const Shape& shape, std::string_view points, std::string_view terms, std::string_view half, std::string_view radius) {
    if (const HalfSpace* core = std::get_if<HalfSpace>(&shape.core)) out_.word(half).words(core->normal).word(core->offset).end();
    else if (const auto& all = std::get<std::vector<Term>>(shape.core); c_.claim == ShapeClaim::signed_bounds) write_terms(all, terms);
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

  const ShapeCertificate& c_;
  Writer out_;
  std::vector<std::size_t> counts_;
};

// One hull of points without a radius.
bool bare(const Shape& shape) { return shape.radius == 0 && shapes::require_all_but_points(shape); }

std::vector<Point> points_of(const Shape& shape) { return *shapes::polytope_points(shape, most_expanded_points); }

}  // namespace

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const ShapeCertificate& certificate) { return certificate::ShapeWriter(certificate).text(); }

std::string certificate_text(const Shape& a, const Shape& b, const SignedDepth& answer, std::string_view id, ShapeFormat format,
                             Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const Depth* const cores = std::get_if<Depth>(&answer.core);
  if (cores != nullptr && certificate::bare(a) && certificate::bare(b) && (format == ShapeFormat::shortest || !cores->touch()))
    return certificate_text(certificate::points_of(a), certificate::points_of(b), *cores, id, monitor);
  ShapeCertificate certificate = make_certificate(a, b, answer, monitor);
  certificate.id = id;
  return certificate_text(certificate);
}

}  // namespace fathom
