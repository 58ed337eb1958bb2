// SPDX-License-Identifier: GPL-3.0-or-later
// The histogram of errors by decade, as SVG.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/text.hpp"

namespace fathom::harness {
namespace {

constexpr int lowest = -18, highest = 18;  // decades; what lies beyond is counted in the last ones
constexpr double left = 190, top = 8, row_height = 46, bar_height = 34, chart_width = 700, gap = 3;

/// Counts of one verdict: exact zeros, and by decade.
struct Row {
  std::size_t zeros = 0, total = 0;
  std::map<int, std::size_t> decades;
};

/// floor(log10 |error|), kept within bounds; infinity is the highest.
int decade_of(double error) {
  const double exponent = std::floor(std::log10(std::abs(error)));
  return static_cast<int>(std::clamp(exponent, static_cast<double>(lowest), static_cast<double>(highest)));
}

std::map<Verdict, Row> rows_of(std::span<const Outcome> outcomes, bool in_u_r) {
  std::map<Verdict, Row> result;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.judgement) continue;
    const std::optional<double> error = in_u_r ? outcome.judgement->error_u_r : outcome.judgement->error_relative;
    if (!error || std::isnan(*error)) continue;
    Row& row = result[outcome.verdict];
    ++row.total;
    ++(*error == 0 ? row.zeros : row.decades[decade_of(*error)]);
  }
  return result;
}

/// The decades that have a place, and where: slot 0 is that of zeros.
struct Axis {
  int first, last;

  explicit Axis(const std::map<Verdict, Row>& rows) : first(highest), last(lowest) {
    for (const auto& [verdict, row] : rows) {
      if (row.decades.empty()) continue;
      first = std::min(first, row.decades.begin()->first);
      last = std::max(last, row.decades.rbegin()->first);
    }
    if (first > last) first = last = 0;
  }
  [[nodiscard]] double slot_width() const { return (chart_width - left) / (last - first + 3); }
  [[nodiscard]] double start(int decade) const { return left + slot_width() * (decade - first + 2); }  // a slot is free after the zeros
};

std::string bar(double x, double width, double ground, std::size_t count, std::size_t most, Verdict verdict, const std::string& what) {
  const double height = std::max(2.0, bar_height * static_cast<double>(count) / static_cast<double>(most));
  return fmt::format("<rect class=\"bar{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{}: {} {}</title></rect>",
                     fails(verdict) ? " failing" : "", x, ground - height, width - gap, height, name(verdict),
                     count_text(count, "case", "cases"), what);
}

std::string decade_text(int decade) {
  if (decade == lowest) return fmt::format("below 1e{}", decade + 1);
  return decade == highest ? fmt::format("from 1e{} on", decade) : fmt::format("from 1e{} to 1e{}", decade, decade + 1);
}

std::string row_elements(const Axis& axis, Verdict verdict, const Row& row, double ground) {
  std::size_t most = row.zeros;
  for (const auto& [decade, count] : row.decades) most = std::max(most, count);
  std::string result =
      fmt::format("<text x=\"0\" y=\"{0:.1f}\">{2}</text><text class=\"soft\" x=\"0\" y=\"{1:.1f}\">{3}, at most {4} in a bar</text>",
                  ground - 16, ground - 2, name(verdict), row.total, most);
  if (row.zeros > 0) result += bar(left, axis.slot_width(), ground, row.zeros, most, verdict, "with no error at all");
  for (const auto& [decade, count] : row.decades)
    result += bar(axis.start(decade), axis.slot_width(), ground, count, most, verdict, decade_text(decade));
  return result + fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n", left, chart_width, ground, ground);
}

std::string axis_elements(const Axis& axis, double ground, double tolerance) {
  const int step = axis.last - axis.first > 20 ? 3 : axis.last - axis.first > 10 ? 2 : 1;
  std::string result = fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\">0</text>", left, ground + 16);
  for (int decade = axis.first; decade <= axis.last + 1; decade += step) {
    const double x = axis.start(decade) - gap / 2;
    result += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>", x, ground, ground + 4);
    result += fmt::format("<text class=\"soft\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{}\">1e{}</text>", x, ground + 16, decade);
  }
  if (!(tolerance > 0)) return result;
  const double exponent = std::log10(tolerance);
  if (exponent < axis.first || exponent > axis.last + 1) return result;
  const double x = axis.start(axis.first) + (exponent - axis.first) * axis.slot_width() - gap / 2;
  return result +
         fmt::format(
             "<line class=\"limit\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"><title>relative tolerance {3}</title></line>", x,
             top, ground, error_text(tolerance));
}

}  // namespace

std::string histogram(std::span<const Outcome> outcomes, bool in_u_r, double tolerance) {
  const std::map<Verdict, Row> rows = rows_of(outcomes, in_u_r);
  if (rows.empty()) return "";
  const Axis axis(rows);
  const double ground = top + row_height * static_cast<double>(rows.size());
  const std::string what = in_u_r ? "in units of uR" : "relative to the depth", id = in_u_r ? "errors-u" : "errors-r";
  std::string body, described;
  double at = top;
  for (const auto& [verdict, row] : rows) {
    body += row_elements(axis, verdict, row, at += row_height);
    described += fmt::format("{}{} {}", described.empty() ? "" : ", ", row.total, name(verdict));
  }
  return fmt::format(
      "<figure><div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Errors {0}\"><svg class=\"chart\" viewBox=\"0 0 {1} {2}\" "
      "width=\"{1}\" "
      "height=\"{2}\" role=\"img\" aria-labelledby=\"{3}-t {3}-d\"><title id=\"{3}-t\">Errors of the claimed depths, {0}</title>"
      "<desc id=\"{3}-d\">Numbers of cases by verdict and by the decade of the error: {4}.</desc>\n{5}{6}</svg></div>"
      "<figcaption>Magnitudes of the errors {0}, by decade; bars are as high as cases are many, in each row for itself{7}."
      "</figcaption></figure>\n",
      what, chart_width + 20, ground + 24, id, described, body, axis_elements(axis, ground, tolerance),
      tolerance > 0 ? "; dashed: the relative tolerance" : "");
}

}  // namespace fathom::harness
