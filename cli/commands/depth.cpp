// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B | CASES.jsonl | -
// fathom depth A B --along X,Y,Z --steps N | CASES.jsonl --case ID --along X,Y,Z
// The answer; or the signed depth along a path: for people (a table), for programs (JSON,
// along.schema.json), for spreadsheets (CSV), and as a chart.

#include "cli/commands/depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"
#include "reference/shapes/core.hpp"
#include "reference/text/json.hpp"
#include "view/picture/markup.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {
namespace {

// ---- --along ----

/// What is known when A stands at one place of the path.
struct AlongStep {
  std::uint32_t number;
  mpq_class share;                      ///< of the translation that A has been moved by
  std::optional<Status> status;         ///< nullopt if bounds leave it open
  std::variant<Surd, Bounds> value;     ///< the signed depth, exact or enclosed
  double low, high;                     ///< rounded outward
  Vector direction;                     ///< in which the least h(u)/|u| is reached, or at most the upper bound
  std::optional<Contact> contact = {};  ///< as `depth` has it
};

struct AlongRequest : DepthRequest {
  explicit AlongRequest(const Given& given)
      : DepthRequest(given),
        translation(typed_vector(given.text("--along")).value()),
        steps(given.integer<std::uint32_t>("--steps").value_or(32)),
        csv(given.flag("--csv")) {
    form.optima = 1;  // ties are not shown
  }

  Point translation;  ///< A is moved by parts of it, and by all of it in the end
  std::uint32_t steps;
  bool csv;
};

struct Path {
  std::string id;
  Point translation;
  std::uint32_t steps;
};

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

std::size_t share_columns(const Path& path) {
  return std::max<std::size_t>(1, 2 * std::to_string(path.steps).size() + 1);
}

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

/// One series of marks for each status, in the order of Status, so that a status has the same look
/// in all charts; those without places are not shown.
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

/// The lines of a table of which `path` says how wide it is.
std::string along_text_header(const Path& path) {
  return fmt::format("along {}\n{:<{}}  {:<11}  {:<23}  contact", translation_text(path.translation), "s",
                     share_columns(path), "status", "signed depth");
}

std::string along_text_row(const Path& path, const AlongStep& step) {
  std::string row = fmt::format("{:<{}}  {:<11}  {:<23}", exact_text(step.share), share_columns(path),
                                status_text(step), value_text(step));
  if (step.contact) return row + fmt::format("  {}", name(step.contact->kind));
  row.resize(row.find_last_not_of(' ') + 1);
  return row;
}

std::string along_csv_header() { return "step,s,status,value,low,high,sign,root,plus,contact"; }

std::string along_csv_row(const AlongStep& step) {
  const Surd* const exact = std::get_if<Surd>(&step.value);
  std::string row = fmt::format("{},{},{},{},{},{},", step.number, exact_text(step.share), status_text(step),
                                exact ? surd_text(*exact) : "", step.low, step.high);
  row += exact ? fmt::format("{},{},{}", sgn(exact->root), exact_text(abs(exact->root)), exact_text(exact->rational))
               : ",,";
  return row + fmt::format(",{}", step.contact ? name(step.contact->kind) : "");
}

/// One line, pure ASCII.
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
  return Json{{"schema", "fathom/along/1"},
              {"fathom", FATHOM_VERSION},
              {"id", path.id},
              {"along", output::exact(path.translation)},
              {"steps", path.steps},
              {"values", values}}
      .text();
}

/// A file of SVG.
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
  return plot::figure_file({"Signed depth along a path: " + picture::without_folders(safe_id(path.id)),
                            fmt::format("A is moved by s {} for s from 0 to 1, in {} steps. {}.",
                                        translation_text(path.translation), path.steps, course(steps)),
                            "along",
                            {panel}});
}

constexpr std::size_t indent = 4;  // of the further lines of a row, on a narrow terminal

/// Answers for A at each place of the path.
class Walk {
 public:
  Walk(const Case& pair, const AlongRequest& request, Monitor& monitor)
      : pair_(pair), request_(request), monitor_(monitor) {
    if (!has_shape(pair)) return;
    a_ = files::shape_of(pair.a);
    b_ = files::shape_of(pair.b);
    require_depth(pair.id, *a_, *b_);
  }

