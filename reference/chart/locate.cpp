// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/locate.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace fathom {
namespace {

// The arcs of one colour that cross the sweep line, by index, which is from bottom to top. A balanced tree in heap order; each node holds
// the greatest index in its subtree.
class SweepLine {
 public:
  SweepLine(const PerturbedKernel& kernel, const Charts& charts, Colour colour)
      : kernel_(kernel),
        charts_(charts),
        colour_(colour),
        leaves_(std::bit_ceil(std::max<std::uint32_t>(1, static_cast<std::uint32_t>(charts.arcs_of(colour).size())))),
        highest_(2 * std::size_t{leaves_}, none) {}

  void insert(std::uint32_t arc) {
    for (std::size_t i = leaves_ + arc; i > 0 && (highest_[i] == none || highest_[i] < arc); i /= 2) highest_[i] = arc;
  }

  void erase(std::uint32_t arc) {
    std::size_t i = leaves_ + arc;
    highest_[i] = none;
    for (i /= 2; i > 0 && highest_[i] == arc; i /= 2) highest_[i] = highest_[2 * i + 1] != none ? highest_[2 * i + 1] : highest_[2 * i];
  }

  [[nodiscard]] NodePlace locate(std::uint32_t node) const {
    const std::uint32_t below = highest_below(node);
    const std::vector<ChartArc>& arcs = charts_.arcs_of(colour_);
    if (below != none) return {below + 1, charts_.vertex_above(colour_, arcs[below])};
    if (highest_[1] != none) return {0, charts_.vertex_below(colour_, arcs[lowest()])};
    return {0, 0};  // only the diagram of a single point leaves a vertical free
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  [[nodiscard]] bool passes_below(std::uint32_t arc, std::uint32_t node, const Vec3<double>& at) const {
    if (const std::optional<Sign> side = sure_side_of_arc(at, charts_.circles_of(colour_)[arc])) {
      kernel_.count_calls(Predicate::side_of_arc, 1);
      return side == Sign::positive;
    }
    return node_above_arc(kernel_, charts_, other(colour_), node, colour_, charts_.arcs_of(colour_)[arc]) == Sign::positive;
  }

  // Of the arcs on the sweep line the highest that passes below the node. A predicate is asked only where both subtrees hold arcs.
  [[nodiscard]] std::uint32_t highest_below(std::uint32_t node) const {
    const Vec3<double> at = image(charts_.node(other(colour_), node));
    std::uint32_t below = none;
    std::size_t i = 1;
    while (i < leaves_) {
      const std::uint32_t left = highest_[2 * i], right = highest_[2 * i + 1];
      if (left == none || (right != none && passes_below(left, node, at))) {
        if (left != none) below = left;
        i = 2 * i + 1;
      } else {
        i = 2 * i;
      }
    }
    return highest_[i] != none && passes_below(highest_[i], node, at) ? highest_[i] : below;
  }

  [[nodiscard]] std::uint32_t lowest() const {
    std::size_t i = 1;
    while (i < leaves_) i = highest_[2 * i] != none ? 2 * i : 2 * i + 1;
    return highest_[i];
  }

  const PerturbedKernel& kernel_;
  const Charts& charts_;
  Colour colour_;
  std::uint32_t leaves_;
  std::vector<std::uint32_t> highest_;
};

// The arcs at each node of the diagram: those of node i are arcs[begin[i], begin[i + 1]).
struct Incidence {
  std::vector<std::uint32_t> begin, arcs;

  Incidence(const Charts& charts, Colour colour) : begin(charts.diagram(colour).nodes.size() + 1, 0) {
    const std::vector<ChartArc>& all = charts.arcs_of(colour);
    const auto ends = [&](const ChartArc& arc, const auto& visit) {
      if (arc.left != at_infinity) visit(arc.left);
      if (arc.right != at_infinity) visit(arc.right);
    };
    for (const ChartArc& arc : all) ends(arc, [&](std::uint32_t node) { ++begin[node]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& b : begin) b = sum += b;
    arcs.resize(sum);
    for (std::uint32_t i = 0; i < all.size(); ++i) ends(all[i], [&](std::uint32_t node) { arcs[--begin[node]] = i; });
  }
};

// Both colours' arcs that reach to the same infinity are sorted there by index. Merges them by height.
void locate_at_infinity(const PerturbedKernel& kernel, Charts& charts, bool at_left) {
  std::array<std::vector<std::uint32_t>, 2> ends;
  for (const std::size_t c : {0, 1}) {
    for (std::uint32_t i = 0; i < charts.arcs[c].size(); ++i) {
      if ((at_left ? charts.arcs[c][i].left : charts.arcs[c][i].right) == at_infinity) ends[c].push_back(i);
    }
  }
  std::array<std::size_t, 2> next{};
  std::array<std::uint32_t, 2> height{};  // one more than the last index that was taken
  while (next[0] < ends[0].size() || next[1] < ends[1].size()) {
    std::size_t c = next[0] < ends[0].size() ? 0 : 1;
    if (next[0] < ends[0].size() && next[1] < ends[1].size()) {
      const Sign sign =
          above_far_left(kernel, charts, Colour::a, charts.arcs[0][ends[0][next[0]]], Colour::b, charts.arcs[1][ends[1][next[1]]]);
      c = (sign == Sign::positive) == at_left ? 1 : 0;
    }
    const std::uint32_t lower = ends[c][next[c]++];
    ChartArc& arc = charts.arcs[c][lower];
    (at_left ? arc.left_height : arc.right_height) = height[1 - c];
    height[c] = lower + 1;
  }
}

}  // namespace

// A wall belongs to one node of one colour: there arcs leave the sweep line and enter it, or the node is located.
void locate_nodes(const PerturbedKernel& kernel, Charts& charts, Colour colour) {
  std::vector<NodePlace>& places = charts.place_of[static_cast<std::size_t>(colour)];
  places.assign(charts.diagram(colour).nodes.size(), {});
  const Colour of_arcs = other(colour);
  const std::vector<ChartArc>& arcs = charts.arcs_of(of_arcs);
  const Incidence incidence(charts, of_arcs);
  SweepLine line(kernel, charts, of_arcs);
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i].left == at_infinity) line.insert(i);
  }
  for (const Charts::Wall& wall : charts.walls) {
    if (wall.colour == colour) {
      places[wall.node] = line.locate(wall.node);
      continue;
    }
    for (std::uint32_t k = incidence.begin[wall.node]; k < incidence.begin[wall.node + 1]; ++k) {
      const std::uint32_t i = incidence.arcs[k];
      if (arcs[i].left == wall.node) {
        line.insert(i);
      } else {
        line.erase(i);
      }
    }
  }
}

void locate_ends(const PerturbedKernel& kernel, Charts& charts) {
  for (const Colour c : {Colour::a, Colour::b}) {
    for (ChartArc& arc : charts.arcs[static_cast<std::size_t>(c)]) {
      if (arc.left != at_infinity) arc.left_height = charts.place(c, arc.left).height;
      if (arc.right != at_infinity) arc.right_height = charts.place(c, arc.right).height;
    }
  }
  for (const bool at_left : {true, false}) locate_at_infinity(kernel, charts, at_left);
}

}  // namespace fathom
