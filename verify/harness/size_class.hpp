// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that every engine is made for, to be counted apart.                                              [docs/certify.md]
#pragma once

#include "fathom/files.hpp"

namespace fathom::harness {

/// Whether both bodies have a volume; exact.
bool is_solid(const Case& pair);

/// Whether the longest side of each body's box is from 1/100 to 100, in the numbers of the case: exact of points, and of shapes rounded up
/// by 2^-40 of itself at most. A half-space has any size.
bool is_metre_sized(const Case& pair);

/// Whether the length is above that of the longest side of the bodies' boxes.
bool is_dwarfed_by(const mpq_class& length, const Case& pair);

}  // namespace fathom::harness
