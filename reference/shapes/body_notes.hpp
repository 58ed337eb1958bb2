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

/// "A is not convex: the hull holds 2.2 times its volume, its deepest point is 0.7 inside", of the
/// body so called.
std::string dents_of(std::string_view body, const polytope::Dents& dents);

/// The lengths of a body's box along x, y and z, rounded to the nearest binary64, infinity
/// included; of bodies with discs or balls, upper bounds that are off by a few units in the last
/// place at most. nullopt of a half-space.
std::optional<std::array<double, 3>> extent(const Body& body);

/// The extents of the bodies of a case.
struct BodySizes {
  std::optional<std::array<double, 3>> a, b;
  bool one_body = false;  ///< A alone
};
BodySizes sizes_of(const Body& a, const Body& b);
BodySizes sizes_of(const Body& a);

/// "A 2 x 2 x 2, B 1 x 1 x 1".
std::string sizes_text(const BodySizes& sizes);

/// A sentence if one body is more than 100 times as large as the other.
std::optional<std::string> sizes_note(const BodySizes& sizes);

/// Compares the body with its hull; nullopt if it has no faces, or that was not tried.
std::optional<polytope::MeshConvexity> hull_fact(const Body& body);

/// The pieces of a union that are no hulls of their own, by their numbers.
using DentedPieces = std::vector<std::pair<std::size_t, polytope::Dents>>;

/// Compares the pieces with their hulls, or a mesh as the only one; nullopt if there are no faces.
/// A piece of which that was not tried is left out.
std::optional<DentedPieces> dented_pieces(const Body& body);

/// What is known of the bodies of a case.
struct HullFacts {
  std::optional<polytope::MeshConvexity> a, b;
  std::optional<DentedPieces> pieces_a = std::nullopt, pieces_b = std::nullopt;
};

/// "A is not convex: the hull holds 2.2 times its volume, its deepest point is 0.7 inside", for
/// each body that is not, joined by "; "; or "". Of a union the first such piece is told of, and
/// how many there are.
std::string dents_text(const HullFacts& facts);

/// The same of one union, called `body`.
std::string dents_text(std::string_view body, const DentedPieces& pieces);

}  // namespace fathom::shapes
