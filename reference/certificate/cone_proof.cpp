// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::certificate {
namespace {

// The rays of a cone without lineality in the order in which its faces go round it. Seen from the
// first ray the others follow each other within less than half a turn.
std::vector<Vector> in_cyclic_order(std::vector<Vector> rays) {
  const Vector first = rays.front();
  std::sort(rays.begin() + 1, rays.end(), [&](const Vector& u, const Vector& v) { return det(first, u, v) > 0; });
  return rays;
}

class Prover {
 public:
  Prover(std::span<const Point> a, std::span<const Point> b, const OptimalCone& cone)
      : a_(a), b_(b), proof_{cone, {}} {}

  ConeProof run() {
    const std::vector<Vector>& rays = proof_.cone.rays;
    if (rays.size() >= 3) facets(in_cyclic_order(rays));
    else few_rays(rays, rounded::lineality_basis(proof_.cone));
    return std::move(proof_);
  }

 private:
  // The points of both bodies whose differences are those of P's face in a direction.
  struct Face {
    std::vector<std::uint32_t> a, b;
  };

  [[nodiscard]] Face face(const Vector& u) const {
    return {solve::extreme_points(a_, -u), solve::extreme_points(b_, u)};
  }

  // Adds the difference of the face that lies farthest in the direction w.
  Point add(const Face& face, const Vector& w) {
    const auto farthest = [](std::span<const Point> points, const std::vector<std::uint32_t>& listed, const Vector& u) {
      return *std::max_element(listed.begin(), listed.end(),
                               [&](std::uint32_t i, std::uint32_t j) { return dot(u, points[i]) < dot(u, points[j]); });
    };
    const std::pair found{farthest(a_, face.a, -w), farthest(b_, face.b, w)};
    if (std::find(proof_.differences.begin(), proof_.differences.end(), found) == proof_.differences.end())
      proof_.differences.push_back(found);
    return b_[found.second] - a_[found.first];
  }

  // Two neighbouring rays span a facet of the cone, whose plane is orthogonal to an edge or a line
  // of differences.
  void facets(const std::vector<Vector>& rays) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::size_t next = (i + 1) % rays.size(), other = (i + 2) % rays.size();
      add(face(rays[i] + rays[next]), -rays[other]);
    }
  }

  void few_rays(const std::vector<Vector>& rays, std::vector<Vector> spanning) {
    Vector sum;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      add(face(rays.size() == 2 ? rays[1 - i] : Vector{}), -rays[i]);
      sum = sum + rays[i];
      spanning.push_back(rays[i]);
    }
    if (spanning.size() == 2) {
      const Vector w = cross(spanning[0], spanning[1]);
      for (const Vector& side : {w, -w}) add(face(sum), side);
    }
    if (spanning.size() == 1) around(face(sum), spanning.front());
  }

  // Differences of a face in the plane orthogonal to p, each of which has one to its left: each
  // next one is the farthest to the left.
  void around(const Face& face, const Vector& p) {
    std::vector<Vector> found;
    Vector w = is_zero(cross(p, {1, 0, 0})) ? Vector{0, 1, 0} : cross(p, {1, 0, 0});
    do {
      found.push_back(primitive_along(add(face, w)));
      w = cross(p, found.back());
    } while (std::none_of(found.begin(), found.end(), [&](const Vector& d) { return dot(w, d) > 0; }));
  }

  std::span<const Point> a_, b_;
  ConeProof proof_;
};

// The rules, one by one.
class Rules {
 public:
  Rules(const ConeProof& proof, std::span<const Point> a, std::span<const Point> b)
      : rays_(proof.cone.rays), lines_(rounded::lineality_basis(proof.cone)) {
    for (const auto& [i, j] : proof.differences) {
      if (!report_.expect(i < a.size() && j < b.size(), "a difference has an index out of range")) continue;
      differences_.push_back(primitive_along(b[j] - a[i]));
      zeros_.push_back(zeros_of(differences_.back()));
    }
  }

  kernels::Report run() {
    const bool independent = lines_.size() == 3   ? det(lines_[0], lines_[1], lines_[2]) != 0
                             : lines_.size() == 2 ? !is_zero(cross(lines_[0], lines_[1]))
                                                  : lines_.empty() || !is_zero(lines_.front());
    report_.expect(independent, "the lineality's vectors are not independent");
    if (rays_.size() >= 3) many_rays();
    else few_rays();
    return report_;
  }

 private:
  using Indices = std::set<std::size_t>;

  [[nodiscard]] Indices zeros_of(const Vector& d) const {
    Indices zeros;
    for (std::size_t k = 0; k < rays_.size(); ++k)
      if (dot(d, rays_[k]) == 0) zeros.insert(k);
    return zeros;
  }

  void many_rays() {
    std::set<Indices> facets;
    for (const Indices& zeros : zeros_)
      report_.expect(zeros.size() == 2, "a difference is not orthogonal to exactly two rays");
    facets.insert(zeros_.begin(), zeros_.end());
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const auto around =
          std::count_if(facets.begin(), facets.end(), [&](const Indices& zeros) { return zeros.contains(k); });
      report_.expect(around >= 2, "a ray lies in fewer than two facets");
    }
  }

  void few_rays() {
    const std::size_t dimension = lines_.size() + rays_.size();
    report_.expect(dimension >= 1 && dimension <= 3, "lineality and rays have another dimension than 1, 2 and 3");
    report_.expect(rays_.size() < 2 || !is_zero(cross(rays_[0], rays_[1])), "the rays are dependent");
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const auto ends_at = [&](const Indices& zeros) { return !zeros.contains(k) && zeros.size() + 1 == rays_.size(); };
      report_.expect(std::any_of(zeros_.begin(), zeros_.end(), ends_at), "nothing shows that a ray is the end");
    }
    std::vector<Vector> flat;
    for (std::size_t i = 0; i < differences_.size(); ++i)
      if (zeros_[i].size() == rays_.size()) flat.push_back(differences_[i]);
    const auto some = [&](const auto& holds) { return std::any_of(flat.begin(), flat.end(), holds); };
    if (dimension == 2) {
      const bool both = some([&](const Vector& d) { return some([&](const Vector& e) { return dot(d, e) < 0; }); });
      report_.expect(both, "no two differences of opposite senses");
    }
    if (dimension == 1) {
      const Vector p = lines_.empty() ? rays_.front() : lines_.front();
      report_.expect(!flat.empty(), "no difference is orthogonal to the one direction");
      for (const Vector& d : flat)
        report_.expect(some([&](const Vector& e) { return det(p, d, e) > 0; }), "no difference to the left of another");
    }
  }

  const std::vector<Vector>& rays_;
  std::vector<Vector> lines_, differences_;
  std::vector<Indices> zeros_;
  kernels::Report report_;
};

}  // namespace

ConeProof prove_cone(std::span<const Point> a, std::span<const Point> b, const OptimalCone& cone) {
  return Prover(a, b, cone).run();
}

kernels::Report validate(const ConeProof& proof, std::span<const Point> a, std::span<const Point> b) {
  kernels::Report report = rounded::validate(proof.cone, a, b);
  if (report.ok()) report = Rules(proof, a, b).run();
  return report;
}

}  // namespace fathom::certificate
