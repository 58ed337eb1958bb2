// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as numbers of the subject's format: exact.
#pragma once

#include <gmpxx.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::harness {

using judging::scaled;

inline constexpr std::array axes = {&Point::x, &Point::y, &Point::z};

/// floor(log2 |value|); the value must not be 0.
long exponent_of(const mpq_class& value);

/// The largest e for which value is a multiple of 2^e; the value must be a binary fraction, and not
/// 0.
long lowest_bit(const mpq_class& value);

/// Rounds a length to the nearest one that is a number of the format's points in its unit; returns
/// nullopt if it overflows.
std::optional<mpq_class> rounded(const mpq_class& value, const NumberFormat& format);

/// Returns the motion with each number rounded: velocities are lengths. Returns nullopt if one
/// overflows.
std::optional<Motion> rounded(Motion motion, const NumberFormat& format);

/// Whether a length is a finite number of the format's points in its unit.
bool representable(const mpq_class& value, const NumberFormat& format);

/// Returns the description with each number rounded: parameters, margins, poses. Turns, matrices
/// and normals have no unit. Omits a margin of 0, and the prefix "rounded_". Returns nullopt if a
/// number overflows.
std::optional<files::NamedBody> rounded(files::NamedBody words, const NumberFormat& format);

/// Applies use(mpq_class&) to each length of a named body: radii, margins, points, offsets, the
/// place; not to normals and turns.
void for_each_length(files::NamedBody& words, const std::function<void(mpq_class&)>& use);

/// Applies use(mpq_class&) to each number that is no length: turns, matrices, normals.
void for_each_slope(files::NamedBody& words, const std::function<void(mpq_class&)>& use);

/// Returns the number for the position of a named body along x, y or z: 0, 1 or 2.
mpq_class& place_along(files::NamedBody& words, std::size_t axis);

/// Returns the points of the core of a shape of the plane; none of a half-plane.
std::vector<Point> core_of(const Body& body);

/// Applies change(std::vector<Point>&) to the points of a body without words; to those of each
/// piece of a union, and of the core of a shape of the plane.
template <class Change>
void for_each_hull(Body& body, Change change) {
  if (body.shape && body.dimension == 2) {
    std::vector<Point> core = core_of(body);
    change(core);
    body.shape->core = hull(core).core;
    return;
  }
  if (!body.pieces) return change(body.points.edit());
  Pieces pieces = *body.pieces;
  for (std::vector<Point>& piece : pieces) change(piece);
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  body.solid = nullptr;  // its pieces are others now
}
using answer::for_each_hull;

/// Calls visit(mpq_class&) for every coordinate of both bodies; for a body with a description, for
/// its lengths, and for its slopes too, if `visit` is to have them. Changes by `visit` are made in
/// `pair`, unless it is const. Throws std::invalid_argument if the changed description is no body.
template <class Pair, class Visit>
void for_each_coordinate(Pair& pair, Visit visit, bool with_slopes = false) {
  for (auto* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      for_each_length(words, visit);
      if (with_slopes) for_each_slope(words, visit);
      if constexpr (!std::is_const_v<Pair>) *body = files::body_of(std::move(words));
      continue;
    }
    for_each_hull(*body, [&](auto& points) {
      for (auto& p : points)
        for (auto* value : {&p.x, &p.y, &p.z}) visit(*value);
    });
  }
}

/// Does the same for all numbers: lengths and slopes.
template <class Pair, class Visit>
void for_each_number(Pair& pair, Visit visit) {
  for_each_coordinate(pair, visit, true);
}

/// Returns the case with all lengths times 2^exponent. A shape must have a description.
Case in_unit(Case pair, long exponent);
/// Returns the answer with all lengths times 2^exponent, each rounded to nearest. Directions have
/// no unit.
Reply in_unit(Reply reply, long exponent);
/// Returns the format of a subject that gets lengths times 2^exponent.
inline NumberFormat in_unit(const NumberFormat& format, long exponent) {
  return {format.points, format.answers, exponent};
}

/// The largest |coordinate|; 0 if all are 0.
mpq_class largest_coordinate(const Case& pair);

}  // namespace fathom::harness
