// SPDX-License-Identifier: GPL-3.0-or-later
// The sum P for pictures, or the polytope Q inside it. A facet of P is the sum of two convex
// polygons in parallel planes: their edges, merged by angle. First that sum, then all facets, then
// the selection that is shown.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "kernels/filters/support.hpp"
#include "kernels/nearest.hpp"
#include "kernels/number/rational.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using gaussian::ArcId;
using polytope::FacetId;
using polytope::VertexId;

/// Angles around n, counter-clockwise from a direction r in its plane.
struct Turn {
  Vector n, r, w;  // w = n x r is a right angle from r

  /// Returns whether the angle of d is at least pi.
  [[nodiscard]] bool is_late(const Vector& d) const {
    const int side = sgn(dot(w, d));
    return side < 0 || (side == 0 && sgn(dot(r, d)) < 0);
  }
  /// Compares angles. Negative: that of d is smaller. Zero: they are equal.
  [[nodiscard]] int compare(const Vector& d, const Vector& e) const {
    const bool late = is_late(d);
    if (late != is_late(e)) return late ? 1 : -1;
    return -sgn(det(n, d, e));
  }
};

/// One of the two polygons: that of B unchanged, that of A reflected. Its edges are visited by
/// angle.
class Side {
 public:
  Side(const polytope::Polytope& body, bool reflected, std::vector<VertexId> cycle)
      : body_(&body), reflected_(reflected), cycle_(std::move(cycle)) {
    if (reflected_) std::ranges::reverse(cycle_);  // a facet of A has the outward normal -n
  }

  [[nodiscard]] Vector point(std::size_t i) const {
    const Vector& p = body_->vertices[cycle_[i % cycle_.size()]];
    return reflected_ ? -p : p;
  }
  [[nodiscard]] bool has_edges() const { return cycle_.size() > 1; }
  [[nodiscard]] Vector edge(std::size_t i) const { return point(i + 1) - point(i); }
  /// Starts at the corner after which the angles of edges begin at 0.
  void start(const Turn& turn) {
    const auto lower = [&](std::size_t i, std::size_t j) {
      const Vector d = point(i) - point(j);
      const int side = sgn(dot(turn.w, d));
      return side < 0 || (side == 0 && sgn(dot(turn.r, d)) < 0);
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < cycle_.size(); ++i)
      if (lower(i, first)) first = i;
    std::rotate(cycle_.begin(), cycle_.begin() + static_cast<std::ptrdiff_t>(first), cycle_.end());
  }
  [[nodiscard]] bool done() const { return taken_ == (has_edges() ? cycle_.size() : 0); }
  [[nodiscard]] Vector next_edge() const { return edge(taken_); }
  void take() { ++taken_; }
  [[nodiscard]] VertexId corner() const { return cycle_[taken_ % cycle_.size()]; }

 private:
  const polytope::Polytope* body_;
  bool reflected_;
  std::vector<VertexId> cycle_;
  std::size_t taken_ = 0;
};

/// Returns the corners of the facet of P with this normal, given the faces of A in direction
/// -normal and of B in direction normal: each a vertex, the ends of an edge, or the cycle of a
/// facet, counter-clockwise from outside its body.
std::vector<SumCorner> sum_cycle(const depth::Hulls& hulls, const Vector& normal, std::vector<VertexId> of_a,
                                 std::vector<VertexId> of_b) {
  Side a(hulls.a, true, std::move(of_a)), b(hulls.b, false, std::move(of_b));
  const Vector r = a.has_edges() ? a.edge(0) : b.edge(0);
  const Turn turn{normal, r, cross(normal, r)};
  a.start(turn);
  b.start(turn);
  std::vector<SumCorner> corners;
  while (!a.done() || !b.done()) {
    corners.push_back({a.corner(), b.corner()});
    const int order = a.done() ? 1 : b.done() ? -1 : turn.compare(a.next_edge(), b.next_edge());
    if (order <= 0) a.take();
    if (order >= 0) b.take();
  }
  return corners;
}

constexpr std::size_t crossings_per_facet = 20;  // coplanar facets merge; more crossings would take too long

/// The features in a direction: facets of the bodies, or edges whose arcs cross there.
struct Found {
  gaussian::PerColour<std::optional<FacetId>> facets;
  gaussian::PerColour<std::optional<ArcId>> edges;
  Indices pairs;
};
using FoundByNormal = std::map<Vector, Found, LexicographicOrder>;

/// Returns whether n, a multiple of a direction on the circle of the arc, lies on the closed arc.
bool is_on(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& n) {
  if (diagram.rank < 2) return true;
  const Vector circle = arc.circle.exact();
  return sgn(det(circle, diagram.nodes[arc.from].exact(), n)) >= 0 &&
         sgn(det(circle, n, diagram.nodes[arc.to].exact())) >= 0;
}

class Directions {
 public:
  explicit Directions(const depth::ExactStages& exact) : exact_(exact) {}

