// SPDX-License-Identifier: Apache-2.0
// The limits of a certificate, so that none, however hostile, makes a checker run out of memory or
// run for ever. They follow from the text alone: all checkers find the same texts malformed.
//                                                                            [FORMAT.md, section 8]
#pragma once

#include <cstddef>
#include <cstdint>

#include "certificate.hpp"

namespace fathom_check {

constexpr std::size_t longest_line = std::size_t{1} << 24;  ///< bytes
constexpr std::size_t longest_number = 100'000;             ///< digits

/// The limits of a certificate as a whole. All checkers have these; tests have smaller ones.
struct Limits {
  std::size_t bytes = 1'000'000'000, numbers = 10'000'000;
  std::uint64_t size = 4'000'000'000, work = 100'000'000'000'000;
};

/// Sets the common denominator of the points. Throws Fault (malformed, on `line`) if the
/// certificate is too large, or too much work.
void require_limits(Certificate& certificate, std::size_t line, const Limits& limits);

}  // namespace fathom_check
