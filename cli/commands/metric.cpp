// SPDX-License-Identifier: GPL-3.0-or-later
// fathom metric --ball Q A B | CASES.jsonl | - Depths in a polyhedral norm or gauge, for people and
// for programs (JSON, metric.schema.json).

#include "reference/approximate/metric.hpp"

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
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

constexpr const char* schema = "fathom/metric/1";
constexpr std::size_t most_vertices = 12;

std::string kind(const UnitBall& ball) { return ball.symmetric ? "norm" : "gauge"; }

std::string ball_text(const UnitBall& ball) {
  const char* const why =
      ball.symmetric ? "symmetric about O" : "not symmetric about O, so t and -t may differ in length";
  return fmt::format("{}: {}; {} vertices", kind(ball), why, ball.vertices.size());
}

std::string deciding_text(const MetricResult& result) {
  std::vector<std::string> words;
  for (const MetricOptimum& optimum : result.optima()) {
    if (words.size() == most_vertices) {
      words.push_back(fmt::format("... ({} in all)", result.optima().size()));
      break;
    }
    words.push_back(std::to_string(optimum.vertex));
  }
  return fmt::format("{} of the ball{}", fmt::join(words, " "),
                     words.size() == 1 ? "" : "; the first is shown, --json lists all");
}

/// The value as a decimal: that of the root of its square.
std::string decimal(const mpq_class& value) { return root_text(value * value); }

Json optima_array(const MetricResult& result) {
  Json array = Json::array();
  for (const MetricOptimum& optimum : result.optima()) {
    array.push_back({{"vertex", optimum.vertex},
                     {"translation", output::exact(optimum.translation)},
                     {"direction", output::exact(optimum.direction)},
                     {"contact", output::contact_object(optimum.contact)},
                     {"witness", output::witness_object(optimum.witness)}});
  }
  return array;
}

std::string direction_label(const MetricResult& result) {
  return result.status() == Status::disjoint ? "separating normal" : "direction";
}

/// Several lines, or one; without the last newline.
std::string metric_block(const MetricResult& result, const UnitBall& ball, const Request& request) {
  std::vector<Row> rows{{"depth", decimal(result.depth())}};
  if (request.exact) rows.emplace_back("exactly", exact_text(result.depth()));
  rows.emplace_back("unit ball", ball_text(ball));
  if (!result.optima().empty()) rows.emplace_back("vertices", deciding_text(result));
  rows.emplace_back(direction_label(result), way_text(result.direction(), request.exact));
  if (!result.optima().empty()) {
    const MetricOptimum& first = result.optima().front();
    rows.emplace_back("translation", place_text(first.translation, request.exact));
    rows.emplace_back("contact", contact_text(first.contact));
    add_witness(rows, first.witness, request);
  }
  if (const std::string flat = flat_text(result); !flat.empty()) rows.emplace_back("flat", flat);
  if (result.flat_a && result.status() == Status::penetrating) rows.push_back(flat_note());
  return aligned(std::string(name(result.status())), rows);
}

std::string metric_line(const std::string& id, const MetricResult& result, const UnitBall& ball,
                        const Request& request) {
  std::vector<std::string> parts{std::string(name(result.status())),
                                 fmt::format("depth {} in the {}", decimal(result.depth()), kind(ball))};
  if (!result.optima().empty()) {
    parts.push_back("translation " + place_text(result.optima().front().translation, request.exact));
    parts.emplace_back(name(result.optima().front().contact.kind));
  } else {
    parts.push_back(direction_label(result) + " " + way_text(result.direction(), request.exact));
  }
  if (result.optima().size() > 1) parts.push_back(fmt::format("{} ties", result.optima().size()));
  if (const std::string flat = flat_text(result); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string metric_json(const std::string& id, const MetricResult& result, const UnitBall& ball) {
  Json object = {{"schema", schema}, {"id", id}, {"status", name(result.status())}};
  object["ball"] = {{"kind", kind(ball)}, {"vertices", ball.vertices.size()}};
  object["depth"] = output::number(result.depth());
  object["direction"] = output::exact(result.direction());
  object["optima"] = optima_array(result);
  object["flat"] = output::flat_array(result);
  object["rays"] = result.penetration() ? result.penetration()->rays : 0;
  return object.text();
}

/// Returns the line for a case of a stream that has no result.
std::string metric_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(schema, id, line, error);
}

UnitBall ball_of(const Request& request) {
  try {
    return unit_ball(read_mesh(request.ball, request.decimals).points);
  } catch (const NoUnitBall& error) {
    throw InputError(request.ball, 0, error.what());
  }
}

}  // namespace

ExitCode run_metric(const Request& request) {
  const UnitBall ball = ball_of(request);
  Replies replies;
  replies.refuses_shapes = "depth answers about those, in Euclid's norm";
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const MetricResult result = metric_depth(pair.a.points, pair.b.points, ball, &monitor);
    if (request.json) return {metric_json(pair.id, result, ball)};
    return {is_stream(request) ? metric_line(pair.id, result, ball, request) : metric_block(result, ball, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return metric_json_error(item.id, item.line, fault);
    };
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
