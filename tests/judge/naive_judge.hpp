// SPDX-License-Identifier: GPL-3.0-or-later
// The distance of a point from a hull, by trying every simplex: the nearest point lies inside one
// of at most four points, where it is the foot of the perpendicular.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/judge/manifold.hpp"

namespace fathom::testing {

/// Solves the rows (matrix | right side) of a positive definite system; returns nullopt if it is
/// singular.
inline std::optional<std::vector<mpq_class>> solved(std::vector<std::vector<mpq_class>> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i][i] == 0) return std::nullopt;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k == i) continue;
      const mpq_class factor = rows[k][i] / rows[i][i];
      for (std::size_t j = 0; j < rows[k].size(); ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  std::vector<mpq_class> solution;
  for (std::size_t i = 0; i < rows.size(); ++i) solution.emplace_back(rows[i].back() / rows[i][i]);
  return solution;
}

/// The squared distance of p from the simplex if the foot of the perpendicular is in it.
inline std::optional<mpq_class> squared_distance_of_foot(const Point& p, const std::vector<Point>& simplex) {
  std::vector<std::vector<mpq_class>> rows;
  Point rest = p - simplex[0];
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    const Point edge = simplex[i] - simplex[0];
    rows.emplace_back();
    for (std::size_t j = 1; j < simplex.size(); ++j) rows.back().push_back(dot(edge, simplex[j] - simplex[0]));
    rows.back().push_back(dot(edge, rest));
  }
  const auto weights = solved(rows);
  if (!weights) return std::nullopt;
  mpq_class first = 1;
  for (std::size_t i = 0; i < weights->size(); ++i) {
    const mpq_class& w = (*weights)[i];
    if (w < 0) return std::nullopt;
    first -= w;
    const Point edge = simplex[i + 1] - simplex[0];
    rest = rest - w * edge;
  }
  if (first < 0) return std::nullopt;
  return dot(rest, rest);
}

/// `simplex` and up to four points in all, the others from `body` at `next` or later.
inline void try_simplices(const Point& p, const std::vector<Point>& body, std::vector<Point>& simplex, std::size_t next,
                          std::optional<mpq_class>& least) {
  if (!simplex.empty()) {
    const auto squared = squared_distance_of_foot(p, simplex);
    if (squared && (!least || *squared < *least)) least = squared;
  }
  if (simplex.size() == 4) return;
  for (std::size_t i = next; i < body.size(); ++i) {
    simplex.push_back(body[i]);
    try_simplices(p, body, simplex, i + 1, least);
    simplex.pop_back();
  }
}

inline mpq_class squared_distance_naive(const Point& p, const std::vector<Point>& body) {
  std::optional<mpq_class> least;
  std::vector<Point> simplex;
  try_simplices(p, body, simplex, 0, least);
  return *least;
}

// The findings of VERDICTS.md once more, straight from the page, in floating-point numbers of
// thousands of bits: roots are taken, the hull of all differences is at hand, nothing is squared.
// Differences below 2^-2000 count as 0.

class NaiveJudge {
 public:
  NaiveJudge(const Truth& truth, const Conventions& conventions, Precision precision, const Tolerance& tolerance)
      : truth_(truth),
        conventions_(conventions),
        precision_(precision),
        tolerance_(tolerance),
        p_(differences(polytope::place(truth.a, truth.b))) {
    denominator_ = polytope::place(truth.a, truth.b).denominator;
    depth_ = root(real(truth.depth.squared()));
    distance_ = truth.depth.distance() ? root(real(truth.depth.distance()->squared)) : real(0);
    measure_slack(truth.depth.squared(), depth_);
  }

