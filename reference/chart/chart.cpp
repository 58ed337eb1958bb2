// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace fathom::chart {

gaussian::VertexId ColourChart::vertex_above(const ChartArc& arc) const {
  const gaussian::Arc& whole = diagram->arcs[arc.arc];
  return arc.flipped ? whole.below : whole.above;
}

gaussian::VertexId ColourChart::vertex_below(const ChartArc& arc) const {
  const gaussian::Arc& whole = diagram->arcs[arc.arc];
  return arc.flipped ? whole.above : whole.below;
}

Frame chart_frame(Hemisphere hemisphere) {
  return {kernels::Direction(Vector{0, 1, 0}, kernels::Role::vertical),
          kernels::Direction(Vector{0, 0, hemisphere == Hemisphere::upper ? 1 : -1}, kernels::Role::pole)};
}

kernels::Sign node_above_arc(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_node,
                             gaussian::NodeId node, gaussian::Colour of_arc, const ChartArc& arc) {
  return orientation(arc) * kernel.side_of_arc(charts.of[of_node].node(node), charts.of[of_arc].circle(arc));
}

kernels::Sign above_on_wall(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e,
                            const ChartArc& e, gaussian::Colour of_f, const ChartArc& f, const Wall& wall) {
  return orientation(e) * orientation(f) *
         kernel.order_on_vertical(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.node(wall),
                                  charts.frame.v);
}

kernels::Sign above_far_left(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e,
                             const ChartArc& e, gaussian::Colour of_f, const ChartArc& f) {
  return orientation(e) * orientation(f) *
         kernel.order_at_infinity(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.frame.z);
}

kernels::Sign above_same_colour(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour colour,
                                const ChartArc& e, const ChartArc& f) {
  const auto wall = [&](gaussian::NodeId node) { return charts.of[colour].wall_of[node]; };
  // An end that only one of them has lies off the other, since arcs of one diagram meet in common
  // ends only.
  if (e.left != f.left) {
    const bool later = f.left == at_infinity || (e.left != at_infinity && wall(e.left) > wall(f.left));
    return later ? node_above_arc(kernel, charts, colour, e.left, colour, f)
                 : -node_above_arc(kernel, charts, colour, f.left, colour, e);
  }
  if (e.right != f.right) {
    const bool earlier = f.right == at_infinity || (e.right != at_infinity && wall(e.right) < wall(f.right));
    return earlier ? node_above_arc(kernel, charts, colour, e.right, colour, f)
                   : -node_above_arc(kernel, charts, colour, f.right, colour, e);
  }
  // Both run from one node to the same infinity, or from it to one node: the order there is that of
  // their slopes.
  const kernels::Sign far_left = above_far_left(kernel, charts, colour, e, colour, f);
  return e.left == at_infinity ? far_left : -far_left;
}

