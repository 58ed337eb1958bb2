// SPDX-License-Identifier: GPL-3.0-or-later
#include <cfenv>
#include <charconv>
#include <cmath>

#include "kernels/number/parse.hpp"

namespace fathom::kernels {

// std::from_chars rounds correctly, but some of its shortcuts follow the rounding mode that an interval filter may have set.
// Falls back to parse_number for inf, nan, integers over 53 bits and underflow.
std::optional<double> quick_number(std::string_view token, Decimals decimals) {
  constexpr long exact_up_to = 1L << 53;
  constexpr std::size_t short_enough = 64;
  if (token.size() > short_enough) return std::nullopt;
  const char* const end = token.data() + token.size();
  long integer = 0;
  const auto [stop, fault] = std::from_chars(token.data(), end, integer);
  if (fault == std::errc() && stop == end) {
    const bool is_double = -exact_up_to <= integer && integer <= exact_up_to;
    return is_double ? std::optional(static_cast<double>(integer)) : std::nullopt;
  }
  if (decimals != Decimals::binary64 || token.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
  double nearest = 0;
  const auto [double_stop, double_fault] = std::from_chars(token.data(), end, nearest);
  if (double_fault != std::errc() || double_stop != end || !std::isfinite(nearest) || std::fegetround() != FE_TONEAREST)
    return std::nullopt;
  return nearest;
}

}  // namespace fathom::kernels
