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
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/boundary.hpp"
#include "fathom/numbers.hpp"
#include "verify/judge/fields.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::c {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The verdicts by their numbers for C.
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
                                Verdict::too_near,
                                Verdict::contact_outside,
                                Verdict::contact_too_deep,
                                Verdict::contact_too_shallow,
                                Verdict::misses_extent,
                                Verdict::tips,
                                Verdict::wrong_derivative};
static_assert(std::size(verdicts) == FATHOM_VERDICT_WRONG_DERIVATIVE + 1 &&
              std::size(verdicts) == static_cast<std::size_t>(Verdict::pass) + 1);
static_assert(verdicts[FATHOM_VERDICT_NAN] == Verdict::nan &&
              verdicts[FATHOM_VERDICT_TOO_SHALLOW] == Verdict::too_shallow);
static_assert(verdicts[FATHOM_VERDICT_WITNESS_OFF] == Verdict::witness_off &&
              verdicts[FATHOM_VERDICT_PASS] == Verdict::pass);
static_assert(verdicts[FATHOM_VERDICT_TOO_NEAR] == Verdict::too_near && verdicts[FATHOM_VERDICT_TIPS] == Verdict::tips);

int number_of(Verdict verdict) { return static_cast<int>(std::ranges::find(verdicts, verdict) - std::begin(verdicts)); }

static_assert(static_cast<int>(Status::penetrating) == FATHOM_PENETRATING &&
              static_cast<int>(Status::disjoint) == FATHOM_DISJOINT);
static_assert(static_cast<int>(Accuracy::correctly_rounded) == FATHOM_CORRECTLY_ROUNDED);
static_assert(static_cast<int>(Accuracy::tolerance) == FATHOM_WITHIN_TOLERANCE);

/// Throws std::invalid_argument where the claim cannot be judged. Its numbers may be any: those are
/// judged.
void require_claim(const fathom_claim& claim) {
  const auto demand = [](bool holds, const char* sentence) {
    if (!holds) throw std::invalid_argument(std::string("claim: ") + sentence);
  };
  const auto is_tolerance = [](double x) { return std::isfinite(x) && x >= 0; };
  demand(claim.precision == FATHOM_BINARY64 || claim.precision == FATHOM_BINARY32, "there is no such precision");
  demand(claim.answers >= FATHOM_SAME_PRECISION && claim.answers <= FATHOM_BINARY32,
         "there is no such precision of answers");
  demand(claim.touching >= FATHOM_TOUCHING_EITHER && claim.touching <= FATHOM_TOUCHING_IS_APART,
         "there is no such convention of touching");
  demand(is_tolerance(claim.tol_relative) && is_tolerance(claim.tol_absolute), "a tolerance is negative or not finite");
  demand(claim.tol_ulps >= 0 && claim.tol_ulps <= 1e9 && std::floor(claim.tol_ulps) == claim.tol_ulps,
         "the tolerance in ulps is not a whole number from 0 to 1e9");
  demand(claim.policy >= FATHOM_POLICY_DECLARED && claim.policy <= FATHOM_POLICY_WITHIN, "there is no such policy");
  demand(is_tolerance(claim.policy_most), "what the policy allows is negative or not finite");
  require_at_most(claim.contact_count, "contacts of a claim");
  demand(claim.contact_count == 0 || claim.contact_positions != nullptr, "contacts without their positions");
  demand(!claim.has_manifold || is_tolerance(claim.contact_margin), "the contacts' margin is negative or not finite");
  demand(!claim.has_patch_slack || is_tolerance(claim.patch_slack), "the patch's slack is negative or not finite");
}

/// Of bodies of the plane z is not read.
std::optional<Triple> triple(int given, const double* p, unsigned dimension) {
  if (!given) return std::nullopt;
  return Triple{p[0], p[1], dimension == 2 ? 0 : p[2]};
}

std::optional<ContactLimits> manifold_of(const fathom_claim& claim) {
  if (!claim.has_manifold) return std::nullopt;
  return ContactLimits{claim.most_contacts ? std::optional(claim.most_contacts) : std::nullopt, claim.contact_margin};
}

Conventions conventions_of(const fathom_claim& claim) {
  using Touching = Conventions::Touching;
  return {.touching = claim.touching == FATHOM_TOUCHING_IS_OVERLAP ? Touching::overlap
                      : claim.touching == FATHOM_TOUCHING_IS_APART ? Touching::separate
                                                                   : Touching::either,
          .depth = claim.depth_negative ? Conventions::Sign::negative : Conventions::Sign::positive,
          .moves = claim.moves_b ? Conventions::Body::b : Conventions::Body::a,
          .unit = claim.not_unit == 0,
          .claims = claim.separating ? Conventions::Claims::separating : Conventions::Claims::minimum,
          .manifold = manifold_of(claim)};
}

