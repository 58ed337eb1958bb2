// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a record of shapes says, as exact values; and its line. Serialization is canonical: equal facts give equal bytes.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "verify/golden/shapes/shape_recipe.hpp"

namespace fathom::golden {

/// What an answer about two shapes tells, whoever gives it.
struct ShapeStatement {
  std::variant<Surd, Bounds> value;  ///< the signed depth, exact or enclosed
  Vector direction;
  /// Exact values of cores that are polytopes, or one and a half-space: as SignedDepth::translations() says. Else empty.
  std::vector<AlongNormal> translations;
  std::optional<OptimalCone> cone;  ///< of such cores that touch
};

ShapeStatement truth_of(const SignedDepth& answer);

/// The answer that records tell: with bounds as near as signed_depth makes them, and nearer where these leave the status open. Throws as
/// that does.
SignedDepth answer_about(const Shape& a, const Shape& b, const Options& options);

struct ShapeFacts {
  Recipe recipe;
  FormedShapes bodies;
  ShapeStatement truth;
  std::string certificate_sha256;
};

/// Returns the record's line, without a line feed.
std::string line_of(const ShapeFacts& facts);

}  // namespace fathom::golden