  AlongStep at(std::uint32_t number) {
    const mpq_class share = quotient(number, request_.steps);
    const Point& t = request_.translation;
    const files::GivenPose pose{.place = {mpq_class(share * t.x), mpq_class(share * t.y), mpq_class(share * t.z)}};
    const Question question = question_of(request_, monitor_, workspace_);
    if (a_)
      return along_step(
          number, share,
          signed_depth(moved(*a_, files::exact_pose(pose)), *b_, {.cores = question.options, .bits = question.bits}));
    Body a = pair_.a;
    files::place(a, pose);
    return along_step(number, share, penetration_depth(a, pair_.b, question.options));
  }

 private:
  static mpq_class quotient(std::uint32_t number, std::uint32_t of) {
    mpq_class result(number, of);
    result.canonicalize();
    return result;
  }

  const Case& pair_;
  const AlongRequest& request_;
  Monitor& monitor_;
  std::optional<Shape> a_, b_;  // unless both are polytopes
  Workspace workspace_;
};

/// Prints rows as soon as they are known; JSON, which is one object, in the end.
void print_row(const Path& path, const AlongStep& step, const AlongRequest& request) {
  if (request.csv) print(along_csv_row(step));
  else if (!request.json) print(fitted(along_text_row(path, step), indent));
}

// ---- one answer ----

/// The bits that bounds must have so that their digits can agree.
unsigned bits_of(const DepthRequest& request) {
  const unsigned usual = SignedDepthOptions{}.bits;
  if (request.bits || !request.form.digits) return request.bits.value_or(usual);
  const unsigned long enough = *request.form.digits * 3322UL / 1000 + 4;  // log2(10) < 3.322
  return static_cast<unsigned>(std::clamp<unsigned long>(enough, usual, most_bound_bits));
}

/// What a run writes beside its replies.
struct Files {
  FilePlaces certificates, pictures;

  explicit Files(const DepthRequest& request)
      : certificates(request, request.certificate, "certificate", ".cert"),
        pictures(request, request.svg, "picture", ".svg") {}
};

/// Of the answer, and of its patches and the derivative if these are asked for and have one.
std::string certificate_of(const Body& a, const Body& b, const AnsweredCase& answered, const AnswerForm& form,
                           Monitor* monitor) {
  if (!answered.manifold || !has_patch_certificate(answered.manifold->geometry))
    return certificate_text(a, b, answered.answer, answered.id, monitor);
  std::vector<Twist> motions;
  if (form.motion)  // of A, with B at rest: of convex bodies it has the same derivative
    motions.push_back({form.motion->of_a.v - form.motion->of_b.v, form.motion->of_a.w - form.motion->of_b.w});
  return certificate_text(a, b, answered.answer, answered.manifold->geometry, motions, answered.id, monitor);
}

std::string text_of(const AnsweredCase& answered, const DepthRequest& request) {
  if (request.json) return output::answer_json(answered, request.form);
  return is_stream(request) ? answer_line(answered, request.form) : answer_block(answered, request.form);
}

}  // namespace

ExitCode run_along(const Given& given) {
  const AlongRequest request(given);
  const auto picture = wanted_file(request.svg, "picture");  // an unwritable path fails early
  const Case pair = asked_case(request, "--along answers about convex bodies; without it depth takes unions");
  const InterruptGuard interrupt_guard;
  Progress progress("steps");
  const AskedCase asked = looked_at(pair, request);
  const Path path{pair.id, request.translation, request.steps};
  Walk walk(pair, request, progress);
  std::vector<AlongStep> steps;
  if (!request.json) print(request.csv ? along_csv_header() : fitted(along_text_header(path), indent));
  for (std::uint32_t i = 0; i <= path.steps; ++i) {
    steps.push_back(walk.at(i));
    progress.answered();
    print_row(path, steps.back(), request);
    progress.count({i + 1, std::size_t{path.steps} + 1});
  }
  progress.clear();
  if (request.json) print(along_json(path, steps));
  if (picture) picture->write(along_svg(path, steps));
  if (const std::string dents = shapes::dents_text(asked.bodies.hull); !dents.empty()) talk(dents);
  return fine;
}

