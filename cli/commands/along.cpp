// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B --along X,Y,Z[,WX,WY,WZ] --steps N | CASES.jsonl --case ID --along X,Y,Z
// The signed depth along a path: as a table, as JSON (along.schema.json), as CSV, and as a chart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

struct AlongRequest : DepthRequest {
  explicit AlongRequest(const Given& given)
      : DepthRequest(given),
        along(given.text("--along")),
        steps(given.integer<std::uint32_t>("--steps").value_or(32)),
        csv(given.flag("--csv")) {}

  std::string along;
  std::uint32_t steps;
  bool csv;

  /// Throws InputError unless it was typed for bodies of that dimension.
  [[nodiscard]] Twist motion(unsigned dimension) const {
    const std::optional<Twist> motion = typed_motion(along, dimension);
    const char* const expected =
        dimension == 2 ? "X,Y or X,Y,W of bodies of the plane" : "X,Y,Z or X,Y,Z,WX,WY,WZ of bodies of space";
    return motion
               ? *motion
               : throw InputError("--along", 0, fmt::format("expected {}, found {}", expected, kernels::shown(along)));
  }
};

/// Returns "0.25", or "[0.24, 0.26]" if only bounds are known.
std::string value_text(const AlongStep& step) {
  if (const Surd* exact = std::get_if<Surd>(&step.value)) return surd_text(*exact);
  return fmt::format("[{}, {}]", step.low, step.high);
}

/// Returns the ordinate of a mark in the chart.
double height(const AlongStep& step) {
  if (const Surd* exact = std::get_if<Surd>(&step.value)) return round_binary64(*exact);
  return step.low / 2 + step.high / 2;
}

bool turns(const Twist& motion) { return motion.w != Point{}; }

/// Returns the rotation that the path begins with, "turned by the quaternion (1, s/2 (0, 0, 1)),
/// then ", in the plane "turned by the half-angle s/2 1, then "; or "".
std::string turn_text(const Path& path) {
  const Point& w = path.motion.of_a.w;
  if (!turns(path.motion.of_a)) return "";
  return path.dimension == 2 ? fmt::format("turned by the half-angle s/2 {}, then ", exact_text(w.z))
                             : fmt::format("turned by the quaternion (1, s/2 {}), then ", place_text(w, true));
}

std::string way_of(const Path& path) { return place_text(path.motion.of_a.v, true, path.dimension); }

std::size_t share_columns(const Path& path) {
  return std::max<std::size_t>(1, 2 * std::to_string(path.steps).size() + 1);
}

/// Returns "penetrating for s from 0 to 7/16, touching at 1/2, disjoint for s from 9/16 to 1".
std::string course(const std::vector<AlongStep>& steps) {
  std::string result;
  for (std::size_t begin = 0, end = 0; begin < steps.size(); begin = end) {
    while (end < steps.size() && steps[end].status == steps[begin].status) ++end;
    const std::string first = exact_text(steps[begin].share), last = exact_text(steps[end - 1].share);
    if (!result.empty()) result += ", ";
    result += end - begin == 1 ? fmt::format("{} at s = {}", name(steps[begin].status), first)
                               : fmt::format("{} from s = {} to {}", name(steps[begin].status), first, last);
  }
  return result;
}

/// Returns a series of marks for each status that occurs, in the order of Status, so that a status
/// looks the same in all charts.
std::vector<plot::Series> series_of(const std::vector<AlongStep>& steps) {
  std::vector<plot::Series> series{{"signed depth", {}, true, false}};
  for (const Status status : {Status::penetrating, Status::touching, Status::disjoint})
    series.push_back({std::string(name(status)), {}, false});
  series.push_back({std::string(name(std::optional<Status>())), {}, false});
  for (const AlongStep& step : steps) {
    const double x = step.share.get_d(), y = height(step);
    std::string what = fmt::format("s = {}: {}, {}", exact_text(step.share), value_text(step), name(step.status));
    if (step.contact) what += fmt::format(", {}", name(step.contact->kind));
    series[0].places.push_back({x, y});
    series[step.status ? 1 + static_cast<std::size_t>(*step.status) : 4].places.push_back({x, y, what});
  }
  return series;
}

