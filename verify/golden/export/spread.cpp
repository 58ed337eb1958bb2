// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/export/spread.hpp"

namespace fathom::golden {

std::vector<std::size_t> shares(const std::vector<std::size_t>& sizes, std::size_t count) {
  std::vector<std::size_t> result(sizes.size(), 0);
  while (count > 0) {
    std::vector<std::size_t> open;
    for (std::size_t group = 0; group < sizes.size(); ++group)
      if (result[group] < sizes[group]) open.push_back(group);
    if (open.empty()) break;
    const std::size_t round = count < open.size() ? count : open.size();
    for (const std::size_t i : evenly(round, open.size())) ++result[open[i]];
    count -= round;
  }
  return result;
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t size) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back((2 * i + 1) * size / (2 * count));  // the middle of each of `count` parts
  return result;
}

}  // namespace fathom::golden
