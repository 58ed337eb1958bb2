// SPDX-License-Identifier: Apache-2.0
// A line of JSON Lines results that holds a certificate.                     [FORMAT.md, section 9]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certificate.hpp"

namespace fathom_check {

/// What the line says besides.
struct Result {
  std::string certificate;
  std::optional<std::string> id, status;
  /// The field "squared" of a field that is there; absent if it is null.
  struct Square {
    std::optional<mpq_class> value;
  };
  std::optional<Square> depth, bound;
  std::vector<Square> distances;  ///< wherever the line says one

  /// sign sqrt(root) + plus.
  struct Exact {
    int sign = 0;
    mpq_class root, plus;
  };
  struct SignedDepth {
    std::optional<mpq_class> low, high;  ///< absent: beyond all doubles
    std::optional<Exact> exact;
  };
  std::optional<SignedDepth> signed_depth;
};

/// Throws Fault (malformed); the id may have been read by then.
void read_result(std::string_view text, std::size_t line, Result& result);

/// Throws Fault (refused) unless id, status, depth, bound, distance and signed depth are those of
/// the certificate.
void compare(const Result& result, const Certificate& certificate);

}  // namespace fathom_check
