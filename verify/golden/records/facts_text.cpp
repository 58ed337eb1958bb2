// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of facts.hpp: a line of JSON, and a row of CSV.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/answer_json.hpp"
#include "reference/text/json.hpp"
#include "verify/golden/records/facts.hpp"

namespace fathom::golden {

namespace {

using text::JsonStream;

// ---- numbers, lengths, vectors ----

constexpr std::array<std::string_view, 3> mode_names{"rn", "rd", "ru"};
constexpr std::size_t nearest = 0, down = 1, up = 2;

/// "f64": {"rn": .., "rd": .., "ru": ..}, "f32": {..}. put(out, values of one format, mode) writes
/// a value.
template <class Put>
void in_both_formats(JsonStream& out, Put put) {
  const auto in_every_mode = [&](std::string_view name, std::array<double, 3> Rounded::*format) {
    out.key(name).open('{');
    for (std::size_t mode = 0; mode < mode_names.size(); ++mode) {
      out.key(mode_names[mode]);
      put(format, mode);
    }
    out.close('}');
  };
  in_every_mode("f64", &Rounded::binary64);
  in_every_mode("f32", &Rounded::binary32);
}

void write_modes(JsonStream& out, const Rounded& value) {
  in_both_formats(out, [&](auto format, std::size_t mode) { out.hex((value.*format)[mode]); });
}

// `dimension`: 2 in the plane, where the third coordinate, which is 0, is left out.

void write_rounded(JsonStream& out, std::string_view key, const RoundedVector& vector, unsigned dimension = 3) {
  out.key(key).open('{');
  in_both_formats(out, [&](auto format, std::size_t mode) {
    out.open('[');
    for (const Rounded& component : std::span(vector).first(dimension)) out.hex((component.*format)[mode]);
    out.close(']');
  });
  out.close('}');
}

/// Writes the members of an object for a length.
void write_length(JsonStream& out, const mpq_class& squared, const Rounded& root) {
  out.key("squared").exact(squared);
  write_modes(out, root);
}

void write_vector(JsonStream& out, const Vector& v, unsigned dimension) {
  if (dimension == 3) out.exact(v);
  else out.open('[').exact(v.x).exact(v.y).close(']');
}

void write_direction(JsonStream& out, const Vector& n, const RoundedVector& unit, unsigned dimension = 3) {
  out.key("direction");
  write_vector(out, n, dimension);
  write_rounded(out, "unit", unit, dimension);
}

void write_translation(JsonStream& out, const Point& t, const RoundedVector& rounded) {
  out.key("translation").exact(t);
  write_rounded(out, "rounded", rounded);
}

/// Writes the value sign sqrt(root) + plus.
void write_surd(JsonStream& out, std::string_view key, const Surd& value) {
  out.key(key).open('{').key("sign").integer(sgn(value.root));
  out.key("root").exact(mpq_class(abs(value.root))).key("plus").exact(value.rational).close('}');
}

// ---- bodies ----

/// Numbers of bodies: hexadecimal floats if all of the record's are binary64, else exact.
class BodyText {
 public:
  BodyText(JsonStream& out, bool hexadecimal) : out_(out), hexadecimal_(hexadecimal) {}

  void write(const Body& body) {
    if (body.shape) return write_plane(*body.shape);
    out_.open('{').key("vertices").open('[');
    if (hexadecimal_) {
      for (const std::array<double, 3>& p : body.points.binary64()) out_.hex(p);
    } else {
      for (const Point& p : body.points) out_.exact(p);
    }
    out_.close(']').close('}');
  }

  void write(const Pieces& pieces) {
    out_.open('{').key("pieces").open('[');
    for (const std::vector<Point>& piece : pieces) {
      out_.open('{');
      vertices(piece);
      out_.close('}');
    }
    out_.close(']').close('}');
  }

  void write(const families::NamedBody& body) {
    const files::ShapeName& shape = *files::named_shape(body.shape).shape;
    out_.open('{').key("shape").plain(body.shape);
    for (const files::NumberField& field : shape.numbers) numbers(body, field.name);
    if (shape.part == files::ShapePart::axis)
      out_.key("axis").plain(std::array{"x", "y", "z"}.at(static_cast<std::size_t>(body.fields.axis)));
    if (shape.part == files::ShapePart::vertices) vertices(body.fields.vertices);
    if (shape.part == files::ShapePart::terms) {
      out_.key("terms").open('[');
      for (const families::NamedBody& term : body.terms) write(term);
      out_.close(']');
    }
    numbers(body, "margin");
    out_.key("pose").open('{').key("quaternion").open('[');
    for (const mpq_class* part : {&body.turn.w, &body.turn.x, &body.turn.y, &body.turn.z}) number(*part);
    out_.close(']').key("translation");
    point(body.place);
    out_.close('}').close('}');
  }

