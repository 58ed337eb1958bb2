// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of shapes: two bodies by their names, and what is known of the answer.                                     [docs/shapes.md]
#pragma once

#include <optional>
#include <string>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::families {

using files::named;
using files::named_hull;
using files::named_sum;
using files::NamedBody;
using files::posed;
using files::rounded;
using files::shape_of;

/// What is known of the answer by construction.
struct KnownDepth {
  Surd signed_depth;
  std::optional<Point> direction = std::nullopt;  ///< one that attains it, of length 1
};

/// Two bodies that have no id yet.
struct NamedPair {
  NamedBody a, b;
  std::optional<KnownDepth> known = std::nullopt;
};

struct ShapeCase {
  std::string id;
  NamedPair pair;

  /// What a reader finds in the printed case.
  [[nodiscard]] Case read() const { return {id, files::body_of(pair.a), files::body_of(pair.b)}; }
};

}  // namespace fathom::families