AlongStep along_step(std::uint32_t number, const mpq_class& share, const Depth& depth) {
  const Surd value{0, signed_square(depth)};
  const Contact* const contact = depth.contact();
  // Adding 0.0 turns -0.0 into 0.0.
  return {number,
          share,
          depth.status(),
          value,
          round_binary64(value, Rounding::rd) + 0.0,
          round_binary64(value, Rounding::ru) + 0.0,
          depth.direction(),
          contact ? std::optional(*contact) : std::nullopt};
}

/// Convex bodies have no such answer.
AlongStep along_step(std::uint32_t, const mpq_class&, const UnionDepth&) { throw std::logic_error("a path of unions"); }

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

/// Returns the heading of the table; `path` determines its width.
std::string along_text_header(const Path& path) {
  return fmt::format("{}along {}\n{:<{}}  {:<11}  {:<23}  contact", turn_text(path), way_of(path), "s",
                     share_columns(path), "status", "signed depth");
}

std::string along_text_row(const Path& path, const AlongStep& step) {
  std::string row = fmt::format("{:<{}}  {:<11}  {:<23}", exact_text(step.share), share_columns(path),
                                name(step.status), value_text(step));
  if (step.contact) return row + fmt::format("  {}", name(step.contact->kind));
  row.resize(row.find_last_not_of(' ') + 1);
  return row;
}

std::string along_csv_header() { return "step,s,status,value,low,high,sign,root,plus,contact"; }

std::string along_csv_row(const AlongStep& step) {
  const Surd* const exact = std::get_if<Surd>(&step.value);
  std::string row = fmt::format("{},{},{},{},{},{},", step.number, exact_text(step.share), name(step.status),
                                exact ? surd_text(*exact) : "", step.low, step.high);
  row += exact ? fmt::format("{},{},{}", sgn(exact->root), exact_text(abs(exact->root)), exact_text(exact->rational))
               : ",,";
  return row + fmt::format(",{}", step.contact ? name(step.contact->kind) : "");
}

/// Returns the tangent from s = 0 on, cut off where it leaves the range of the curve's values by
/// half of that range.
plot::Series tangent_of(const std::vector<plot::Datum>& curve, double slope) {
  const auto [low, high] = std::ranges::minmax(curve, {}, &plot::Datum::y);
  const double room = high.y - low.y, start = curve.front().y;
  const double above = high.y + room / 2 - start, below = start - low.y + room / 2, reach = slope > 0 ? above : below;
  const double end = room > 0 && std::abs(slope) > reach ? reach / std::abs(slope) : 1;
  return {"tangent at s = 0", {{0, start}, {end, start + end * slope}}, true, false};
}

constexpr std::size_t indent = 4;  // spaces before continued lines of a row, on a narrow terminal

/// Computes the answer at each step of the path.
class Walk {
 public:
  Walk(const Case& pair, const Path& path, const DepthRequest& request, Monitor& monitor)
      : pair_(pair), path_(path), request_(request), monitor_(monitor) {
    if (has_shape(pair)) require_depth(pair.id, files::shape_of(pair.a), files::shape_of(pair.b));
  }

  AlongStep at(std::uint32_t number) {
    const mpq_class share = quotient(number, path_.steps);
    const files::GivenPose pose_a = pose_at(share, path_.motion.of_a), pose_b = pose_at(share, path_.motion.of_b);
    const bool b_moves = path_.motion.of_b != Twist();
    Question question = question_of(request_, monitor_, workspace_);
    question.options.optima = 1;  // ties are not printed
    question.coaxial = true;
    Body a = pair_.a, b = pair_.b;
    files::place(a, pose_a);
    if (b_moves) files::place(b, pose_b);
    const Answer answer = exact_answer(a, b, question);
    return std::visit([&](const auto& found) { return along_step(number, share, found); }, answer.found);
  }

 private:
  static files::GivenPose pose_at(const mpq_class& share, const Twist& motion) {
    const Point half_turn = mpq_class(share / 2) * motion.w;
    return {.turn = {1, half_turn.x, half_turn.y, half_turn.z}, .place = share * motion.v};
  }
  static mpq_class quotient(std::uint32_t number, std::uint32_t of) {
    mpq_class result(number, of);
    result.canonicalize();
    return result;
  }

  const Case& pair_;
  const Path& path_;
  const DepthRequest& request_;
  Monitor& monitor_;
  Workspace workspace_;
};

