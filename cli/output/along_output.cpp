// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/along_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/output/answer_output.hpp"
#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "reference/output/json_values.hpp"
#include "view/picture/markup.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {
namespace {

constexpr std::string_view open_status = "undecided";

std::string_view status_text(const AlongStep& step) { return step.status ? name(*step.status) : open_status; }

/// "0.25", or "[0.24, 0.26]" if there are bounds only.
std::string value_text(const AlongStep& step) {
  if (const Surd* exact = std::get_if<Surd>(&step.value)) return surd_text(*exact);
  return fmt::format("[{}, {}]", step.low, step.high);
}

/// Where a mark is drawn.
double height(const AlongStep& step) {
  if (const Surd* exact = std::get_if<Surd>(&step.value)) return round_binary64(*exact);
  return step.low / 2 + step.high / 2;
}

std::string translation_text(const Point& p) { return place_text(p, true); }

std::size_t share_columns(const Path& path) { return std::max<std::size_t>(1, 2 * std::to_string(path.steps).size() + 1); }

/// "penetrating for s from 0 to 7/16, touching at 1/2, disjoint for s from 9/16 to 1"
std::string course(const std::vector<AlongStep>& steps) {
  std::string result;
  for (std::size_t begin = 0, end = 0; begin < steps.size(); begin = end) {
    while (end < steps.size() && steps[end].status == steps[begin].status) ++end;
    const std::string first = exact_text(steps[begin].share), last = exact_text(steps[end - 1].share);
    if (!result.empty()) result += ", ";
    result += end - begin == 1 ? fmt::format("{} at s = {}", status_text(steps[begin]), first)
                               : fmt::format("{} from s = {} to {}", status_text(steps[begin]), first, last);
  }
  return result;
}

/// One series of marks for each status, in the order of Status, so that a status has the same look in all charts; those without places are
/// not shown.
std::vector<plot::Series> series_of(const std::vector<AlongStep>& steps) {
  std::vector<plot::Series> series{{"signed depth", {}, true, false}};
  for (const Status status : {Status::penetrating, Status::touching, Status::disjoint})
    series.push_back({std::string(name(status)), {}, false});
  series.push_back({std::string(open_status), {}, false});
  for (const AlongStep& step : steps) {
    const double x = step.share.get_d(), y = height(step);
    std::string what = fmt::format("s = {}: {}, {}", exact_text(step.share), value_text(step), status_text(step));
    if (step.contact) what += fmt::format(", {}", name(step.contact->kind));
    series[0].places.push_back({x, y});
    series[step.status ? 1 + static_cast<std::size_t>(*step.status) : 4].places.push_back({x, y, what});
  }
  return series;
}

}  // namespace

AlongStep along_step(std::uint32_t number, const mpq_class& share, const Depth& depth) {
  const Surd value{0, signed_square(depth)};
  const Contact* const contact = depth.contact();
  // + 0.0: a zero is no negative one
  return {number,
          share,
          depth.status(),
          value,
          round_binary64(value, Rounding::rd) + 0.0,
          round_binary64(value, Rounding::ru) + 0.0,
          depth.direction(),
          contact ? std::optional(*contact) : std::nullopt};
}

AlongStep along_step(std::uint32_t number, const mpq_class& share, const SignedDepth& depth) {
  const Contact* const contact = depth.contact();
  return {number,
          share,
          depth.status(),
          depth.value,
          depth.low_binary64(),
          depth.high_binary64(),
          depth.direction(),
          contact ? std::optional(*contact) : std::nullopt};
}

std::string along_text_header(const Path& path) {
  return fmt::format("along {}\n{:<{}}  {:<11}  {:<23}  contact", translation_text(path.translation), "s", share_columns(path), "status",
                     "signed depth");
}

std::string along_text_row(const Path& path, const AlongStep& step) {
  std::string row = fmt::format("{:<{}}  {:<11}  {:<23}", exact_text(step.share), share_columns(path), status_text(step), value_text(step));
  if (step.contact) return row + fmt::format("  {}", name(step.contact->kind));
  row.resize(row.find_last_not_of(' ') + 1);
  return row;
}

std::string along_csv_header() { return "step,s,status,value,low,high,sign,root,plus,contact"; }

std::string along_csv_row(const AlongStep& step) {
  const Surd* const exact = std::get_if<Surd>(&step.value);
  std::string row = fmt::format("{},{},{},{},{},{},", step.number, exact_text(step.share), status_text(step),
                                exact ? surd_text(*exact) : "", step.low, step.high);
  row += exact ? fmt::format("{},{},{}", sgn(exact->root), exact_text(abs(exact->root)), exact_text(exact->rational)) : ",,";
  return row + fmt::format(",{}", step.contact ? name(step.contact->kind) : "");
}

std::string along_json(const Path& path, const std::vector<AlongStep>& steps) {
  Json values = Json::array();
  for (const AlongStep& step : steps) {
    const Surd* const exact_value = std::get_if<Surd>(&step.value);
    const auto bound = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json depth{{"low", bound(step.low)}, {"high", bound(step.high)}};
    if (exact_value) depth["exact"] = output::exact_object(*exact_value);
    const double nearest = exact_value ? round_binary64(*exact_value) : 0;
    const bool told = exact_value && std::isfinite(nearest) && (nearest != 0 || sign(*exact_value) == 0);
    values.push_back({{"step", step.number},
                      {"s", Json::plain(exact_text(step.share))},
                      {"status", status_text(step)},
                      {"value", told ? Json(nearest) : Json()},
                      {"signed_depth", depth},
                      {"direction", output::exact(step.direction)},
                      {"contact", step.contact ? output::contact_object(*step.contact) : Json()}});
  }
  return Json{{"schema", "fathom/along/1"}, {"fathom", FATHOM_VERSION}, {"id", path.id}, {"along", output::exact(path.translation)},
              {"steps", path.steps},        {"values", values}}
      .text();
}

std::string along_svg(const Path& path, const std::vector<AlongStep>& steps) {
  plot::CurvePanel panel;
  panel.x = {fmt::format("s: A is moved by s {}", translation_text(path.translation)), plot::Scale::linear, true};
  panel.y = {"signed depth"};
  panel.series = series_of(steps);
  panel.above = "penetrating", panel.below = "apart";
  plot::Band band{"proved bounds", {}};
  for (const AlongStep& step : steps)
    if (std::holds_alternative<Bounds>(step.value)) band.slices.push_back({step.share.get_d(), step.low, step.high});
  if (!band.slices.empty()) panel.band = std::move(band);
  return plot::figure_file(
      {"Signed depth along a path: " + picture::without_folders(safe_id(path.id)),
       fmt::format("A is moved by s {} for s from 0 to 1, in {} steps. {}.", translation_text(path.translation), path.steps, course(steps)),
       "along",
       {panel}});
}

}  // namespace fathom::cli
