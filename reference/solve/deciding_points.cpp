// SPDX-License-Identifier: GPL-3.0-or-later
// Guesses the deciding points on bodies rounded to a coarse grid, and answers exactly for those. If
// other points lie farther out in a direction of that answer, they become deciding points too, and
// it answers again.

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::solve {
namespace {

constexpr long grid_bits = 128;  // of the largest coordinate
constexpr int most_rounds = 100;
constexpr std::size_t worth_a_guess = 32;  // points: of fewer, more than half decide

// q * 2^shift, truncated.
mpz_class truncated(const mpq_class& q, long shift) {
  mpz_class n = q.get_num(), d = q.get_den();
  if (shift > 0) n <<= static_cast<unsigned long>(shift);
  else d <<= static_cast<unsigned long>(-shift);
  return n / d;
}

// The points, seen from `origin`, as integers that err by less than one in each coordinate.
struct Rounded {
  std::vector<Vector> a, b;

  Rounded(kernels::Context& context, polytope::Positions of_a, polytope::Positions of_b) {
    const Point& origin = of_b.front();
    long size = -grid_bits * (1L << 20);
    for (const polytope::Positions& body : {of_a, of_b}) {
      for (const Point& p : body) {
        context.check();
        for (const mpq_class& c : {mpq_class(p.x - origin.x), mpq_class(p.y - origin.y), mpq_class(p.z - origin.z)})
          if (c != 0) size = std::max(size, kernels::binary_order(c));
      }
    }
    const long shift = grid_bits - size;
    for (const auto& [body, images] : {std::pair(of_a, &a), std::pair(of_b, &b)}) {
      for (const Point& p : body) {
        context.check();
        images->push_back(image(p, origin, shift));
      }
    }
  }

  static Vector image(const Point& p, const Point& origin, long shift) {
    return {truncated(p.x - origin.x, shift), truncated(p.y - origin.y, shift), truncated(p.z - origin.z, shift)};
  }
};

// Of the listed points, those that maximise <u, p>.
std::vector<std::uint32_t> extreme_among(polytope::Positions body, const Vector& u, std::vector<std::uint32_t> listed) {
  kernels::keep_greatest<mpq_class>(listed, [&](mpq_class& value, std::uint32_t i) { value = dot(u, body[i]); });
  return listed;
}

// The same among all. Coordinates of images err by less than one, so a product does by less than
// |u|_1: what is extreme is within twice that of the greatest.
std::vector<std::uint32_t> extreme_of_all(polytope::Positions body, std::span<const Vector> images, const Vector& u) {
  std::vector<mpz_class> values;
  values.reserve(images.size());
  for (const Vector& p : images) values.push_back(dot(u, p));
  const mpz_class level = *std::ranges::max_element(values) - 2 * (abs(u.x) + abs(u.y) + abs(u.z));
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < values.size(); ++i)
    if (values[i] >= level) near.push_back(i);
  return near.size() == 1 ? near : extreme_among(body, u, std::move(near));
}

// Takes the differences to the first point. Scaling each separately does not change the rank.
bool is_flat(polytope::Positions body) {
  std::vector<Vector> directions{{0, 0, 0}};
  for (const Point& p : body) {
    const Point d = p - body[0];
    const mpz_class scale = lcm(lcm(d.x.get_den(), d.y.get_den()), d.z.get_den());
    directions.push_back({mpz_class(d.x * scale), mpz_class(d.y * scale), mpz_class(d.z * scale)});
  }
  return polytope::affine_rank(directions) < 3;
}

// The directions that an answer names. Where all points agree in each of them with those that were
// asked, the answer is right.
std::vector<Vector> directions_of(const Depth& depth) {
  if (!depth.penetration()) return {depth.direction()};
  std::vector<Vector> directions;
  for (const Optimum& optimum : depth.optima()) directions.push_back(optimum.direction);
  return directions;
}

// The chosen points of one body.
class Choice {
 public:
  Choice(polytope::Positions body, std::span<const Vector> images) : body_(body), images_(images) {}

  void add(std::uint32_t i) { chosen_.insert(i); }
  // Whether one was missing.
  bool add_extreme(const Vector& u) {
    const std::size_t before = chosen_.size();
    for (const std::uint32_t i : extreme_of_all(body_, images_, u)) add(i);
    return chosen_.size() > before;
  }

  [[nodiscard]] std::size_t size() const { return chosen_.size(); }
  [[nodiscard]] std::vector<std::uint32_t> ids() const { return {chosen_.begin(), chosen_.end()}; }
  [[nodiscard]] std::vector<Point> points() const {
    std::vector<Point> points;
    for (const std::uint32_t i : chosen_) points.push_back(body_[i]);
    return points;
  }

 private:
  polytope::Positions body_;
  std::span<const Vector> images_;
  std::set<std::uint32_t> chosen_;
};

class Deciding {
 public:
  Deciding(kernels::Context& context, polytope::Positions a, polytope::Positions b)
      : a_(a), b_(b), images_(context, a, b), chosen_a_(a, images_.a), chosen_b_(b, images_.b) {}

  std::optional<Depth> run(kernels::Context& context, const Options& options) {
    guess(context);
    // All optima are needed: each must be one of all points, too.
    Options whole = options;
    whole.optima.reset();
    for (int round = 0; round < most_rounds && 2 * (chosen_a_.size() + chosen_b_.size()) <= a_.size() + b_.size();
         ++round) {
      Depth depth = depth_by_method(context, polytope::place(chosen_a_.points(), chosen_b_.points(), &context), whole);
      if (add_extremes(depth)) continue;
      if (auto* penetration = std::get_if<Penetration>(&depth.outcome)) depth::list_first(*penetration, options.optima);
      return of_all(std::move(depth));
    }
    return std::nullopt;
  }

 private:
  void guess(kernels::Context& context) {
    const Depth depth = depth_by_method(context, polytope::place_integers(images_.a, images_.b), {});
    add_extremes(depth);
    if (!depth.penetration() || !depth.penetration()->inner) return;
    for (const auto& [i, j] : depth.penetration()->inner->vertices) {
      chosen_a_.add(i);
      chosen_b_.add(j);
    }
  }

  bool add_extremes(const Depth& depth) {
    bool missing = false;
    for (const Vector& n : directions_of(depth)) {
      missing = chosen_a_.add_extreme(-n) || missing;
      missing = chosen_b_.add_extreme(n) || missing;
    }
    return missing;
  }

  // With the indices of all points.
  Depth of_all(Depth depth) const {
    const std::vector<std::uint32_t> ids_a = chosen_a_.ids(), ids_b = chosen_b_.ids();
    const auto rename = [&](Contact& contact) {
      for (std::uint32_t& i : contact.a) i = ids_a[i];
      for (std::uint32_t& i : contact.b) i = ids_b[i];
    };
    if (auto* penetration = std::get_if<Penetration>(&depth.outcome)) {
      for (Optimum& optimum : penetration->optima) rename(optimum.contact);
      if (penetration->inner)
        for (auto& [i, j] : penetration->inner->vertices) std::tie(i, j) = std::pair(ids_a[i], ids_b[j]);
    }
    if (auto* distance = std::get_if<Distance>(&depth.outcome)) rename(distance->contact);
    depth.flat_a = depth.flat_a && is_flat(a_);
    depth.flat_b = depth.flat_b && is_flat(b_);
    depth.extreme_a = depth.extreme_b = 0;
    return depth;
  }

  polytope::Positions a_, b_;
  Rounded images_;
  Choice chosen_a_, chosen_b_;
};

}  // namespace

std::optional<Depth> depth_by_deciding_points(kernels::Context& context, polytope::Positions a, polytope::Positions b,
                                              const Options& options) {
  if (a.size() + b.size() < worth_a_guess) return std::nullopt;
  return Deciding(context, a, b).run(context, options);
}

std::vector<std::uint32_t> extreme_points(polytope::Positions body, const Vector& u) {
  std::vector<std::uint32_t> all(body.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return extreme_among(body, u, std::move(all));
}

}  // namespace fathom::solve