 private:
  /// Writes a body of the plane.
  void write_plane(const Shape& shape) {
    const std::vector<Point> core = files::points_of(shape).value();
    out_.open('{').key("vertices").open('[');
    for (const Point& p : core) {
      out_.open('[');
      number(p.x);
      number(p.y);
      out_.close(']');
    }
    out_.close(']');
    if (shape.radius > 0) {
      out_.key("margin");
      number(shape.radius);
    }
    out_.close('}');
  }
  void number(const mpq_class& value) { hexadecimal_ ? out_.hex(round_binary64(value)) : out_.exact(value); }
  void point(const Point& p) {
    out_.open('[');
    for (const mpq_class* coordinate : {&p.x, &p.y, &p.z}) number(*coordinate);
    out_.close(']');
  }
  void vertices(const std::vector<Point>& points) {
    out_.key("vertices").open('[');
    for (const Point& p : points) point(p);
    out_.close(']');
  }
  /// Writes a number or a triple, if the body has that field.
  void numbers(const families::NamedBody& body, std::string_view name) {
    const auto found = body.fields.numbers.find(name);
    if (found == body.fields.numbers.end()) return;
    out_.key(name);
    if (found->second.size() == 1) return number(found->second.front());
    out_.open('[');
    for (const mpq_class& value : found->second) number(value);
    out_.close(']');
  }

