// SPDX-License-Identifier: GPL-3.0-or-later
// Format 4: what is proved of contact patches beside the depth. The corners of a patch as points of
// both bodies, and the sides that leave no room for another one.      [verify/check/FORMAT.md, 13]
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fathom/patch.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/patch/patch.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::certificate {
namespace {

/// A face in direction u by its corners, counter-clockwise seen from the tip of n; none of a
/// half-space.
struct OrderedFace {
  std::vector<Point> corners;

  OrderedFace(const std::vector<Point>& body, const Vector& u, const Vector& n) {
    if (body.empty()) return;
    for (const std::uint32_t i : patch::counter_clockwise(n, body, solve::extreme_points(body, u)))
      corners.push_back(body[i]);
  }
};

std::vector<Weight> weights_on(const std::vector<Point>& body, std::vector<std::uint32_t> on, const Vector& n,
                               const Point& p) {
  if (on.empty()) return {};
  if (on.size() > 2) on = patch::counter_clockwise(n, body, on);
  return patch::weights_in(body, on, p);
}

/// The directions in the plane of a face in which it is bounded: inward normals of its edges, of a
/// segment also along it from both ends, of a point four.
std::vector<Vector> inward(const std::vector<Point>& face, const Vector& n) {
  std::vector<Vector> normals;
  for (std::size_t k = 0; face.size() > 1 && k < face.size(); ++k) {
    const Vector along = primitive_along(face[(k + 1) % face.size()] - face[k]);
    normals.push_back(primitive(cross(n, along)));
    if (face.size() == 2) normals.push_back(along);
  }
  if (face.size() != 1) return normals;
  const Vector e = n.x != 0 || n.y != 0 ? Vector{-n.y, n.x, 0} : Vector{1, 0, 0};
  for (const Vector& m : {e, cross(n, e)}) normals.insert(normals.end(), {primitive(m), primitive(-m)});
  return normals;
}

mpq_class least(const std::vector<Point>& points, const Vector& m) {
  mpq_class value = dot(m, points.front());
  for (const Point& p : points) value = std::min(value, dot(m, p));
  return value;
}

/// Before or after, counter-clockwise around n from the direction e.
bool angle_less(const Vector& n, const Vector& e, const Vector& u, const Vector& v) {
  const auto half = [&](const Vector& w) {
    const int side = sgn(det(n, e, w));
    return side > 0 || (side == 0 && dot(e, w) > 0) ? 0 : 1;
  };
  if (half(u) != half(v)) return half(u) < half(v);
  return det(n, u, v) > 0;
}

/// The sides of a patch with these corners on A: in the order of their directions all in which a
/// face is bounded where the patch is, without those that the two beside them make superfluous.
std::vector<PatchSide> sides_of(const std::vector<Point>& on_a, const OrderedFace& a, const OrderedFace& b,
                                const Vector& n) {
  std::vector<PatchSide> sides;
  const auto add = [&](const OrderedFace& face, bool of_b) {
    for (const Vector& m : inward(face.corners, n)) {
      const mpq_class level = least(on_a, m);  // a translation along n does not change it
      const bool known = std::ranges::any_of(sides, [&](const PatchSide& s) { return same_direction(s.inward, m); });
      if (!known && level == least(face.corners, m)) sides.push_back({of_b, m, 0});
    }
  };
  add(a, false);
  add(b, true);
  const Vector first = sides.front().inward;
  std::ranges::sort(sides,
                    [&](const PatchSide& p, const PatchSide& q) { return angle_less(n, first, p.inward, q.inward); });
  const auto after = [&](std::size_t l) { return l + 1 == sides.size() ? 0 : l + 1; };
  for (std::size_t l = 0; l < sides.size(); ++l) {
    const Vector both[] = {sides[l].inward, sides[after(l)].inward};
    const auto corner = std::ranges::find_if(on_a, [&](const Point& p) {
      return dot(both[0], p) == least(on_a, both[0]) && dot(both[1], p) == least(on_a, both[1]);
    });
    if (corner == on_a.end()) contradiction("a patch that its sides do not hold");
    sides[l].corner = static_cast<std::size_t>(corner - on_a.begin());
  }
  for (std::size_t l = 0; sides.size() > 3 && l < sides.size();) {
    const PatchSide &before = sides[l == 0 ? sides.size() - 1 : l - 1], &next = sides[after(l)];
    if (before.corner == sides[l].corner && det(n, before.inward, next.inward) > 0)
      sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(l));
    else ++l;
  }
  return sides;
}

PatchProof prove_patch(const Patch& patch, const std::vector<Point>& a, const std::vector<Point>& b) {
  const Vector& n = patch.direction;
  PatchProof proof;
  std::vector<Point> on_a;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    on_a.push_back(patch.a(k).core);
    proof.corners.push_back({weights_on(a, patch.corners[k].on_a, n, on_a.back()),
                             weights_on(b, patch.corners[k].on_b, n, patch.b(k).core)});
  }
  proof.sides = sides_of(on_a, OrderedFace(a, -n, n), OrderedFace(b, n, n), n);
  return proof;
}