  void add_nodes() {
    for (const FacetId i : exact_.hulls.a.facets.ids()) found_[-exact_.hulls.a.facets[i].normal].facets.a = i;
    for (const FacetId i : exact_.hulls.b.facets.ids()) found_[exact_.hulls.b.facets[i].normal].facets.b = i;
  }
  /// Stops as soon as there are more than `most` directions.
  void add_crossings(std::size_t most) {
    Index number = 0;
    for (std::size_t h = 0; h < exact_.subsets.size(); ++h) {
      const chart::Charts& charts = exact_.charts[h];
      for (std::size_t i = 0; i < exact_.subsets[h].size() && found_.size() <= most; ++i, ++number) {
        const canonical::CanonicalPair pair = exact_.subsets[h][i];
        for (const chart::ChartArcOfA a : pair.a) {
          if (found_.size() > most) return;
          for (const chart::ChartArcOfB b : pair.b)
            add(charts.of.a.arcs[chart::ChartArcId(a.value)].arc, charts.of.b.arcs[chart::ChartArcId(b.value)].arc,
                number);
        }
      }
    }
  }
  [[nodiscard]] const FoundByNormal& found() const { return found_; }

 private:
  void add(ArcId e, ArcId f, Index pair) {
    const gaussian::GaussianDiagram &a = exact_.diagrams.a, &b = exact_.diagrams.b;
    const Vector line = primitive(cross(a.arcs[e].circle.exact(), b.arcs[f].circle.exact()));
    if (is_zero(line)) return;  // parallel edges cross only after perturbation
    for (const Vector& n : {line, -line}) {
      if (!is_on(a, a.arcs[e], n) || !is_on(b, b.arcs[f], n)) continue;
      Found& here = found_[n];
      here.edges.a = e;
      here.edges.b = f;
      if (here.pairs.empty() || here.pairs.back() != pair) here.pairs.push_back(pair);
    }
  }

  const depth::ExactStages& exact_;
  FoundByNormal found_;
};

/// The cycles of both faces in a direction.
class Faces {
 public:
  explicit Faces(const depth::Hulls& hulls)
      : hulls_(hulls),
        cloud_a_(std::vector<Vector>(hulls.a.vertices.begin(), hulls.a.vertices.end())),
        cloud_b_(std::vector<Vector>(hulls.b.vertices.begin(), hulls.b.vertices.end())) {}

  [[nodiscard]] std::vector<VertexId> of_a(const Vector& n, const Found& found) const {
    return of(hulls_.a, cloud_a_, -n, found.facets.a, found.edges.a);
  }
  [[nodiscard]] std::vector<VertexId> of_b(const Vector& n, const Found& found) const {
    return of(hulls_.b, cloud_b_, n, found.facets.b, found.edges.b);
  }

 private:
  static std::vector<VertexId> of(const polytope::Polytope& body, const kernels::PointCloud& cloud, const Vector& u,
                                  const std::optional<FacetId>& facet, const std::optional<ArcId>& edge) {
    if (facet) {
      const polytope::Facet& face = body.facets[*facet];
      return {body.corners.begin() + face.begin, body.corners.begin() + face.end};
    }
    if (edge) return {body.edges[edge->value].from, body.edges[edge->value].to};
    std::vector<VertexId> result;
    for (const std::uint32_t i : kernels::extreme_points(cloud, u)) result.emplace_back(i);
    return result;
  }

  const depth::Hulls& hulls_;
  kernels::PointCloud cloud_a_, cloud_b_;
};

std::vector<VertexId> sorted(std::vector<VertexId> cycle) {
  std::ranges::sort(cycle);
  return cycle;
}

constexpr std::size_t most_facets = 20'000;  // a picture of more is a ball

using Points = std::vector<std::uint32_t>;

/// Returns (height / (|normal| denominator))^2.
mpq_class squared_distance(const mpz_class& height, const Vector& normal, const mpz_class& denominator) {
  return kernels::ratio(height * height, dot(normal, normal) * denominator * denominator);
}

SumFacetKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b) {
  if (corners_of_b == 1) return SumFacetKind::facet_of_a;
  if (corners_of_a == 1) return SumFacetKind::facet_of_b;
  return corners_of_a == 2 && corners_of_b == 2 ? SumFacetKind::edges : SumFacetKind::merged;
}

/// Sorts by distance, ties by normals; marks the nearest facets as optimal.
void rank(std::vector<StagedFacet>& facets) {
  std::ranges::stable_sort(facets, {}, &StagedFacet::squared);
  for (StagedFacet& facet : facets) facet.optimal = facet.squared == facets.front().squared;
}

Points input_points(const polytope::Polytope& body, const std::vector<polytope::VertexId>& face) {
  Points result;
  for (const polytope::VertexId v : face) result.push_back(body.input_ids[v]);
  return result;
}

