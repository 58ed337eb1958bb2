// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "view/picture/markup.hpp"

namespace fathom::plot {
namespace {

/// A marker around the origin.
struct Shape {
  std::string_view path, fill;
};

constexpr std::array<Shape, distinct_looks> shapes{
    Shape{"m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "full"},    // a disc
    Shape{"m-3.6 -3.6h7.2v7.2h-7.2z", "full"},               // a square
    Shape{"m0 -4.8l4.6 8h-9.2z", "hollow"},                  // a triangle
    Shape{"m0 -5l5 5l-5 5l-5 -5z", "hollow"},                // a diamond
    Shape{"m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "hollow"},  // a ring
    Shape{"m-4 -4l8 8m0 -8l-8 8", "cross"},
};

constexpr double panel_width = 760, panel_margin = 12;                               // pixels
constexpr double plot_height = 300, right_room = 24, label_room = 12, letter = 7.2;  // pixels; of a letter its width
constexpr double x_label_room = 20, x_name_room = 20, legend_row = 20, legend_column = 360, title_room = 22,
                 y_name_room = 20, least_left = 90;
constexpr unsigned most_x_labels = 8, most_y_labels = 8;
constexpr std::size_t most_characters = 84;  // of a line of text
constexpr std::size_t most_marks = 64, marks_of_many = 32;

/// Returns the marker of series number `series`; with a title if `what` is not empty.
std::string mark_element(std::size_t series, double x, double y, const std::string& what) {
  const std::size_t look = series % distinct_looks;
  const std::string start = fmt::format("<path class=\"mark {} look-{}\" d=\"M{:.1f} {:.1f}{}\"", shapes[look].fill,
                                        look, x, y, shapes[look].path);
  return what.empty() ? start + "/>" : fmt::format("{}><title>{}</title></path>", start, picture::markup(what));
}

/// Returns the classes of the line of series number `series`: colour and dash.
std::string line_classes(std::size_t series) {
  const std::size_t look = series % distinct_looks;
  return look == 0 ? "look-0" : fmt::format("look-{0} dash-{0}", look);
}

std::size_t characters(const std::string& text) {  // of UTF-8
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80; }));
}

/// Returns the text as markup, cut if it would not fit into the figure.
std::string fitting(const std::string& text) {
  if (characters(text) <= most_characters) return picture::markup(text);
  std::size_t end = 0;
  for (std::size_t count = 0; count < most_characters || (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80; ++end)
    count += (static_cast<unsigned char>(text[end]) & 0xc0U) != 0x80 ? 1 : 0;
  return picture::markup(text.substr(0, end)) + "...";
}

/// The mapping of values to places in the panel.
struct Field {
  Ticks x, y;
  double left = 0, top = 0, right = panel_width - right_room, bottom = 0;

  [[nodiscard]] bool holds(double u, double v) const { return x.holds(u) && y.holds(v); }
  [[nodiscard]] double across(double u) const { return left + x.share(u) * (right - left); }
  [[nodiscard]] double down(double v) const { return bottom - y.share(v) * (bottom - top); }
};

Field field_of(const CurvePanel& panel) {
  std::vector<double> across, up;
  const auto add = [&](double x, double y) {
    across.push_back(x);
    up.push_back(y);
  };
  for (const Series& series : panel.series)
    for (const Datum& place : series.places) add(place.x, place.y);
  if (panel.band)
    for (const Band::Slice& slice : panel.band->slices) add(slice.x, slice.low), add(slice.x, slice.high);
  if (panel.y.scale == Scale::linear && panel.from_zero)
    up.push_back(0);  // 0 is always visible, so that both sides of it can be seen
  Field field{ticks_for(panel.x.scale, across, most_x_labels, panel.x.tight),
              ticks_for(panel.y.scale, up, most_y_labels, panel.y.tight)};
  std::size_t longest = 0;
  for (const Tick& tick : field.y.ticks) longest = std::max(longest, characters(tick.label));
  field.left = std::max(least_left, panel_margin + y_name_room + letter * static_cast<double>(longest) + label_room);
  field.top = panel.title.empty() ? 8 : title_room + 8;
  field.bottom = field.top + plot_height;
  return field;
}

std::string grid_elements(const CurvePanel& panel, const Field& field) {
  std::string lines, texts;
  const auto style = [](const Tick& tick) { return tick.label.empty() ? "grid small" : "grid"; };
  for (const Tick& tick : field.x.ticks) {
    const double x = field.across(tick.value);
    lines += fmt::format("<line class=\"{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{3:.1f}\"/>\n",
                         style(tick), x, field.top, field.bottom);
    if (!tick.label.empty())
      texts += fmt::format("<text class=\"soft\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x,
                           field.bottom + 16, tick.label);
  }
  for (const Tick& tick : field.y.ticks) {
    const double y = field.down(tick.value);
    lines += fmt::format("<line class=\"{0}\" x1=\"{2:.1f}\" x2=\"{3:.1f}\" y1=\"{1:.1f}\" y2=\"{1:.1f}\"/>\n",
                         style(tick), y, field.left, field.right);
    if (!tick.label.empty())
      texts += fmt::format("<text class=\"soft\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                           field.left - 6, y + 4, tick.label);
  }
  lines += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                       field.left, field.top, field.right - field.left, field.bottom - field.top);
  const double middle = (field.top + field.bottom) / 2, turn = panel_margin + 8;
  texts += fmt::format("<text text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                       (field.left + field.right) / 2, field.bottom + x_label_room + 15, fitting(panel.x.name));
  texts += fmt::format("<text text-anchor=\"middle\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\">{}</text>\n",
                       turn, middle, picture::markup(panel.y.name));
  return lines + texts;
}

/// Returns the line at 0 and the labels of its two sides.
std::string zero_elements(const CurvePanel& panel, const Field& field) {
  if (panel.y.scale != Scale::linear || field.y.low > 0 || field.y.high < 0) return "";
  const double y = field.down(0);
  std::string result =
      fmt::format("<line class=\"zero\" x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n", field.left,
                  field.right, y);
  const auto side = [&](const std::string& text, double at) {
    if (!text.empty())
      result += fmt::format("<text class=\"soft\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                            field.right - 6, at, picture::markup(text));
  };
  if (y - field.top > legend_row) side(panel.above, y - 6);
  if (field.bottom - y > legend_row) side(panel.below, y + 15);
  return result;
}

std::string band_element(const Band& band, const Field& field) {
  std::string there, back;
  for (const Band::Slice& slice : band.slices) {
    if (!field.holds(slice.x, slice.low) || !field.holds(slice.x, slice.high)) continue;
    there += fmt::format("{}{:.1f} {:.1f}", there.empty() ? "M" : "L", field.across(slice.x), field.down(slice.high));
    back.insert(0, fmt::format("L{:.1f} {:.1f}", field.across(slice.x), field.down(slice.low)));
  }
  return there.empty() ? "" : fmt::format("<path class=\"band\" d=\"{}{}Z\"/>\n", there, back);
}

std::string series_elements(const Series& series, std::size_t number, const Field& field) {
  std::string path, marks;
  bool open = false;
  const std::size_t every =
      series.places.size() <= most_marks ? 1 : (series.places.size() + marks_of_many - 1) / marks_of_many;
  for (std::size_t i = 0; i < series.places.size(); ++i) {
    const Datum& place = series.places[i];
    const bool drawn = field.holds(place.x, place.y);
    if (drawn) {
      const double x = field.across(place.x), y = field.down(place.y);
      path += fmt::format("{}{:.1f} {:.1f}", open ? "L" : "M", x, y);
      if (series.marks && (i % every == 0 || !series.line)) marks += mark_element(number, x, y, place.what) + "\n";
    }
    open = drawn;
  }
  if (!series.line || path.empty()) return marks;
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n{}", line_classes(number), path, marks);
}

/// Returns the legend, in rows of two entries each.
std::string legend_elements(const CurvePanel& panel, double top, double left, double& height) {
  std::string result;
  std::size_t entry = 0;
  const auto add = [&](const std::string& sample, const std::string& name) {
    const double x = left + legend_column * static_cast<double>(entry % 2),
                 y = top + legend_row * static_cast<double>(entry / 2);
    result += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"46\" y=\"4\">{}</text></g>\n", x, y,
                          sample, picture::markup(name));
    ++entry;
  };
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    if (panel.series[i].places.empty()) continue;
    std::string sample = panel.series[i].line ? fmt::format("<path class=\"{}\" d=\"M0 0H38\"/>", line_classes(i)) : "";
    if (panel.series[i].marks) sample += mark_element(i, 19, 0, "");
    add(sample, panel.series[i].name);
  }
  if (panel.band) add("<path class=\"band\" d=\"M0 -6H38V6H0Z\"/>", panel.band->name);
  height = legend_row * static_cast<double>((entry + 1) / 2);
  return result;
}

/// Returns a sentence on the values without a place on the axes.
std::string left_out(const CurvePanel& panel, const Field& field) {
  std::size_t count = 0;
  for (const Series& series : panel.series)
    count += static_cast<std::size_t>(
        std::ranges::count_if(series.places, [&](const Datum& p) { return !field.holds(p.x, p.y); }));
  if (count == 0) return "";
  const bool logarithmic = panel.x.scale == Scale::logarithmic || panel.y.scale == Scale::logarithmic;
  return fmt::format("Not drawn: {} value{}, {}.", count, count == 1 ? "" : "s",
                     logarithmic ? "0 or below, or too large for the axis" : "unknown, or beyond binary64");
}

/// The elements of a panel, with its upper left corner at the origin.
struct PanelPicture {
  std::string content;
  double height;
};

/// Returns one panel of a figure. `clip` is the id of its clipping path.
PanelPicture panel_picture(const CurvePanel& panel, const std::string& clip) {
  const Field field = field_of(panel);
  std::string content;
  if (!panel.title.empty())
    content += fmt::format("<text class=\"panel\" x=\"{}\" y=\"16\">{}</text>\n", panel_margin, fitting(panel.title));
  content += grid_elements(panel, field) + zero_elements(panel, field);
  content += fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n",
      picture::markup(clip), field.left - 6, field.top - 6, field.right - field.left + 12,
      field.bottom - field.top + 12);
  content += fmt::format("<g clip-path=\"url(#{})\">\n", picture::markup(clip));
  if (panel.band) content += band_element(*panel.band, field);
  for (std::size_t i = 0; i < panel.series.size(); ++i) content += series_elements(panel.series[i], i, field);
  content += "</g>\n";
  double height = 0, y = field.bottom + x_label_room + x_name_room + legend_row;
  content += legend_elements(panel, y, field.left, height);
  y += height;
  if (const std::string note = left_out(panel, field); !note.empty()) {
    content += fmt::format("<text class=\"soft\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", field.left, y + 4, note);
    y += legend_row;
  }
  return {content, y};
}

/// "@name" stands for a colour of that name.
constexpr std::string_view rules = R"(
svg.plot{max-width:100%;height:auto}
svg.plot .ground{fill:@ground}
svg.plot text{fill:@ink;font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;font-size:13px}
svg.plot .title{font-size:16px;font-weight:600}
svg.plot .panel{font-weight:600}
svg.plot .soft{fill:@soft;font-size:12px}
svg.plot .grid{stroke:@line}
svg.plot .small{stroke-opacity:.45}
svg.plot .frame{fill:none;stroke:@soft}
svg.plot .zero{stroke:@ink;stroke-width:1.2}
svg.plot path{fill:none;stroke-width:2;stroke-linejoin:round}
svg.plot .mark{stroke-width:1.6}
svg.plot .hollow{fill:@ground}
svg.plot .look-0{stroke:@a}
svg.plot .look-1{stroke:@b}
svg.plot .look-2{stroke:@true}
svg.plot .look-3{stroke:@claimed}
svg.plot .look-4{stroke:@lit}
svg.plot .look-5{stroke:@ink}
svg.plot .full.look-0{fill:@a}
svg.plot .full.look-1{fill:@b}
svg.plot .full.look-2{fill:@true}
svg.plot .full.look-3{fill:@claimed}
svg.plot .full.look-4{fill:@lit}
svg.plot .full.look-5{fill:@ink}
svg.plot .band{fill:@a;fill-opacity:.18;stroke:none}
svg.plot .dash-1{stroke-dasharray:8 4}
svg.plot .dash-2{stroke-dasharray:2 3}
svg.plot .dash-3{stroke-dasharray:10 3 2 3}
svg.plot .dash-4{stroke-dasharray:14 5}
svg.plot .dash-5{stroke-dasharray:5 2}
)";

