// SPDX-License-Identifier: GPL-3.0-or-later
// Stages of polytopes, part by part, and the public function for all bodies. First places for
// pixels: input coordinates, moved and scaled by a power of two only if binary64 needs it.
#include "view/stages/stages.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/solve/depth.hpp"
#include "view/picture/view.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using picture::largest;

// If a body is farther from O than this many extents, its position takes up the digits of binary64,
// so places are relative to the body.
constexpr int near_origin = 4;

// Beyond this power of two, squares and products of places would overflow or underflow binary64.
constexpr long comfortable_exponent = 300;

/// Returns a length, given by its square, in the unit of places.
double scaled_root(const mpq_class& squared, const StagedScale& scale) {
  return root_binary64(kernels::times_power_of_two(squared, 2 * scale.exponent));
}

mpq_class extent_of(const polytope::PlacedPair& pair) {
  mpz_class most;
  for (const kernels::PointCloud* cloud : {&pair.a, &pair.b}) {
    for (const Vector& p : cloud->points()) {
      for (const mpz_class* c : {&p.x, &p.y, &p.z}) {
        if (mpz_cmpabs(c->get_mpz_t(), most.get_mpz_t()) > 0) most = abs(*c);
      }
    }
  }
  mpq_class extent(most, pair.denominator);
  extent.canonicalize();
  return extent;
}

// Returns the component of a direction over 2^most, where `most` is the largest number of bits of
// its components.
double component(const mpz_class& c, long most) {
  long exponent = 0;
  const double fraction = mpz_get_d_2exp(&exponent, c.get_mpz_t());
  return std::ldexp(fraction, static_cast<int>(std::max(exponent - most, -2000L)));
}

// ---- the hulls with their Gaussian diagrams, and the answer ----

// The most optima that are listed if there are very many ties.
constexpr std::size_t most_listed_optima = 1000;

std::optional<Index> index_of(gaussian::NodeId node) {
  return node.is_none() ? std::nullopt : std::optional(node.value);
}

void add_diagram(const gaussian::GaussianDiagram& diagram, StagedBody& body) {
  for (const kernels::Direction& node : diagram.nodes) body.nodes.push_back(unit(node.exact()));
  for (const gaussian::Arc& arc : diagram.arcs) {
    body.arcs.push_back({index_of(arc.from), index_of(arc.to)});
    if (diagram.rank < 3) body.circles.push_back(unit(arc.circle.exact()));
  }
}

StagedBody body_of(const polytope::Polytope& hull, const Placing& placing) {
  StagedBody body;
  body.rank = hull.rank;
  body.ids.assign(hull.input_ids.begin(), hull.input_ids.end());
  for (const Vector& v : hull.vertices) body.vertices.push_back(placing.point(v));
  for (const polytope::Edge& edge : hull.edges) body.edges.push_back({edge.from.value, edge.to.value});
  for (const polytope::Facet& facet : hull.facets) {
    Indices& corners = body.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.corners[i].value);
  }
  return body;
}

void tell_of_lost_places(std::string_view name, const StagedBody& body, Stages& stages) {
  const std::set<Place> distinct(body.vertices.begin(), body.vertices.end());
  if (distinct.size() < body.vertices.size())
    stages.left_out.push_back(
        std::string("Vertices of ") + std::string(name) +
        " fall together in binary64: beside the other body, or along one axis, they are too near each other.");
}

void add_bodies(const StagesSource& subject, Stages& stages) {
  stages.scale = subject.placing.scale();
  stages.a = body_of(subject.exact.hulls.a, subject.placing);
  stages.b = body_of(subject.exact.hulls.b, subject.placing);
  add_diagram(subject.exact.diagrams.a, stages.a);
  add_diagram(subject.exact.diagrams.b, stages.b);
  tell_of_lost_places("A", stages.a, stages);
  tell_of_lost_places("B", stages.b, stages);
}

void add_contact(const Depth& depth, const Placing& placing, Stages& stages) {
  stages.status = depth.status();
  stages.contact.direction = unit(depth.direction());
  if (const Distance* const distance = depth.distance())
    stages.contact.translation = times(-placing.length(distance->squared), stages.contact.direction);
  if (depth.contact()) stages.contact.features = *depth.contact();
  if (!depth.penetration()) return;
  stages.squared = depth.squared();
  if (const double value = root_binary64(*stages.squared); std::isfinite(value) && value > 0) stages.depth = value;
  const double length = placing.length(*stages.squared);
  for (const Optimum& optimum : depth.optima()) {
    if (stages.contact.optima.size() == most_listed_optima) break;
    const Place direction = unit(optimum.direction);
    stages.contact.optima.push_back({direction, times(length, direction), optimum.contact});
  }
  stages.contact.translation = stages.contact.optima.front().translation;
  if (depth.optima_count() > most_listed_optima)
    stages.left_out.push_back("The first " + std::to_string(most_listed_optima) + " of " +
                              std::to_string(depth.optima_count()) + " optima are listed.");
}

