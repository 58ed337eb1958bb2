// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as JSON, one after another from a stream.
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/source.hpp"

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

/// Places the vertices of `fields`. Returns a sentence on what went wrong, or "".
std::string place(BodyFields& fields, bool rounded, const char* name, Body& body) {
  body.points = std::move(fields.vertices);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    Point& point = body.points[i];
    if (fields.pose) point = placed(point, *fields.pose);
    if ((rounded || fields.rounded) && !round_to_binary64(point)) {
      return std::string(name) + ".vertices[" + std::to_string(i) + "]: expected a point within binary64 once placed, found a larger one";
    }
  }
  return "";
}

}  // namespace

}  // namespace fathom::files

namespace fathom {

CaseItem parse_case(std::string_view text, const std::string& name, std::size_t line) {
  const kernels::DefaultFloatEnvironment environment;
  files::CaseFields fields = files::read_case_fields(text);
  Case result{fields.id.value_or(std::to_string(line)), {}, {}};
  std::string fault = std::move(fields.fault);
  if (fault.empty()) fault = files::place(fields.a, fields.rounded, "a", result.a);
  if (fault.empty()) fault = files::place(fields.b, fields.rounded, "b", result.b);
  std::string id = result.id;
  if (fault.empty()) return {line, std::move(id), std::move(result)};
  return {line, std::move(id), InputError(name, line + fields.fault_line, fault)};
}

/// The lines of an input, put together to cases.
class CaseStream::Reader {
 public:
  Reader(std::istream& input, std::string name, CaseLayout layout) : input_(&input), name_(std::move(name)), layout_(layout) {}
  Reader(std::unique_ptr<std::istream> input, std::string name, CaseLayout layout)
      : owned_(std::move(input)), input_(owned_.get()), name_(std::move(name)), layout_(layout) {}

  std::optional<CaseItem> next();
  [[nodiscard]] std::size_t case_line() const { return case_line_; }

 private:
  bool next_line(std::string& line);
  void take_back(std::string line);
  void read_rest_of_case(std::string& text);
  void read_document(std::string& text);
  void append(std::string& text, const std::string& line);
  CaseItem refuse_long();
  [[nodiscard]] CaseItem failure(std::size_t line, const std::string& message) const;

  std::unique_ptr<std::istream> owned_;
  std::istream* input_;
  std::string name_;
  CaseLayout layout_;
  std::size_t line_ = 0, case_line_ = 1;           ///< of the line read last; of the case
  files::LineRead kept_ = files::LineRead::whole;  ///< or why the current case is lost
  std::optional<std::string> pending_;
  bool any_ = false, finished_ = false;
};

// A line that could not be kept is empty, and condemns its case.
bool CaseStream::Reader::next_line(std::string& line) {
  if (pending_) {
    line = *std::exchange(pending_, std::nullopt);
  } else {
    const files::LineRead read = files::read_line(*input_, line);
    if (read == files::LineRead::none) return false;
    if (kept_ == files::LineRead::whole) kept_ = read;
  }
  ++line_;
  return true;
}

void CaseStream::Reader::take_back(std::string line) {
  pending_ = std::move(line);
  --line_;
}

// `text` is a lone brace. Whatever starts with an unindented brace is a case of its own: this one was cut short.
void CaseStream::Reader::read_rest_of_case(std::string& text) {
  files::Nesting nesting;
  nesting.take(text);
  for (std::string line; !nesting.closed() && next_line(line);) {
    if (line.starts_with('{')) return take_back(std::move(line));
    nesting.take(line);
    append(text, line);
  }
}

void CaseStream::Reader::read_document(std::string& text) {
  for (std::string line; next_line(line);) append(text, line);
}

void CaseStream::Reader::append(std::string& text, const std::string& line) {
  if (kept_ == files::LineRead::whole && text.size() + line.size() >= files::longest_line) kept_ = files::LineRead::too_long;
  try {
    if (kept_ == files::LineRead::whole) (text += '\n') += line;
  } catch (const std::bad_alloc&) {
    kept_ = files::LineRead::no_memory;
  }
  if (kept_ != files::LineRead::whole) std::string().swap(text);
}

CaseItem CaseStream::Reader::refuse_long() {
  constexpr std::string_view limit = "expected a case of at most 256 MiB, found ";
  finished_ = input_->bad();
  return failure(case_line_, std::string(limit) + (finished_ ? "one without an end" : "a longer one"));
}

CaseItem CaseStream::Reader::failure(std::size_t line, const std::string& message) const {
  return {line, std::to_string(line), InputError(name_, line, message)};
}

std::optional<CaseItem> CaseStream::Reader::next() {
  if (finished_) return std::nullopt;
  for (std::string text; next_line(text);) {
    if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    if (kept_ == files::LineRead::whole && files::is_blank(text)) continue;
    any_ = true;
    case_line_ = line_;
    if (layout_ == CaseLayout::document) {
      read_document(text);
    } else if (files::is_lone_brace(text)) {
      read_rest_of_case(text);
    }
    const files::LineRead kept = std::exchange(kept_, files::LineRead::whole);
    if (kept == files::LineRead::no_memory) throw std::bad_alloc();
    return kept == files::LineRead::too_long ? refuse_long() : parse_case(text, name_, case_line_);
  }
  finished_ = true;
  if (input_->bad()) return failure(line_ + 1, "expected a line, found that the input cannot be read further");
  if (!any_) return failure(1, "expected at least one case, found an empty input");
  return std::nullopt;
}

CaseStream::CaseStream(std::istream& input, std::string name, CaseLayout layout)
    : reader_(std::make_unique<Reader>(input, std::move(name), layout)) {}
CaseStream::CaseStream(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
CaseStream::CaseStream(CaseStream&&) noexcept = default;
CaseStream& CaseStream::operator=(CaseStream&&) noexcept = default;
CaseStream::~CaseStream() = default;

CaseStream CaseStream::open(const std::string& path, std::istream& standard_input) {
  if (path == "-") return {standard_input, "<stdin>"};
  if (files::extension(path) == "json") {
    std::string text = files::read_file(path);
    const CaseLayout layout = files::holds_one_value(text) ? CaseLayout::document : CaseLayout::lines;
    return CaseStream(std::make_unique<Reader>(std::make_unique<std::istringstream>(std::move(text)), path, layout));
  }
  files::require_readable(path);
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!file->is_open()) throw InputError(path, 0, "expected a readable file, found one that cannot be opened");
  return CaseStream(std::make_unique<Reader>(std::move(file), path, CaseLayout::lines));
}

std::optional<CaseItem> CaseStream::next() { return reader_->next(); }

std::size_t CaseStream::case_line() const { return reader_->case_line(); }

}  // namespace fathom
