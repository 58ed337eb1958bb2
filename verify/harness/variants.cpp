// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetry is applied only if it keeps all points exact, so that the depth of a variant follows
// from that of the case.

#include "verify/harness/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "verify/families/random.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/manifold.hpp"
#include "verify/judge/measures.hpp"

namespace fathom::harness {
namespace {

constexpr long exponents[] = {10, -10, 3, -3, 1, -1};  // of scale, in the order in which they are tried
constexpr long bulky = 20;                             // coordinates from 2^bulky on are scaled down rather than up
constexpr std::uint64_t seed = 7;                      // of all permutations

/// Returns whether `fits` holds for all coordinates on the axis: of the points, or of the place of
/// a described body.
template <class Fits>
bool all_coordinates(const Case& pair, std::size_t axis, Fits fits) {
  for (const Body* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      if (!fits(place_along(words, axis))) return false;
      continue;
    }
    bool all = true;
    for_each_hull(*body, [&](const std::vector<Point>& points) {
      for (const Point& p : points) all = all && fits(p.*axes[axis]);
    });
    if (!all) return false;
  }
  return true;
}

/// Returns a power of two, or its negative, that can be added to all coordinates on this axis
/// exactly: the largest one up to eight times the largest coordinate.
std::optional<mpq_class> shift(const Case& pair, std::size_t axis, const NumberFormat& format) {
  mpq_class largest = 0;
  std::optional<long> finest;
  all_coordinates(pair, axis, [&](const mpq_class& value) {
    largest = std::max(largest, mpq_class(abs(value)));
    if (value != 0) finest = std::min(finest.value_or(lowest_bit(value)), lowest_bit(value));
    return true;
  });
  if (!finest) return scaled(1, -format.exponent);
  const long highest = exponent_of(largest) + 3;
  for (long exponent = highest; exponent >= *finest && exponent > highest - 64; --exponent)
    for (const int sign : {1, -1}) {
      const mpq_class step = scaled(sign, exponent);
      if (all_coordinates(pair, axis, [&](const mpq_class& value) { return representable(value + step, format); }))
        return step;
    }
  return std::nullopt;
}

std::optional<Variant> swapped(Variant variant) {
  std::swap(variant.seen.a, variant.seen.b);
  if (variant.seen.motion) std::swap(variant.seen.motion->of_a, variant.seen.motion->of_b);
  variant.swapped = true;
  return variant;
}

std::optional<Variant> translated(Variant variant) {
  const Case original = variant.seen;
  bool moved = false;
  for (std::size_t axis = 0; axis < original.a.dimension; ++axis)
    if (const std::optional<mpq_class> step = shift(original, axis, variant.format)) {
      moved = true;
      variant.step.*axes[axis] = *step;
      for (Body* body : {&variant.seen.a, &variant.seen.b}) {
        if (body->words) {
          files::NamedBody words = *body->words;
          place_along(words, axis) += *step;
          *body = files::body_of(std::move(words));
        } else {
          for_each_hull(*body, [&](std::vector<Point>& points) {
            for (Point& p : points) p.*axes[axis] += *step;
          });
        }
      }
    }
  if (std::optional<Motion>& motion = variant.seen.motion) {  // whose w are about the origin
    for (Twist* twist : {&motion->of_a, &motion->of_b}) twist->v = twist->v - cross(twist->w, variant.step);
    if (rounded(*motion, variant.format) != motion) motion.reset();
  }
  return moved ? std::optional(variant) : std::nullopt;
}

bool shuffle(std::vector<Point>& points, families::Random& random) {
  const std::vector<Point> original = points;
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1))]);
  if (points == original) std::rotate(points.begin(), points.begin() + (points.size() > 1 ? 1 : 0), points.end());
  return points != original;
}

bool shuffle(Body& body, families::Random& random) {
  if (!body.words) {
    bool other = false;
    for_each_hull(body, [&](std::vector<Point>& points) { other = shuffle(points, random) || other; });
    return other;
  }
  files::NamedBody words = *body.words;
  const bool other = shuffle(words.fields.vertices, random);
  if (other) body = files::body_of(std::move(words));
  return other;
}

std::optional<Variant> permuted(Variant variant) {
  families::Random random(seed);
  const bool a = shuffle(variant.seen.a, random), b = shuffle(variant.seen.b, random);
  return a || b ? std::optional(variant) : std::nullopt;
}