// ---- both hemispheres as charts ----

// The projection is longitude and latitude about v, in which walls are vertical and the hemisphere
// fits a square.

std::optional<Index> end_of(gaussian::NodeId node) {
  return node == chart::at_infinity ? std::nullopt : std::optional(node.value);
}

StagedDiagram diagram_in(const chart::ColourChart& chart, const std::vector<Place>& nodes, const Place& v,
                         const Place& z) {
  StagedDiagram result;
  for (const chart::ChartArc& arc : chart.arcs)
    result.arcs.push_back({arc.arc.value, end_of(arc.left), end_of(arc.right)});
  const Place right = cross(v, z);
  for (const gaussian::NodeId i : chart.wall_of.ids()) {
    if (chart.wall_of[i].is_none()) continue;
    const Place& n = nodes[i.value];
    // asin would lose half of the digits near v. Adding 0.0 turns -0.0 into 0.0.
    const double along = dot(n, right) + 0.0, ahead = dot(n, z) + 0.0;
    result.nodes.push_back({i.value, std::atan2(along, ahead), std::atan2(dot(n, v), std::hypot(along, ahead))});
  }
  return result;
}

void add_charts(const StagesSource& subject, Stages& stages) {
  for (const chart::Hemisphere hemisphere : chart::both_hemispheres) {
    const chart::Charts& charts = subject.exact.charts[stages.charts.size()];
    StagedChart staged;
    staged.upper = hemisphere == chart::Hemisphere::upper;
    staged.v = unit(charts.frame.v.exact());
    staged.z = unit(charts.frame.z.exact());
    staged.a = diagram_in(charts.of.a, stages.a.nodes, staged.v, staged.z);
    staged.b = diagram_in(charts.of.b, stages.b.nodes, staged.v, staged.z);
    for (const chart::Wall& wall : charts.walls)
      staged.walls.push_back({wall.colour == gaussian::Colour::a, wall.node.value});
    stages.charts.push_back(std::move(staged));
  }
}

// ---- counts of the exact method beside the paper's bounds, without constants ----

/// The numbers of edges m and n.
struct Sizes {
  double m, n;
  [[nodiscard]] double both() const { return m + n; }
  [[nodiscard]] double log() const { return std::log2(std::max(2.0, both())); }
};

void add_bounds(const StagesSource& subject, Stages& stages) {
  const depth::Hulls& hulls = subject.exact.hulls;
  const Sizes size{static_cast<double>(hulls.a.edges.size()), static_cast<double>(hulls.b.edges.size())};
  const std::uint64_t vertices = hulls.a.vertices.size() + hulls.b.vertices.size(),
                      edges = hulls.a.edges.size() + hulls.b.edges.size(),
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
  const auto add = [&](std::string_view stage, std::string_view what, std::uint64_t count, std::string_view bound,
                       double value, std::string_view source) {
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
  add("canonical subsets", "crossings: sum |A_i| |B_i|", crossings, "m n", size.m * size.n,
      "each crossing once: (C2), (C3)");
  if (stages.status == Status::penetrating)
    add("closest lines", "pairs of lines looked at", stages.counters.pairs_evaluated, "(m n)^(3/4) + m + n",
        std::pow(size.m * size.n, 0.75) + size.both(),
        "section 2.3, expected, up to eps in the exponents; not proved for cuttings in order");
}

// ---- all of it ----

/// Measures the time of each stage of a run: a monitor that reads the clock when a stage begins,
/// and passes everything on.
class StageTimes : public Monitor {
 public:
  /// Passes every call on to `next`, which may be null.
  explicit StageTimes(Monitor* next) : next_(next) {}

  void report(std::string_view stage, double share) override {
    if (running_.empty() || running_.back().first != stage) {
      end();
      running_.emplace_back(stage, 0);
      begin_ = Clock::now();
    }
    if (next_) next_->report(stage, share);
  }
  [[nodiscard]] bool stopped() override { return next_ && next_->stopped(); }

  /// Ends the current stage.
  void end() {
    if (!running_.empty() && begin_ != Clock::time_point{})
      running_.back().second = std::chrono::duration<double>(Clock::now() - begin_).count();
    begin_ = {};
  }
  /// Returns the times in the order of the stages. Before the first stage, no time is measured.
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& seconds() const { return running_; }

 private:
  using Clock = std::chrono::steady_clock;

  Monitor* next_;
  std::vector<std::pair<std::string, double>> running_;
  Clock::time_point begin_{};
};

// Returns the answer of penetration_depth. If a common lattice would be too fine, penetration_depth
// uses another method, and may return another of several right directions of touching bodies.
Depth answer_of(const StagesSource& subject, bool slim) {
  if (slim) return subject.exact.depth;
  kernels::Context context = subject.context.worker();
  return solve::placed_depth(context, subject.a.points.exact(), subject.b.points.exact(), {.method = Method::exact})
      .depth;
}

void fill(const StagesSource& subject, const Depth& depth, Stages& stages) {
  add_bodies(subject, stages);
  add_contact(depth, subject.placing, stages);
  add_charts(subject, stages);
  add_pairs(subject, stages);
  add_winner(subject, depth, stages);
  add_cutting(subject, stages);
  stages.counters = subject.exact.depth.counters;
  if (!depth.penetration())
    stages.left_out.emplace_back(
        "The bodies do not penetrate: the exact method ends before the search for closest lines, so pairs have no "
        "closest lines.");
  add_sum(subject, stages);
  add_coincidences(subject, stages);
  add_bounds(subject, stages);
}

}  // namespace

