// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/derivative.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/shapes/core.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

constexpr unsigned speed_bits = 40;

mpq_class rounded_up(const mpq_class& squared) { return kernels::enclosed({0, squared}, speed_bits).high; }

/// Returns the points whose hull is the body's core; O for a curved core.
std::vector<Point> points_of(const Body& body) {
  std::vector<Point> points;
  if (body.pieces)
    for (const std::vector<Point>& piece : *body.pieces) points.insert(points.end(), piece.begin(), piece.end());
  else if (const patch::CorePoints core(body); core.known()) points = core.exact();
  else points.emplace_back();
  return points;
}

mpq_class largest_speed(const Body& body, const Twist& twist) {
  mpq_class squared = 0;
  for (const Point& p : points_of(body)) {
    const Point velocity = twist.v + cross(twist.w, p);
    squared = std::max(squared, dot(velocity, velocity));
  }
  const mpq_class radius = body.shape ? shapes::simplified(*body.shape).radius : mpq_class(0);
  return rounded_up(squared) + radius * rounded_up(dot(twist.w, twist.w));
}

Twist reversed(const Twist& twist) { return {-twist.v, -twist.w}; }

std::string number_text(const mpq_class& signed_square) {
  return fmt::format("{:.6g}", kernels::nearest_binary64({0, signed_square}));
}

/// Returns the body's point: that of the core, moved outward by the radius.
std::string point_text(const RoundedPoint& point) {
  const auto [x, y, z] = rounded::nearest_binary64(point);
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", x, y, z);
}

std::string direction_text(const Vector& n) {
  const auto share = [&](const mpz_class& c) {
    return kernels::nearest_binary64({0, mpq_class(c * abs(c)) / mpq_class(dot(n, n))});
  };
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", share(n.x), share(n.y), share(n.z));
}

/// Finds a well-known other rate that equals a wrong claim, by comparing the numbers alone.
class Instead {
 public:
  Instead(const ContactGeometry& geometry, const Motion& motion, const DirectionalDerivative& right, mpq_class claimed,
          const mpq_class& allowed)
      : geometry_(geometry),
        motion_(motion),
        right_(right),
        squared_(right.value().root),
        claimed_(std::move(claimed)),
        allowed_(allowed),
        within_(0, 0, allowed) {}

  /// Returns a clause on that rate, or "".
  [[nodiscard]] std::string told(const Claim& claim) const {
    if (is(-squared_)) return "the right rate with the other sign";
    for (std::string text : {of_differences(), of_witness(claim), of_patches()})
      if (!text.empty()) return text;
    return "";
  }

 private:
  [[nodiscard]] bool is(const mpq_class& signed_square) const { return !within_.off(claimed_, signed_square); }

  /// Returns the rate at points of A and B along one direction, as a signed square.
  [[nodiscard]] mpq_class rate_at(const Vector& n, const Point& a, const Point& b) const {
    const Point apart = motion_.of_b.v + cross(motion_.of_b.w, b) - motion_.of_a.v - cross(motion_.of_a.w, a);
    const mpq_class rate = dot(n, apart);
    return rate * abs(rate) / dot(n, n);
  }

  /// Compares with difference quotients: at a kink the rate before the given time differs from the
  /// one after it.
  [[nodiscard]] std::string of_differences() const {
    const auto until_now = directional_derivative(geometry_, reversed(motion_.of_a), reversed(motion_.of_b));
    const auto* const found = std::get_if<DirectionalDerivative>(&until_now);
    if (!found) return "";
    const mpq_class before = -found->value().root;
    if (before == squared_) return "";
    if (is(before)) return "the rate until now: that of a difference backwards";
    const mpq_class twice = 2 * claimed_, slack = 2 * allowed_;
    if (kernels::sign_of_sum(twice - slack, -squared_, -before) > 0 ||
        kernels::sign_of_sum(twice + slack, -squared_, -before) < 0)
      return "";
    return fmt::format("the mean of the rates from now on, {}, and until now, {}: that of a central difference",
                       number_text(squared_), number_text(before));
  }

