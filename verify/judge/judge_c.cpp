// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface: plain structs in and out; no exception leaves this file.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fathom/judge.h"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/surd.hpp"

namespace fathom::judging {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

static_assert(static_cast<int>(Verdict::pass) == FATHOM_PASS && static_cast<int>(Verdict::failed) == FATHOM_FAILED);
static_assert(static_cast<int>(Verdict::nan) == FATHOM_NAN && static_cast<int>(Verdict::false_overlap) == FATHOM_FALSE_OVERLAP);
static_assert(static_cast<int>(Verdict::too_deep) == FATHOM_TOO_DEEP && static_cast<int>(Verdict::witness_off) == FATHOM_WITNESS_OFF);
static_assert(static_cast<int>(Status::penetrating) == FATHOM_PENETRATING && static_cast<int>(Status::disjoint) == FATHOM_DISJOINT);
static_assert(static_cast<int>(Accuracy::correctly_rounded) == FATHOM_CORRECTLY_ROUNDED);
static_assert(static_cast<int>(Accuracy::tolerance) == FATHOM_WITHIN_TOLERANCE);

/// Why the claim cannot be judged; empty if it can.
std::string_view fault(const fathom_claim& claim) {
  const auto tolerance = [](double x) { return std::isfinite(x) && x >= 0; };
  if (claim.size != sizeof(fathom_claim)) return "the claim was not made by fathom_claim_init of this version";
  if (claim.a == nullptr || claim.b == nullptr || claim.a_count == 0 || claim.b_count == 0) return "a body has no points";
  if (claim.precision != FATHOM_BINARY64 && claim.precision != FATHOM_BINARY32) return "there is no such precision";
  if (claim.touching < FATHOM_TOUCHING_EITHER || claim.touching > FATHOM_TOUCHING_IS_APART)
    return "there is no such convention of touching";
  if (!tolerance(claim.tol_relative) || !tolerance(claim.tol_absolute)) return "a tolerance is negative or not finite";
  if (!(claim.tol_ulps >= 0 && claim.tol_ulps <= 1e9) || std::floor(claim.tol_ulps) != claim.tol_ulps) {
    return "the tolerance in ulps is not a whole number from 0 to 1e9";
  }
  return {};
}

std::vector<Triple> triples(const double* points, std::size_t count) {
  std::vector<Triple> result(count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(points + 3 * i, 3, result[i].begin());
  return result;
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
          .unit = claim.not_unit == 0};
}

Reply reply_of(const fathom_claim& claim) {
  Reply reply;
  reply.overlap = claim.overlap != 0;
  if (claim.has_depth) reply.depth = claim.depth;
  reply.direction = triple(claim.has_direction, claim.direction);
  reply.witness_a = triple(claim.has_witness_a, claim.witness_a);
  reply.witness_b = triple(claim.has_witness_b, claim.witness_b);
  return reply;
}

double rounded_root(const std::optional<mpq_class>& signed_square) {
  return signed_square ? kernels::nearest_binary64({0, *signed_square}) : none;
}

void fill(const Judgement& from, fathom_judgement& to) {
  to.verdict = static_cast<int>(from.verdict);
  for (const Verdict finding : from.findings) to.findings |= 1U << static_cast<unsigned>(finding);
  to.accuracy = from.accuracy ? static_cast<int>(*from.accuracy) : FATHOM_NO_CLASS;
  to.status = static_cast<int>(*from.status);
  to.true_depth = root_binary64(from.depth_squared, Rounding::rn);
  to.true_distance = root_binary64(from.distance_squared, Rounding::rn);
  to.error = from.error.value_or(none);
  to.error_ulps = from.error_ulps.value_or(none);
  to.error_relative = from.error_relative.value_or(none);
  to.error_u_r = from.error_u_r.value_or(none);
  to.price = rounded_root(from.price_squared);
  to.travel = rounded_root(from.travel_squared);
  to.inconsistency = from.inconsistency.value_or(none);
  to.overlap_left = from.overlap_left.value_or(none);
  to.witness_a_distance = rounded_root(from.witness_a_squared);
  to.witness_b_distance = rounded_root(from.witness_b_squared);
  to.witness_gap = from.witness_gap.value_or(none);
}

void copy(std::string_view text, char* to, std::size_t capacity) {
  if (to == nullptr || capacity == 0) return;
  const std::size_t length = std::min(text.size(), capacity - 1);
  std::memcpy(to, text.data(), length);
  to[length] = '\0';
}

void judge_claim(const fathom_claim& claim, fathom_judgement& judgement, char* sentence, std::size_t capacity) {
  const Tolerance tolerance{exact_value(claim.tol_relative), exact_value(claim.tol_absolute), static_cast<unsigned long>(claim.tol_ulps)};
  const Precision precision = claim.precision == FATHOM_BINARY32 ? Precision::binary32 : Precision::binary64;
  const Judgement result =
      judge(triples(claim.a, claim.a_count), triples(claim.b, claim.b_count), reply_of(claim), conventions_of(claim), precision, tolerance);
  fill(result, judgement);
  copy(result.sentence, sentence, capacity);
}

}  // namespace
}  // namespace fathom::judging

void fathom_claim_init(fathom_claim* claim) {
  *claim = {};
  claim->size = sizeof(fathom_claim);
  claim->tol_relative = 1e-3;
  claim->tol_absolute = 1e-6;
}

void fathom_judgement_init(fathom_judgement* judgement) {
  using fathom::judging::none;
  *judgement = {};
  judgement->size = sizeof(fathom_judgement);
  judgement->verdict = judgement->accuracy = judgement->status = -1;
  for (double* number :
       {&judgement->true_depth, &judgement->true_distance, &judgement->error, &judgement->error_ulps, &judgement->error_relative,
        &judgement->error_u_r, &judgement->price, &judgement->travel, &judgement->inconsistency, &judgement->overlap_left,
        &judgement->witness_a_distance, &judgement->witness_b_distance, &judgement->witness_gap}) {
    *number = none;
  }
}

int fathom_judge(const fathom_claim* claim, fathom_judgement* judgement, char* sentence, size_t capacity) {
  const fathom::kernels::DefaultFloatEnvironment environment;
  if (judgement == nullptr || judgement->size != sizeof(fathom_judgement)) {
    fathom::judging::copy("the judgement was not made by fathom_judgement_init of this version", sentence, capacity);
    return FATHOM_BAD_ARGUMENT;
  }
  const auto refused = [&](int code, std::string_view reason) {
    fathom_judgement_init(judgement);
    fathom::judging::copy(reason, sentence, capacity);
    return code;
  };
  fathom_judgement_init(judgement);
  if (claim == nullptr) return refused(FATHOM_BAD_ARGUMENT, "there is no claim");
  if (const std::string_view fault = fathom::judging::fault(*claim); !fault.empty()) return refused(FATHOM_BAD_ARGUMENT, fault);
  try {
    fathom::judging::judge_claim(*claim, *judgement, sentence, capacity);
    return FATHOM_JUDGED;
  } catch (const std::invalid_argument& error) {
    return refused(FATHOM_BAD_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return refused(FATHOM_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return refused(FATHOM_FAULT, error.what());
  } catch (...) {
    return refused(FATHOM_FAULT, "a fault of fathom");
  }
}

const char* fathom_verdict_name(int verdict) {
  return verdict < 0 || verdict > FATHOM_PASS ? nullptr : fathom::name(static_cast<fathom::Verdict>(verdict)).data();
}

int fathom_verdict_passes(int verdict) { return verdict == FATHOM_PASS || verdict == FATHOM_TOUCHING_BY_CONVENTION; }