namespace {

// Which nodes and arcs lie in the hemisphere.

// Tells the nodes of this hemisphere from the others, before their walls are known.
constexpr WallId some_wall{0};

void find_nodes(const kernels::PerturbedKernel& kernel, const Charts& charts, ColourChart& chart) {
  chart.wall_of.assign(chart.diagram->nodes.size(), WallId::none());
  for (const gaussian::NodeId i : chart.wall_of.ids()) {
    if (kernel.side_of_equator(chart.node(i), charts.frame.z) == kernels::Sign::positive) chart.wall_of[i] = some_wall;
  }
}

void find_arcs(const kernels::PerturbedKernel& kernel, const Charts& charts, ColourChart& chart) {
  const gaussian::GaussianDiagram& diagram = *chart.diagram;
  const auto end = [&](gaussian::NodeId node) {
    return node.is_none() || chart.wall_of[node].is_none() ? at_infinity : node;
  };
  for (const gaussian::ArcId i : diagram.arcs.ids()) {
    const gaussian::Arc& arc = diagram.arcs[i];
    const gaussian::NodeId from = end(arc.from), to = end(arc.to);
    // An arc of rank 2 or 3 with no end here lies in the other hemisphere: it is no longer than pi.
    if (diagram.rank > 1 && from == at_infinity && to == at_infinity) continue;
    const bool flipped = kernel.side_of_arc(charts.frame.v, arc.circle) == kernels::Sign::negative;
    chart.arcs.push_back({i, flipped ? to : from, flipped ? from : to, flipped, {}, {}});
  }
}

void draw_circles(ColourChart& chart) {
  chart.circles.reserve(chart.arcs.size());
  for (const ChartArc& arc : chart.arcs) {
    const Vec3<double> d = kernels::image(chart.circle(arc));
    chart.circles.push_back(arc.flipped ? -d : d);
  }
}

// The order "above" of a colour's arcs, as one list.

// Indices 0, 1, ... grouped by a key below `keys`: those of key k are items[begin[k], begin[k +
// 1]), ascending.
struct Groups {
  std::vector<std::uint32_t> begin, items;
};

template <class Key>
Groups group(std::uint32_t count, std::uint32_t keys, Key key) {
  Groups groups{std::vector<std::uint32_t>(keys + 1, 0), std::vector<std::uint32_t>(count)};
  for (std::uint32_t i = 0; i < count; ++i) ++groups.begin[key(i)];
  std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
  for (std::uint32_t i = count; i-- > 0;) groups.items[--groups.begin[key(i)]] = i;
  return groups;
}

// Puts the arcs of a chart into height order: where two overlap in an x-interval, the higher one
// comes later. It asks no predicate: an arc leads from the face below it to the face above it, and
// the faces are sorted topologically. Linear, not recursive. Throws std::logic_error if the arcs
// lead around in a circle: then they are not a diagram.           [proofs/chart.md, "Height order"]
void sort_by_height(ColourChart& chart) {
  const std::vector<ChartArc>& arcs = chart.arcs;
  const auto above = [&](const ChartArc& arc) { return chart.vertex_above(arc).value; };
  const auto below = [&](const ChartArc& arc) { return chart.vertex_below(arc).value; };
  std::uint32_t faces = 0;
  for (const ChartArc& arc : arcs) faces = std::max({faces, above(arc) + 1, below(arc) + 1});
  const auto count = static_cast<std::uint32_t>(arcs.size());
  const Groups leaving = group(count, faces, [&](std::uint32_t i) { return below(arcs[i]); });
  std::vector<std::uint32_t> waiting(faces, 0);  // of each face, how many arcs below it have not been listed
  for (const ChartArc& arc : arcs) ++waiting[above(arc)];
  std::vector<std::uint32_t> ready;  // faces in topological order, as a queue
  for (std::uint32_t f = 0; f < faces; ++f) {
    if (waiting[f] == 0) ready.push_back(f);
  }
  kernels::IdVector<ChartArcId, ChartArc> sorted;
  sorted.reserve(arcs.size());
  for (std::size_t k = 0; k < ready.size(); ++k) {
    const std::uint32_t face = ready[k];
    for (std::uint32_t i = leaving.begin[face]; i < leaving.begin[face + 1]; ++i) {
      sorted.push_back(arcs[leaving.items[i]]);
      const std::uint32_t next = above(sorted.back());
      if (--waiting[next] == 0) ready.push_back(next);
    }
  }
  if (sorted.size() != arcs.size()) throw std::logic_error("arcs of a chart lie above each other in a circle");
  chart.arcs = std::move(sorted);
}

// The walls through the nodes of both colours, sorted. Abscissae in binary64 propose an order, and
// the predicate decides: it sorts each group of walls that lie close together, then checks all
// neighbours. If it finds any in the wrong order, it sorts all walls.

struct Candidate {
  double x;
  Wall wall;
};

std::vector<Candidate> candidates(const Charts& charts) {
  std::vector<Candidate> result;
  const Vec3<double> v = kernels::image(charts.frame.v), z = kernels::image(charts.frame.z), right = cross(v, z);
  for (const gaussian::Colour c : gaussian::both_colours) {
    const ColourChart& chart = charts.of[c];
    for (const gaussian::NodeId i : chart.wall_of.ids()) {
      if (chart.wall_of[i].is_none()) continue;
      const Vec3<double> n = kernels::image(chart.node(i));
      const double x = dot(n, right) / dot(n, z);
      result.push_back({std::isnan(x) ? 0 : x, {c, i}});
    }
  }
  return result;
}

bool close_together(double x, double y) { return !(std::abs(y - x) > 0x1p-40 * (1 + std::abs(x))); }

// Fills in the walls, and in wall_of their ids, for the nodes whose wall_of is not none. Sorts
// exactly, in O(N log N); where abscissae are well apart, with one predicate a wall.
void raise_walls(const kernels::PerturbedKernel& kernel, Charts& charts) {
  const auto left_of = [&](const Candidate& s, const Candidate& t) {
    return s.wall != t.wall &&
           kernel.x_order(charts.node(s.wall), charts.node(t.wall), charts.frame.v) == kernels::Sign::positive;
  };
  std::vector<Candidate> all = candidates(charts);
  std::ranges::sort(all, {}, &Candidate::x);
  for (auto first = all.begin(); first != all.end();) {
    auto last = first + 1;
    while (last != all.end() && close_together(std::prev(last)->x, last->x)) ++last;
    std::sort(first, last, left_of);
    first = last;
  }
  if (!std::ranges::is_sorted(all, left_of)) std::ranges::sort(all, left_of);
  charts.walls.reserve(all.size());
  for (const Candidate& c : all) {
    charts.of[c.wall.colour].wall_of[c.wall.node] = WallId(static_cast<std::uint32_t>(charts.walls.size()));
    charts.walls.push_back(c.wall);
  }
}

// The places of one colour's nodes, and of its arcs' ends, in the other colour's diagram.

// The arcs of one colour that cross the sweep line, by id, which is from bottom to top. A balanced
// tree in heap order; each node holds the greatest id in its subtree.
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
    for (std::size_t i = leaves_ + arc.value; i > 0 && (highest_[i].is_none() || highest_[i] < arc); i /= 2)
      highest_[i] = arc;
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
    return node_above_arc(kernel_, charts_, gaussian::other(colour_), node, colour_, chart_.arcs[arc]) ==
           kernels::Sign::positive;
  }

  // Of the arcs on the sweep line the highest that passes below the node. Asks a predicate only
  // where both subtrees hold arcs.
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
    for (const ChartArcId i : chart.arcs.ids())
      ends(chart.arcs[i], [&](gaussian::NodeId node) { arcs_[--begin_[node]] = i; });
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

