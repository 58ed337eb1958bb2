// SPDX-License-Identifier: GPL-3.0-or-later
// The judge for C: plain structs in and out.
#include "fathom/judge.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "c/boundary.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::c {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The verdicts by their numbers for C, which are in order of rank but for the last two.
constexpr Verdict verdicts[] = {Verdict::crash,
                                Verdict::time_out,
                                Verdict::silent,
                                Verdict::garbage,
                                Verdict::failed,
                                Verdict::nan,
                                Verdict::false_separation,
                                Verdict::false_overlap,
                                Verdict::not_a_direction,
                                Verdict::wrong_sign,
                                Verdict::too_deep,
                                Verdict::too_shallow,
                                Verdict::not_separating,
                                Verdict::inconsistent,
                                Verdict::witness_off,
                                Verdict::not_invariant,
                                Verdict::unsupported,
                                Verdict::touching_by_convention,
                                Verdict::pass,
                                Verdict::too_far,
                                Verdict::too_near};
static_assert(std::size(verdicts) == FATHOM_VERDICT_TOO_NEAR + 1 && std::size(verdicts) == static_cast<std::size_t>(Verdict::pass) + 1);
static_assert(verdicts[FATHOM_VERDICT_NAN] == Verdict::nan && verdicts[FATHOM_VERDICT_TOO_SHALLOW] == Verdict::too_shallow);
static_assert(verdicts[FATHOM_VERDICT_WITNESS_OFF] == Verdict::witness_off && verdicts[FATHOM_VERDICT_PASS] == Verdict::pass);

int number_of(Verdict verdict) { return static_cast<int>(std::ranges::find(verdicts, verdict) - std::begin(verdicts)); }

static_assert(static_cast<int>(Status::penetrating) == FATHOM_PENETRATING && static_cast<int>(Status::disjoint) == FATHOM_DISJOINT);
static_assert(static_cast<int>(Accuracy::correctly_rounded) == FATHOM_CORRECTLY_ROUNDED);
static_assert(static_cast<int>(Accuracy::tolerance) == FATHOM_WITHIN_TOLERANCE);

/// Throws std::invalid_argument where the claim cannot be judged. Its numbers may be any: those are judged.
void require_claim(const fathom_claim& claim) {
  const auto demand = [](bool holds, const char* sentence) {
    if (!holds) throw std::invalid_argument(std::string("claim: ") + sentence);
  };
  const auto is_tolerance = [](double x) { return std::isfinite(x) && x >= 0; };
  demand(claim.precision == FATHOM_BINARY64 || claim.precision == FATHOM_BINARY32, "there is no such precision");
  demand(claim.answers >= FATHOM_SAME_PRECISION && claim.answers <= FATHOM_BINARY32, "there is no such precision of answers");
  demand(claim.touching >= FATHOM_TOUCHING_EITHER && claim.touching <= FATHOM_TOUCHING_IS_APART, "there is no such convention of touching");
  demand(is_tolerance(claim.tol_relative) && is_tolerance(claim.tol_absolute), "a tolerance is negative or not finite");
  demand(claim.tol_ulps >= 0 && claim.tol_ulps <= 1e9 && std::floor(claim.tol_ulps) == claim.tol_ulps,
         "the tolerance in ulps is not a whole number from 0 to 1e9");
  demand(claim.policy >= FATHOM_POLICY_DECLARED && claim.policy <= FATHOM_POLICY_WITHIN, "there is no such policy");
  demand(is_tolerance(claim.policy_most), "what the policy allows is negative or not finite");
  require_at_most(claim.contact_count, "contacts of a claim");
  demand(claim.contact_count == 0 || claim.contact_positions != nullptr, "contacts without their positions");
}

std::optional<Triple> triple(int given, const double* p) {
  if (!given) return std::nullopt;
  return Triple{p[0], p[1], p[2]};
}

