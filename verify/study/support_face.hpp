// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a sum of terms, and a direction.
// Output  the face of the sum in that direction, the set of its points that are farthest there: its dimension, and what it is.
#pragma once

#include <span>
#include <vector>

#include "fathom/shape.hpp"
#include "verify/study/solid.hpp"

namespace fathom::studies {

/// What the atoms of a face of dimension 0 are; the later one wins in a sum.
enum class Corner { vertex, apex, rim, smooth };

struct SupportFace {
  RootSum height;                    ///< the support: the greatest <n,x>
  std::vector<RootVector> spanning;  ///< independent vectors of differences of its points: as many as its dimension, at most two
  Corner corner = Corner::vertex;    ///< of dimension 0: what it is
  bool of_points = true;             ///< only atoms that are points reach it
};

/// `direction` is not 0; every term has an atom.
SupportFace support_face(std::span<const Term> terms, const Vector& direction);

}  // namespace fathom::studies