// The arcs of each colour that reach to one infinity are sorted there by id. Merges both colours by
// height.
void locate_at_infinity(const kernels::PerturbedKernel& kernel, Charts& charts, const Ends& side) {
  const bool at_left = side.node == left_ends.node;
  gaussian::PerColour<std::vector<ChartArcId>> ends;
  for (const gaussian::Colour c : gaussian::both_colours) {
    const kernels::IdVector<ChartArcId, ChartArc>& arcs = charts.of[c].arcs;
    std::ranges::copy_if(arcs.ids(), std::back_inserter(ends[c]),
                         [&](ChartArcId i) { return arcs[i].*side.node == at_infinity; });
  }
  gaussian::PerColour<std::size_t> next{};
  gaussian::PerColour<ChartArcId> height{};  // the id after the last arc that was taken
  const auto arc = [&](gaussian::Colour c) -> ChartArc& { return charts.of[c].arcs[ends[c][next[c]]]; };
  while (next.a < ends.a.size() || next.b < ends.b.size()) {
    gaussian::Colour lower = next.a < ends.a.size() ? gaussian::Colour::a : gaussian::Colour::b;
    if (next.a < ends.a.size() && next.b < ends.b.size()) {
      const bool a_above = above_far_left(kernel, charts, gaussian::Colour::a, arc(gaussian::Colour::a),
                                          gaussian::Colour::b, arc(gaussian::Colour::b)) == kernels::Sign::positive;
      lower = a_above == at_left ? gaussian::Colour::b : gaussian::Colour::a;
    }
    arc(lower).*side.height = height[gaussian::other(lower)];
    height[lower] = ends[lower][next[lower]++].next();
  }
}

