// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/quick_number.hpp"

#include <cfenv>
#include <charconv>
#include <cmath>

namespace fathom::kernels {

// std::from_chars rounds correctly, but some of its shortcuts follow the rounding mode that an interval filter may have set.
// Falls back to parse_number for inf, nan, integers over 64 bits and underflow.
bool quick_number(std::string_view token, Decimals decimals, mpq_class& value) {
  constexpr std::size_t short_enough = 64;
  if (token.size() > short_enough) return false;
  const char* const end = token.data() + token.size();
  long integer = 0;
  const auto [stop, fault] = std::from_chars(token.data(), end, integer);
  if (fault == std::errc() && stop == end) {
    value = integer;
    return true;
  }
  if (decimals != Decimals::binary64 || token.find_first_of(".eE") == std::string_view::npos) return false;
  double nearest = 0;
  const auto [double_stop, double_fault] = std::from_chars(token.data(), end, nearest);
  if (double_fault != std::errc() || double_stop != end || !std::isfinite(nearest) || std::fegetround() != FE_TONEAREST) return false;
  value = exact_value(nearest);
  return true;
}

}  // namespace fathom::kernels
