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
/// The facets of the points' convex hull: coplanar ones merged, corners counter-clockwise seen from
/// outside. Empty if the hull is flat.
Faces faces_of(const std::vector<Point>& points);

/// What fathom sends, without the newline. A body that has words is sent by them, a union by its
/// pieces, any other by its vertices. How they begin to move is sent if the case knows: who puts it
/// to a subject that does not want that leaves it out. Numbers are the shortest decimals that read
/// back as the same number of the precision; `seen` must hold such numbers only.
std::string hello_message();
std::string run_message(const std::string& ticket, const Case& seen, Precision precision, bool with_faces);
std::string stop_message();
/// A body of a run.
std::string body_message(const Body& body, Precision precision, bool with_faces);

/// What a subject says of itself. Throws ProtocolError.
SubjectInfo read_hello(std::string_view line);
/// The hello that says the same.
std::string hello_text(const SubjectInfo& info);

struct Unsupported {
  std::string why;
};
struct Failed {
  std::string why;
};
/// What a subject answered to the run with this ticket.
struct SubjectAnswer {
  std::string ticket;
  std::variant<Reply, Unsupported, Failed> said;
  std::optional<double> microseconds = std::nullopt;  ///< how long the answer took, as it says
  /// the vertices of the hulls that it used
  std::optional<std::vector<Triple>> hull_a = std::nullopt, hull_b = std::nullopt;
  std::string remark = {};  ///< of a reply: unknown fields that look misspelt; see near_misses
};

/// Numbers are rounded to the precision of answers, those of used hulls to that of points. nan, inf
/// and C99 hex floats are understood as bare words and as strings, in any of their usual spellings.
/// Known fields must have their type, whatever `overlap` says; null has none. Unknown fields are
/// skipped, with a remark if they look misspelt. Throws ProtocolError.
SubjectAnswer read_reply(std::string_view line, const NumberFormat& format);

/// Whether the line is a hello, valid or not: the first line of a replay may be one.
bool is_hello(std::string_view line);

// ---- their JSON, whose numbers are as written, even by hand, as a NaN by printf("%g") ----

using text::JsonValue;

/// How many of the bytes that a text begins with are a number, even one that JSON does not have:
/// every bare word that starts like a number, or is a spelling of NaN or infinity.
std::size_t number_word(std::string_view text);

/// The digits of an integer, however it is written ("7", "7.0", "7e0"); nullopt if it is not an
/// integer.
std::optional<std::string> read_integer(std::string_view text);

/// The JSON on the line, its numbers as they were written; null if it is none.
JsonValue json_on(std::string_view line);

}  // namespace fathom::harness
