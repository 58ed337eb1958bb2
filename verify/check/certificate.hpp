// SPDX-License-Identifier: Apache-2.0
// A certificate as it was read: nothing in it is believed yet.
//                                                           [FORMAT.md, sections 2, 3, 12 to 15]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "integers.hpp"

namespace fathom_check {

struct Vector {
  Integer x, y, z;
};

/// In lowest terms.
struct Rational {
  Integer num;
  Integer den = Integer::one();  ///< positive
};

inline bool same(const Rational& r, const Rational& s) { return r.num == s.num && r.den == s.den; }

struct RationalPoint {
  Rational x, y, z;
};

enum class Claim { depth, bounds, touching, disjoint, apart, signed_bounds, solid };

/// Indices as read; one too large for any list has become `no_index`.
constexpr std::uint32_t no_index = UINT32_MAX;
struct Pair {
  std::uint32_t j, i;
};
struct Weight {
  std::uint32_t index;
  Rational weight;
};

/// Lists of corners, one after another.
struct Facets {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;  ///< of facet f among the corners: from ends[f - 1] to ends[f]

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::size_t begin_of(std::size_t f) const { return f == 0 ? 0 : ends[f - 1]; }
};

/// Items of a part, and the line of each.
template <class Items>
struct Part {
  Items items;
  std::vector<std::size_t> lines;
  std::size_t line = 0;  ///< that announces the part
};

/// One of several lists whose items lie one behind another in a Part.
struct List {
  std::size_t end;   ///< of its items: they begin where the list before ends
  std::size_t line;  ///< that announces it
};

/// Returns where the list of this number begins.
inline std::size_t begin_of(const std::vector<List>& lists, std::size_t number) {
  return number == 0 ? 0 : lists[number - 1].end;
}

/// The center, then the axes.
using Atom = std::vector<RationalPoint>;
using Term = std::vector<Atom>;

/// A point of a term.
struct Place {
  std::uint32_t atom;
  RationalPoint y;
};

/// What a mesh encloses, in convex pieces; its points are those of the body.
struct SolidParts {
  using Triangle = std::array<std::uint32_t, 3>;
  Part<std::vector<Triangle>> mesh;
  Part<Facets> facets;       ///< of all pieces, one after another
  std::vector<List> pieces;  ///< of facets
  std::size_t line = 0;      ///< that announces the pieces
};

/// A core, the radius around it, and what the proof says about the core alone.
struct Body {
  enum class Core { points, shape, half_space, pieces, solid, none };

  Core core = Core::points;
  std::size_t line = 0;                     ///< that announces the core
  Part<std::vector<RationalPoint>> points;  ///< of all pieces, one after another, if there are pieces
  std::vector<List> pieces;                 ///< of points, if there are pieces
  SolidParts solid;
  std::vector<Term> terms;  ///< of a shape
  RationalPoint normal;     ///< of a half-space
  Rational offset;
  Rational radius;
  Part<std::vector<Rational>> heights;  ///< of a shape
  /// of a shape: for each inner point as many places as there are terms; `lines` has one for each
  /// point
  Part<std::vector<Place>> inner;
};

/// How the lower side is proved.
enum class Proof { none, facets, weights };

/// A polytope inside the differences of piece i of A and piece j of B. Its vertices and facets lie
/// among those of the certificate.
struct InnerPolytope {
  std::uint32_t i, j;
  std::size_t line;
  List vertices, facets;
};

/// Nodes of a tree, in preorder.
struct Nodes {
  std::vector<std::uint32_t> indices;  ///< of a split: its polytope, then the facets; of a leaf: the constraints
  std::vector<std::size_t> ends;       ///< of node k among the indices: from ends[k - 1] to ends[k]
  std::vector<bool> splits;            ///< whether the node is a split; else it is a leaf

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::size_t begin_of(std::size_t k) const { return k == 0 ? 0 : ends[k - 1]; }
};

/// A range of pieces of A times one of B, which is split, or separated by a vector.
struct Block {
  enum class Kind { splits_a, splits_b, vector };
  Kind kind;
  Vector u;  ///< of a vector
};

/// What a certificate of format 3, or one of format 5 about two bodies, says besides; its polytopes
/// have `vertices` and `facets`, the nearest pieces `weights_a` and `weights_b`.
struct UnionParts {
  Part<std::vector<RationalPoint>> optima;
  Part<std::vector<Vector>> separations;  ///< of all lists, one after another; of format 3
  Part<std::vector<Block>> blocks;        ///< likewise; of format 5
  std::vector<List> separation_lists;     ///< one for each optimum; a single one for other claims
  std::vector<InnerPolytope> polytopes;
  Part<Nodes> tree;
  std::uint32_t nearest_a = 0, nearest_b = 0;  ///< the pieces of the weights
  std::size_t nearest_line = 0;
  mpz_class unit = 1;  ///< the least common multiple of the denominators of all coordinates of optima
  /// of format 5: what the tree's work adds to; the letters b and e of section 15
  std::uint64_t work = 0, width_of_claim = 0, width_of_optima = 0;
};

/// What a certificate of format 4 says besides: a patch for each direction.
struct PatchParts {
  /// Weights of a point of A, then of B, up to these among those of all corners.
  struct Corner {
    std::size_t end_a, end_b;
  };
  struct Side {
    bool of_b;
    Vector inward;
    std::uint32_t corner;
  };
  /// How fast the signed depth grows, sign sqrt(root), as A moves with v + w x p at its points p.
  struct Rate {
    RationalPoint v, w;
    Integer sign;
    Rational root;
  };

  std::size_t line = 0;
  std::vector<List> corner_lists, side_lists;  ///< one of each for each patch
  Part<std::vector<Corner>> corners;
  std::vector<Weight> weights;
  Part<std::vector<Side>> sides;
  Part<std::vector<Rate>> rates;

  /// Of corner k among the weights.
  [[nodiscard]] std::size_t begin_of(std::size_t k) const { return k == 0 ? 0 : corners.items[k - 1].end_b; }
};

struct Certificate {
  Arena integers;  ///< where all below lie
  int format = 1;
  std::string id;  ///< percent-escaped as written; empty if none
  Body a, b;
  Claim claim = Claim::depth;
  std::size_t claim_line = 0;
  Rational low, high;  ///< of the claim; equal for claims of depth and apart
  bool all = false;
  Part<std::vector<Vector>> directions;
  Proof proof = Proof::none;
  Part<std::vector<Pair>> vertices;
  Part<Facets> facets;
  Part<std::vector<Weight>> weights_a, weights_b;
  bool has_cone = false;
  Part<std::vector<Vector>> lineality, rays;
  Part<std::vector<Pair>> differences;
  UnionParts of_unions;
  PatchParts of_patches;
  mpz_class fine = 1;   ///< the least common multiple of the denominators of all parameters of inner points
  mpz_class scale = 1;  ///< `fine` times that of the denominators of all coordinates of points and atoms
};

/// Whether bodies have radii and may be half-spaces, and the signed depth is what is claimed.
inline bool is_of_bodies(int format) { return format == 2 || format == 4; }

/// Whether it is about two bodies that are solids or unions.                         [section 15]
inline bool is_of_solids(const Certificate& c) { return c.format == 5 && c.claim != Claim::solid; }

/// Whether the claim is one about unions.
inline bool is_of_unions(const Certificate& c) { return c.format == 3 || is_of_solids(c); }

inline bool has_half_space(const Certificate& c) {
  return c.a.core == Body::Core::half_space || c.b.core == Body::Core::half_space;
}

}  // namespace fathom_check
