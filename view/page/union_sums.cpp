// SPDX-License-Identifier: GPL-3.0-or-later
// "Why no shorter way" about unions: union_parts.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "fathom/numbers.hpp"
#include "view/page/parts.hpp"

namespace fathom::page {
namespace {

constexpr std::size_t most_rows = 200;

std::string touches_text(const stages::PieceSum& sum, std::size_t ways) {
  if (sum.touches.empty()) return "no";
  if (ways == 1) return "yes";
  std::string result;
  for (const stages::Index k : sum.touches) result += (result.empty() ? "after way " : ", ") + std::to_string(k + 1);
  return result;
}

}  // namespace

std::string piece_sums(const stages::UnionStages& stages) {
  if (stages.sums.empty()) return "";
  Table table("Differences of pieces that reach into the ball", {"piece of A", "piece of B", "'O is", "distance", "'touch"});
  for (std::size_t i = 0; i < std::min(stages.sums.size(), most_rows); ++i) {
    const stages::PieceSum& sum = stages.sums[i];
    table.add({std::to_string(sum.a), std::to_string(sum.b),
               sum.inside         ? "inside"
               : sum.squared == 0 ? "on it"
                                  : "outside",
               Data(root_binary64(sum.squared)).dump(), touches_text(sum, stages.ways.size())},
              fmt::format("data-pair=\"{}\"{}", i, sum.touches.empty() ? "" : " class=\"optimal\""));
  }
  const std::string more = stages.sums.size() > most_rows
                               ? fmt::format("<p class=\"soft\">{} pairs more are not listed here.</p>\n", stages.sums.size() - most_rows)
                               : "";
  return table.text() + more;
}

std::string lead_of_sums(const stages::UnionStages& stages) {
  if (stages.status != Status::penetrating)
    return "No two pieces have interiors in common: O is in the interior of no set of differences b - a of pieces.";
  return fmt::format(
      "A moved by t overlaps B exactly if t is in the interior of the differences b - a of a piece of A and one of B. So the depth is the "
      "distance from O to the nearest point that none of the {} x {} sets of differences holds inside: together they cover the ball around "
      "O, and "
      "at the end of the way out the boundaries meet of those that touch there. {} into the ball.",
      stages.a.size(), stages.b.size(), counted(stages.sums.size(), "of them reaches", "of them reach"));
}

}  // namespace fathom::page
