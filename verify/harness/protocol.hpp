// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the protocol fathom/subject/1 to and from text: one JSON object a line.
//                                                                              [verify/PROTOCOL.md]
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fathom/judge.hpp"
#include "reference/text/json_value.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::harness {

inline constexpr std::string_view protocol_name = "fathom/subject/1";

/// A line breaks the protocol; what() says what was expected and what was found.
struct ProtocolError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The facets of a hull, as cycles of point indices.
using Faces = std::vector<std::vector<std::uint32_t>>;
/// Returns the facets of the points' convex hull: coplanar ones merged, corners counter-clockwise
/// seen from outside. Empty if the hull is flat.
Faces faces_of(const std::vector<Point>& points);
/// Returns the edges of the convex hull in the plane z = 0, each from corner to corner and one
/// behind the other, counter-clockwise; empty if the hull has no area.
Faces edges_in_plane(const std::vector<Point>& points);

/// These functions return the messages that fathom sends, without line ends. They write a body with
/// a description by that, a union by its pieces, any other by its vertices; and the motion if the
/// case has one: for a subject that does not want it, remove it first. Numbers are the shortest
/// decimals that read back as the same number of the precision; `seen` must hold such numbers only.
/// A body of the plane is written by its margin and the vertices of its core, two numbers each.
std::string hello_message();
std::string run_message(const std::string& ticket, const Case& seen, Precision precision, bool with_faces);
std::string stop_message();
/// Returns a body of a run.
std::string body_message(const Body& body, Precision precision, bool with_faces);

/// Reads the hello of a subject. Throws ProtocolError.
SubjectInfo read_hello(std::string_view line);
/// Returns a hello with these declarations.
std::string hello_text(const SubjectInfo& info);

struct Unsupported {
  std::string why;
};
struct Failed {
  std::string why;
};
/// The answer of a subject to the run with this ticket.
struct SubjectAnswer {
  std::string ticket;
  std::variant<Reply, Unsupported, Failed> said;
  std::optional<double> microseconds = std::nullopt;  ///< the time of the answer, as the subject measured it
  /// The vertices of the hulls that it used.
  std::optional<std::vector<Triple>> hull_a = std::nullopt, hull_b = std::nullopt;
  std::string remark = {};  ///< on unknown fields that look misspelt; see near_misses
};

/// Reads a reply. Rounds numbers to the precision of answers, those of hulls to that of points.
/// Accepts nan, inf and C99 hex floats as bare words and as strings, in any of their usual
/// spellings. Known fields must have their type, whatever `overlap` says; null is of no type. Skips
/// unknown fields, with a remark if they look misspelt. With dimension 2 points and directions have
/// two coordinates, to which z = 0 is added here. Throws ProtocolError.
SubjectAnswer read_reply(std::string_view line, const NumberFormat& format, unsigned dimension = 3);

/// Returns whether the line is a hello, valid or not: the first line of a replay may be one.
bool is_hello(std::string_view line);

// ---- reading JSON, with numbers as they were written, including those that JSON does not have,
// such as a NaN printed by "%g" ----

using text::JsonValue;

/// Returns the length in bytes of the number that a text begins with, including those that JSON
/// does not have: every bare word that begins like a number, or is a spelling of NaN or infinity.
std::size_t number_word(std::string_view text);

/// Returns the digits of an integer, however it is written ("7", "7.0", "7e0"); nullopt for other
/// numbers.
std::optional<std::string> read_integer(std::string_view text);

/// Returns the JSON on the line, with numbers as they were written; null if it is not JSON.
JsonValue json_on(std::string_view line);

}  // namespace fathom::harness
