// SPDX-License-Identifier: GPL-3.0-or-later
// The question how deep, or how far apart, two bodies are, and what its answer tells: doubles,
// exact numbers, JSON, its certificate; and the independent checker.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/c/boundary.hpp"
#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "fathom/overlap.hpp"
#include "fathom/prepared.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/files/cases.hpp"
#include "reference/output/answer_json.hpp"
#include "reference/rounded/coordinates.hpp"
#include "verify/check/check.hpp"
#include "verify/check/comparisons.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"

namespace fathom::c {
namespace {

/// The part of the answer, which the caller asked for.
template <class T>
T present(const Part<T>& part) {
  if (!part) throw Absence(std::string(part.why_not));
  return *part;
}

void copy(const SurdPoint& from, double* to) { copy_numbers(rounded::nearest_binary64(from), to); }

/// What the caller asks, by the monitor of this call.
Question question_of(const fathom_options& given, Monitor& monitor) {
  thread_local Workspace workspace;
  Question question;
  if (given.optima != 0) question.options.optima = given.optima;
  question.options.monitor = &monitor;
  question.options.workspace = &workspace;
  question.bits = given.bits;
  return question;
}

fathom_answer answer_about(const fathom_body& a, const fathom_body& b, const fathom_options& given) {
  CallersMonitor monitor(given);
  const Question question = question_of(given, monitor);
  return {a.body, b.body, exact_answer(*a.body, *b.body, question), question.options.optima};
}

/// A finite distance, exactly.
mpq_class distance_from(double distance) {
  if (!std::isfinite(distance)) throw std::invalid_argument("distance: expected a finite number above 0");
  return distance;
}

int int_of(const std::optional<bool>& closer) { return closer ? (*closer ? 1 : 0) : -1; }

PlacedBody placed_from(const fathom_prepared* prepared, const double* pose, const std::string& name) {
  require(prepared, name.c_str());
  PlacedBody placed{prepared->prepared};
  if (pose != nullptr) placed.pose = pose_from(pose, "pose_" + name);
  return placed;
}

WarmStart start_from(const fathom_warm_start& given) {
  if (given.count > most_start_differences)
    throw std::invalid_argument("start: expected at most " + std::to_string(most_start_differences) +
                                " differences, found " + std::to_string(given.count));
  WarmStart start;
  for (std::size_t i = 0; i < given.count; ++i) start.differences.emplace_back(given.a[i], given.b[i]);
  return start;
}

void copy(const WarmStart& from, fathom_warm_start& to) {
  to.count = 0;
  for (const auto& [i, j] : from.differences) {
    to.a[to.count] = i;
    to.b[to.count++] = j;
  }
}

/// What `ask` says of both bodies in their poses without a depth.
template <class Ask>
auto asked_of_prepared(const fathom_prepared* a, const double* pose_a, const fathom_prepared* b, const double* pose_b,
                       const fathom_options* given, Ask ask) {
  const PlacedBody first = placed_from(a, pose_a, "a"), second = placed_from(b, pose_b, "b");
  const fathom_options options = options_from(given);
  CallersMonitor monitor(options);
  const Question question = question_of(options, monitor);
  return ask(first, second, OverlapOptions{false, question.bits, &monitor, question.options.workspace});
}

/// The answer of `ask`, which gets what the caller asks; `proof` gets the text of its proof.
template <class Ask, class Text>
auto asked_with_proof(const fathom_body* a, const fathom_body* b, const fathom_options* given, char** proof, Ask ask,
                      Text text) {
  require(a, "a");
  require(b, "b");
  const fathom_options options = options_from(given);
  CallersMonitor monitor(options);
  const Question question = question_of(options, monitor);
  const auto found =
      ask(*a->body, *b->body, OverlapOptions{proof != nullptr, question.bits, &monitor, question.options.workspace});
  if (proof) *proof = text_for_caller(text(*found.proof));
  return found;
}

// ---- exact texts ----

std::string text_of(const Vector& n) { return n.x.get_str() + " " + n.y.get_str() + " " + n.z.get_str(); }

std::string text_of(const OverlapProof& proof) {
  std::string text;
  if (proof.common) text += "common " + coordinates_text(rounded::coordinates(*proof.common)) + "\n";
  if (proof.normal) text += "normal " + text_of(*proof.normal) + "\n";
  if (!proof.around.empty()) text += "around";
  for (const auto& [i, j] : proof.around) text += " " + std::to_string(i) + " " + std::to_string(j);
  return text + (proof.around.empty() ? "" : "\n");
}

std::string text_of(const ClosenessProof& proof) {
  if (proof.normal) return "normal " + text_of(*proof.normal) + "\n";
  return "points " + coordinates_text(rounded::coordinates(proof.points->a)) + " " +
         coordinates_text(rounded::coordinates(proof.points->b)) + "\n";
}

std::string exact_of(const Answer& answer, int quantity) {
  switch (quantity) {
    case FATHOM_SIGNED_DEPTH:
      return answer.exact() ? surd_text(*answer.exact())
                            : "[" + surd_text(answer.low()) + "," + surd_text(answer.high()) + "]";
    case FATHOM_DIRECTION: return text_of(present(answer.direction()));
    case FATHOM_TRANSLATION: return coordinates_text(present(answer.translation()));
    case FATHOM_WITNESS_A: return coordinates_text(present(answer.witness()).a);
    case FATHOM_WITNESS_B: return coordinates_text(present(answer.witness()).b);
    case FATHOM_DEEPEST_PAIR: return surd_text(Surd{0, present(answer.union_bounds()).deepest_pair});
    case FATHOM_HULLS: return surd_text(Surd{0, present(answer.union_bounds()).hulls});
    default: throw std::invalid_argument("quantity: expected one from 0 to 6, found " + std::to_string(quantity));
  }
}

std::string certificate_of(const fathom_answer& asked, const std::string& id, const fathom_options& options) {
  CallersMonitor monitor(options);
  if (!asked.answer.complete()) throw Absence(std::string(asked.answer.exact().why_not));
  const output::Manifold* const manifold = options.patches ? &asked.manifold->of(asked) : nullptr;
  std::string text = output::certificate_of(*asked.a, *asked.b, asked.answer, manifold, {}, id, &monitor);
  try {
    fathom_check::require_readable(text);
  } catch (const fathom_check::Unreadable& refusal) {
    throw Absence(refusal.what());
  }
  return text;
}

output::AboutBodies about_bodies_of(const fathom_answer& asked, const std::string& id) {
  return output::about_bodies(Case{id, *asked.a, *asked.b}, false);
}

std::size_t ways_out(const fathom_answer& answer) {
  const std::size_t all = answer.answer.ways_out();
  return answer.listed ? std::min(all, *answer.listed) : all;
}

/// Throws std::invalid_argument unless there are more ways out than this.
void require_way_out(const fathom_answer& answer, std::size_t index) {
  require_below(index, ways_out(answer), "index", "optima");
}

// ---- the checker ----

text::Json points_json(const fathom_body& body, const char* name) {
  if (body.body->shape)
    throw std::invalid_argument(std::string(name) +
                                ": expected points, or pieces, to compare the certificate with, found a shape");
  Body bare;
  bare.dimension = body.body->dimension;
  if (body.body->pieces) bare.pieces = body.body->pieces;
  else bare.points = body.body->points;
  return files::body_json(bare);
}

/// Refuses a certificate that is not about these bodies.
fathom_check::Verdict verify_about(std::string_view text, const fathom_body& a, const fathom_body& b) {
  const unsigned dimension = a.body->dimension;
  if (b.body->dimension != dimension)
    throw std::invalid_argument("expected two bodies of the plane, or two of space, found one of each");
  const text::Json both{{"dimension", dimension}, {"a", points_json(a, "a")}, {"b", points_json(b, "b")}};
  const fathom_check::CaseFile bodies(both.text() + '\n');
  const fathom_check::Verdict alone = fathom_check::verify(text);
  if (!alone.accepted()) return alone;
  fathom_check::Lines lines(text, fathom_check::longest_line);
  const auto compare = [&](const fathom_check::Certificate& certificate) { bodies.compare(certificate); };
  return fathom_check::Reader(lines).next(compare).value_or(fathom_check::Verdict());
}

}  // namespace

void copy_numbers(const std::array<double, 3>& from, double* to) { std::ranges::copy(from, to); }

std::string coordinates_text(const SurdPoint& values) {
  return surd_text(values[0]) + " " + surd_text(values[1]) + " " + surd_text(values[2]);
}

std::string surd_text(const Surd& value) {
  std::string text = kernels::exact_surd_text(value);
  std::erase(text, ' ');
  return text;
}

std::string json_of(const fathom_answer& asked, const std::string& id, std::optional<output::Manifold> manifold) {
  const bool with_patches = manifold.has_value();
  const output::AnsweredCase answered{
      id, asked.answer,       about_bodies_of(asked, id), facts_of(*asked.a, *asked.b, asked.answer),
      {}, std::move(manifold)};
  return output::answer_json(answered, {.optima = asked.listed, .patch = with_patches});
}

int status_of(const std::optional<Status>& status) { return status ? static_cast<int>(*status) : FATHOM_UNDECIDED; }

RoundedDepth rounded(const Answer& answer) {
  return {answer.nearest_binary64().value_or(std::numeric_limits<double>::quiet_NaN()), answer.low_binary64(),
          answer.high_binary64()};
}

fathom_options options_from(const fathom_options* options) {
  fathom_options result;
  fathom_options_init(&result);
  if (options == nullptr) return result;
  require_struct(options, "options");
  if (options->bits > most_bound_bits)
    throw std::invalid_argument("options: expected at most " + std::to_string(most_bound_bits) + " bits, found " +
                                std::to_string(options->bits));
  return *options;
}

}  // namespace fathom::c