  JsonStream& out_;
  bool hexadecimal_;
};

void write_known(JsonStream&, const HullPair&) {}
void write_known(JsonStream&, const families::PlanePair&) {}

void write_known(JsonStream& out, const families::NamedPair& shapes) {
  if (shapes.known) write_surd(out, "signed_depth", shapes.known->signed_depth);
}

void write_known(JsonStream& out, const Unions& unions) {
  if (!unions.known) return;
  const auto& [status, squared, optima] = *unions.known;
  out.key("known").open('{').key("status").plain(name(status)).key("squared").exact(squared);
  out.key("optima").integer(optima).close('}');
}

// ---- the answer: the members of the object "expected" ----

void write_flat(JsonStream& out, bool flat_a, bool flat_b) {
  out.key("flat").open('[');
  if (flat_a) out.plain("a");
  if (flat_b) out.plain("b");
  out.close(']');
}

void write_depth(JsonStream& out, Status status, const mpq_class& squared, const Rounded& root) {
  out.key("status").plain(name(status)).key("depth").open('{');
  write_length(out, squared, root);
  out.close('}');
}

void write_witness(JsonStream& out, const Witness& witness) {
  out.key("witness").open('{').key("a").exact(witness.a).key("b").exact(witness.b).close('}');
}

void write_contact(JsonStream& out, const Contact& contact) {
  out.key("contact").open('{').key("kind").plain(name(contact.kind));
  out.key("a").array_of(contact.a);
  out.key("b").array_of(contact.b);
  out.close('}');
}

void write_gap(JsonStream& out, const HullStatement& truth) {
  out.key("gap");
  if (!truth.gap) {
    out.null();
    return;
  }
  const mpq_class relative = *truth.gap / truth.answer.squared() - 1;
  out.open('{').key("squared").exact(*truth.gap).key("relative").hex(round_binary64(relative, Rounding::rn)).close('}');
}

void write_expected(JsonStream& out, const HullStatement& truth, const RecordBodies&) {
  const Depth& answer = truth.answer;
  write_depth(out, answer.status(), answer.squared(), truth.depth);
  write_flat(out, answer.flat_a, answer.flat_b);
  out.key("optima").open('[');
  const std::vector<Optimum>& optima = answer.optima();
  for (std::size_t i = 0; i < optima.size(); ++i) {
    const Contact& contact = optima[i].contact;
    out.open('{');
    write_direction(out, optima[i].direction, truth.units[i]);
    write_translation(out, optima[i].translation(), truth.translations[i]);
    write_contact(out, contact);
    out.close('}');
  }
  out.close(']');
  if (answer.status() == Status::penetrating) write_gap(out, truth);
  else write_direction(out, answer.direction(), truth.units.front());
  if (const std::optional<Witness> witness = answer.witness()) write_witness(out, *witness);
  if (const Distance* const distance = answer.distance()) {
    out.key("distance").open('{');
    write_length(out, distance->squared, truth.distance);
    write_translation(out, distance->translation, truth.translations.front());
    write_witness(out, distance->witness);
    out.close('}');
  }
}

std::string_view status_of(const ShapeStatement& truth) {
  const Surd* const exact = std::get_if<Surd>(&truth.value);
  const Bounds* const bounds = std::get_if<Bounds>(&truth.value);
  const int low = exact ? sign(*exact) : sgn(bounds->low), high = exact ? low : sgn(bounds->high);
  if (low != high) return name(std::optional<Status>());
  return name(low > 0 ? Status::penetrating : low < 0 ? Status::disjoint : Status::touching);
}

void write_value(JsonStream& out, const ShapeStatement& truth) {
  const auto write_ends = [&out](const Rounded& low, const Rounded& high) {
    out.key("low").hex(low.binary64[down]).key("high").hex(high.binary64[up]);
  };
  out.key("signed_depth").open('{');
  if (const Surd* const exact = std::get_if<Surd>(&truth.value)) {
    const Rounded rounded = rounded_surd(*exact);
    write_ends(rounded, rounded);
    write_surd(out, "exact", *exact);
    write_modes(out, rounded);
  } else {
    const auto& [low, high] = std::get<Bounds>(truth.value);
    write_ends(rounded_value(low), rounded_value(high));
    out.key("bounds").open('[').exact(low).exact(high).close(']');
  }
  out.close('}');
}

void write_cone(JsonStream& out, const OptimalCone& cone, unsigned dimension) {
  out.key("optimal_cone").open('{').key("lineality").plain(output::lineality_name(cone)).key("axis");
  if (cone.lineality == Lineality::line || cone.lineality == Lineality::plane) write_vector(out, cone.axis, dimension);
  else out.null();
  out.key("rays").open('[');
  for (const Vector& ray : cone.rays) write_vector(out, ray, dimension);
  out.close(']').close('}');
}

/// `contacts`: one for each translation, or none.
void write_signed_depth(JsonStream& out, const ShapeStatement& truth, std::array<bool, 2> flat, unsigned dimension,
                        std::span<const Contact> contacts) {
  out.key("status").plain(status_of(truth));
  write_value(out, truth);
  write_flat(out, flat[0], flat[1]);
  write_direction(out, truth.direction, rounded_unit(truth.direction), dimension);
  out.key("translations").open('[');
  for (std::size_t i = 0; i < truth.translations.size(); ++i) {
    const AlongNormal& along = truth.translations[i];
    out.open('{').key("normal");
    write_vector(out, along.normal, dimension);
    out.key("alpha").exact(along.alpha).key("beta").exact(along.beta);
    write_rounded(out, "rounded", rounded_along(along), dimension);
    if (!contacts.empty()) write_contact(out, contacts[i]);
    out.close('}');
  }
  out.close(']');
  if (truth.cone) write_cone(out, *truth.cone, dimension);
}

void write_expected(JsonStream& out, const ShapeStatement& truth, const RecordBodies& bodies) {
  const auto& [a, b, known] = std::get<families::NamedPair>(bodies);
  write_signed_depth(out, truth, {is_flat(families::shape_of(a)), is_flat(families::shape_of(b))}, 3, {});
}

void write_expected(JsonStream& out, const PlaneStatement& truth, const RecordBodies& bodies) {
  const auto& [a, b] = std::get<families::PlanePair>(bodies);
  write_signed_depth(out, truth.shapes, {answer::is_flat_body(a), answer::is_flat_body(b)}, 2, truth.contacts);
}

void write_expected(JsonStream& out, const UnionStatement& truth, const RecordBodies&) {
  write_depth(out, truth.status, truth.squared, rounded_root(truth.squared));
  out.key("optima").open('[');
  for (const Point& t : truth.optima) {
    out.open('{');
    write_translation(out, t, rounded_point(t));
    out.close('}');
  }
  out.close(']');
  if (!truth.gap) return;
  out.key("distance").open('{');
  write_length(out, truth.gap->squared, rounded_root(truth.gap->squared));
  out.key("pieces").open('[').integer(truth.gap->a).integer(truth.gap->b).close(']');
  write_translation(out, truth.gap->translation, rounded_point(truth.gap->translation));
  out.close('}');
}

void write_contacts(JsonStream& out, const ContactFacts& contacts) {
  out.key("manifold").value(output::manifold_object(contacts.manifold).text());
  out.key("derivatives").open('[');
  for (std::size_t i = 0; i < contacts.derivatives.size(); ++i) {
    const Twist& motion = recorded_motions()[i];
    out.open('{').key("v").exact(motion.v).key("w").exact(motion.w);
    out.key("derivative").value(output::derivative_object(contacts.derivatives[i]).text()).close('}');
  }
  out.close(']');
}

}  // namespace

void open_line(JsonStream& out, std::string_view schema) {
  out.open('{').key("schema").plain(files::case_schema).key("golden").plain(schema).key("id");
}

std::string line_of(const Facts& facts) {
  const auto& [recipe, made, in_binary64, in_binary32, truth, sha256, contacts] = facts;
  JsonStream out;
  open_line(out, record_schemas.at(truth.index()));
  out.plain(made.id);
  out.key("source").open('{').key("kind").plain(name_of(recipe.source)).key("name").plain(recipe.name);
  if (from_family(recipe.source)) out.key("size").integer(recipe.size).key("seed").plain(std::to_string(recipe.seed));
  out.key("form").plain(name_of(made.form));
  std::visit([&out](const auto& bodies) { write_known(out, bodies); }, made.bodies);
  out.close('}').key("formats").open('[').plain("exact");
  if (in_binary64) out.plain("binary64");
  if (in_binary32) out.plain("binary32");
  out.close(']');
  if (const auto* const hulls = std::get_if<HullStatement>(&truth)) {
    out.key("flags").open('[');
    for (const std::string_view flag : hulls->flags) out.plain(flag);
    out.close(']');
  }
  if (std::holds_alternative<families::PlanePair>(made.bodies)) out.key("dimension").integer(2);
  BodyText body_text(out, in_binary64);
  const auto write_bodies = [&out, &body_text](const auto& bodies) {
    out.key("a");
    body_text.write(bodies.a);
    out.key("b");
    body_text.write(bodies.b);
  };
  std::visit(write_bodies, made.bodies);
  out.key("expected").open('{');
  std::visit([&out, &facts](const auto& says) { write_expected(out, says, facts.made.bodies); }, truth);
  if (contacts) write_contacts(out, *contacts);
  out.close('}').key("certificate").open('{').key("sha256").plain(sha256).close('}').close('}');
  return out.take();
}

// ---- CSV ----

namespace {

using Triple = std::array<double, 3>;

Triple to_nearest(const RoundedVector& v) {
  return {v[0].binary64[nearest], v[1].binary64[nearest], v[2].binary64[nearest]};
}

void append_joined(const Triple& p, char separator, std::string& text) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i > 0) text += separator;
    kernels::append_hex(p[i], text);
  }
}

}  // namespace

