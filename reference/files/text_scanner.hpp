// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and tokens of a text, with the place of each for messages. Looks at bytes only: no locale,
// no copies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fathom::files {

/// What some programs write before a text in UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// What a scan skips besides blanks.
struct ScanRules {
  char comment = '\0';        ///< starts a comment that runs to the end of the line; '\0' for none
  bool continuation = false;  ///< a backslash that ends a line joins it to the next
};

/// Walks over a text it does not own. Lines end in LF, CR LF or a lone CR; a byte order mark is
/// skipped.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string file, ScanRules rules = {}, std::size_t first_line = 1);

  /// Goes to the next line that holds a token (or is joined to one that may). Returns false if none
  /// is left.
  bool next_line();
  /// Returns the next token of the line, or an empty one at its end.
  std::string_view next_token();
  /// Returns the next token, on this line or a later one, or an empty one at the end of the text.
  std::string_view next_token_anywhere();
  /// Returns the rest of the line, without comment and outer blanks. Does not move.
  [[nodiscard]] std::string_view rest_of_line() const;
  /// The same of a name, which may hold the character that starts comments elsewhere.
  [[nodiscard]] std::string_view name_to_end_of_line() const;
  /// Reads the next token of the line as a count: decimal digits only. `what` names it in the
  /// message: "the number of vertices".
  std::uint64_t count(const std::string& what);

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Returns the number of bytes after this line: a bound on all that can still come.
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - next_; }

  /// Throws InputError "file:line: expected ..., found ...". An empty `token` is called the end of
  /// the line.
  [[noreturn]] void fail(const std::string& expected, std::string_view token) const;
  /// The same where the text ends too early.
  [[noreturn]] void fail_at_end(const std::string& expected) const;

 private:
  void take_line();
  [[nodiscard]] std::string_view trimmed(std::size_t end) const;

  std::string_view text_;
  std::string file_;
  ScanRules rules_;
  std::size_t position_ = 0, line_end_ = 0, whole_end_ = 0, next_ = 0;  // line_end_ is before a comment
  std::size_t line_;
  bool started_ = false, joined_ = false;
};

/// Returns whether `token` is decimal digits that fit 64 bits; if so, sets `value`.
bool parse_count(std::string_view token, std::uint64_t& value);

}  // namespace fathom::files