constexpr double heading_room = 34, panel_gap = 22;

struct Drawn {
  std::string content;
  double height;
};

Drawn drawn(const Figure& figure) {
  std::string content;
  double y = heading_room;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const PanelPicture picture = panel_picture(figure.panels[i], fmt::format("{}-clip{}", figure.prefix, i));
    content += fmt::format("<g transform=\"translate(0 {:.1f})\">\n{}</g>\n", y, picture.content);
    y += picture.height + panel_gap;
  }
  return {content, y - panel_gap};
}

/// Returns the SVG element. `style`: the style element of a file; empty on a page.
std::string figure_svg(const Figure& figure, const std::string& style) {
  const Drawn picture = drawn(figure);
  const double height = std::ceil(picture.height);
  const std::string ground = fmt::format(
      "<rect class=\"ground\" width=\"{}\" height=\"{}\"/>\n<text class=\"title\" x=\"{}\" y=\"22\">{}</text>\n",
      panel_width, height, panel_margin, fitting(figure.title));
  return picture::svg_element({"plot", panel_width, height, picture::markup(figure.prefix),
                               picture::markup(figure.title), picture::markup(figure.description), !style.empty()},
                              style + ground + picture.content);
}

constexpr double smallest_plain = 1e-4, largest_plain = 1e6;  // shown without a power of ten
constexpr int digits = 6;
constexpr double least_span = 1e-9;  // of an axis, as a share of its values: below it doubles are too coarse for ticks
constexpr double least_size = 1e-290;  // of an axis: below it steps are subnormal
constexpr double least_logarithmic = 1e-300, most_logarithmic = 1e300;
constexpr std::array round_steps{1.0, 2.0, 5.0};