Conventions conventions_of(const fathom_claim& claim) {
  using Touching = Conventions::Touching;
  return {.touching = claim.touching == FATHOM_TOUCHING_IS_OVERLAP ? Touching::overlap
                      : claim.touching == FATHOM_TOUCHING_IS_APART ? Touching::separate
                                                                   : Touching::either,
          .depth = claim.depth_negative ? Conventions::Sign::negative : Conventions::Sign::positive,
          .moves = claim.moves_b ? Conventions::Body::b : Conventions::Body::a,
          .unit = claim.not_unit == 0,
          .claims = claim.separating ? Conventions::Claims::separating : Conventions::Claims::minimum};
}

NumberFormat format_of(const fathom_claim& claim) {
  const auto precision = [](int number) { return number == FATHOM_BINARY32 ? Precision::binary32 : Precision::binary64; };
  return {precision(claim.precision), precision(claim.answers == FATHOM_SAME_PRECISION ? claim.precision : claim.answers)};
}

Reply reply_of(const fathom_claim& claim) {
  Reply reply;
  reply.overlap = claim.overlap != 0;
  if (claim.has_depth) reply.depth = claim.depth;
  reply.direction = triple(claim.has_direction, claim.direction);
  reply.witness_a = triple(claim.has_witness_a, claim.witness_a);
  reply.witness_b = triple(claim.has_witness_b, claim.witness_b);
  if (claim.has_distance) reply.distance = claim.distance;
  for (std::size_t i = 0; i < claim.contact_count; ++i) {
    const std::optional<double> depth = claim.contact_depths ? std::optional(claim.contact_depths[i]) : std::nullopt;
    reply.contacts.push_back({*triple(true, claim.contact_positions + 3 * i), depth});
  }
  return reply;
}

Policy policy_of(const fathom_claim& claim) {
  constexpr Policy::Kind kinds[] = {Policy::Kind::declared, Policy::Kind::minimum, Policy::Kind::separating, Policy::Kind::within};
  return {kinds[claim.policy], exact_value(claim.policy_most)};
}

/// A length of polytopes by its signed square, or of shapes by its bounds.
void set_bounds(double& low, double& high, const std::optional<mpq_class>& signed_square, const std::optional<Between>& bounds) {
  if (bounds) {
    low = bounds->low;
    high = bounds->high;
  } else if (signed_square) {
    const Surd value{0, *signed_square};
    low = round_binary64(value, Rounding::rd);
    high = round_binary64(value, Rounding::ru);
  }
}

fathom_judgement judgement_of(const Judgement& from, int status, const RoundedDepth& truth) {
  fathom_judgement to;
  fathom_judgement_init(&to);
  to.verdict = number_of(from.verdict);
  for (const Verdict finding : from.findings) to.findings |= 1U << static_cast<unsigned>(number_of(finding));
  to.accuracy = from.accuracy ? static_cast<int>(*from.accuracy) : FATHOM_NO_CLASS;
  to.status = status;
  to.signed_depth = truth.nearest;
  to.signed_depth_low = truth.low;
  to.signed_depth_high = truth.high;
  to.error = from.error.value_or(none);
  to.error_ulps = from.error_ulps.value_or(none);
  to.error_relative = from.error_relative.value_or(none);
  to.error_u_r = from.error_u_r.value_or(none);
  set_bounds(to.price_low, to.price_high, from.price_squared, from.price);
  if (from.travel_squared) to.travel = round_binary64(Surd{0, *from.travel_squared});
  to.inconsistency = from.inconsistency.value_or(none);
  to.overlap_left = from.overlap_left.value_or(none);
  set_bounds(to.witness_a_low, to.witness_a_high, from.witness_a_squared, from.witness_a_distance);
  set_bounds(to.witness_b_low, to.witness_b_high, from.witness_b_squared, from.witness_b_distance);
  to.witness_gap = from.witness_gap.value_or(none);
  to.longer = from.longer;
  to.dearer = from.dearer.value_or(none);
  set_bounds(to.contact_a_low, to.contact_a_high, from.contact_a_squared, from.contact_a_distance);
  set_bounds(to.contact_b_low, to.contact_b_high, from.contact_b_squared, from.contact_b_distance);
  to.deepest = from.deepest.value_or(none);
  return to;
}

