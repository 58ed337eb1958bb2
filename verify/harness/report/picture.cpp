// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>

#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/report/html.hpp"
#include "verify/judge/claim.hpp"
#include "view/picture/paint.hpp"
#include "view/picture/view.hpp"

namespace fathom::harness {

std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions) {
  const judging::Claim claim = judging::exact_claim(reply, conventions);
  if (!claim.overlap || !claim.length || !claim.direction) return std::nullopt;
  const Vec3<double> u = picture::unit_vector(rational(*claim.direction));
  return Point{mpq_class(exact_value(u.x) * *claim.length), mpq_class(exact_value(u.y) * *claim.length),
               mpq_class(exact_value(u.z) * *claim.length)};
}

std::string pair_picture(const Truth& truth, const std::optional<Point>& claimed, const std::string& name, const std::string& label) {
  return picture::scene_panels(picture::scene_of({truth.a, truth.b, truth.depth}, claimed), name, label);
}

std::string unions_picture(const UnionTruth& truth, const std::optional<Point>& claimed, const std::string& name,
                           const std::string& label) {
  return picture::scene_panels(picture::scene_of(truth.a, truth.b, truth.depth, 0, claimed), name, label);
}

std::string shapes_picture(const Case& seen, const std::string& name, const std::string& label) {
  if (!seen.a.shape && !seen.b.shape) return "";
  try {
    const Shape a = files::shape_of(seen.a), b = files::shape_of(seen.b);
    return picture::scene_panels(picture::scene_of(a, b, signed_depth(a, b)), name, label);
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace fathom::harness