double power(int exponent) { return std::pow(10.0, exponent); }

std::string superscript(int value) {
  constexpr std::array<std::string_view, 10> figures{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = value < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(value))) result += figures[static_cast<std::size_t>(c - '0')];
  return result;
}

/// Returns "12,345.5": the figures before the point in groups of three.
std::string grouped(std::string text) {
  const std::size_t point = std::min(text.find('.'), text.size()), first = text.starts_with('-') ? 1 : 0;
  for (std::size_t at = point; at > first + 3;) text.insert(at -= 3, 1, ',');
  return text;
}

/// Returns "1.2e+07" with a power of ten.
std::string scientific(double value, int precision) {
  std::string mantissa = fmt::format("{:.{}e}", value, precision);
  const std::size_t e = mantissa.find('e');
  const int exponent = std::stoi(mantissa.substr(e + 1));
  mantissa.resize(e);
  if (mantissa.find('.') != std::string::npos) {
    while (mantissa.ends_with('0')) mantissa.pop_back();
    if (mantissa.ends_with('.')) mantissa.pop_back();
  }
  const std::string tail = "10" + superscript(exponent);
  if (mantissa == "1" || mantissa == "-1") return (value < 0 ? "-" : "") + tail;
  return mantissa + "·" + tail;
}

bool is_plain(double magnitude) { return magnitude == 0 || (magnitude >= smallest_plain && magnitude < largest_plain); }

