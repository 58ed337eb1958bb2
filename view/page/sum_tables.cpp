// SPDX-License-Identifier: GPL-3.0-or-later
// "Why no shorter way": the facets of P, ranked. Parts of parts.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "fathom/numbers.hpp"
#include "view/page/parts.hpp"

namespace fathom::page {
namespace {

constexpr std::size_t most_facets = 20;

std::string_view feature(std::size_t points) { return points == 1 ? "vertex" : points == 2 ? "edge" : "facet"; }

/// "edge-edge", A's feature first; of Q, whose facets need not be facets of P, how many points span it.
std::string what(const stages::StagedFacet& facet, bool of_p) {
  if (of_p) return fmt::format("{}-{}", feature(facet.a.size()), feature(facet.b.size()));
  return fmt::format("{} and {} points", facet.a.size(), facet.b.size());
}

std::string ids(const std::vector<std::uint32_t>& points) { return page::points(Data(points)); }

/// A length by its square, rounded once.
std::string length(const mpq_class& squared) { return Data(root_binary64(squared)).dump(); }

/// How much longer than the shortest: sqrt(squared / least) - 1, with the difference taken exactly.
std::string longer(const mpq_class& squared, const mpq_class& least) {
  if (squared == least) return "tie";
  const mpq_class ratio = squared / least, more = ratio - 1;
  return fmt::format("{:.3g} %", 100 * round_binary64(more) / (root_binary64(ratio) + 1));
}

}  // namespace

std::string ranked(const stages::Stages& stages) {
  const std::vector<stages::StagedFacet>& facets = stages.sum.facets;
  if (facets.empty() || stages.sum.kind == stages::SumKind::sampled) return "";
  Table table(
      "Facets by their distance from O",
      {"#", "distance", "longer by", stages.sum.kind == stages::SumKind::p ? "'contact" : "'spanned by", "'A's points", "'B's points"});
  const mpq_class& least = facets.front().squared;
  for (std::size_t i = 0; i < std::min(facets.size(), most_facets); ++i) {
    const stages::StagedFacet& facet = facets[i];
    table.add({std::to_string(i + 1), length(facet.squared), longer(facet.squared, least),
               what(facet, stages.sum.kind == stages::SumKind::p), ids(facet.a), ids(facet.b)},
              fmt::format("data-facet=\"{}\"{}", i, facet.optimal ? " class=\"optimal\"" : ""));
  }
  const std::string more =
      facets.size() > most_facets ? fmt::format("<p class=\"soft\">{} facets are farther.</p>\n", facets.size() - most_facets) : "";
  return table.text() + more;
}

std::string lead_why(const stages::Stages& stages) {
  using stages::SumKind;
  const std::size_t facets = stages.sum.facets.size();
  switch (stages.sum.kind) {
    case SumKind::p:
      return fmt::format(
          "P, the set of all differences b - a, has {}. A moved by t is clear of B exactly if t is not inside P: so the way out is as long "
          "as the nearest facet is far from O, and the ball around O that touches it has nothing of the boundary inside.",
          counted(facets, "facet", "facets"));
    case SumKind::q:
      return fmt::format(
          "P, the set of all differences b - a, has too many facets to draw. Shown is Q, the polytope inside P that proves the depth: its "
          "nearest facet lies on the boundary of P, and no one of its {} is nearer to O.",
          counted(facets, "facet", "facets"));
    case SumKind::sampled: return "P, the set of all differences b - a, as a mesh near it: the answer comes from the exact body.";
    case SumKind::none: break;
  }
  if (stages.status == Status::disjoint || stages.status == Status::touching)
    return "O is not inside P, the set of all differences b - a: the bodies do not overlap, and the plane across n is between them.";
  return "P, the set of all differences b - a, is not drawn.";
}

}  // namespace fathom::page
