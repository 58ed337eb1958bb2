// SPDX-License-Identifier: GPL-3.0-or-later
// fathom ray --direction X,Y,Z A B | CASES.jsonl | -
// Depths in one direction, for people and for programs (JSON, ray.schema.json).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <string>

#include "cli/args/request.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/approximate.hpp"
#include "fathom/numbers.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

constexpr const char* schema = "fathom/ray/1";

std::string normal_label(const DirectionalDepth& depth) {
  return depth.status() == Status::disjoint ? "separating normal" : "normal";
}

/// Several lines, or one; without the last newline.
std::string ray_block(const DirectionalDepth& depth, const Request& request) {
  std::vector<Row> rows{{"depth along", place_text(*request.direction, request.exact)},
                        {"length", root_text(depth.squared())}};
  if (request.exact) rows.emplace_back("length^2", exact_text(depth.squared()));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *request.digits));
  if (request.exact) rows.emplace_back("factor", exact_text(depth.factor()));
  if (depth.status() == Status::penetrating)
    rows.emplace_back("translation", place_text(depth.translation(), request.exact));
  rows.emplace_back(normal_label(depth), way_text(depth.normal(), request.exact));
  if (const RayExit* exit = depth.penetration()) {
    rows.emplace_back("contact", contact_text(exit->contact));
    add_witness(rows, exit->witness, request);
  }
  if (const std::string flat = flat_text(depth); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.status() == Status::penetrating) rows.push_back(flat_note());
  return aligned(std::string(name(depth.status())), rows);
}

std::string ray_line(const std::string& id, const DirectionalDepth& depth, const Request& request) {
  std::vector<std::string> parts{std::string(name(depth.status())), "length " + root_text(depth.squared())};
  if (depth.status() == Status::penetrating)
    parts.push_back("translation " + place_text(depth.translation(), request.exact));
  parts.push_back(normal_label(depth) + " " + way_text(depth.normal(), request.exact));
  if (depth.penetration()) parts.emplace_back(name(depth.penetration()->contact.kind));
  if (const std::string flat = flat_text(depth); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string ray_json(const std::string& id, const DirectionalDepth& depth, const Request& request) {
  const RayExit* const exit = depth.penetration();
  Json result = {
      {"schema", schema}, {"id", id}, {"status", name(depth.status())}, {"ray", output::exact(*request.direction)}};
  result["factor"] = exact_text(depth.factor());
  result["length"] = output::length(depth.squared(), request.digits);
  result["translation"] = output::exact(depth.translation());
  result["normal"] = output::exact(depth.normal());
  result["contact"] = exit ? output::contact_object(exit->contact) : Json();
  result["witness"] = exit ? output::witness_object(exit->witness) : Json();
  result["flat"] = output::flat_array(depth);
  result["steps"] = exit ? exit->steps : 0;
  return result.text();
}

/// Returns the line for a case of a stream that has no result.
std::string ray_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(schema, id, line, error);
}

}  // namespace

ExitCode run_ray(const Request& request) {
  Replies replies;
  replies.refuses_shapes =
      "how far it must move in one direction is not answered about those; depth says how far in the best one";
  replies.reply = [&request](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const DirectionalDepth depth = directional_depth(pair.a.points, pair.b.points, *request.direction, &monitor);
    if (request.json) return {ray_json(pair.id, depth, request)};
    return {is_stream(request) ? ray_line(pair.id, depth, request) : ray_block(depth, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return ray_json_error(item.id, item.line, fault);
    };
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
