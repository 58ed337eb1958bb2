// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of one chain: contiguous runs of the grid's order, halved again and again. Their frames are made only when asked for.
#pragma once

#include <array>
#include <bit>
#include <deque>
#include <numeric>
#include <span>
#include <vector>

#include "kernels/filters/line_filter.hpp"
#include "kernels/filters/line_frame.hpp"

namespace fathom::lines {

/// A cell. Heap order: 1 is the whole chain, 2k and 2k + 1 are the halves of k.
using CellNode = std::uint64_t;

/// Which lines the cells of a chain hold.
class CellTree {
 public:
  static constexpr CellNode root = 1;

  explicit CellTree(std::size_t lines) : order_(lines) { std::iota(order_.begin(), order_.end(), 0U); }

  [[nodiscard]] kernels::LineRun run(CellNode k) const {
    const CellNode level = std::bit_floor(k), place = k - level;
    return {static_cast<std::size_t>(place * order_.size() / level), static_cast<std::size_t>((place + 1) * order_.size() / level)};
  }
  [[nodiscard]] std::size_t size(CellNode k) const { return run(k).size(); }
  [[nodiscard]] std::span<const std::uint32_t> lines(CellNode k) const {
    const kernels::LineRun r = run(k);
    return std::span(order_).subspan(r.first, r.size());
  }

 private:
  std::vector<std::uint32_t> order_;
};

/// The frames of a chain's cells, made when they are first asked for. The tree and the lines must outlive it.
template <class Lines>
class CellFrames {
 public:
  using Frame = kernels::LineFrame<typename Lines::Number>;

  CellFrames(const CellTree& tree, const Lines& lines) : tree_(&tree), lines_(&lines) {}

  /// The frame of all lines of the cell. Linear in them when first asked for.
  [[nodiscard]] const Frame& whole(CellNode k) {
    return wholes_.of(k, [&] {
      lines_framed_ += tree_->size(k);
      return kernels::line_frame(*lines_, tree_->lines(k));
    });
  }
  /// The frame of a few of them. A cheap pre-test: if the sketch does not clear, the full frame almost never does.
  [[nodiscard]] const Frame& sketch(CellNode k) {
    return sketches_.of(k, [&] { return kernels::line_frame(*lines_, few_lines(k)); });
  }
  static constexpr std::size_t sketched = 9;
  using FewLines = std::array<std::uint32_t, sketched>;
  /// The lines of the sketch: ascending, the first and the last among them.
  [[nodiscard]] FewLines few_lines(CellNode k) const {
    FewLines few;
    const kernels::LineRun r = tree_->run(k);
    for (std::size_t i = 0; i < sketched; ++i) few[i] = static_cast<std::uint32_t>(r.first + i * (r.size() - 1) / (sketched - 1));
    return few;
  }
  /// How many lines went into the frames of whole cells so far: what these have cost.
  [[nodiscard]] std::uint64_t lines_framed() const { return lines_framed_; }

 private:
  // Frames by node, made on demand.
  struct Frames {
    std::vector<std::uint32_t> place;  // one more than the index of the node's frame, or 0
    std::deque<Frame> made;            // which stay where they are

    const Frame& of(CellNode k, const auto& make) {
      if (k >= place.size()) place.resize(std::bit_ceil(k + 1), 0);
      if (place[k] == 0) {
        made.push_back(make());
        place[k] = static_cast<std::uint32_t>(made.size());
      }
      return made[place[k] - 1];
    }
  };

  const CellTree* tree_;
  const Lines* lines_;
  Frames wholes_, sketches_;
  std::uint64_t lines_framed_ = 0;
};

}  // namespace fathom::lines
