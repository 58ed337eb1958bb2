// SPDX-License-Identifier: Apache-2.0
#include "parser.hpp"

#include <algorithm>
#include <numeric>

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

bool is_id(std::string_view text) {
  const auto hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] <= ' ' || text[i] > '~') return false;
    if (text[i] != '%') continue;
    if (i + 2 >= text.size() || !hex(text[i + 1]) || !hex(text[i + 2])) return false;
    i += 2;
  }
  return !text.empty();
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
                            : lines_->kind() == Lines::Kind::cut_off  ? "a line that is cut off: " + shown(lines_->text())
                                                                      : shown(lines_->text());
  return malformed(lines_->number(), "expected " + expected + ", found " + found);
}

void Parser::require_line(const char* expected) {
  if (lines_->kind() != Lines::Kind::whole) throw wrong(expected);
  bytes_ += lines_->text().size();
  if (bytes_ > longest_certificate) throw malformed(lines_->number(), "a certificate of more bytes than the limit, 1000000000");
}

// Moves on to the next line that is not a comment and splits it into its fields. Blanks in excess yield empty fields, which are not tokens.
void Parser::next(const char* expected) {
  lines_->advance();
  skip_comments();
  require_line(expected);
  split();
}

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
  if (numbers_ > most_numbers) throw malformed(lines_->number(), "a certificate of more numbers than the limit, 10000000");
}

void Parser::require_natural(std::string_view token, const char* expected) const {
  if (!is_natural(token)) throw wrong(expected);
  if (token.size() > longest_number) throw malformed(lines_->number(), "a number of more digits than the limit, 100000");
}

mpz_class Parser::long_integer(std::string_view token, const char* expected) const {
  require_natural(token.substr(!token.empty() && token[0] == '-' ? 1 : 0), expected);
  return to_integer(token);
}

Integer Parser::integer(std::string_view token, const char* expected) const {
  if (const std::optional<long> value = short_integer<long>(token)) return integers_->keep(*value);
  return integers_->keep(long_integer(token, expected));
}