StagedScale scale_of(const Point& origin, const mpq_class& extent) {
  StagedScale scale;
  const mpq_class distance = largest(origin);
  if (distance > near_origin * extent) scale.center = origin;
  const mpq_class& size = distance > near_origin * extent ? extent : std::max(extent, distance);
  if (size == 0) return scale;
  const long exponent = kernels::binary_order(size);
  if (std::abs(exponent) > comfortable_exponent) scale.exponent = -exponent;
  return scale;
}

double scaled(const mpq_class& value, const StagedScale& scale) {
  return round_binary64(kernels::times_power_of_two(value, scale.exponent)) + 0.0;
}

Placing::Placing(const polytope::PlacedPair& pair) : scale_(scale_of(pair.origin, extent_of(pair))), pair_(&pair) {}

Place Placing::point(const Vector& lattice) const { return point(pair_->position(lattice)); }

Place Placing::vector(const Vector& lattice) const {
  return vector(
      Point{{lattice.x, pair_->denominator}, {lattice.y, pair_->denominator}, {lattice.z, pair_->denominator}});
}

Place Placing::point(const Point& p) const { return vector(p - scale_.center); }

Place Placing::vector(const Point& v) const { return {scaled(v.x, scale_), scaled(v.y, scale_), scaled(v.z, scale_)}; }

double Placing::length(const mpq_class& squared) const { return scaled_root(squared, scale_); }

Place unit(const Vector& direction) {
  const long most = kernels::bit_length(direction);
  const Place v{component(direction.x, most), component(direction.y, most), component(direction.z, most)};
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length + 0.0, v[1] / length + 0.0, v[2] / length + 0.0};
}

Stages stages_in_plane(const Body& a, const Body& b, const Answer& answer) {
  const kernels::DefaultFloatEnvironment environment;
  Stages stages;
  stages.left_out.emplace_back(only_what_happens);
  if (const SignedDepth* const shapes = std::get_if<SignedDepth>(&answer.found)) {
    add_outlines(a, b, *shapes, 2, stages);
    return stages;
  }
  const polytope::PlacedPair pair = polytope::place(a.points.exact(), b.points.exact());
  const Placing placing(pair);
  stages.scale = placing.scale();
  stages.a = body_of(polytope::convex_hull(pair.a.points()), placing);
  stages.b = body_of(polytope::convex_hull(pair.b.points()), placing);
  add_contact(std::get<Depth>(answer.found), placing, stages);
  return stages;
}

Stages stages_of(const Body& a, const Body& b, const StageOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  if (a.shape || b.shape) return stages_of_shapes(a, b, options);
  StageTimes times(options.monitor);
  kernels::Context context(&times);
  const std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(a.points.exact(), b.points.exact());
  const polytope::PlacedPair pair = slim ? *slim : polytope::place(a.points.exact(), b.points.exact());
  const std::unique_ptr<depth::ExactStages> exact = depth::exact_stages(context, pair);
  times.end();
  Stages stages;
  add_decided(context.counters.predicates, stages);
  const Placing placing(pair);
  const StagesSource subject{a, b, pair, *exact, placing, context, options};
  if (options.times) stages.seconds = times.seconds();
  fill(subject, answer_of(subject, slim.has_value()), stages);
  return stages;
}

}  // namespace fathom::stages
