// SPDX-License-Identifier: GPL-3.0-or-later
// Readers are fuzzed without what cuts meshes, which needs CGAL and has tests of its own: a case
// with a solid is read, and refused.
#include <stdexcept>

#include "fathom/solid.hpp"

namespace fathom {

Body solid_body(const Body&) { throw std::invalid_argument("the mesh is not cut here"); }

}  // namespace fathom