DepthRequest::DepthRequest(const Given& given)
    : BodiesRequest(given),
      form(given),
      closest_lines(typed_engine(given.text("--closest-lines"))),
      seed(given.integer<std::uint64_t>("--seed").value_or(1)),
      bits(given.integer<unsigned>("--bits")),
      certificate(given.text("--certificate")),
      svg(given.text("--svg")) {
  const std::string by = given.text("--method");
  if (by == "exact") method = Method::exact;
  if (by == "naive") method = Method::naive;
  shallow = by == "shallow";
}

Question question_of(const DepthRequest& request, Monitor& monitor, Workspace& workspace) {
  Question question;
  question.options.method = request.method;
  question.options.closest_lines = request.closest_lines;
  question.options.seed = request.seed;
  question.options.optima = request.form.optima;
  question.options.monitor = &monitor;
  question.options.workspace = &workspace;
  question.bits = bits_of(request);
  return question;
}

AnsweredCase answered_by(const AskedCase& asked, const DepthRequest& request, const Question& question) {
  const Case& single = asked;
  const bool one = request.one_body;
  const Body& b = one ? single.a : single.b;
  if (has_union(single)) {
    if (request.shallow || request.closest_lines || request.method != Method::automatic || request.form.optima)
      throw InputError(
          single.id, 0,
          "a union of pieces has one method, and goes with none of --method, --closest-lines and --optima");
  } else if (single.a.shape || b.shape) {
    if (request.shallow) throw InputError(single.id, 0, "--method shallow takes polytopes, found a shape that is none");
    if (!one && single.a.shape && b.shape) require_depth(single.id, *single.a.shape, *b.shape);
  } else if (request.shallow || one) {
    Depth depth = request.shallow ? shallow_depth(single.a.points, b.points, question.options)
                                  : width(single.a.points, question.options);
    const BodyFacts facts = depth;
    return {single.id, {std::move(depth)}, asked.bodies, facts};
  }
  try {
    if (one && single.a.shape) shapes::require_width(*single.a.shape);
    Answer answer = exact_answer(single.a, b, question);
    const BodyFacts facts = facts_of(single.a, b, answer);
    return {single.id, std::move(answer), asked.bodies, facts};
  } catch (const std::invalid_argument& error) {
    if (!has_union(single) && !one) throw;
    throw InputError(single.id, 0, error.what());
  }
}

Replies exact_replies(const DepthRequest& request) {
  Replies replies;
  replies.names_dents = true;
  if (request.one_body) replies.refuses_unions = width_of_union;
  replies.reply = [&request, files = std::make_shared<Files>(request)](const AskedCase& asked, Monitor& monitor,
                                                                       Workspace& workspace) -> CaseReply {
    const std::unique_ptr<CertificateFile> proof = files->certificates.single();  // an unwritable path fails early
    const std::unique_ptr<CertificateFile> drawing = files->pictures.single();
    AnsweredCase answered = answered_by(asked, request, question_of(request, monitor, workspace));
    if (!answered.answer.complete()) return {text_of(answered, request), {}, interrupted};
    const Case& single = asked;
    const Body& b = request.one_body ? single.a : single.b;
    if (request.form.manifold())
      answered.manifold = output::manifold_of(single.a, b, answered.answer, request.form.motion, &monitor);
    if (!request.certificate.empty() || request.form.certificate) {
      answered.certificate = certificate_of(single.a, b, answered, request.form, &monitor);
      require_readable(single.id, answered.certificate);
    }
    CaseReply reply{text_of(answered, request)};
    const std::string picture = files->pictures.wanted() ? answer_picture(single, answered, request.form) : "";
    if (proof) proof->write(answered.certificate);
    if (drawing) drawing->write(picture);
    if (!proof && !drawing && (files->certificates.wanted() || files->pictures.wanted()))
      reply.keep = [files, picture, id = single.id, certificate = answered.certificate] {
        files->certificates.write_to_folder(id, certificate);
        files->pictures.write_to_folder(id, picture);
      };
    return reply;
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::json_error(item.id, item.line, fault);
    };
  return replies;
}

ExitCode run_depth(const Given& given) {
  if (given.has("--along")) return run_along(given);
  const DepthRequest request(given);
  return reply_to_inputs(request, exact_replies(request));
}

}  // namespace fathom::cli
