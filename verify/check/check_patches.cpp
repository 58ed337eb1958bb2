// SPDX-License-Identifier: Apache-2.0
// Contact patches: the p in A for which p + t is in B, t = (h(n)/<n,n>) n, are the hull of the
// corners. And how fast the signed depth grows as A moves.                  [FORMAT.md, section 13]
#include <algorithm>
#include <numeric>

#include "checks.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// The core points that reach as far as the core does in its direction s: -n or n.
struct Face {
  MutableVector s;
  mpz_class level;
  std::vector<Vector> points;  ///< none of a half-space
};

class Patches {
 public:
  Patches(const Certificate& certificate, const Scaled& bodies)
      : c_(&certificate), parts_(&certificate.of_patches), bodies_(&bodies) {}

  /// Throws Fault (refused) unless each direction has its patch.
  void check() {
    const std::vector<Vector>& directions = c_->directions.items;
    if (parts_->corner_lists.size() != directions.size())
      throw refused(parts_->line, "there is not one patch for each direction");
    for (std::size_t k = 0; k < directions.size(); ++k) {
      a_ = face(bodies_->a, negated(directions[k]));
      b_ = face(bodies_->b, copied(directions[k]));
      check_corners(k);
      check_sides(k);
    }
  }

  /// Of all patches, one after another: points of A, or of B if A is a half-space.
  [[nodiscard]] const std::vector<Combination>& corners() const { return corners_; }

 private:
  Face face(const ScaledBody& body, MutableVector s) {
    Face result;
    result.s = std::move(s);
    if (body.points.empty()) return result;
    find_largest(result.level, scratch_, result.s, body.all_points());
    for (const Vector& p : body.points) {
      dot(product_, result.s, p);
      if (product_ == result.level) result.points.push_back(p);
    }
    return result;
  }

  // Corners.

  void check_corners(std::size_t patch) {
    const std::size_t first = begin_of(parts_->corner_lists, patch), last = parts_->corner_lists[patch].end;
    const bool both = !a_.points.empty() && !b_.points.empty();
    for (std::size_t k = first; k < last; ++k) {
      const auto [end_a, end_b] = parts_->corners.items[k];
      const std::size_t line = parts_->corners.lines[k];
      const Combination p = end_of(a_, bodies_->a, parts_->begin_of(k), end_a, line),
                        q = end_of(b_, bodies_->b, end_a, end_b, line);
      if (both) check_ends(p, q, line);
      corners_.push_back(a_.points.empty() ? q : p);
    }
    std::vector<std::size_t> order(last - first);
    std::iota(order.begin(), order.end(), first);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return compare(i, k) < 0; });
    for (std::size_t k = 1; k < order.size(); ++k)
      if (compare(order[k - 1], order[k]) == 0)
        throw refused(parts_->corners.lines[order[k]], "this corner is where another one is");
  }

  /// The point of the face that these weights say; O of a half-space, which has none.
  Combination end_of(const Face& face, const ScaledBody& body, std::size_t first, std::size_t last, std::size_t line) {
    if (face.points.empty() && first != last) throw refused(line, "weights of a half-space, which has no points");
    if (face.points.empty()) return {};
    const Weight* const weights = parts_->weights.data();
    Combination end = convex_combination(weights + first, weights + last, body.all_points(), line);
    dot(product_, face.s, end.sum);
    if (product_ != face.level * end.den) throw refused(line, "this corner is not in the faces of its direction");
    return end;
  }

  /// <n,n> (q - p) = h(n) n.
  void check_ends(const Combination& p, const Combination& q, std::size_t line) {
    const MutableVector& n = b_.s;
    const mpz_class h = (a_.level + b_.level) * p.den * q.den;
    dot(product_, n, n);
    const auto meet = [&](const mpz_class& from, const mpz_class& to, const mpz_class& entry) {
      return product_ * (to * p.den - from * q.den) == h * entry;
    };
    if (!meet(p.sum.x, q.sum.x, n.x) || !meet(p.sum.y, q.sum.y, n.y) || !meet(p.sum.z, q.sum.z, n.z))
      throw refused(line, "the ends of this corner do not meet");
  }

  /// In lexicographic order.
  int compare(std::size_t i, std::size_t k) {
    const Combination &u = corners_[i], &v = corners_[k];
    const auto entry = [&](const mpz_class& x, const mpz_class& y) {
      product_ = x * v.den;
      scratch_ = y * u.den;
      return cmp(product_, scratch_);
    };
    if (const int x = entry(u.sum.x, v.sum.x)) return x;
    if (const int y = entry(u.sum.y, v.sum.y)) return y;
    return entry(u.sum.z, v.sum.z);
  }

  // Sides.

  void check_sides(std::size_t patch) {
    const std::size_t first_corner = begin_of(parts_->corner_lists, patch),
                      corners = parts_->corner_lists[patch].end - first_corner,
                      first = begin_of(parts_->side_lists, patch), last = parts_->side_lists[patch].end;
    std::vector<bool> named(corners);
    for (std::size_t k = first; k < last; ++k) {
      const PatchParts::Side& side = parts_->sides.items[k];
      if (side.corner >= corners) throw refused(parts_->sides.lines[k], "there is no corner of this number");
      named[side.corner] = true;
    }
    if (first == last) throw refused(parts_->side_lists[patch].line, "a patch without sides");
    for (std::size_t k = 0; k < corners; ++k)
      if (!named[k]) throw refused(parts_->corners.lines[first_corner + k], "no side names this corner");
    for (std::size_t k = first; k < last; ++k) check_side(k, k == first ? last - 1 : k - 1, first_corner);
  }

  /// Of two sides, one after the other: all of the patch is beyond this one, and the corners of
  /// both are on its line.
  void check_side(std::size_t k, std::size_t before, std::size_t first_corner) {
    const PatchParts::Side &side = parts_->sides.items[k], &other = parts_->sides.items[before];
    const Vector& m = side.inward;
    const std::size_t line = parts_->sides.lines[k];
    const Face& face = side.of_b ? b_ : a_;
    if (face.points.empty()) throw refused(line, "a side of a half-space, which has none");
    dot(product_, b_.s, m);
    if (product_ != 0) throw refused(line, "this side is not orthogonal to the direction");
    cross(across_, other.inward, m);
    dot(product_, b_.s, across_);
    if (product_ <= 0) throw refused(line, "this side does not turn to the left of the one before it");
    dot(lowest_, m, face.points.front());
    for (const Vector& p : face.points) {
      dot(product_, m, p);
      if (product_ < lowest_) swap(product_, lowest_);
    }
    for (const std::uint32_t corner : {other.corner, side.corner}) {
      const Combination& p = corners_[first_corner + corner];
      dot(product_, m, p.sum);
      if (product_ != lowest_ * p.den) throw refused(line, "this side passes by corner " + std::to_string(corner));
    }
  }

  const Certificate* c_;
  const PatchParts* parts_;
  const Scaled* bodies_;
  Face a_, b_;  ///< of the direction at hand
  std::vector<Combination> corners_;
  MutableVector across_;
  mpz_class product_, lowest_, scratch_;
};

