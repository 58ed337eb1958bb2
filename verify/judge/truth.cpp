// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies after rounding to the subject's format, and the exact answer about them.
#include "verify/judge/truth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

double rounded(const mpq_class& x, Precision precision) {
  kernels::require_lowest_terms(x);
  return precision == Precision::binary64 ? round_binary64(x, Rounding::rn) : round_binary32(x, Rounding::rn);
}
double rounded(double x, Precision precision) {
  return precision == Precision::binary64 ? x : kernels::nearest_binary32(x);
}

/// Returns nullopt if a coordinate overflows.
template <class P>
std::optional<GivenPoints> rounded(std::span<const P> points, Precision precision) {
  std::vector<Triple> result;
  result.reserve(points.size());
  for (const auto& [x, y, z] : points) {
    result.push_back({rounded(x, precision), rounded(y, precision), rounded(z, precision)});
    if (!is_finite(result.back())) return std::nullopt;
  }
  return GivenPoints(std::move(result));
}

/// Returns the least number of binary64 for which `holds`; infinity if there is none. If it holds
/// for a number it must hold for each larger one.
double least_double(const std::function<bool(double)>& holds) {
  // Numbers of one sign are in the order of their bits.
  const auto number = [](std::int64_t place) {
    return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
  };
  std::int64_t end = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  for (std::int64_t begin = 1 - end; begin < end;) {
    const std::int64_t middle = std::midpoint(begin, end);
    if (holds(number(middle))) end = middle;
    else begin = middle + 1;
  }
  return number(end);
}

GivenPoints points_of(const std::vector<Triple>& body, const NumberFormat& format) {
  std::optional<GivenPoints> rounded = seen(GivenPoints(body), format);
  if (!rounded) throw std::invalid_argument("a coordinate is beyond the subject's precision");
  return std::move(*rounded);
}

}  // namespace
}  // namespace fathom::judging

namespace fathom {

std::optional<GivenPoints> seen(const GivenPoints& points, const NumberFormat& format) {
  const kernels::DefaultFloatEnvironment environment;
  if (format.exponent != 0) {
    const std::optional<GivenPoints> there = seen(judging::scaled(points, format.exponent), format.points);
    return there ? std::optional(judging::scaled(*there, -format.exponent)) : std::nullopt;
  }
  const Precision precision = format.points;
  if (!points.in_binary64()) return judging::rounded(std::span<const Point>(points.exact()), precision);
  return precision == Precision::binary64 ? points : judging::rounded(points.binary64(), precision);
}

Truth truth_about(GivenPoints a, GivenPoints b, const Options& options) {
  Depth depth = penetration_depth(Body{a}, Body{b}, options);
  return {std::move(a), std::move(b), std::move(depth)};
}

ShapeTruth truth_about(Shape a, Shape b, const SignedDepthOptions& options) {
  SignedDepth depth = signed_depth(a, b, options);
  return {std::move(a), std::move(b), std::move(depth)};
}

UnionTruth truth_about(Pieces a, Pieces b, const UnionOptions& options) {
  UnionOptions all = options;
  all.bounds = true;
  UnionDepth depth = union_depth(a, b, all);
  if (!depth.complete) throw Interrupted();
  return {std::move(a), std::move(b), std::move(depth)};
}

Judgement judge(const std::vector<Triple>& a, const std::vector<Triple>& b, const Reply& reply,
                const Conventions& conventions, const NumberFormat& format, const Tolerance& tolerance,
                const std::optional<Motion>& motion) {
  return judge(truth_about(judging::points_of(a, format), judging::points_of(b, format)), reply, conventions, format,
               tolerance, motion);
}

}  // namespace fathom

namespace fathom::judging {

std::optional<Body> body_seen(const Body& body, const NumberFormat& format) {
  if (body.shape) return body;
  Body result;
  result.dimension = body.dimension;
  if (!body.pieces) {
    std::optional<GivenPoints> points = seen(body.points, format);
    if (!points) return std::nullopt;
    result.points = *std::move(points);
    return result;
  }
  Pieces pieces;
  for (const std::vector<Point>& piece : *body.pieces) {
    const std::optional<GivenPoints> points = seen(GivenPoints(piece), format);
    if (!points) return std::nullopt;
    pieces.push_back(points->exact());
  }
  result.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return result;
}

AnyTruth truth_of(const Body& a, const Body& b, const Options& options) {
  if (a.dimension == 2 || b.dimension == 2) {
    const answer::Prisms prisms = answer::prisms_of(a, b);
    AnyTruth truth = truth_of(prisms.a, prisms.b, options);
    std::visit([](auto& known) { known.dimension = 2; }, truth);
    return truth;
  }
  if (a.pieces || b.pieces) return truth_about(pieces_of(a), pieces_of(b), UnionOptions{.monitor = options.monitor});
  if (a.shape || b.shape)
    return truth_about(files::shape_of(a), files::shape_of(b), SignedDepthOptions{.cores = options});
  return truth_about(a.points, b.points, options);
}

Judgement judged(const AnyTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor) {
  return std::visit(
      [&](const auto& known) { return judge(known, reply, conventions, format, tolerance, motion, monitor); }, truth);
}

Accepted accepted(const AnyTruth& truth, const Conventions& conventions, const NumberFormat& format,
                  const Tolerance& tolerance, Monitor* monitor) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Conventions plain = conventions;
  plain.depth = Conventions::Sign::positive;
  const auto finds = [&](bool overlap, std::optional<double> length, std::initializer_list<Verdict> sought) {
    Reply claim;
    claim.overlap = overlap;
    (overlap ? claim.depth : claim.distance) = length;
    const Judgement found = judged(truth, claim, plain, format, tolerance, {}, monitor);
    return std::ranges::find_first_of(found.findings, sought) != found.findings.end();
  };
  const auto between = [&](bool overlap) {
    const double low = least_double([&](double length) {
      return !finds(overlap, length, {Verdict::wrong_sign, Verdict::too_shallow, Verdict::too_near});
    });
    const double beyond = least_double([&](double length) {
      return finds(overlap, length, {Verdict::too_deep, Verdict::too_far});
    });
    return Between{low, std::nextafter(beyond, -infinity)};
  };
  Accepted result{.overlap = !finds(true, {}, {Verdict::false_overlap}),
                  .apart = !finds(false, {}, {Verdict::false_separation}),
                  .depth = between(true),
                  .distance = between(false)};
  using Kind = Policy::Kind;
  const Kind kind = tolerance.policy.kind;
  const bool shortest =
      kind == Kind::minimum || (kind == Kind::declared && conventions.claims == Conventions::Claims::minimum);
  if (!shortest) result.depth.high = infinity;
  if (conventions.depth == Conventions::Sign::negative) result.depth = {-result.depth.high, -result.depth.low};
  return result;
}

}  // namespace fathom::judging
