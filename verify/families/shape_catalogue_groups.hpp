// SPDX-License-Identifier: GPL-3.0-or-later
// How the catalogue of shapes is put together. Not a door: the door is shape_catalogue.hpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verify/families/catalogue.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

inline ShapeCatalogueEntry shapes(std::string name, std::string_view description, Surd signed_depth, NamedBody a, NamedBody b) {
  return {description, {std::move(name), {std::move(a), std::move(b), KnownDepth{std::move(signed_depth)}}}};
}

inline Surd rational(mpq_class value) { return {std::move(value), 0}; }

inline NamedBody ball(const mpq_class& radius) { return named("sphere", {{"radius", {radius}}}); }
inline NamedBody block_of(const mpq_class& x, const mpq_class& y, const mpq_class& z) { return named("box", {{"half", {x, y, z}}}); }
inline NamedBody ellipsoid_of(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return named("ellipsoid", {{"radii", {x, y, z}}});
}
inline NamedBody of_lengths(const char* shape, const mpq_class& radius, const mpq_class& half_length, Axis axis = Axis::z) {
  return named(shape, {{"radius", {radius}}, {"half_length", {half_length}}}, axis);
}
inline NamedBody of_ends(const char* shape, const mpq_class& low, const mpq_class& high, const mpq_class& half_length) {
  return named(shape, {{"radius_low", {low}}, {"radius_high", {high}}, {"half_length", {half_length}}});
}
/// All that is not above z = 0.
inline NamedBody ground() {
  return named("halfspace", {{"normal", {mpq_class(0), mpq_class(0), mpq_class(1)}}, {"offset", {mpq_class(0)}}});
}
inline NamedBody at(NamedBody body, const Point& place) { return posed(std::move(body), {1, 0, 0, 0}, place); }
inline NamedBody upside_down(NamedBody body) { return posed(std::move(body), {0, 1, 0, 0}, {}); }

/// The binary64 numbers next to 2.
inline mpq_class above_two() { return 2 + times_power_of_two(1, -51); }
inline mpq_class below_two() { return 2 - times_power_of_two(1, -52); }

using ShapeEntries = std::vector<ShapeCatalogueEntry>;
ShapeEntries ball_entries();
ShapeEntries capsule_entries();
ShapeEntries cylinder_entries();
ShapeEntries cone_entries();
ShapeEntries other_entries();

}  // namespace fathom::families
