// SPDX-License-Identifier: GPL-3.0-or-later
// Of polytopes: directions are judged by the plane across them and the way along them.                       [proofs/judge.md]
#include <fmt/format.h>

#include <cmath>

#include "fathom/numbers.hpp"
#include "verify/judge/exact_measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

double root(const mpq_class& squared) { return root_binary64(squared, Rounding::rn); }

std::optional<mpq_class> distance_of(const Depth& depth) {
  return depth.distance() ? std::optional(depth.distance()->squared) : std::nullopt;
}

class PolytopeMeasures final : public ExactMeasures {
 public:
  PolytopeMeasures(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance)
      : ExactMeasures(sizes_of(truth.a, truth.b), truth.depth.status(), truth.depth.squared(), distance_of(truth.depth), format, tolerance),
        truth_(truth),
        scene_(truth) {}

  bool is_inconsistent(const Vector& u, const mpq_class& d) override {
    return of_direction().off(d, price_ && way_ == u ? *price_ : scene_.price(u));
  }
  bool is_dearer(const Vector& u, const mpq_class& times) override { return scene_.price(u) > times * times * depth_squared(); }
  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    return status() == Status::penetrating && of_direction().below(d, travel(u));
  }

  [[nodiscard]] std::string left(const mpq_class& d) const override {
    return fmt::format("{:.4g} of overlap is left along its direction", std::abs(kernels::nearest_binary64({-d, travel_})));
  }
  [[nodiscard]] std::string across(const std::string& claimed) const override {
    return fmt::format("the plane across its direction is at {}, not at {}", kernels::nearest_binary64({0, *price_}), claimed);
  }
  [[nodiscard]] std::string gap(const std::string& claimed) const override {
    if (sgn(*price_) > 0) return "no plane across its direction separates the bodies";
    return fmt::format("the gap across its direction is {}, not {}", root(-*price_), claimed);
  }

 private:
  [[nodiscard]] mpq_class squared_distance_a(const Point& point) const override { return squared_distance(point, truth_.a.exact()); }
  [[nodiscard]] mpq_class squared_distance_b(const Point& point) const override { return squared_distance(point, truth_.b.exact()); }

  void measure_direction(const Claim& claim, Judgement& result) override {
    if (!claim.direction) return;
    result.travel_squared = travel(*claim.direction);
    price_ = result.price_squared = scene_.price(*claim.direction);
    const bool overlap = claim.overlap && status() == Status::penetrating;
    if (overlap) result.dearer = kernels::nearest_binary64({-1, *price_ / depth_squared()});
    if (!claim.length) return;
    result.inconsistency = kernels::nearest_binary64({claim.way(), -*price_});
    const Surd left{-claim.way(), *result.travel_squared};
    if (overlap && sign(left) > 0) result.overlap_left = kernels::nearest_binary64(left);
  }

  const mpq_class& travel(const Vector& u) {
    if (!way_ || *way_ != u) {
      travel_ = scene_.travel(u);
      price_.reset();
      way_ = u;
    }
    return travel_;
  }

  const Truth& truth_;
  Scene scene_;
  std::optional<mpq_class> price_;
  std::optional<Vector> way_;  // whose travel is known, and maybe whose price
  mpq_class travel_;
};

}  // namespace

std::unique_ptr<Measures> measures_of(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance) {
  return std::make_unique<PolytopeMeasures>(truth, format, tolerance);
}

}  // namespace fathom::judging