// Fills in place_of for the nodes of a colour, by a plane sweep over all walls and the other
// colour's arcs, which must be in height order. A wall belongs to one node of one colour: there
// arcs leave the sweep line and enter it, or the node is located. O((m + n) log(m + n)) steps; each
// node asks at most about as many predicates as the logarithm of the arcs over its abscissa.
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

// Fills in the heights of all arcs' ends: from the places of the nodes, and at infinity by merging
// both colours' lists. Linear.
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

}  // namespace

Charts make_charts(kernels::Context& context, const gaussian::GaussianDiagram& minus_a,
                   const gaussian::GaussianDiagram& b, const Frame& frame, const kernels::Perturbation& perturbation) {
  Charts charts{perturbation, frame, {}, {}};
  charts.of.a.diagram = &minus_a;
  charts.of.b.diagram = &b;
  const kernels::PerturbedKernel kernel(charts.perturbation, context.counters.predicates);
  for (const gaussian::Colour c : gaussian::both_colours) {
    ColourChart& chart = charts.of[c];
    find_nodes(kernel, charts, chart);
    find_arcs(kernel, charts, chart);
    sort_by_height(chart);
    draw_circles(chart);
  }
  raise_walls(kernel, charts);
  for (const gaussian::Colour c : gaussian::both_colours) locate_nodes(kernel, charts, c);
  locate_ends(kernel, charts);
  return charts;
}

namespace {

// At each face, the arcs below it come before those above it.
bool in_height_order(const ColourChart& chart) {
  kernels::IdVector<gaussian::VertexId, ChartArcId> after_below;  // for each face, the id after the last arc below it
  for (const ChartArcId i : chart.arcs.ids()) {
    const gaussian::VertexId face = chart.vertex_above(chart.arcs[i]);
    if (face.value >= after_below.size()) after_below.resize(face.value + 1);
    after_below[face] = i.next();
  }
  return std::ranges::all_of(chart.arcs.ids(), [&](ChartArcId i) {
    const gaussian::VertexId face = chart.vertex_below(chart.arcs[i]);
    return face.value >= after_below.size() || after_below[face] <= i;
  });
}

}  // namespace

kernels::Report validate(const Charts& charts) {
  kernels::Report report;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  for (std::uint32_t i = 1; i < charts.walls.size(); ++i) {
    const kernels::Direction &left = charts.node(charts.walls[WallId(i - 1)]),
                             &right = charts.node(charts.walls[WallId(i)]);
    report.expect(kernel.x_order(left, right, charts.frame.v) == kernels::Sign::positive,
                  "wall " + std::to_string(i) + " is not right of the one before");
  }
  for (const gaussian::Colour c : gaussian::both_colours) {
    const ColourChart& chart = charts.of[c];
    const auto here = [&](gaussian::NodeId node) {
      return kernel.side_of_equator(chart.node(node), charts.frame.z) == kernels::Sign::positive;
    };
    const auto is_end = [&](gaussian::NodeId end, gaussian::NodeId node) {
      return end == at_infinity ? node.is_none() || !here(node) : end == node && here(node);
    };
    report.expect(in_height_order(chart), "the arcs are not in height order");
    for (const ChartArc& part : chart.arcs) {
      const std::string name = "arc " + std::to_string(part.arc.value) + ": ";
      const gaussian::Arc& arc = chart.diagram->arcs[part.arc];
      report.expect((kernel.side_of_arc(charts.frame.v, arc.circle) == kernels::Sign::positive) != part.flipped,
                    name + "flipped against its circle");
      report.expect(is_end(part.left, part.flipped ? arc.to : arc.from), name + "left end");
      report.expect(is_end(part.right, part.flipped ? arc.from : arc.to), name + "right end");
      if (part.left != at_infinity && part.right != at_infinity) {
        report.expect(chart.wall_of[part.left] < chart.wall_of[part.right], name + "does not run from left to right");
      }
    }
  }
  return report;
}

}  // namespace fathom::chart
