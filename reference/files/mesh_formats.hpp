// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the mesh formats, and what they share: lines and tokens of a text, and points that
// stay in binary64 for as long as every coordinate is.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"

namespace fathom::files {

/// What some programs write before a text in UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Returns `text` without the blanks at its ends.
std::string_view trimmed(std::string_view text);

/// What a scan skips besides blanks.
struct ScanRules {
  char comment = '\0';        ///< starts a comment that runs to the end of the line; '\0' for none
  bool continuation = false;  ///< a backslash that ends a line joins it to the next
};

/// Lines and tokens of a text that it does not own, with the place of each for messages. Looks at
/// bytes only: no locale, no copies. Lines end in LF, CR LF or a lone CR; a byte order mark is
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

  std::string_view text_;
  std::string file_;
  ScanRules rules_;
  std::size_t position_ = 0, line_end_ = 0, whole_end_ = 0, next_ = 0;  // line_end_ is before a comment
  std::size_t line_;
  bool started_ = false, joined_ = false;
};

/// Returns whether `token` is decimal digits that fit 64 bits; if so, sets `value`.
bool parse_count(std::string_view token, std::uint64_t& value);

/// A number of a file: in binary64 if it is one of its numbers and was seen to be.
using Coordinate = std::variant<double, mpq_class>;

/// The exact value.
mpq_class exact(Coordinate coordinate);

class CollectedPoints {
 public:
  [[nodiscard]] std::size_t size() const { return in_binary64_ ? binary64_.size() : exact_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  void reserve(std::size_t count) { binary64_.reserve(count); }
  void add(std::array<Coordinate, 3>&& point);
  GivenPoints take() { return in_binary64_ ? GivenPoints(std::move(binary64_)) : GivenPoints(std::move(exact_)); }

 private:
  bool in_binary64_ = true;  // all points so far
  std::vector<std::array<double, 3>> binary64_;
  std::vector<Point> exact_;
};

Body parse_off(std::string_view text, const std::string& name, Decimals decimals);
Body parse_obj(std::string_view text, const std::string& name, Decimals decimals);
Body parse_ply(std::string_view bytes, const std::string& name, Decimals decimals);
Body parse_stl(std::string_view bytes, const std::string& name, Decimals decimals);
/// A piece of a body, and what its group or its file is called; "" if it has no name.
struct NamedPiece {
  Body mesh;
  std::string name;
  std::string other_name = "";  ///< of the mesh that the node of a scene shows
  std::string note = "";        ///< on what placed that node, if anything did; a sentence
};
/// The pieces of a body: the groups of an OBJ file, the solids of an STL file.
std::vector<NamedPiece> parse_obj_pieces(std::string_view text, const std::string& name, Decimals decimals);
std::vector<NamedPiece> parse_stl_pieces(std::string_view bytes, const std::string& name, Decimals decimals);
/// Numbers the corners anew, by those that there are; returns their old numbers, in order.
std::vector<std::uint32_t> renumbered(std::vector<std::uint32_t>& corners);
/// Lines of two numbers, the same in all of them, are a body of the plane.
Body parse_xyz(std::string_view text, const std::string& name, Decimals decimals);
/// The shapes of a drawing, which are bodies of the plane; the first throws InputError unless there
/// is one.
Body parse_svg(std::string_view text, const std::string& name, Decimals decimals);
std::vector<NamedPiece> parse_svg_pieces(std::string_view text, const std::string& name, Decimals decimals);

/// The format of a mesh, by its name or else by its first bytes; nullopt if neither tells.
std::optional<MeshFormat> mesh_format(std::string_view bytes, const std::string& name);

/// The faces as a body keeps them; null if there are none.
std::shared_ptr<const MeshFaces> faces_of(MeshFaces faces);

/// The body of what a file holds; it has no faces if there are none.
Body mesh_body(CollectedPoints points, MeshFaces faces);

/// Returns whether the size is that which the header of a binary STL announces.
bool is_binary_stl(std::string_view bytes);

/// Returns the coordinate in `token`. Throws InputError, with the place of `scanner`, if it is not
/// a number.
Coordinate parse_coordinate(std::string_view token, const TextScanner& scanner, Decimals decimals);

/// The same with the next token of the line.
Coordinate read_coordinate(TextScanner& scanner, Decimals decimals);

/// Adds the point of the next three tokens.
void read_point(TextScanner& scanner, Decimals decimals, CollectedPoints& points);

/// Reserves room for the items that a file announces, but never for more than `bytes_left` bytes
/// can hold at `bytes_each` an item.
template <class Items>
void reserve_within(Items& items, std::uint64_t announced, std::size_t bytes_left, std::size_t bytes_each) {
  const std::uint64_t possible = bytes_left / bytes_each + 1;
  items.reserve(static_cast<std::size_t>(announced < possible ? announced : possible));
}

/// Calls f with the corners of each face of a mesh of so many points. Throws std::invalid_argument
/// if one is none of them.
template <class F>
void for_each_face(const MeshFaces& faces, std::size_t points, F f) {
  std::vector<std::uint32_t> corners = faces.corners;
  if (corners.empty() && faces.ends.empty())
    for (std::uint32_t i = 0; i < points; ++i) corners.push_back(i);
  const bool ordered =
      std::ranges::is_sorted(faces.ends) && (faces.ends.empty() || faces.ends.back() <= corners.size());
  if (!ordered || std::ranges::any_of(corners, [&](std::uint32_t i) { return i >= points; }))
    throw std::invalid_argument("expected faces of points of the mesh, found an index that is none of them");
  const std::span<const std::uint32_t> all = corners;
  if (faces.ends.empty())
    for (std::size_t i = 0; i + 2 < all.size(); i += 3) f(all.subspan(i, 3));
  std::size_t begin = 0;
  for (const std::uint32_t end : faces.ends) {
    f(all.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace fathom::files
