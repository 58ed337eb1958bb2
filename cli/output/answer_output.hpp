// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answer to a case, of bodies of any kinds: as JSON (schemas/result.schema.json, of unions schemas/union.schema.json), as text
// for people, and as a picture.                                                                                [docs/command_line.md]
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/output/about_bodies.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/answer.hpp"
#include "fathom/files.hpp"
#include "kernels/number/roundings.hpp"
#include "reference/text/json.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {

using text::Json;

/// A case and its answer; for `width` it is about the body against itself.
struct AnsweredCase {
  std::string id;
  Answer answer;
  AboutBodies bodies = {};
  std::string certificate = {};  ///< as text, if one is requested and the answer is complete
};

// ---- JSON: answer_json.cpp ----

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string answer_json(const AnsweredCase& answered, const Request& request);

/// Returns the line for a case of a stream that has no result.
std::string json_error(const std::string& id, std::size_t line, std::string_view error);

/// The first fields of every result, exact or approximate: the schema, the version of fathom, the id, the status.
Json result_head(const std::string& id, std::string_view status);

/// Doubles on both sides of a signed depth: positive if the bodies penetrate, negative if they are apart. Equal if it is that double.
struct SignedDepthBounds {
  double low, high;
};

/// Of bodies that penetrate with this depth, or are this far apart.
SignedDepthBounds penetrating_by(const kernels::Roundings& depth);
SignedDepthBounds apart_by(const kernels::Roundings& distance);

/// The field "signed_depth" but for its exact form. A bound that is infinite becomes null.
Json signed_depth_object(const SignedDepthBounds& bounds);

// ---- text: answer_text.cpp ----

/// Several lines, without the last newline.
std::string answer_block(const AnsweredCase& answered, const Request& request);

/// One line, which begins with the id, without its newline.
std::string answer_line(const AnsweredCase& answered, const Request& request);

/// The word for the method that answered.
inline std::string_view method_name(const Depth& depth) { return depth.method ? name(*depth.method) : "shallow"; }
std::string_view method_name(const SignedDepth& depth);

/// What the run did.
inline const Counters& counters_of(const Depth& depth) { return depth.counters; }
inline Counters counters_of(const SignedDepth& depth) { return depth.counters(); }

/// Appends what the run did, stage by stage.
void add_counters(std::vector<Row>& rows, const Counters& counters);

/// Whether cores touch such that not one direction is optimal but all of a cone.
bool has_continuum(const SignedDepth& depth);

/// The status and the length that goes with it: "penetrating: depth 0.5", "disjoint: distance 2", "undecided: signed depth from ...".
std::string shape_length_text(const SignedDepth& depth);

// ---- a picture: answer_picture.cpp ----

/// What a picture of two bodies and their answer, which is complete, shows.
picture::PairScene answer_scene(const Case& bodies, const Answer& answer);

/// An SVG file of the case and its answer, which is complete, with the numbers of the text below.
std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const Request& request);

}  // namespace fathom::cli
