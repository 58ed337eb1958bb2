// SPDX-License-Identifier: GPL-3.0-or-later
// What results tell of the bodies, whatever was asked about them.
#pragma once

#include <vector>

#include "cli/output/text_rows.hpp"
#include "fathom/files.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/text/json.hpp"

namespace fathom::cli {

using text::Json;

struct AboutBodies {
  shapes::BodySizes sizes;
  shapes::HullFacts hull;
};

AboutBodies about_bodies(const Case& input, bool one_body);

/// The rows "sizes" and, if a mesh is not convex, "hull".
void add_bodies(std::vector<Row>& rows, const AboutBodies& bodies);
void add_hull(std::vector<Row>& rows, const shapes::HullFacts& facts);

/// The fields "sizes" and, if a body is a mesh with faces or has such pieces, "hull".
void add_bodies(Json& result, const AboutBodies& bodies);
void add_hull(Json& result, const shapes::HullFacts& facts);

}  // namespace fathom::cli
