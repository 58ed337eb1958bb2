// SPDX-License-Identifier: GPL-3.0-or-later
// How long things in a picture are: a bar of a round length, whose number is exact.
#pragma once

#include <gmpxx.h>

#include <string>

namespace fathom::picture {

/// A length of one digit, 1, 2 or 5, and a power of ten.
struct RoundLength {
  mpq_class value;
  std::string text;  ///< "0.05", "200"; "2e-7" where that is shorter
};

/// The greatest that is not above `most` > 0.
RoundLength round_length(const mpq_class& most);

}  // namespace fathom::picture
