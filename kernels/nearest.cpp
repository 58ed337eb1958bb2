// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/nearest.hpp"

namespace fathom {

bool NearestPlanes::offer(const Vector& normal, const mpz_class& height) {
  if (height <= 0) return false;
  mpz_class numerator = height * height;
  mpz_class denominator = dot(normal, normal);
  const int order = empty() ? -1 : cmp(mpz_class(numerator * denominator_), mpz_class(numerator_ * denominator));
  if (order > 0) return false;
  if (order < 0) {
    directions_.clear();
    numerator_ = std::move(numerator);
    denominator_ = std::move(denominator);
  }
  directions_.insert(primitive(normal));
  return true;
}

}  // namespace fathom
