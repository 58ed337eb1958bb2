// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "verify/study/solid.hpp"

namespace fathom::studies {

void RootSum::add(const mpq_class& factor, const mpq_class& square) {
  if (factor == 0 || square == 0) return;
  for (Part& part : parts_) {
    if (const auto ratio = kernels::rational_root(square / part.square)) {
      part.factor += factor * *ratio;
      return;
    }
  }
  parts_.push_back({square, factor});
}

void RootSum::add(const RootSum& sum, const mpq_class& times) {
  for (const Part& part : sum.parts_) add(times * part.factor, part.square);
}

bool RootSum::is_zero() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.factor == 0; });
}

Vector primitive_along(const RationalVector& v) { return fathom::primitive_along(Point{v.x, v.y, v.z}); }

bool parallel(const RootVector& u, const RootVector& v) {
  const RationalVector rr = cross(u.rational, v.rational), ri = cross(u.rational, v.irrational), ir = cross(u.irrational, v.rational),
                       ii = cross(u.irrational, v.irrational);
  for (const auto axis : {&RationalVector::x, &RationalVector::y, &RationalVector::z}) {
    RootSum component;
    component.add(rr.*axis);
    component.add(ri.*axis, v.square);
    component.add(ir.*axis, u.square);
    component.add(ii.*axis, u.square * v.square);
    if (!component.is_zero()) return false;
  }
  return true;
}

}  // namespace fathom::studies
