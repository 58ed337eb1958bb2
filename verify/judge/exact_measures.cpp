// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/exact_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fathom/numbers.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

double root(const mpq_class& squared) { return root_binary64(squared, Rounding::rn); }

}  // namespace

ExactMeasures::ExactMeasures(Sizes sizes, Status status, mpq_class depth, std::optional<mpq_class> distance, const NumberFormat& format,
                             const Tolerance& tolerance)
    : sizes_(std::move(sizes)),
      status_(status),
      depth_(std::move(depth)),
      distance_(std::move(distance)),
      format_(format),
      tolerance_(tolerance),
      squared_(depth_),
      allowed_(sizes_, squared_, format, tolerance) {}

void ExactMeasures::measure(const Claim& claim, Judgement& result) {
  result.status = status_;
  result.depth_squared = depth_;
  if (distance_) result.distance_squared = *distance_;
  if (!claim.overlap && claim.length) ask_for_distance(result.distance_squared);
  if (claim.length) measure_length(*claim.length, result);
  measure_direction(claim, result);
  if (claim.witness_a) away_a_ = result.witness_a_squared = squared_distance_a(*claim.witness_a);
  if (claim.witness_b) away_b_ = result.witness_b_squared = squared_distance_b(*claim.witness_b);
  for (const Point& contact : claim.contacts) {
    contact_a_ = std::max(contact_a_.value_or(0), squared_distance_a(contact));
    contact_b_ = std::max(contact_b_.value_or(0), squared_distance_b(contact));
  }
  result.contact_a_squared = contact_a_;
  result.contact_b_squared = contact_b_;
}

std::string ExactMeasures::depth() const { return fmt::format("{}", root(depth_)); }
std::string ExactMeasures::distance() const { return distance_ ? fmt::format("{}", root(*distance_)) : ""; }
std::string ExactMeasures::length() const { return fmt::format("{}", root(squared_)); }
double ExactMeasures::off_by(const mpq_class& d) const { return kernels::nearest_binary64({d, -squared_}); }
double ExactMeasures::away_a() const { return root(*away_a_); }
double ExactMeasures::away_b() const { return root(*away_b_); }
double ExactMeasures::contact_away_a() const { return root(*contact_a_); }
double ExactMeasures::contact_away_b() const { return root(*contact_b_); }

mpq_class ExactMeasures::rounding_unit() const { return unit_roundoff(format_.points) * sizes_.farthest; }

void ExactMeasures::ask_for_distance(const mpq_class& squared) {
  squared_ = squared;
  const Allowance classification = allowed_.classification;
  allowed_ = Allowances(sizes_, squared_, format_, tolerance_);
  allowed_.classification = classification;
}

void ExactMeasures::measure_length(const mpq_class& d, Judgement& result) const {
  const mpq_class &s = squared_, ulp = ulp_at_root(s, format_), u_r = rounding_unit();
  result.error = kernels::nearest_binary64({d, -s});
  if (sgn(s) > 0) {
    result.error_ulps = kernels::nearest_binary64({d / ulp, -s / (ulp * ulp)});
    result.error_relative = kernels::nearest_binary64({-1, d * abs(d) / s});
  }
  if (sgn(u_r) > 0) result.error_u_r = kernels::nearest_binary64({d / u_r, -s / (u_r * u_r)});
}

}  // namespace fathom::judging
