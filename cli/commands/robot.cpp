// SPDX-License-Identifier: GPL-3.0-or-later
// fathom robot FILE.urdf
// The signed depths of all pairs of links that are not adjacent.

#include "reference/files/robot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/answer.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/output/json_values.hpp"
#include "reference/shapes/body_notes.hpp"

namespace fathom::cli {
namespace {

using output::Json;

/// What is known of the signed depth of two links: low <= it <= high.
struct PairOfLinks {
  std::size_t a, b;          ///< links
  Surd low;                  ///< of links of several bodies the greatest depth of two of these
  std::optional<Surd> high;  ///< none if that is all that is known, since they overlap

  [[nodiscard]] bool exact() const { return high && compare(low, *high) == 0; }
  [[nodiscard]] std::optional<Status> status() const {
    if (sign(low) > 0) return Status::penetrating;
    if (high && sign(*high) < 0) return Status::disjoint;
    return exact() ? std::optional(Status::touching) : std::nullopt;
  }
};

/// A robot in a position, and what its pairs of links are to each other.
struct RobotTable {
  files::PosedRobot posed;
  std::vector<std::vector<Body>> bodies;  ///< of each link
  std::vector<PairOfLinks> pairs;         ///< by their least signed depth
  std::size_t adjacent = 0;               ///< pairs that are left out

  [[nodiscard]] const std::string& name(std::size_t link) const { return posed.robot.links[link].name; }
  [[nodiscard]] std::size_t count(std::optional<Status> status) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(pairs, [&](const PairOfLinks& pair) { return pair.status() == status; }));
  }
};

bool is_round(const Body& body) { return body.shape.has_value(); }

/// The bodies of a link; beside a link with a round one the pieces of unions, as no depth is taken
/// of a union and a round body.
std::vector<Body> parts_of(const std::vector<Body>& bodies, const std::vector<Body>& other) {
  if (std::ranges::none_of(other, is_round)) return bodies;
  std::vector<Body> parts;
  for (const Body& body : bodies) {
    if (!body.pieces) parts.push_back(body);
    else
      for (const std::vector<Point>& piece : *body.pieces) parts.push_back({piece});
  }
  return parts;
}

/// The distance of two unions is the least of their parts, so the signed depth is the greatest one;
/// if parts overlap, the unions overlap at least so deeply.
PairOfLinks pair_of(const RobotTable& table, std::size_t a, std::size_t b, const Question& question) try {
  std::optional<PairOfLinks> pair;
  const std::vector<Body> parts_a = parts_of(table.bodies[a], table.bodies[b]),
                          parts_b = parts_of(table.bodies[b], table.bodies[a]);
  for (const Body& of_a : parts_a)
    for (const Body& of_b : parts_b) {
      const Answer answer = exact_answer(of_a, of_b, question);
      if (!answer.complete()) throw Interrupted();
      if (!pair) pair = PairOfLinks{a, b, answer.low(), answer.high()};
      if (compare(pair->low, answer.low()) < 0) pair->low = answer.low();
      if (compare(*pair->high, answer.high()) < 0) pair->high = answer.high();
    }
  if (parts_a.size() * parts_b.size() > 1 && sign(*pair->high) > 0) pair->high.reset();
  return *pair;
} catch (const std::invalid_argument& error) {
  throw InputError(
      table.posed.robot.file, 0,
      fmt::format("links {} and {}: {}", kernels::shown(table.name(a)), kernels::shown(table.name(b)), error.what()));
}

RobotTable table_of(const BodiesRequest& request, Monitor& monitor) {
  files::Robot robot = files::read_robot(request.inputs[0], request.decimals);
  files::require_joints({robot}, request.joints);
  RobotTable table{files::posed(std::move(robot), request.joints), {}, {}};
  const std::size_t links = table.posed.robot.links.size();
  for (std::size_t link = 0; link < links; ++link)
    table.bodies.push_back(files::bodies_of(table.posed, link, request.robots));
  Question question;
  question.options.monitor = &monitor;
  for (std::size_t a = 0; a < links; ++a)
    for (std::size_t b = a + 1; b < links; ++b) {
      if (table.bodies[a].empty() || table.bodies[b].empty()) continue;
      if (files::are_adjacent(table.posed.robot, a, b)) ++table.adjacent;
      else table.pairs.push_back(pair_of(table, a, b, question));
      if (monitor.stopped()) throw Interrupted();
    }
  std::ranges::stable_sort(table.pairs, [](const auto& p, const auto& q) { return compare(p.low, q.low) < 0; });
  return table;
}

