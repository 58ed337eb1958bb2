// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/release/sums.hpp"

#include <algorithm>

namespace fathom::golden {
namespace {

constexpr std::size_t digits = 64;

bool is_plain_name(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !name.empty() && name.front() != '.' && name.find_first_not_of(letters) == std::string_view::npos;
}

}  // namespace

std::string sums_text(std::vector<Sum> sums) {
  std::ranges::sort(sums, {}, &Sum::name);
  std::string text;
  for (const Sum& sum : sums) text += sum.sha256 + "  " + sum.name + '\n';
  return text;
}

std::optional<std::vector<Sum>> parse_sums(std::string_view text) {
  std::vector<Sum> sums;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (line.size() == rest.size() || line.size() < digits + 3) return std::nullopt;
    rest.remove_prefix(line.size() + 1);
    sums.push_back({std::string(line.substr(digits + 2)), std::string(line.substr(0, digits))});
    const Sum& sum = sums.back();
    if (!is_plain_name(sum.name) || sum.sha256.find_first_not_of("0123456789abcdef") != std::string::npos) return std::nullopt;
    if (sums.size() > 1 && sums[sums.size() - 2].name >= sum.name) return std::nullopt;
  }
  if (sums_text(sums) != text) return std::nullopt;
  return sums;
}

}  // namespace fathom::golden
