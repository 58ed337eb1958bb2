// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs constructed from their contact: first the two features and the gap are chosen, then the bodies are built around them.
// Both features lie in parallel planes with normal +z (then the pair is turned): A's is A's lowest face, B's is B's highest, and
// each body widens away from it. With overlap g, h(z) = g. The features' projections along z meet.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

enum class FeatureKind { vertex, edge, face };

/// The two features touch, edges crossing transversally; `n` is the number of further points of each body, at least 4.
Bodies touching(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// Two parallel edges share a segment; the bodies lie on either side of a plane through it.
Bodies touching_parallel_edges(Random& random, unsigned n);

/// The pair of `touching` with overlap 2^-k, 4 <= k <= 40. When the features span a facet of P (an edge and an edge, or a face and
/// anything), the depth is 2^-k and this direction its only optimum.
Bodies overlapping(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// The pair of `touching` with the gap 2^-k, 4 <= k <= 60, or overlapping by it: a random one of the nine kinds.
Bodies nearly_touching(Random& random, unsigned n);

}  // namespace fathom::families
