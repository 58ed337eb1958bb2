// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the mesh formats, and what they share: points that stay in binary64 for as long as
// every coordinate is.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/text_scanner.hpp"

namespace fathom::files {

/// A number of a file: in binary64 if it is one of its numbers and was seen to be.
using Coordinate = std::variant<double, mpq_class>;

/// The exact value.
mpq_class exact(Coordinate coordinate);

class CollectedPoints {
 public:
  [[nodiscard]] std::size_t size() const { return in_binary64_ ? binary64_.size() : exact_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  void reserve(std::size_t count) { binary64_.reserve(count); }
  void add(std::array<Coordinate, 3> point);
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
/// The pieces of a body: the groups of an OBJ file.
std::vector<Body> parse_obj_pieces(std::string_view text, const std::string& name, Decimals decimals);
Body parse_xyz(std::string_view text, const std::string& name, Decimals decimals);

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

}  // namespace fathom::files
