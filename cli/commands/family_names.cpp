// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/family_names.hpp"

#include <algorithm>

#include "kernels/messages.hpp"
#include "verify/families/families.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t suggestions = 3, longest_name = 60;

}  // namespace

std::vector<std::string_view> family_names() {
  std::vector<std::string_view> names;
  for (const families::Family& family : families::all_families()) names.push_back(family.name);
  return names;
}

std::vector<std::string_view> nearest_families(std::string_view name, std::vector<std::string_view> names) {
  const std::string_view typed = name.substr(0, longest_name);
  const auto distance = [typed](std::string_view other) {
    return !typed.empty() && other.find(typed) != std::string_view::npos ? 0 : kernels::slips(typed, other);
  };
  std::ranges::stable_sort(names, {}, distance);
  names.resize(std::min(names.size(), suggestions));
  return names;
}

}  // namespace fathom::cli
