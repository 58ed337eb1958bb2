// SPDX-License-Identifier: GPL-3.0-or-later
// All that tie for the greatest value.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace fathom::kernels {

/// Returns those of `listed` whose value is greatest, in their order. `set(value, i)` writes the value of i, a Number.
template <class Number, class Set>
std::vector<std::uint32_t> greatest(std::span<const std::uint32_t> listed, const Set& set) {
  std::vector<std::uint32_t> result;
  Number most, value;
  for (const std::uint32_t i : listed) {
    set(value, i);
    const int order = result.empty() ? 1 : cmp(value, most);
    if (order < 0) continue;
    if (order > 0) {
      result.clear();
      swap(most, value);
    }
    result.push_back(i);
  }
  return result;
}

}  // namespace fathom::kernels
