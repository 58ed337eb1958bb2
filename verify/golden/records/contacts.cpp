// SPDX-License-Identifier: GPL-3.0-or-later
// The additional fields of records of contacts: where the bodies touch, and how the signed depth
// changes. Computed from an answer; and compared with two other computations: of the bodies turned
// and exchanged, and by clipping faces against each other in rationals. [proofs/golden.md]
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/shape.hpp"
#include "kernels/vector.hpp"
#include "reference/files/pose.hpp"
#include "reference/patch/patch.hpp"
#include "reference/shapes/core.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"

namespace fathom::golden {
namespace {

Body of_shape(Shape shape) {
  Body body;
  body.shape = std::move(shape);
  return body;
}

std::pair<Body, Body> bodies_of(const RecordBodies& bodies) {
  if (const auto* const shapes = std::get_if<families::NamedPair>(&bodies))
    return {of_shape(families::shape_of(shapes->a)), of_shape(families::shape_of(shapes->b))};
  const auto& hulls = std::get<HullPair>(bodies);
  return {hulls.a, hulls.b};
}

Body placed(const Pose& frame, const Body& body) {
  if (body.shape) return of_shape(moved(*body.shape, frame));
  std::vector<Point> points;
  for (const Point& p : body.points.exact()) points.push_back(files::placed(p, frame));
  return {std::move(points)};
}

/// Returns the motion in the coordinates of the frame.
Twist placed(const Pose& frame, const Twist& motion) {
  const Point origin = files::placed({}, frame);
  const Point v = files::placed(motion.v, frame) - origin, w = files::placed(motion.w, frame) - origin;
  return {v - cross(w, origin), w};
}

bool same(const std::variant<DirectionalDerivative, LeftOut>& one,
          const std::variant<DirectionalDerivative, LeftOut>& other) {
  const auto *const rate = std::get_if<DirectionalDerivative>(&one), *const other_rate =
                                                                         std::get_if<DirectionalDerivative>(&other);
  if (rate && other_rate) return rate->sign() == other_rate->sign() && rate->root() == other_rate->root();
  return !rate && !other_rate && std::get<LeftOut>(one) == std::get<LeftOut>(other);
}

}  // namespace

std::span<const Twist> recorded_motions() {
  static const std::array<Twist, 3> motions{
      {{{1, 0, 0}, {}}, {{}, {0, 0, 1}}, {{1, mpq_class(-1, 2), 0}, {mpq_class(1, 3), 0, -1}}}};
  return motions;
}

ContactStatement contacts_of(const RecordBodies& bodies, const Options& options) {
  const auto [a, b] = bodies_of(bodies);
  const auto* const hulls = std::get_if<HullPair>(&bodies);
  Answer answer;
  if (hulls) answer.found = penetration_depth(a, b, options);
  else answer.found = answer_about(*a.shape, *b.shape, options);
  ContactFacts contacts{output::manifold_of(a, b, answer, std::nullopt, options.monitor), {}};
  const ContactGeometry& geometry = contacts.manifold.geometry;
  for (const Twist& motion : recorded_motions())
    contacts.derivatives.push_back(directional_derivative(geometry, motion));
  if (!hulls) {
    RecordStatement truth = truth_of(std::get<SignedDepth>(answer.found));
    return {std::move(answer), std::move(truth), std::move(contacts)};
  }
  Depth& depth = std::get<Depth>(answer.found);
  if (const Touch* const touch = depth.touch()) depth.outcome = Touch{geometry.cone->direction(), touch->point};
  RecordStatement truth = truth_of(*hulls, depth, options.monitor);
  return {std::move(answer), std::move(truth), std::move(contacts)};
}

std::string certificate_of(const RecordBodies& bodies, const ContactStatement& found, const std::string& id,
                           Monitor* monitor) {
  const auto [a, b] = bodies_of(bodies);
  return certificate_text(a, b, found.answer, found.contacts.manifold.geometry, recorded_motions(), id, monitor);
}

void insist_on_exchanged(const RecordBodies& bodies, const ContactFacts& contacts, const Pose& frame,
                         const Options& options) {
  const auto [a, b] = bodies_of(bodies);
  const Body first = placed(frame, b), second = placed(frame, a);
  Question question;
  question.options = options;
  const ContactGeometry turned = contact_geometry(first, second, exact_answer(first, second, question));
  const ContactGeometry& geometry = contacts.manifold.geometry;
  std::vector<std::pair<Point, Point>> expected, found;
  for (const Patch& patch : geometry.patches)
    for (std::size_t k = 0; k < patch.corners.size(); ++k)
      expected.emplace_back(files::placed(patch.b(k).core, frame), files::placed(patch.a(k).core, frame));
  for (const Patch& patch : turned.patches)
    for (std::size_t k = 0; k < patch.corners.size(); ++k) found.emplace_back(patch.a(k).core, patch.b(k).core);
  if (!std::is_permutation(expected.begin(), expected.end(), found.begin(), found.end()) ||
      geometry.kinks != turned.kinks)
    throw NotProved("expected.manifold.patches: the bodies, turned and exchanged, have others");
  for (std::size_t i = 0; i < contacts.derivatives.size(); ++i) {
    const Twist motion = placed(frame, recorded_motions()[i]);
    if (!same(contacts.derivatives[i], directional_derivative(turned, {}, motion)))
      throw NotProved("expected.derivatives: the bodies, turned and exchanged, have others");
  }
}

void insist_on_clipped(const RecordBodies& bodies, const ContactFacts& contacts) {
  const auto [body_a, body_b] = bodies_of(bodies);
  const patch::CorePoints core_a(body_a), core_b(body_b);
  if (!core_a.known() || !core_b.known()) return;  // a half-space shares whole faces
  const std::vector<Point>&a = core_a.exact(), &b = core_b.exact();
  const Integers integers = integers_of(a, b);
  for (const Patch& patch : contacts.manifold.geometry.patches) {
    const Vector& n = patch.direction;
    const SupportingFace of_a = face_in_direction(integers.a, -n), of_b = face_in_direction(integers.b, n);
    const std::vector<Point> expected = patch::shared_naive(patch.translation(), {n, a, of_a.corners, b, of_b.corners});
    std::vector<Point> corners;
    for (std::size_t k = 0; k < patch.corners.size(); ++k) corners.push_back(patch.a(k).core);
    if (!std::is_permutation(corners.begin(), corners.end(), expected.begin(), expected.end()))
      throw NotProved("expected.manifold.patches: clipped in rationals, the faces share others");
  }
}

void insist_on_cone(const ContactGeometry& geometry, const std::optional<OptimalCone>& proved) {
  if (geometry.cone != proved) throw NotProved("expected.manifold: the certificate proves another cone");
}

}  // namespace fathom::golden
