// SPDX-License-Identifier: GPL-3.0-or-later
// A judgement in one line of English.
#pragma once

#include <string>

#include "fathom/judge.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/measures.hpp"

namespace fathom::judging {

/// Which of several reasons a finding has.
struct Remarks {
  bool tolerated = false;                                  ///< the classification is wrong, within the tolerance
  bool length_sign = false, direction_sign = false;        ///< wrong, and corrected in the claim
  bool witness_a = false, witness_b = false, gap = false;  ///< off
  bool contact_a = false, contact_b = false;               ///< off
  bool price = false, deepest = false;                     ///< not the claimed length
};

/// Findings one after another, each with its numbers: depths and claims as shortest decimals, differences to four digits.
std::string sentence(const Judgement& judgement, const Measures& truth, const Reply& reply, const Claim& mended, const NumberFormat& format,
                     const Remarks& remarks);

}  // namespace fathom::judging
