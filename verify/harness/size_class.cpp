// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/size_class.hpp"

#include <variant>

#include "fathom/shape.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {
namespace {

mpq_class extent_of(const Body& body) {
  if (body.pieces) return judging::sizes_of(*body.pieces, *body.pieces).extent;
  if (body.shape) return judging::sizes_of(*body.shape, *body.shape, judging::usual_bits).extent;
  return judging::sizes_of(body.points.exact(), body.points.exact()).extent;
}

bool has_usual_size(const Body& body) {
  if (body.shape && std::holds_alternative<HalfSpace>(body.shape->core)) return true;
  const mpq_class longest = extent_of(body);
  return longest >= mpq_class(1, 100) && longest <= 100;
}

}  // namespace

bool is_solid(const Case& pair) {
  const auto is_flat = [](const Body& body) { return !body.pieces && fathom::is_flat(files::shape_of(body)); };  // pieces have interiors
  return !is_flat(pair.a) && !is_flat(pair.b);
}

bool is_dwarfed_by(const mpq_class& length, const Case& pair) { return length > 0 && length > sizes_of(pair).extent; }

bool is_metre_sized(const Case& pair) { return has_usual_size(pair.a) && has_usual_size(pair.b); }

}  // namespace fathom::harness
