// SPDX-License-Identifier: GPL-3.0-or-later
// fathom stages A B | CASES.jsonl | -
// Prints the size and the result of each stage as text; stages::to_json writes them as JSON.

#include "view/stages/stages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/messages.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

using kernels::counted;
using stages::PairFate;
using stages::StagedBody;
using stages::StagedChart;
using stages::StagedPair;
using stages::Stages;

std::string answer_text(const Stages& stages) {
  const std::string status(name(stages.status));
  return stages.depth ? fmt::format("{}; depth {}", status, *stages.depth) : status;
}

std::string body_text(const StagedBody& body) {
  if (body.sampled)
    return body.facets.empty() ? "not drawn" : counted(body.facets.size(), "sampled facet", "sampled facets");
  return fmt::format("{}, {}, {}{}", counted(body.vertices.size(), "vertex", "vertices"),
                     counted(body.edges.size(), "edge", "edges"), counted(body.facets.size(), "facet", "facets"),
                     body.rank < 3 ? "; flat" : "");
}

std::string chart_text(const Stages& stages, std::size_t chart) {
  const StagedChart& c = stages.charts[chart];
  std::uint64_t pairs = 0, crossings = 0;
  for (const StagedPair& pair : stages.pairs) {
    if (pair.chart != chart) continue;
    ++pairs;
    crossings += pair.crossings();
  }
  return fmt::format("{}; {} of -A, {} of B; {} with {}", counted(c.walls.size(), "wall", "walls"),
                     counted(c.a.arcs.size(), "arc", "arcs"), c.b.arcs.size(),
                     counted(pairs, "canonical pair", "canonical pairs"), counted(crossings, "crossing", "crossings"));
}

std::string search_text(const Stages& stages) {
  std::array<std::uint64_t, 4> pairs{};
  std::uint64_t evaluated = 0;
  for (const StagedPair& pair : stages.pairs) {
    ++pairs[static_cast<std::size_t>(pair.fate)];
    evaluated += pair.evaluated;
  }
  const auto of = [&](PairFate fate) { return pairs[static_cast<std::size_t>(fate)]; };
  return fmt::format("{} scanned, {} cleared, {} cut; {} looked at", counted(of(PairFate::scanned), "pair", "pairs"),
                     of(PairFate::cleared), of(PairFate::cut), counted(evaluated, "crossing", "crossings"));
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
    blocks += static_cast<std::uint64_t>(std::ranges::count_if(
        level.blocks, [](const auto& block) { return block.fate != stages::BlockFate::refined; }));
  return fmt::format("pair {}, {} and {}{}", cutting.pair, counted(cutting.levels.size(), "level", "levels"),
                     counted(blocks, "block", "blocks"),
                     cutting.as_searched ? "" : ", for a picture: the search does not cut it so");
}

std::string coincidences_text(const Stages& stages) {
  std::vector<std::string> parts;
  for (const stages::StagedCoincidence& found : stages.coincidences) {
    if (found.count == 0) continue;
    parts.push_back(fmt::format("{} {}", spoken(found.kind), found.count));
  }
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

/// Returns several lines, without the last newline.
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

/// Returns one line, without its newline.
std::string stages_line(const Stages& stages) {
  std::uint64_t crossings = 0;
  for (const StagedPair& pair : stages.pairs) crossings += pair.crossings();
  std::vector<std::string> parts{
      answer_text(stages), fmt::format("{} with {}", counted(stages.pairs.size(), "canonical pair", "canonical pairs"),
                                       counted(crossings, "crossing", "crossings"))};
  if (stages.winner) parts.push_back(winner_text(stages));
  return case_line(stages.id, parts);
}

struct StagesRequest : BodiesRequest {
  explicit StagesRequest(const Given& given)
      : BodiesRequest(given), times(given.flag("--times")), svg(given.text("--svg")) {}

  bool times;       ///< with the seconds of each stage
  std::string svg;  ///< the file for the charts, or for a stream the folder; empty: none
};

std::string text_of(const stages::Stages& stages, const StagesRequest& request) {
  if (request.json) return stages::to_json(stages);
  return is_stream(request) ? stages_line(stages) : stages_block(stages);
}

/// Returns the picture. Throws InputError if there is nothing to draw.
std::string picture_of(const Case& pair, const stages::Stages& stages) {
  if (stages.charts.empty())
    throw InputError(pair.id, 0, "--svg draws the charts of polytopes, found a shape that is none");
  return stages::charts_file(stages);
}

}  // namespace

ExitCode run_stages(const Given& given) {
  const StagesRequest request(given);
  Replies replies;
  const auto pictures = std::make_shared<FilePlaces>(request, request.svg, "picture", ".svg");
  replies.refuses_unions = "the stages are those of two convex bodies; explain shows how a union was answered";
  replies.refuses_plane = "the stages are those of the exact method in space; explain draws those";
  replies.reply = [&request, pictures](const Case& pair, Monitor& monitor, Workspace&) {
    const std::unique_ptr<CertificateFile> drawing = pictures->single();  // fails early for an unwritable path
    if (has_shape(pair)) require_depth(pair.id, files::shape_of(pair.a), files::shape_of(pair.b));
    stages::Stages stages = stages::stages_of(pair.a, pair.b, {request.times, &monitor});
    stages.id = pair.id;
    CaseReply reply{text_of(stages, request)};
    const std::string picture = pictures->wanted() ? picture_of(pair, stages) : "";
    if (drawing) drawing->write(picture);
    else if (pictures->wanted())
      reply.keep = [pictures, picture, id = pair.id] { pictures->write_to_folder(id, picture); };
    return reply;
  };
  if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::error_object("fathom/stages/1", item.id, item.line, fault);
    };
  }
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
