// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of cases, one after another from a stream, not yet read: to find where a case ends is
// little work beside reading it, so that one thread can hand out texts to many.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "fathom/files.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::files {

/// The text of one case, or the error in its place.
struct UnreadCase {
  std::size_t line = 1;  ///< where it begins
  std::string text;
  std::optional<InputError> error = {};
};

/// Reads the case, as parse_case does. Throws nothing on bad input; may throw std::bad_alloc.
CaseItem read_case(QuickCaseReader& reader, const UnreadCase& text, const std::string& name);

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

}  // namespace fathom::files
