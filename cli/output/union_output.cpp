// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/union_output.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/json_values.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_contacts = 8;  // that text lists

void add_squared(std::vector<Row>& rows, const std::string& what, const mpq_class& squared, const Request& request) {
  rows.emplace_back(what, root_text(squared));
  if (request.exact) rows.emplace_back(what + "^2", exact_text(squared));
  if (request.digits) rows.emplace_back("enclosure", enclosure_text(squared, *request.digits));
}

void add_contacts(std::vector<Row>& rows, const std::vector<PieceContact>& contacts) {
  for (std::size_t i = 0; i < contacts.size() && i < most_contacts; ++i) {
    const PieceContact& c = contacts[i];
    rows.emplace_back(i == 0 ? "touching" : "", fmt::format("piece {} of A, piece {} of B; {}", c.a, c.b, contact_text(c.contact)));
  }
  if (contacts.size() > most_contacts) rows.emplace_back("", fmt::format("and {} more pairs", contacts.size() - most_contacts));
}

void add_optimum(std::vector<Row>& rows, const UnionDepth& depth, const Request& request) {
  if (depth.optima.empty()) return;
  const UnionOptimum& first = depth.optima.front();
  if (depth.status == Status::penetrating) rows.emplace_back("translation", place_text(first.translation, request.exact));
  rows.emplace_back("clearance", first.clearance ? "yes" : "none: an exact fit");
  add_contacts(rows, first.contacts);
  const std::size_t count = depth.optima.size();
  if (depth.status == Status::penetrating && depth.complete)
    rows.emplace_back("ties", count == 1 ? "none" : fmt::format("{} translations; the first is shown, --json lists all", count));
}

std::string counted(const UnionCounters& c) {
  return fmt::format("{} cells split, {} nearest points, {} of {} pairs of pieces looked at", c.nodes, c.nearest_points, c.pairs_touched,
                     c.pairs);
}

Json contact_json(const PieceContact& c) {
  return {{"pieces", std::vector<std::uint32_t>{c.a, c.b}}, {"direction", exact(c.direction)}, {"contact", contact_object(c.contact)}};
}

Json optimum_json(const UnionOptimum& optimum) {
  Json contacts = Json::array();
  for (const PieceContact& c : optimum.contacts) contacts.push_back(contact_json(c));
  return {{"translation", exact(optimum.translation)}, {"clearance", Json::boolean(optimum.clearance)}, {"contacts", contacts}};
}

Json distance_json(const UnionDistance& apart, const Request& request) {
  const Distance& d = apart.distance;
  return {{"distance", length(d.squared, request.digits)},
          {"pieces", std::vector<std::uint32_t>{apart.a, apart.b}},
          {"translation", exact(d.translation)},
          {"witness", witness_object(d.witness)},
          {"contact", contact_object(d.contact)}};
}

}  // namespace

std::string union_text(const UnionAnswer& answer, const Request& request) {
  const UnionDepth& depth = answer.depth;
  std::vector<Row> rows;
  if (depth.complete) {
    add_squared(rows, "depth", depth.low, request);
  } else {
    add_squared(rows, "at least", depth.low, request);
    add_squared(rows, "at most", depth.high, request);
  }
  if (depth.apart) {
    add_squared(rows, "distance", depth.apart->distance.squared, request);
    rows.emplace_back("between", fmt::format("piece {} of A, piece {} of B", depth.apart->a, depth.apart->b));
    rows.emplace_back("A to B", place_text(depth.apart->distance.translation, request.exact));
  }
  add_optimum(rows, depth, request);
  if (depth.bounds && depth.status == Status::penetrating) {
    rows.emplace_back("deepest pair", fmt::format("{}: piece {} of A, piece {} of B", root_text(depth.bounds->deepest_pair),
                                                  depth.bounds->a, depth.bounds->b));
    rows.emplace_back("hulls", root_text(depth.bounds->hulls));
  }
  add_hull(rows, answer.bodies.hull);
  if (request.counters) rows.emplace_back("counted", counted(depth.counters));
  return aligned(depth.complete ? std::string(name(depth.status)) : "interrupted", rows);
}

std::string union_line(const UnionAnswer& answer, const Request& request) {
  const UnionDepth& depth = answer.depth;
  if (!depth.complete)
    return case_line(answer.id, {"interrupted", "depth at least " + root_text(depth.low), "at most " + root_text(depth.high)});
  std::vector<std::string> parts{std::string(name(depth.status)), "depth " + root_text(depth.squared())};
  if (depth.status == Status::penetrating) {
    if (request.exact) parts.push_back("depth^2 " + exact_text(depth.squared()));
    if (request.digits) parts.push_back("in " + enclosure_text(depth.squared(), *request.digits));
    parts.push_back("translation " + place_text(depth.optima.front().translation, request.exact));
    if (!depth.optima.front().clearance) parts.emplace_back("an exact fit");
    if (depth.optima.size() > 1) parts.push_back(fmt::format("{} ties", depth.optima.size()));
    parts.push_back("deepest pair " + root_text(depth.bounds->deepest_pair));
  }
  if (depth.apart) parts.push_back("distance " + root_text(depth.apart->distance.squared));
  if (request.counters) parts.push_back("counted " + counted(depth.counters));
  return case_line(answer.id, parts);
}

std::string union_json(const UnionAnswer& answer, const Request& request) {
  const UnionDepth& depth = answer.depth;
  Json optima = Json::array();
  for (const UnionOptimum& o : depth.optima) optima.push_back(optimum_json(o));
  const UnionBounds& bounds = *depth.bounds;
  const UnionCounters& c = depth.counters;
  Json result{
      {"schema", "fathom/union/1"},
      {"fathom", FATHOM_VERSION},
      {"id", answer.id},
      {"status", name(depth.status)},
      {"complete", Json::boolean(depth.complete)},
      {"depth", depth.complete ? length(depth.low, request.digits) : Json()},
      {"low", length(depth.low, request.digits)},
      {"high", length(depth.high, request.digits)},
      {"optima", optima},
      {"apart", depth.apart ? distance_json(*depth.apart, request) : Json()},
      {"deepest_pair",
       Json{{"depth", length(bounds.deepest_pair, std::nullopt)}, {"pieces", std::vector<std::uint32_t>{bounds.a, bounds.b}}}},
      {"hulls", length(bounds.hulls, std::nullopt)},
      {"counters", Json{{"nodes", c.nodes}, {"nearest_points", c.nearest_points}, {"pairs", c.pairs}, {"pairs_touched", c.pairs_touched}}}};
  add_hull(result, answer.bodies.hull);
  if (request.embed_certificate && depth.complete) result["certificate"] = answer.certificate;
  return result.text();
}

}  // namespace fathom::cli
