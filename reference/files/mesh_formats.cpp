// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of meshes share, and the door to them: a format is told by extension or first
// bytes.
#include "reference/files/mesh_formats.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/scene_files.hpp"

namespace fathom::files {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n'; }

std::optional<MeshFormat> format_of_name(const std::string& name) {
  const std::string ending = extension(name);
  if (ending == "off") return MeshFormat::off;
  if (ending == "obj") return MeshFormat::obj;
  if (ending == "ply") return MeshFormat::ply;
  if (ending == "stl") return MeshFormat::stl;
  if (ending == "gltf" || ending == "glb") return MeshFormat::gltf;
  if (ending == "svg") return MeshFormat::svg;
  if (ending == "dae") return MeshFormat::collada;
  if (ending == "3mf") return MeshFormat::threemf;
  if (ending == "xyz" || ending == "txt" || ending == "pts") return MeshFormat::xyz;
  return std::nullopt;
}

bool is_obj_keyword(std::string_view token) {
  constexpr std::array<std::string_view, 8> keywords{"v", "vn", "vt", "f", "o", "g", "mtllib", "usemtl"};
  for (const std::string_view keyword : keywords)
    if (token == keyword) return true;
  return false;
}

/// By the first token that is not a comment; a binary STL by its size.
std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  constexpr std::size_t head = 1024;
  if (bytes.starts_with("glTF")) return MeshFormat::gltf;
  if (bytes.starts_with("<") && bytes.substr(0, head).find("<COLLADA") != std::string_view::npos)
    return MeshFormat::collada;
  if (bytes.starts_with("<") && bytes.substr(0, head).find("<svg") != std::string_view::npos) return MeshFormat::svg;
  TextScanner scanner(bytes, "", {.comment = '#'});
  if (scanner.next_line()) {
    const std::string_view token = scanner.next_token();
    if (token == "ply") return MeshFormat::ply;
    if (token == "solid" || is_binary_stl(bytes)) return MeshFormat::stl;
    if (token.ends_with("OFF") || token.starts_with("OFF")) return MeshFormat::off;
    if (is_obj_keyword(token)) return MeshFormat::obj;
    if (parse_number(token.substr(0, token.find(',')), Decimals::exact).value) return MeshFormat::xyz;
  }
  return std::nullopt;
}

/// What the file holds instead of a mesh, and what to do about it.
std::string other_content(std::string_view bytes, const std::string& name) {
  struct Kind {
    std::string_view ending, beginning, what;
  };
  constexpr std::array<Kind, 5> kinds{
      {{"urdf", "<robot", "a description of a robot, which is not read: name the mesh files that it lists"},
       {"sdf", "<sdf", "a description of a model, which is not read: name the mesh files that it lists"},
       {"npy", "\x93NUMPY",
        "an array of numpy, which is not read: numpy.savetxt('points.xyz', array) writes lines x y z"},
       {"fbx", "Kaydara FBX", "FBX, which is not read: export the mesh as glTF, OBJ, PLY, STL or OFF"},
       {"step", "ISO-10303-21", "STEP, which is not read: export a mesh as glTF, OBJ, PLY, STL or OFF"}}};
  constexpr std::size_t head = 1024;
  const std::string_view start = bytes.substr(0, head);
  for (const Kind& kind : kinds)
    if (extension(name) == kind.ending || start.starts_with(kind.beginning) ||
        (kind.beginning[0] == '<' && start.find(kind.beginning) != std::string_view::npos))
      return std::string(kind.what);
  const std::string_view first = start.substr(0, start.find_first_of("\r\n"));
  const bool table = std::ranges::count(first, ',') >= 2 && first.size() < bytes.size();
  return kernels::shown(bytes) + (table ? ": a table of points has no line with names above them" : "");
}

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

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view TextScanner::rest_of_line() const { return trimmed(text_.substr(position_, line_end_ - position_)); }

