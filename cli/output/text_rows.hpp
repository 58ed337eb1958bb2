// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of results for people.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/args/request.hpp"
#include "fathom/depth.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

/// A label and its text.
using Row = std::pair<std::string, std::string>;

/// What the command computes: "depth" or "width".
std::string quantity(const Request& request);

/// Returns the heading, if there is one, and the rows with their texts in one column; without the
/// last newline. On a terminal the rows are broken at its width.
std::string aligned(const std::string& heading, const std::vector<Row>& rows);

/// Returns the line for a case of a stream, "id: first; second", broken on a terminal as above.
std::string case_line(const std::string& id, const std::vector<std::string>& parts);

/// Returns the id, or as a JSON string if it holds control characters.
std::string safe_id(const std::string& id);

/// "edge-edge: points 1 2 of A, 3 4 of B"; for one body against itself both are of A.
std::string contact_text(const Contact& contact, bool same_body = false);

/// Adds two points, in two rows if one would be long; or the one that both bodies share.
void add_points(std::vector<Row>& rows, const std::string& label, const std::string& a, const std::string& b,
                bool same_body = false);
void add_witness(std::vector<Row>& rows, const Witness& witness, const Request& request);

/// The bodies without interior: "A and B", or "". For one body against itself: "A", or "".
std::string flat_text(const BodyFacts& facts, bool same_body = false);

/// Explains why a flat A may have a positive depth.
Row flat_note();

/// Adds the rows "sizes" and, if a mesh is not convex, "hull".
void add_bodies(std::vector<Row>& rows, const output::AboutBodies& bodies);
void add_hull(std::vector<Row>& rows, const shapes::HullFacts& facts);

/// "[low, high]" to that many digits.
std::string enclosure_text(const mpq_class& squared, unsigned digits);

}  // namespace fathom::cli