/// The points as the implementation saw them.
GivenPoints seen_points(const Body& body, Precision precision, const char* body_name) {
  std::optional<GivenPoints> points = seen(body.points, precision);
  if (!points) throw std::invalid_argument(std::string(body_name) + ": a coordinate is beyond " + std::string(name(precision)));
  return *std::move(points);
}

Shape seen_shape(const Body& body, Precision precision, const char* body_name) {
  return body.shape ? *body.shape : hull(seen_points(body, precision, body_name).exact());
}

/// Judges by the truth about two polytopes, or about two shapes.
template <class TheTruth>
void judge_by(const TheTruth& truth, const fathom_claim& claim, fathom_judgement& judgement, std::string& sentence) {
  const Tolerance tolerance{exact_value(claim.tol_relative), exact_value(claim.tol_absolute), static_cast<unsigned long>(claim.tol_ulps),
                            policy_of(claim)};
  const Judgement found = judge(truth, reply_of(claim), conventions_of(claim), format_of(claim), tolerance);
  judgement = judgement_of(found, status_of({truth.depth}), rounded({truth.depth}));
  sentence = found.sentence;
}

void judge_claim(const Body& a, const Body& b, const fathom_claim& claim, fathom_judgement& judgement, std::string& sentence) {
  require_claim(claim);
  require_convex(a, "a");
  require_convex(b, "b");
  const Precision precision = format_of(claim).points;
  if (!a.shape && !b.shape) {
    judge_by(truth_about(seen_points(a, precision, "a"), seen_points(b, precision, "b")), claim, judgement, sentence);
  } else {
    judge_by(truth_about(seen_shape(a, precision, "a"), seen_shape(b, precision, "b")), claim, judgement, sentence);
  }
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

void fathom_claim_init(fathom_claim* claim) {
  if (claim == nullptr) return;
  *claim = {};
  claim->size = sizeof(fathom_claim);
  claim->answers = FATHOM_SAME_PRECISION;
  claim->tol_relative = 1e-3;
  claim->tol_absolute = 1e-6;
}

void fathom_judgement_init(fathom_judgement* judgement) {
  if (judgement == nullptr) return;
  *judgement = {};
  judgement->size = sizeof(fathom_judgement);
  judgement->verdict = judgement->accuracy = judgement->status = -1;
  for (double* number : {&judgement->signed_depth,   &judgement->signed_depth_low, &judgement->signed_depth_high,
                         &judgement->error,          &judgement->error_ulps,       &judgement->error_relative,
                         &judgement->error_u_r,      &judgement->price_low,        &judgement->price_high,
                         &judgement->travel,         &judgement->inconsistency,    &judgement->overlap_left,
                         &judgement->witness_a_low,  &judgement->witness_a_high,   &judgement->witness_b_low,
                         &judgement->witness_b_high, &judgement->witness_gap,      &judgement->dearer,
                         &judgement->contact_a_low,  &judgement->contact_a_high,   &judgement->contact_b_low,
                         &judgement->contact_b_high, &judgement->deepest}) {
    *number = none;
  }
}

int fathom_judge(const fathom_body* a, const fathom_body* b, const fathom_claim* claim, fathom_judgement* judgement, char** sentence) {
  if (sentence) *sentence = nullptr;
  return guarded([&] {
    require_struct(judgement, "judgement");
    fathom_judgement_init(judgement);
    require(a, "a");
    require(b, "b");
    require_struct(claim, "claim");
    fathom_judgement result;
    std::string text;
    judge_claim(*a->body, *b->body, *claim, result, text);
    if (sentence) *sentence = text_for_caller(text);
    *judgement = result;
  });
}

const char* fathom_verdict_name(int verdict) {
  return verdict < 0 || verdict > FATHOM_VERDICT_TOO_NEAR ? nullptr : fathom::name(verdicts[verdict]).data();
}

int fathom_verdict_passes(int verdict) { return verdict == FATHOM_VERDICT_PASS || verdict == FATHOM_VERDICT_TOUCHING_BY_CONVENTION; }
