// SPDX-License-Identifier: GPL-3.0-or-later
// Further questions about two bodies, and the judge.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/answers.hpp"
#include "bindings/python/src/bodies.hpp"
#include "fathom/approximate.hpp"
#include "fathom/judge.hpp"
#include "fathom/overlap.hpp"
#include "fathom/prepared.hpp"
#include "fathom/study.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/solve/depth.hpp"
#include "verify/judge/fields.hpp"
#include "verify/judge/truth.hpp"

template <>
struct pybind11::detail::type_caster<fathom::Prepared> : fathom::python::MadeCaster<fathom::Prepared> {};

namespace fathom::python {
namespace {

using py::literals::operator""_a;

struct Pair {
  Body a, b;
};

/// Returns two convex bodies; a union is refused for the reason `no_union`. Warns of meshes that
/// are not convex.
Pair any_pair_from(const py::object& a, const py::object& b, const py::object& pose_a, const py::object& pose_b,
                   const char* no_union) {
  Pair pair{body_from(a, pose_a, "a", nullptr, no_union), body_from(b, pose_b, "b", nullptr, no_union)};
  warn_of_dents(pair.a, "A");
  warn_of_dents(pair.b, "B");
  return pair;
}

/// Returns two polytopes. Warns as any_pair_from does.
Pair pair_from(const py::object& a, const py::object& b, const py::object& pose_a, const py::object& pose_b,
               const char* no_union) {
  Pair pair = any_pair_from(a, b, pose_a, pose_b, no_union);
  points_of(pair.a, "a");
  points_of(pair.b, "b");
  return pair;
}

/// Returns a body of any kind. Warns as any_pair_from does.
Body any_body_from(const py::object& from, const py::object& pose, const char* name) {
  const bool is_union = py::isinstance<Body>(from) && from.cast<const Body&>().pieces;
  Body body = is_union ? posed(from.cast<Body>(), pose, name) : body_from(from, pose, name);
  warn_of_dents(body, *name == 'a' ? "A" : "B");
  return body;
}

py::object normal_of(const Vector& n, unsigned dimension) {
  return py::make_tuple(unit(n, dimension), integers(n, dimension));
}

/// Returns ask(a, b, options).
template <class Ask>
auto asked_with_proof(const py::object& a, const py::object& b, bool proof, const py::object& pose_a,
                      const py::object& pose_b, Ask ask) {
  const Body first = any_body_from(a, pose_a, "a"), second = any_body_from(b, pose_b, "b");
  return watched([&](Monitor& monitor) {
    thread_local Workspace workspace;
    OverlapOptions options;
    options.proof = proof;
    options.monitor = &monitor;
    options.workspace = &workspace;
    return ask(first, second, options);
  });
}

py::object overlap_of(const py::object& a, const py::object& b, bool proof, const py::object& pose_a,
                      const py::object& pose_b) {
  const Overlap found = asked_with_proof(a, b, proof, pose_a, pose_b,
                                         [](const Body& first, const Body& second, const OverlapOptions& options) {
                                           return overlap(first, second, options);
                                         });
  const py::str status(std::string(name(found.status)));
  if (!found.proof) return status;
  py::dict shown;
  if (found.proof->common) shown["common"] = fractions(*found.proof->common);
  if (found.proof->normal) shown["normal"] = integers(*found.proof->normal);
  if (!found.proof->around.empty()) shown["around"] = py::cast(found.proof->around);
  return py::make_tuple(status, shown);
}

py::object closer_than_of(const py::object& a, const py::object& b, const py::object& distance, bool proof,
                          const py::object& pose_a, const py::object& pose_b) {
  const mpq_class limit = number_from(distance);
  const Closeness found = asked_with_proof(a, b, proof, pose_a, pose_b,
                                           [&](const Body& first, const Body& second, const OverlapOptions& options) {
                                             return closer_than(first, second, limit, options);
                                           });
  const py::object closer = found.closer ? py::object(py::bool_(*found.closer)) : py::object(py::none());
  if (!found.proof) return closer;
  py::dict shown;
  if (found.proof->points) shown["points"] = witness(found.proof->points, true);
  if (found.proof->normal) shown["normal"] = integers(*found.proof->normal);
  return py::make_tuple(closer, shown);
}

py::dict ray(const py::object& a, const py::object& b, const py::object& direction, const py::object& pose_a,
             const py::object& pose_b) {
  const Pair pair = pair_from(
      a, b, pose_a, pose_b,
      "how far it must move in one direction is not answered about those; union_depth says how far in the best one");
  const unsigned dimension = pair.a.dimension;
  const Point along = point_from(direction, dimension);
  const DirectionalDepth found =
      watched([&](Monitor& monitor) { return directional_depth(pair.a, pair.b, along, &monitor); });
  py::dict result("status"_a = std::string(name(found.status())), "factor"_a = fraction(found.factor()),
                  "translation"_a = fractions(found.translation(), dimension), "squared"_a = fraction(found.squared()),
                  "length"_a = root_binary64(found.squared()), "normal"_a = normal_of(found.normal(), dimension));
  if (const RayExit* const exit = found.penetration()) {
    result["contact"] = contact(&exit->contact);
    result["witness"] = witness(exit->witness, true, dimension);
  }
  return result;
}

py::dict growth(const py::object& a, const py::object& b, const py::object& center_a, const py::object& center_b,
                const py::object& pose_a, const py::object& pose_b) {
  const Pair pair = pair_from(
      a, b, pose_a, pose_b,
      "by which factor it must grow is not answered about those; union_depth says how deep they are, or how far apart");
  const unsigned dimension = pair.a.dimension;
  const auto center = [&](const py::object& given) {
    return given.is_none() ? std::nullopt : std::optional(point_from(given, dimension));
  };
  const std::optional<Point> about_a = center(center_a), about_b = center(center_b);
  const GrowthDistance found =
      watched([&](Monitor& monitor) { return growth_distance(pair.a, pair.b, about_a, about_b, &monitor); });
  py::dict result(
      "status"_a = std::string(name(found.status())), "growth"_a = fraction(found.growth),
      "centers"_a = py::make_tuple(fractions(found.center_a, dimension), fractions(found.center_b, dimension)));
  if (!found.touch) return result;
  result["normal"] = integers(found.touch->normal, dimension);
  result["contact"] = contact(&found.touch->contact);
  result["weights"] = py::make_tuple(weights(found.touch->weights_a), weights(found.touch->weights_b));
  result["witness"] = witness(found.touch->witness, true, dimension);
  return result;
}

py::dict metric(const py::object& a, const py::object& b, const py::object& ball, const py::object& pose_a,
                const py::object& pose_b) {
  const Pair pair = pair_from(a, b, pose_a, pose_b, "union_depth answers about those, in Euclid's norm");
  const Body unit_body = body_from(ball, py::none(), "ball", nullptr, "the unit ball of a norm is convex");
  points_of(unit_body, "ball");
  const unsigned dimension = pair.a.dimension;
  const MetricResult found =
      watched([&](Monitor& monitor) { return metric_depth(pair.a, pair.b, unit_ball(unit_body), &monitor); });
  py::list optima;
  for (const MetricOptimum& optimum : found.optima())
    optima.append(py::dict("vertex"_a = optimum.vertex, "translation"_a = fractions(optimum.translation, dimension),
                           "normal"_a = normal_of(optimum.direction, dimension),
                           "contact"_a = contact(&optimum.contact)));
  return py::dict("status"_a = std::string(name(found.status())), "depth"_a = fraction(found.depth()),
                  "optima"_a = optima, "normal"_a = normal_of(found.direction(), dimension));
}

py::dict approx(const py::object& a, const py::object& b, const py::object& delta, const py::object& pose_a,
                const py::object& pose_b) {
  const Pair pair = pair_from(a, b, pose_a, pose_b, "union_depth answers about those, exactly");
  const mpq_class within = number_from(delta);
  const ApproxDepth found = watched([&](Monitor& monitor) { return approx_depth(pair.a, pair.b, within, &monitor); });
  return py::dict(
      "status"_a = std::string(name(found.status())), "low"_a = root_binary64(found.bound_squared(), Rounding::rd),
      "high"_a = root_binary64(found.squared(), Rounding::ru), "low_squared"_a = fraction(found.bound_squared()),
      "high_squared"_a = fraction(found.squared()), "translation"_a = fractions(found.translation(), pair.a.dimension),
      "normal"_a = normal_of(found.direction(), pair.a.dimension));
}

py::dict involved(const Involved& features) {
  return py::dict("a"_a = py::cast(features.a), "b"_a = py::cast(features.b));
}

py::dict size_of(const BodySize& size) {
  return py::dict("rank"_a = size.rank, "vertices"_a = size.vertices, "edges"_a = size.edges, "facets"_a = size.facets);
}

py::dict studied(PairAnswer answer, const py::dict& coincidences, const py::dict& predicates, const py::dict& a,
                 const py::dict& b) {
  return py::dict("answer"_a = std::move(answer), "coincidences"_a = coincidences, "predicates"_a = predicates,
                  "a"_a = a, "b"_a = b);
}

py::dict coincidence(std::uint64_t count, const py::list& listed) {
  return py::dict("count"_a = count, "listed"_a = listed);
}

py::dict study_of_polytopes(Pair pair, std::size_t listed) {
  Study found = watched([&](Monitor& monitor) {
    return study(pair.a.points.exact(), pair.b.points.exact(), {.listed = listed, .monitor = &monitor});
  });
  py::dict coincidences;
  for (std::size_t i = 0; i < found.coincidences.size(); ++i) {
    py::list list;
    for (const Involved& one : found.coincidences[i].listed) list.append(involved(one));
    coincidences[py::str(std::string(coincidence_names[i]))] = coincidence(found.coincidences[i].count, list);
  }
  const py::dict a = size_of(found.a), b = size_of(found.b), asked = predicates(found.predicates);
  return studied({std::move(pair.a), std::move(pair.b), {}, {std::move(found.depth)}}, coincidences, asked, a, b);
}

py::dict feature(const ShapeFeature& found) {
  return py::dict("what"_a = std::string(found.what),
                  "direction"_a = found.direction == Vector{0, 0, 0} ? py::object(py::none())
                                                                     : py::object(integers(found.direction)),
                  "point"_a = found.point ? py::object(fractions(*found.point)) : py::object(py::none()),
                  "length"_a = found.length ? py::object(py::make_tuple(fraction(found.length->rational),
                                                                        fraction(found.length->root)))
                                            : py::object(py::none()));
}

py::dict size_of(const ShapeSize& size) {
  return py::dict("half_space"_a = size.half_space, "terms"_a = size.terms, "points"_a = size.points,
                  "discs"_a = size.discs, "balls"_a = size.balls, "radius"_a = fraction(size.radius));
}

py::dict study_of_shapes(Pair pair, std::size_t listed) {
  ShapeStudy found = watched([&](Monitor& monitor) {
    return study(files::shape_of(pair.a), files::shape_of(pair.b), {.listed = listed, .monitor = &monitor});
  });
  py::dict coincidences;
  for (std::size_t i = 0; i < found.coincidences.size(); ++i) {
    py::list list;
    for (const ShapeInvolved& one : found.coincidences[i].listed)
      list.append(py::dict("a"_a = feature(one.a), "b"_a = feature(one.b)));
    coincidences[py::str(std::string(shape_coincidence_names[i]))] = coincidence(found.coincidences[i].count, list);
  }
  const py::dict a = size_of(found.a), b = size_of(found.b);
  return studied({std::move(pair.a), std::move(pair.b), {}, {std::move(found.depth)}}, coincidences, {}, a, b);
}

py::dict study_of(const py::object& a, const py::object& b, std::size_t listed, const py::object& pose_a,
                  const py::object& pose_b) {
  Pair pair = any_pair_from(a, b, pose_a, pose_b, shapes::study_of_union);
  solve::require_space(pair.a, pair.b, "study");
  return pair.a.shape || pair.b.shape ? study_of_shapes(std::move(pair), listed)
                                      : study_of_polytopes(std::move(pair), listed);
}

// ---- the judge ----

template <class Value>
Value one_of(const std::string& what, const std::string& word) {
  std::string words;
  for (const auto& [text, value] : judging::words_of(Value())) {
    if (word == text) return value;
    words += (words.empty() ? "'" : ", '") + std::string(text) + "'";
  }
  throw py::value_error("expected " + what + " to be one of " + words + ", found '" + word + "'");
}

struct JudgeArguments {
  Reply reply;
  Conventions conventions;
  NumberFormat format;
  Tolerance tolerance;
  std::optional<Motion> motion = {};
};

/// Returns the argument of `judge` with this name.
template <class Value>
Value argument(const py::dict& claim, const char* name, const char* expected) try {
  return claim[name].cast<Value>();
} catch (const py::cast_error&) {
  throw py::type_error(std::string(name) + ": expected " + expected + ", found " + shown(claim[name]));
}

std::string text_argument(const py::dict& claim, const char* name) {
  return argument<std::string>(claim, name, "a text");
}
bool bool_argument(const py::dict& claim, const char* name) { return argument<bool>(claim, name, "True or False"); }

std::optional<double> number_or_none(py::handle from, const char* name) {
  return from.is_none() ? std::nullopt : std::optional(float_from(from, name));
}

/// In the plane two numbers.
Triple triple(py::handle from, const char* name, unsigned dimension) {
  if (!PySequence_Check(from.ptr()) || py::isinstance<py::str>(from) || py::len(from) != dimension)
    throw py::value_error(std::string(name) + ": expected " + (dimension == 2 ? "two" : "three") + " numbers, found " +
                          shown(from));
  const auto values = py::reinterpret_borrow<py::sequence>(from);
  return {float_from(values[0], name), float_from(values[1], name), dimension == 2 ? 0 : float_from(values[2], name)};
}

/// Returns the items of a sequence of two.
py::sequence two_of(py::handle from, const char* expected) {
  if (!PySequence_Check(from.ptr()) || py::len(from) != 2)
    throw py::value_error(std::string("expected ") + expected + ", found " + shown(from));
  return py::reinterpret_borrow<py::sequence>(from);
}

Reply reply_from(const py::dict& claim, unsigned dimension) {
  Reply reply;
  reply.overlap = bool_argument(claim, "overlap");
  reply.depth = number_or_none(claim["depth"], "depth");
  reply.distance = number_or_none(claim["distance"], "distance");
  for (const py::handle& each : claim["contacts"]) {
    const py::sequence contact = two_of(each, "each contact to be a position and a depth, or None");
    reply.contacts.push_back({triple(contact[0], "contacts", dimension), number_or_none(contact[1], "contacts")});
  }
  reply.derivative = number_or_none(claim["derivative"], "derivative");
  if (!claim["direction"].is_none()) reply.direction = triple(claim["direction"], "direction", dimension);
  if (!claim["witness"].is_none()) {
    const py::sequence two = two_of(claim["witness"], "a witness of two points");
    reply.witness_a = triple(two[0], "witness", dimension);
    reply.witness_b = triple(two[1], "witness", dimension);
  }
  return reply;
}

/// Returns the most contacts of an answer, or None for no limit, and the margin of their depths.
std::optional<ContactLimits> manifold_from(const py::handle& from) {
  if (from.is_none()) return std::nullopt;
  const py::sequence two = two_of(from, "a manifold of two: how many contacts at most, or None, and a margin");
  ContactLimits limits;
  limits.margin = float_from(two[1], "manifold");
  if (!std::isfinite(limits.margin) || limits.margin < 0)
    throw py::value_error("manifold: expected a margin of at least 0, found " + shown(two[1]));
  if (two[0].is_none()) return limits;
  try {
    limits.most = two[0].cast<std::size_t>();
  } catch (const py::cast_error&) {
    limits.most = 0;
  }
  if (limits.most == 0U)
    throw py::value_error("manifold: expected a number of contacts from 1, found " + shown(two[0]));
  return limits;
}

JudgeArguments judge_arguments(const py::dict& claim, unsigned dimension) {
  JudgeArguments result;
  result.reply = reply_from(claim, dimension);
  const auto take = [&]<class Value>(const char* name, Value& value) {
    value = one_of<Value>(name, text_argument(claim, name));
  };
  take("touching", result.conventions.touching);
  take("sign", result.conventions.depth);
  take("moves", result.conventions.moves);
  result.conventions.unit = bool_argument(claim, "unit");
  take("claims", result.conventions.claims);
  result.conventions.manifold = manifold_from(claim["manifold"]);
  const auto precision = [&](const char* of) { return one_of<Precision>(of, text_argument(claim, of)); };
  result.format = precision("precision");
  if (!claim["answers"].is_none()) result.format.answers = precision("answers");
  result.tolerance.relative = number_from(claim["relative"]);
  result.tolerance.absolute = number_from(claim["absolute"]);
  const std::string policy = text_argument(claim, "policy");
  const std::optional<Policy> known = judging::policy_of(policy);
  if (!known)
    throw py::value_error("expected policy to be 'declared', 'minimum', 'separating' or 'within=P%', found '" + policy +
                          "'");
  result.tolerance.policy = *known;
  if (result.reply.derivative)
    result.motion = {twist_from(claim["v"], claim["w"], "v", "w", dimension),
                     twist_from(claim["v_b"], claim["w_b"], "v_b", "w_b", dimension)};
  if (!claim["patch_slack"].is_none()) {
    mpq_class& slack = result.tolerance.patch_slack.emplace(number_from(claim["patch_slack"]));
    if (slack < 0)
      throw py::value_error("patch_slack: expected a length of at least 0, found " + shown(claim["patch_slack"]));
  }
  return result;
}

/// Returns a body after rounding to the number format of the program under test.
Body seen_from(const Body& given, const NumberFormat& format, const char* name) {
  std::optional<Body> body = judging::body_seen(given, format);
  if (!body)
    throw py::value_error(std::string(name) + ": a coordinate overflows " + std::string(fathom::name(format.points)));
  return *std::move(body);
}

// Values of fields in Python.
py::object in_python(bool value) { return py::bool_(value); }
py::object in_python(double value) { return py::float_(value); }
py::object in_python(const std::string& value) { return py::str(value); }
py::object in_python(const mpq_class& value) { return fraction(value); }
py::object in_python(const Between& value) { return py::make_tuple(value.low, value.high); }
py::object in_python(Verdict value) { return py::str(std::string(name(value))); }
py::object in_python(Accuracy value) { return py::str(std::string(name(value))); }
py::object in_python(const std::optional<Status>& value) { return py::str(std::string(name(value))); }
py::object in_python(const UnionBounds& value) {
  return py::dict("squared"_a = fraction(value.deepest_pair), "pieces"_a = py::make_tuple(value.a, value.b));
}
py::object in_python(const std::vector<Verdict>& list) {
  py::list result;
  for (const Verdict verdict : list) result.append(in_python(verdict));
  return result;
}
py::object in_python(const std::vector<std::string>& list) {
  py::list result;
  for (const std::string& text : list) result.append(in_python(text));
  return result;
}
py::object in_python(const DerivativeJudgement& value);
template <class T>
py::object in_python(const std::optional<T>& value) {
  return value ? in_python(*value) : py::object(py::none());
}

/// Returns a dict by the table of fields of the struct; fields without a value are None.
template <class Struct>
py::dict in_python_by_fields(const Struct& of) {
  py::dict result;
  text::for_each_field(judging::fields_of(&of), [&](const auto& field) {
    const bool is_flag = std::is_same_v<std::decay_t<decltype(text::value_of(field, of))>, bool>;
    result[py::str(std::string(field.name))] =
        is_flag || text::has(field, of) ? in_python(text::value_of(field, of)) : py::object(py::none());
  });
  return result;
}
py::object in_python(const DerivativeJudgement& value) { return in_python_by_fields(value); }

py::dict judged(const py::object& a, const py::object& b, const py::dict& claim, const py::object& pose_a,
                const py::object& pose_b) {
  const Body given_a = any_body_from(a, pose_a, "a"), given_b = any_body_from(b, pose_b, "b");
  const JudgeArguments claimed = judge_arguments(claim, given_a.dimension);
  const Body seen_a = seen_from(given_a, claimed.format, "a"), seen_b = seen_from(given_b, claimed.format, "b");
  const Judgement found = watched([&](Monitor& monitor) {
    Options options;
    options.monitor = &monitor;
    const judging::AnyTruth truth = judging::truth_of(seen_a, seen_b, options);
    return judging::judged(truth, claimed.reply, claimed.conventions, claimed.format, claimed.tolerance, claimed.motion,
                           &monitor);
  });
  py::dict result = in_python_by_fields(found);
  result["passed"] = passes(found.verdict);
  return result;
}

// ---- prepared polytopes ----

/// Returns an array of floats as a pose in binary64, without conversion; nullopt for any other
/// object, and for an array whose fourth row is not 0 0 0 1: their pose is made exact.
std::optional<PoseBinary64> array_pose(const py::object& pose) {
  if (!py::isinstance<py::array_t<double>>(pose)) return std::nullopt;
  const auto array = pose.cast<py::array_t<double>>();
  const bool square = array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4;
  if (!square && (array.ndim() != 2 || array.shape(0) != 3 || array.shape(1) != 4)) return std::nullopt;
  const auto rows = array.unchecked<2>();
  if (square && (rows(3, 0) != 0 || rows(3, 1) != 0 || rows(3, 2) != 0 || rows(3, 3) != 1)) return std::nullopt;
  PoseBinary64 result;
  for (py::ssize_t i = 0; i < 3; ++i)
    for (py::ssize_t j = 0; j < 4; ++j) result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = rows(i, j);
  return result;
}

PlacedBody placed_from(const Prepared& prepared, const py::object& pose, const char* name) {
  PlacedBody placed{prepared};
  if (const std::optional<PoseBinary64> rows = array_pose(pose)) placed.pose = *rows;
  else if (const std::optional<files::GivenPose> given = pose_from(pose, name)) placed.pose = files::exact_pose(*given);
  return placed;
}

/// Returns ask(a, b, monitor, workspace), computed without the GIL.
template <class Ask>
auto asked_of_prepared(const Prepared& a, const Prepared& b, const py::object& pose_a, const py::object& pose_b,
                       Ask ask) {
  const PlacedBody first = placed_from(a, pose_a, "pose_a"), second = placed_from(b, pose_b, "pose_b");
  return watched([&](Monitor& monitor) {
    thread_local Workspace workspace;
    return ask(first, second, &monitor, &workspace);
  });
}

PairAnswer depth_of(const Prepared& a, const Prepared& b, const py::object& pose_a, const py::object& pose_b,
                    const py::object& start, const std::optional<std::size_t>& optima) {
  WarmStart warm;
  try {
    if (!start.is_none()) warm.differences = start.cast<decltype(warm.differences)>();
  } catch (const py::cast_error&) {
    throw py::type_error("start: expected a list of pairs of indices");
  }
  Question asked_for = question("automatic", optima, SignedDepthOptions{}.bits);
  PairAnswer result =
      asked_of_prepared(a, b, pose_a, pose_b,
                        [&](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
                          Options options = asked_for.options;
                          options.monitor = monitor;
                          options.workspace = workspace;
                          Depth depth = penetration_depth(first, second, start.is_none() ? nullptr : &warm, options);
                          return PairAnswer{moved(first), moved(second), asked_for, Answer{std::move(depth)}};
                        });
  if (!start.is_none()) start[py::slice(py::none(), py::none(), py::none())] = py::cast(warm.differences);
  return result;
}

std::string overlap_of_prepared(const Prepared& a, const Prepared& b, const py::object& pose_a,
                                const py::object& pose_b) {
  const auto ask = [](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
    return overlap(first, second, {.monitor = monitor, .workspace = workspace});
  };
  return std::string(name(*asked_of_prepared(a, b, pose_a, pose_b, ask).status));
}

bool closer_than_of_prepared(const Prepared& a, const Prepared& b, const py::object& distance, const py::object& pose_a,
                             const py::object& pose_b) {
  const mpq_class limit = number_from(distance);
  const auto ask = [&](const PlacedBody& first, const PlacedBody& second, Monitor* monitor, Workspace* workspace) {
    return closer_than(first, second, limit, {.monitor = monitor, .workspace = workspace});
  };
  return *asked_of_prepared(a, b, pose_a, pose_b, ask).closer;
}

}  // namespace

void bind_questions(py::module_& module) {
  using py::arg;
  py::class_<Prepared>(module, "Prepared")
      .def(py::init([](const py::object& from) {
             const Body body = body_from(from, py::none(), "body");
             warn_of_dents(body, "the body");
             return Prepared(body);
           }),
           arg("body"))
      .def_property_readonly("body", &Prepared::body)
      .def_property_readonly("extreme_points",
                             [](const Prepared& prepared) { return py::tuple(py::cast(prepared.extreme_points())); })
      .def("depth", depth_of, arg("other"), arg("pose_a"), arg("pose_b"), arg("start"), arg("optima"))
      .def("overlap", overlap_of_prepared, arg("other"), arg("pose_a"), arg("pose_b"))
      .def("closer_than", closer_than_of_prepared, arg("other"), arg("distance"), arg("pose_a"), arg("pose_b"));
  module.def("overlap", overlap_of, arg("a"), arg("b"), arg("proof"), arg("pose_a"), arg("pose_b"));
  module.def("closer_than", closer_than_of, arg("a"), arg("b"), arg("distance"), arg("proof"), arg("pose_a"),
             arg("pose_b"));
  module.def("ray", ray, arg("a"), arg("b"), arg("direction"), arg("pose_a"), arg("pose_b"));
  module.def("growth", growth, arg("a"), arg("b"), arg("center_a"), arg("center_b"), arg("pose_a"), arg("pose_b"));
  module.def("metric", metric, arg("a"), arg("b"), arg("ball"), arg("pose_a"), arg("pose_b"));
  module.def("approx", approx, arg("a"), arg("b"), arg("delta"), arg("pose_a"), arg("pose_b"));
  module.def("study", study_of, arg("a"), arg("b"), arg("listed"), arg("pose_a"), arg("pose_b"));
  module.def("judge", judged, arg("a"), arg("b"), arg("claim"), arg("pose_a"), arg("pose_b"));
}

}  // namespace fathom::python
