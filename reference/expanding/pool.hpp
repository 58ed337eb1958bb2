// SPDX-License-Identifier: GPL-3.0-or-later
// Values that come and go, in memory that stays.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "kernels/id.hpp"

namespace fathom::expanding {

using PoolIndex = kernels::Id<struct PoolTag>;

/// Values are never constructed again: what `take` returns holds some earlier value. References stay valid until the pool is gone.
template <class T>
class Pool {
 public:
  PoolIndex take() {
    if (!free_.empty()) {
      const PoolIndex index = free_.back();
      free_.pop_back();
      return index;
    }
    if (taken_ == values_.size()) values_.emplace_back();
    return PoolIndex(static_cast<std::uint32_t>(taken_++));
  }
  void give_back(PoolIndex index) { free_.push_back(index); }
  /// Gives back all.
  void clear() {
    free_.clear();
    taken_ = 0;
  }
  T& operator[](PoolIndex index) { return values_[index.value]; }

 private:
  std::deque<T> values_;
  std::size_t taken_ = 0;  // values from here on have not been taken since the last `clear`
  std::vector<PoolIndex> free_;
};

}  // namespace fathom::expanding
