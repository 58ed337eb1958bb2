// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of two unions: all their points as integers in one common unit; and of each pair of
// pieces the polytope P_ij.
#pragma once

#include <cstdint>
#include <deque>
#include <type_traits>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/narrow_lattice.hpp"

namespace fathom::unions {

/// All clouds have one exponent. Points of the lattice are translations of A too.
struct PlacedPieces {
  polytope::PlacedPair whole;  ///< all points of either body, piece after piece
  std::vector<kernels::PointCloud> a, b;

  [[nodiscard]] long exponent() const { return whole.exponent(); }
  /// Piece i of A and piece j of B, on the common lattice.
  [[nodiscard]] polytope::PlacedPair pair(std::uint32_t i, std::uint32_t j) const;

  /// A point of the lattice in the unit of the input, and back.
  [[nodiscard]] Point translation(const kernels::RationalPoint& p) const;
  [[nodiscard]] kernels::RationalPoint point(const Point& translation) const;
  /// A squared length on the lattice, numerator / denominator, in the unit of the input.
  [[nodiscard]] mpq_class squared(const mpz_class& numerator, const mpz_class& denominator) const;
};

/// Throws std::invalid_argument if a body has no pieces, a piece has no points or no interior, or a
/// coordinate is not in lowest terms.
PlacedPieces place_pieces(const Pieces& a, const Pieces& b);

// A piece of A and a piece of B: the polytope P_ij = B_j (+) (-A_i), known by a polytope Q inside
// it and by planes that hold it. Both grow towards the points that are asked about, by the steps of
// the expanding polytope, and only as far as an answer needs.

/// The differences of two clouds, by the scans of these numbers.
template <class Numbers>
using DifferencesIn = std::conditional_t<std::is_same_v<Numbers, kernels::FixedNumbers>,
                                         polytope::NarrowDifferences<polytope::NarrowInteger>, polytope::Differences>;

/// A facet of Q, or a part of one.
template <class Numbers>
struct PieceFacetIn {
  expanding::TriangleId triangle;
  kernels::OrientedPlaneIn<Numbers> plane;     ///< its normal points out of Q
  kernels::OrientedPlaneIn<Numbers> reversed;  ///< the same plane, from the other side
  bool supports = false;                       ///< whether the plane is known to hold a facet of P_ij
};
using PieceFacet = PieceFacetIn<kernels::AnyNumbers>;

/// `Numbers`: the integers that hold all of it.
template <class Numbers>
class PiecePairIn {
 public:
  using Plane = kernels::OrientedPlaneIn<Numbers>;
  using Place = kernels::RationalPointIn<Numbers>;
  using Facet = PieceFacetIn<Numbers>;
  using Surface = expanding::Surface<typename Numbers::OfPlane>;

  /// The clouds have one exponent and outlive it. Their hulls have interiors.
  PiecePairIn(const kernels::PointCloud& a, const kernels::PointCloud& b);

  /// Whether the point lies in the interior of P_ij. Exact; Q grows until it tells.
  bool contains(const Place& p);
  /// A plane that holds P_ij below it and the point on it or above it: after contains(p) has
  /// returned false, until the next call.
  [[nodiscard]] const Plane& separation() const { return separations_.front(); }
  /// About how far a point in the interior of Q is from its boundary. Decides nothing but the order
  /// of work.
  [[nodiscard]] double margin(const Place& p) const;

  /// The facets of Q, once it has any: of a facet that is alive the plane stays where it is, also
  /// when the facet goes.
  [[nodiscard]] const std::vector<Facet*>& facets() const { return facets_; }
  /// True if the facet's plane supports P_ij. Otherwise Q grows and the facet is no more.
  bool settle(Facet& facet);
  /// Grows Q until all its planes that have the point on them or below support P_ij. If the point
  /// lies in the boundary of P_ij, returns the outward normals of all facets that meet there, each
  /// once; else none.
  std::vector<Vector> normals_at(const Place& p);
  /// Q, its coplanar parts merged. Sets `facet_of` to the merged facet of each of facets().
  InnerPolytope inner(std::vector<std::uint32_t>& facet_of);
  /// Whether a point was ever asked about for which Q was needed.
  [[nodiscard]] bool touched() const { return started_; }
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  using Corner = expanding::SurfaceVertex<typename Numbers::OfPlane>;
  using Product = typename Numbers::Product;

  void start();
  [[nodiscard]] Corner corner(polytope::Difference d) const;
  void add(expanding::TriangleId triangle);
  void grow(const Corner& corner, const Facet& facet);
  Facet* worst(const Place& p);
  bool separated(const Place& p);
  void remember(Plane plane);
  bool step_towards(const Place& p, Facet& facet);

  kernels::ScanMemory memory_;
  DifferencesIn<Numbers> differences_;
  bool started_ = false;
  Surface surface_;
  expanding::MergeMemory merge_;
  std::deque<Facet> all_;
  std::vector<Facet*> facets_;
  std::vector<Plane> separations_;  // the last one that told is the first
};
using PiecePair = PiecePairIn<kernels::AnyNumbers>;

}  // namespace fathom::unions
