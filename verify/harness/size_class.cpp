// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/size_class.hpp"

#include <variant>

#include "fathom/shape.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {
namespace {

bool has_usual_size(const Body& body) {
  if (body.shape && std::holds_alternative<HalfSpace>(body.shape->core)) return true;
  const mpq_class longest = body.shape ? judging::sizes_of(*body.shape, *body.shape, judging::usual_bits).extent
                                       : judging::sizes_of(body.points.exact(), body.points.exact()).extent;
  return longest >= mpq_class(1, 100) && longest <= 100;
}

}  // namespace

bool is_solid(const Case& pair) { return !is_flat(files::shape_of(pair.a)) && !is_flat(files::shape_of(pair.b)); }

bool is_metre_sized(const Case& pair) { return has_usual_size(pair.a) && has_usual_size(pair.b); }

}  // namespace fathom::harness