/// The velocities v + w x p, over a common denominator.
struct Motion {
  MutableVector v, w;
  mpz_class den = 1;
};

Motion motion_of(const PatchParts::Rate& rate) {
  Motion result;
  const Rational* const entries[] = {&rate.v.x, &rate.v.y, &rate.v.z, &rate.w.x, &rate.w.y, &rate.w.z};
  for (const Rational* entry : entries) mpz_lcm(result.den.get_mpz_t(), result.den.get_mpz_t(), entry->den.get_mpz_t());
  const auto whole = [&](const Rational& entry) {
    return mpz_class(entry.num.value() * mpz_class(result.den / entry.den.value()));
  };
  result.v = {whole(rate.v.x), whole(rate.v.y), whole(rate.v.z)};
  result.w = {whole(rate.w.x), whole(rate.w.y), whole(rate.w.z)};
  return result;
}

/// The least, of all directions, of the greatest -<n, v + w x p>/|n| of their corners p, squared
/// with its sign.
mpq_class squared_rate(const Certificate& c, const std::vector<Combination>& corners, const Motion& motion) {
  mpq_class least;
  MutableVector lever;
  mpz_class along, speed, fastest, den_of_fastest;
  const std::vector<List>& lists = c.of_patches.corner_lists;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const Vector& n = c.directions.items[k];
    cross(lever, n, motion.w);  // <n, w x p> = <n x w, p>
    dot(along, n, motion.v);
    along *= c.scale;
    for (std::size_t i = begin_of(lists, k); i < lists[k].end; ++i) {
      const Combination& p = corners[i];
      dot(speed, lever, p.sum);
      speed += along * p.den;
      speed = -speed;  // over p.den and what all corners share
      if (i != begin_of(lists, k) && speed * den_of_fastest <= fastest * p.den) continue;
      swap(fastest, speed);
      den_of_fastest = p.den;
    }
    dot(along, n, n);
    const mpz_class den = den_of_fastest * motion.den * c.scale;
    mpq_class squared(fastest * abs(fastest), den * den * along);
    squared.canonicalize();
    if (k == 0 || squared < least) least = squared;
  }
  return least;
}

void check_rates(const Certificate& c, const std::vector<Combination>& corners) {
  const Part<std::vector<PatchParts::Rate>>& part = c.of_patches.rates;
  if (part.items.empty()) return;
  if (c.claim != Claim::apart && !c.all && !has_half_space(c))
    throw refused(part.line, "a rate needs all optimal directions, which are not proved here");
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const PatchParts::Rate& rate = part.items[k];
    const bool is_one = mpz_cmpabs_ui(rate.sign.get_mpz_t(), 1) <= 0;
    if (!is_one || rate.root.num.sign() != std::abs(rate.sign.sign()))
      throw refused(part.lines[k], "the sign and the root of this rate do not go together");
    if (squared_rate(c, corners, motion_of(rate)) != rate.sign.sign() * value(rate.root))
      throw refused(part.lines[k], "the signed depth grows at another rate than claimed");
  }
}

}  // namespace

void check_patches(const Certificate& certificate, const Scaled& bodies) {
  Patches patches(certificate, bodies);
  patches.check();
  check_rates(certificate, patches.corners());
}

}  // namespace fathom_check
