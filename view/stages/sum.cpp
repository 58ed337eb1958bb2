// SPDX-License-Identifier: GPL-3.0-or-later
// The sum P for pictures, or the polytope Q inside it. Part of parts.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "kernels/number/rational.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

constexpr std::size_t most_facets = 20'000;  // a picture of more is a ball

using Points = std::vector<std::uint32_t>;

/// (height / (|normal| denominator))^2.
mpq_class squared_distance(const mpz_class& height, const Vector& normal, const mpz_class& denominator) {
  return kernels::ratio(height * height, dot(normal, normal) * denominator * denominator);
}

SumFacetKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b) {
  if (corners_of_b == 1) return SumFacetKind::facet_of_a;
  if (corners_of_a == 1) return SumFacetKind::facet_of_b;
  return corners_of_a == 2 && corners_of_b == 2 ? SumFacetKind::edges : SumFacetKind::merged;
}

/// By distance, ties by normals; those that are nearest are optimal.
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
      if (is_new) sum.vertices.push_back(subject.placing.vector(hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a]));
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

/// The facet of Q with these corners.
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

/// Passes the reports of a computation of its own on to the context that it belongs to.
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

/// Of the certificate, if it is found soon and not too large itself; kind none otherwise.
StagedSum inner_sum(const StagesSource& subject) {
  Relay relay(subject.context);
  const Depth certified = penetration_depth(subject.a, subject.b, {.monitor = &relay});
  const Penetration* const penetration = certified.penetration();
  if (penetration == nullptr || !penetration->inner || penetration->inner->facets.size() > most_facets) return {};
  const InnerPolytope& q = *penetration->inner;
  StagedSum sum;
  sum.kind = SumKind::q;
  for (const auto& [a, b] : q.vertices) sum.vertices.push_back(subject.placing.vector(subject.pair.b[b] - subject.pair.a[a]));
  for (const std::vector<std::uint32_t>& corners : q.facets) sum.facets.push_back(facet_of_q(subject, q, corners));
  rank(sum.facets);
  return sum;
}

}  // namespace

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
  stages.left_out.push_back(many + (stages.sum.kind == SumKind::q ? ": in its place stands Q, the polytope inside P that proves the depth."
                                                                  : ", and no smaller polytope that proves the depth was found."));
}

}  // namespace fathom::stages
