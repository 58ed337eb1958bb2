// SPDX-License-Identifier: GPL-3.0-or-later
// fathom approx --delta D A B | CASES.jsonl | -
// fathom width [--delta D] A | CASES.jsonl | -
// Depths within a factor, for people and for programs (JSON, result.schema.json).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <string>

#include "cli/args/request.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/approximate.hpp"
#include "fathom/numbers.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

/// Tells no distance: for disjoint bodies an approximation has only a plane between them.
std::string direction_label(const ApproxDepth& depth) {
  return depth.status() == Status::disjoint ? "separating normal" : "direction";
}

std::uint64_t rays(const ApproxDepth& depth) { return depth.penetration() ? depth.penetration()->rays : 0; }

/// How far apart disjoint bodies are, no approximation tells.
output::SignedDepthBounds signed_bounds(Status status, const kernels::Roundings& least,
                                        const kernels::Roundings& most) {
  if (status == Status::disjoint) return {-std::numeric_limits<double>::infinity(), 0};
  return {least.binary64.rd, most.binary64.ru};
}

/// Several lines, or one; without the last newline.
std::string approx_block(const ApproxDepth& depth, const output::AboutBodies& bodies, const Request& request) {
  const std::string what = quantity(request);
  std::vector<Row> rows;
  rows.emplace_back(what + " at most", root_text(depth.squared()));
  if (request.exact) rows.emplace_back(what + "^2 at most", exact_text(depth.squared()));
  rows.emplace_back(what + " at least", root_text(depth.bound_squared()));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *request.digits));
  rows.emplace_back("delta", exact_text(depth.delta));
  rows.emplace_back("rays", fmt::format("{}", rays(depth)));
  rows.emplace_back(direction_label(depth), way_text(depth.direction(), request.exact));
  if (const ApproxPenetration* found = depth.penetration()) {
    if (!has_one_body(request)) rows.emplace_back("translation", place_text(found->translation, request.exact));
    rows.emplace_back("contact", contact_text(found->contact, has_one_body(request)));
    if (found->witness) add_witness(rows, *found->witness, request);
  }
  add_bodies(rows, bodies);
  if (const std::string flat = flat_text(depth, has_one_body(request)); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.penetration()) rows.push_back(flat_note());
  return aligned(has_one_body(request) ? "" : std::string(name(depth.status())), rows);
}

std::string approx_line(const std::string& id, const ApproxDepth& depth, const Request& request) {
  std::vector<std::string> parts;
  if (!has_one_body(request)) parts.emplace_back(name(depth.status()));
  parts.push_back(quantity(request) + " at most " + root_text(depth.squared()));
  parts.push_back("at least " + root_text(depth.bound_squared()));
  if (depth.penetration()) {
    if (request.exact) parts.push_back(quantity(request) + "^2 at most " + exact_text(depth.squared()));
    if (request.digits) parts.push_back("in " + enclosure_text(depth.squared(), *request.digits));
  }
  parts.push_back(direction_label(depth) + " " + way_text(depth.direction(), request.exact));
  if (depth.penetration()) parts.emplace_back(name(depth.penetration()->contact.kind));
  if (const std::string flat = flat_text(depth, has_one_body(request)); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string approx_json(const std::string& id, const ApproxDepth& depth, const output::AboutBodies& bodies,
                        const Request& request) {
  const ApproxPenetration* const found = depth.penetration();
  Json result = output::result_head(id, name(depth.status()));
  const kernels::Roundings most = kernels::roundings_of_root(depth.squared()),
                           least = kernels::roundings_of_root(depth.bound_squared());
  result["signed_depth"] = output::signed_depth_object(signed_bounds(depth.status(), least, most));
  const Json size = output::length(depth.squared(), most, request.digits);
  result["depth"] = size;
  result["translation"] = output::exact(depth.translation());
  result["direction"] = output::exact(depth.direction());
  result["contact"] = found ? output::contact_object(found->contact) : Json();
  result["witness"] = found && found->witness ? output::witness_object(*found->witness) : Json();
  output::add_rounded(result, depth.direction(), coordinates(depth.translation()),
                      output::coordinates_of(found ? found->witness : std::nullopt));
  result["optima"] = Json::array();
  add_bodies(result, bodies);
  result["flat"] = output::flat_array(depth);
  result["method"] = "approx";
  result["delta"] = exact_text(depth.delta);
  result["rays"] = rays(depth);
  result["bound"] = output::length(depth.bound_squared(), least, request.digits);
  if (has_one_body(request)) result["width"] = size;
  return result.text();
}

ApproxDepth solve(const Case& single, const Request& request, Monitor& monitor) {
  return has_one_body(request) ? approx_width(single.a.points, *request.delta, &monitor)
                               : approx_depth(single.a.points, single.b.points, *request.delta, &monitor);
}

/// Not refused: a run can be interrupted, and its progress is shown.
void warn_of_many_rays(const Request& request) {
  constexpr long many = 10'000'000;
  const mpq_class rays = (has_one_body(request) ? 2 : 4) / *request.delta;  // the grid itself takes long to find
  if (rays > many)
    talk(
        fmt::format("--delta {} asks for about {} rays a case", exact_text(*request.delta), mpz_class(rays).get_str()));
}

/// request.delta must be set, and `request` must outlive the replies.
Replies approximate_replies(const Request& request) {
  warn_of_many_rays(request);
  Replies replies;
  replies.tells_of_dents = true;
  replies.refuses_shapes =
      has_one_body(request)
          ? "width without --delta answers about those, exactly or within bounds as near as --bits asks for"
          : "depth answers about those, exactly or within bounds as near as --bits asks for";
  replies.reply = [&request](const AskedCase& asked, Monitor& monitor, Workspace&) -> CaseReply {
    const std::string& id = asked.input.id;
    const ApproxDepth depth = solve(asked, request, monitor);
    if (request.json) return {approx_json(id, depth, asked.bodies, request)};
    return {is_stream(request) ? approx_line(id, depth, request) : approx_block(depth, asked.bodies, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::json_error(item.id, item.line, fault);
    };
  return replies;
}

}  // namespace

ExitCode run_approx(const Request& request) { return reply_to_inputs(request, approximate_replies(request)); }

ExitCode run_width(const Request& request) {
  return reply_to_inputs(request, request.delta ? approximate_replies(request) : exact_replies(request));
}

}  // namespace fathom::cli
