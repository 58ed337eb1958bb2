// SPDX-License-Identifier: Apache-2.0
#include "result.hpp"

#include "budget.hpp"
#include "json.hpp"
#include "number.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

std::optional<std::string> text_field(const Json& object, std::string_view key, std::size_t line) {
  const Json* const field = object.field(key, line);
  if (!field || field->kind == Json::Kind::null) return std::nullopt;
  if (field->kind != Json::Kind::text) throw malformed(line, "expected a text for the field " + shown(key));
  return field->text;
}

mpq_class value(const Rational& r) {
  mpq_class result(r.num, r.den);
  result.canonicalize();
  return result;
}

}  // namespace

void read_result(std::string_view text, std::size_t line, Result& result) {
  Budget budget;
  JsonReader reader(text, line);
  const Json object = reader.next(budget);
  if (reader.more() || object.kind != Json::Kind::object) throw malformed(line, "expected one JSON object on the line");
  if (const Json* const id = object.field("id", line)) result.id = escaped(id->text);
  const std::optional<std::string> certificate = text_field(object, "certificate", line);
  if (!certificate) throw malformed(line, "expected a field 'certificate', found none");
  result.certificate = *certificate;
  result.status = text_field(object, "status", line);
  const Json* const depth = object.field("depth", line);
  if (depth && depth->kind == Json::Kind::object) result.depth_squared = text_field(*depth, "squared", line);
}

void compare(const Result& result, const Certificate& c) {
  const char* const status = c.claim == Claim::touching ? "touching" : c.claim == Claim::disjoint ? "disjoint" : "penetrating";
  if (result.status && *result.status != status) throw refused(c.claim_line, "the result's status is another than the certificate's");
  if (!result.depth_squared) return;
  const std::optional<mpq_class> squared = exact_number(*result.depth_squared);
  const bool has_depth = c.claim == Claim::depth || c.claim == Claim::bounds;  // else it is 0
  const mpq_class low = has_depth ? value(c.low) : mpq_class(0), high = has_depth ? value(c.high) : mpq_class(0);
  if (!squared || *squared < low || *squared > high) throw refused(c.claim_line, "the result's depth is another than the certificate's");
}

}  // namespace fathom_check
