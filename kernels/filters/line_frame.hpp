// SPDX-License-Identifier: GPL-3.0-or-later
// The frame test: lines of a run lie near a parabola in their parameter space. A Taylor model of N - rho |w| over two such frames bounds
// all pairs of the runs at once, to third order in the runs' extent.                                              [proofs/cutting.md]
#pragma once

#include <span>

#include "kernels/filters/line_scan.hpp"

namespace fathom::kernels {

/// The lines of a run, each as six coordinates (direction D, point Q): for each line there are a positive multiple D of its direction,
/// a point Q on it and an s in [-1, 1] with |(D, Q) - (m + e s + k s^2)| <= r in every coordinate. Q avoids long ways along the lines.
struct LineFrame {
  std::array<double, 6> m{}, e{}, k{}, r{};
  bool valid = false;  ///< false when the directions of the run turn by more than an acute angle: there is no frame
};

/// The frame of the given lines, of which there is at least one, in chain order. Linear.
LineFrame line_frame(const LineImages& lines, std::span<const std::uint32_t> run);

/// True only if <q - p, w> > 0 and <q - p, w>^2 > bound |w|^2, w = d x e, for every line (p, d) of the first frame and every line (q, e)
/// of the second. `bound` is a squared distance in images, as from image_bound. False means unsure.
bool frames_beyond(const LineFrame& a, const LineFrame& b, double bound);

}  // namespace fathom::kernels
