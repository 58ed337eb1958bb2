// SPDX-License-Identifier: GPL-3.0-or-later
// Line charts as SVG, for looking at: numbers are placed to a tenth of a pixel, and the exact ones
// stand elsewhere. Series differ by dash and by marker as well as by colour. Colours are those of
// all pictures: light, dark, on paper as light ones. Round numbers along an axis come first, then
// what a figure is made of, then the door.
#pragma once

#include <optional>
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

/// The ticks of an axis that shows all of the values that have a place on it. About `most` of them
/// have a label. The ends of a tight axis are the extreme values themselves.
Ticks ticks_for(Scale scale, std::span<const double> values, unsigned most, bool tight = false);

/// A decimal of at most six significant digits: "0.25", "20,000"; powers of ten where that is long:
/// "2.5·10⁷".
std::string number_text(double value);

struct Datum {
  double x, y;
  std::string what = {};  ///< what a pointer that rests on its mark is told; may be empty
};

struct Series {
  std::string name;  ///< in the legend
  /// ascending in x; none: it is not shown, but those after it have the looks that they would have
  std::vector<Datum> places;
  bool line = true;   ///< whether neighbours are joined
  bool marks = true;  ///< whether places have markers: of very many, only some
};

/// What lies between two curves.
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
  bool tight = false;  ///< whether it ends at the extreme values
};

/// One pair of axes, with its legend below.
struct CurvePanel {
  std::string title;  ///< may be empty
  ChartAxis x, y;
  std::vector<Series> series;
  std::optional<Band> band = std::nullopt;
  bool from_zero = true;               ///< whether a linear y axis shows 0 wherever the values are
  std::string above = {}, below = {};  ///< what it means to be above 0 and below it, on a linear axis; may be empty
};

/// Panels one below the other.
struct Figure {
  std::string title, description;  ///< for those who do not see it, too
  std::string prefix = "plot";     ///< begins all ids: those of two figures in one page must differ
  std::vector<CurvePanel> panels;
};

/// How many series have a look of their own; those after them begin again.
inline constexpr unsigned distinct_looks = 6;

/// An SVG element that stands in a page with chart_style. Texts of others are escaped. Values
/// without a place on an axis are left out, lines are broken there, and a sentence below the panel
/// counts them.
std::string figure_element(const Figure& figure);
/// The same as a file with its style.
std::string figure_file(const Figure& figure);
/// The rules of charts in pages, which have the colours of view/picture/style.hpp.
std::string chart_style();

/// The exponent e of the power y = c x^e that fits best, by least squares of the logarithms.
/// Returns nullopt unless there are two different x with positive values.
std::optional<double> growth_exponent(std::span<const Datum> places);

}  // namespace fathom::plot
