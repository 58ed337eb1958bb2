// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file: which elements follow, how many, and what each consists of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::files {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Returns the bytes of one value in a binary file.
std::size_t size_of(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;                       ///< of the value, or of each item of the list
  std::optional<PlyType> count_type;  ///< if set, the property is a list, whose length comes first in this integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;       ///< offset of the first byte after the header
  std::size_t body_line = 1;  ///< number of the first line after the header
};

/// Throws InputError for anything but a complete header. Its lines end in LF, CR LF or CR, all like the first.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace fathom::files
