// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/ray_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/answer_output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

constexpr const char* schema = "fathom/ray/1";

std::string normal_label(const DirectionalDepth& depth) { return depth.status() == Status::disjoint ? "separating normal" : "normal"; }

}  // namespace

std::string ray_block(const DirectionalDepth& depth, const Request& request) {
  std::vector<Row> rows{{"depth along", place_text(*request.direction, request.exact)}, {"length", root_text(depth.squared())}};
  if (request.exact) rows.emplace_back("length^2", exact_text(depth.squared()));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *request.digits));
  if (request.exact) rows.emplace_back("factor", exact_text(depth.factor()));
  if (depth.status() == Status::penetrating) rows.emplace_back("translation", place_text(depth.translation(), request.exact));
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
  if (depth.status() == Status::penetrating) parts.push_back("translation " + place_text(depth.translation(), request.exact));
  parts.push_back(normal_label(depth) + " " + way_text(depth.normal(), request.exact));
  if (depth.penetration()) parts.emplace_back(name(depth.penetration()->contact.kind));
  if (const std::string flat = flat_text(depth); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

std::string ray_json(const std::string& id, const DirectionalDepth& depth, const Request& request) {
  const RayExit* const exit = depth.penetration();
  Json result = {{"schema", schema}, {"id", id}, {"status", name(depth.status())}, {"ray", output::exact(*request.direction)}};
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

std::string ray_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(schema, id, line, error);
}

}  // namespace fathom::cli