std::string_view TextScanner::name_to_end_of_line() const {
  return trimmed(text_.substr(position_, whole_end_ - position_));
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

mpq_class exact(Coordinate coordinate) {
  if (const double* const value = std::get_if<double>(&coordinate)) return exact_value(*value);
  return std::get<mpq_class>(std::move(coordinate));
}

void CollectedPoints::add(std::array<Coordinate, 3>&& point) {
  auto& [x, y, z] = point;
  if (in_binary64_) {
    const double *const u = std::get_if<double>(&x), *const v = std::get_if<double>(&y),
                        *const w = std::get_if<double>(&z);
    if (u && v && w) {
      binary64_.push_back({*u, *v, *w});
      return;
    }
    exact_ = std::move(GivenPoints(std::move(binary64_)).edit());
    in_binary64_ = false;
  }
  exact_.push_back({exact(std::move(x)), exact(std::move(y)), exact(std::move(z))});
}

std::optional<MeshFormat> mesh_format(std::string_view bytes, const std::string& name) {
  const std::optional<MeshFormat> named = format_of_name(name);
  return named ? named : format_of_content(bytes);
}

std::shared_ptr<const MeshFaces> faces_of(MeshFaces faces) {
  if (faces.ends.empty()) return nullptr;
  bool triangles = true;
  for (std::size_t i = 0; i < faces.ends.size() && triangles; ++i) triangles = faces.ends[i] == 3 * (i + 1);
  if (triangles) faces.ends = {};
  return std::make_shared<const MeshFaces>(std::move(faces));
}

Body mesh_body(CollectedPoints points, MeshFaces faces) {
  Body body{points.take()};
  body.faces = faces_of(std::move(faces));
  return body;
}

Coordinate parse_coordinate(std::string_view token, const TextScanner& scanner, Decimals decimals) {
  if (const std::optional<double> quick = kernels::quick_number(token, decimals)) return *quick;
  if (token.empty()) scanner.fail("a number", token);
  ParsedNumber number = parse_number(token, decimals);
  if (!number.value) throw InputError(scanner.file(), scanner.line(), number.error);
  if (const std::optional<double> same = kernels::in_binary64(*number.value)) return *same;
  return *std::move(number.value);
}

Coordinate read_coordinate(TextScanner& scanner, Decimals decimals) {
  return parse_coordinate(scanner.next_token(), scanner, decimals);
}

void read_point(TextScanner& scanner, Decimals decimals, CollectedPoints& points) {
  std::array<Coordinate, 3> point;
  for (Coordinate& c : point) c = read_coordinate(scanner, decimals);
  points.add(std::move(point));
}

}  // namespace fathom::files

namespace fathom {

Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals, MeshFormat format) {
  const kernels::DefaultFloatEnvironment environment;
  if (bytes.empty()) throw InputError(name, 0, "expected a mesh, found an empty file");
  switch (format) {
    case MeshFormat::off: return files::parse_off(bytes, name, decimals);
    case MeshFormat::obj: return files::parse_obj(bytes, name, decimals);
    case MeshFormat::ply: return files::parse_ply(bytes, name, decimals);
    case MeshFormat::stl: return files::parse_stl(bytes, name, decimals);
    case MeshFormat::svg: return files::parse_svg(bytes, name, decimals);
    case MeshFormat::gltf:
    case MeshFormat::collada:
    case MeshFormat::threemf: return files::one_mesh(files::parse_scene(bytes, name, format, nullptr));
    default: return files::parse_xyz(bytes, name, decimals);
  }
}

Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals) {
  if (bytes.empty()) throw InputError(name, 0, "expected a mesh, found an empty file");
  if (const std::optional<MeshFormat> format = files::mesh_format(bytes, name))
    return parse_mesh(bytes, name, decimals, *format);
  throw InputError(name, 1,
                   "expected a mesh (OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF or lines x y z), found " +
                       files::other_content(bytes, name));
}

}  // namespace fathom
