// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of unions, for people and for programs (JSON, schemas/union.schema.json).
#pragma once

#include <string>

#include "cli/args/request.hpp"
#include "cli/output/about_bodies.hpp"
#include "fathom/union.hpp"

namespace fathom::cli {

/// What was found about a case.
struct UnionAnswer {
  std::string id;
  UnionDepth depth;
  AboutBodies bodies;
  std::string certificate = {};  ///< its text; empty if it was not asked for, or the search was stopped
};

/// Several lines, without the last newline.
std::string union_text(const UnionAnswer& answer, const Request& request);
/// One line.
std::string union_line(const UnionAnswer& answer, const Request& request);
/// One line, pure ASCII.
std::string union_json(const UnionAnswer& answer, const Request& request);

/// An SVG file of two unions, the answer about which is complete: the way out, the pieces in contact, and the answer below.
std::string union_picture(const UnionAnswer& answer, const Pieces& a, const Pieces& b, const Request& request);

}  // namespace fathom::cli
