// SPDX-License-Identifier: GPL-3.0-or-later
// Two shapes and a certificate: what is true of them, as far as the certificate proves it.
#pragma once

#include <string_view>

#include "verify/golden/shapes/shape_facts.hpp"

namespace fathom::golden {

/// Returns the truth that the certificate proves: value, directions and cone are its own, and translations follow from the bodies by the
/// definitions. Throws NotProved unless the checker accepts it, it has the id of these shapes and is about them, and agrees with what is
/// known of the answer by construction.                                                                              [proofs/golden.md]
ShapeStatement proved_truth(const families::ShapeCase& shapes, std::string_view certificate);

}  // namespace fathom::golden
