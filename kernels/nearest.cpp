// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/nearest.hpp"

#include "kernels/predicates/kernels_cgal.hpp"
#include "kernels/predicates/predicates_cgal.hpp"

namespace fathom::kernels {

Sign NearestPlanes::compare(const Vector& normal, const mpz_class& height) const {
  return sign_of(CompareDistance<ExactKernel>{}(to_cgal<ExactKernel>(normal), height, numerator_, denominator_));
}

bool NearestPlanes::offer(const Vector& normal, const mpz_class& height) {
  if (height <= 0) return false;
  const Sign order = empty() ? Sign::negative : compare(normal, height);
  if (order == Sign::positive) return false;
  if (order == Sign::negative) {
    directions_.clear();
    numerator_ = height * height;
    denominator_ = dot(normal, normal);
  }
  directions_.insert(primitive(normal));
  return true;
}

bool NearestPlanes::nearer_than(const Vector& normal, const mpz_class& height) const {
  return !empty() && height > 0 && compare(normal, height) == Sign::positive;
}

}  // namespace fathom::kernels
