// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and perhaps a distance.
// Output  whether they overlap, touch or are apart; whether they are closer than the distance.
//         Exact, without their depth, and with a proof if one is asked for.
//                            [AGHRS, section 2.2, step before the algorithm; proofs/position.md]
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/signed_depth.hpp"

namespace fathom {

/// Why two polytopes overlap, touch or are apart. P and h are those of fathom/depth.hpp.
struct OverlapProof {
  /// Primitive n with h(n) = 0 if they touch, h(n) < 0 if they are apart; none if they overlap.
  std::optional<Vector> normal;
  /// Of both; none if they are apart.
  std::optional<Point> common;
  /// If they overlap: indices of points a of A and b of B whose differences b - a have O in the
  /// interior of their convex hull.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> around;
};

/// Where two bodies are.
struct Overlap {
  std::optional<Status> status;  ///< as penetration_depth says it; nullopt if bounds of curved shapes leave it open
  std::optional<OverlapProof> proof;  ///< if one was asked for
};

/// Why two polytopes are closer than a distance r, or not.
struct ClosenessProof {
  std::optional<Witness> points;  ///< closer: a point of each body, and |b - a| < r
  std::optional<Vector> normal;   ///< not closer: primitive n with h(n) / |n| <= -r
};

/// Whether two bodies are closer than a distance.
struct Closeness {
  std::optional<bool> closer;           ///< nullopt if bounds of curved shapes leave it open
  std::optional<ClosenessProof> proof;  ///< if one was asked for
};

/// How to find out. The answer does not depend on it, but where bounds leave it open.
struct OverlapOptions {
  bool proof = false;  ///< of polytopes; then they are placed on one lattice of integers of any size
  unsigned bits = SignedDepthOptions{}.bits;  ///< of the bounds of shapes, as in SignedDepthOptions
  Monitor* monitor = nullptr;                 ///< may stop the work; may be null
  Workspace* workspace = nullptr;             ///< as in Options; with one, polytopes on a narrow lattice take no memory
};

/// Returns where two bodies of any kinds are. Of polytopes without their depth, in a seventh to a
/// half of its time, but as long where they touch or nearly do; of others their depth or its bounds
/// are found first, as exact_answer does. Throws what exact_answer throws. If a proof is asked for,
/// also std::invalid_argument if one is no polytope, and InputError if the bodies' denominators
/// share so little that one lattice would take over 256 MB.
Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options = {});

/// Returns whether some point of A and some point of B are closer than `distance`, in the unit of
/// the coordinates: bodies that touch are closer than any. Throws what overlap throws, and
/// std::invalid_argument unless `distance` is above 0 and in lowest terms.
Closeness closer_than(const Body& a, const Body& b, const mpq_class& distance, const OverlapOptions& options = {});

}  // namespace fathom
