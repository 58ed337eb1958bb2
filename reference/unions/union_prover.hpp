// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two unions that penetrate, and the optima.
// Output  what proves their depth, as plain data: polytopes inside differences of pieces, a tree
//         that splits space at their facets, and the optima. All numbers are in the unit of the
//         input.                                                                 [proofs/unions.md]
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/union.hpp"
#include "kernels/context.hpp"
#include "reference/unions/pieces.hpp"
#include "reference/unions/union_search.hpp"

namespace fathom::unions {

/// A polytope Q inside P_ij = B_j (+) (-A_i). Its vertices are differences of the points of these
/// pieces, by their indices in the pieces. Unlike that of two convex bodies it need not hold O.
struct PiecePolytope {
  std::uint32_t a = 0, b = 0;  ///< i and j: which pieces
  InnerPolytope inner;         ///< vertices and facets, coplanar ones merged
};

/// A node of the tree, which stands in preorder: after a split come the subtrees of its children. A
/// node stands for a cell, the points x that meet the constraints of its path, numbered from 0,
/// from the root on. On the way from a split to its child number c (from 0) these are added: for
/// each child before it, in their order, <n, x> <= h of that child's facet; then <n, x> >= h of the
/// child's own facet. Facets of the split's polytope without a child have h > 0 and h^2 > q <n,n>.
struct ProofNode {
  bool split = false;          ///< else a leaf
  std::uint32_t polytope = 0;  ///< of a split: which one
  /// of a split: the facets of its children, each once. Of a leaf: at most four constraints of the
  /// path that alone keep its cell at distance sqrt(q), or that have no common point; none can go
  std::vector<std::uint32_t> numbers;
};

/// Together they prove that q is the squared depth if the optima are free, which is proved by
/// separations or by an apart_tree of each; and that the optima are all.
struct UnionProof {
  mpq_class squared;  ///< q
  std::vector<PiecePolytope> polytopes;
  std::vector<ProofNode> nodes;  ///< the first is the root
  std::vector<Point> optima;     ///< all translations, in lexicographic order
};

/// For each pair of pieces a direction u other than O with <u, p> >= h_ij(u), primitive; that of
/// pieces i and j is at i * (number of pieces of B) + j. The naive twin of apart_tree. Throws
/// std::logic_error if p is not free, and Interrupted.
std::vector<Vector> separations(kernels::Context& context, const PlacedPieces& pieces, const kernels::RationalPoint& p);

// ---- blocks of pairs ---- [proofs/unions.md, "Blocks"]

/// A block of pairs: a range of A's pieces times one of B's. The first one is of all pairs. One
/// that is halved stands before its two halves, the lower pieces first, each with all below it; a
/// range [low, high) is cut at the floor of (low + high) / 2.
struct ApartBlock {
  enum class Kind {
    halves_of_a,
    halves_of_b,
    apart  ///< `direction` shows it for all pairs of the block
  };
  Kind kind = Kind::apart;
  Vector direction;  ///< u other than O, primitive
};

/// With h(u) the largest h_ij(u) of a block's pairs: <u, p> >= h(u) for each direction. `known` are
/// directions to be tried: those of contacts. Throws std::logic_error if p lies in the interior of
/// some P_ij, and Interrupted.
std::vector<ApartBlock> apart_tree(kernels::Context& context, const PlacedPieces& pieces,
                                   const kernels::RationalPoint& p, std::span<const Vector> known);

/// The same for unions at a distance, whose square is q > 0: h(u) < 0 and h(u)^2 >= q <u,u>.
/// Throws std::logic_error if two pieces are nearer.
std::vector<ApartBlock> distance_tree(kernels::Context& context, const PlacedPieces& pieces, const mpq_class& squared,
                                      std::span<const Vector> known);

/// Proves that these are the optima of unions that penetrate, translations of A in the unit of the
/// input. Throws std::logic_error if they are not, and Interrupted.
UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, const std::vector<UnionOptimum>& optima);

}  // namespace fathom::unions
