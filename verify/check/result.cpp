// SPDX-License-Identifier: Apache-2.0
#include "result.hpp"

#include <algorithm>

#include "checks.hpp"
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
    if (field->kind != Json::Kind::text && (!or_number || field->kind != Json::Kind::number))
      throw wrong("a text", key);
    return field->text;
  }

  [[nodiscard]] std::optional<Result::Square> square(std::string_view key) const {
    const std::optional<Fields> fields = object(key);
    if (!fields) return std::nullopt;
    const Json* const squared = fields->object_->field("squared", line_);
    if (squared && squared->kind == Json::Kind::null) return Result::Square{};
    return Result::Square{fields->rational("squared")};
  }

  /// Of unions it is in the field "apart", which is null unless they are.
  [[nodiscard]] std::vector<Result::Square> distances() const {
    std::vector<Result::Square> result;
    if (const auto found = square("distance")) result.push_back(*found);
    const Json* const of_unions = object_->field("apart", line_);
    if (!of_unions || of_unions->kind == Json::Kind::null) return result;
    if (const auto found = object("apart")->square("distance")) result.push_back(*found);
    return result;
  }

  [[nodiscard]] std::optional<Result::SignedDepth> signed_depth(std::string_view key) const {
    const std::optional<Fields> fields = object(key);
    if (!fields) return std::nullopt;
    Result::SignedDepth result{fields->number("low"), fields->number("high"), std::nullopt};
    const Json* const exact = fields->object_->field("exact", line_);
    if (!exact || exact->kind == Json::Kind::null) return result;
    const Fields parts = *fields->object("exact");
    result.exact = Result::Exact{parts.sign("sign"), parts.rational("root"), parts.rational("plus")};
    return result;
  }

 private:
  [[nodiscard]] std::optional<Fields> object(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (!field) return std::nullopt;
    if (field->kind != Json::Kind::object) throw wrong("an object", key);
    return Fields(*field, line_);
  }

  /// A text that holds an exact number.
  [[nodiscard]] mpq_class rational(std::string_view key) const {
    const std::optional<std::string> found = text(key);
    const std::optional<mpq_class> value = found ? rational_of(*found) : std::nullopt;
    if (!value) throw wrong("an integer or a fraction, in the notation of certificates,", key);
    return *value;
  }

  /// A number, or null.
  [[nodiscard]] std::optional<mpq_class> number(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (field && field->kind == Json::Kind::null) return std::nullopt;
    std::optional<mpq_class> value;
    if (field && field->kind == Json::Kind::number) value = nearest_binary64(field->text);
    if (!value) throw wrong("a number within the range of binary64, or null,", key);
    return value;
  }

  [[nodiscard]] int sign(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (field && field->kind == Json::Kind::number)
      for (const int sign : {-1, 0, 1})
        if (field->text == std::to_string(sign)) return sign;
    throw wrong("-1, 0 or 1", key);
  }

  [[nodiscard]] Fault wrong(const std::string& expected, std::string_view key) const {
    return malformed(line_, "expected " + expected + " in the field " + shown(key));
  }

  static std::optional<mpq_class> rational_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string_view num = text.substr(0, slash),
                           den = slash == std::string_view::npos ? "1" : text.substr(slash + 1);
    const std::string_view digits = num.substr(!num.empty() && num[0] == '-' ? 1 : 0);
    if (!is_natural(digits) || !is_natural(den) || std::max(digits.size(), den.size()) > longest_number)
      return std::nullopt;
    mpq_class result(to_integer(num), to_integer(den));
    if (result.get_den() == 0) return std::nullopt;
    result.canonicalize();
    return result;
  }

  const Json* object_;
  std::size_t line_;
};

/// With its sign.
mpq_class squared(const mpq_class& x) { return x * abs(x); }

/// How x compares with the signed depth, of which this bound was proved.
int compare_with(const mpq_class& x, const Certificate& c, const Rational& bound) {
  if (is_exact(c)) return cmp(squared(x - radii(c)), squared_of_cores(c));
  return c.claim == Claim::bounds ? cmp(squared(x), value(bound)) : cmp(x, value(bound));
}

bool is_proved(const Result::Exact& exact, const Certificate& c) {
  if (exact.root < 0 || (exact.sign == 0) != (exact.root == 0)) return false;
  if (is_exact(c)) return exact.sign * exact.root == squared_of_cores(c) && exact.plus == radii(c);
  return c.claim == Claim::signed_bounds && exact.sign == 0 && exact.plus == value(c.low) &&
         exact.plus == value(c.high);
}