NumberFormat format_of(const fathom_claim& claim) {
  const auto precision = [](int number) {
    return number == FATHOM_BINARY32 ? Precision::binary32 : Precision::binary64;
  };
  return {precision(claim.precision),
          precision(claim.answers == FATHOM_SAME_PRECISION ? claim.precision : claim.answers)};
}

Reply reply_of(const fathom_claim& claim, unsigned dimension) {
  Reply reply;
  reply.overlap = claim.overlap != 0;
  if (claim.has_depth) reply.depth = claim.depth;
  reply.direction = triple(claim.has_direction, claim.direction, dimension);
  reply.witness_a = triple(claim.has_witness_a, claim.witness_a, dimension);
  reply.witness_b = triple(claim.has_witness_b, claim.witness_b, dimension);
  if (claim.has_distance) reply.distance = claim.distance;
  if (claim.has_derivative) reply.derivative = claim.derivative;
  for (std::size_t i = 0; i < claim.contact_count; ++i) {
    const std::optional<double> depth = claim.contact_depths ? std::optional(claim.contact_depths[i]) : std::nullopt;
    reply.contacts.push_back({*triple(true, claim.contact_positions + 3 * i, dimension), depth});
  }
  return reply;
}

Policy policy_of(const fathom_claim& claim) {
  constexpr Policy::Kind kinds[] = {Policy::Kind::declared, Policy::Kind::minimum, Policy::Kind::separating,
                                    Policy::Kind::within};
  return {kinds[claim.policy], exact_value(claim.policy_most)};
}

// ---- out: fields of a judgement, by the table in verify/judge/fields.hpp ----

/// Where the number of a field goes: to one member, or rounded down and up to two. Of a derivative
/// the second is the error.
struct Place {
  std::string_view field;
  double fathom_judgement::*low;
  double fathom_judgement::*high = nullptr;
};
using To = fathom_judgement;
constexpr Place places[] = {
    {"signed_depth", &To::signed_depth_low, &To::signed_depth_high},
    {"error", &To::error},
    {"error_ulps", &To::error_ulps},
    {"error_relative", &To::error_relative},
    {"error_u_r", &To::error_u_r},
    {"separating_distance_squared", &To::separating_distance_low, &To::separating_distance_high},
    {"exit_distance_squared", &To::exit_distance},
    {"separating_distance", &To::separating_distance_low, &To::separating_distance_high},
    {"inconsistency", &To::inconsistency},
    {"overlap_left", &To::overlap_left},
    {"witness_a_squared", &To::witness_a_low, &To::witness_a_high},
    {"witness_b_squared", &To::witness_b_low, &To::witness_b_high},
    {"witness_a_distance", &To::witness_a_low, &To::witness_a_high},
    {"witness_b_distance", &To::witness_b_low, &To::witness_b_high},
    {"witness_gap", &To::witness_gap},
    {"contact_a_squared", &To::contact_a_low, &To::contact_a_high},
    {"contact_b_squared", &To::contact_b_low, &To::contact_b_high},
    {"contact_a_distance", &To::contact_a_low, &To::contact_a_high},
    {"contact_b_distance", &To::contact_b_low, &To::contact_b_high},
    {"deepest", &To::deepest},
    {"relative_excess", &To::relative_excess},
    {"deepest_pair", &To::deepest_pair},
    {"hulls_squared", &To::hulls},
    {"deeper_than_pair", &To::deeper_than_pair},
    {"deeper", &To::deeper},
    {"deeper_squared", &To::deeper},
    {"extent_missed", &To::extent_missed},
    {"extent_missed_squared", &To::extent_missed},
    {"extent_covered", &To::extent_covered},
    {"extent_covered_squared", &To::extent_covered},
    {"derivative", &To::derivative, &To::derivative_error}};

constexpr const Place* place_of(std::string_view field) {
  for (const Place& place : places)
    if (place.field == field) return &place;
  return nullptr;
}

/// A length of polytopes by its signed square.
void put(To& to, const Place& place, const mpq_class& signed_square) {
  const Surd value{0, signed_square};
  to.*place.low = round_binary64(value, place.high ? Rounding::rd : Rounding::rn);
  if (place.high) to.*place.high = round_binary64(value, Rounding::ru);
}
void put(To& to, const Place& place, double value) { to.*place.low = value; }
void put(To& to, const Place& place, const Between& bounds) {
  to.*place.low = bounds.low;
  to.*place.high = bounds.high;
}
void put(To& to, const Place& place, const UnionBounds& bounds) {
  put(to, place, bounds.deepest_pair);
  to.deepest_pieces[0] = bounds.a;
  to.deepest_pieces[1] = bounds.b;
}
void put(To& to, const Place& place, const DerivativeJudgement& derivative) {
  to.*place.high = derivative.error.value_or(none);
  if (derivative.squared) to.*place.low = round_binary64(Surd{0, *derivative.squared});
}
template <class T>
void put(To& to, const Place& place, const std::optional<T>& value) {
  if (value) put(to, place, *value);
}

