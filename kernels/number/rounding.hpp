// SPDX-License-Identifier: GPL-3.0-or-later
// All roundings of one number at once, and numbers in hexadecimal, for results that print them.
//                                                                                [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <string>

namespace fathom::kernels {

template <class Float>
struct EveryMode {
  Float rn, rd, ru;
  friend bool operator==(const EveryMode&, const EveryMode&) = default;
};

struct Roundings {
  EveryMode<double> binary64;
  EveryMode<float> binary32;
};

/// Returns what round_binary64 and round_binary32, the naive twins, say in each mode, by one
/// division.
Roundings roundings(const mpq_class& value);

/// Returns what root_binary64 and root_binary32, the naive twins, say in each mode, by one division
/// and one integer root. Throws std::domain_error if `squared` is negative.
Roundings roundings_of_root(const mpq_class& squared);

/// Appends hex_text(value) to `text`.
void append_hex(double value, std::string& text);

}  // namespace fathom::kernels
