// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "view/plot/plot.hpp"

namespace fathom::plot {
namespace {

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

/// "12,345.5": the figures before the point in groups of three.
std::string grouped(std::string text) {
  const std::size_t point = std::min(text.find('.'), text.size()), first = text.starts_with('-') ? 1 : 0;
  for (std::size_t at = point; at > first + 3;) text.insert(at -= 3, ",");
  return text;
}

/// "1.2e+07" as a power of ten.
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

/// Neighbouring labels differ: as many decimals as the step has.
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
  const double wanted = high / most - low / most;  // each by itself: the difference may overflow
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

/// The largest of 1, 2, 5 times a power of ten that is not above the value; and the least that is
/// not below it.
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

/// The least of 1, 2, 5, 10, 20, ... that is not below the count.
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
  if (low > high) low = high = scale == Scale::linear ? 0 : 1;  // nothing to show
  return scale == Scale::linear ? linear_ticks(low, high, most, tight) : logarithmic_ticks(low, high, most, tight);
}

std::string number_text(double value) {
  if (!is_plain(std::abs(value))) return scientific(value, digits - 1);
  std::string text = fmt::format("{:.{}g}", value, digits);
  return text.find('e') == std::string::npos ? grouped(std::move(text)) : text;
}

}  // namespace fathom::plot
