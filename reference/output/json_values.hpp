// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of JSON results: numbers, places, contacts, and what they tell of the bodies. Exact
// numbers are strings.
#pragma once

#include <gmpxx.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/solid.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/text/json.hpp"

namespace fathom::output {

using text::Json;
using text::JsonStream;

// ---- rational numbers ----

Json exact(const mpq_class& q);
// `dimension`: 2 in the plane, where the third coordinate, which is 0, is left out.
Json exact(const Point& p, unsigned dimension = 3);
Json exact(const Vector& v, unsigned dimension = 3);
/// [[index, "weight"], ...]
Json weights_array(const std::vector<Weight>& weights);
/// An angular velocity: in the plane one number.
Json turn_object(const Point& w, unsigned dimension);

/// A length by its exact square, with roundings, and an enclosure if digits are given.
Json length(const mpq_class& squared, const std::optional<unsigned>& digits);
Json length(const mpq_class& squared, const kernels::Roundings& rounded, const std::optional<unsigned>& digits);
/// A rational number, exact and rounded.
Json number(const mpq_class& value);

// ---- signed depths, and what goes along their directions: rational but for one root ----

/// A length: value >= 0. Its exact square is null if that is irrational.
Json surd_length(const Surd& value, const std::optional<unsigned>& digits);

/// {"sign", "root", "plus"}.
Json exact_object(const Surd& value);

/// Doubles on both sides of a signed depth: positive if the bodies penetrate, negative if they are
/// apart. Equal if it is that double.
struct SignedDepthBounds {
  double low, high;
};

/// Of bodies that penetrate with this depth, or are this far apart.
SignedDepthBounds penetrating_by(const kernels::Roundings& depth);
SignedDepthBounds apart_by(const kernels::Roundings& distance);

/// The field "signed_depth": of bounds it has no exact form, and a bound that is infinite becomes
/// null.
Json signed_depth_object(const SignedDepthBounds& bounds);
Json signed_depth_object(const SignedDepth& depth);

/// A point as three rationals if it is rational; else {"normal", "alpha", "beta"}, and {"core",
/// "normal", "distance"}.
Json vector_object(const AlongNormal& vector, unsigned dimension = 3);
Json point_object(const RoundedPoint& point, unsigned dimension = 3);

// ---- the same in binary64 ----

// Null of what there is not, and of what is beyond all finite numbers.

Json numbers(const std::array<double, 3>& values, unsigned dimension = 3);
Json unit_f64(const Vector& direction, unsigned dimension = 3);
template <class Translation>
Json translation_f64(const std::optional<Translation>& translation, unsigned dimension = 3) {
  return translation ? numbers(rounded::nearest_binary64(*translation), dimension) : Json();
}
template <class SomeWitness>
Json witness_f64(const std::optional<SomeWitness>& witness, unsigned dimension = 3) {
  if (!witness) return {};
  return {{"a", numbers(rounded::nearest_binary64(witness->a), dimension)},
          {"b", numbers(rounded::nearest_binary64(witness->b), dimension)}};
}

// ---- contacts and bodies ----

Json contact_object(const Contact& contact);
Json witness_object(const Witness& witness, unsigned dimension = 3);
Json flat_array(const BodyFacts& facts);

/// The fields of the bodies that every result has, whatever was asked about them.
struct AboutBodies {
  shapes::BodySizes sizes;
  shapes::HullFacts hull;
  std::shared_ptr<const Solid> solid_a = nullptr, solid_b = nullptr;  ///< of bodies that are solids of meshes
};

AboutBodies about_bodies(const Case& input, bool one_body);

Json sizes_object(const shapes::BodySizes& sizes);
/// Of bodies that are meshes with faces, or have such pieces.
std::optional<Json> hull_object(const shapes::HullFacts& facts);
/// Of bodies that are solids of meshes.
std::optional<Json> solids_object(const AboutBodies& bodies);
/// What its mesh has that people may not expect, and into how many pieces it was cut.
Json solid_object(const Solid& solid);

// ---- no result ----

/// Returns the line for a case of a stream that has no result.
std::string error_object(std::string_view schema, const std::string& id, std::size_t line, std::string_view error);

}  // namespace fathom::output
