// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twins of the predicates: the formulas once more, over Vec3 of any ring, without a
// kernel.
#pragma once

#include "kernels/vector.hpp"

namespace fathom::testing::plain {

struct SideOfEquator {
  template <class NT>
  NT operator()(const Vec3<NT>& n, const Vec3<NT>& z) const {
    return dot(n, z);
  }
};

struct XOrder {
  template <class NT>
  NT operator()(const Vec3<NT>& n1, const Vec3<NT>& n2, const Vec3<NT>& v) const {
    return det(n1, n2, v);
  }
};

struct SideOfArc {
  template <class NT>
  NT operator()(const Vec3<NT>& n, const Vec3<NT>& d) const {
    return dot(n, d);
  }
};

struct OrderOnVertical {
  template <class NT>
  NT operator()(const Vec3<NT>& d1, const Vec3<NT>& d2, const Vec3<NT>& n, const Vec3<NT>& v) const {
    return det(d1, d2, cross(v, n));
  }
};

struct OrderAtInfinity {
  template <class NT>
  NT operator()(const Vec3<NT>& d1, const Vec3<NT>& d2, const Vec3<NT>& z) const {
    return det(d1, d2, z);
  }
};

}  // namespace fathom::testing::plain
