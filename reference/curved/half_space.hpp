// SPDX-License-Identifier: GPL-3.0-or-later
// A half-space and a curved core: one support is the answer, from both sides.
#pragma once

#include "reference/curved/curved_bounds.hpp"

namespace fathom::curved {

/// `plane` is the core of A or B; `radius` is that of its shape. `other` is no half-space.
CurvedBounds half_space_bounds(kernels::Context& context, const HalfSpace& plane, const Shape& other, bool plane_is_a,
                               const mpq_class& radius, unsigned bits);

}  // namespace fathom::curved