void print_header(const Path& path, const AlongRequest& request) {
  if (!request.json) print(request.csv ? along_csv_header() : fitted(along_text_header(path), indent));
}

/// Prints each row as soon as it is known; JSON, which is one object, at the end.
void print_row(const Path& path, const AlongStep& step, const AlongRequest& request) {
  if (request.csv) print(along_csv_row(step));
  else if (!request.json) print(fitted(along_text_row(path, step), indent));
}

}  // namespace

Json along_object(const Path& path, const std::vector<AlongStep>& steps) {
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
                      {"status", name(step.status)},
                      {"value", told ? Json(nearest) : Json()},
                      {"signed_depth", depth},
                      {"direction", output::exact(step.direction, path.dimension)},
                      {"contact", step.contact ? output::contact_object(*step.contact) : Json()}});
  }
  Json result{{"schema", "fathom/along/1"},
              {"fathom", FATHOM_VERSION},
              {"id", path.id},
              {"along", output::exact(path.motion.of_a.v, path.dimension)}};
  if (path.dimension == 2) result["dimension"] = 2;
  if (turns(path.motion.of_a)) result["turn"] = output::turn_object(path.motion.of_a.w, path.dimension);
  if (path.motion.of_b != Twist()) {
    result["along_b"] = output::exact(path.motion.of_b.v, path.dimension);
    result["turn_b"] = output::turn_object(path.motion.of_b.w, path.dimension);
  }
  result["steps"] = path.steps;
  result["values"] = values;
  return result;
}

plot::Figure along_figure(const std::vector<AlongStep>& steps, const std::string& prefix, const std::string& title,
                          const std::string& motion, std::optional<double> slope) {
  plot::CurvePanel panel;
  panel.x = {"s: " + motion, plot::Scale::linear, true};
  panel.y = {"signed depth"};
  panel.series = series_of(steps);
  panel.from_zero = !slope;
  if (slope) panel.series.push_back(tangent_of(panel.series[0].places, *slope));
  panel.above = "penetrating", panel.below = "apart";
  plot::Band band{"proved bounds", {}};
  for (const AlongStep& step : steps)
    if (std::holds_alternative<Bounds>(step.value)) band.slices.push_back({step.share.get_d(), step.low, step.high});
  if (!band.slices.empty()) panel.band = std::move(band);
  return {title,
          fmt::format("{} for s from 0 to 1, in {} steps. {}.", motion, steps.size() - 1, course(steps)),
          prefix,
          {panel}};
}

std::vector<AlongStep> walked(const Case& pair, const Path& path, const DepthRequest& request, Monitor& monitor,
                              const std::function<void(const AlongStep&)>& known) {
  Walk walk(pair, path, request, monitor);
  std::vector<AlongStep> steps;
  for (std::uint32_t i = 0; i <= path.steps; ++i) {
    steps.push_back(walk.at(i));
    if (known) known(steps.back());
  }
  return steps;
}

ExitCode run_along(const Given& given) {
  const AlongRequest request(given);
  const auto picture = wanted_file(request.svg, "picture");  // fails early for an unwritable path
  const Case pair = asked_case(request, "--along answers about convex bodies; without it depth takes unions", "", "");
  const unsigned dimension = pair.a.dimension;
  const Path path{pair.id, {request.motion(dimension), {}}, request.steps, dimension};
  const InterruptGuard interrupt_guard;
  Progress progress("steps");
  const AskedCase asked = looked_at(pair, request);
  const std::vector<AlongStep> steps = walked(pair, path, request, progress, [&](const AlongStep& step) {
    if (step.number == 0) {
      say_about_hulls(asked, !request.json && !request.csv);
      print_header(path, request);
    }
    progress.answered();
    print_row(path, step, request);
    progress.count({step.number + 1, std::size_t{path.steps} + 1});
  });
  progress.clear();
  if (request.json) print(along_object(path, steps).text());
  if (picture)
    picture->write(plot::figure_file(
        along_figure(steps, "along", "Signed depth along a path: " + picture::without_folders(safe_id(path.id)),
                     fmt::format("A is {}moved by s {}", turn_text(path), way_of(path)))));
  return fine;
}

}  // namespace fathom::cli
