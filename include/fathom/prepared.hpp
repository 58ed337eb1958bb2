// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two polytopes, prepared once, and a pose of each.
// Output  what penetration_depth, overlap and closer_than say of the bodies in these poses, for as
//         many poses as there are. A search may begin where the one before it ended: no answer
//         depends on that.                                                    [proofs/prepared.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/overlap.hpp"
#include "fathom/shape.hpp"

namespace fathom {

/// A polytope whose hull is known, which all its copies share. Threads may share it.
class Prepared {
 public:
  /// Computes the hull. Throws std::invalid_argument if the body is no polytope, is empty, or has a
  /// coordinate that is not in lowest terms; and what a lattice for its points throws.
  explicit Prepared(const Body& polytope);

  [[nodiscard]] const Body& body() const;  ///< as it was given
  /// The indices of its extreme points, ascending; of equal points the lowest.
  [[nodiscard]] const std::vector<std::uint32_t>& extreme_points() const;

  struct Parts;
  std::shared_ptr<const Parts> parts;  ///< not for users
};

/// A prepared polytope in a pose: any affine map, exactly as it is given. M is hardly ever a
/// rotation if it is in binary64, but those of rigid_pose are exact ones.
struct PlacedBody {
  Prepared prepared;                                                                                 ///< the polytope
  std::variant<PoseBinary64, Pose> pose = PoseBinary64{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};  ///< the map
};

/// How many differences a search may begin with.
inline constexpr std::size_t most_start_differences = 8;

/// Where a search begins: differences b - a, by the indices of points a of A and b of B, any but no
/// more than most_start_differences. The search leaves here what it has ended with. No answer
/// depends on it.
struct WarmStart {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> differences;  ///< index in A, index in B
};

/// Returns the body in its pose, as exact points: what the questions below are about. Certificates
/// are of it. Throws std::invalid_argument if a number of the pose is not finite, or not in lowest
/// terms.
Body moved(const PlacedBody& placed);

/// Returns what penetration_depth(moved(a), moved(b), options) says, but for what depends on the
/// method: there is no inner polytope, no method and no count. Exact. Fastest are poses in binary64
/// of points in binary64, if their numbers are short or of similar sizes. Throws what moved and
/// penetration_depth throw, and std::invalid_argument if `start`, which may be null, has too many
/// differences, or an index of no point.
Depth penetration_depth(const PlacedBody& a, const PlacedBody& b, WarmStart* start = nullptr,
                        const Options& options = {});

/// Returns what overlap(moved(a), moved(b), options) says.
Overlap overlap(const PlacedBody& a, const PlacedBody& b, const OverlapOptions& options = {});

/// Returns what closer_than(moved(a), moved(b), distance, options) says.
Closeness closer_than(const PlacedBody& a, const PlacedBody& b, const mpq_class& distance,
                      const OverlapOptions& options = {});

}  // namespace fathom
