// SPDX-License-Identifier: GPL-3.0-or-later
// fathom approx --delta D A B | CASES.jsonl | -
// fathom width [--delta D] A | CASES.jsonl | -
// fathom ray --direction X,Y[,Z] A B | CASES.jsonl | -
// fathom ray --growth [--center-a X,Y[,Z]] [--center-b X,Y[,Z]] A B | CASES.jsonl | -
// fathom metric --ball Q A B | CASES.jsonl | -
// Lengths found by shooting rays: depths within a factor, in one direction, and in a polyhedral
// norm or gauge; and growth distances. As text and as JSON (result, ray, growth and
// metric.schema.json).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/approximate.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/output/json_values.hpp"
#include "reference/shapes/body_notes.hpp"

namespace fathom::cli {
namespace {

/// Returns the form for bodies of that dimension.
AnswerForm in_dimension(AnswerForm form, unsigned dimension) {
  form.dimension = dimension;
  return form;
}

/// Returns the point that was typed with an option, which has as many numbers as the bodies.
Point given_point(const std::string& option, const std::string& text, unsigned dimension) {
  const std::optional<Point> point = typed_point(text, dimension);
  const char* const expected =
      dimension == 2 ? "two numbers X,Y of bodies of the plane" : "three numbers X,Y,Z of bodies of space";
  return point ? *point
               : throw InputError(option, 0, fmt::format("expected {}, found {}", expected, kernels::shown(text)));
}

/// Returns the first members of a JSON object about bodies.
Json json_head(const char* schema, const std::string& id, unsigned dimension, Status status) {
  Json object = {{"schema", schema}, {"id", id}};
  if (dimension == 2) object["dimension"] = dimension;
  object["status"] = name(status);
  return object;
}

/// Returns the absolute value as root_text prints numbers.
std::string decimal(const mpq_class& value) { return root_text(value * value); }

// ---- within a factor ----

/// Returns the label of the direction. Without a distance: of disjoint bodies an approximation
/// finds only a separating plane.
std::string direction_label(const ApproxDepth& depth) {
  return depth.status() == Status::disjoint ? "separating normal" : "direction";
}

std::uint64_t rays(const ApproxDepth& depth) { return depth.penetration() ? depth.penetration()->rays : 0; }

/// Returns the bounds of the signed depth. Of disjoint bodies they exclude only 0, because an
/// approximation does not find the distance.
output::SignedDepthBounds signed_bounds(Status status, const kernels::Roundings& least,
                                        const kernels::Roundings& most) {
  if (status == Status::disjoint) return {-std::numeric_limits<double>::infinity(), 0};
  return {least.binary64.rd, most.binary64.ru};
}

/// Returns several lines, or one; without the last newline.
std::string approx_block(const ApproxDepth& depth, const output::AboutBodies& bodies, const AnswerForm& form) {
  const std::string what = quantity(form);
  std::vector<Row> rows;
  rows.emplace_back(what + " at most", root_text(depth.squared()));
  if (form.exact) rows.emplace_back(what + "^2 at most", exact_text(depth.squared()));
  rows.emplace_back(what + " at least", root_text(depth.bound_squared()));
  if (form.digits) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *form.digits));
  rows.emplace_back("delta", exact_text(depth.delta));
  rows.emplace_back("rays", fmt::format("{}", rays(depth)));
  rows.emplace_back(direction_label(depth), way_text(depth.direction(), form));
  if (const ApproxPenetration* found = depth.penetration()) {
    if (!form.width) rows.emplace_back("translation", place_text(found->translation, form));
    rows.emplace_back("contact", contact_text(found->contact, form.width));
    if (found->witness) add_witness(rows, *found->witness, form);
  }
  rows.emplace_back("sizes", shapes::sizes_text(bodies.sizes));
  if (const std::string flat = flat_text(depth, form.width); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.penetration()) rows.push_back(flat_note());
  return aligned(form.width ? "" : std::string(name(depth.status())), rows);
}

