// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects in this process, right except for a rule of the test's making.
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::testing {

/// The right answer, rounded: depth and direction.
inline Reply right_reply(const Depth& truth) {
  Reply reply;
  reply.overlap = truth.status() == Status::penetrating;
  if (!reply.overlap) return reply;
  reply.depth = root_binary64(truth.squared(), Rounding::rn);
  const Vector& n = truth.optima().front().direction;
  const mpq_class length_squared = dot(n, n);
  const auto component = [&](const mpz_class& x) {
    const double size = root_binary64(mpq_class(x * x) / length_squared, Rounding::rn);
    return x < 0 ? -size : size;
  };
  reply.direction = Triple{component(n.x), component(n.y), component(n.z)};
  return reply;
}

/// Judges what `rule` makes of the right reply.
inline harness::Examine judged(std::function<void(const Case&, Reply&)> rule, Tolerance tolerance = {}) {
  return [=](const Case& pair) {
    const Truth truth = truth_about(pair.a.points, pair.b.points);
    harness::Outcome outcome;
    outcome.id = pair.id;
    Reply reply = right_reply(truth.depth);
    rule(pair, reply);
    outcome.reply = reply;
    outcome.judgement = judge(truth, reply, {}, Precision::binary64, tolerance);
    outcome.verdict = outcome.judgement->verdict;
    return outcome;
  };
}

/// For a subject that the unit is nothing to.
inline harness::ExamineInUnit in_any_unit(harness::Examine examine) {
  return [examine = std::move(examine)](const Case& pair, long) { return examine(pair); };
}

/// An outcome without a reply.
inline harness::Outcome speechless(const Case& pair, Verdict verdict) {
  harness::Outcome outcome;
  outcome.id = pair.id;
  outcome.verdict = verdict;
  return outcome;
}

/// A case of a family, rounded to the precision.
inline Case family_case(const char* family, unsigned size, std::uint64_t seed,
                        Precision precision = Precision::binary64) {
  const families::Family* found = families::find_family(family);
  if (!found) throw std::invalid_argument(std::string("no family ") + family);
  const std::optional<Case> seen = harness::as_seen(found->make(seed, size), precision);
  if (!seen) throw std::invalid_argument(std::string("beyond the precision: ") + family);
  return *seen;
}

inline Body box(const mpq_class& x, const mpq_class& y, const mpq_class& z, const mpq_class& sx, const mpq_class& sy,
                const mpq_class& sz) {
  Body body;
  for (int corner = 0; corner < 8; ++corner)
    body.points.push_back({x + (corner & 1 ? sx : 0), y + (corner & 2 ? sy : 0), z + (corner & 4 ? sz : 0)});
  return body;
}

}  // namespace fathom::testing
