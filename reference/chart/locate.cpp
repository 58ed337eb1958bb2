// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/locate.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numeric>
#include <span>

#include "reference/chart/chart.hpp"

namespace fathom::chart {
namespace {

// The arcs of one colour that cross the sweep line, by id, which is from bottom to top. A balanced tree in heap order; each node holds the
// greatest id in its subtree.
class SweepLine {
 public:
  SweepLine(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour colour)
      : kernel_(kernel),
        charts_(charts),
        colour_(colour),
        chart_(charts.of[colour]),
        leaves_(std::bit_ceil(std::max<std::size_t>(1, chart_.arcs.size()))),
        highest_(2 * leaves_, ChartArcId::none()) {}

  void insert(ChartArcId arc) {
    for (std::size_t i = leaves_ + arc.value; i > 0 && (highest_[i].is_none() || highest_[i] < arc); i /= 2) highest_[i] = arc;
  }

  void erase(ChartArcId arc) {
    std::size_t i = leaves_ + arc.value;
    highest_[i] = ChartArcId::none();
    for (i /= 2; i > 0 && highest_[i] == arc; i /= 2) {
      highest_[i] = !highest_[2 * i + 1].is_none() ? highest_[2 * i + 1] : highest_[2 * i];
    }
  }

  [[nodiscard]] NodePlace locate(gaussian::NodeId node) const {
    const ChartArcId below = highest_below(node);
    if (!below.is_none()) return {below.next(), chart_.vertex_above(chart_.arcs[below])};
    if (!highest_[1].is_none()) return {ChartArcId(0), chart_.vertex_below(chart_.arcs[lowest()])};
    return {};  // only the diagram of a single point, whose face is vertex 0, leaves a vertical free
  }

 private:
  [[nodiscard]] bool passes_below(ChartArcId arc, gaussian::NodeId node, const Vec3<double>& at) const {
    if (const std::optional<kernels::Sign> side = kernels::sure_side_of_arc(at, chart_.circles[arc])) {
      kernel_.count_calls(Predicate::side_of_arc, 1);
      return side == kernels::Sign::positive;
    }
    return node_above_arc(kernel_, charts_, gaussian::other(colour_), node, colour_, chart_.arcs[arc]) == kernels::Sign::positive;
  }

  // Of the arcs on the sweep line the highest that passes below the node. Asks a predicate only where both subtrees hold arcs.
  [[nodiscard]] ChartArcId highest_below(gaussian::NodeId node) const {
    const Vec3<double> at = kernels::image(charts_.of[gaussian::other(colour_)].node(node));
    ChartArcId below = ChartArcId::none();
    std::size_t i = 1;
    while (i < leaves_) {
      const ChartArcId left = highest_[2 * i], right = highest_[2 * i + 1];
      if (left.is_none() || (!right.is_none() && passes_below(left, node, at))) {
        if (!left.is_none()) below = left;
        i = 2 * i + 1;
      } else {
        i = 2 * i;
      }
    }
    return !highest_[i].is_none() && passes_below(highest_[i], node, at) ? highest_[i] : below;
  }

  [[nodiscard]] ChartArcId lowest() const {
    std::size_t i = 1;
    while (i < leaves_) i = !highest_[2 * i].is_none() ? 2 * i : 2 * i + 1;
    return highest_[i];
  }