/// Returns a label with as many decimals as the step has, so that neighbouring labels differ.
std::string linear_label(double value, int exponent, double largest) {
  if (value == 0) return "0";
  if (is_plain(largest) && exponent >= -digits) return grouped(fmt::format("{:.{}f}", value, std::max(0, -exponent)));
  const int top = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return scientific(value, std::clamp(top - exponent, 0, std::numeric_limits<double>::digits10));
}

Ticks linear_ticks(double low, double high, unsigned most, bool tight) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(high - low > std::max(least_span * size, least_size))) {
    const double half = size == 0 ? 0.5 : std::max(size * 0.05, least_size);
    low = std::max(low - half, -std::numeric_limits<double>::max());
    high = std::min(high + half, std::numeric_limits<double>::max());
    tight = false;
  }
  const double wanted = high / most - low / most;  // each divided on its own, because the difference may overflow
  int exponent = static_cast<int>(std::floor(std::log10(wanted)));
  double factor = 10;
  for (const double round : round_steps)
    if (factor == 10 && round * power(exponent) >= wanted * (1 - least_span)) factor = round;
  if (factor == 10) factor = 1, ++exponent;
  const double step = factor * power(exponent);
  const double first = tight ? std::ceil(low / step - least_span) : std::floor(low / step + least_span);
  const double last = tight ? std::floor(high / step + least_span) : std::ceil(high / step - least_span);
  Ticks result{Scale::linear, tight ? low : first * step, tight ? high : last * step, {}};
  for (double k = first; k <= last; ++k) {
    const double value = k == 0 ? 0 : k * step;  // no -0
    if (std::isfinite(value)) result.ticks.push_back({value, linear_label(value, exponent, size)});
  }
  result.low = std::max(result.low, -std::numeric_limits<double>::max());
  result.high = std::min(result.high, std::numeric_limits<double>::max());
  return result;
}