StagedSum sum_of(const StagesSource& subject, const std::vector<ExactSumFacet>& exact) {
  const depth::Hulls& hulls = subject.exact.hulls;
  StagedSum sum;
  sum.kind = SumKind::p;
  std::map<SumCorner, Index> indices;
  for (const ExactSumFacet& facet : exact) {
    StagedFacet staged;
    for (const SumCorner& corner : facet.corners) {
      const auto [place, is_new] = indices.emplace(corner, static_cast<Index>(sum.vertices.size()));
      if (is_new)
        sum.vertices.push_back(subject.placing.vector(hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a]));
      staged.vertices.push_back(place->second);
    }
    staged.normal = unit(facet.normal);
    staged.squared = squared_distance(facet.height, facet.normal, subject.pair.denominator);
    staged.distance = subject.placing.length(staged.squared);
    staged.kind = kind_of(facet.a.size(), facet.b.size());
    staged.a = input_points(hulls.a, facet.a);
    staged.b = input_points(hulls.b, facet.b);
    staged.pairs = facet.pairs;
    sum.facets.push_back(std::move(staged));
  }
  rank(sum.facets);
  return sum;
}

/// Returns the facet of Q with these corners.
StagedFacet facet_of_q(const StagesSource& subject, const InnerPolytope& q, const std::vector<std::uint32_t>& corners) {
  const auto difference = [&](std::size_t i) {
    const auto& [a, b] = q.vertices[corners[i]];
    return subject.pair.b[b] - subject.pair.a[a];
  };
  const Vector normal = primitive(cross(difference(1) - difference(0), difference(2) - difference(0)));
  std::set<std::uint32_t> a, b;
  for (const std::uint32_t corner : corners) {
    a.insert(q.vertices[corner].first);
    b.insert(q.vertices[corner].second);
  }
  StagedFacet facet;
  facet.vertices = corners;
  facet.normal = unit(normal);
  facet.squared = squared_distance(dot(normal, difference(0)), normal, subject.pair.denominator);
  facet.distance = subject.placing.length(facet.squared);
  facet.kind = kind_of(a.size(), b.size());
  facet.a.assign(a.begin(), a.end());
  facet.b.assign(b.begin(), b.end());
  return facet;
}

/// Passes the reports of a separate computation on to the context of the caller.
class Relay : public Monitor {
 public:
  explicit Relay(kernels::Context& context) : context_(context) {}
  void report(std::string_view stage, double share) override {
    try {
      context_.report(stage, share);
    } catch (const Interrupted&) {
      stopped_ = true;
    }
  }
  [[nodiscard]] bool stopped() override { return stopped_; }

 private:
  kernels::Context& context_;
  bool stopped_ = false;
};

/// Returns the polytope of the certificate, if it is found soon and is not too large; otherwise a
/// sum of kind none.
StagedSum inner_sum(const StagesSource& subject) {
  Relay relay(subject.context);
  const Depth certified = penetration_depth(subject.a, subject.b, {.monitor = &relay});
  const Penetration* const penetration = certified.penetration();
  if (penetration == nullptr || !penetration->inner || penetration->inner->facets.size() > most_facets) return {};
  const InnerPolytope& q = *penetration->inner;
  StagedSum sum;
  sum.kind = SumKind::q;
  for (const auto& [a, b] : q.vertices)
    sum.vertices.push_back(subject.placing.vector(subject.pair.b[b] - subject.pair.a[a]));
  for (const std::vector<std::uint32_t>& corners : q.facets) sum.facets.push_back(facet_of_q(subject, q, corners));
  rank(sum.facets);
  return sum;
}

}  // namespace

std::optional<std::vector<ExactSumFacet>> sum_facets(const depth::ExactStages& exact, std::size_t most) {
  if (exact.subsets[0].sums().product + exact.subsets[1].sums().product > most * crossings_per_facet)
    return std::nullopt;
  Directions directions(exact);
  directions.add_nodes();
  directions.add_crossings(most);
  if (directions.found().size() > most) return std::nullopt;
  const Faces faces(exact.hulls);
  std::vector<ExactSumFacet> result;
  result.reserve(directions.found().size());
  for (const auto& [n, found] : directions.found()) {
    std::vector<VertexId> a = faces.of_a(n, found), b = faces.of_b(n, found);
    std::vector<SumCorner> corners = sum_cycle(exact.hulls, n, a, b);
    const mpz_class height =
        dot(n, exact.hulls.b.vertices[corners.front().b] - exact.hulls.a.vertices[corners.front().a]);
    result.push_back({n, height, std::move(corners), sorted(std::move(a)), sorted(std::move(b)), found.pairs});
  }
  return result;
}

void add_sum(const StagesSource& subject, Stages& stages) {
  if (stages.status != Status::penetrating) {
    stages.left_out.emplace_back("P is not drawn: O is not inside it, so no facet of it is the way out.");
    return;
  }
  if (const std::optional<std::vector<ExactSumFacet>> facets = sum_facets(subject.exact, most_facets)) {
    stages.sum = sum_of(subject, *facets);
    return;
  }
  stages.sum = inner_sum(subject);
  const std::string many = fmt::format("P has too many facets to be drawn, more than {}", most_facets);
  stages.left_out.push_back(many + (stages.sum.kind == SumKind::q
                                        ? ": in its place stands Q, the polytope inside P that proves the depth."
                                        : ", and no smaller polytope that proves the depth was found."));
}

}  // namespace fathom::stages