using namespace fathom::c;

void fathom_options_init(fathom_options* options) {
  if (options) *options = {sizeof(fathom_options), 0, fathom::SignedDepthOptions{}.bits, nullptr, nullptr, 0};
}

int fathom_depth(const fathom_body* a, const fathom_body* b, const fathom_options* options, fathom_answer** answer) {
  return make_handle(answer, [&] {
    require(a, "a");
    require(b, "b");
    return answer_about(*a, *b, options_from(options));
  });
}

void fathom_answer_free(fathom_answer* answer) { delete answer; }

const char* fathom_status_name(int status) {
  if (status == FATHOM_UNDECIDED) return fathom::name(std::optional<fathom::Status>()).data();
  return status < 0 || status > FATHOM_DISJOINT ? nullptr : fathom::name(static_cast<fathom::Status>(status)).data();
}

int fathom_answer_status(const fathom_answer* answer) { return answer ? status_of(answer->answer.status()) : -1; }

int fathom_answer_signed_depth(const fathom_answer* answer, double* nearest, double* low, double* high) {
  return guarded([&] {
    require(answer, "answer");
    const RoundedDepth value = rounded(answer->answer);
    if (nearest) *nearest = value.nearest;
    if (low) *low = value.low;
    if (high) *high = value.high;
  });
}

