// SPDX-License-Identifier: GPL-3.0-or-later
// The members of the traits classes, and nothing else: a program that defines them itself, to
// record what is asked, gets by without this.
#include "kernels/predicates/kernels_cgal.hpp"

namespace fathom::kernels {

Sign UnperturbedKernel::side_of_equator(const Direction& n, const Direction& z) const {
  return decide<SideOfEquator>(n, z);
}
Sign PerturbedKernel::side_of_equator(const Direction& n, const Direction& z) const {
  return decide<SideOfEquator>(n, z);
}

Sign UnperturbedKernel::x_order(const Direction& n1, const Direction& n2, const Direction& v) const {
  return decide<XOrder>(n1, n2, v);
}
Sign PerturbedKernel::x_order(const Direction& n1, const Direction& n2, const Direction& v) const {
  return decide<XOrder>(n1, n2, v);
}

Sign UnperturbedKernel::side_of_arc(const Direction& n, const Direction& d) const { return decide<SideOfArc>(n, d); }
Sign PerturbedKernel::side_of_arc(const Direction& n, const Direction& d) const { return decide<SideOfArc>(n, d); }

Sign UnperturbedKernel::order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                          const Direction& v) const {
  return decide<OrderOnVertical>(d1, d2, n, v);
}
Sign PerturbedKernel::order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                        const Direction& v) const {
  return decide<OrderOnVertical>(d1, d2, n, v);
}

Sign UnperturbedKernel::order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const {
  return decide<OrderAtInfinity>(d1, d2, z);
}
Sign PerturbedKernel::order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const {
  return decide<OrderAtInfinity>(d1, d2, z);
}

}  // namespace fathom::kernels
