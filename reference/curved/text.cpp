// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds as text: a certificate of format 2, verify/check/FORMAT.md.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/curved/curved_bounds.hpp"

namespace fathom::curved {
namespace {

class Text {
 public:
  Text(const CurvedBounds& bounds, const Shape& a, const Shape& b, std::string_view escaped_id) {
    line("fathom-certificate 2");
    if (!escaped_id.empty()) line("id ", escaped_id);
    shape("a ", a);
    shape("b ", b);
    line("claim signed_bounds ", exact_text(bounds.low), " ", exact_text(bounds.high));
    const Bracket& proof = bounds.bracket;
    announce("directions ", 1, " some");
    line(proof.direction.x.get_str(), " ", proof.direction.y.get_str(), " ", proof.direction.z.get_str());
    const bool plane_a = std::holds_alternative<HalfSpace>(a.core), plane_b = std::holds_alternative<HalfSpace>(b.core);
    if (!plane_a) heights("heights_a ", proof.heights_a);
    if (!plane_b) heights("heights_b ", proof.heights_b);
    if (!plane_a) inner_points("inner_a ", proof.inner_a);
    if (!plane_b) inner_points("inner_b ", proof.inner_b);
    if (!plane_a && !plane_b) lower_side(proof);
    text_ += "end";
    for (const std::size_t count : counts_) text_ += " " + std::to_string(count);
    line("");
  }

  std::string take() { return std::move(text_); }

 private:
  template <class... Words>
  void line(const Words&... words) {
    ((text_ += words), ...);
    text_ += '\n';
  }
  void announce(std::string_view word, std::size_t count, std::string_view rest = "") {
    counts_.push_back(count);
    line(word, std::to_string(count), rest);
  }

  static std::string numbers(const Point& p) { return exact_text(p.x) + " " + exact_text(p.y) + " " + exact_text(p.z); }

  void shape(const std::string& name, const Shape& shape) {
    if (const auto* plane = std::get_if<HalfSpace>(&shape.core)) {
      line("halfspace_", name, numbers(plane->normal), " ", exact_text(plane->offset));
    } else {
      const auto& terms = std::get<std::vector<Term>>(shape.core);
      announce("shape_" + name, terms.size());
      for (const Term& term : terms) {
        announce("term ", term.atoms.size());
        for (const Atom& atom : term.atoms) {
          text_ += atom.axes.empty() ? "point " : atom.axes.size() == 2 ? "disc " : "ball ";
          text_ += numbers(atom.center);
          for (const Point& axis : atom.axes) text_ += " " + numbers(axis);
          line("");
        }
      }
    }
    if (shape.radius != 0) line("radius_", name, exact_text(shape.radius));
  }

  void heights(std::string_view name, const std::vector<mpq_class>& heights) {
    announce(name, heights.size());
    for (const mpq_class& height : heights) line(exact_text(height));
  }

  void inner_points(std::string_view name, const std::vector<InnerPoint>& points) {
    announce(name, points.size());
    for (const InnerPoint& point : points) {
      bool first = true;
      for (const AtomPoint& part : point) {
        if (!std::exchange(first, false)) text_ += ' ';
        text_ += std::to_string(part.atom);
        for (std::size_t k = 0; k < 3; ++k) text_ += k < part.local.size() ? " " + exact_text(part.local[k]) : " 0";
      }
      line("");
    }
  }

  void lower_side(const Bracket& proof) {
    if (proof.polytope.facets.empty()) {
      weights("weights_a ", proof.weights_a);
      weights("weights_b ", proof.weights_b);
      return;
    }
    announce("vertices ", proof.polytope.vertices.size());
    for (const auto& [a, b] : proof.polytope.vertices) line(std::to_string(b), " ", std::to_string(a));
    announce("facets ", proof.polytope.facets.size());
    for (const std::vector<std::uint32_t>& facet : proof.polytope.facets) {
      text_ += std::to_string(facet.size());
      for (const std::uint32_t corner : facet) text_ += " " + std::to_string(corner);
      line("");
    }
  }

  void weights(std::string_view name, const std::vector<Weight>& weights) {
    announce(name, weights.size());
    for (const Weight& w : weights) line(std::to_string(w.index), " ", exact_text(w.weight));
  }

  std::string text_;
  std::vector<std::size_t> counts_;
};

}  // namespace

std::string certificate_text(const CurvedBounds& bounds, const Shape& a, const Shape& b, std::string_view escaped_id) {
  return Text(bounds, a, b, escaped_id).take();
}

}  // namespace fathom::curved