std::optional<Variant> rescaled(Variant variant) {
  const mpq_class largest = largest_coordinate(variant.seen);
  if (largest == 0) return std::nullopt;
  const long sign = exponent_of(largest) + variant.format.exponent >= bulky ? -1 : 1;
  for (const long size : exponents) {
    const long exponent = sign * size;
    bool exact = true;
    for_each_coordinate(std::as_const(variant.seen), [&](const mpq_class& value) {
      exact = exact && representable(scaled(value, exponent), variant.format);
    });
    if (!exact) continue;
    variant.seen = in_unit(std::move(variant.seen), exponent);
    if (variant.seen.motion && rounded(*variant.seen.motion, variant.format) != variant.seen.motion)
      variant.seen.motion.reset();
    variant.exponent = exponent;
    return variant;
  }
  return std::nullopt;
}

std::optional<Variant> made(std::string_view name, const Case& as_seen, const NumberFormat& format) {
  Variant variant{std::string(name), as_seen, false, {}, 0, format};
  if (name == "swap") return swapped(std::move(variant));
  if (name == "translate") return translated(std::move(variant));
  if (name == "permute") return permuted(std::move(variant));
  if (name == "scale") return rescaled(std::move(variant));
  return variant;  // the same case once more
}

// Lengths are compared in the units of the original case, and by their exact squares: sqrt(p) -
// sqrt(q) > t is decided without a root.

std::string short_text(double value) { return fmt::format("{:.6g}", value); }

/// The square root of a signed square, rounded.
double signed_root(const mpq_class& square) {
  const double root = root_binary64(abs(square), Rounding::rn);
  return square < 0 ? -root : root;
}

/// Returns whether two lengths, given by their signed squares, differ by more than the square root
/// of `allowed`.
bool differ(const mpq_class& p, const mpq_class& q, const mpq_class& allowed) {
  const mpq_class rest = abs(p) + abs(q) - allowed, product = 4 * abs(p) * abs(q);
  if ((p < 0) == (q < 0) || p == 0 || q == 0)
    return rest > 0 && rest * rest > product;  // that is, |p| + |q| - allowed > 2 sqrt(pq)
  return rest > 0 || rest * rest < product;    // one length is negative, so their magnitudes add up
}

/// Returns the square of the depth, or of the distance, that the answer is about; for shapes that
/// of its upper bound, less the radii that the subject added, if that is smaller.
mpq_class squared_length(const Reply& reply, const Judgement& judgement, const mpq_class& radii) {
  const bool far = !reply.overlap && reply.distance;
  if (!judgement.signed_depth) return far ? judgement.distance_squared : judgement.depth_squared;
  const double high = far ? -judgement.signed_depth->low : judgement.signed_depth->high;
  const mpq_class most = std::isfinite(high) && high > 0 ? exact_value(high) : mpq_class(0);
  const mpq_class length = std::min(most, far ? mpq_class(most + radii) : mpq_class(abs(most - radii)));
  return length * length;
}

/// Returns whether each value of x differs from each of y / 2^exponent by more than the square root
/// of `allowed`.
bool differ(const Between& x, const Between& y, long exponent, const mpq_class& allowed) {
  for (const double end : {x.low, x.high, y.low, y.high})
    if (!std::isfinite(end)) return false;
  const mpq_class gap = std::max(mpq_class(exact_value(x.low) - scaled(exact_value(y.high), -exponent)),
                                 mpq_class(scaled(exact_value(y.low), -exponent) - exact_value(x.high)));
  return gap > 0 && gap * gap > allowed;
}

/// Both answers, the variant's in the units of the original.
class Comparison {
 public:
  Comparison(const Outcome& original, const Outcome& variant, const Variant& made, const Tolerance& tolerance,
             const std::optional<ContactLimits>& manifold)
      : original_(original), variant_(variant), made_(made), manifold_(manifold) {
    if (!original.judgement) return;
    const auto length_less = [&](const mpq_class& radii) {
      return squared_length(*original.reply, *original.judgement, radii);
    };
    allow(tolerance, length_less(0), length_less(original.radii));
  }

