// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as JSON, schema fathom/case/1 (schemas/case.schema.json): one per line, or one pretty-printed.
//
// A JSON number means the nearest binary64 of its decimal text, as in any other program, integers too; 1e400 is an error.
// A string is exact: integer, p/q, decimal, C99 hex float. "pose" is applied exactly, as an affine map. "pose_rounding": "binary64",
// in the case or in one body, then rounds the placed vertices once. Unknown fields are passed over; a field of ours that is given
// twice is an error, since readers differ in which one they take. null stands for an optional field that is not given.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "reference/files/body.hpp"
#include "reference/files/source.hpp"

namespace fathom {

/// One case of a stream, or why it is none.
struct CaseItem {
  std::size_t line = 1;  ///< where it begins
  std::string id;        ///< its id, else its line number as text; also of a bad case, if it could be read
  std::variant<Case, InputError> outcome;

  [[nodiscard]] bool ok() const { return std::holds_alternative<Case>(outcome); }
  [[nodiscard]] const Case& value() const { return std::get<Case>(outcome); }
  [[nodiscard]] const InputError& error() const { return std::get<InputError>(outcome); }
};

/// The case in `text`, which begins on line `line` of the input called `name`. Throws nothing on bad input.
CaseItem parse_case(std::string_view text, const std::string& name, std::size_t line = 1);

/// How cases lie in an input.
enum class CaseLayout {
  lines,    ///< one a line; but a line that is "{" alone starts a case that runs until its braces balance (or an unindented "{")
  document  ///< a single case, however it is broken into lines
};

/// Cases one after another: each is read, and can be answered, before the line after it is read. Blank lines are skipped.
/// A bad case is an item of its own and the stream goes on. An input without any case yields one error.
class CaseStream {
 public:
  /// Reads `input`, which must outlive the stream; `name` is for messages.
  CaseStream(std::istream& input, std::string name, CaseLayout layout = CaseLayout::lines);

  /// Opens a file; "-" is `standard_input`, named "<stdin>". A .json file is a document, unless more follows its first value.
  /// InputError if it cannot be read.
  static CaseStream open(const std::string& path, std::istream& standard_input);

  /// The next case; nothing at the end. A case of more than longest_line bytes is a bad one. Throws std::bad_alloc where memory ends:
  /// that case, which begins on line case_line(), is passed over then, and the stream can go on.
  std::optional<CaseItem> next();
  [[nodiscard]] std::size_t case_line() const { return case_line_; }

 private:
  CaseStream(std::unique_ptr<std::istream> input, std::string name, CaseLayout layout);
  bool next_line(std::string& line);
  void take_back(std::string line);
  void read_rest_of_case(std::string& text);
  void read_document(std::string& text);
  void append(std::string& text, const std::string& line);
  CaseItem refuse_long();
  CaseItem failure(std::size_t line, const std::string& message) const;

  std::unique_ptr<std::istream> owned_;
  std::istream* input_;
  std::string name_;
  CaseLayout layout_;
  std::size_t line_ = 0, case_line_ = 1;  ///< of the line read last; of the case
  LineRead kept_ = LineRead::whole;       ///< else why the case at hand is lost
  std::optional<std::string> pending_;
  bool any_ = false, finished_ = false;
};

}  // namespace fathom
