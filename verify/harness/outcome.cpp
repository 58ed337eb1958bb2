// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/outcome.hpp"

#include <string_view>

namespace fathom::harness {
namespace {

/// How many of the last characters are digits.
std::size_t digits_behind(std::string_view text) {
  const std::size_t last = text.find_last_not_of("0123456789");
  return last == text.npos ? text.size() : text.size() - last - 1;
}

/// `text` without "<mark><digits>" at its end; empty if it does not end so.
std::string_view before_number(std::string_view text, std::string_view mark) {
  const std::size_t digits = digits_behind(text);
  const std::string_view rest = text.substr(0, text.size() - digits);
  return digits > 0 && rest.ends_with(mark) ? rest.substr(0, rest.size() - mark.size()) : std::string_view();
}

}  // namespace

std::string family_of(const std::string& id) {
  if (const std::size_t colons = id.find("::"); colons != std::string::npos) return id.substr(0, colons);
  return std::string(before_number(before_number(id, "-s"), "-n"));
}

}  // namespace fathom::harness
