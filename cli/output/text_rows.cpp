// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/args/values.hpp"
#include "cli/io/output.hpp"
#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_triple = 72;  // characters; longer exact texts are replaced by decimals
constexpr std::size_t few = 9;              // digits of an approximate component
constexpr std::size_t beyond_binary64_digits = 17;

bool is_informative(double value) { return std::isfinite(value) && value != 0; }

/// Returns nine digits, rounded; truncated for values beyond binary64.
std::string few_digits(const mpq_class& value) {
  if (sgn(value) == 0) return "0";
  if (const double rounded = round_binary64(value, Rounding::rn); is_informative(rounded))
    return fmt::format("{:.{}g}", rounded, few);
  return fmt::format("{}{}", sgn(value) < 0 ? "-" : "", enclose_root(value * value, few).low);
}

/// Returns component / length, from its exact square.
std::string unit_component(const mpz_class& component, const mpz_class& squared_length) {
  const mpq_class squared = kernels::ratio(component * component, squared_length);
  if (sgn(squared) == 0) return "0";
  const double rounded = root_binary64(squared, Rounding::rn);
  return fmt::format("{}{}", sgn(component) < 0 ? "-" : "",
                     is_informative(rounded) ? fmt::format("{:.{}g}", rounded, few) : enclose_root(squared, few).low);
}

std::string triple(std::string_view mark, const std::string& x, const std::string& y, const std::string& z) {
  return fmt::format("{}({}, {}, {})", mark, x, y, z);
}

std::string decimal(const Surd& value) { return sign(value) < 0 ? "-" + surd_text(negated(value)) : surd_text(value); }

/// Returns "(x, y, z)", in the plane "(x, y)".
std::string in_brackets(const std::string& x, const std::string& y, const std::string& z, unsigned dimension) {
  return dimension == 2 ? fmt::format("({}, {})", x, y) : triple("", x, y, z);
}

std::string in_full(const Point& p, unsigned dimension) {
  return in_brackets(exact_text(p.x), exact_text(p.y), exact_text(p.z), dimension);
}
std::string in_full(const Vector& n, unsigned dimension) {
  return in_brackets(n.x.get_str(), n.y.get_str(), n.z.get_str(), dimension);
}

/// Returns from + length n/|n|.
std::string in_full(const Point& from, const mpq_class& length, const Vector& n, unsigned dimension) {
  if (const std::optional<Point> point = rational_point(RoundedPoint{from, n, length}))
    return in_full(*point, dimension);
  return fmt::format("{} and {} along {}", in_full(from, dimension), exact_text(length), in_full(n, dimension));
}

constexpr std::size_t most_indices = 12;
constexpr std::size_t case_indent = 4;  // spaces before continued lines of a case
constexpr std::size_t short_pair = 54;  // characters of two points that share a line of 80

}  // namespace

std::string root_text(const mpq_class& squared) {
  if (sgn(squared) == 0) return "0";
  if (const double rounded = root_binary64(squared, Rounding::rn); is_informative(rounded))
    return fmt::format("{}", rounded);
  return enclose_root(squared, beyond_binary64_digits).low;
}

std::string surd_text(const Surd& value) {
  if (sign(value) == 0) return "0";
  if (const double rounded = round_binary64(value); is_informative(rounded)) return fmt::format("{}", rounded);
  return enclose(value, beyond_binary64_digits).low;
}

std::string point_text(const Point& p) {
  const std::string exact = triple("", exact_text(p.x), exact_text(p.y), exact_text(p.z));
  if (exact.size() <= longest_triple) return exact;
  return triple("~", few_digits(p.x), few_digits(p.y), few_digits(p.z));
}

std::string direction_text(const Vector& n) {
  const std::string exact = triple("", n.x.get_str(), n.y.get_str(), n.z.get_str());
  if (exact.size() <= longest_triple) return exact;
  const mpz_class squared_length = dot(n, n);
  return triple("~", unit_component(n.x, squared_length), unit_component(n.y, squared_length),
                unit_component(n.z, squared_length));
}

std::string decimals(const Coordinates& values, unsigned dimension) {
  return in_brackets(decimal(values[0]), decimal(values[1]), decimal(values[2]), dimension);
}

std::string place_text(const Point& p, bool exact, unsigned dimension) {
  return exact ? in_full(p, dimension) : decimals(coordinates(p), dimension);
}