  const kernels::PerturbedKernel& kernel_;
  const Charts& charts_;
  gaussian::Colour colour_;
  const ColourChart& chart_;
  std::size_t leaves_;
  std::vector<ChartArcId> highest_;
};

// The arcs at each node of the diagram.
class Incidence {
 public:
  explicit Incidence(const ColourChart& chart) : begin_(chart.diagram->nodes.size() + 1) {
    const auto ends = [&](const ChartArc& arc, const auto& visit) {
      if (arc.left != at_infinity) visit(arc.left);
      if (arc.right != at_infinity) visit(arc.right);
    };
    for (const ChartArc& arc : chart.arcs) ends(arc, [&](gaussian::NodeId node) { ++begin_[node]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    arcs_.resize(begin_.back());
    for (const ChartArcId i : chart.arcs.ids()) ends(chart.arcs[i], [&](gaussian::NodeId node) { arcs_[--begin_[node]] = i; });
  }

  [[nodiscard]] std::span<const ChartArcId> at(gaussian::NodeId node) const {
    return std::span(arcs_).subspan(begin_[node], begin_[node.next()] - begin_[node]);
  }

 private:
  kernels::IdVector<gaussian::NodeId, std::uint32_t> begin_;
  std::vector<ChartArcId> arcs_;
};

// The ends of arcs on one side, with what is noted there.
struct Ends {
  gaussian::NodeId ChartArc::*node;
  ChartArcId ChartArc::*height;
};
constexpr Ends left_ends{&ChartArc::left, &ChartArc::left_height};
constexpr Ends right_ends{&ChartArc::right, &ChartArc::right_height};

// The arcs of each colour that reach to one infinity are sorted there by id. Merges both colours by height.
void locate_at_infinity(const kernels::PerturbedKernel& kernel, Charts& charts, const Ends& side) {
  const bool at_left = side.node == left_ends.node;
  gaussian::PerColour<std::vector<ChartArcId>> ends;
  for (const gaussian::Colour c : gaussian::both_colours) {
    const kernels::IdVector<ChartArcId, ChartArc>& arcs = charts.of[c].arcs;
    std::ranges::copy_if(arcs.ids(), std::back_inserter(ends[c]), [&](ChartArcId i) { return arcs[i].*side.node == at_infinity; });
  }
  gaussian::PerColour<std::size_t> next{};
  gaussian::PerColour<ChartArcId> height{};  // the id after the last arc that was taken
  const auto arc = [&](gaussian::Colour c) -> ChartArc& { return charts.of[c].arcs[ends[c][next[c]]]; };
  while (next.a < ends.a.size() || next.b < ends.b.size()) {
    gaussian::Colour lower = next.a < ends.a.size() ? gaussian::Colour::a : gaussian::Colour::b;
    if (next.a < ends.a.size() && next.b < ends.b.size()) {
      const bool a_above = above_far_left(kernel, charts, gaussian::Colour::a, arc(gaussian::Colour::a), gaussian::Colour::b,
                                          arc(gaussian::Colour::b)) == kernels::Sign::positive;
      lower = a_above == at_left ? gaussian::Colour::b : gaussian::Colour::a;
    }
    arc(lower).*side.height = height[gaussian::other(lower)];
    height[lower] = ends[lower][next[lower]++].next();
  }
}

}  // namespace

// A wall belongs to one node of one colour: there arcs leave the sweep line and enter it, or the node is located.
void locate_nodes(const kernels::PerturbedKernel& kernel, Charts& charts, gaussian::Colour colour) {
  kernels::IdVector<gaussian::NodeId, NodePlace>& places = charts.of[colour].place_of;
  places.assign(charts.of[colour].diagram->nodes.size(), {});
  const kernels::IdVector<ChartArcId, ChartArc>& arcs = charts.of[gaussian::other(colour)].arcs;
  const Incidence incidence(charts.of[gaussian::other(colour)]);
  SweepLine line(kernel, charts, gaussian::other(colour));
  for (const ChartArcId i : arcs.ids()) {
    if (arcs[i].left == at_infinity) line.insert(i);
  }
  for (const Wall& wall : charts.walls) {
    if (wall.colour == colour) {
      places[wall.node] = line.locate(wall.node);
      continue;
    }
    for (const ChartArcId i : incidence.at(wall.node)) {
      if (arcs[i].left == wall.node) {
        line.insert(i);
      } else {
        line.erase(i);
      }
    }
  }
}

void locate_ends(const kernels::PerturbedKernel& kernel, Charts& charts) {
  for (const gaussian::Colour c : gaussian::both_colours) {
    ColourChart& chart = charts.of[c];
    for (ChartArc& arc : chart.arcs) {
      if (arc.left != at_infinity) arc.left_height = chart.place_of[arc.left].height;
      if (arc.right != at_infinity) arc.right_height = chart.place_of[arc.right].height;
    }
  }
  for (const Ends& side : {left_ends, right_ends}) locate_at_infinity(kernel, charts, side);
}

}  // namespace fathom::chart
