// SPDX-License-Identifier: GPL-3.0-or-later
// Input   canonical pairs (A_i, B_i), and the lines through the bodies' edges.
// Output  the nearest of all planes aff(e (+) (-e')): the closest pairs of lines in L_i x L'_i, all ties kept.        [AGHRS, Lemma 2.2]
// Engine  naive: every pair of every canonical pair, through a double filter that leaves near ties to exact arithmetic.
#pragma once

#include <functional>
#include <vector>

#include "kernels/counters.hpp"
#include "kernels/line_scan.hpp"
#include "kernels/nearest.hpp"
#include "kernels/report.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {

/// The lines through a polytope's edges, exact and as images. Line i carries edge i. The polytope must outlive it.
class EdgeLines {
 public:
  /// `exponent` bounds the coordinates of both bodies: |c| <= 2^exponent.
  EdgeLines(const Polytope& polytope, long exponent);

  [[nodiscard]] std::size_t size() const { return polytope_->edges.size(); }
  [[nodiscard]] const Vector& point(std::uint32_t edge) const { return polytope_->vertices[polytope_->edges[edge].from]; }
  [[nodiscard]] Vector direction(std::uint32_t edge) const;
  [[nodiscard]] const LineImages& images() const { return images_; }

 private:
  const Polytope* polytope_;
  LineImages images_;
};

/// Offers the plane that is parallel to edge `of_a` of A and edge `of_b` of B, oriented away from O, in exact arithmetic. Parallel edges
/// span no plane and are skipped. N = <q - p, d x d'>, and d^2(l,l') = N^2 / |d x d'|^2.
/// Returns whether it is among the nearest now.
bool offer_edges(const EdgeLines& a, std::uint32_t of_a, const EdgeLines& b, std::uint32_t of_b, NearestPlanes& nearest);

/// Offers all pairs of all canonical pairs. `keep_going` is called with the share done; false stops early, and is returned.
bool closest_lines(const CanonicalSubsets& subsets, const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest, Counters& counters,
                   const std::function<bool(double)>& keep_going = {});

/// C4 as a sign: for each pair of each canonical pair of the hemisphere with pole z, <p_e - p_e', w> > 0 for the normal w of both edges
/// with <w,z> > 0. Parallel edges, and crossings on the equator, have no such w and are passed over. O(sum |A_i| |B_i|).       [AGHRS, Lemma 2.3]
[[nodiscard]] Report validate_separation(const CanonicalSubsets& subsets, const EdgeLines& a, const EdgeLines& b, const Vector& z);

}  // namespace fathom
