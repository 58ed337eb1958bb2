// SPDX-License-Identifier: GPL-3.0-or-later
// What people are to hear of the bodies before they read an answer: how large they are, and whether
// the meshes are the hulls that stand for them. A millimetre that was taken for a metre shows
// there, and so does the hole of a torus.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/polytope/convexity.hpp"

namespace fathom::shapes {

/// The lengths of a body's box along x, y and z, rounded to the nearest binary64, infinity
/// included; of bodies with discs or balls, upper bounds that are off by a few units in the last
/// place at most. nullopt of a half-space.
std::optional<std::array<double, 3>> extent(const Body& body);

/// The extents of the bodies of a case.
struct BodySizes {
  std::optional<std::array<double, 3>> a, b;
  bool one_body = false;  ///< A alone
  bool plane = false;     ///< the bodies are of the plane: the lengths along z are 0
};
BodySizes sizes_of(const Body& a, const Body& b);
BodySizes sizes_of(const Body& a);

/// "A 2 x 2 x 2, B 1 x 1 x 1"; in the plane "A 2 x 2, B 1 x 1".
std::string sizes_text(const BodySizes& sizes);

/// A sentence if one body is more than 100 times as large as the other.
std::optional<std::string> sizes_note(const BodySizes& sizes);

/// Compares the body with its hull; nullopt if it has no faces, or that was not tried.
std::optional<polytope::MeshConvexity> hull_fact(const Body& body);

/// A mesh that is not convex, or is open, beside its hull.
struct DentedPiece {
  std::size_t piece = 0;            ///< its number in a union
  std::string name = {};            ///< of its group or file, "" if there is none
  polytope::MeshConvexity found{};  ///< has dents, or is open
};
using DentedPieces = std::vector<DentedPiece>;

/// Compares the pieces with their hulls, or a mesh as the only one; nullopt if there are no faces.
/// A piece of which that was not tried is left out.
std::optional<DentedPieces> dented_pieces(const Body& body);

/// What is known of the bodies of a case.
struct HullFacts {
  std::optional<polytope::MeshConvexity> a, b;
  std::optional<DentedPieces> pieces_a = std::nullopt, pieces_b = std::nullopt;
};

/// "A is not convex, its hull is 33 % larger, its deepest point 1 inside the hull", "A is open", of
/// the body so called; "" if it is neither. The percentage is rounded down to two digits.
std::string dents_of(std::string_view body, const polytope::MeshConvexity& found);

/// The same of each piece of a union, called `body`, joined by "; ": of the first eight.
std::string dents_text(std::string_view body, const DentedPieces& pieces);

/// The same of each body. What is merely open is left out unless `open_too`.
std::string dents_text(const HullFacts& facts, bool open_too = true);

/// Why no width takes a union, and why no study does.
inline constexpr const char* width_of_union =
    "its width is that of the hull: give the points of all pieces as one body";
inline constexpr const char* study_of_union =
    "the coincidences of a study are those of two convex bodies; study a piece of each";

/// The sentence that an answer begins with: that it is about hulls, and what else could be asked;
/// of the width, which is that of the hull, that as well. "" if the bodies are their hulls.
std::string about_hulls(const HullFacts& facts, bool width = false);

}  // namespace fathom::shapes
