// SPDX-License-Identifier: Apache-2.0
#include "result.hpp"

#include <algorithm>

#include "budget.hpp"
#include "json.hpp"
#include "limits.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

/// The fields of one object that matter here; knows the line for messages.
class Fields {
 public:
  Fields(const Json& object, std::size_t line) : object_(&object), line_(line) {}

  [[nodiscard]] std::optional<std::string> text(std::string_view key, bool or_number = false) const {
    const Json* const field = object_->field(key, line_);
    if (!field) return std::nullopt;
    if (field->kind != Json::Kind::text && (!or_number || field->kind != Json::Kind::number)) throw wrong("a text", key);
    return field->text;
  }

  /// The field "squared" of an object.
  [[nodiscard]] std::optional<mpq_class> squared(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (!field) return std::nullopt;
    if (field->kind != Json::Kind::object) throw wrong("an object", key);
    const std::optional<std::string> text = Fields(*field, line_).text("squared");
    if (!text) throw wrong("an object with a field 'squared'", key);
    const std::optional<mpq_class> value = rational(*text);
    if (!value) throw wrong("an integer or a fraction, in the notation of certificates, for 'squared'", key);
    return value;
  }

 private:
  [[nodiscard]] Fault wrong(const std::string& expected, std::string_view key) const {
    return malformed(line_, "expected " + expected + " in the field " + shown(key));
  }

  static std::optional<mpq_class> rational(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string_view num = text.substr(0, slash), den = slash == std::string_view::npos ? "1" : text.substr(slash + 1);
    const std::string_view digits = num.substr(!num.empty() && num[0] == '-' ? 1 : 0);
    if (!is_natural(digits) || !is_natural(den) || std::max(digits.size(), den.size()) > longest_number) return std::nullopt;
    mpq_class result(to_integer(num), to_integer(den));
    if (result.get_den() == 0) return std::nullopt;
    result.canonicalize();
    return result;
  }

  const Json* object_;
  std::size_t line_;
};

mpq_class value(const Rational& r) { return {r.num.value(), r.den.value()}; }

}  // namespace

void read_result(std::string_view text, std::size_t line, Result& result) {
  Budget budget;
  JsonReader reader(text, line);
  const Json object = reader.next(budget);
  if (reader.more() || object.kind != Json::Kind::object) throw malformed(line, "expected one JSON object on the line");
  const Fields fields(object, line);
  result.id = fields.text("id", true);
  const std::optional<std::string> certificate = fields.text("certificate");
  if (!certificate) throw malformed(line, "expected a field 'certificate', found none");
  result.certificate = *certificate;
  result.status = fields.text("status");
  result.depth_squared = fields.squared("depth");
  result.bound_squared = fields.squared("bound");
}

void compare(const Result& result, const Certificate& c) {
  const auto demand = [&c](bool right, const char* fault) {
    if (!right) throw refused(c.claim_line, fault);
  };
  const char* const status = c.claim == Claim::touching ? "touching" : c.claim == Claim::disjoint ? "disjoint" : "penetrating";
  const bool has_depth = c.claim == Claim::depth || c.claim == Claim::bounds;  // else it is 0
  const mpq_class low = has_depth ? value(c.low) : mpq_class(0), high = has_depth ? value(c.high) : mpq_class(0);
  demand(!result.id || c.id.empty() || unescaped(c.id) == *result.id, "the result's id is another than the certificate's");
  demand(!result.status || *result.status == status, "the result's status is another than the certificate's");
  demand(!result.depth_squared || *result.depth_squared == high, "the result's depth is another than the certificate's");
  demand(!result.bound_squared || *result.bound_squared == low, "the result's bound is another than the certificate's");
  demand(!result.depth_squared || result.bound_squared || low == high, "the result has a depth, the certificate proves bounds only");
}

}  // namespace fathom_check
