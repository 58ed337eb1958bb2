// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string_view>

#include "fathom/numbers.hpp"
#include "verify/golden/records/line_parts.hpp"
#include "verify/golden/unions/union_facts.hpp"

namespace fathom::golden {
namespace {

/// The members of an object that tells a length.
void write_length(JsonText& out, const mpq_class& squared) {
  out.key("squared").exact(squared);
  write_modes(out, rounded_root(squared));
}

void write_translation(JsonText& out, const Point& t) {
  out.key("translation").exact(t);
  write_rounded(out, "rounded", rounded_point(t));
}

/// In binary64 if the record is.
void write_body(JsonText& out, std::string_view key, const Pieces& pieces, bool hexadecimal) {
  out.key(key).open('{').key("pieces").open('[');
  for (const std::vector<Point>& piece : pieces) {
    out.open('{').key("vertices").open('[');
    for (const Point& p : piece) {
      if (hexadecimal) out.hex(std::array{round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
      else out.exact(p);
    }
    out.close(']').close('}');
  }
  out.close(']').close('}');
}

void write_known(JsonText& out, const KnownUnion& known) {
  out.key("known").open('{').key("status").text(name(known.status)).key("squared").exact(known.squared);
  out.key("optima").number(static_cast<std::int64_t>(known.optima)).close('}');
}

void write_gap(JsonText& out, const UnionGap& gap) {
  out.key("distance").open('{');
  write_length(out, gap.squared);
  out.key("pieces").open('[').number(gap.a).number(gap.b).close(']');
  write_translation(out, gap.translation);
  out.close('}');
}

void write_expected(JsonText& out, const UnionStatement& truth) {
  out.key("expected").open('{').key("status").text(name(truth.status)).key("depth").open('{');
  write_length(out, truth.squared);
  out.close('}').key("optima").open('[');
  for (const Point& t : truth.optima) {
    out.open('{');
    write_translation(out, t);
    out.close('}');
  }
  out.close(']');
  if (truth.gap) write_gap(out, *truth.gap);
  out.close('}');
}

}  // namespace

std::string line_of(const UnionFacts& facts) {
  const auto& [form, unions, known] = facts.bodies;
  const bool in_binary64 = unions_in_format(unions, Form::binary64), in_binary32 = unions_in_format(unions, Form::binary32);
  JsonText out;
  out.open('{').key("schema").text("fathom/case/1").key("golden").text("fathom/golden-unions/1").key("id").text(unions.id);
  out.key("source").open('{');
  write_source(out, facts.recipe, form);
  if (known) write_known(out, *known);
  out.close('}');
  write_formats(out, in_binary64, in_binary32);
  write_body(out, "a", *unions.a.pieces, in_binary64);
  write_body(out, "b", *unions.b.pieces, in_binary64);
  write_expected(out, facts.truth);
  out.key("certificate").open('{').key("sha256").text(facts.certificate_sha256).close('}');
  out.close('}');
  return out.take();
}

}  // namespace fathom::golden
