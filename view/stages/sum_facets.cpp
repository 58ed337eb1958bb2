// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernels/filters/support.hpp"
#include "kernels/nearest.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using gaussian::ArcId;
using gaussian::Colour;
using polytope::FacetId;
using polytope::VertexId;

constexpr std::size_t crossings_per_facet = 20;  // coplanar facets merge; more are not worth the work

/// What lies in a direction: facets of the bodies, or edges that cross there.
struct Found {
  gaussian::PerColour<std::optional<FacetId>> facets;
  gaussian::PerColour<std::optional<ArcId>> edges;
  Indices pairs;
};
using FoundByNormal = std::map<Vector, Found, kernels::NearestPlanes::LexicographicOrder>;

/// Whether n, a multiple of a direction on the circle of the arc, lies on the closed arc.
bool is_on(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& n) {
  if (diagram.rank < 2) return true;
  const Vector circle = arc.circle.exact();
  return sgn(det(circle, diagram.nodes[arc.from].exact(), n)) >= 0 && sgn(det(circle, n, diagram.nodes[arc.to].exact())) >= 0;
}

class Directions {
 public:
  explicit Directions(const depth::ExactStages& exact) : exact_(exact) {}

  void add_nodes() {
    for (const FacetId i : exact_.hulls.a.facets.ids()) found_[-exact_.hulls.a.facets[i].normal].facets.a = i;
    for (const FacetId i : exact_.hulls.b.facets.ids()) found_[exact_.hulls.b.facets[i].normal].facets.b = i;
  }
  /// Stops as soon as there are too many directions.
  void add_crossings(std::size_t most) {
    Index number = 0;
    for (std::size_t h = 0; h < exact_.subsets.size(); ++h) {
      const chart::Charts& charts = exact_.charts[h];
      for (std::size_t i = 0; i < exact_.subsets[h].size() && found_.size() <= most; ++i, ++number) {
        const canonical::CanonicalPair pair = exact_.subsets[h][i];
        for (const chart::ChartArcOfA a : pair.a) {
          if (found_.size() > most) return;
          for (const chart::ChartArcOfB b : pair.b)
            add(charts.of.a.arcs[chart::ChartArcId(a.value)].arc, charts.of.b.arcs[chart::ChartArcId(b.value)].arc, number);
        }
      }
    }
  }
  [[nodiscard]] const FoundByNormal& found() const { return found_; }

 private:
  void add(ArcId e, ArcId f, Index pair) {
    const gaussian::GaussianDiagram &a = exact_.diagrams.a, &b = exact_.diagrams.b;
    const Vector line = primitive(cross(a.arcs[e].circle.exact(), b.arcs[f].circle.exact()));
    if (is_zero(line)) return;  // parallel edges cross only once they are perturbed
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

}  // namespace

std::optional<std::vector<ExactSumFacet>> sum_facets(const depth::ExactStages& exact, std::size_t most) {
  if (exact.subsets[0].sums().product + exact.subsets[1].sums().product > most * crossings_per_facet) return std::nullopt;
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
    const mpz_class height = dot(n, exact.hulls.b.vertices[corners.front().b] - exact.hulls.a.vertices[corners.front().a]);
    result.push_back({n, height, std::move(corners), sorted(std::move(a)), sorted(std::move(b)), found.pairs});
  }
  return result;
}

}  // namespace fathom::stages