  /// For finite numbers. Witness points are judged if their bodies are small.
  std::vector<Verdict> findings(const Reply& reply) const {
    std::vector<Verdict> found;
    const Status status = truth_.depth.status();
    const bool overlap = reply.overlap, has_depth = overlap && reply.depth.has_value();
    mpf_class d = has_depth ? real(exact_value(*reply.depth)) : real(0);
    if (conventions_.depth == Conventions::Sign::negative) d = -d;
    if (status == Status::penetrating && !overlap && more(depth_, tol_)) found.push_back(Verdict::false_separation);
    if (status == Status::disjoint && overlap && (more(distance_, tol_) || more(d, tol_)))
      found.push_back(Verdict::false_overlap);
    if (status == Status::touching && overlap && conventions_.touching == Conventions::Touching::separate)
      found.push_back(Verdict::false_overlap);
    if (status == Status::touching && !overlap && conventions_.touching == Conventions::Touching::overlap)
      found.push_back(Verdict::false_separation);
    if (!overlap && reply.distance) return of_distance(reply, found);
    if (!has_depth) return found;
    if (more(real(-depth_tol_), d) && !more(real(abs(real(-d - depth_))), depth_tol_)) {
      found.push_back(Verdict::wrong_sign);
      d = -d;
    }
    if (more(real(d - depth_), depth_tol_)) found.push_back(Verdict::too_deep);
    if (more(real(depth_ - d), depth_tol_)) found.push_back(Verdict::too_shallow);
    const std::optional<Point> u = reply.direction ? judge_direction(exact(*reply.direction), d, found) : std::nullopt;
    if (witness_off(reply, u, d)) found.push_back(Verdict::witness_off);
    judge_contacts(reply, d, found);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  [[nodiscard]] const mpf_class& depth_tol() const { return depth_tol_; }
  [[nodiscard]] const mpf_class& direction_tol() const { return direction_tol_; }
  [[nodiscard]] const mpf_class& witness_tol() const { return witness_tol_; }
  [[nodiscard]] const mpf_class& gap_tol() const { return gap_tol_; }
  [[nodiscard]] const mpf_class& depth() const { return depth_; }
  [[nodiscard]] const mpf_class& distance() const { return distance_; }
  /// The same judge, who allows what is allowed of a distance.
  [[nodiscard]] NaiveJudge about_distance() const {
    NaiveJudge result = *this;
    result.measure_slack(truth_.depth.distance() ? truth_.depth.distance()->squared : mpq_class(0), distance_);
    return result;
  }
  /// h(u) / |u|.
  [[nodiscard]] mpf_class separating_distance(const Point& u) const {
    mpq_class low = along(u, truth_.a.front()), high = along(u, truth_.b.front());
    for (const Point& p : truth_.a) low = std::min(low, along(u, p));
    for (const Point& p : truth_.b) high = std::max(high, along(u, p));
    return real(real(mpq_class(high - low)) / length(u));
  }
  [[nodiscard]] mpf_class exit_distance(const Point& u) const {
    if (truth_.depth.status() != Status::penetrating) return real(0);
    const mpz_class d = lcm(lcm(u.x.get_den(), u.y.get_den()), u.z.get_den());
    const Vector v{mpq_class(d * u.x).get_num(), mpq_class(d * u.y).get_num(), mpq_class(d * u.z).get_num()};
    return real(real(mpq_class(factor_naive(p_, v) * d / denominator_)) * length(u));
  }

 private:
  static constexpr mp_bitcnt_t bits = 6000;
  static mpf_class real(const mpf_class& x) { return mpf_class(x, bits); }
  static mpf_class real(const mpq_class& x) {
    return mpf_class(mpf_class(x.get_num(), bits) / mpf_class(x.get_den(), bits), bits);
  }
  static mpf_class real(int x) { return mpf_class(x, bits); }
  static mpf_class root(const mpf_class& x) { return mpf_class(sqrt(x), bits); }
  static bool more(const mpf_class& x, const mpf_class& y) {
    mpf_class hair(1, bits);
    mpf_div_2exp(hair.get_mpf_t(), hair.get_mpf_t(), 2000);
    return mpf_class(x - y, bits) > hair;
  }
  static Point exact(const Triple& u) { return {exact_value(u[0]), exact_value(u[1]), exact_value(u[2])}; }
  static mpq_class along(const Point& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }
  static mpf_class length(const Point& u) { return root(real(along(u, u))); }

  [[nodiscard]] std::vector<Verdict> of_distance(const Reply& reply, std::vector<Verdict> found) const {
    const NaiveJudge judge = about_distance();
    mpf_class e = real(exact_value(*reply.distance));
    if (more(real(-judge.depth_tol_), e) && !more(real(abs(real(-e - distance_))), judge.depth_tol_)) {
      found.push_back(Verdict::wrong_sign);
      e = -e;
    }
    if (more(real(e - distance_), judge.depth_tol_)) found.push_back(Verdict::too_far);
    if (more(real(distance_ - e), judge.depth_tol_)) found.push_back(Verdict::too_near);
    std::optional<Point> u = reply.direction ? std::optional(exact(*reply.direction)) : std::nullopt;
    if (u) u = judge.judge_direction(*u, real(-e), found, false);
    if (judge.witness_off(reply, u, real(-e))) found.push_back(Verdict::witness_off);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The direction in which A moves, mended; nullopt if it is zero. `moved`: whether the way along
  /// it is to separate.
  std::optional<Point> judge_direction(const Point& given, const mpf_class& d, std::vector<Verdict>& found,
                                       bool moved = true) const {
    if (given == Point{0, 0, 0}) {
      found.push_back(Verdict::not_a_direction);
      return std::nullopt;
    }
    const mpq_class u16 = precision_ == Precision::binary64 ? exact_value(0x1p-49) : exact_value(0x1p-20);
    const mpf_class slack = real(std::max({tolerance_.relative, u16, mpq_class(u16 * tolerance_.ulps / 8)}));
    if (conventions_.unit && more(real(abs(real(length(given) - 1))), slack)) found.push_back(Verdict::not_a_direction);
    const bool b_moves = conventions_.moves == Conventions::Body::b;
    const Point opposite{-given.x, -given.y, -given.z}, u = b_moves ? opposite : given, v = b_moves ? given : opposite;
    const auto consistent = [&](const Point& x) {
      return !more(real(abs(real(d - separating_distance(x)))), direction_tol_);
    };
    const auto separates = [&](const Point& x) {
      return !moved || truth_.depth.status() != Status::penetrating ||
             !more(real(exit_distance(x) - d), direction_tol_);
    };
    if (consistent(u) && separates(u)) return u;
    if (consistent(v) && separates(v)) {
      found.push_back(Verdict::wrong_sign);
      return v;
    }
    if (!separates(u)) found.push_back(Verdict::not_separating);
    if (!consistent(u)) found.push_back(Verdict::inconsistent);
    return u;
  }

  /// d is the depth, mended; so are those of the contacts. What is wrong with them along the
  /// direction is taken over: manifold_test.cpp holds it to its definitions.
  void judge_contacts(const Reply& reply, const mpf_class& d, std::vector<Verdict>& found) const {
    std::vector<judging::ContactFault> faults;
    if (std::ranges::none_of(found, [](Verdict finding) { return finding <= Verdict::wrong_sign; }))
      faults = OwnedContactJudge(truth_, reply, conventions_, precision_, tolerance_).judge.faults();
    std::vector<char> outside(reply.contacts.size(), 0);
    for (const judging::ContactFault& fault : faults) {
      found.push_back(fault.finding);
      if (fault.finding == Verdict::contact_outside) outside[*fault.contact] = 1;
    }
    const bool flipped = (sgn(d) < 0) != (*reply.depth < 0);
    std::optional<mpf_class> deepest;
    for (std::size_t k = 0; k < reply.contacts.size(); ++k) {
      const ContactPoint& contact = reply.contacts[k];
      const mpf_class depth = real(exact_value((flipped ? -1 : 1) * contact.depth.value_or(0)));
      const mpf_class allowed = real(depth < 0 ? real(witness_tol_ - depth) : witness_tol_);
      for (const GivenPoints* body : {&truth_.a, &truth_.b})
        if (outside[k] == 0 && more(root(real(squared_distance_naive(exact(contact.position), *body))), allowed))
          found.push_back(Verdict::witness_off);
      if (!contact.depth) continue;
      if (!deepest || depth > *deepest) deepest = depth;
    }
    if (deepest && more(real(abs(real(*deepest - d))), depth_tol_)) found.push_back(Verdict::inconsistent);
  }

  [[nodiscard]] bool witness_off(const Reply& reply, const std::optional<Point>& u, const mpf_class& d) const {
    const auto away = [&](const std::optional<Triple>& w, const std::vector<Point>& body) {
      return w && more(root(real(squared_distance_naive(exact(*w), body))), witness_tol_);
    };
    if (away(reply.witness_a, truth_.a) || away(reply.witness_b, truth_.b)) return true;
    if (!reply.witness_a || !reply.witness_b || (reply.direction && !u)) return false;
    const Point way = exact(*reply.witness_b) - exact(*reply.witness_a);
    if (!u) return more(real(abs(real(length(way) - (reply.overlap ? d : real(-d))))), gap_tol_);
    mpf_class squared = real(0);
    for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
      const mpf_class miss = real(real(way.*axis) - real(d * real(real((*u).*axis) / length(*u))));
      squared += miss * miss;
    }
    return more(root(squared), gap_tol_);
  }

  /// What an answer may be off by if its numbers are off by `ulps`, or by half of one.
  void measure_slack(const mpq_class& squared, const mpf_class& length_in_question) {
    tol_ = std::max({real(real(tolerance_.relative) * length_in_question), real(real(tolerance_.absolute) * extent()),
                     real(real(mpq_class(tolerance_.ulps)) * ulp(squared))});
    mpq_class farthest, reach;
    for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
      for (const Point& p : truth_.a) {
        for (const Point& q : truth_.b) {
          farthest = std::max({farthest, mpq_class(abs(p.*axis)), mpq_class(abs(q.*axis))});
          reach = std::max(reach, mpq_class(abs(q.*axis - p.*axis)));
        }
      }
    }
    const mpq_class u = precision_ == Precision::binary64 ? exact_value(0x1p-53) : exact_value(0x1p-24);
    const mpf_class numbers = real(tolerance_.ulps == 0 ? mpq_class(1, 2) : mpq_class(tolerance_.ulps)),
                    far = real(numbers * ulp(farthest * farthest)), of_depth = real(numbers * ulp(squared));
    depth_tol_ = std::max(tol_, of_depth);
    direction_tol_ = std::max(tol_, real(of_depth + numbers * real(mpq_class(4 * u * reach))));
    witness_tol_ = std::max(tol_, real(far * 7 / 4));
    gap_tol_ = std::max(tol_, real(of_depth * 3 + far * 7 / 2));
  }