int fathom_answer_direction(const fathom_answer* answer, double direction[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(direction, "direction");
    copy_numbers(fathom::rounded::nearest_unit(present(answer->answer.direction())), direction);
  });
}

int fathom_answer_translation(const fathom_answer* answer, double translation[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(translation, "translation");
    copy(present(answer->answer.translation()), translation);
  });
}

int fathom_answer_witness(const fathom_answer* answer, double a[3], double b[3]) {
  return guarded([&] {
    require(answer, "answer");
    require(a, "a");
    require(b, "b");
    const fathom::SurdWitness witness = present(answer->answer.witness());
    copy(witness.a, a);
    copy(witness.b, b);
  });
}

size_t fathom_answer_optima(const fathom_answer* answer) {
  std::size_t count = 0;
  guarded([&] {
    require(answer, "answer");
    count = ways_out(*answer);
  });
  return count;
}

int fathom_answer_optimum(const fathom_answer* answer, size_t index, double direction[3], double translation[3]) {
  return guarded([&] {
    require(answer, "answer");
    require_way_out(*answer, index);
    const fathom::WayOut way = answer->answer.way_out(index);
    if (direction) copy_numbers(fathom::rounded::nearest_unit(way.direction), direction);
    if (translation) copy(way.translation, translation);
  });
}

int fathom_answer_exact(const fathom_answer* answer, int quantity, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return exact_of(answer->answer, quantity);
  });
}

int fathom_answer_dents(const fathom_answer* answer, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    std::string sentence = fathom::shapes::dents_text(about_bodies_of(*answer, "").hull);
    if (sentence.empty()) throw Absence("no mesh with faces is known that is not convex");
    return sentence;
  });
}

int fathom_answer_json(const fathom_answer* answer, const char* id, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return json_of(*answer, id ? id : "");
  });
}

int fathom_answer_certificate(const fathom_answer* answer, const char* id, const fathom_options* options, char** text) {
  return make_text(text, [&] {
    require(answer, "answer");
    return certificate_of(*answer, id ? id : "", options_from(options));
  });
}

// ---- without the depth ----

int fathom_overlap(const fathom_body* a, const fathom_body* b, const fathom_options* options, int* status,
                   char** proof) {
  if (proof) *proof = nullptr;
  return guarded([&] {
    require(status, "status");
    const auto ask = [](const fathom::Body& first, const fathom::Body& second, const fathom::OverlapOptions& how) {
      return fathom::overlap(first, second, how);
    };
    const fathom::Overlap found =
        asked_with_proof(a, b, options, proof, ask, [](const fathom::OverlapProof& shown) { return text_of(shown); });
    *status = status_of(found.status);
  });
}

