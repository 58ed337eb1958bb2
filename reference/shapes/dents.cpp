// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/shapes/dents.hpp"

#include <fmt/format.h>

#include "fathom/numbers.hpp"

namespace fathom::shapes {
namespace {

constexpr double shown_as_excess = 0.005;  // "1 + 2e-16 times": three digits would show 1

std::string volume_text(const mpq_class& ratio) {
  const double excess = round_binary64(mpq_class(ratio - 1));
  if (excess < shown_as_excess) return fmt::format("the hull holds 1 + {:.2g} times its volume", excess);
  return fmt::format("the hull holds {:.3g} times its volume", round_binary64(ratio));
}

}  // namespace

std::string dents_of(std::string_view body, const polytope::Dents& dents) {
  std::string text = fmt::format("{} is not convex: {}", body,
                                 dents.volume_ratio ? volume_text(*dents.volume_ratio) : std::string("its faces are not closed"));
  if (!dents.deepest) return text;
  if (dents.deepest->squared_depth == 0) return text + ", all its points are on the hull";
  return text + fmt::format(", its deepest point is {:.3g} inside", root_binary64(dents.deepest->squared_depth));
}

}  // namespace fathom::shapes