  [[nodiscard]] mpf_class extent() const {
    mpq_class result;
    for (const GivenPoints* body : {&truth_.a, &truth_.b}) {
      for (const Point& p : *body) {
        for (const Point& q : *body)
          result = std::max({result, mpq_class(p.x - q.x), mpq_class(p.y - q.y), mpq_class(p.z - q.z)});
      }
    }
    return real(result);
  }

  /// The distance of neighbours around a root, by asking for them.
  [[nodiscard]] mpf_class ulp(const mpq_class& squared) const {
    if (precision_ == Precision::binary64) {
      const double low = root_binary64(squared, Rounding::rd);
      return real(mpq_class(exact_value(std::nextafter(low, 1e308)) - exact_value(low)));
    }
    const float low = root_binary32(squared, Rounding::rd);
    return real(mpq_class(exact_value(std::nextafter(low, 3e38F)) - exact_value(low)));
  }

  const Truth& truth_;
  Conventions conventions_;
  Precision precision_;
  Tolerance tolerance_;
  polytope::Polytope p_;
  mpz_class denominator_;
  mpf_class depth_{0, bits}, distance_{0, bits}, tol_{0, bits};
  mpf_class depth_tol_{0, bits}, direction_tol_{0, bits}, witness_tol_{0, bits}, gap_tol_{0, bits};
};

}  // namespace fathom::testing