int fathom_closer_than(const fathom_body* a, const fathom_body* b, double distance, const fathom_options* options,
                       int* closer, char** proof) {
  if (proof) *proof = nullptr;
  return guarded([&] {
    require(closer, "closer");
    const mpq_class limit = distance_from(distance);
    const auto ask = [&](const fathom::Body& first, const fathom::Body& second, const fathom::OverlapOptions& how) {
      return fathom::closer_than(first, second, limit, how);
    };
    const fathom::Closeness found =
        asked_with_proof(a, b, options, proof, ask, [](const fathom::ClosenessProof& shown) { return text_of(shown); });
    *closer = int_of(found.closer);
  });
}

// ---- prepared ----

int fathom_prepare(const fathom_body* body, fathom_prepared** prepared) {
  return make_handle(prepared, [&] {
    require(body, "body");
    return fathom_prepared{fathom::Prepared(*body->body)};
  });
}

int fathom_prepared_depth(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b,
                          const double pose_b[12], fathom_warm_start* start, const fathom_options* options,
                          fathom_answer** answer) {
  return make_handle(answer, [&] {
    const fathom::PlacedBody first = placed_from(a, pose_a, "a"), second = placed_from(b, pose_b, "b");
    const fathom_options given = options_from(options);
    CallersMonitor monitor(given);
    const fathom::Question question = question_of(given, monitor);
    fathom::WarmStart warm = start ? start_from(*start) : fathom::WarmStart();
    fathom::Depth depth = penetration_depth(first, second, start ? &warm : nullptr, question.options);
    if (start) copy(warm, *start);
    return fathom_answer{std::make_shared<const fathom::Body>(moved(first)),
                         std::make_shared<const fathom::Body>(moved(second)), fathom::Answer{std::move(depth)},
                         question.options.optima};
  });
}

int fathom_prepared_overlap(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b,
                            const double pose_b[12], const fathom_options* options, int* status) {
  return guarded([&] {
    require(status, "status");
    const auto ask = [](const auto& first, const auto& second, const fathom::OverlapOptions& how) {
      return fathom::overlap(first, second, how);
    };
    *status = status_of(asked_of_prepared(a, pose_a, b, pose_b, options, ask).status);
  });
}

int fathom_prepared_closer_than(const fathom_prepared* a, const double pose_a[12], const fathom_prepared* b,
                                const double pose_b[12], double distance, const fathom_options* options, int* closer) {
  return guarded([&] {
    require(closer, "closer");
    const mpq_class limit = distance_from(distance);
    const auto ask = [&](const auto& first, const auto& second, const fathom::OverlapOptions& how) {
      return fathom::closer_than(first, second, limit, how);
    };
    *closer = int_of(asked_of_prepared(a, pose_a, b, pose_b, options, ask).closer);
  });
}

void fathom_prepared_free(fathom_prepared* prepared) { delete prepared; }

// ---- of unions ----

int fathom_answer_clearance(const fathom_answer* answer, size_t index, int* clearance) {
  return guarded([&] {
    require(answer, "answer");
    require(clearance, "clearance");
    require_way_out(*answer, index);
    const auto* const unions = std::get_if<fathom::UnionDepth>(&answer->answer.found);
    *clearance = !unions || unions->optima[index].clearance ? 1 : 0;
  });
}

int fathom_answer_deepest_pair(const fathom_answer* answer, double* depth, size_t pieces[2]) {
  return guarded([&] {
    require(answer, "answer");
    const fathom::UnionBounds bounds = present(answer->answer.union_bounds());
    if (depth) *depth = fathom::root_binary64(bounds.deepest_pair);
    if (!pieces) return;
    pieces[0] = bounds.a;
    pieces[1] = bounds.b;
  });
}

int fathom_answer_hulls(const fathom_answer* answer, double* depth) {
  return guarded([&] {
    require(answer, "answer");
    require(depth, "depth");
    *depth = fathom::root_binary64(present(answer->answer.union_bounds()).hulls);
  });
}

// ---- the checker ----

int fathom_check_certificate(const char* certificate, size_t length, const fathom_body* a, const fathom_body* b,
                             int* outcome, char** line) {
  if (line) *line = nullptr;
  return guarded([&] {
    require(certificate, "certificate");
    require(outcome, "outcome");
    require_at_most(length, "bytes of a certificate");
    if ((a == nullptr) != (b == nullptr)) throw std::invalid_argument("expected both bodies or none, found one");
    const std::string_view text(certificate, length);
    const fathom_check::Verdict verdict = a ? verify_about(text, *a, *b) : fathom_check::verify(text);
    if (line) *line = text_for_caller(fathom_check::verdict_line(verdict, "certificate"));
    *outcome = static_cast<int>(verdict.outcome);
  });
}