std::string csv_header() {
  return "id,status,format,flags,depth_squared,depth_f64_rn,depth_f64_rd,depth_f64_ru,depth_f32_rn,depth_f32_rd,depth_"
         "f32_ru,"
         "direction_x,direction_y,direction_z,translation_x,translation_y,translation_z,optima,contact,distance,"
         "a_count,a_points,b_count,b_points\n";
}

std::string csv_row(const Facts& facts) {
  const auto* const truth = std::get_if<HullStatement>(&facts.truth);
  if (!truth || !facts.in_binary64 || facts.contacts) return "";
  const auto& [a, b] = std::get<HullPair>(facts.made.bodies);
  const std::vector<Optimum>& optima = truth->answer.optima();
  std::string row = facts.made.id + ',';
  ((row += name(truth->answer.status())) += ',') += facts.in_binary32 ? "binary32," : "binary64,";
  for (std::size_t i = 0; i < truth->flags.size(); ++i) (row += i == 0 ? "" : " ") += truth->flags[i];
  row += ',' + exact_text(truth->answer.squared());
  for (const auto& format : {truth->depth.binary64, truth->depth.binary32}) {
    row += ',';
    append_joined(format, ',', row);
  }
  row += ',';
  append_joined(to_nearest(truth->units.front()), ',', row);
  row += ',';  // the translation of the first optimum; zero if the bodies touch, to the contact if they are disjoint
  append_joined(truth->translations.empty() ? Triple{} : to_nearest(truth->translations.front()), ',', row);
  row += ',' + std::to_string(optima.size()) + ',';
  if (!optima.empty()) row += name(optima.front().contact.kind);
  row += ',';
  kernels::append_hex(truth->distance.binary64[nearest], row);
  for (const Body* body : {&a, &b}) {
    row += ',' + std::to_string(body->points.size());
    char before = ',';
    for (const Triple& p : body->points.binary64()) {
      row += std::exchange(before, ' ');
      append_joined(p, ' ', row);
    }
  }
  return row + '\n';
}

}  // namespace fathom::golden
