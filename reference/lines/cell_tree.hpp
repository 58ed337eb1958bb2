// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of one chain: contiguous runs of the grid's order, halved again and again. Stores only the frames that were asked for.
#pragma once

#include <array>
#include <bit>
#include <numeric>
#include <vector>

#include "kernels/filters/corner_bound.hpp"
#include "kernels/filters/line_frame.hpp"

namespace fathom::lines {

/// The images of the lines must outlive it.
class CellTree {
 public:
  /// Heap order: 1 is the whole chain, 2k and 2k + 1 are the halves of k.
  using Node = std::uint64_t;
  static constexpr Node root = 1;

  explicit CellTree(const kernels::LineImages& lines) : lines_(&lines), order_(lines.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
  }

  [[nodiscard]] kernels::LineRun run(Node k) const {
    const Node level = std::bit_floor(k), place = k - level;
    return {static_cast<std::size_t>(place * order_.size() / level), static_cast<std::size_t>((place + 1) * order_.size() / level)};
  }
  [[nodiscard]] std::size_t size(Node k) const { return run(k).size(); }
  [[nodiscard]] std::span<const std::uint32_t> lines(Node k) const {
    const kernels::LineRun r = run(k);
    return std::span(order_).subspan(r.first, r.size());
  }

  /// The frame of all lines of the cell. Linear in them when first asked for.
  [[nodiscard]] const kernels::LineFrame& frame(Node k) {
    return frames_.of(k, [&] { return kernels::line_frame(*lines_, lines(k)); });
  }
  /// The frame of a few of them. A cheap pre-test: if the sketch does not clear, the full frame almost never does.
  [[nodiscard]] const kernels::LineFrame& sketch(Node k) {
    return sketches_.of(k, [&] {
      std::array<std::uint32_t, sketched> some;
      const kernels::LineRun r = run(k);
      for (std::size_t i = 0; i < sketched; ++i) some[i] = static_cast<std::uint32_t>(r.first + i * (r.size() - 1) / (sketched - 1));
      return kernels::line_frame(*lines_, some);
    });
  }

 private:
  static constexpr std::size_t sketched = 9;

  // Frames by node, made on demand.
  struct Frames {
    std::vector<std::uint32_t> place;  // one more than the index of the node's frame, or 0
    std::vector<kernels::LineFrame> made;

    const kernels::LineFrame& of(Node k, const auto& make) {
      if (k >= place.size()) place.resize(std::bit_ceil(k + 1), 0);
      if (place[k] == 0) {
        made.push_back(make());
        place[k] = static_cast<std::uint32_t>(made.size());
      }
      return made[place[k] - 1];
    }
  };

  const kernels::LineImages* lines_;
  std::vector<std::uint32_t> order_;
  Frames frames_, sketches_;
};

}  // namespace fathom::lines
