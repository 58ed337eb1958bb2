// SPDX-License-Identifier: GPL-3.0-or-later
// "Where it comes from": canonical pairs and a cutting. Parts of parts.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fathom/numbers.hpp"
#include "view/page/parts.hpp"

namespace fathom::page {
namespace {

constexpr std::size_t most_pairs = 20;

std::string_view words(stages::PairFate fate) {
  switch (fate) {
    case stages::PairFate::none: return "-";
    case stages::PairFate::scanned: return "scanned";
    case stages::PairFate::cleared: return "cleared";
    case stages::PairFate::cut: return "cut";
  }
  return "";
}

/// By crossings, the most first; of equal ones the first found.
std::vector<std::size_t> largest_pairs(const stages::Stages& stages) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < stages.pairs.size(); ++i)
    if (stages.pairs[i].crossings() > 1) order.push_back(i);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return stages.pairs[i].crossings(); });
  return order;
}

std::vector<std::string> row(const stages::Stages& stages, std::size_t i) {
  const stages::StagedPair& pair = stages.pairs[i];
  return {std::to_string(i),
          stages.charts.size() > pair.chart && stages.charts[pair.chart].upper ? "upper" : "lower",
          pair.stored_of_a ? "A" : "B",
          fmt::format("{} x {}", pair.a.size(), pair.b.size()),
          pair.closest ? Data(root_binary64(pair.closest->squared)).dump() : "-",
          pair.closest ? fmt::format("{}, {}", pair.closest->a, pair.closest->b) : "-",
          std::to_string(pair.evaluated),
          std::string(words(pair.fate))};
}

}  // namespace

std::string pairs(const stages::Stages& stages) {
  if (stages.pairs.empty()) return "";
  const std::vector<std::size_t> order = largest_pairs(stages);
  const std::size_t single = stages.pairs.size() - order.size();
  Table table("Canonical pairs by crossings",
              {"#", "'hemisphere", "'stored of", "|A_i| x |B_i|", "closest lines", "edges of A, B", "evaluated", "'search"});
  for (std::size_t k = 0; k < std::min(order.size(), most_pairs); ++k)
    table.add(row(stages, order[k]), fmt::format("data-pair=\"{}\"", order[k]));
  std::string result = "<h3>Canonical pairs</h3>\n";
  if (!table.empty()) result += table.text();
  if (order.size() > most_pairs)
    result += fmt::format("<p class=\"soft\">{} more have several crossings.</p>\n", order.size() - most_pairs);
  if (single > 0) result += fmt::format("<p class=\"soft\">{} of one crossing.</p>\n", counted(single, "pair is", "pairs are"));
  return result;
}

std::string cutting(const stages::Stages& stages) {
  if (!stages.cutting) return "";
  Table table(fmt::format("Cutting of pair {}", stages.cutting->pair), {"level", "'cut", "blocks", "cleared", "refined", "scanned", "won"});
  for (std::size_t k = 0; k < stages.cutting->levels.size(); ++k) {
    const stages::StagedLevel& level = stages.cutting->levels[k];
    std::array<std::size_t, 4> fates{};
    for (const stages::StagedBlock& block : level.blocks) ++fates[static_cast<std::size_t>(block.fate)];
    table.add({std::to_string(k),
               !level.cut_a   ? "-"
               : *level.cut_a ? "A"
                              : "B",
               std::to_string(level.blocks.size()), std::to_string(fates[0]), std::to_string(fates[1]), std::to_string(fates[2]),
               std::to_string(fates[3])});
  }
  const std::string_view note = stages.cutting->as_searched
                                    ? "The search cut it so."
                                    : "The search looks at a pair this small all at once; it is cut here to show how large ones are.";
  return fmt::format("<h3>How a pair is cut</h3>\n<p>{} is the pair {}. {}</p>\n", fmt::format("Pair {}", stages.cutting->pair),
                     stages.cutting->winner ? "that holds the optimum" : "with the most crossings", note) +
         table.text();
}

std::string lead_where(const stages::Stages& stages) {
  if (stages.charts.empty()) return "The exact method of AGHRS is about polytopes: there are no diagrams here.";
  std::string winner;
  if (stages.winner) {
    using stages::WinnerKind;
    const WinnerKind kind = stages.winner->kind;
    winner = kind == WinnerKind::edges
                 ? (stages.winner->pair ? fmt::format(" The answer is a crossing of arcs, of canonical pair {}.", *stages.winner->pair)
                                        : std::string(" The answer is where two arcs meet."))
             : kind == WinnerKind::facet_of_a ? " The answer is a node of A: a facet of A against a vertex of B."
                                              : " The answer is a node of B: a facet of B against a vertex of A.";
  }
  return fmt::format(
      "The Gaussian diagrams of -A and of B: a node is a facet's normal, an arc is an edge. A facet of P is a node of one in a face of the "
      "other, or a crossing of two arcs. All {} are in {}, in which every arc of A_i crosses every arc of B_i.{}",
      counted(stages.counters.crossings, "crossing", "crossings"), counted(stages.pairs.size(), "canonical pair", "canonical pairs"),
      winner);
}

}  // namespace fathom::page
