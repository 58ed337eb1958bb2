// SPDX-License-Identifier: GPL-3.0-or-later
// The ways in which a case is made smaller. Each offers candidates to the search, which rejects larger and invalid ones. Not a door.
#pragma once

#include "verify/harness/shrink/search.hpp"

namespace fathom::harness {

/// All points that are not extreme, of both bodies or of one; then chunks of points, ever smaller, down to single ones (ddmin).
void drop_points(Search& search);

/// Both bodies moved so that a vertex, or a centre, lies at the origin; what is not exact then is rounded.
void move_to_origin(Search& search);

/// Times a power of two: to about 1, or to integers.
void rescale(Search& search);

/// All coordinates to small integers, to few bits in their own scale, or those of one body, or on one axis.
void round_together(Search& search);

/// Value by value on each axis, wherever it occurs, then coordinate by coordinate: 0, a value that is there already, an integer, fewer
/// bits, half as much.
void simplify_values(Search& search);

/// Of cases with bodies by name, in the place of all others: margins, terms and vertices dropped, turns and places taken back, lengths to
/// small integers, and then number by number.
void simplify_shapes(Search& search);

}  // namespace fathom::harness