std::string approx_line(const std::string& id, const ApproxDepth& depth, const AnswerForm& form) {
  std::vector<std::string> parts;
  if (!form.width) parts.emplace_back(name(depth.status()));
  parts.push_back(quantity(form) + " at most " + root_text(depth.squared()));
  parts.push_back("at least " + root_text(depth.bound_squared()));
  if (depth.penetration()) {
    if (form.exact) parts.push_back(quantity(form) + "^2 at most " + exact_text(depth.squared()));
    if (form.digits) parts.push_back("in " + enclosure_text(depth.squared(), *form.digits));
  }
  parts.push_back(direction_label(depth) + " " + way_text(depth.direction(), form));
  if (depth.penetration()) parts.emplace_back(name(depth.penetration()->contact.kind));
  if (const std::string flat = flat_text(depth, form.width); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// Returns one line, without its newline, in ASCII for any id.
std::string approx_json(const std::string& id, const ApproxDepth& depth, const output::AboutBodies& bodies,
                        const AnswerForm& form) {
  const ApproxPenetration* const found = depth.penetration();
  const kernels::Roundings most = kernels::roundings_of_root(depth.squared()),
                           least = kernels::roundings_of_root(depth.bound_squared());
  const auto witness = found ? found->witness : std::nullopt;
  output::Result result{id,
                        form.dimension == 2 ? std::optional(form.dimension) : std::nullopt,
                        name(depth.status()),
                        output::signed_depth_object(signed_bounds(depth.status(), least, most)),
                        output::length(depth.squared(), most, form.digits),
                        output::exact(depth.translation(), form.dimension),
                        output::exact(depth.direction(), form.dimension),
                        found ? output::contact_object(found->contact) : Json(),
                        witness ? output::witness_object(*witness, form.dimension) : Json(),
                        output::unit_f64(depth.direction(), form.dimension),
                        output::translation_f64(std::optional(depth.translation()), form.dimension),
                        output::witness_f64(witness, form.dimension)};
  result.sizes = output::sizes_object(bodies.sizes);
  result.hull = output::hull_object(bodies.hull);
  result.flat = output::flat_array(depth);
  result.method = "approx";
  result.delta = exact_text(depth.delta);
  result.rays = rays(depth);
  result.bound = output::length(depth.bound_squared(), least, form.digits);
  if (form.width) result.width = result.depth;
  return output::result_line(result);
}

struct ApproxRequest : BodiesRequest {
  explicit ApproxRequest(const Given& given)
      : BodiesRequest(given), form(given), delta(given.number("--delta").value_or(mpq_class(1, 100))) {}

  AnswerForm form;
  mpq_class delta;  ///< the answer is within a factor of 1 + delta
};

ApproxDepth solve(const Case& single, const ApproxRequest& request, Monitor& monitor) {
  return request.one_body ? approx_width(single.a, request.delta, &monitor)
                          : approx_depth(single.a, single.b, request.delta, &monitor);
}

/// Warns, but does not refuse: the run can be interrupted, and its progress is shown.
void warn_of_many_rays(const ApproxRequest& request) {
  constexpr long many = 10'000'000;
  const mpq_class rays = (request.one_body ? 2 : 4) / request.delta;  // making the grid of directions takes long too
  if (rays > many)
    talk(fmt::format("--delta {} asks for about {} rays a case", exact_text(request.delta), mpz_class(rays).get_str()));
}

/// `request` must outlive the replies.
Replies approximate_replies(const ApproxRequest& request) {
  warn_of_many_rays(request);
  Replies replies;
  replies.refuses_shapes =
      request.one_body
          ? "width without --delta answers about those, exactly or within bounds as near as --bits asks for"
          : "depth answers about those, exactly or within bounds as near as --bits asks for";
  replies.refuses_unions = request.one_body ? shapes::width_of_union : "depth answers about those, exactly";
  replies.reply = [&request](const AskedCase& asked, Monitor& monitor, Workspace&) -> CaseReply {
    const std::string& id = asked.input.id;
    const ApproxDepth depth = solve(asked, request, monitor);
    const AnswerForm form = in_dimension(request.form, asked.input.a.dimension);
    if (request.json) return {approx_json(id, depth, asked.bodies, form)};
    return {is_stream(request) ? approx_line(id, depth, form) : approx_block(depth, asked.bodies, form)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::json_error(item.id, item.line, fault);
    };
  return replies;
}

// ---- in one direction ----

constexpr const char* ray_schema = "fathom/ray/1";

struct RayRequest : BodiesRequest {
  explicit RayRequest(const Given& given) : BodiesRequest(given), form(given), direction(given.text("--direction")) {}

  AnswerForm form;
  std::string direction;  ///< as typed
};

std::string normal_label(const DirectionalDepth& depth) {
  return depth.status() == Status::disjoint ? "separating normal" : "normal";
}

/// Returns several lines, or one; without the last newline.
std::string ray_block(const DirectionalDepth& depth, const Point& direction, const AnswerForm& form) {
  std::vector<Row> rows{{"depth along", place_text(direction, form)}, {"length", root_text(depth.squared())}};
  if (form.exact) rows.emplace_back("length^2", exact_text(depth.squared()));
  if (form.digits) rows.emplace_back("enclosure", enclosure_text(depth.squared(), *form.digits));
  if (form.exact) rows.emplace_back("factor", exact_text(depth.factor()));
  if (depth.status() == Status::penetrating) rows.emplace_back("translation", place_text(depth.translation(), form));
  rows.emplace_back(normal_label(depth), way_text(depth.normal(), form));
  if (const RayExit* exit = depth.penetration()) {
    rows.emplace_back("contact", contact_text(exit->contact));
    add_witness(rows, exit->witness, form);
  }
  if (const std::string flat = flat_text(depth); !flat.empty()) rows.emplace_back("flat", flat);
  if (depth.flat_a && depth.status() == Status::penetrating) rows.push_back(flat_note());
  return aligned(std::string(name(depth.status())), rows);
}

std::string ray_line(const std::string& id, const DirectionalDepth& depth, const AnswerForm& form) {
  std::vector<std::string> parts{std::string(name(depth.status())), "length " + root_text(depth.squared())};
  if (depth.status() == Status::penetrating) parts.push_back("translation " + place_text(depth.translation(), form));
  parts.push_back(normal_label(depth) + " " + way_text(depth.normal(), form));
  if (depth.penetration()) parts.emplace_back(name(depth.penetration()->contact.kind));
  if (const std::string flat = flat_text(depth); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// Returns one line, without its newline, in ASCII for any id.
std::string ray_json(const std::string& id, const DirectionalDepth& depth, const Point& direction,
                     const AnswerForm& form) {
  const RayExit* const exit = depth.penetration();
  Json result = json_head(ray_schema, id, form.dimension, depth.status());
  result["ray"] = output::exact(direction, form.dimension);
  result["factor"] = exact_text(depth.factor());
  result["length"] = output::length(depth.squared(), form.digits);
  result["translation"] = output::exact(depth.translation(), form.dimension);
  result["normal"] = output::exact(depth.normal(), form.dimension);
  result["contact"] = exit ? output::contact_object(exit->contact) : Json();
  result["witness"] = exit ? output::witness_object(exit->witness, form.dimension) : Json();
  result["flat"] = output::flat_array(depth);
  result["steps"] = exit ? exit->steps : 0;
  return result.text();
}

/// Returns the line for a case of a stream that has no result.
std::string ray_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(ray_schema, id, line, error);
}

// ---- about two centers ----

constexpr const char* growth_schema = "fathom/growth/1";

struct GrowthRequest : BodiesRequest {
  explicit GrowthRequest(const Given& given)
      : BodiesRequest(given), form(given), center_a(given.value("--center-a")), center_b(given.value("--center-b")) {}

  AnswerForm form;
  std::optional<std::string> center_a, center_b;  ///< as typed
};

/// Returns several lines, or one; without the last newline.
std::string growth_block(const GrowthDistance& found, const AnswerForm& form) {
  std::vector<Row> rows{{"growth", decimal(found.growth)}};
  if (form.exact) rows.emplace_back("exactly", exact_text(found.growth));
  add_points(rows, "centers", place_text(found.center_a, form), place_text(found.center_b, form));
  if (const GrownTouch* touch = found.touch ? &*found.touch : nullptr) {
    rows.emplace_back("normal", way_text(touch->normal, form));
    rows.emplace_back("contact", contact_text(touch->contact));
    add_witness(rows, touch->witness, form);
  }
  if (const std::string flat = flat_text(found); !flat.empty()) rows.emplace_back("flat", flat);
  return aligned(std::string(name(found.status())), rows);
}

std::string growth_line(const std::string& id, const GrowthDistance& found, const AnswerForm& form) {
  std::vector<std::string> parts{std::string(name(found.status())), "growth " + decimal(found.growth)};
  if (form.exact) parts.push_back("exactly " + exact_text(found.growth));
  if (found.touch) {
    parts.push_back("normal " + way_text(found.touch->normal, form));
    parts.emplace_back(name(found.touch->contact.kind));
  }
  if (const std::string flat = flat_text(found); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// Returns one line, without its newline, in ASCII for any id.
std::string growth_json(const std::string& id, const GrowthDistance& found, unsigned dimension) {
  Json object = json_head(growth_schema, id, dimension, found.status());
  object["growth"] = output::number(found.growth);
  object["centers"] = {{"a", output::exact(found.center_a, dimension)},
                       {"b", output::exact(found.center_b, dimension)}};
  const GrownTouch* const touch = found.touch ? &*found.touch : nullptr;
  object["normal"] = touch ? output::exact(touch->normal, dimension) : Json();
  object["contact"] = touch ? output::contact_object(touch->contact) : Json();
  object["weights"] =
      touch ? Json{{"a", output::weights_array(touch->weights_a)}, {"b", output::weights_array(touch->weights_b)}}
            : Json();
  object["witness"] = touch ? output::witness_object(touch->witness, dimension) : Json();
  object["flat"] = output::flat_array(found);
  object["steps"] = touch ? touch->steps : 0;
  return object.text();
}

GrowthDistance growth_of(const Case& pair, const GrowthRequest& request, Monitor& monitor) {
  const auto center = [&](const char* option, const std::optional<std::string>& text) {
    return text ? std::optional(given_point(option, *text, pair.a.dimension)) : std::nullopt;
  };
  try {
    return growth_distance(pair.a, pair.b, center("--center-a", request.center_a),
                           center("--center-b", request.center_b), &monitor);
  } catch (const NoGrowth& error) {
    throw InputError(pair.id, 0, error.what());
  }
}

// ---- in a norm or a gauge ----

constexpr const char* metric_schema = "fathom/metric/1";
constexpr std::size_t most_vertices = 12;

std::string kind(const UnitBall& ball) { return ball.symmetric ? "norm" : "gauge"; }

std::string ball_text(const UnitBall& ball) {
  const char* const why =
      ball.symmetric ? "symmetric about O" : "not symmetric about O, so t and -t may differ in length";
  return fmt::format("{}: {}; {} vertices", kind(ball), why, ball.vertices.size());
}

std::string deciding_text(const MetricResult& result) {
  std::vector<std::string> words;
  for (const MetricOptimum& optimum : result.optima()) {
    if (words.size() == most_vertices) {
      words.push_back(fmt::format("... ({} in all)", result.optima().size()));
      break;
    }
    words.push_back(std::to_string(optimum.vertex));
  }
  return fmt::format("{} of the ball{}", fmt::join(words, " "),
                     words.size() == 1 ? "" : "; the first is shown, --json lists all");
}

Json optima_array(const MetricResult& result, unsigned dimension) {
  Json array = Json::array();
  for (const MetricOptimum& optimum : result.optima()) {
    array.push_back({{"vertex", optimum.vertex},
                     {"translation", output::exact(optimum.translation, dimension)},
                     {"direction", output::exact(optimum.direction, dimension)},
                     {"contact", output::contact_object(optimum.contact)},
                     {"witness", output::witness_object(optimum.witness, dimension)}});
  }
  return array;
}

std::string direction_label(const MetricResult& result) {
  return result.status() == Status::disjoint ? "separating normal" : "direction";
}

/// Returns several lines, or one; without the last newline.
std::string metric_block(const MetricResult& result, const UnitBall& ball, const AnswerForm& form) {
  std::vector<Row> rows{{"depth", decimal(result.depth())}};
  if (form.exact) rows.emplace_back("exactly", exact_text(result.depth()));
  rows.emplace_back("unit ball", ball_text(ball));
  if (!result.optima().empty()) rows.emplace_back("vertices", deciding_text(result));
  rows.emplace_back(direction_label(result), way_text(result.direction(), form));
  if (!result.optima().empty()) {
    const MetricOptimum& first = result.optima().front();
    rows.emplace_back("translation", place_text(first.translation, form));
    rows.emplace_back("contact", contact_text(first.contact));
    add_witness(rows, first.witness, form);
  }
  if (const std::string flat = flat_text(result); !flat.empty()) rows.emplace_back("flat", flat);
  if (result.flat_a && result.status() == Status::penetrating) rows.push_back(flat_note());
  return aligned(std::string(name(result.status())), rows);
}

std::string metric_line(const std::string& id, const MetricResult& result, const UnitBall& ball,
                        const AnswerForm& form) {
  std::vector<std::string> parts{std::string(name(result.status())),
                                 fmt::format("depth {} in the {}", decimal(result.depth()), kind(ball))};
  if (!result.optima().empty()) {
    parts.push_back("translation " + place_text(result.optima().front().translation, form));
    parts.emplace_back(name(result.optima().front().contact.kind));
  } else {
    parts.push_back(direction_label(result) + " " + way_text(result.direction(), form));
  }
  if (result.optima().size() > 1) parts.push_back(fmt::format("{} ties", result.optima().size()));
  if (const std::string flat = flat_text(result); !flat.empty()) parts.push_back("flat " + flat);
  return case_line(id, parts);
}

/// Returns one line, without its newline, in ASCII for any id.
std::string metric_json(const std::string& id, const MetricResult& result, const UnitBall& ball) {
  Json object = json_head(metric_schema, id, ball.dimension, result.status());
  object["ball"] = {{"kind", kind(ball)}, {"vertices", ball.vertices.size()}};
  object["depth"] = output::number(result.depth());
  object["direction"] = output::exact(result.direction(), ball.dimension);
  object["optima"] = optima_array(result, ball.dimension);
  object["flat"] = output::flat_array(result);
  object["rays"] = result.penetration() ? result.penetration()->rays : 0;
  return object.text();
}

/// Returns the line for a case of a stream that has no result.
std::string metric_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(metric_schema, id, line, error);
}

struct MetricRequest : BodiesRequest {
  explicit MetricRequest(const Given& given) : BodiesRequest(given), form(given), ball(given.text("--ball")) {}

  AnswerForm form;
  std::string ball;  ///< a mesh
};

UnitBall ball_of(const MetricRequest& request) {
  try {
    return unit_ball(mesh_of_input(request.ball, request.decimals));
  } catch (const std::invalid_argument& error) {
    throw InputError(request.ball, 0, error.what());
  }
}

}  // namespace

ExitCode run_approx(const Given& given) {
  const ApproxRequest request(given);
  return reply_to_inputs(request, approximate_replies(request));
}

ExitCode run_width(const Given& given) {
  if (given.has("--delta")) return run_approx(given);
  const DepthRequest request(given);
  return reply_to_inputs(request, exact_replies(request));
}

namespace {

ExitCode run_growth(const Given& given) {
  const GrowthRequest request(given);
  Replies replies;
  replies.refuses_shapes = replies.refuses_unions =
      "by which factor it must grow is not answered about those; depth says how deep they are, or how far apart";
  replies.reply = [&request](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const GrowthDistance found = growth_of(pair, request, monitor);
    if (request.json) return {growth_json(pair.id, found, pair.a.dimension)};
    const AnswerForm form = in_dimension(request.form, pair.a.dimension);
    return {is_stream(request) ? growth_line(pair.id, found, form) : growth_block(found, form)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::error_object(growth_schema, item.id, item.line, fault);
    };
  return reply_to_inputs(request, replies);
}

}  // namespace

ExitCode run_ray(const Given& given) {
  if (given.flag("--growth")) return run_growth(given);
  const RayRequest request(given);
  Replies replies;
  replies.refuses_shapes = replies.refuses_unions =
      "how far it must move in one direction is not answered about those; depth says how far in the best one";
  replies.reply = [&request](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const AnswerForm form = in_dimension(request.form, pair.a.dimension);
    const Point direction = given_point("--direction", request.direction, form.dimension);
    const DirectionalDepth depth = directional_depth(pair.a, pair.b, direction, &monitor);
    if (request.json) return {ray_json(pair.id, depth, direction, form)};
    return {is_stream(request) ? ray_line(pair.id, depth, form) : ray_block(depth, direction, form)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return ray_json_error(item.id, item.line, fault);
    };
  return reply_to_inputs(request, replies);
}

ExitCode run_metric(const Given& given) {
  const MetricRequest request(given);
  const UnitBall ball = ball_of(request);
  Replies replies;
  replies.refuses_shapes = replies.refuses_unions = "depth answers about those, in Euclid's norm";
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    if (pair.a.dimension != ball.dimension)
      throw InputError(pair.id, 0, "expected bodies and a unit ball that are all of the plane, or all of space");
    const MetricResult result = metric_depth(pair.a, pair.b, ball, &monitor);
    if (request.json) return {metric_json(pair.id, result, ball)};
    const AnswerForm form = in_dimension(request.form, ball.dimension);
    return {is_stream(request) ? metric_line(pair.id, result, ball, form) : metric_block(result, ball, form)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return metric_json_error(item.id, item.line, fault);
    };
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
