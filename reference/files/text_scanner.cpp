// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/text_scanner.hpp"

#include <charconv>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"

namespace fathom::files {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n'; }

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string file, ScanRules rules, std::size_t first_line)
    : text_(text), file_(std::move(file)), rules_(rules), line_(first_line) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

// The line [position_, line_end_) starts at next_; its comment and a joining backslash are left
// out.
void TextScanner::take_line() {
  line_ += started_ ? 1 : 0;
  started_ = true;
  position_ = next_;
  std::size_t end = position_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
  whole_end_ = end;
  next_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : end < text_.size() ? 1 : 0);
  std::string_view line = text_.substr(position_, end - position_);
  if (rules_.comment != '\0') line = line.substr(0, line.find(rules_.comment));
  line_end_ = position_ + line.size();
  joined_ = rules_.continuation && line_end_ == end && line.ends_with('\\');
  if (joined_) --line_end_;
}

bool TextScanner::next_line() {
  while (joined_) take_line();
  while (next_ < text_.size()) {
    take_line();
    while (position_ < line_end_ && is_blank(text_[position_])) ++position_;
    if (position_ < line_end_ || joined_) return true;
  }
  position_ = line_end_ = whole_end_ = text_.size();
  return false;
}

std::string_view TextScanner::next_token() {
  while (true) {
    while (position_ < line_end_ && is_blank(text_[position_])) ++position_;
    const std::size_t start = position_;
    while (position_ < line_end_ && !is_blank(text_[position_])) ++position_;
    if (position_ > start) return text_.substr(start, position_ - start);
    if (!joined_) return {};
    take_line();
  }
}

std::string_view TextScanner::next_token_anywhere() {
  std::string_view token = next_token();
  while (token.empty() && next_line()) token = next_token();
  return token;
}

std::string_view TextScanner::rest_of_line() const { return trimmed(line_end_); }

std::string_view TextScanner::name_to_end_of_line() const { return trimmed(whole_end_); }

std::string_view TextScanner::trimmed(std::size_t end) const {
  std::size_t start = position_;
  while (start < end && is_blank(text_[start])) ++start;
  while (end > start && is_blank(text_[end - 1])) --end;
  return text_.substr(start, end - start);
}

std::uint64_t TextScanner::count(const std::string& what) {
  const std::string_view token = next_token();
  std::uint64_t value = 0;
  if (!parse_count(token, value)) fail(what, token);
  return value;
}

void TextScanner::fail(const std::string& expected, std::string_view token) const {
  throw InputError(
      file_, line_,
      "expected " + expected + ", found " + (token.empty() ? "the end of the line" : kernels::shown(token)));
}

void TextScanner::fail_at_end(const std::string& expected) const {
  throw InputError(file_, line_, "expected " + expected + ", found the end of the file");
}

bool parse_count(std::string_view token, std::uint64_t& value) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return !token.empty() && error == std::errc() && stop == end;
}

}  // namespace fathom::files
