// SPDX-License-Identifier: GPL-3.0-or-later
// The points that the subject saw, and the exact answer for them.
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/lowest_terms.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

/// False if it overflows.
bool round_to(mpq_class& x, Precision precision) {
  kernels::require_lowest_terms(x);
  const double rounded = precision == Precision::binary64 ? round_binary64(x, Rounding::rn) : round_binary32(x, Rounding::rn);
  if (!std::isfinite(rounded)) return false;
  x = exact_value(rounded);
  return true;
}

std::vector<Point> points_of(const std::vector<Triple>& body, Precision precision) {
  std::vector<Point> points;
  for (const Triple& p : body) {
    if (!is_finite(p)) throw std::invalid_argument("a coordinate is not finite");
    points.push_back(exact_point(p));
  }
  std::optional<std::vector<Point>> rounded = seen(points, precision);
  if (!rounded) throw std::invalid_argument("a coordinate is beyond the subject's precision");
  return std::move(*rounded);
}

}  // namespace

}  // namespace fathom::judging

namespace fathom {

std::optional<std::vector<Point>> seen(const std::vector<Point>& points, Precision precision) {
  std::vector<Point> result = points;
  for (Point& p : result) {
    if (!judging::round_to(p.x, precision) || !judging::round_to(p.y, precision) || !judging::round_to(p.z, precision)) return std::nullopt;
  }
  return result;
}

Truth truth_about(std::vector<Point> a, std::vector<Point> b, const Options& options) {
  Truth truth{std::move(a), std::move(b), {}};
  truth.depth = penetration_depth(truth.a, truth.b, options);
  return truth;
}

Judgement judge(const std::vector<Triple>& a, const std::vector<Triple>& b, const Reply& reply, const Conventions& conventions,
                Precision precision, const Tolerance& tolerance) {
  return judge(truth_about(judging::points_of(a, precision), judging::points_of(b, precision)), reply, conventions, precision, tolerance);
}

}  // namespace fathom
