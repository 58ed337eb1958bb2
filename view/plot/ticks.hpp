// SPDX-License-Identifier: GPL-3.0-or-later
// Round numbers along an axis, and where values lie between its ends.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace fathom::plot {

/// How values are spread over an axis.
enum class Scale { linear, logarithmic };

/// A place on the axis; small ones have a line and no label.
struct Tick {
  double value;
  std::string label;  ///< empty: a small tick
};

/// The ends of an axis, which are round numbers, and the ticks between them, ascending.
struct Ticks {
  Scale scale;
  double low, high;  ///< low < high; both > 0 if the scale is logarithmic
  std::vector<Tick> ticks;

  /// Whether a value has a place: finite, and > 0 on a logarithmic axis.
  [[nodiscard]] bool holds(double value) const;
  /// 0 at the low end, 1 at the high end; of a value that has a place.
  [[nodiscard]] double share(double value) const;
};

/// The ticks of an axis that shows all of the values that have a place on it. About `most` of them have a label. The ends of a tight axis
/// are the extreme values themselves.
Ticks ticks_for(Scale scale, std::span<const double> values, unsigned most, bool tight = false);

/// A decimal of at most six significant digits: "0.25", "20,000"; powers of ten where that is long: "2.5·10⁷".
std::string number_text(double value);

}  // namespace fathom::plot
