// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of two unions: their points as integers in one common unit, or, where that would be
// very short, of each piece in a unit of its own; and of a pair of pieces the polytope P_ij.
//                                                    [proofs/unions.md, "Lattices of their own"]
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::unions {

/// The point v / w, w > 0.
struct Homogeneous {
  Vector v;
  mpz_class w;
};

/// A point p of the cloud stands for origin + p / (denominator * factor).
struct PlacedPiece {
  kernels::PointCloud cloud;
  mpz_class factor = 1;  ///< > 0
  double scale = 1;      ///< makes images of the cloud images in 2^exponent of the common unit; at most 1, within 2^-51
  /// The points in the common unit, each in lowest terms, if the piece has a lattice of its own:
  /// that of all its points together is many times as fine as what one of them needs.
  std::vector<Homogeneous> points = {};
};

/// Translations of A are points of the common lattice, over any denominators.
struct PlacedPieces {
  /// The common unit, origin and exponent, that of all coordinates in this unit; and all points of
  /// either body, piece after piece, unless pieces have lattices of their own.
  polytope::PlacedPair whole;
  std::vector<PlacedPiece> a, b;

  [[nodiscard]] bool on_one_lattice() const { return whole.a.size() > 0; }
  [[nodiscard]] long exponent() const { return whole.exponent(); }
  /// The factor by which the lattice of piece i of A and piece j of B is finer than the common one;
  /// and the two pieces on it.
  [[nodiscard]] mpz_class factor(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] polytope::PlacedPair pair(std::uint32_t i, std::uint32_t j) const;
  /// What the boxes about two pieces say, in the unit of the input: the squared depth of the boxes,
  /// or minus their squared distance. That of the pieces is not larger.
  [[nodiscard]] mpq_class squared_of_boxes(std::uint32_t i, std::uint32_t j) const;

  /// A point of the common lattice in the unit of the input, and back.
  [[nodiscard]] Point translation(const kernels::RationalPoint& p) const;
  [[nodiscard]] kernels::RationalPoint point(const Point& translation) const;
  /// A squared length on the lattice, numerator / denominator, in the unit of the input.
  [[nodiscard]] mpq_class squared(const mpz_class& numerator, const mpz_class& denominator) const;
  /// A length in the unit of the input, by its square, as one of images: an upper bound, and a
  /// lower one of what is at least 2^-400.
  [[nodiscard]] double image_above(const mpq_class& squared) const;
  [[nodiscard]] double image_below(const mpq_class& squared) const;
};

/// Which lattices pieces are put on.
enum class Lattices {
  fitting,  ///< one, if its denominator is in proportion to the coordinates; else their own
  one,      ///< one of all pieces, however fine
  own,      ///< each its own
};

/// Throws std::invalid_argument if a body has no pieces, a piece has no points or no interior, or a
/// coordinate is not in lowest terms; InputError if one lattice is asked for and would be too fine.
PlacedPieces place_pieces(const Pieces& a, const Pieces& b, Lattices lattices = Lattices::fitting);

// A piece of A and a piece of B: the polytope P_ij = B_j (+) (-A_i), known by a polytope Q inside
// it and by planes that hold it. Both grow towards the points that are asked about, by the steps of
// the expanding polytope, and only as far as an answer needs.

/// The integers that scans of two clouds take.
template <class Numbers>
using IntegerOfScans =
    std::conditional_t<std::is_same_v<Numbers, kernels::FixedNumbers>, polytope::NarrowInteger, mpz_class>;

/// A facet of Q, or a part of one.
template <class Numbers>
struct PieceFacetIn {
  PieceFacetIn(expanding::TriangleId of, kernels::OrientedPlaneIn<Numbers> on) : triangle(of), plane(std::move(on)) {}

  expanding::TriangleId triangle;
  kernels::OrientedPlaneIn<Numbers> plane;  ///< its normal points out of Q
  bool supports = false;                    ///< whether the plane is known to hold a facet of P_ij

  /// The same plane, from the other side. It stays where it is.
  [[nodiscard]] const kernels::OrientedPlaneIn<Numbers>& reversed() {
    if (!reversed_) reversed_ = std::make_unique<kernels::OrientedPlaneIn<Numbers>>(plane.reversed());
    return *reversed_;
  }

 private:
  std::unique_ptr<kernels::OrientedPlaneIn<Numbers>> reversed_;  // few facets are asked for it
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

  /// Of piece i of A and piece j of B. `pieces` must outlive it.
  PiecePairIn(const PlacedPieces& pieces, std::uint32_t i, std::uint32_t j);
  PiecePairIn(const PiecePairIn&) = delete;
  PiecePairIn& operator=(const PiecePairIn&) = delete;

  const std::uint32_t a, b;  ///< i and j

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
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  using Corner = expanding::SurfaceVertex<typename Numbers::OfPlane>;
  using Product = typename Numbers::Product;

  [[nodiscard]] Plane outwards(const Vec3<typename Numbers::OfPlane>& normal,
                               const typename Numbers::OfPlane& height) const;
  [[nodiscard]] const Plane& inwards(const Plane& plane, Plane& room) const;
  void start();
  [[nodiscard]] Corner corner(polytope::Difference d) const;
  [[nodiscard]] Plane plane_of(expanding::TriangleId triangle);
  void grow(const Corner& corner, const Facet& facet);
  Facet* worst(const Place& p);
  bool separated(const Place& p);
  void remember(Plane plane);
  bool step_towards(const Place& p, Facet& facet);

  mpz_class factor_;  // by which the lattice of the pair is finer than the common one
  const PlacedPieces& pieces_;
  std::optional<polytope::PlacedPair> own_;  // the points on the pair's lattice, if that is not the common one
  kernels::ScanMemory memory_;
  polytope::DifferencesIn<IntegerOfScans<Numbers>> differences_;
  bool started_ = false;
  Surface surface_;
  expanding::MergeMemory merge_;
  std::deque<Facet> all_;
  std::vector<Facet*> facets_;
  std::vector<Plane> separations_;  // the last one that told is the first
};
using PiecePair = PiecePairIn<kernels::AnyNumbers>;

}  // namespace fathom::unions
