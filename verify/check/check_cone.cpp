// SPDX-License-Identifier: Apache-2.0
// The set of all vectors u with h(u) = 0: the sums of multiples of the lineality and of multiples
// >= 0 of the rays.
#include <algorithm>
#include <array>
#include <set>

#include "checks.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

class Cone {
 public:
  Cone(const Certificate& certificate, const Scaled& bodies)
      : c_(&certificate), bodies_(&bodies), lines_(&certificate.lineality.items), rays_(&certificate.rays.items) {}

  void check() {
    check_lineality();
    check_rays();
    make_differences();
    rays_->size() >= few ? check_sides() : check_few_rays();
  }

 private:
  static constexpr std::size_t few = 3;

  /// A difference, which of the rays are orthogonal to it, the first ones at least, and how many
  /// they are.
  struct Difference {
    MutableVector d;
    std::array<std::size_t, 2> zeros{};
    std::size_t count = 0;
  };

  void check_lineality() {
    const Part<std::vector<Vector>>& part = c_->lineality;
    const std::vector<Vector>& l = *lines_;
    bool independent = l.size() <= 3;
    if (independent && l.size() == 1) independent = !is_zero(l[0]);
    if (independent && l.size() >= 2) {
      cross(across_, l[0], l[1]);
      independent = !is_zero(across_);
    }
    if (independent && l.size() == 3) {
      dot(product_, across_, l[2]);
      independent = product_ != 0;
    }
    if (!independent) throw refused(part.line, "the vectors of the lineality are not independent");
    for (std::size_t k = 0; k < l.size(); ++k) {
      require_zero(copied(l[k]), negated(l[k]), part.lines[k]);
      require_zero(negated(l[k]), copied(l[k]), part.lines[k]);
    }
  }

  /// h(u) = 0.
  void require_zero(const MutableVector& u, const MutableVector& minus_u, std::size_t line) {
    find_largest(product_, scratch_, u, bodies_->b.all_points());
    find_largest(other_, scratch_, minus_u, bodies_->a.all_points());
    if (product_ + other_ != 0) throw refused(line, "this vector does not belong to the cone");
  }

  void check_rays() {
    const Part<std::vector<Vector>>& part = c_->rays;
    if (lines_->size() + rays_->size() == 0) throw refused(part.line, "a cone of touching bodies is not empty");
    for (std::size_t k = 0; k < rays_->size(); ++k) {
      const Vector& ray = (*rays_)[k];
      find_gcd(product_, ray);
      if (product_ != 1) throw refused(part.lines[k], "a ray is primitive: this one is not");
      if (k > 0 && !ascending((*rays_)[k - 1], ray))
        throw refused(part.lines[k], "each ray must be above the one before it");
      for (const Vector& l : *lines_) {
        dot(product_, ray, l);
        if (product_ != 0) throw refused(part.lines[k], "this ray is not orthogonal to the lineality");
      }
      require_zero(copied(ray), negated(ray), part.lines[k]);
    }
  }

  void make_differences() {
    const Part<std::vector<Pair>>& part = c_->differences;
    const std::vector<Vector>&a = bodies_->a.points, &b = bodies_->b.points;
    for (std::size_t k = 0; k < part.items.size(); ++k) {
      const auto [j, i] = part.items[k];
      if (j >= b.size()) throw refused(part.lines[k], "b has no point of this number");
      if (i >= a.size()) throw refused(part.lines[k], "a has no point of this number");
      Difference difference;
      subtract(difference.d, b[j], a[i]);
      for (std::size_t r = 0; r < rays_->size(); ++r) {
        dot(product_, difference.d, (*rays_)[r]);
        if (product_ != 0) continue;
        if (difference.count < difference.zeros.size()) difference.zeros[difference.count] = r;
        ++difference.count;
      }
      differences_.push_back(std::move(difference));
    }
  }

  /// Three rays or more: each difference is the normal of the side between two of them.
  void check_sides() {
    std::set<std::array<std::size_t, 2>> sides;
    for (std::size_t k = 0; k < differences_.size(); ++k) {
      if (differences_[k].count != 2)
        throw refused(c_->differences.lines[k], "this difference is not orthogonal to exactly two rays");
      sides.insert(differences_[k].zeros);
    }
    std::vector<std::size_t> ends(rays_->size());
    for (const auto& [r, s] : sides) ++ends[r], ++ends[s];
    for (std::size_t r = 0; r < ends.size(); ++r)
      if (ends[r] < 2) throw refused(c_->rays.lines[r], "this ray is not the end of two sides");
  }

  void check_few_rays() {
    const std::size_t rays = rays_->size(), vectors = lines_->size() + rays, line = c_->differences.line;
    if (vectors > 3) throw refused(c_->rays.line, "more vectors than dimensions");
    if (rays == 2) {
      cross(across_, rays_->front(), rays_->back());
      if (is_zero(across_)) throw refused(c_->rays.line, "the two rays are opposite");
    }
    for (std::size_t r = 0; r < rays; ++r) {
      // Orthogonal to the other ray if there is one, and not to this one.
      const auto ends_ray = [&](const Difference& d) {
        return d.count == rays - 1 && (d.count == 0 || d.zeros[0] != r);
      };
      if (std::none_of(differences_.begin(), differences_.end(), ends_ray))
        throw refused(line, "the cone may go on behind ray " + std::to_string(r));
    }
    std::vector<const MutableVector*> flat;
    for (const Difference& difference : differences_)
      if (difference.count == rays) flat.push_back(&difference.d);
    const bool narrow = vectors == 3 || (vectors == 2 ? spans_line(flat) : spans_plane(flat));
    if (!narrow) throw refused(line, "the cone may be wider");
  }

  bool spans_line(const std::vector<const MutableVector*>& flat) {
    for (const MutableVector* d : flat)
      for (const MutableVector* e : flat) {
        dot(product_, *d, *e);
        if (product_ < 0) return true;
      }
    return false;
  }

  /// Whether each has another one to its left, seen along the vector that is listed.
  bool spans_plane(const std::vector<const MutableVector*>& flat) {
    const Vector& p = lines_->empty() ? rays_->front() : lines_->front();
    const auto has_left = [&](const MutableVector* d) {
      return std::any_of(flat.begin(), flat.end(), [&](const MutableVector* e) {
        cross(across_, *d, *e);
        dot(product_, across_, p);
        return product_ > 0;
      });
    };
    return !flat.empty() && std::all_of(flat.begin(), flat.end(), has_left);
  }

  const Certificate* c_;
  const Scaled* bodies_;
  const std::vector<Vector>*lines_, *rays_;
  std::vector<Difference> differences_;
  MutableVector across_;
  mpz_class product_, other_, scratch_;
};

}  // namespace

void check_cone(const Certificate& certificate, const Scaled& bodies) { Cone(certificate, bodies).check(); }

}  // namespace fathom_check
