// SPDX-License-Identifier: Apache-2.0
// A line of JSON Lines results that holds a certificate.                                                            [FORMAT.md, section 9]
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "certificate.hpp"

namespace fathom_check {

/// What the line says besides.
struct Result {
  std::string certificate;
  std::string id;  ///< of the result, percent-escaped; empty if it has none
  std::optional<std::string> status, depth_squared;
};

/// Throws Fault (malformed); the id may have been read by then.
void read_result(std::string_view text, std::size_t line, Result& result);

/// Throws Fault (refused) unless status and depth are those that the certificate claims.
void compare(const Result& result, const Certificate& certificate);

}  // namespace fathom_check
