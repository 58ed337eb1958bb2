// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the first contact: at a time at which the bodies are apart, the planes that their
// nearest points suggest; each is followed as far as it separates the bodies; from its end it goes
// on. The contact is looked for on a grid of times, so what is found does not depend on the way.
//                                                                     [proofs/impact.md, theorem 6]
#include "fathom/impact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/contact.hpp"
#include "reference/motion/motion.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::motion {
namespace {

constexpr std::size_t most_pieces = 100'000;

/// The bodies at one time.
struct Moment {
  mpq_class t;
  polytope::PlacedPair placed;
  polytope::PositionOfOrigin origin;
  std::optional<polytope::NearestPoints> nearest;  ///< if they are apart

  [[nodiscard]] bool apart() const { return nearest.has_value(); }
  /// From B to A.
  [[nodiscard]] const Vector& normal() const { return nearest->normal; }
  [[nodiscard]] mpq_class squared_distance() const {
    const mpq_class height = kernels::ratio(nearest->height, 1) * placed.unit();
    return height * height / kernels::ratio(dot(normal(), normal()), 1);
  }
};

/// The first x in (0, 1] where the polynomial may fall to 0, as a guess. What depends on it is how
/// many guesses are made, and where pieces end.
double guessed_root(const Over<mpz_class>& f) {
  long order = 0;
  std::vector<double> c;
  for (const mpz_class& v : f) order = std::max(order, kernels::bit_length(v));
  for (const mpz_class& v : f) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, v.get_mpz_t());
    c.push_back(std::ldexp(mantissa, static_cast<int>(std::max(exponent - order, -2000L))));
  }
  const auto value = [&](double x) {  // Horner's rule, in x / (1-x) times powers of 1-x
    double sum = 0, power = 1;
    for (const double v : c) {
      sum = sum * (1 - x) + v * power;
      power *= x;
    }
    return sum;
  };
  constexpr int samples = 16;
  for (int k = 1; k <= samples; ++k) {
    double low = static_cast<double>(k - 1) / samples, high = static_cast<double>(k) / samples;
    if (value(high) > 0) continue;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (value(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
  return 0.5;
}

class ImpactSearch {
 public:
  ImpactSearch(const MovingPair& pair, const ImpactOptions& options)
      : pair_(pair), context_(options.monitor), cell_(1, mpz_class(1) << options.bits) {
    cell_.canonicalize();
    delta_ = options.delta.value_or(mpq_class(cell_ * pair.extent()));
  }

  Impact run() {
    Moment now = at(0);
    if (!now.apart()) {
      impact_.status = ImpactStatus::at_beginning;
      return std::move(impact_);
    }
    while (now.t < 1) {
      context_.report("impact", now.t.get_d());
      require_few_pieces(now.t);
      std::optional<Moment> next = step(now);
      if (impact_.contact) return std::move(impact_);
      if (!next && !(next = cross_cell(now))) return std::move(impact_);
      now = *std::move(next);
    }
    stand(now);
    if (impact_.status != ImpactStatus::grazing) impact_.status = ImpactStatus::apart;
    return std::move(impact_);
  }

 private:
  struct Reach {
    mpq_class until, fails;  ///< until < fails, unless until = 1
    MovingPlane plane;
  };

  Moment at(const mpq_class& t) {
    ++impact_.questions;
    Moment moment{t, pair_.at(t), {}, {}};
    moment.origin = polytope::position_of_origin(moment.placed.a, moment.placed.b);
    if (moment.origin.position == polytope::Position::outside)
      moment.nearest = polytope::nearest_points(moment.placed.a, moment.placed.b);
    return moment;
  }

  void require_few_pieces(const mpq_class& t) const {
    if (impact_.pieces.size() >= most_pieces)
      throw ImpactTooLong("the motion needs more than 100000 pieces of time until " + t.get_str());
  }

  /// A multiple of 2^-k in (low, t], for a small k: in the last eighth of it, or the greatest of
  /// the grid.
  mpq_class short_time(const mpq_class& low, const mpq_class& t, bool exact) const {
    const long order = kernels::binary_order(t - low);
    mpz_class denominator = mpz_class(1) << static_cast<unsigned long>(std::max(0L, -order));
    if (exact || denominator > cell_.get_den()) denominator = cell_.get_den();
    for (;; denominator *= 2) {
      mpz_class floor;
      const mpz_class numerator = t.get_num() * denominator;
      mpz_fdiv_q(floor.get_mpz_t(), numerator.get_mpz_t(), t.get_den_mpz_t());
      mpq_class result = kernels::ratio(floor, denominator);
      if (denominator == cell_.get_den() || 8 * (result - low) > 7 * (t - low)) return result;
    }
  }

  /// How far from s, at most up to `end`, the plane separates the bodies, to an eighth of that; or
  /// to the cell. Returns nullopt if it does not reach the next time of the grid.
  std::optional<Reach> reach(const MovingPlane& plane, const mpq_class& s, const mpq_class& end, bool exact) const {
    mpq_class low = s, high = end;
    Holding holding = pair_.holding(plane, s, end);
    if (holding.holds) return Reach{end, end, plane};
    double root = guessed_root(holding.broken);
    int tries = 0;
    while (high - low > cell_ && (exact || low == s || 8 * (high - low) > low - s)) {
      mpq_class t = s + mpq_class(root) * (high - s);  // of the gap that failed
      if (++tries % 3 == 0 || t <= low || t >= high) t = (low + high) / 2;
      t = short_time(low, t, exact || high - low < 16 * cell_);
      if (t <= low) t = low + cell_;
      if (t >= high) t = high - cell_;
      holding = pair_.holding(plane, s, t);
      if (holding.holds) {
        low = t;
        if (low + cell_ < high && exact) {  // the root was a good one, if this fails
          holding = pair_.holding(plane, s, low + cell_);
          if (holding.holds) low += cell_;
          else high = low + cell_;
        }
        root = mpq_class(((low + high) / 2 - s) / (high - s)).get_d();
      } else {
        root = guessed_root(holding.broken);
        high = t;
      }
    }
    if (low == s) return std::nullopt;
    return Reach{low, high, plane};
  }

  /// Of these planes the one that reaches farthest.
  std::optional<Reach> farthest(const std::vector<MovingPlane>& planes, const mpq_class& s) const {
    std::optional<Reach> best;
    for (const MovingPlane& plane : planes) {
      if (best && (best->until == 1 || !pair_.holding(plane, s, best->until).holds)) continue;
      std::optional<Reach> found = reach(plane, s, 1, false);
      if (found && (!best || found->until > best->until)) best = std::move(found);
    }
    return best;
  }

  /// Goes on with the piece before, if its plane is the same and holds on.
  void add(const mpq_class& until, const MovingPlane& plane) {
    std::vector<ImpactPiece>& pieces = impact_.pieces;
    const mpq_class from = pieces.size() < 2 ? mpq_class(0) : pieces[pieces.size() - 2].until;
    if (!pieces.empty() && pieces.back().plane == plane && pair_.holding(plane, from, until).holds)
      pieces.back().until = until;
    else pieces.push_back({until, plane, {}});
  }

  /// Goes on from a time at which the bodies are apart. Returns nullopt if no plane reaches the
  /// next time of the grid, or if it has found the contact.
  std::optional<Moment> step(const Moment& now) {
    const std::optional<Reach> found = farthest(pair_.planes(now.t, now.placed, now.normal()), now.t);
    if (!found) return std::nullopt;
    if (found->until == 1) {
      add(1, found->plane);
      return Moment{1, {}, {}, {}};
    }
    const Moment beyond = at(found->fails);
    if (!beyond.apart()) {
      const Reach whole = *reach(found->plane, now.t, found->fails, true);
      add(whole.until, whole.plane);
      if (const Moment next = at(whole.until + cell_); !next.apart()) {
        meet(whole.until, pair_.at(whole.until), pair_.direction(whole.plane, whole.until), next);
        return std::nullopt;
      }
      return at(whole.until);
    }
    add(found->until, found->plane);
    // The plane beyond reaches back, as a rule.
    if (std::optional<Reach> on = farthest(pair_.planes(beyond.t, beyond.placed, beyond.normal()), found->until);
        on && on->until >= beyond.t) {
      if (on->until == 1) {
        add(1, on->plane);
        return Moment{1, {}, {}, {}};
      }
      add(beyond.t, on->plane);
      return beyond;
    }
    return at(found->until);
  }

  /// Shows at this time alone that the bodies are apart, if no piece does: at 0, and next to a near
  /// miss.
  void stand(const Moment& now) {
    if (impact_.pieces.empty() || impact_.pieces.back().near)
      add(now.t, pair_.planes(now.t, now.placed, now.normal()).front());
  }

  /// From a time of the grid to the next: a contact there, or a way through the cell, or a near
  /// miss. Returns nullopt if it is the contact.
  std::optional<Moment> cross_cell(const Moment& now) {
    stand(now);
    Moment next = at(now.t + cell_);
    if (!next.apart()) {
      meet(now.t, now.placed, pair_.direction(*impact_.pieces.back().plane, now.t), next);
      return std::nullopt;
    }
    std::optional<Moment> inside;
    const Moment* from = &now;
    while (from->t < next.t) {
      context_.check();
      require_few_pieces(from->t);
      mpq_class best = from->t;
      std::optional<MovingPlane> with;
      for (const MovingPlane& plane : pair_.planes(from->t, from->placed, from->normal()))
        for (mpq_class step = next.t - from->t; step > 0; step /= 2) {
          if (from->t + step <= best) break;
          if (!pair_.holding(plane, from->t, from->t + step).holds) continue;
          best = from->t + step;
          with = plane;
        }
      const bool stuck = best < next.t && 16 * (best - from->t) < cell_;
      if (stuck && from->squared_distance() <= delta_ * delta_) {
        miss(now, next);
        break;
      }
      impact_.pieces.push_back({best, with, {}});
      inside = at(best);
      from = &*inside;
    }
    return next;
  }

  /// The pieces inside the cell are taken back: the bodies may touch anywhere in it.
  void miss(const Moment& now, const Moment& next) {
    while (!impact_.pieces.empty() && impact_.pieces.back().until > now.t) impact_.pieces.pop_back();
    const mpq_class squared = next.squared_distance();
    mpq_class gap = delta_;
    while (gap * gap < squared) gap *= 2;
    impact_.pieces.push_back({next.t, {}, NearMiss{std::move(gap), next.nearest->a, next.nearest->b}});
    impact_.status = ImpactStatus::grazing;
  }

  void meet(const mpq_class& t, const polytope::PlacedPair& placed, const Vector& normal, const Moment& next) {
    FirstContact contact;
    contact.t0 = t;
    contact.t1 = next.t;
    contact.a = next.origin.a;
    contact.b = next.origin.b;
    contact.point =
        depth::combination(contact.a, [&](std::size_t i) { return next.placed.position(next.placed.a[i]); });
    contact.normal = normal;
    contact.contact = depth::contact_along(placed, contact.normal);
    impact_.contact = std::move(contact);
    impact_.status = ImpactStatus::contact;
  }

  const MovingPair& pair_;
  kernels::Context context_;
  mpq_class cell_, delta_;
  Impact impact_;
};

}  // namespace
}  // namespace fathom::motion

namespace fathom {

Impact first_contact(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b,
                     const RigidMotion& of_b, const ImpactOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  if (options.bits < 1 || options.bits > 1000)
    throw std::invalid_argument("the bits of a time of contact are from 1 to 1000");
  if (options.delta) kernels::require_lowest_terms(*options.delta);
  if (options.delta && *options.delta <= 0) throw std::invalid_argument("expected a positive delta of a near miss");
  const motion::MovingPair pair(a, of_a, b, of_b);
  Impact impact = motion::ImpactSearch(pair, options).run();
  if (impact.status == ImpactStatus::at_beginning) {
    Options asked;
    asked.monitor = options.monitor;
    impact.beginning = penetration_depth(placed_at(a, of_a, 0), placed_at(b, of_b, 0), asked);
  }
  if (impact.contact) {
    FirstContact& contact = *impact.contact;
    contact.in_a = depth::combination(contact.a, [&](std::size_t i) { return a[i]; });
    contact.in_b = depth::combination(contact.b, [&](std::size_t i) { return b[i]; });
  }
  return impact;
}

}  // namespace fathom