/// What people are to hear of the bodies, and of the position.
std::vector<std::string> said_of(const RobotTable& table) {
  std::vector<std::string> notes;
  for (std::size_t link = 0; link < table.bodies.size(); ++link)
    for (const Body& body : table.bodies[link]) {
      const std::string name = "link " + kernels::shown(table.name(link));
      if (const auto pieces = shapes::dented_pieces(body); pieces && body.pieces) {
        if (std::string text = shapes::dents_text(name, *pieces); !text.empty()) notes.push_back(std::move(text));
      } else if (const auto mesh = shapes::hull_fact(body)) {
        if (std::string text = shapes::dents_of(name, *mesh); !text.empty()) notes.push_back(std::move(text));
      }
    }
  const auto& more = table.posed.notes;
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

std::string pair_text(const PairOfLinks& pair, bool exact) {
  const auto text = [](const Surd& value) { return fmt::format("{}", round_binary64(value) + 0.0); };
  if (!pair.high) return "at least " + text(pair.low);
  if (!pair.exact())
    return fmt::format("[{}, {}]", round_binary64(pair.low, Rounding::rd) + 0.0,
                       round_binary64(*pair.high, Rounding::ru) + 0.0);
  return exact ? kernels::exact_surd_text(pair.low) : text(pair.low);
}

/// Several lines; without the last newline.
std::string robot_block(const RobotTable& table, bool exact) {
  const files::Robot& robot = table.posed.robot;
  std::string counts;
  for (const Status status : {Status::penetrating, Status::touching, Status::disjoint})
    counts += fmt::format("{} {}, ", table.count(status), name(status));
  if (const std::size_t open = table.count(std::nullopt)) counts += fmt::format("{} undecided, ", open);
  std::vector<std::array<std::string, 3>> cells{{"signed depth", "status", "links"}};
  for (const PairOfLinks& pair : table.pairs)
    cells.push_back({pair_text(pair, exact), std::string(pair.status() ? name(*pair.status()) : "undecided"),
                     safe_id(table.name(pair.a)) + ", " + safe_id(table.name(pair.b))});
  std::size_t first = 0, second = 0;
  for (const auto& row : cells) first = std::max(first, row[0].size()), second = std::max(second, row[1].size());
  std::string text =
      fmt::format("{} and {}; pairs: {}{} adjacent and left out", kernels::counted(robot.links.size(), "link", "links"),
                  kernels::counted(robot.joints.size(), "joint", "joints"), counts, table.adjacent);
  for (const auto& row : cells) text += fmt::format("\n{:<{}}  {:<{}}  {}", row[0], first, row[1], second, row[2]);
  for (const std::string& note : said_of(table)) text += "\n" + fitted("note  " + note, 6);
  return text;
}

Json pair_object(const RobotTable& table, const PairOfLinks& pair) {
  const double high = pair.high ? round_binary64(*pair.high, Rounding::ru) : std::numeric_limits<double>::infinity();
  Json depth = output::signed_depth_object({round_binary64(pair.low, Rounding::rd) + 0.0, high + 0.0});
  if (pair.exact()) depth["exact"] = output::exact_object(pair.low);
  return {{"a", table.name(pair.a)},
          {"b", table.name(pair.b)},
          {"status", pair.status() ? name(*pair.status()) : std::string_view("undecided")},
          {"signed_depth", depth}};
}

/// One line, without its newline.
std::string robot_json(const RobotTable& table) {
  const files::Robot& robot = table.posed.robot;
  Json joints = Json::array();
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].moves())
      joints.push_back({{"name", robot.joints[i].name}, {"value", output::exact(table.posed.values[i])}});
  Json links = Json::array();
  for (const files::RobotLink& link : robot.links)
    links.push_back({{"name", link.name}, {"elements", link.elements.size()}});
  return Json{{"schema", "fathom/robot/1"},
              {"id", robot.file},
              {"links", links},
              {"joints", joints},
              {"angles", {{"turned", robot.angles}, {"off_by_less_than", "1/35184372088832"}}},
              {"adjacent", table.adjacent},
              {"pairs", Json::array_of(table.pairs, [&](const auto& pair) { return pair_object(table, pair); })},
              {"notes", Json::array_of(said_of(table), [](const std::string& note) { return Json(note); })}}
      .text();
}

}  // namespace

ExitCode run_robot(const Given& given) {
  const BodiesRequest request(given);
  const InterruptGuard interrupt_guard;
  Progress progress("pairs");
  const RobotTable table = table_of(request, progress);
  print(request.json ? robot_json(table) : robot_block(table, given.flag("--exact")));
  return fine;
}

}  // namespace fathom::cli
