// SPDX-License-Identifier: GPL-3.0-or-later
// Studies for people (tables), for programs (JSON, study.schema.json) and for spreadsheets
// (CSV, RFC 4180 with "\n").
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "fathom/study.hpp"
#include "reference/text/json.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {

using text::Json;

/// Where the further lines of a body begin: below what follows "A  ".
inline constexpr std::size_t body_column = 3;

/// Several lines, without the last newline. `all`: with every coincidence that the study lists.
std::string study_block(const Study& study, bool all);

/// "parallel edges", for parallel_edges.
std::string spoken(std::string_view name);

/// One line, without its newline: what is not zero.
std::string study_line(const std::string& id, const Study& study);

/// What studies of polytopes and of shapes begin with; and what one of polytopes has beside that.
Json study_head(const std::string& id);
void add_study(Json& object, const Study& study);

/// The same for shapes.
std::string study_block(const ShapeStudy& study, bool all);
std::string study_line(const std::string& id, const ShapeStudy& study);
std::string study_json(const std::string& id, const ShapeStudy& study);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string study_json(const std::string& id, const Study& study);
/// Returns the line for a case of a stream that has no study.
std::string study_json_error(const std::string& id, std::size_t line, const std::string& error);

/// The names of the columns; a row of counts; a row with nothing but an error. Without their
/// newlines.
std::string study_csv_header();
std::string study_csv_row(const std::string& id, const Study& study);
std::string study_csv_error(const std::string& id, const std::string& error);

// The words of studies, which tables for people and pages share.

/// "8 vertices, 12 edges, 6 facets"; "1 disc, radius 1/2".
std::string size_text(const BodySize& size);
std::string size_text(const ShapeSize& size);

/// "penetrating; depth^2 1/16; 1 optimum"; "penetrating; signed depth 1/2".
std::string status_text(const Depth& depth);
std::string status_text(const SignedDepth& depth);

/// "penetrating"; "undecided" if the bounds leave it open.
std::string_view status_name(const SignedDepth& depth);

/// "axis (0, 0, 1) at (0, 0, 0)".
std::string feature_text(const ShapeFeature& feature);
/// "A axis ..., B axis ...".
std::string involved_text(const ShapeInvolved& involved);

}  // namespace fathom::cli
