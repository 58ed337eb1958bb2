// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many cases to take, so that every family has its share.
#pragma once

#include <cstddef>
#include <vector>

namespace fathom::golden {

/// How many to take of each group, of which so many are there: `count` in all, or all if that is fewer. No group gets two more than another
/// that has some left; where the last round does not reach all of them, those that it reaches lie evenly in the order of the groups.
std::vector<std::size_t> shares(const std::vector<std::size_t>& sizes, std::size_t count);

/// `count` <= `size` numbers below `size`, ascending, evenly spaced.
std::vector<std::size_t> evenly(std::size_t count, std::size_t size);

}  // namespace fathom::golden
