// SPDX-License-Identifier: Apache-2.0
#include "parser.hpp"

#include <algorithm>

#include "fixed.hpp"
#include "limits.hpp"
#include "text.hpp"

namespace fathom_check {

namespace {

constexpr std::string_view header_word = "fathom-certificate";

/// Its value, or the largest number if it is larger.
std::size_t saturated(std::string_view digits) {
  std::size_t value = 0;
  for (const char c : digits) {
    if (value > SIZE_MAX / 10 - 1) return SIZE_MAX;
    value = value * 10 + static_cast<std::size_t>(c - '0');
  }
  return value;
}

/// Of fewer digits than a word has, q > 0. Most denominators are powers of 2; for others GMP's
/// function takes a fraction of the time of std::gcd.
Word common_divisor(Word p, Word q) {
  if (p == 0) return q;
  if ((q & (q - 1)) == 0) return (p | q) & -(p | q);
  const auto size = static_cast<mp_limb_t>(p < 0 ? -p : p);
  return static_cast<Word>(mpn_gcd_1(&size, 1, static_cast<mp_limb_t>(q)));
}

}  // namespace

// Lines.

bool Parser::skip_comments() {
  while (lines_->kind() == Lines::Kind::whole && !lines_->text().empty() && lines_->text()[0] == '#') lines_->advance();
  return lines_->kind() != Lines::Kind::none;
}

bool Parser::find_next() {
  if (!fresh_) lines_->advance();
  fresh_ = false;
  return skip_comments();
}

bool Parser::at_header() const { return lines_->text().substr(0, header_word.size()) == header_word; }

bool Parser::skip_to_next() {
  while (lines_->kind() != Lines::Kind::none && !at_header()) lines_->advance();
  fresh_ = lines_->kind() != Lines::Kind::none;
  return fresh_;
}

Fault Parser::wrong(const std::string& expected) const {
  const std::string found = lines_->kind() == Lines::Kind::none       ? "the end of the input"
                            : lines_->kind() == Lines::Kind::too_long ? "a line that is too long"
                            : lines_->kind() == Lines::Kind::cut_off
                                ? "a line that is cut off: " + shown(lines_->text())
                                : shown(lines_->text());
  return malformed(lines_->number(), "expected " + expected + ", found " + found);
}

void Parser::require_line(const char* expected) {
  if (lines_->kind() != Lines::Kind::whole) throw wrong(expected);
  bytes_ += lines_->text().size();
  if (bytes_ > limits_.bytes)
    throw malformed(lines_->number(), "a certificate of more bytes than the limit, " + std::to_string(limits_.bytes));
}

// Moves on to the next line that is not a comment and splits it into its fields. Blanks in excess
// yield empty fields, which are not tokens.
void Parser::advance() {
  lines_->advance();
  skip_comments();
  split();
}

void Parser::next(const char* expected) {
  advance();
  require_line(expected);
}

/// Whether the line at hand begins with this word.
bool Parser::at(std::string_view word) const { return lines_->kind() == Lines::Kind::whole && fields_[0] == word; }

void Parser::split() {
  fields_.clear();
  std::string_view rest = lines_->text();
  for (std::size_t blank = rest.find(' '); blank != std::string_view::npos; blank = rest.find(' ')) {
    fields_.push_back(rest.substr(0, blank));
    rest.remove_prefix(blank + 1);
  }
  fields_.push_back(rest);
}

// Fields.

void Parser::demand(std::size_t count, const char* expected) const {
  if (fields_.size() != count) throw wrong(expected);
}

/// The fields of a line that holds `numbers` of them and nothing else.
void Parser::row(std::size_t numbers, const char* expected) {
  next(expected);
  demand(numbers, expected);
  count_numbers(numbers);
}

void Parser::count_numbers(std::size_t numbers) {
  numbers_ += numbers;
  if (numbers_ > limits_.numbers)
    throw malformed(lines_->number(),
                    "a certificate of more numbers than the limit, " + std::to_string(limits_.numbers));
}

void Parser::require_natural(std::string_view token, const char* expected) const {
  if (!is_natural(token)) throw wrong(expected);
  if (token.size() > longest_number)
    throw malformed(lines_->number(), "a number of more digits than the limit, 100000");
}

mpz_class Parser::long_integer(std::string_view token, const char* expected) const {
  require_natural(token.substr(!token.empty() && token[0] == '-' ? 1 : 0), expected);
  return to_integer(token);
}

Integer Parser::integer(std::string_view token, const char* expected) const {
  if (const std::optional<Word> value = short_integer<Word>(token)) return integers_->keep(*value);
  return integers_->keep(long_integer(token, expected));
}

Rational Parser::rational(std::string_view token) const {
  constexpr const char* expected = "rational numbers";
  const std::size_t slash = token.find('/');
  if (slash == std::string_view::npos) return {integer(token, expected)};
  const std::string_view numerator = token.substr(0, slash), denominator = token.substr(slash + 1);
  const std::optional<Word> p = short_integer<Word>(numerator), q = short_integer<Word>(denominator);
  if (p && q && *q > 0) {
    const Word common = common_divisor(*p, *q);
    if (common == 1) return {integers_->keep(*p), integers_->keep(*q)};
    return {integers_->keep(*p / common), integers_->keep(*q / common)};
  }
  mpz_class num = long_integer(numerator, expected);
  require_natural(denominator, expected);
  mpz_class den = to_integer(denominator);
  if (den == 0) throw wrong("a denominator other than zero");
  const mpz_class common = gcd(num, den);
  if (common != 1) {
    num /= common;
    den /= common;
  }
  return {integers_->keep(num), integers_->keep(den)};
}

std::size_t Parser::count(std::size_t index, const char* expected) const {
  require_natural(fields_[index], expected);
  return saturated(fields_[index]);
}

std::uint32_t Parser::index_number(std::string_view token) const {
  require_natural(token, "indices, counted from 0");
  return static_cast<std::uint32_t>(std::min<std::size_t>(saturated(token), no_index));
}

// One block. A pipe hands over what it has: a certificate is judged before its successor is
// written.
bool Lines::refill() {
  constexpr std::streamsize block = 1 << 16;
  if (input_ == nullptr || !input_->good()) return false;
  buffer_.resize(block);
  std::streamsize got = 0;
  if (input_->peek() != std::istream::traits_type::eof()) got = input_->readsome(buffer_.data(), block);
  if (got == 0 && input_->good() && input_->get(buffer_[0])) got = 1;
  block_ = std::string_view(buffer_.data(), static_cast<std::size_t>(got));
  return got > 0;
}

Lines::Kind Lines::advance() {
  joined_.clear();
  bool any = false, too_long = false, joined = false;
  while (!block_.empty() || refill()) {
    any = true;
    const std::size_t end = block_.find('\n');
    const std::string_view piece = block_.substr(0, end);
    too_long = too_long || joined_.size() + piece.size() > longest_;
    if (end != std::string_view::npos && !joined) {
      text_ = piece;
    } else if (!too_long) {
      joined_ += piece;
      joined = true;
    } else {
      joined = true;
    }
    block_.remove_prefix(end == std::string_view::npos ? block_.size() : end + 1);
    if (joined) text_ = joined_;
    if (end == std::string_view::npos) continue;
    ++number_;
    if (too_long) text_ = {};
    return kind_ = too_long ? Kind::too_long : Kind::whole;
  }
  ++number_;
  if (!any || too_long) text_ = {};
  return kind_ = !any ? Kind::none : too_long ? Kind::too_long : Kind::cut_off;
}

}  // namespace fathom_check
