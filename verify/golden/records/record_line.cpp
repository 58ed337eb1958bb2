// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_line.hpp"

#include "fathom/numbers.hpp"
#include "verify/golden/records/json_text.hpp"
#include "verify/golden/records/line_parts.hpp"

namespace fathom::golden {
namespace {

/// The members of an object that tells a length.
void write_length(JsonText& out, const mpq_class& squared, const Rounded& root) {
  out.key("squared").exact(squared);
  write_modes(out, root);
}

void write_indices(JsonText& out, std::string_view key, const std::vector<std::uint32_t>& indices) {
  out.key(key).open('[');
  for (const std::uint32_t i : indices) out.number(i);
  out.close(']');
}

void write_translation(JsonText& out, const Point& t, const RoundedVector& rounded) {
  out.key("translation").exact(t);
  write_rounded(out, "rounded", rounded);
}

void write_witness(JsonText& out, const Witness& witness) {
  out.key("witness").open('{').key("a").exact(witness.a).key("b").exact(witness.b).close('}');
}

void write_optimum(JsonText& out, const Optimum& optimum, const RoundedVector& unit, const RoundedVector& rounded) {
  out.open('{');
  write_direction(out, optimum.direction, unit);
  write_translation(out, optimum.translation(), rounded);
  out.key("contact").open('{').key("kind").text(name(optimum.contact.kind));
  write_indices(out, "a", optimum.contact.a);
  write_indices(out, "b", optimum.contact.b);
  out.close('}').close('}');
}

void write_gap(JsonText& out, const Facts& facts) {
  out.key("gap");
  if (!facts.gap) {
    out.null();
    return;
  }
  const mpq_class relative = *facts.gap / facts.answer.squared() - 1;
  out.open('{').key("squared").exact(*facts.gap).key("relative").hex(round_binary64(relative, Rounding::rn)).close('}');
}

void write_distance(JsonText& out, const Distance& distance, const RoundedResults& rounded) {
  out.key("distance").open('{');
  write_length(out, distance.squared, rounded.distance);
  write_translation(out, distance.translation, rounded.translations.front());
  write_witness(out, distance.witness);
  out.close('}');
}

void write_expected(JsonText& out, const Facts& facts) {
  out.key("expected").open('{').key("status").text(name(facts.answer.status()));
  out.key("depth").open('{');
  write_length(out, facts.answer.squared(), facts.rounded.depth);
  out.close('}').key("flat").open('[');
  if (facts.answer.flat_a) out.text("a");
  if (facts.answer.flat_b) out.text("b");
  out.close(']').key("optima").open('[');
  const std::vector<Optimum>& optima = facts.answer.optima();
  for (std::size_t i = 0; i < optima.size(); ++i) write_optimum(out, optima[i], facts.rounded.units[i], facts.rounded.translations[i]);
  out.close(']');
  if (facts.answer.status() == Status::penetrating) write_gap(out, facts);
  if (facts.answer.status() != Status::penetrating) write_direction(out, facts.answer.direction(), facts.rounded.units.front());
  if (const std::optional<Witness> witness = facts.answer.witness()) write_witness(out, *witness);
  if (facts.answer.distance()) write_distance(out, *facts.answer.distance(), facts.rounded);
  out.close('}');
}

/// In binary64 if the record is.
void write_body(JsonText& out, std::string_view key, const Body& body, bool hexadecimal) {
  out.key(key).open('{').key("vertices").open('[');
  if (hexadecimal) {
    for (const std::array<double, 3>& p : body.points.binary64()) out.hex(p);
  } else {
    for (const Point& p : body.points) out.exact(p);
  }
  out.close(']').close('}');
}

}  // namespace

std::string line_of(const Facts& facts) {
  JsonText out;
  out.open('{').key("schema").text("fathom/case/1").key("golden").text("fathom/golden/1").key("id").text(facts.points.id);
  out.key("source").open('{');
  write_source(out, facts.recipe, facts.form);
  out.close('}');
  write_formats(out, facts.in_binary64, facts.in_binary32);
  out.key("flags").open('[');
  for (const std::string_view flag : facts.flags) out.text(flag);
  out.close(']');
  write_body(out, "a", facts.points.a, facts.in_binary64);
  write_body(out, "b", facts.points.b, facts.in_binary64);
  write_expected(out, facts);
  out.key("certificate").open('{').key("sha256").text(facts.certificate_sha256).close('}');
  out.close('}');
  return out.take();
}

}  // namespace fathom::golden
