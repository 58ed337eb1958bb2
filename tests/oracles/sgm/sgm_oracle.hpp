// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's spherical Gaussian maps (Fogel, Halperin): the overlay of B's and -A's is the map of P,
// and its vertices are P's facets.
#pragma once

#include "tests/oracles/oracle.hpp"

namespace fathom::oracles {

/// Both bodies must have rank 3. Some hundred vertices a side; about 20 us and 2.4 KB for each
/// facet of P. The bodies' own facets come from fathom's convex hull, since CGAL's maps want
/// coplanar triangles merged. Throws std::runtime_error when a map of CGAL's is inconsistent: it
/// lacks features of the body, or has corners off their facet's plane.
OracleAnswer sgm_oracle(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::oracles
