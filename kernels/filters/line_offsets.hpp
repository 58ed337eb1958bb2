// SPDX-License-Identifier: GPL-3.0-or-later
// The offset test: where lines lie near two parabolas, but not as near as the ties between them are, each line's own distance from its
// parabola is kept, as one number. A pair's margin is that of the parabolas plus both numbers, up to what they do to each other.
// [proofs/cutting.md, Lemma 4]
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/filters/line_frame.hpp"

namespace fathom::kernels {

/// A run of lines in chain order, with its frame.
struct FramedRun {
  const WideLines& lines;
  std::span<const std::uint32_t> run;
  const LineFrame<WideFloat>& frame;
};

/// A row and a column.
using LinePair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all pairs of a row and a column that are not proved to have <q - p, w> > 0 and <q - p, w>^2 > bound |w|^2, w = d x e; nullopt if
/// they are more than `most`, or if nothing can be said. Time O(n log n) for n lines, and the pairs. `bound` is as for margin_model, and
/// `smooth` that model for the smooth frames of both runs.
std::optional<std::vector<LinePair>> pairs_left(const FramedRun& rows, const FramedRun& columns, const WideFloat& bound,
                                                const TaylorModel<WideFloat>& smooth, std::size_t most);

}  // namespace fathom::kernels