  [[nodiscard]] std::string of_witness(const Claim& claim) const {
    if (!claim.direction || !claim.witness_a || !claim.witness_b) return "";
    if (!is(rate_at(*claim.direction, *claim.witness_a, *claim.witness_b))) return "";
    return "the rate at its own witness points, along its own direction";
  }

  [[nodiscard]] std::string of_patches() const {
    if (geometry_.of_unions) return "";
    for (const Patch& patch : geometry_.patches) {
      std::vector<mpq_class> rates;
      for (std::size_t k = 0; k < patch.corners.size(); ++k)
        rates.push_back(rate_at(patch.direction, patch.a(k).core, patch.b(k).core));
      const auto greatest = std::ranges::max_element(rates);
      if (is(*greatest))
        return fmt::format("the rate along {} alone, where {}", direction_text(patch.direction),
                           geometry_.cone ? "each direction that separates the cores counts"
                                          : fmt::format("each shortest way out counts as well, and {} decides",
                                                        direction_text(right_.direction)));
      for (std::size_t k = 0; k < rates.size(); ++k)
        if (is(rates[k]))
          return fmt::format("the rate at the contact point {} alone, where each counts{}", point_text(patch.a(k)),
                             decisive(", and "));
      const RoundedWitness middle = patch.centroid();
      if (is(rate_at(patch.direction, middle.a.core, middle.b.core)))
        return fmt::format("the rate at the middle of the contact patch, {}{}", point_text(middle.a),
                           decisive(", where "));
    }
    return "";
  }

  /// Returns a clause on the contact point that decides; "" if cores touch, as several points may
  /// decide together then.
  [[nodiscard]] std::string decisive(std::string_view before) const {
    if (geometry_.cone) return "";
    return fmt::format("{}{} decides", before, point_text(geometry_.patches.at(right_.patch).a(right_.corner)));
  }

  const ContactGeometry& geometry_;
  const Motion& motion_;
  const DirectionalDerivative& right_;
  mpq_class squared_, claimed_, allowed_;
  Allowance within_;
};

}  // namespace

mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion) {
  return std::max(largest_speed(shapes::is_halfspace(a) ? b : a, motion.of_a),
                  largest_speed(shapes::is_halfspace(b) ? a : b, motion.of_b));
}

DerivativeJudgement judged_derivative(const Body& a, const Body& b, const Answer& answer, const Motion& motion,
                                      const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                                      const Tolerance& tolerance, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const double claimed = reply.derivative.value();
  DerivativeJudgement result;
  result.claimed = std::ldexp(claimed, static_cast<int>(-format.exponent));
  if (!std::isfinite(claimed)) {
    result.sentence = fmt::format("the derivative is {}", claimed);
    return result;
  }
  const ContactGeometry geometry = contact_geometry(a, b, answer, monitor);
  for (const Kink kink : geometry.kinks) result.kinks.emplace_back(name(kink));
  const auto found = directional_derivative(geometry, motion.of_a, motion.of_b);
  if (const LeftOut* const why = std::get_if<LeftOut>(&found)) {
    result.left_out = name(*why);
    return result;
  }
  const auto& right = std::get<DirectionalDerivative>(found);
  const mpq_class& squared = result.squared.emplace(right.value().root);
  const mpq_class rate = scaled(exact_value(claimed), -format.exponent);
  result.error = kernels::nearest_binary64({rate, -squared});
  const mpq_class share = std::max({tolerance.relative, tolerance.absolute, mpq_class(0)}),
                  rounding = std::max(mpq_class(tolerance.ulps), mpq_class(1, 2)) * ulp_at_root(abs(squared), format),
                  allowed = std::max(mpq_class(share * largest_speed(a, b, motion)), rounding);
  if (!Allowance(0, 0, allowed).off(rate, squared)) return result;
  result.sentence = fmt::format("the derivative is wrong by {:.4g}: {} is claimed, {} is right",
                                std::abs(*result.error), result.claimed, number_text(squared));
  const std::string instead =
      Instead(geometry, motion, right, rate, allowed).told(exact_claim(reply, conventions, format.exponent));
  if (!instead.empty()) result.sentence += "; it is " + instead;
  return result;
}

}  // namespace fathom::judging