  /// Returns a sentence on the difference; empty if no difference exceeds the tolerance.
  [[nodiscard]] std::string difference() const {
    if (!original_.reply || !original_.judgement || original_.verdict == Verdict::nan)
      return fmt::format("the case itself ends in {}, {} of it does not", name(original_.verdict), of_variant());
    if (original_.reply->overlap != variant_.reply->overlap && fails(original_.verdict))
      return fmt::format("overlap is {} of the case itself, and {} of {}",
                         original_.reply->overlap ? "claimed" : "denied",
                         variant_.reply->overlap ? "claimed" : "denied", of_variant());
    if (original_.judgement->excess_allowed || variant_.judgement->excess_allowed)
      return "";  // under such a policy two different answers may be right
    if (std::string text = of_lengths(); !text.empty()) return text;
    if (std::string text = of_separating_distances(); !text.empty()) return text;
    return of_contacts();
  }

 private:
  [[nodiscard]] std::string of_variant() const { return fmt::format("the variant \"{}\"", made_.name); }

  /// Sets the allowances: the larger of the tolerance and the effect of rounding in both answers.
  void allow(const Tolerance& tolerance, const mpq_class& depth_squared, const mpq_class& less_radii) {
    const auto in_units = [&](const mpq_class& length) { return scaled(length, -made_.exponent); };
    const judging::Sizes there = sizes_of(made_.seen);
    mpq_class way = 0;
    for (const auto axis : axes) way = std::max(way, mpq_class(abs(made_.step.*axis)));
    const judging::Sizes here{in_units(there.extent), in_units(there.farthest) + way, in_units(there.reach)};
    const judging::Slack slack = judging::rounding_slack(here, depth_squared, made_.format, tolerance.ulps);
    const judging::Slack slack_there =
        judging::rounding_slack(there, depth_squared_of(made_, depth_squared), made_.format, tolerance.ulps);
    const auto allowed = [&](mpq_class judging::Slack::*const residual) {
      const mpq_class both = slack.*residual + in_units(slack_there.*residual),
                      absolute = tolerance.absolute * here.extent;
      return judging::Allowance(tolerance.relative, less_radii, std::max(absolute, both)).squared();
    };
    allowed_depth_ = allowed(&judging::Slack::depth);
    allowed_separating_distance_ = allowed(&judging::Slack::direction);
    allowed_contacts_ = 4 * allowed(&judging::Slack::witness);
  }

  /// Returns the claimed depth, or distance, in the units of the original. If only one answer
  /// claims an overlap, the other has the depth 0.
  [[nodiscard]] std::optional<mpq_class> claimed(const Reply& reply, long exponent) const {
    if (!reply.overlap && !both_apart()) return mpq_class(0);
    const double* const length = judging::length_of(reply);
    if (!length || !std::isfinite(*length)) return std::nullopt;
    return scaled(exact_value(*length), -exponent - made_.format.exponent);
  }

  [[nodiscard]] bool both_apart() const { return !original_.reply->overlap && !variant_.reply->overlap; }

  [[nodiscard]] std::string of_lengths() const {
    const std::optional<mpq_class> here = claimed(*original_.reply, 0),
                                   there = claimed(*variant_.reply, made_.exponent);
    if (!here || !there) return "";
    const mpq_class difference = abs(*here - *there);
    if (difference * difference <= allowed_depth_) return "";
    std::string text =
        fmt::format("the {} of the case and of {} differ by {}: {} and {}", both_apart() ? "distances" : "depths",
                    of_variant(), short_text(round_binary64(difference, Rounding::rn)),
                    short_text(round_binary64(*here, Rounding::rn)), short_text(round_binary64(*there, Rounding::rn)));
    if (const auto [p, q] = separating_distances(); p && q && *p != *q)
      text +=
          fmt::format("; their directions need {} and {}", short_text(signed_root(*p)), short_text(signed_root(*q)));
    return text;
  }

  [[nodiscard]] std::string of_separating_distances() const {
    const std::optional<Between>&x = original_.judgement->separating_distance,
          &y = variant_.judgement->separating_distance;
    if (x && y && differ(*x, *y, made_.exponent, allowed_separating_distance_))
      return fmt::format("the directions for the case and for {} need different depths: {} and {}", of_variant(),
                         short_text(x->low), short_text(std::ldexp(y->low, static_cast<int>(-made_.exponent))));
    const auto [p, q] = separating_distances();
    if (!p || !q || !differ(*p, *q, allowed_separating_distance_)) return "";
    return fmt::format("the directions for the case and for {} need different depths: {} and {}", of_variant(),
                       short_text(signed_root(*p)), short_text(signed_root(*q)));
  }

