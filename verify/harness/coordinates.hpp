// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as numbers of the subject's precision: exact.
#pragma once

#include <gmpxx.h>

#include <functional>
#include <optional>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"
#include "reference/files/named_body.hpp"

namespace fathom::harness {

/// value * 2^exponent.
mpq_class scaled(const mpq_class& value, long exponent);

/// floor(log2 |value|); the value must not be 0.
long exponent_of(const mpq_class& value);

/// The largest e for which value is a multiple of 2^e; the value must be a binary fraction, and not 0.
long lowest_bit(const mpq_class& value);

/// Rounds `value` to the nearest number of the precision; returns nullopt if it overflows.
std::optional<mpq_class> rounded(const mpq_class& value, Precision precision);

/// Whether `value` is a finite number of the precision.
bool representable(const mpq_class& value, Precision precision);

/// The words with each number rounded: parameters, margins, poses. A margin that is 0 is left out, and so is "rounded_". Returns nullopt if a
/// number overflows.
std::optional<files::NamedBody> rounded(files::NamedBody words, Precision precision);

/// Applies use(mpq_class&) to each length of a named body: radii, margins, points, offsets, the place; not to normals and turns.
void for_each_length(files::NamedBody& words, const std::function<void(mpq_class&)>& use);

/// The number that says where a named body is along x, y or z: 0, 1 or 2.
mpq_class& place_along(files::NamedBody& words, std::size_t axis);

/// Applies change(mpq_class&) to every coordinate of both bodies; to the lengths of a body that has words, which must stay a body.
template <class Change>
void for_each_coordinate(Case& pair, Change change) {
  for (Body* body : {&pair.a, &pair.b}) {
    if (body->words) {
      files::NamedBody words = *body->words;
      for_each_length(words, change);
      *body = files::body_of(std::move(words));
      continue;
    }
    for (Point& p : body->points.edit())
      for (mpq_class* value : {&p.x, &p.y, &p.z}) change(*value);
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
    for (const Point& p : body->points)
      for (const mpq_class* value : {&p.x, &p.y, &p.z}) look(*value);
  }
}

/// The largest |coordinate|; 0 if all are 0.
mpq_class largest_coordinate(const Case& pair);

}  // namespace fathom::harness