Rational Parser::rational(std::string_view token) const {
  constexpr const char* expected = "rational numbers";
  const std::size_t slash = token.find('/');
  if (slash == std::string_view::npos) return {integer(token, expected)};
  const std::string_view numerator = token.substr(0, slash), denominator = token.substr(slash + 1);
  const std::optional<long> p = short_integer<long>(numerator), q = short_integer<long>(denominator);
  if (p && q && *q > 0) {
    const long common = std::gcd(*p, *q);  // both are far from the ends of their range
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

// Parts.

void Parser::read(Certificate& result) {
  bytes_ = numbers_ = 0;
  integers_ = &result.integers;
  if (lines_->kind() != Lines::Kind::whole || lines_->text() != "fathom-certificate 1") {
    const Fault fault = wrong("'fathom-certificate 1'");
    if (at_header()) lines_->advance();  // it is this certificate's own
    throw fault;
  }
  bytes_ += lines_->text().size();
  next("'id', or 'a' and the number of its points");
  if (fields_[0] == "id") read_id(result);
  read_points(result.a, "a", "'a' and the number of its points");
  next("'b' and the number of its points");
  read_points(result.b, "b", "'b' and the number of its points");
  read_claim(result);
  read_directions(result);
  if (result.claim == Claim::depth || result.claim == Claim::bounds) {
    read_vertices(result.vertices);
    read_facets(result.facets);
  } else if (result.claim == Claim::touching) {
    read_weights(result.weights_a, "weights_a", "'weights_a' and their number");
    read_weights(result.weights_b, "weights_b", "'weights_b' and their number");
  }
  read_footer(result);
  require_limits(result, lines_->number());
}

void Parser::read_id(Certificate& result) {
  constexpr std::size_t prefix = 3;
  const std::string_view text = lines_->text().substr(std::min(prefix, lines_->text().size()));
  if (!is_id(text)) throw wrong("an id in printable ASCII; blanks, other bytes and % as %XX");
  result.id = text;
  next("'a' and the number of its points");
}

// The first line of a part is at hand; the number in it.
std::size_t Parser::part_header(const char* word, std::size_t fields, const char* expected) {
  demand(fields, expected);
  if (fields_[0] != word) throw wrong(expected);
  return count(1, expected);
}

void Parser::read_points(Part<std::vector<RationalPoint>>& part, const char* word, const char* expected) {
  part.line = lines_->number();
  for (std::size_t left = part_header(word, 2, expected); left > 0; --left) {
    row(3, "a point: three rational numbers");
    part.items.push_back({rational(fields_[0]), rational(fields_[1]), rational(fields_[2])});
    part.lines.push_back(lines_->number());
  }
}

void Parser::read_claim(Certificate& result) {
  constexpr const char* expected = "'claim depth Q', 'claim bounds LO HI', 'claim touching' or 'claim disjoint'";
  next(expected);
  result.claim_line = lines_->number();
  if (fields_.size() < 2 || fields_[0] != "claim") throw wrong(expected);
  const std::string_view word = fields_[1];
  if (word == "depth" && fields_.size() == 3) {
    result.claim = Claim::depth;
    result.low = result.high = rational(fields_[2]);
  } else if (word == "bounds" && fields_.size() == 4) {
    result.claim = Claim::bounds;
    result.low = rational(fields_[2]);
    result.high = rational(fields_[3]);
  } else if (word == "touching" && fields_.size() == 2) {
    result.claim = Claim::touching;
  } else if (word == "disjoint" && fields_.size() == 2) {
    result.claim = Claim::disjoint;
  } else {
    throw wrong(expected);
  }
}

void Parser::read_directions(Certificate& result) {
  constexpr const char* expected = "'directions', their number, and 'some' or 'all'";
  constexpr const char* vector = "a direction: three integers";
  next(expected);
  Part<std::vector<Vector>>& part = result.directions;
  part.line = lines_->number();
  std::size_t left = part_header("directions", 3, expected);
  if (fields_[2] != "some" && fields_[2] != "all") throw wrong(expected);
  result.all = fields_[2] == "all";
  for (; left > 0; --left) {
    row(3, vector);
    part.items.push_back({integer(fields_[0], vector), integer(fields_[1], vector), integer(fields_[2], vector)});
    part.lines.push_back(lines_->number());
  }
}

void Parser::read_vertices(Part<std::vector<Pair>>& part) {
  constexpr const char* expected = "'vertices' and their number";
  next(expected);
  part.line = lines_->number();
  for (std::size_t left = part_header("vertices", 2, expected); left > 0; --left) {
    row(2, "a vertex: an index into b and one into a");
    part.items.push_back({index_number(fields_[0]), index_number(fields_[1])});
    part.lines.push_back(lines_->number());
  }
}

void Parser::read_facets(Part<Facets>& part) {
  constexpr const char* expected = "'facets' and their number";
  constexpr const char* facet = "a facet: the number of its corners, and that many indices of vertices";
  next(expected);
  part.line = lines_->number();
  for (std::size_t left = part_header("facets", 2, expected); left > 0; --left) {
    next(facet);
    if (count(0, facet) != fields_.size() - 1) throw wrong(facet);
    count_numbers(fields_.size());
    for (std::size_t k = 1; k < fields_.size(); ++k) part.items.corners.push_back(index_number(fields_[k]));
    part.items.ends.push_back(part.items.corners.size());
    part.lines.push_back(lines_->number());
  }
}

void Parser::read_weights(Part<std::vector<Weight>>& part, const char* word, const char* expected) {
  next(expected);
  part.line = lines_->number();
  for (std::size_t left = part_header(word, 2, expected); left > 0; --left) {
    row(2, "a weight: an index and a rational number");
    part.items.push_back({index_number(fields_[0]), rational(fields_[1])});
    part.lines.push_back(lines_->number());
  }
}

void Parser::read_footer(const Certificate& certificate) {
  constexpr const char* expected = "'end' and five counts";
  next(expected);
  demand(6, expected);
  if (fields_[0] != "end") throw wrong(expected);
  const std::size_t counts[] = {certificate.a.items.size(), certificate.b.items.size(), certificate.directions.items.size(),
                                std::max(certificate.vertices.items.size(), certificate.weights_a.items.size()),
                                std::max(certificate.facets.items.size(), certificate.weights_b.items.size())};
  for (std::size_t i = 0; i < 5; ++i)
    if (count(i + 1, expected) != counts[i]) throw wrong("the counts of the parts again");
}

}  // namespace fathom_check