std::string place_text(const AlongNormal& vector, bool exact, unsigned dimension) {
  const auto& [n, alpha, beta] = vector;
  return exact ? in_full(alpha * n, beta, n, dimension) : decimals(coordinates(vector), dimension);
}

std::string place_text(const RoundedPoint& point, bool exact, unsigned dimension) {
  return exact ? in_full(point.core, point.distance, point.normal, dimension) : decimals(coordinates(point), dimension);
}

std::string way_text(const Vector& n, bool exact, unsigned dimension) {
  return exact ? in_full(n, dimension) : decimals(unit(n), dimension);
}

std::string spin_text(const SurdPoint& w, const AnswerForm& form) {
  return form.dimension == 2 ? decimal(w[2]) : decimals(w);
}

AnswerForm::AnswerForm(const Given& given)
    : Shown{given.integer<std::size_t>("--optima"),
            given.integer<unsigned>("--digits"),
            given.flag("--counters"),
            given.flag("--embed-certificate"),
            given.command == "width",
            given.flag("--patch"),
            given.number("--patch-slack")},
      exact(given.flag("--exact")),
      by_default(given.value("--method").value_or("auto") == "auto" && !given.has("--closest-lines")),
      twists(given.twists()) {}

std::string quantity(const AnswerForm& form) { return form.width ? "width" : "depth"; }

std::string aligned(const std::string& heading, const std::vector<Row>& rows) {
  std::size_t column = 0;
  for (const Row& row : rows) column = std::max(column, row.first.size());
  std::vector<std::string> lines;
  if (!heading.empty()) lines.push_back(heading);
  for (const auto& [label, text] : rows)
    lines.push_back(fitted(fmt::format("{:<{}}  {}", label, column, text), column + 2));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string case_line(const std::string& id, const std::vector<std::string>& parts) {
  return fitted(fmt::format("{}: {}", safe_id(id), fmt::join(parts, "; ")), case_indent);
}

std::string safe_id(const std::string& id) { return without_controls(id) == id ? id : text::Json(id).text(); }

std::string indices_text(const std::vector<std::uint32_t>& indices) {
  if (indices.size() <= most_indices) return fmt::format("{}", fmt::join(indices, " "));
  return fmt::format("{} ... ({} in all)", fmt::join(indices.begin(), indices.begin() + most_indices, " "),
                     indices.size());
}

std::string contact_text(const Contact& contact, bool same_body) {
  return fmt::format("{}: points {} of A, {} of {}", name(contact.kind), indices_text(contact.a),
                     indices_text(contact.b), same_body ? "A" : "B");
}

void add_points(std::vector<Row>& rows, const std::string& label, const std::string& a, const std::string& b,
                bool same_body) {
  const char* const of_b = same_body ? "A" : "B";
  if (a.size() + b.size() <= short_pair) {
    rows.emplace_back(label, fmt::format("{} of A, {} of {}", a, b, of_b));
    return;
  }
  rows.emplace_back(label, fmt::format("{} of A", a));
  rows.emplace_back("", fmt::format("{} of {}", b, of_b));
}

void add_witness(std::vector<Row>& rows, const Witness& witness, const AnswerForm& form) {
  const std::string a = place_text(witness.a, form);
  if (witness.a == witness.b) rows.emplace_back("common point", a);
  else add_points(rows, "witness", a, place_text(witness.b, form), form.width);
}

std::string flat_text(const BodyFacts& facts, bool same_body) {
  const bool b = facts.flat_b && !same_body;
  return facts.flat_a && b ? "A and B" : facts.flat_a ? "A" : b ? "B" : "";
}

Row flat_note() {
  return {"note",
          "A has no interior; this is the depth of O in B (+) (-A), where the wording by interiors would give 0"};
}

void add_solids(std::vector<Row>& rows, const output::AboutBodies& bodies) {
  for (const auto& [name, solid] : {std::pair("A", bodies.solid_a), std::pair("B", bodies.solid_b)}) {
    if (!solid) continue;
    rows.emplace_back("solid", fmt::format("{}: {} triangles, {}", name, solid->triangles.size(),
                                           kernels::counted(pieces_of(*solid).size(), "piece", "pieces")));
    for (const std::string& note : notes(*solid)) rows.emplace_back("", note);
  }
}

std::string enclosure_text(const Enclosure& enclosure) {
  return fmt::format("[{}, {}]", enclosure.low, enclosure.high);
}

}  // namespace fathom::cli