  [[nodiscard]] std::pair<std::optional<mpq_class>, std::optional<mpq_class>> separating_distances() const {
    std::optional<mpq_class> there = variant_.judgement->separating_distance_squared;
    if (there) there = scaled(*there, -2 * made_.exponent);
    return {original_.judgement->separating_distance_squared, there};
  }

  /// Returns the positions of contacts at the place and in the units of the original; empty if one
  /// is not finite.
  [[nodiscard]] std::vector<Point> positions(const Reply& reply, const Point& step, long exponent) const {
    std::vector<Point> result;
    for (const ContactPoint& contact : reply.contacts) {
      if (!judging::is_finite(contact)) return {};
      result.push_back(
          mpq_class(scaled(1, -exponent - made_.format.exponent)) * judging::exact_point(contact.position) - step);
    }
    return result;
  }

  /// Returns whether the subject declares that an answer with so few contacts is complete. An
  /// answer with the largest number may be a choice among more.
  [[nodiscard]] bool tells_all(const Reply& reply) const {
    return manifold_ && (!manifold_->most || reply.contacts.size() < *manifold_->most);
  }

  /// Compares contacts only if the directions are equal: different ones may be those of different
  /// optima.
  [[nodiscard]] std::string of_contacts() const {
    if (!tells_all(*original_.reply) || !tells_all(*variant_.reply)) return "";
    const std::optional<Triple>&u = original_.reply->direction, &v = variant_.reply->direction;
    if (!u || !v || !judging::is_finite(*u) || !judging::is_finite(*v)) return "";
    const Point along = judging::exact_point(*u);
    if (along == Point{}) return "";
    const Vector n = primitive_along(along);
    if (primitive_along(judging::exact_point(*v)) != (made_.name == "swap" ? -n : n)) return "";
    const std::vector<Point> here = positions(*original_.reply, {}, 0),
                             there = positions(*variant_.reply, made_.step, made_.exponent);
    if (here.empty() || there.empty()) return "";
    const mpq_class unlike = judging::unlike_squared(n, here, there);
    if (unlike <= allowed_contacts_) return "";
    return fmt::format("the contacts of the case and of {} reach differently far, by {}", of_variant(),
                       short_text(signed_root(unlike)));
  }

  const Outcome &original_, &variant_;
  const Variant& made_;
  const std::optional<ContactLimits>& manifold_;
  mpq_class allowed_depth_, allowed_separating_distance_, allowed_contacts_;  ///< squared
};

}  // namespace

std::vector<Variant> variants(const Case& as_seen, const NumberFormat& format, std::span<const std::string> names,
                              std::vector<std::string>* left_out) {
  std::vector<Variant> result;
  for (const std::string_view name : variant_names) {
    if (std::ranges::find(names, name) == names.end()) continue;
    if (std::optional<Variant> variant = made(name, as_seen, format)) result.push_back(*std::move(variant));
    else if (left_out)
      left_out->push_back(fmt::format("no {} other than the case itself keeps its coordinates exact in {}", name,
                                      fathom::name(format.points)));
  }
  return result;
}

mpq_class depth_squared_of(const Variant& variant, const mpq_class& of_original) {
  return scaled(of_original, 2 * variant.exponent);
}

Examine examine_variant(ExamineInUnit examine, std::string name, NumberFormat format, Tolerance tolerance,
                        std::optional<mpq_class> fit, std::optional<ContactLimits> manifold) {
  return [=](const Case& pair) {
    const std::string names[] = {name};
    const long exponent = exponent_to_fit(pair, fit);
    const Outcome original = examine(pair, exponent);
    const std::vector<Variant> found = variants(pair, in_unit(format, exponent), names);
    return found.empty()
               ? original
               : compare_variant(original, examine(found.front().seen, exponent), found.front(), tolerance, manifold);
  };
}

Outcome compare_variant(const Outcome& original, const Outcome& variant, const Variant& made,
                        const Tolerance& tolerance, const std::optional<ContactLimits>& manifold) {
  Outcome result = variant;
  result.variant = made.name;
  if (!passes(variant.verdict) || !variant.reply || !variant.judgement || original.verdict == Verdict::unsupported)
    return result;
  const std::string difference = Comparison(original, variant, made, tolerance, manifold).difference();
  if (difference.empty()) return result;
  result.verdict = result.judgement->verdict = Verdict::not_invariant;
  result.judgement->findings.push_back(Verdict::not_invariant);
  result.judgement->sentence = difference + (made.exponent == 0 ? "" : ", scaled back");
  return result;
}

}  // namespace fathom::harness
