// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/unread_cases.hpp"

#include <fstream>
#include <new>
#include <sstream>
#include <string_view>
#include <utility>

#include "reference/files/text_scanner.hpp"

namespace fathom::files {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

bool is_blank(std::string_view text) { return text.find_first_not_of(blanks) == std::string_view::npos; }

bool is_lone_brace(std::string_view text) {
  const std::size_t brace = text.find_first_not_of(blanks);
  return brace != std::string_view::npos && text[brace] == '{' && is_blank(text.substr(brace + 1));
}

/// Counts braces and brackets outside strings, without caring which closes which: enough to see where a value ends.
class Nesting {
 public:
  /// Takes text up to the end of the outermost value. Returns how much was taken.
  std::size_t take(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      take(text[i]);
      if (closed_) return i + 1;
    }
    return text.size();
  }
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  void take(char c) {
    if (in_string_) {
      if (c == '"' && !escaped_) in_string_ = false;
      escaped_ = c == '\\' && !escaped_;
    } else if (c == '"') {
      in_string_ = true;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && depth_ > 0) {
      closed_ = --depth_ == 0;
    }
  }

  std::size_t depth_ = 0;
  bool in_string_ = false, escaped_ = false, closed_ = false;
};

/// Whether nothing but blanks follows the first value, which may be cut short.
bool holds_one_value(std::string_view text) { return is_blank(text.substr(Nesting().take(text))); }

}  // namespace

// A line that could not be kept is empty, and condemns its case.
bool UnreadCases::next_line(std::string& line) {
  if (pending_) {
    line = *std::exchange(pending_, std::nullopt);
  } else {
    const LineRead read = read_line(*input_, line);
    if (read == LineRead::none) return false;
    if (kept_ == LineRead::whole) kept_ = read;
  }
  ++line_;
  return true;
}

void UnreadCases::take_back(std::string line) {
  pending_ = std::move(line);
  --line_;
}

// `text` is a lone brace. Whatever starts with an unindented brace is a case of its own: this one was cut short.
void UnreadCases::read_rest_of_case(std::string& text) {
  Nesting nesting;
  nesting.take(text);
  for (std::string line; !nesting.closed() && next_line(line);) {
    if (line.starts_with('{')) return take_back(std::move(line));
    nesting.take(line);
    append(text, line);
  }
}

void UnreadCases::read_document(std::string& text) {
  for (std::string line; next_line(line);) append(text, line);
}

void UnreadCases::append(std::string& text, const std::string& line) {
  if (kept_ == LineRead::whole && text.size() + line.size() >= longest_line) kept_ = LineRead::too_long;
  try {
    if (kept_ == LineRead::whole) (text += '\n') += line;
  } catch (const std::bad_alloc&) {
    kept_ = LineRead::no_memory;
  }
  if (kept_ != LineRead::whole) std::string().swap(text);
}

UnreadCase UnreadCases::refuse_long() {
  constexpr std::string_view limit = "expected a case of at most 256 MiB, found ";
  finished_ = input_->bad();
  return failure(case_line_, std::string(limit) + (finished_ ? "one without an end" : "a longer one"));
}

UnreadCase UnreadCases::failure(std::size_t line, const std::string& message) const { return {line, "", InputError(name_, line, message)}; }

std::optional<UnreadCase> UnreadCases::next() {
  if (finished_) return std::nullopt;
  for (std::string text; next_line(text);) {
    if (line_ == 1 && text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    if (kept_ == LineRead::whole && is_blank(text)) continue;
    any_ = true;
    case_line_ = line_;
    if (layout_ == CaseLayout::document) {
      read_document(text);
    } else if (is_lone_brace(text)) {
      read_rest_of_case(text);
    }
    const LineRead kept = std::exchange(kept_, LineRead::whole);
    if (kept == LineRead::no_memory) throw std::bad_alloc();
    if (kept == LineRead::too_long) return refuse_long();
    return UnreadCase{case_line_, std::move(text)};
  }
  finished_ = true;
  if (input_->bad()) return failure(line_ + 1, "expected a line, found that the input cannot be read further");
  if (!any_) return failure(1, "expected at least one case, found an empty input");
  return std::nullopt;
}

UnreadCases UnreadCases::open(const std::string& path, std::istream& standard_input) {
  if (path == "-") return {standard_input, "<stdin>"};
  if (extension(path) == "json") {
    std::string text = read_file(path);
    const CaseLayout layout = holds_one_value(text) ? CaseLayout::document : CaseLayout::lines;
    return {std::make_unique<std::istringstream>(std::move(text)), path, layout};
  }
  require_readable(path);
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!file->is_open()) throw InputError(path, 0, "expected a readable file, found one that cannot be opened");
  return {std::move(file), path, CaseLayout::lines};
}

}  // namespace fathom::files