/// Whether the root of `square` is the depth or the distance that is proved: x^2 = square for the
/// signed depth x. If it is root + rho, the square is square(root) + 2 rho root + rho^2: so it must
/// be (square + rho^2 - square(root)) / (2 rho).
bool is_square_of_signed_depth(const mpq_class& square, const Certificate& c) {
  if (!is_exact(c)) return value(c.low) == value(c.high) && square == value(c.low) * value(c.low);
  const mpq_class rho = radii(c), cores = squared_of_cores(c);
  if (rho == 0) return square == abs(cores);
  const mpq_class depth = (square + rho * rho - abs(cores)) / (2 * rho);
  return depth * depth == square && sgn(depth - rho) == sgn(cores);
}

/// Whether the result's depth is that of a certificate of format 2 or 4: 0 unless they penetrate,
/// and then null or its square.
bool is_depth(const std::optional<mpq_class>& square, const Certificate& c) {
  const std::string_view state = status(c);
  if (state == "penetrating") return !square || is_square_of_signed_depth(*square, c);
  return state == "undecided" ? !square : square && *square == 0;
}

/// Whether the result's distance is that of a certificate of another format than 1: of bodies
/// that are disjoint, null or its square.
bool is_distance(const std::optional<mpq_class>& square, const Certificate& c) {
  if (std::string_view(status(c)) != "disjoint") return false;
  return is_of_unions(c) ? square && *square == value(c.low) : !square || is_square_of_signed_depth(*square, c);
}

/// `disjoint` proves that the signed depth is negative, and nothing else.
bool says_negative_alone(const Result::SignedDepth& depth) {
  return !depth.low && (!depth.high || *depth.high >= 0) && !depth.exact;
}

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
  result.depth = fields.square("depth");
  result.bound = fields.square("bound");
  result.signed_depth = fields.signed_depth("signed_depth");
  result.distances = fields.distances();
}

void compare(const Result& result, const Certificate& c) {
  const auto demand = [&c](bool right, const char* fault) {
    if (!right) throw refused(c.claim_line, fault);
  };
  demand(c.claim != Claim::solid, "a solid is no result");
  demand(c.format != 6, "a result of bodies at rest, of a certificate of bodies in motion");
  demand(!result.id || c.id.empty() || unescaped(c.id) == *result.id,
         "the result's id is another than the certificate's");
  demand(!result.status || *result.status == status(c), "the result's status is another than the certificate's");
  if (c.claim == Claim::disjoint)
    demand(result.distances.empty() && (!result.signed_depth || says_negative_alone(*result.signed_depth)),
           "distance not proved: 'disjoint' says that there is one, not how long it is");
  for (const Result::Square& distance : result.distances)
    demand(is_distance(distance.value, c), "the result's distance is another than the certificate's");
  if (is_of_unions(c)) {
    demand(!result.depth || result.depth->value == (c.claim == Claim::depth ? value(c.low) : 0),
           "the result's depth is another than the certificate's");
    demand(!result.bound && !result.signed_depth,
           "the result has a bound or a signed depth, which do not go with unions");
    return;
  }
  if (result.signed_depth && c.claim != Claim::disjoint) {
    const auto& [low, high, exact] = *result.signed_depth;
    demand(!low || compare_with(*low, c, c.low) <= 0, "the result's signed depth is above what the certificate proves");
    demand(!high || compare_with(*high, c, c.high) >= 0,
           "the result's signed depth is below what the certificate proves");
    demand(!exact || is_proved(*exact, c), "the result's exact signed depth is another than the certificate's");
  }
  if (is_of_bodies(c.format)) {
    demand(!result.depth || is_depth(result.depth->value, c), "the result's depth is another than the certificate's");
    return demand(!result.bound, "the result has a bound, which goes with format 1");
  }
  const mpq_class low = value(c.low), high = value(c.high);
  demand(!result.depth || result.depth->value == high, "the result's depth is another than the certificate's");
  demand(!result.bound || result.bound->value == low, "the result's bound is another than the certificate's");
  demand(!result.depth || result.bound || low == high, "the result has a depth, the certificate proves bounds only");
}

}  // namespace fathom_check
