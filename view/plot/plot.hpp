// SPDX-License-Identifier: GPL-3.0-or-later
// Line charts as SVG, for looking at: numbers are placed to a tenth of a pixel, and the exact ones stand elsewhere.
//
// Series differ by dash and by marker as well as by colour. Colours are those of all pictures: light, dark, on paper as light ones.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom::plot {

struct Datum {
  double x, y;
  std::string what = {};  ///< what a pointer that rests on its mark is told; may be empty
};

struct Series {
  std::string name;           ///< in the legend
  std::vector<Datum> places;  ///< ascending in x; none: it is not shown, but those after it have the looks that they would have
  bool line = true;           ///< whether neighbours are joined
  bool marks = true;          ///< whether places have markers: of very many, only some
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

/// One element <svg>, for an HTML page that has plot_style() and picture::colour_style(). Texts of others are escaped. Values without a
/// place on an axis are left out, lines are broken there, and a sentence below the panel counts them.
std::string figure_element(const Figure& figure);

/// The same as a file of its own, with its style.
std::string figure_file(const Figure& figure);

/// The rules for the classes of a figure, by the colours of picture::colour_style.
std::string plot_style();

/// The exponent e of the power y = c x^e that fits best, by least squares of the logarithms. Returns nullopt unless there are two different
/// x with positive values.
std::optional<double> growth_exponent(std::span<const Datum> places);

}  // namespace fathom::plot
