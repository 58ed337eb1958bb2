// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as JSON: the text of one, and one after another from a stream.
#include "reference/files/cases.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "kernels/float_environment.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {
namespace {

constexpr std::string_view white_space = " \t\r\n\v\f";

bool is_blank(std::string_view text) { return text.find_first_not_of(white_space) == std::string_view::npos; }

bool is_lone_brace(std::string_view text) {
  const std::size_t brace = text.find_first_not_of(white_space);
  return brace != std::string_view::npos && text[brace] == '{' && is_blank(text.substr(brace + 1));
}

/// Counts braces and brackets outside strings, without caring which closes which: enough to see
/// where a value ends.
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
  rounded = rounded || fields.rounded;
  body.points = std::move(fields.vertices);
  if (!fields.pose && (!rounded || body.points.in_binary64())) return "";
  std::vector<Point>& points = body.points.edit();
  std::vector<std::array<double, 3>> in_binary64;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& point = points[i];
    if (fields.pose) point = placed(point, *fields.pose);
    if (!rounded) continue;
    if (!round_to_binary64(point))
      return std::string(name) + ".vertices[" + std::to_string(i) +
             "]: expected a point within binary64 once placed, found a larger one";
    in_binary64.push_back({point.x.get_d(), point.y.get_d(), point.z.get_d()});
  }
  if (rounded) body.points = GivenPoints(std::move(in_binary64));
  return "";
}

void note_pose(const BodyFields& body, const char* name, std::vector<CaseNote>& notes) {
  if (body.is_shape || !body.pose) return;
  if (const std::string note = pose_note({body.pose}, false); !note.empty())
    notes.push_back({CaseNote::pose, std::string(name) + ".pose: " + note});
}

/// Whether the body has faces and is the hull of the points that they name: those of other shapes
/// are not read.
bool has_mesh(const BodyFields& fields, const Body& body) {
  return fields.has_faces && !body.shape && (!body.words || body.words->shape == "hull");
}

/// Places both bodies. Returns a sentence on what went wrong, or "".
std::string place(const text::JsonValue& document, CaseFields& fields, Case& result, std::vector<CaseNote>& notes) {
  std::string fault;
  if (fields.plane) fields.a.is_shape = fields.b.is_shape = true;
  note_pose(fields.a, "a", notes);
  note_pose(fields.b, "b", notes);
  if (!fields.a.is_shape) fault = place(fields.a, fields.rounded, "a", result.a);
  if (fault.empty() && !fields.b.is_shape) fault = place(fields.b, fields.rounded, "b", result.b);
  if (fault.empty() && (fields.a.is_shape || fields.b.is_shape)) {
    ShapesOfCase shapes =
        read_shapes(document, fields.a.is_shape, fields.b.is_shape, fields.rounded, fields.plane ? 2 : 3);
    if (shapes.a) result.a = *std::move(shapes.a);
    if (shapes.b) result.b = *std::move(shapes.b);
    std::ranges::move(shapes.notes, std::back_inserter(notes));
    fault = std::move(shapes.fault);
  }
  if (fault.empty() && has_mesh(fields.a, result.a))
    fault = read_faces(*document.find("a")->find("faces"), "a.faces", result.a);
  if (fault.empty() && has_mesh(fields.b, result.b))
    fault = read_faces(*document.find("b")->find("faces"), "b.faces", result.b);
  if (fault.empty() && fields.moves) fault = read_motion(*document.find("twist"), result.motion.emplace());
  return fault;
}

}  // namespace

// Returns an empty line in place of one that could not be kept; its case is then an error.
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

// `text` is a lone brace. Whatever starts with an unindented brace is a case of its own: this one
// was cut short.
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

UnreadCase UnreadCases::failure(std::size_t line, const std::string& message) const {
  return {line, "", InputError(name_, line, message)};
}

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

CaseItem read_case(const UnreadCase& text, const std::string& name) {
  const std::size_t line = text.line;
  if (text.error) return {line, std::to_string(line), *text.error};
  const kernels::DefaultFloatEnvironment environment;
  std::optional<CaseFields> quick = quick_case_fields(text.text);
  text::JsonRead read;
  if (!quick || quick->misspelt || quick->a.has_faces || quick->b.has_faces) read = text::read_json(text.text);
  CaseFields fields = quick ? *std::move(quick) : read_case_fields(text.text, read);
  Case result{fields.id.value_or(std::to_string(line)), {}, {}};
  std::string fault = std::move(fields.fault);
  std::vector<CaseNote> notes =
      fields.misspelt && read.whole ? misspelt_fields(read.value, fields.plane) : std::vector<CaseNote>{};
  std::string meant;  // perhaps, where a field is missing
  for (const CaseNote& note : notes) meant += "; " + note.text;
  if (fault.empty()) fault = place(read.value, fields, result, notes);
  if (!fault.empty()) fault += meant;
  std::string id = result.id;
  if (fault.empty()) return {line, std::move(id), std::move(result), std::move(notes)};
  return {line, std::move(id), InputError(name, line + fields.fault_line, fault)};
}

}  // namespace fathom::files

namespace fathom {

CaseItem parse_case(std::string_view text, const std::string& name, std::size_t line) {
  return files::read_case({line, std::string(text)}, name);
}

class CaseStream::Reader {
 public:
  explicit Reader(files::UnreadCases texts) : texts_(std::move(texts)) {}

  std::optional<CaseItem> next() {
    const std::optional<files::UnreadCase> text = texts_.next();
    return text ? std::optional(files::read_case(*text, texts_.name())) : std::nullopt;
  }
  [[nodiscard]] std::size_t case_line() const { return texts_.case_line(); }

 private:
  files::UnreadCases texts_;
};

CaseStream::CaseStream(std::istream& input, std::string name, CaseLayout layout)
    : reader_(std::make_unique<Reader>(files::UnreadCases(input, std::move(name), layout))) {}
CaseStream::CaseStream(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
CaseStream::CaseStream(CaseStream&&) noexcept = default;
CaseStream& CaseStream::operator=(CaseStream&&) noexcept = default;
CaseStream::~CaseStream() = default;

CaseStream CaseStream::open(const std::string& path, std::istream& standard_input) {
  return CaseStream(std::make_unique<Reader>(files::UnreadCases::open(path, standard_input)));
}

std::optional<CaseItem> CaseStream::next() { return reader_->next(); }

std::size_t CaseStream::case_line() const { return reader_->case_line(); }

}  // namespace fathom