/// None of a half-space.
std::vector<Point> core_points(const Shape& shape) {
  return shapes::is_halfspace(shape) ? std::vector<Point>() : points_of(shape);
}

/// The same answer as about shapes.
SignedDepth as_shapes(const Answer& answer, const ContactGeometry& geometry) {
  if (const SignedDepth* const shapes = std::get_if<SignedDepth>(&answer.found)) return *shapes;
  const Depth& depth = std::get<Depth>(answer.found);
  return {Surd{0, signed_square(depth)}, 0, 0, depth, geometry.cone, {}};
}

}  // namespace

// A half-space shares the whole face of the other body.
void validate_patches(kernels::Report& report, const ShapeCertificate& certificate) {
  const std::vector<Point> a = core_points(certificate.a), b = core_points(certificate.b);
  report.expect(certificate.patches.size() == certificate.directions.size(), "not a patch for each direction");
  for (std::size_t i = 0; i < certificate.patches.size() && report.ok(); ++i) {
    const Vector& n = certificate.directions[i];
    const std::vector<Point>& own = a.empty() ? b : a;
    std::vector<Point> corners, expected;
    for (const auto& [of_a, of_b] : certificate.patches[i].corners)
      corners.push_back(polytope::convex_combination(report, own, a.empty() ? of_b : of_a));
    if (a.empty() || b.empty()) {
      expected = OrderedFace(own, a.empty() ? n : -n, n).corners;
    } else {
      const std::vector<std::uint32_t> in_a = patch::counter_clockwise(n, a, solve::extreme_points(a, -n)),
                                       in_b = patch::counter_clockwise(n, b, solve::extreme_points(b, n));
      const mpq_class height = dot(n, b[in_b[0]] - a[in_a[0]]) / dot(n, n);
      expected = patch::shared_naive(height * n, {n, a, in_a, b, in_b});
    }
    const bool same = std::is_permutation(corners.begin(), corners.end(), expected.begin(), expected.end());
    report.expect(same, "the corners of a patch are others");
  }
}

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Body& a, const Body& b, const Answer& answer, const ContactGeometry& geometry,
                             std::span<const Twist> motions, std::string_view id, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  if (!geometry.tells_smoothness())
    throw std::invalid_argument("patches of unions and of curved bodies have no certificate");
  if (answer.prisms) throw std::invalid_argument("patches of bodies of the plane have no certificate");
  ShapeCertificate proof =
      make_certificate(files::shape_of(a), files::shape_of(b), certificate::as_shapes(answer, geometry), monitor);
  proof.id = id;
  const std::vector<Point> points_a = certificate::core_points(proof.a), points_b = certificate::core_points(proof.b);
  if (geometry.patches.size() != proof.directions.size()) certificate::contradiction("patches of another answer");
  for (const Patch& patch : geometry.patches) {
    if (patch.direction != proof.directions[proof.patches.size()]) certificate::contradiction("another direction");
    proof.patches.push_back(certificate::prove_patch(patch, points_a, points_b));
  }
  const bool one_direction = points_a.empty() || points_b.empty();
  if (geometry.no_first_order || (geometry.cone && !one_direction)) motions = {};
  for (const Twist& motion : motions)
    proof.rates.push_back({motion, std::get<DirectionalDerivative>(directional_derivative(geometry, motion)).value()});
  return certificate_text(proof);
}

}  // namespace fathom
