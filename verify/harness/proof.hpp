// SPDX-License-Identifier: GPL-3.0-or-later
// The truth about a case, proved.
#pragma once

#include <string>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/judge.hpp"

namespace fathom::harness {

/// Returns the text of the certificate of an answer, which the independent checker has accepted as a proof of that very answer: of its
/// status, its depth or distance, and how many optima it has. Throws std::logic_error if the checker refuses it or finds another answer
/// proved, fathom_check::Unreadable if the text passes a limit of checkers, and Interrupted.
std::string accepted_certificate(const Case& pair, const Depth& answer, Monitor* monitor = nullptr);
/// The same for shapes: of the signed depth, or of its bounds.
std::string accepted_certificate(const std::string& id, const ShapeTruth& truth, Monitor* monitor = nullptr);
/// The same for unions: of the status, the depth and how many optima it has, or the distance.
std::string accepted_certificate(const std::string& id, const UnionTruth& truth, Monitor* monitor = nullptr);
/// The truth about a case, solved anew, and accepted.
std::string accepted_certificate(const Case& pair, Monitor* monitor);

}  // namespace fathom::harness
