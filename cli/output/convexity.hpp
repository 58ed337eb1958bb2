// SPDX-License-Identifier: GPL-3.0-or-later
// Whether meshes are the hulls that stand for them: of a torus the answer is that of its hull, and people are to hear it.
#pragma once

#include <optional>
#include <string>

#include "cli/output/json.hpp"
#include "fathom/files.hpp"
#include "reference/polytope/mesh_convexity.hpp"

namespace fathom::cli {

/// What is known of the bodies of a case; nullopt of those without faces.
struct HullFacts {
  std::optional<polytope::MeshConvexity> a, b;
};

/// Compares the bodies that have faces with their hulls.
HullFacts hull_facts(const Case& input, bool one_body);

/// "A is not convex: the hull holds 2.2 times its volume, its deepest point is 0.7 inside", for each body that is not, joined by "; "; or "".
std::string dents_text(const HullFacts& facts);

/// {"a": {"convex": true}}; null if no mesh was compared.
std::optional<Json> hull_object(const HullFacts& facts);

}  // namespace fathom::cli
