// SPDX-License-Identifier: GPL-3.0-or-later
// The search for cores that penetrate: a polytope inside P expands towards the supports of its
// nearest facets.
//                                                                [proofs/shapes_curved.md, lemma 2]
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "reference/curved/goal.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {

/// Of a normal that is asked for without being shortened.
inline constexpr long most_exact_bits = 128;
/// After so many calls the search looks for the first time at how fast it gets on.
inline constexpr std::size_t first_checkpoint = 128;

/// What binary64 says of bounds, of which it decides nothing: in the lattice's coordinates times
/// 2^-exponent.
class Estimates {
 public:
  Estimates(const Lattice& lattice, const Goal& goal);

  [[nodiscard]] double ceiling(const Ceiling& ceiling) const { return distance(ceiling.height, ceiling.direction); }
  /// height / |normal|.
  [[nodiscard]] double distance(const mpz_class& height, const Vector& normal) const;
  /// Of the foot of O, whose square is numerator / denominator.
  [[nodiscard]] double root(const mpz_class& numerator, const mpz_class& denominator) const;
  /// False if the goal is out of sight.
  [[nodiscard]] bool perhaps_met(double low, double high) const;
  /// How far bounds of one sign may be apart.
  [[nodiscard]] double allowed() const { return share_ * extent_; }
  /// How fine a point has to be while the bounds differ by this.
  [[nodiscard]] unsigned precision(double gap) const;

 private:
  long exponent_;
  unsigned fine_;
  double extent_, rho_, share_;
};

class Growth {
 public:
  /// `common`: O is known to be in P.
  Growth(Oracle& oracle, const Goal& goal, const Estimates& estimates, bool common)
      : oracle_(oracle), goal_(goal), estimates_(estimates), common_(common) {}

  /// The points must not lie in one plane.
  void start(const std::array<polytope::Difference, 4>& points);
  /// Expands until the goal is met, h(n) = 0 for some n, nothing is above any facet, no call is
  /// left, or the calls that are left will not do.
  void run();

  /// The squared distance of the nearest facet plane of Q, in the shapes' unit; nullopt if O is not
  /// in the interior of Q. Exact.
  [[nodiscard]] std::optional<mpq_class> squared();
  /// Q; its vertices name points of the oracle twice.
  InnerPolytope polytope() { return expanding::inner_polytope(surface_, merge_); }

 private:
  using Corner = expanding::SurfaceVertex<mpz_class>;
  using TriangleId = expanding::TriangleId;

  // By the squared distance, negative above O, less that of the reference: so near distances differ
  // by many bits.
  struct Waiting {
    double key;
    bool exact;  ///< it comes from the exact plane
    TriangleId triangle;
    bool operator<(const Waiting& other) const { return key > other.key; }
  };
  struct Reference {
    mpz_class square, length;  ///< height |height| and <n,n> of some ceiling
    double rounded = 0;        ///< their quotient
  };

  [[nodiscard]] Corner corner(polytope::Difference d) const;
  void wait_for(TriangleId t, bool exact);
  std::optional<Waiting> nearest();
  void refer_to(const Ceiling& ceiling);
  [[nodiscard]] double key(const mpz_class& height, const Vector& normal) const;
  [[nodiscard]] double distance(double key) const;
  bool met();
  bool hopeless(double gap);
  void expand(TriangleId t, double gap);
  void ask_exactly(TriangleId t);

  Oracle& oracle_;
  const Goal& goal_;
  const Estimates& estimates_;
  bool common_;
  expanding::Surface<mpz_class> surface_;
  expanding::MergeMemory merge_;
  std::vector<Waiting> waiting_;  // a heap
  Reference reference_;
  std::size_t checkpoint_ = first_checkpoint;  // a power of two
  double last_gap_ = 0, last_factor_ = 0;      // at the one before, if any; and by how much it had shrunk there
};

}  // namespace fathom::curved
