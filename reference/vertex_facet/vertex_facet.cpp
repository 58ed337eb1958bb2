// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/vertex_facet/vertex_facet.hpp"

#include <algorithm>
#include <set>

#include "kernels/support.hpp"

namespace fathom {
namespace {

// The arcs of one colour that cross the sweep line, from bottom to top. Any two of them overlap in an x-range of positive length, where
// their order is fixed, and a node on the sweep line splits them.
class SweepLine {
 public:
  SweepLine(const Charts& charts, Colour colour) : charts_(charts), colour_(colour), status_(Below{&charts, colour}) {}

  void insert(const ChartArc& arc) { status_.insert(&arc); }
  void erase(const ChartArc& arc) { status_.erase(&arc); }

  /// The vertex whose face holds the node of the other colour.
  [[nodiscard]] std::uint32_t face_of(std::uint32_t node) const {
    const auto upper = status_.lower_bound(Node{node});
    if (upper != status_.begin()) return charts_.vertex_above(colour_, **std::prev(upper));
    if (upper != status_.end()) return charts_.vertex_below(colour_, **upper);
    return 0;  // only the diagram of a single point leaves a vertical free
  }

 private:
  struct Node {
    std::uint32_t index;
  };
  struct Below {
    using is_transparent = void;
    const Charts* charts;
    Colour colour;
    bool operator()(const ChartArc* e, const ChartArc* f) const {
      return e->arc != f->arc && above_same_colour(*charts, colour, *f, *e) > 0;
    }
    bool operator()(const ChartArc* e, Node n) const { return node_above_arc(*charts, other(colour), n.index, colour, *e) > 0; }
    bool operator()(Node n, const ChartArc* e) const { return node_above_arc(*charts, other(colour), n.index, colour, *e) < 0; }
  };

  const Charts& charts_;
  Colour colour_;
  std::set<const ChartArc*, Below> status_;
};

// What happens at each wall: indices of arcs that end, nodes to locate, indices of arcs that begin.
struct Event {
  std::vector<std::uint32_t> ending, beginning, nodes;
};

std::vector<Event> events(const Charts& charts, Colour arcs_of) {
  std::vector<Event> result(charts.walls.size());
  const std::vector<ChartArc>& arcs = charts.arcs_of(arcs_of);
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i].left != at_infinity) result[charts.wall(arcs_of, arcs[i].left)].beginning.push_back(i);
    if (arcs[i].right != at_infinity) result[charts.wall(arcs_of, arcs[i].right)].ending.push_back(i);
  }
  const std::vector<std::uint32_t>& wall_of = charts.wall_of[static_cast<std::size_t>(other(arcs_of))];
  for (std::uint32_t i = 0; i < wall_of.size(); ++i) {
    if (wall_of[i] != at_infinity) result[wall_of[i]].nodes.push_back(i);
  }
  return result;
}

// A wall belongs to one node of one colour, so at each there is either something to insert and erase, or a node to locate.
void sweep(const Charts& charts, Colour arcs_of, std::vector<VertexFacetPair>& pairs) {
  const std::vector<ChartArc>& arcs = charts.arcs_of(arcs_of);
  SweepLine line(charts, arcs_of);
  for (const ChartArc& arc : arcs) {
    if (arc.left == at_infinity) line.insert(arc);
  }
  for (const Event& event : events(charts, arcs_of)) {
    for (const std::uint32_t i : event.ending) line.erase(arcs[i]);
    for (const std::uint32_t node : event.nodes) pairs.push_back({other(arcs_of), node, line.face_of(node)});
    for (const std::uint32_t i : event.beginning) line.insert(arcs[i]);
  }
}

}  // namespace

std::vector<VertexFacetPair> vertex_facet_pairs(const Charts& charts) {
  std::vector<VertexFacetPair> pairs;
  sweep(charts, Colour::a, pairs);
  sweep(charts, Colour::b, pairs);
  return pairs;
}

Report validate(const std::vector<VertexFacetPair>& pairs, const Charts& charts, const Polytope& a, const Polytope& b) {
  Report report;
  std::array<std::vector<int>, 2> seen{std::vector<int>(charts.wall_of[0].size()), std::vector<int>(charts.wall_of[1].size())};
  std::array<PointCloud, 2> vertices;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<Vector> points = (c == 0 ? a : b).vertices;
    if (c == 0) {
      for (Vector& p : points) p = -p;
    }
    vertices[c] = PointCloud(std::move(points));
  }
  for (const VertexFacetPair& pair : pairs) {
    ++seen[static_cast<std::size_t>(pair.facet_of)][pair.facet];
    const std::vector<std::uint32_t> extreme =
        extreme_points(vertices[static_cast<std::size_t>(other(pair.facet_of))], charts.node(pair.facet_of, pair.facet).exact());
    report.expect(std::ranges::binary_search(extreme, pair.vertex),
                  "vertex " + std::to_string(pair.vertex) + " is not extreme in the direction of facet " + std::to_string(pair.facet));
  }
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < seen[c].size(); ++i) {
      report.expect(seen[c][i] == (charts.wall_of[c][i] != at_infinity ? 1 : 0), "node " + std::to_string(i) + " is not located once");
    }
  }
  return report;
}

}  // namespace fathom
