// SPDX-License-Identifier: Apache-2.0
// A certificate as it was read: nothing in it is believed yet.
//                                                           [FORMAT.md, sections 2, 3, 12 to 17]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fathom_check {

// Integers that are made once and kept. A small certificate has several hundred, and an allocation
// for each would take longer than their arithmetic: so their digits lie side by side in a few
// blocks.

/// An integer whose digits lie in an Arena, which must outlive it. Copies share the digits; nothing
/// changes them.
class Integer {
 public:
  Integer() : Integer(&one_, 0) {}
  static Integer one() { return {&one_, 1}; }

  [[nodiscard]] mpz_srcptr get_mpz_t() const { return value_; }
  [[nodiscard]] mpz_class value() const { return mpz_class(value_); }
  [[nodiscard]] int sign() const { return mpz_sgn(value_); }

 private:
  friend class Arena;
  /// Digits with the least one first, and their number, which is negative if the integer is.
  Integer(mp_srcptr digits, mp_size_t size)
      : value_ MPZ_ROINIT_N(const_cast<mp_limb_t*>(digits), static_cast<int>(size)) {}

  static constexpr mp_limb_t one_ = 1;
  mpz_t value_;
};

inline bool operator==(const Integer& u, const Integer& v) { return mpz_cmp(u.get_mpz_t(), v.get_mpz_t()) == 0; }

class Arena {
 public:
  Integer keep(const mpz_class& value) {
    if (value == 0) return {};
    const std::size_t size = mpz_size(value.get_mpz_t());
    mp_limb_t* const digits = room(size);
    std::copy_n(mpz_limbs_read(value.get_mpz_t()), size, digits);
    return {digits, sgn(value) * static_cast<mp_size_t>(size)};
  }
  Integer keep(std::int64_t value) {
    if (value == 0) return {};
    mp_limb_t* const digit = room(1);
    *digit = value < 0 ? -static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
    return {digit, value < 0 ? -1 : 1};
  }

 private:
  mp_limb_t* room(std::size_t digits) {
    constexpr std::size_t block = 1024;
    if (digits > left_) {
      left_ = std::max(digits, block);
      blocks_.emplace_back(new mp_limb_t[left_]);
      next_ = blocks_.back().get();
    }
    left_ -= digits;
    return std::exchange(next_, next_ + digits);
  }

  std::vector<std::unique_ptr<mp_limb_t[]>> blocks_;
  mp_limb_t* next_ = nullptr;
  std::size_t left_ = 0;
};

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

enum class Claim { depth, bounds, touching, disjoint, apart, signed_bounds, solid, grazing, contact };

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

  /// The corners of the facets from number `first` to `last`, sorted, each once.
  [[nodiscard]] std::vector<std::uint32_t> named(std::size_t first, std::size_t last) const {
    std::vector<std::uint32_t> result(corners.data() + begin_of(first), corners.data() + begin_of(last));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
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
  std::size_t levels = 1;                   ///< how often each list of points stands among the points
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

/// How many pieces a solid or a union has.
inline std::size_t count_pieces(const Body& body) {
  return body.core == Body::Core::solid ? body.solid.pieces.size() : body.pieces.size();
}

/// How the lower side is proved.
enum class Proof { none, facets, weights };

/// A polytope inside the differences of piece i of A and piece j of B. Its vertices and facets lie
/// among those of the certificate.
struct InnerPolytope {
  std::uint32_t i, j;
  std::size_t line;
  std::size_t first_vertex, first_facet;
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

/// What a certificate of format 6 says besides: how the bodies move, and what shows when they meet.
struct MotionParts {
  struct Quaternion {
    Rational r;
    RationalPoint v;
  };
  /// At the begin, and at the end.
  struct Motion {
    std::array<Quaternion, 2> turns;
    std::array<RationalPoint, 2> places;
  };
  using Weights = std::array<Part<std::vector<Weight>>, 2>;  ///< of a and of b
  /// From the end of the piece before, or from 0.
  struct Piece {
    enum class Kind { of_b, of_a, of_edges, near };
    Kind kind;
    std::size_t line;
    Rational end;
    Vector n, g;      ///< the direction; of edges, those of a and of b
    Rational delta;   ///< of `near`
    Weights weights;  ///< of `near`
  };

  std::array<Motion, 2> motions;  ///< of a and of b
  std::vector<Piece> pieces;
  std::size_t line = 0;   ///< that announces the pieces
  mpz_class turning = 1;  ///< the least common multiple of the denominators of all quaternions
};

/// Bodies of the plane stand for bodies of space.                                   [section 16]
struct Raising {
  Rational height;
  std::size_t line;
};

struct Certificate {
  Arena integers;  ///< where all below lie
  int format = 1;
  std::string id;                  ///< percent-escaped as written; empty if none
  std::optional<Raising> raising;  ///< if the bodies are of the plane: as given below they are raised
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
  MotionParts of_motions;
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
