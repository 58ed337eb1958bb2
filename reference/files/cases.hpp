// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as texts: read one after another from a stream, and written. To find where a case ends is
// little work beside reading it, so that one thread can hand out texts to many.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/text/json.hpp"

namespace fathom::files {

/// The text of one case, or the error in its place.
struct UnreadCase {
  std::size_t line = 1;  ///< where it begins
  std::string text;
  std::optional<InputError> error = {};
};

/// Reads the case, as parse_case does. Throws nothing on bad input; may throw std::bad_alloc.
CaseItem read_case(const UnreadCase& text, const std::string& name);

/// Whether a body of the case is a union of pieces.
inline bool has_union(const Case& single) { return single.a.pieces || single.b.pieces; }

/// As CaseStream, which reads each text as it comes.
class UnreadCases {
 public:
  UnreadCases(std::istream& input, std::string name, CaseLayout layout = CaseLayout::lines)
      : input_(&input), name_(std::move(name)), layout_(layout) {}

  static UnreadCases open(const std::string& path, std::istream& standard_input);

  std::optional<UnreadCase> next();
  [[nodiscard]] std::size_t case_line() const { return case_line_; }
  /// The name of the input, for messages.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  UnreadCases(std::unique_ptr<std::istream> input, std::string name, CaseLayout layout)
      : owned_(std::move(input)), input_(owned_.get()), name_(std::move(name)), layout_(layout) {}

  bool next_line(std::string& line);
  void take_back(std::string line);
  void read_rest_of_case(std::string& text);
  void read_document(std::string& text);
  void append(std::string& text, const std::string& line);
  UnreadCase refuse_long();
  [[nodiscard]] UnreadCase failure(std::size_t line, const std::string& message) const;

  std::unique_ptr<std::istream> owned_;
  std::istream* input_;
  std::string name_;
  CaseLayout layout_;
  std::size_t line_ = 0, case_line_ = 1;  ///< of the line read last; of the case
  LineRead kept_ = LineRead::whole;       ///< or why the current case is lost
  std::optional<std::string> pending_;
  bool any_ = false, finished_ = false;
};

// Cases and their bodies as JSON, with every number exact for every reader.
//                                                                        [case.schema.json]

/// The name of the schema of a case, as each case may say it.
inline constexpr std::string_view case_schema = "fathom/case/1";

/// Whether fields with their default values (axis z, identity pose) are written.
enum class Defaults { left_out, written };

/// A body by its words if it has some, else by its vertices, which are placed if there is a pose.
/// Throws std::invalid_argument for a shape that is no polytope and has no words.
text::Json body_json(const Body& body, const std::optional<Pose>& pose = std::nullopt);
/// By its vertices, with the pose as it was given: a matrix, or a quaternion and a translation.
text::Json body_json(const Body& body, const GivenPose& pose);
text::Json body_json(const NamedBody& body, Defaults defaults = Defaults::left_out);
text::Json motion_json(const Motion& motion);

/// A case to be written. Empty fields are left out.
struct CaseText {
  std::string id;
  text::Json a, b;
  std::vector<std::pair<std::string, std::string>> source;  ///< keys, which need no escapes, and texts
  std::string comment;
  bool pose_rounding = false;  ///< whether readers round the placed points once to binary64
  std::optional<Motion> motion = {};
  bool plane = false;  ///< the bodies are of the plane
};

/// One line of pure ASCII, without its newline.
std::string case_json(const CaseText& text);
std::string case_json(const Case& pair, const std::string& comment = "");

// The text of the exception that FCL throws when its signed distance fails ("Error with
// configuration"): two shapes and their poses.

/// A shape in its own frame, and where it stands.
struct FclShape {
  Body body;
  Pose pose;
};

/// One failure.
struct FclFailure {
  std::size_t line = 0;  ///< where "Shape 1" stands
  FclShape first, second;
  std::string message;  ///< FCL's own, on one line; may be empty
};

/// Returns every failure in a log, in order. Skips lines of other programs between them, and what
/// stands before "Shape 1:" on a line. Reads both spellings: that of FCL 0.6 and 0.7 ("Shape 1:
/// Box0.5 0.5 0.5", matrices in columns) and the later one ("Box<double>(0.5, 0.5, 0.5);", matrices
/// with commas). Boxes and Convex with their points are bodies; decimals mean the nearest binary64.
/// Throws InputError with file, line and what was expected: another shape (a sphere is not a
/// polytope), a Convex printed without its points, a bad number, a last row that is not 0 0 0 1, or
/// no failure in the text at all.
std::vector<FclFailure> read_fcl_text(std::string_view text, const std::string& name);

}  // namespace fathom::files
