// SPDX-License-Identifier: GPL-3.0-or-later
// Counts of the exact method beside the paper's bounds, without constants. Part of parts.hpp.
#include <cmath>

#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

/// m and n: the numbers of edges.
struct Sizes {
  double m, n;
  [[nodiscard]] double both() const { return m + n; }
  [[nodiscard]] double log() const { return std::log2(std::max(2.0, both())); }
};

}  // namespace

void add_bounds(const StagesSource& subject, Stages& stages) {
  const depth::Hulls& hulls = subject.exact.hulls;
  const Sizes size{static_cast<double>(hulls.a.edges.size()), static_cast<double>(hulls.b.edges.size())};
  const std::uint64_t vertices = hulls.a.vertices.size() + hulls.b.vertices.size(), edges = hulls.a.edges.size() + hulls.b.edges.size(),
                      facets = hulls.a.facets.size() + hulls.b.facets.size();
  std::uint64_t walls = 0, pieces = 0, pairs = 0, sums = 0, crossings = 0;
  for (const chart::Charts& charts : subject.exact.charts) {
    walls += charts.walls.size();
    pieces += charts.of.a.arcs.size() + charts.of.b.arcs.size();
  }
  for (const canonical::CanonicalSubsets& subsets : subject.exact.subsets) {
    const canonical::CanonicalSubsets::Sums of_subsets = subsets.sums();
    pairs += subsets.size();
    sums += of_subsets.a + of_subsets.b;
    crossings += of_subsets.product;
  }
  const auto add = [&](std::string_view stage, std::string_view what, std::uint64_t count, std::string_view bound, double value,
                       std::string_view source) {
    stages.bounds.push_back({stage, what, count, bound, value, source});
  };
  const double near_linear = size.both() * size.log() * size.log();
  add("hulls", "vertices of A and B", vertices, "m + n", size.both(), "m, n: the edges of A and of B");
  add("diagrams", "arcs", edges, "m + n", size.both(), "one for each edge: section 2.2");
  add("diagrams", "nodes", facets, "m + n", size.both(), "one for each facet: section 2.2");
  add("charts", "arcs of both charts", pieces, "2 (m + n)", 2 * size.both(), "section 2.2, \"Computing F\"");
  add("charts", "walls", walls, "m + n", size.both(), "section 2.2, \"Computing F\"");
  if (stages.status == Status::penetrating)
    add("vertex-facet pairs", "facets with their vertices", stages.counters.vertex_facet_pairs, "m + n", size.both(),
        "PENETRATION-DEPTH, step 1");
  add("canonical subsets", "pairs (A_i, B_i)", pairs, "(m + n) log^2(m + n)", near_linear, "(C5)");
  add("canonical subsets", "sum |A_i| + |B_i|", sums, "(m + n) log^2(m + n)", near_linear, "(C5) and equation (1)");
  add("canonical subsets", "crossings: sum |A_i| |B_i|", crossings, "m n", size.m * size.n, "each crossing once: (C2), (C3)");
  if (stages.status == Status::penetrating)
    add("closest lines", "pairs of lines looked at", stages.counters.pairs_evaluated, "(m n)^(3/4) + m + n",
        std::pow(size.m * size.n, 0.75) + size.both(),
        "section 2.3, expected, up to eps in the exponents; not proved for cuttings in order");
}

}  // namespace fathom::stages
