// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as numbers of the subject's format: exact.
#pragma once

#include <gmpxx.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::harness {

using judging::scaled;

/// floor(log2 |value|); the value must not be 0.
long exponent_of(const mpq_class& value);

/// The largest e for which value is a multiple of 2^e; the value must be a binary fraction, and not
/// 0.
long lowest_bit(const mpq_class& value);

/// Rounds a length to the nearest one that is a number of the format's points in its unit; returns
/// nullopt if it overflows.
std::optional<mpq_class> rounded(const mpq_class& value, const NumberFormat& format);

/// Whether a length is a finite number of the format's points in its unit.
bool representable(const mpq_class& value, const NumberFormat& format);

/// The words with each number rounded: parameters, margins, poses. Turns, matrices and normals have
/// no unit. A margin that is 0 is left out, and so is "rounded_". Returns nullopt if a number
/// overflows.
std::optional<files::NamedBody> rounded(files::NamedBody words, const NumberFormat& format);

/// Applies use(mpq_class&) to each length of a named body: radii, margins, points, offsets, the
/// place; not to normals and turns.
void for_each_length(files::NamedBody& words, const std::function<void(mpq_class&)>& use);

/// The number that says where a named body is along x, y or z: 0, 1 or 2.
mpq_class& place_along(files::NamedBody& words, std::size_t axis);

/// Applies change(std::vector<Point>&) to the points of a body without words; to those of each
/// piece of a union.
template <class Change>
void for_each_hull(Body& body, Change change) {
  if (!body.pieces) return change(body.points.edit());
  Pieces pieces = *body.pieces;
  for (std::vector<Point>& piece : pieces) change(piece);
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
}
template <class Look>
void for_each_hull(const Body& body, Look look) {
  if (!body.pieces) return look(body.points.exact());
  for (const std::vector<Point>& piece : *body.pieces) look(piece);
}

/// Applies change(mpq_class&) to every coordinate of both bodies; to the lengths of a body that has
/// words, which must stay a body.
template <class Change>
void for_each_coordinate(Case& pair, Change change) {
  for (Body* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      for_each_length(words, change);
      *body = files::body_of(std::move(words));
      continue;
    }
    for_each_hull(*body, [&](std::vector<Point>& points) {
      for (Point& p : points)
        for (mpq_class* value : {&p.x, &p.y, &p.z}) change(*value);
    });
  }
}
template <class Look>
void for_each_coordinate(const Case& pair, Look look) {
  for (const Body* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      for_each_length(words, look);
      continue;
    }
    for_each_hull(*body, [&](const std::vector<Point>& points) {
      for (const Point& p : points)
        for (const mpq_class* value : {&p.x, &p.y, &p.z}) look(*value);
    });
  }
}

/// Applies change(mpq_class&) to every coordinate as above, and to the slopes of bodies that have
/// words. Throws std::invalid_argument where what comes out is no body.
void for_each_number(Case& pair, const std::function<void(mpq_class&)>& change);
void for_each_number(const Case& pair, const std::function<void(const mpq_class&)>& look);

/// The case with all lengths times 2^exponent. A shape must have words.
Case in_unit(Case pair, long exponent);
/// The answer with all lengths times 2^exponent, each rounded to nearest. Directions have no unit.
Reply in_unit(Reply reply, long exponent);
/// The format of a subject that sees lengths times 2^exponent.
inline NumberFormat in_unit(const NumberFormat& format, long exponent) {
  return {format.points, format.answers, exponent};
}

/// The largest |coordinate|; 0 if all are 0.
mpq_class largest_coordinate(const Case& pair);

}  // namespace fathom::harness