/// Return the largest of 1, 2, 5 times a power of ten that is at most the value; and the least that
/// is at least the value.
double round_below(double value) {
  const double decade = power(static_cast<int>(std::floor(std::log10(value) + least_span)));
  double result = decade;
  for (const double step : round_steps)
    if (step * decade <= value * (1 + least_span)) result = step * decade;
  return result;
}
double round_above(double value) {
  const double decade = power(static_cast<int>(std::floor(std::log10(value) + least_span)));
  for (const double step : round_steps)
    if (step * decade >= value * (1 - least_span)) return step * decade;
  return 10 * decade;
}

/// Returns the least of 1, 2, 5, 10, 20, ... that is at least the count.
int round_count(int count) {
  for (int unit = 1;; unit *= 10)
    for (const int factor : {1, 2, 5})
      if (factor * unit >= count) return factor * unit;
}

Ticks logarithmic_ticks(double low, double high, unsigned most, bool tight) {
  if (!tight || !(high > low * (1 + least_span))) {
    low = round_below(low);
    high = round_above(high);
    if (high <= low * (1 + least_span)) high = round_above(low * 1.5), low = round_below(low / 1.5);
  }
  Ticks result{Scale::logarithmic, low, high, {}};
  const int first = static_cast<int>(std::floor(std::log10(low) - least_span)),
            last = static_cast<int>(std::ceil(std::log10(high)));
  const int decades = last - first,
            every = round_count((decades + static_cast<int>(most) - 1) / static_cast<int>(most));
  const bool labels_between = decades * 3 <= static_cast<int>(most) + 1,
             small_ticks = decades <= static_cast<int>(most);
  for (int exponent = first; exponent <= last; ++exponent)
    for (int figure = 1; figure < 10; ++figure) {
      const double value = figure * power(exponent);
      if (value < low * (1 - least_span) || value > high * (1 + least_span) || !std::isfinite(value) || value <= 0)
        continue;
      const bool labelled = figure == 1 ? exponent % every == 0 : labels_between && (figure == 2 || figure == 5);
      if (labelled || small_ticks) result.ticks.push_back({value, labelled ? number_text(value) : ""});
    }
  return result;
}

}  // namespace

std::string figure_element(const Figure& figure) { return figure_svg(figure, ""); }

std::string figure_file(const Figure& figure) {
  return figure_svg(figure,
                    fmt::format("\n<style>\n{}{}</style>\n", picture::colour_style(), picture::coloured(rules, true)));
}

std::string chart_style() { return picture::coloured(rules, false); }

std::optional<double> growth_exponent(std::span<const Datum> places) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Datum& place : places) {
    if (!(place.x > 0) || !(place.y > 0) || !std::isfinite(place.x) || !std::isfinite(place.y)) continue;
    const double u = std::log(place.x), v = std::log(place.y);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 1e-9 * n * xx)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

bool Ticks::holds(double value) const {
  if (scale == Scale::linear) return std::isfinite(value);
  return value >= least_logarithmic && value <= most_logarithmic;
}

double Ticks::share(double value) const {
  if (scale == Scale::linear) return (value / 2 - low / 2) / (high / 2 - low / 2);  // halves: no difference overflows
  return (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
}

Ticks ticks_for(Scale scale, std::span<const double> values, unsigned most, bool tight) {
  const Ticks shape{scale, 0, 0, {}};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values)
    if (shape.holds(value)) low = std::min(low, value), high = std::max(high, value);
  if (low > high) low = high = scale == Scale::linear ? 0 : 1;  // there are no values
  return scale == Scale::linear ? linear_ticks(low, high, most, tight) : logarithmic_ticks(low, high, most, tight);
}

std::string number_text(double value) {
  if (!is_plain(std::abs(value))) return scientific(value, digits - 1);
  std::string text = fmt::format("{:.{}g}", value, digits);
  return text.find('e') == std::string::npos ? grouped(std::move(text)) : text;
}

}  // namespace fathom::plot
