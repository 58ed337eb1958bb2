// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/text_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/counts.hpp"
#include "cli/decimal.hpp"
#include "kernels/number/enclosure.hpp"
#include "kernels/number/parse.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_in_line = 40;
constexpr std::size_t most_indices = 12;

/// A label and its text.
using Row = std::pair<std::string, std::string>;

bool is_width(const Request& request) { return request.command == Command::width; }

std::string quantity(const Request& request) { return is_width(request) ? "width" : "depth"; }

std::string enclosure_text(const Depth& depth, unsigned digits) {
  const Enclosure enclosure = enclose_root(depth.squared, digits);
  return fmt::format("[{}, {}]", enclosure.low, enclosure.high);
}

/// Indices of the points that span a face; the first few of a large one.
std::string indices_text(const std::vector<std::uint32_t>& indices) {
  if (indices.size() <= most_indices) return fmt::format("{}", fmt::join(indices, " "));
  return fmt::format("{} ... ({} in all)", fmt::join(indices.begin(), indices.begin() + most_indices, " "), indices.size());
}

std::string contact_text(const Contact& contact, bool same_body) {
  return fmt::format("{}: points {} of A, {} of {}", name(contact.kind), indices_text(contact.a), indices_text(contact.b),
                     same_body ? "A" : "B");
}

/// A pair of planes is found from both of its sides.
std::size_t ties(const Depth& depth, const Request& request) { return is_width(request) ? depth.optima.size() / 2 : depth.optima.size(); }

std::string ties_text(const Depth& depth, const Request& request) {
  const std::size_t count = ties(depth, request);
  const std::string_view many = is_width(request) ? "pairs of planes" : "nearest facets";
  return count == 1 ? "none" : fmt::format("{} {}; the first is shown, --json lists all", count, many);
}

Row witness_row(const Witness& witness, bool same_body) {
  if (witness.a == witness.b) return {"common point", point_text(witness.a)};
  return {"witness", fmt::format("{} of A, {} of {}", point_text(witness.a), point_text(witness.b), same_body ? "A" : "B")};
}

void add_result(std::vector<Row>& rows, const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  rows.emplace_back(quantity(request), root_text(depth.squared));
  rows.emplace_back(quantity(request) + "^2", exact_text(depth.squared));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(depth, *request.digits));
  if (depth.direction) rows.emplace_back("direction", direction_text(*depth.direction));
  if (depth.status == Status::penetrating && !is_width(request)) rows.emplace_back("translation", point_text(depth.translation));
  if (depth.contact) rows.emplace_back("contact", contact_text(*depth.contact, is_width(request)));
  if (depth.witness) rows.push_back(witness_row(*depth.witness, is_width(request)));
  if (!depth.optima.empty()) rows.emplace_back("ties", ties_text(depth, request));
}

/// The bodies without interior: "A and B", or nothing.
std::string flat_text(const Depth& depth, const Request& request) {
  if (is_width(request)) return depth.flat_a ? "A" : "";
  return depth.flat_a && depth.flat_b ? "A and B" : depth.flat_a ? "A" : depth.flat_b ? "B" : "";
}

void add_notes(std::vector<Row>& rows, const Depth& depth, const Request& request) {
  if (const std::string flat = flat_text(depth, request); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.status == Status::penetrating)
    rows.emplace_back("note", "A has no interior; this is the depth of O in B (+) (-A), where the wording by interiors would give 0");
}

void add_counters(std::vector<Row>& rows, const Counters& counters) {
  for_each_count(counters, [&](std::string_view what, std::uint64_t count) { rows.emplace_back(what, fmt::format("{}", count)); });
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    rows.emplace_back(predicate_names[i], fmt::format("{} calls, {} exact, {} zero", tiers.calls, tiers.exact, tiers.zero));
  }
}

}  // namespace

std::string text_block(const Answer& answer, const Request& request) {
  std::vector<Row> rows;
  add_result(rows, answer, request);
  add_notes(rows, answer.depth, request);
  if (request.counters) add_counters(rows, answer.depth.counters);
  std::size_t column = 0;
  for (const Row& row : rows) column = std::max(column, row.first.size());
  std::vector<std::string> lines;
  if (!is_width(request)) lines.emplace_back(name(answer.depth.status));
  for (const auto& [label, text] : rows) lines.push_back(fmt::format("{:<{}}  {}", label, column, text));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string text_line(const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  std::vector<std::string> parts;
  if (!is_width(request)) parts.emplace_back(name(depth.status));
  parts.push_back(quantity(request) + " " + root_text(depth.squared));
  if (depth.status == Status::penetrating) {
    const std::string squared = exact_text(depth.squared);
    if (squared.size() <= longest_in_line) parts.push_back(quantity(request) + "^2 " + squared);
    if (request.digits) parts.push_back("in " + enclosure_text(depth, *request.digits));
  }
  if (depth.direction) parts.push_back("direction " + direction_text(*depth.direction));
  if (depth.contact) parts.emplace_back(name(depth.contact->kind));
  if (const std::size_t count = ties(depth, request); count > 1) parts.push_back(fmt::format("{} ties", count));
  if (const std::string flat = flat_text(depth, request); !flat.empty()) parts.push_back("flat " + flat);
  std::vector<Row> rows;
  if (request.counters) add_counters(rows, depth.counters);
  for (const auto& [label, text] : rows) parts.push_back(label + " " + text);
  return fmt::format("{}: {}", safe_id(answer.id), fmt::join(parts, "; "));
}

std::string safe_id(const std::string& id) {
  for (const char c : id) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      return nlohmann::json(id).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  }
  return id;
}

std::optional<std::string> hull_note(const Answer& answer, const Request& request) {
  std::vector<std::string> notes;
  const auto look = [&](std::string_view body, std::size_t given, std::uint32_t extreme) {
    if (extreme != 0 && extreme < given) notes.push_back(fmt::format("{}: {} of {} points are not extreme", body, given - extreme, given));
  };
  look("A", answer.points_a, answer.depth.extreme_a);
  if (!is_width(request)) look("B", answer.points_b, answer.depth.extreme_b);
  if (notes.empty()) return std::nullopt;
  return fmt::format("{}; the convex hull is taken", fmt::join(notes, "; "));
}

}  // namespace fathom::cli
