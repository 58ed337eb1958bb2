// SPDX-License-Identifier: GPL-3.0-or-later
// Of unions: a translation is judged by what it leaves, the signed depth of A + t and B, which is found by one more search. t is a root
// times a direction, and is known to as many bits as a question needs.                                       [proofs/judge.md]
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "verify/judge/exact_measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

constexpr unsigned first_bits = 80, last_bits = 640;  // of the root in a translation

Pieces moved(const Pieces& pieces, const mpq_class& factor, const Vector& u) {
  const Point t = factor * u;
  Pieces result = pieces;
  for (std::vector<Point>& piece : result)
    for (Point& p : piece) p = p + t;
  return result;
}

/// The root of a square less `off`, or more; correctly rounded if that makes no difference.
double least_root(const mpq_class& squared, const mpq_class& off) {
  const double low = kernels::nearest_binary64({-off, squared});
  if (low == kernels::nearest_binary64({off, squared})) return low;
  const mpq_class root = kernels::enclosed({0, squared}, last_bits).low - off;
  return sgn(root) > 0 ? round_binary64(root, Rounding::rd) : 0;
}

std::optional<mpq_class> distance_of(const UnionDepth& depth) {
  return depth.apart ? std::optional(depth.apart->distance.squared) : std::nullopt;
}

/// How the bodies lie after a translation.
struct Left {
  mpq_class depth, distance;  ///< squared, where A has moved by a rational vector
  mpq_class off;              ///< no less than the length by which that differs from the translation in question
};

class UnionMeasures final : public ExactMeasures {
 public:
  UnionMeasures(const UnionTruth& truth, const NumberFormat& format, const Tolerance& tolerance, Monitor* monitor)
      : ExactMeasures(sizes_of(truth.a, truth.b), truth.depth.status, truth.depth.squared(), distance_of(truth.depth), format, tolerance),
        truth_(truth),
        monitor_(monitor) {}

  bool is_inconsistent(const Vector& u, const mpq_class& d) override { return leaves(u, d, &Left::distance) || leaves(u, d, &Left::depth); }
  bool is_dearer(const Vector&, const mpq_class& times) override { return claimed_ * claimed_ > times * times * depth_squared(); }
  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    return status() == Status::penetrating && leaves(u, d, &Left::depth);
  }
  [[nodiscard]] bool is_one_question() const override { return true; }

  [[nodiscard]] std::string times(const mpq_class& d) const override {
    return sgn(d) > 0 ? fmt::format(", {:.4g} times as much", root_binary64(depth_squared() / (d * d), Rounding::rn)) : "";
  }
  [[nodiscard]] std::string left(const mpq_class&) const override {
    return fmt::format("{:.4g} of overlap is left after its translation", least_root(told_.depth, told_.off));
  }
  [[nodiscard]] std::string across(const std::string&) const override { return what_is_left(); }
  [[nodiscard]] std::string gap(const std::string&) const override { return what_is_left(); }

 private:
  [[nodiscard]] mpq_class squared_distance_a(const Point& point) const override { return squared_distance(point, truth_.a); }
  [[nodiscard]] mpq_class squared_distance_b(const Point& point) const override { return squared_distance(point, truth_.b); }

  void measure_direction(const Claim& claim, Judgement& result) override {
    if (claim.length) claimed_ = *claim.length;
    if (status() == Status::penetrating) result.bounds = truth_.depth.bounds;
    if (status() == Status::penetrating && claim.overlap && sgn(claimed_) > 0)
      result.deeper_squared = depth_squared() / (claimed_ * claimed_);
    if (!claim.direction || !claim.length) return;
    claimed_way_ = *claim.direction;
    const Left& left = after(*claim.direction, claim.way(), first_bits);
    const double overlap = least_root(left.depth, left.off), gap = least_root(left.distance, left.off);
    result.inconsistency = overlap > 0 ? -overlap : gap;
    if (claim.overlap && status() == Status::penetrating && overlap > 0) result.overlap_left = overlap;
  }

  /// Whether so much of the depth, or of the distance, is left that it is more than tol.
  bool leaves(const Vector& u, const mpq_class& way, const mpq_class Left::*what) {
    for (unsigned bits = first_bits;; bits *= 2) {
      const Left& left = after(u, way, bits);
      if (u == claimed_way_) told_ = left;
      if (of_direction().below(left.off, left.*what)) return true;
      if (!of_direction().below(-left.off, left.*what)) return false;
      if (bits >= last_bits) return false;
    }
  }

  const Left& after(const Vector& u, const mpq_class& way, unsigned bits) {
    if (u == moved_along_ && way == moved_by_ && bits <= moved_bits_) return left_;
    const kernels::RationalInterval length = kernels::enclosed({0, mpq_class(dot(u, u))}, bits);
    const mpq_class factor = way / length.high;
    const Pieces a = moved(truth_.a, factor, u);
    UnionOptions options;
    options.monitor = monitor_;
    options.bounds = false;
    const UnionDepth depth = union_depth(a, truth_.b, options);
    if (!depth.complete) throw Interrupted();
    left_ = {depth.squared(), distance_of(depth).value_or(0), abs(factor) * (length.high - length.low)};
    moved_along_ = u;
    moved_by_ = way;
    moved_bits_ = length.low == length.high ? last_bits : bits;
    return left_;
  }

  [[nodiscard]] std::string what_is_left() const {
    const double overlap = least_root(told_.depth, told_.off);
    return overlap > 0 ? fmt::format("{:.4g} of overlap is left after its translation", overlap)
                       : fmt::format("its translation leaves a gap of {:.4g}", least_root(told_.distance, told_.off));
  }

  const UnionTruth& truth_;
  Monitor* monitor_;
  mpq_class claimed_;            // length
  Vector claimed_way_{0, 0, 0};  // direction
  Left told_;                    // what the claim leaves, its length mended
  // The translation that was looked at last, by a direction and a length along it, and what it leaves:
  Vector moved_along_{0, 0, 0};
  mpq_class moved_by_;
  unsigned moved_bits_ = 0;
  Left left_;
};

}  // namespace

std::unique_ptr<Measures> measures_of(const UnionTruth& truth, const NumberFormat& format, const Tolerance& tolerance, Monitor* monitor) {
  return std::make_unique<UnionMeasures>(truth, format, tolerance, monitor);
}

}  // namespace fathom::judging
