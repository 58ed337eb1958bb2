// SPDX-License-Identifier: GPL-3.0-or-later
// Signed depths of shapes, printed as text and as JSON.
#pragma once

#include <string>

#include "cli/args/request.hpp"
#include "cli/output/about_bodies.hpp"
#include "fathom/signed_depth.hpp"

namespace fathom::cli {

/// The answer to a case with a body that is no polytope.
struct ShapeAnswer {
  std::string id;
  SignedDepth depth;
  BodyFacts facts = {};          ///< which bodies are flat
  std::string certificate = {};  ///< as text, if one is requested
  AboutBodies bodies = {};
};

/// Several lines; one line, which begins with the id; one line of JSON. Each without the last newline.
std::string shape_block(const ShapeAnswer& answer, const Request& request);
std::string shape_line(const ShapeAnswer& answer, const Request& request);
std::string shape_json(const ShapeAnswer& answer, const Request& request);

/// Whether cores touch such that not one direction is optimal but all of a cone.
bool has_continuum(const SignedDepth& depth);

/// The status and the length that goes with it: "penetrating: depth 0.5", "disjoint: distance 2", "undecided: signed depth from ...".
std::string shape_length_text(const SignedDepth& depth);

}  // namespace fathom::cli