// The fields that are no numbers, and the truth, which is handed out as that of an answer is.
void put_word(To& to, Verdict verdict) { to.verdict = number_of(verdict); }
void put_word(To& to, const std::vector<Verdict>& findings) {
  for (const Verdict finding : findings) to.findings |= 1U << static_cast<unsigned>(number_of(finding));
}
void put_word(To& to, const std::optional<Accuracy>& accuracy) {
  to.accuracy = accuracy ? static_cast<int>(*accuracy) : FATHOM_NO_CLASS;
}
void put_word(To& to, const std::optional<Status>& status) { to.status = status_of(status); }
void put_word(To& to, bool excess_allowed) { to.excess_allowed = excess_allowed; }
void put_word(To&, const std::string&) {}  // the sentence is a text of its own
void put_word(To&, const mpq_class&) {}    // the squares of the truth, which signed_depth has

To judgement_of(const Judgement& from, const RoundedDepth& truth) {
  To to;
  fathom_judgement_init(&to);
  text::for_each_field(judging::judgement_fields, [&](const auto& field) {
    const auto& value = text::value_of(field, from);
    if constexpr (requires { put_word(to, value); }) put_word(to, value);
    else put(to, *place_of(field.name), value);
  });
  to.signed_depth = truth.nearest;
  to.signed_depth_low = truth.low;
  to.signed_depth_high = truth.high;
  return to;
}

/// Whether each field of numbers has its place, and each place a field.
constexpr bool places_are_complete() {
  std::size_t found = 0;
  bool all = true;
  text::for_each_field(judging::judgement_fields, [&](const auto& field) {
    using Value = std::decay_t<decltype(text::value_of(field, std::declval<const Judgement&>()))>;
    constexpr bool is_word = requires(To & to, const Value& value) { put_word(to, value); };
    if (place_of(field.name)) ++found;
    else if (!is_word) all = false;
  });
  return all && found == std::size(places);
}
static_assert(places_are_complete(), "each number of a judgement has its member of fathom_judgement");

// ---- judging ----

Body seen_from(const Body& body, const NumberFormat& format, const char* body_name) {
  std::optional<Body> seen = judging::body_seen(body, format);
  if (!seen)
    throw std::invalid_argument(std::string(body_name) + ": a coordinate is beyond " +
                                std::string(name(format.points)));
  return *std::move(seen);
}

void judge_claim(const Body& a, const Body& b, const fathom_claim& claim, fathom_judgement& judgement,
                 std::string& sentence) {
  require_claim(claim);
  const NumberFormat format = format_of(claim);
  Tolerance tolerance{exact_value(claim.tol_relative), exact_value(claim.tol_absolute),
                      static_cast<unsigned long>(claim.tol_ulps), policy_of(claim)};
  if (claim.has_patch_slack) tolerance.patch_slack = exact_value(claim.patch_slack);
  std::optional<Motion> motion;
  if (claim.has_derivative) motion = {twist_from(claim.twist_a, "twist_a"), twist_from(claim.twist_b, "twist_b")};
  const judging::AnyTruth truth = judging::truth_of(seen_from(a, format, "a"), seen_from(b, format, "b"));
  const Judgement found =
      judging::judged(truth, reply_of(claim, a.dimension), conventions_of(claim), format, tolerance, motion);
  judgement = judgement_of(found, std::visit([](const auto& known) { return rounded(Answer{known.depth}); }, truth));
  sentence = found.sentence;
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
  judgement->signed_depth = none;
  for (const Place& place : places) {
    judgement->*place.low = none;
    if (place.high) judgement->*place.high = none;
  }
}

int fathom_judge(const fathom_body* a, const fathom_body* b, const fathom_claim* claim, fathom_judgement* judgement,
                 char** sentence) {
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
  return verdict < 0 || verdict >= static_cast<int>(std::size(verdicts)) ? nullptr
                                                                         : fathom::name(verdicts[verdict]).data();
}

int fathom_verdict_passes(int verdict) {
  return verdict == FATHOM_VERDICT_PASS || verdict == FATHOM_VERDICT_TOUCHING_BY_CONVENTION;
}
