// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string_view>

#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/golden/records/line_parts.hpp"
#include "verify/golden/shapes/shape_facts.hpp"

namespace fathom::golden {
namespace {

/// Numbers of bodies: hexadecimal floats if all of the record's are binary64, else exact.
class BodyText {
 public:
  BodyText(JsonText& out, bool hexadecimal) : out_(out), hexadecimal_(hexadecimal) {}

  void write(const families::NamedBody& body) {
    const files::ShapeName& shape = *files::named_shape(body.shape).shape;
    out_.open('{').key("shape").text(body.shape);
    for (const files::NumberField& field : shape.numbers) numbers(body, field.name);
    if (shape.part == files::ShapePart::axis)
      out_.key("axis").text(std::array{"x", "y", "z"}.at(static_cast<std::size_t>(body.fields.axis)));
    if (shape.part == files::ShapePart::vertices) {
      out_.key("vertices").open('[');
      for (const Point& p : body.fields.vertices) write(p);
      out_.close(']');
    }
    if (shape.part == files::ShapePart::terms) {
      out_.key("terms").open('[');
      for (const families::NamedBody& term : body.terms) write(term);
      out_.close(']');
    }
    numbers(body, "margin");
    out_.key("pose").open('{').key("quaternion").open('[');
    for (const mpq_class* part : {&body.turn.w, &body.turn.x, &body.turn.y, &body.turn.z}) write(*part);
    out_.close(']').key("translation");
    write(body.place);
    out_.close('}').close('}');
  }

 private:
  void write(const mpq_class& value) { hexadecimal_ ? out_.hex(round_binary64(value)) : out_.exact(value); }
  void write(const Point& p) {
    out_.open('[');
    for (const mpq_class* coordinate : {&p.x, &p.y, &p.z}) write(*coordinate);
    out_.close(']');
  }
  /// A number or three, if the body has that field.
  void numbers(const families::NamedBody& body, std::string_view name) {
    const auto found = body.fields.numbers.find(name);
    if (found == body.fields.numbers.end()) return;
    out_.key(name);
    if (found->second.size() == 1) return write(found->second.front());
    out_.open('[');
    for (const mpq_class& value : found->second) write(value);
    out_.close(']');
  }

  JsonText& out_;
  bool hexadecimal_;
};

/// sign sqrt(root) + plus.
void write_surd(JsonText& out, std::string_view key, const Surd& value) {
  out.key(key).open('{').key("sign").number(sgn(value.root));
  out.key("root").exact(mpq_class(abs(value.root))).key("plus").exact(value.rational).close('}');
}

std::string_view status_of(const ShapeStatement& truth) {
  const Surd* const exact = std::get_if<Surd>(&truth.value);
  const Bounds* const bounds = std::get_if<Bounds>(&truth.value);
  const int low = exact ? sign(*exact) : sgn(bounds->low), high = exact ? low : sgn(bounds->high);
  if (low != high) return "undecided";
  return name(low > 0 ? Status::penetrating : low < 0 ? Status::disjoint : Status::touching);
}

void write_ends(JsonText& out, const Rounded& low, const Rounded& high) {
  constexpr std::size_t down = 1, up = 2;
  out.key("low").hex(low.binary64[down]).key("high").hex(high.binary64[up]);
}

void write_value(JsonText& out, const ShapeStatement& truth) {
  out.key("signed_depth").open('{');
  if (const Surd* const exact = std::get_if<Surd>(&truth.value)) {
    const Rounded rounded = rounded_surd(*exact);
    write_ends(out, rounded, rounded);
    write_surd(out, "exact", *exact);
    write_modes(out, rounded);
  } else {
    const auto& [low, high] = std::get<Bounds>(truth.value);
    write_ends(out, rounded_value(low), rounded_value(high));
    out.key("bounds").open('[').exact(low).exact(high).close(']');
  }
  out.close('}');
}

void write_cone(JsonText& out, const OptimalCone& cone) {
  constexpr std::array<std::string_view, 4> names{"none", "line", "plane", "all"};
  out.key("optimal_cone").open('{').key("lineality").text(names.at(static_cast<std::size_t>(cone.lineality))).key("axis");
  if (cone.lineality == Lineality::line || cone.lineality == Lineality::plane) out.exact(cone.axis);
  else out.null();
  out.key("rays").open('[');
  for (const Vector& ray : cone.rays) out.exact(ray);
  out.close(']').close('}');
}

void write_expected(JsonText& out, const ShapeStatement& truth, const families::NamedPair& bodies) {
  out.key("expected").open('{').key("status").text(status_of(truth));
  write_value(out, truth);
  out.key("flat").open('[');
  if (is_flat(families::shape_of(bodies.a))) out.text("a");
  if (is_flat(families::shape_of(bodies.b))) out.text("b");
  out.close(']');
  write_direction(out, truth.direction, rounded_unit(truth.direction));
  out.key("translations").open('[');
  for (const AlongNormal& along : truth.translations) {
    out.open('{').key("normal").exact(along.normal).key("alpha").exact(along.alpha).key("beta").exact(along.beta);
    write_rounded(out, "rounded", rounded_along(along));
    out.close('}');
  }
  out.close(']');
  if (truth.cone) write_cone(out, *truth.cone);
  out.close('}');
}

}  // namespace

std::string line_of(const ShapeFacts& facts) {
  const auto& [id, pair] = facts.bodies.shapes;
  const bool in_binary64 = in_format(pair, Form::binary64), in_binary32 = in_format(pair, Form::binary32);
  JsonText out;
  out.open('{').key("schema").text("fathom/case/1").key("golden").text("fathom/golden-shapes/1").key("id").text(id);
  out.key("source").open('{');
  write_source(out, facts.recipe, facts.bodies.form);
  if (pair.known) write_surd(out, "signed_depth", pair.known->signed_depth);
  out.close('}');
  write_formats(out, in_binary64, in_binary32);
  BodyText bodies(out, in_binary64);
  out.key("a");
  bodies.write(pair.a);
  out.key("b");
  bodies.write(pair.b);
  write_expected(out, facts.truth, pair);
  out.key("certificate").open('{').key("sha256").text(facts.certificate_sha256).close('}');
  out.close('}');
  return out.take();
}

}  // namespace fathom::golden
