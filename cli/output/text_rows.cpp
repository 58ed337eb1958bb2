// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/io/output.hpp"
#include "cli/io/terminal.hpp"
#include "cli/output/coordinates.hpp"
#include "fathom/numbers.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_indices = 12;
constexpr std::size_t behind_first = 4;  // spaces before the further lines of a case
constexpr std::size_t short_pair = 54;   // characters of two points that share a line of 80

/// Indices of the points that span a face; the first few of a large one.
std::string indices_text(const std::vector<std::uint32_t>& indices) {
  if (indices.size() <= most_indices) return fmt::format("{}", fmt::join(indices, " "));
  return fmt::format("{} ... ({} in all)", fmt::join(indices.begin(), indices.begin() + most_indices, " "),
                     indices.size());
}

}  // namespace

std::string quantity(const Request& request) { return has_one_body(request) ? "width" : "depth"; }

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
  return fitted(fmt::format("{}: {}", safe_id(id), fmt::join(parts, "; ")), behind_first);
}

std::string safe_id(const std::string& id) { return without_controls(id) == id ? id : text::Json(id).text(); }

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

void add_witness(std::vector<Row>& rows, const Witness& witness, const Request& request) {
  const std::string a = place_text(witness.a, request.exact);
  if (witness.a == witness.b) rows.emplace_back("common point", a);
  else add_points(rows, "witness", a, place_text(witness.b, request.exact), has_one_body(request));
}

std::string flat_text(const BodyFacts& facts, bool same_body) {
  const bool b = facts.flat_b && !same_body;
  return facts.flat_a && b ? "A and B" : facts.flat_a ? "A" : b ? "B" : "";
}

Row flat_note() {
  return {"note",
          "A has no interior; this is the depth of O in B (+) (-A), where the wording by interiors would give 0"};
}

void add_bodies(std::vector<Row>& rows, const output::AboutBodies& bodies) {
  rows.emplace_back("sizes", shapes::sizes_text(bodies.sizes));
  add_hull(rows, bodies.hull);
}

void add_hull(std::vector<Row>& rows, const shapes::HullFacts& facts) {
  if (const std::string dents = shapes::dents_text(facts); !dents.empty()) rows.emplace_back("hull", dents);
}

std::string enclosure_text(const mpq_class& squared, unsigned digits) {
  const Enclosure enclosure = enclose_root(squared, digits);
  return fmt::format("[{}, {}]", enclosure.low, enclosure.high);
}

}  // namespace fathom::cli
