// SPDX-License-Identifier: GPL-3.0-or-later
// Line charts as SVG, for viewing: places are accurate to a tenth of a pixel; exact numbers are
// shown elsewhere. Series differ by dash and by marker as well as by colour. Colours are those of
// all pictures: light, dark, and light on paper. Round numbers along an axis come first, then the
// parts of a figure, then the functions that draw it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom::plot {

/// The scale of an axis.
enum class Scale { linear, logarithmic };

/// A tick of an axis; small ones have a line and no label.
struct Tick {
  double value;
  std::string label;  ///< empty: a small tick
};

/// The ends of an axis, which are round numbers, and the ticks between them, ascending.
struct Ticks {
  Scale scale;
  double low, high;  ///< low < high; both > 0 if the scale is logarithmic
  std::vector<Tick> ticks;

  /// Returns whether a value has a place: finite, and > 0 on a logarithmic axis.
  [[nodiscard]] bool holds(double value) const;
  /// Returns 0 for the low end, 1 for the high end, and the share between them for other values
  /// that have a place.
  [[nodiscard]] double share(double value) const;
};

/// Returns the ticks of an axis for all of the values that have a place on it. About `most` ticks
/// have a label. The ends of a tight axis are the extreme values themselves.
Ticks ticks_for(Scale scale, std::span<const double> values, unsigned most, bool tight = false);

/// Returns a decimal of at most six significant digits: "0.25", "20,000"; with a power of ten if
/// that would be long: "2.5·10⁷".
std::string number_text(double value);

struct Datum {
  double x, y;
  std::string what = {};  ///< the tooltip of its mark; may be empty
};

struct Series {
  std::string name;  ///< in the legend
  /// Ascending in x. A series without places is not shown, but keeps its number, so that later ones
  /// look the same.
  std::vector<Datum> places;
  bool line = true;   ///< whether neighbours are connected
  bool marks = true;  ///< whether places have markers; of very many places only some have
};

/// The area between two curves.
struct Band {
  struct Slice {
    double x, low, high;
  };
  std::string name;           ///< in the legend
  std::vector<Slice> slices;  ///< ascending in x
};

struct ChartAxis {
  std::string name;
  Scale scale = Scale::linear;
  bool tight = false;  ///< whether the axis ends at the extreme values
};

/// One pair of axes, with its legend below.
struct CurvePanel {
  std::string title;  ///< may be empty
  ChartAxis x, y;
  std::vector<Series> series;
  std::optional<Band> band = std::nullopt;
  bool from_zero = true;               ///< whether a linear y axis always includes 0
  std::string above = {}, below = {};  ///< the meaning of values above 0 and below it, on a linear axis; may be empty
};

/// Panels one below the other.
struct Figure {
  std::string title, description;  ///< also for those who cannot see the figure
  std::string prefix = "plot";     ///< begins all ids: two figures in one page need different prefixes
  std::vector<CurvePanel> panels;
};

/// The number of different looks of series; they repeat after that.
inline constexpr unsigned distinct_looks = 6;

/// Returns an SVG element for a page with chart_style. Foreign texts are escaped. Values without a
/// place on an axis are omitted, lines are interrupted there, and a sentence below the panel gives
/// their number.
std::string figure_element(const Figure& figure);
/// Returns the same as a file with its style.
std::string figure_file(const Figure& figure);
/// Returns the rules of charts in pages, in the colours of view/picture/markup.hpp.
std::string chart_style();

/// Returns the exponent e of the power y = c x^e that fits best, by least squares of the
/// logarithms. Returns nullopt unless there are two different x with positive values.
std::optional<double> growth_exponent(std::span<const Datum> places);

}  // namespace fathom::plot
