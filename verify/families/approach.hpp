// SPDX-License-Identifier: GPL-3.0-or-later
// Almost degenerate pairs: a degenerate pair whose points are each moved by at most 2^-k.                           [docs/golden.md]
#pragma once

#include <cstdint>

#include "fathom/files.hpp"

namespace fathom::families {

/// Moves every point of both bodies by its own displacement: three random multiples of 2^-(k+20), each at most 2^-k in size. As k grows,
/// the pair tends to `degenerate`, but all coincidences are gone: parallel edges, coplanar points, ties, touching, flatness.
/// Exact, and the same on every machine. The id is "<id>-k<k>-s<seed>".
Case approach(const Case& degenerate, unsigned k, std::uint64_t seed);

}  // namespace fathom::families
