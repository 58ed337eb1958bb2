// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as JSON: the text of one, and one after another from a stream.
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/float_environment.hpp"
#include "reference/files/case_faces.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/misspelt_fields.hpp"
#include "reference/files/named_body.hpp"
#include "reference/files/quick_case_fields.hpp"
#include "reference/files/shape_fields.hpp"
#include "reference/files/unread_cases.hpp"

namespace fathom::files {
namespace {

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
      return std::string(name) + ".vertices[" + std::to_string(i) + "]: expected a point within binary64 once placed, found a larger one";
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

/// Whether the body has faces and is the hull of the points that they name: those of other shapes are not read.
bool has_mesh(const BodyFields& fields, const Body& body) {
  return fields.has_faces && !body.shape && (!body.words || body.words->shape == "hull");
}

/// Places both bodies. Returns a sentence on what went wrong, or "".
std::string place(const std::string& text, CaseFields& fields, Case& result, std::vector<CaseNote>& notes) {
  std::string fault;
  note_pose(fields.a, "a", notes);
  note_pose(fields.b, "b", notes);
  if (!fields.a.is_shape) fault = place(fields.a, fields.rounded, "a", result.a);
  if (fault.empty() && !fields.b.is_shape) fault = place(fields.b, fields.rounded, "b", result.b);
  if (fault.empty() && (fields.a.is_shape || fields.b.is_shape)) {
    ShapesOfCase shapes = read_shapes(text, fields.a.is_shape, fields.b.is_shape, fields.rounded);
    if (shapes.a) result.a = *std::move(shapes.a);
    if (shapes.b) result.b = *std::move(shapes.b);
    std::ranges::move(shapes.notes, std::back_inserter(notes));
    fault = std::move(shapes.fault);
  }
  if (fault.empty() && has_mesh(fields.a, result.a)) fault = read_faces(text, "a", result.a);
  if (fault.empty() && has_mesh(fields.b, result.b)) fault = read_faces(text, "b", result.b);
  return fault;
}

}  // namespace

CaseItem read_case(QuickCaseReader& reader, const UnreadCase& text, const std::string& name) {
  const std::size_t line = text.line;
  if (text.error) return {line, std::to_string(line), *text.error};
  const kernels::DefaultFloatEnvironment environment;
  std::optional<CaseFields> quick = reader.fields(text.text);
  CaseFields fields = quick ? *std::move(quick) : read_case_fields(text.text);
  Case result{fields.id.value_or(std::to_string(line)), {}, {}};
  std::string fault = std::move(fields.fault);
  std::vector<CaseNote> notes = fields.misspelt ? misspelt_fields(text.text) : std::vector<CaseNote>{};
  std::string meant;  // perhaps, where a field is missing
  for (const CaseNote& note : notes) meant += "; " + note.text;
  if (fault.empty()) fault = place(text.text, fields, result, notes);
  if (!fault.empty()) fault += meant;
  std::string id = result.id;
  if (fault.empty()) return {line, std::move(id), std::move(result), std::move(notes)};
  return {line, std::move(id), InputError(name, line + fields.fault_line, fault)};
}

}  // namespace fathom::files

namespace fathom {

CaseItem parse_case(std::string_view text, const std::string& name, std::size_t line) {
  files::QuickCaseReader reader;
  return files::read_case(reader, {line, std::string(text)}, name);
}

class CaseStream::Reader {
 public:
  explicit Reader(files::UnreadCases texts) : texts_(std::move(texts)) {}

  std::optional<CaseItem> next() {
    const std::optional<files::UnreadCase> text = texts_.next();
    return text ? std::optional(files::read_case(reader_, *text, texts_.name())) : std::nullopt;
  }
  [[nodiscard]] std::size_t case_line() const { return texts_.case_line(); }

 private:
  files::UnreadCases texts_;
  files::QuickCaseReader reader_;
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
