// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/text_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "cli/io/output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/counts.hpp"

namespace fathom::cli {
namespace {

/// A pair of planes is found from both of its sides.
std::size_t ties(const Depth& depth, const Request& request) {
  return has_one_body(request) ? depth.optima_count() / 2 : depth.optima_count();
}

std::string ties_text(const Depth& depth, const Request& request) {
  const std::size_t count = ties(depth, request);
  const std::string_view many = has_one_body(request) ? "pairs of planes" : "nearest facets";
  return count == 1 ? "none" : fmt::format("{} {}; the first is shown, --json lists all", count, many);
}

void add_distance(std::vector<Row>& rows, const Distance& distance, const Request& request) {
  rows.emplace_back("distance", root_text(distance.squared));
  if (request.exact) rows.emplace_back("distance^2", exact_text(distance.squared));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(distance.squared, *request.digits));
  add_points(rows, "nearest", place_text(distance.witness.a, request.exact), place_text(distance.witness.b, request.exact));
  rows.emplace_back("A to B", place_text(distance.translation, request.exact));
}

void add_result(std::vector<Row>& rows, const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  rows.emplace_back(quantity(request), root_text(depth.squared()));
  if (request.exact) rows.emplace_back(quantity(request) + "^2", exact_text(depth.squared()));
  if (request.digits && !depth.distance()) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *request.digits));
  if (depth.distance()) add_distance(rows, *depth.distance(), request);
  rows.emplace_back("direction", way_text(depth.direction(), request.exact));
  if (depth.status() == Status::penetrating && !has_one_body(request))
    rows.emplace_back("translation", place_text(depth.translation(), request.exact));
  if (depth.contact()) rows.emplace_back("contact", contact_text(*depth.contact(), has_one_body(request)));
  if (const std::optional<Witness> witness = depth.witness()) add_witness(rows, *witness, request);
  if (!depth.optima().empty()) rows.emplace_back("ties", ties_text(depth, request));
}

// Which method answered, and why if it is not the one that was tried first.
std::string method_text(const Depth& depth, const Request& request) {
  const std::string ran(method_name(depth));
  if (depth.method == Method::certificate) return fmt::format("{}: an inner polytope of {} facets", ran, depth.counters.inner_facets);
  if (request.method == Method::automatic && !request.shallow && !request.closest_lines)
    return ran + ": the inner polytope took too many points";
  return ran;
}

void add_notes(std::vector<Row>& rows, const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  if (depth.status() == Status::penetrating) rows.emplace_back("method", method_text(depth, request));
  if (const std::string flat = flat_text(depth, has_one_body(request)); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.status() == Status::penetrating) rows.push_back(flat_note());
}

}  // namespace

// Of the stages that ran: what another method would have counted is no 0.
void add_counters(std::vector<Row>& rows, const Counters& counters) {
  std::vector<std::string_view> stages;
  std::vector<Row> counts;
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (!stage.ran()) continue;
    stages.push_back(stage.stage);
    for (const kernels::Count& count : stage.counts) counts.emplace_back(count.name, fmt::format("{}", count.value));
  }
  rows.emplace_back("counted", fmt::format("{}", fmt::join(stages, ", ")));
  rows.insert(rows.end(), counts.begin(), counts.end());
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    if (tiers.calls == 0) continue;
    rows.emplace_back(predicate_names[i], fmt::format("{} calls, {} exact, {} zero", tiers.calls, tiers.exact, tiers.zero));
  }
}

std::string text_block(const Answer& answer, const Request& request) {
  std::vector<Row> rows;
  add_result(rows, answer, request);
  add_bodies(rows, answer.bodies);
  add_notes(rows, answer, request);
  if (request.counters) add_counters(rows, answer.depth.counters);
  return aligned(has_one_body(request) ? "" : std::string(name(answer.depth.status())), rows);
}

std::string text_line(const Answer& answer, const Request& request) {
  const Depth& depth = answer.depth;
  std::vector<std::string> parts;
  if (!has_one_body(request)) parts.emplace_back(name(depth.status()));
  parts.push_back(quantity(request) + " " + root_text(depth.squared()));
  if (depth.status() == Status::penetrating) {
    if (request.exact) parts.push_back(quantity(request) + "^2 " + exact_text(depth.squared()));
    if (request.digits) parts.push_back("in " + enclosure_text(depth.squared(), *request.digits));
  }
  if (depth.distance()) parts.push_back("distance " + root_text(depth.distance()->squared));
  parts.push_back("direction " + way_text(depth.direction(), request.exact));
  if (depth.contact()) parts.emplace_back(name(depth.contact()->kind));
  if (const std::size_t count = ties(depth, request); count > 1) parts.push_back(fmt::format("{} ties", count));
  if (const std::string flat = flat_text(depth, has_one_body(request)); !flat.empty()) parts.push_back("flat " + flat);
  std::vector<Row> rows;
  if (request.counters) add_counters(rows, depth.counters);
  for (const auto& [label, text] : rows) parts.push_back(label + " " + text);
  return case_line(answer.id, parts);
}

std::string safe_id(const std::string& id) { return without_controls(id) == id ? id : text::Json(id).text(); }

}  // namespace fathom::cli
