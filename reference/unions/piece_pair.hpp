// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of A and a piece of B: the polytope P_ij = B_j (+) (-A_i), known by a polytope Q inside it and by planes that hold it. Both grow
// towards the points that are asked about, by the steps of the expanding polytope, and only as far as an answer needs.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "kernels/filters/rational_point.hpp"
#include "reference/expanding/inner_polytope.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/differences.hpp"

namespace fathom::unions {

/// A facet of Q, or a part of one.
struct PieceFacet {
  expanding::TriangleId triangle;
  kernels::OrientedPlane plane;     ///< its normal points out of Q
  kernels::OrientedPlane reversed;  ///< the same plane, from the other side
  bool supports = false;            ///< whether the plane is known to hold a facet of P_ij
};

class PiecePair {
 public:
  /// The clouds have one exponent and outlive it. Their hulls have interiors.
  PiecePair(const kernels::PointCloud& a, const kernels::PointCloud& b);

  /// Whether the point lies in the interior of P_ij. Exact; Q grows until it tells.
  bool contains(const kernels::RationalPoint& p);
  /// A plane that holds P_ij below it and the point on it or above it: after contains(p) has returned false, until the next call.
  [[nodiscard]] const kernels::OrientedPlane& separation() const { return separations_.front(); }
  /// About how far a point in the interior of Q is from its boundary. Decides nothing but the order of work.
  [[nodiscard]] double margin(const kernels::RationalPoint& p) const;

  /// The facets of Q, once it has any: of a facet that is alive the plane stays where it is, also when the facet goes.
  [[nodiscard]] const std::vector<PieceFacet*>& facets() const { return facets_; }
  /// True if the facet's plane supports P_ij. Otherwise Q grows and the facet is no more.
  bool settle(PieceFacet& facet);
  /// Grows Q until all its planes that have the point on them or below support P_ij, and returns these: if the point lies in the boundary
  /// of P_ij, the planes of all facets that meet there, each once; else none.
  std::vector<const kernels::OrientedPlane*> planes_through(const kernels::RationalPoint& p);
  /// Q, its coplanar parts merged. Sets `facet_of` to the merged facet of each of facets().
  InnerPolytope inner(std::vector<std::uint32_t>& facet_of);
  /// Whether a point was ever asked about for which Q was needed.
  [[nodiscard]] bool touched() const { return started_; }
  [[nodiscard]] const expanding::Surface<mpz_class>& surface() const { return surface_; }

 private:
  using Corner = expanding::SurfaceVertex<mpz_class>;

  void start();
  [[nodiscard]] Corner corner(polytope::Difference d) const;
  void add(expanding::TriangleId triangle);
  void grow(const Corner& corner, const PieceFacet& facet);
  PieceFacet* worst(const kernels::RationalPoint& p);
  bool separated(const kernels::RationalPoint& p);
  void remember(kernels::OrientedPlane plane);
  bool step_towards(const kernels::RationalPoint& p, PieceFacet& facet);

  polytope::Differences differences_;
  bool started_ = false;
  expanding::Surface<mpz_class> surface_;
  expanding::MergeMemory merge_;
  std::deque<PieceFacet> all_;
  std::vector<PieceFacet*> facets_;
  std::vector<kernels::OrientedPlane> separations_;  // the last one that told is the first
};

}  // namespace fathom::unions
