// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/pair_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/unions/separating.hpp"

namespace fathom::unions {
namespace {

// Bounds on errors, in any rounding mode.             [proofs/unions.md, "Pairs on demand"]
constexpr double of_distance = 0x1p-46;  // of a distance of boxes, relative

}  // namespace

RankedPairs::RankedPairs(const BoxTree& a, const BoxTree& b, const Vec3<double>& at, bool all)
    : a_(a), b_(b), at_{at.x, at.y, at.z}, error_(margin_error(at)), all_(all) {
  push(a.root, b.root);
}

bool RankedPairs::comes_after(const Block& x, const Block& y) {
  if (x.bound != y.bound) return x.bound < y.bound;
  return std::pair(x.first_a, x.first_b) > std::pair(y.first_a, y.first_b);
}

// That of a pair in two nodes is at most theirs, also as computed. What is not a number bounds
// nothing.
double RankedPairs::bound(const BoxTree::Node& a, const BoxTree::Node& b) const {
  if (all_) return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity(), gaps = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double half = (a.widest[k] + b.widest[k]) / 2;
    for (const double margin : {b.high[k] - a.low[k] - at_[k], at_[k] - (b.low[k] - a.high[k]), half}) {
      const double raised = margin + error_;
      if (raised < least) least = raised;
      if (raised < 0) gaps += raised * raised;
    }
  }
  return least < 0 ? -(std::sqrt(gaps) * (1 - of_distance)) : least;
}

void RankedPairs::push(std::uint32_t node_a, std::uint32_t node_b) {
  const BoxTree::Node &a = a_.nodes[node_a], &b = b_.nodes[node_b];
  heap_.push_back({bound(a, b), a.first, b.first, node_a, node_b});
  std::push_heap(heap_.begin(), heap_.end(), comes_after);
}

std::optional<RankedPair> RankedPairs::next() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), comes_after);
    const Block block = heap_.back();
    heap_.pop_back();
    const BoxTree::Node &a = a_.nodes[block.node_a], &b = b_.nodes[block.node_b];
    if (a.is_leaf() && b.is_leaf()) return RankedPair{block.bound, block.first_a, block.first_b};
    if (b.is_leaf() || (!a.is_leaf() && a.size() >= b.size())) {
      push(a.left, block.node_b);
      push(a.right, block.node_b);
    } else {
      push(block.node_a, b.left);
      push(block.node_a, b.right);
    }
  }
  return std::nullopt;
}

template <class Numbers>
PairTableIn<Numbers>::PairTableIn(const PlacedPieces& pieces, bool all)
    : pieces_(pieces), tree_a_(pieces.a), tree_b_(pieces.b), all_(all) {}

template <class Numbers>
typename PairTableIn<Numbers>::Pair* PairTableIn<Numbers>::find(const RankedPair& ranked, const Place& p) {
  if (ranked.bound < 0) return nullptr;
  const auto& [bound, i, j] = ranked;
  Entry& entry = entries_[std::uint64_t{i} * pieces_.b.size() + j];
  if (!entry.pair) {
    if (!all_ && surely_apart({{&pieces_.a[i], 1}, {&pieces_.b[j], 1}}, p.image, 0, entry.separating)) return nullptr;
    entry.pair = std::make_unique<Pair>(pieces_, i, j);
    ++made_;
  }
  return entry.pair.get();
}

template <class Numbers>
bool PairTableIn<Numbers>::has(const RankedPair& pair) const {
  const auto entry = entries_.find(std::uint64_t{pair.a} * pieces_.b.size() + pair.b);
  return entry != entries_.end() && entry->second.pair;
}

template class PairTableIn<kernels::AnyNumbers>;
template class PairTableIn<kernels::FixedNumbers>;

}  // namespace fathom::unions
