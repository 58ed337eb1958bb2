// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/stages_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cli/output/answer_output.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"

namespace fathom::cli {
namespace {

using stages::PairFate;
using stages::StagedBody;
using stages::StagedChart;
using stages::StagedPair;
using stages::Stages;

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string answer_text(const Stages& stages) {
  const std::string status(stages.status ? name(*stages.status) : "undecided");
  return stages.depth ? fmt::format("{}; depth {}", status, *stages.depth) : status;
}

std::string body_text(const StagedBody& body) {
  if (body.sampled) return body.facets.empty() ? "not drawn" : counted(body.facets.size(), "sampled facet", "sampled facets");
  return fmt::format("{}, {}, {}{}", counted(body.vertices.size(), "vertex", "vertices"), counted(body.edges.size(), "edge", "edges"),
                     counted(body.facets.size(), "facet", "facets"), body.rank < 3 ? "; flat" : "");
}

std::string chart_text(const Stages& stages, std::size_t chart) {
  const StagedChart& c = stages.charts[chart];
  std::uint64_t pairs = 0, crossings = 0;
  for (const StagedPair& pair : stages.pairs) {
    if (pair.chart != chart) continue;
    ++pairs;
    crossings += pair.crossings();
  }
  return fmt::format("{}; {} of -A, {} of B; {} with {}", counted(c.walls.size(), "wall", "walls"), counted(c.a.arcs.size(), "arc", "arcs"),
                     c.b.arcs.size(), counted(pairs, "canonical pair", "canonical pairs"), counted(crossings, "crossing", "crossings"));
}

std::string search_text(const Stages& stages) {
  std::array<std::uint64_t, 4> pairs{};
  std::uint64_t evaluated = 0;
  for (const StagedPair& pair : stages.pairs) {
    ++pairs[static_cast<std::size_t>(pair.fate)];
    evaluated += pair.evaluated;
  }
  const auto of = [&](PairFate fate) { return pairs[static_cast<std::size_t>(fate)]; };
  return fmt::format("{} scanned, {} cleared, {} cut; {} looked at", counted(of(PairFate::scanned), "pair", "pairs"), of(PairFate::cleared),
                     of(PairFate::cut), counted(evaluated, "crossing", "crossings"));
}

std::string winner_text(const Stages& stages) {
  if (stages.winner->kind == stages::WinnerKind::facet_of_a) return "a facet of A";
  if (stages.winner->kind == stages::WinnerKind::facet_of_b) return "a facet of B";
  if (!stages.winner->pair) return "edges whose arcs do not cross once perturbed";
  const StagedPair& pair = stages.pairs[*stages.winner->pair];
  return fmt::format("a crossing in pair {}, {} x {}", *stages.winner->pair, pair.a.size(), pair.b.size());
}

std::string cutting_text(const stages::StagedCutting& cutting) {
  std::uint64_t blocks = 0;
  for (const stages::StagedLevel& level : cutting.levels)
    blocks += static_cast<std::uint64_t>(
        std::ranges::count_if(level.blocks, [](const auto& block) { return block.fate != stages::BlockFate::refined; }));
  return fmt::format("pair {}, {} and {}{}", cutting.pair, counted(cutting.levels.size(), "level", "levels"),
                     counted(blocks, "block", "blocks"), cutting.as_searched ? "" : ", for a picture: the search does not cut it so");
}

std::string coincidences_text(const Stages& stages) {
  std::vector<std::string> parts;
  for (const stages::StagedCoincidence& found : stages.coincidences) {
    if (found.count == 0) continue;
    parts.push_back(fmt::format("{} {}", spoken(found.kind), found.count));
  }
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string stages_block(const Stages& stages) {
  std::vector<Row> rows{{"A", body_text(stages.a)}, {"B", body_text(stages.b)}};
  for (std::size_t i = 0; i < stages.charts.size(); ++i)
    rows.emplace_back(stages.charts[i].upper ? "upper chart" : "lower chart", chart_text(stages, i));
  if (stages.winner) {
    rows.emplace_back("closest lines", search_text(stages));
    rows.emplace_back("winner", winner_text(stages));
  }
  if (stages.contact.features) rows.emplace_back("contact", contact_text(*stages.contact.features));
  if (stages.cutting) rows.emplace_back("cutting", cutting_text(*stages.cutting));
  if (!stages.coincidences.empty()) rows.emplace_back("coincidences", coincidences_text(stages));
  for (const auto& [stage, seconds] : stages.seconds) rows.emplace_back(stage, fmt::format("{:.3g} s", seconds));
  for (const std::string& sentence : stages.left_out) rows.emplace_back("left out", sentence);
  return aligned(answer_text(stages), rows);
}

std::string stages_line(const Stages& stages) {
  std::uint64_t crossings = 0;
  for (const StagedPair& pair : stages.pairs) crossings += pair.crossings();
  std::vector<std::string> parts{answer_text(stages),
                                 fmt::format("{} with {}", counted(stages.pairs.size(), "canonical pair", "canonical pairs"),
                                             counted(crossings, "crossing", "crossings"))};
  if (stages.winner) parts.push_back(winner_text(stages));
  return case_line(stages.id, parts);
}

}  // namespace fathom::cli
