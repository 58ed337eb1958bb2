// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a shape with a bounded core, and a direction.
// Output  how far it reaches there, enclosed: a sum of square roots.                                      [proofs/judge.md]
#pragma once

#include "fathom/shape.hpp"
#include "kernels/number/irrational.hpp"

namespace fathom::shapes {

/// Encloses the greatest <u,x>/|u| over the points x of the body, its radius included; every root is taken to `bits` bits. A value without
/// irrational roots is known. The shape is valid, its core is no half-space, and u is not zero.
kernels::RationalInterval support(const Shape& shape, const Point& u, unsigned bits);

}  // namespace fathom::shapes
