// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of shapes; of fathom/shape.hpp.
#include <stdexcept>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/pose.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::shapes {
namespace {

using Row = std::array<mpq_class, 4>;

// Of rows i and j, without the translations.
Point cross_product(const Row& u, const Row& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

void require_numbers(const Pose& pose) {
  for (const Row& row : pose)
    for (const mpq_class& x : row) kernels::require_lowest_terms(x);
}

// The transpose of the inverse matrix, which maps normals of planes. Its rows are cross products over the determinant.
Pose normal_map(const Pose& pose) {
  const Point x = cross_product(pose[1], pose[2]), y = cross_product(pose[2], pose[0]), z = cross_product(pose[0], pose[1]);
  const mpq_class determinant = pose[0][0] * x.x + pose[0][1] * x.y + pose[0][2] * x.z;
  if (determinant == 0) throw std::invalid_argument("the matrix of a pose is singular");
  const auto row = [&](const Point& p) { return Row{p.x / determinant, p.y / determinant, p.z / determinant, 0}; };
  return {row(x), row(y), row(z)};
}

HalfSpace moved_core(const HalfSpace& half, const Pose& pose) {
  const Point n = files::placed(half.normal, normal_map(pose));
  return {n, half.offset + n.x * pose[0][3] + n.y * pose[1][3] + n.z * pose[2][3]};
}

std::vector<Term> moved_core(std::vector<Term> terms, const Pose& pose) {
  Pose linear = pose;
  for (Row& row : linear) row[3] = 0;
  // The sum of the terms moves once.
  const Pose* of_points = &pose;
  for (Term& term : terms) {
    for (Atom& atom : term.atoms) {
      atom.center = files::placed(atom.center, *of_points);
      for (Point& axis : atom.axes) axis = files::placed(axis, linear);
    }
    of_points = &linear;
  }
  return terms;
}

}  // namespace

}  // namespace fathom::shapes

namespace fathom {

Pose rigid_pose(const Quaternion& rotation, const Point& translation) {
  const auto& [w, x, y, z] = rotation;
  for (const mpq_class* number : {&w, &x, &y, &z, &translation.x, &translation.y, &translation.z}) kernels::require_lowest_terms(*number);
  const mpq_class square = w * w + x * x + y * y + z * z;
  if (square == 0) throw std::invalid_argument("the quaternion of a pose is 0");
  const mpq_class s = 2 / square;
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), translation.x},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), translation.y},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), translation.z}}};
}

Shape moved(const Shape& shape, const Pose& pose) {
  shapes::require_shape(shape);
  shapes::require_numbers(pose);
  shapes::normal_map(pose);  // throws if the matrix is singular
  return std::visit([&](const auto& core) { return Shape{shapes::moved_core(core, pose), shape.radius}; }, shape.core);
}

}  // namespace fathom
