// SPDX-License-Identifier: GPL-3.0-or-later
// One value after another from the body of a PLY file: as text, or as bytes. Both classes have the same functions; an error names the line,
// or the byte. For ply.cpp alone.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "reference/files/mesh_formats.hpp"
#include "reference/files/ply_header.hpp"

namespace fathom::files {

/// One of the items of an element, for messages.
struct PlyItem {
  const PlyElement* element;
  std::uint64_t index;
};

inline std::string described(const PlyItem& item) {
  return item.element->name + " " + std::to_string(item.index + 1) + " of " + std::to_string(item.element->count);
}

/// One item a line, one token a value.
class TextValues {
 public:
  TextValues(std::string_view bytes, const std::string& name, const PlyHeader& header, Decimals decimals)
      : scanner_(bytes.substr(header.body), name, {}, header.body_line), decimals_(decimals) {}

  [[nodiscard]] std::size_t bytes_left() const { return scanner_.bytes_left(); }
  void begin(const PlyItem& item) {
    if (!scanner_.next_line()) scanner_.fail_at_end(described(item));
  }
  Coordinate coordinate(PlyType) { return read_coordinate(scanner_, decimals_); }
  std::int64_t integer(PlyType) {
    const std::string_view token = scanner_.next_token();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || stop != token.data() + token.size()) scanner_.fail("an integer", token);
    return value;
  }
  void skip(PlyType, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i)
      if (scanner_.next_token().empty()) scanner_.fail("one more value", {});
  }
  void end() {
    if (!scanner_.rest_of_line().empty()) scanner_.fail("the end of the line", scanner_.rest_of_line());
  }
  void finish() {
    if (scanner_.next_line()) scanner_.fail("the end of the file", scanner_.rest_of_line());
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const { scanner_.fail(expected, found); }

 private:
  TextScanner scanner_;
  Decimals decimals_;
};

/// Values side by side, without padding.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, const std::string& name, const PlyHeader& header)
      : bytes_(bytes), name_(name), next_(header.body), swap_((header.encoding == PlyEncoding::big_endian) != big_endian_machine) {}

  [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - next_; }
  void begin(const PlyItem& item) { item_ = item; }
  Coordinate coordinate(PlyType type) {
    if (is_integer(type)) return static_cast<double>(integer(type));  // at most 32 bits
    const double number = type == PlyType::float32 ? static_cast<double>(take<float>()) : take<double>();
    if (!std::isfinite(number)) fail("a finite number", std::isnan(number) ? "nan" : "inf");
    return number;
  }
  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8: return take<std::int8_t>();
      case PlyType::uint8: return take<std::uint8_t>();
      case PlyType::int16: return take<std::int16_t>();
      case PlyType::uint16: return take<std::uint16_t>();
      case PlyType::int32: return take<std::int32_t>();
      default: return take<std::uint32_t>();
    }
  }
  void skip(PlyType type, std::uint64_t count) {
    require(count * size_of(type));
    next_ += static_cast<std::size_t>(count) * size_of(type);
  }
  void end() {}
  void finish() {
    last_ = next_;
    if (bytes_left() != 0) fail("the end of the file", std::to_string(bytes_left()) + " more bytes");
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw InputError(name_, 0, "expected " + expected + ", found " + found + " at byte " + std::to_string(last_));
  }

 private:
  static constexpr bool big_endian_machine = std::endian::native == std::endian::big;

  void require(std::uint64_t size) {
    last_ = next_;
    if (size > bytes_left()) fail(std::to_string(size) + " more bytes for " + described(item_), "the end of the file");
  }
  template <class T>
  T take() {
    require(sizeof(T));
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(next_), sizeof(T), raw.begin());
    if (swap_) std::ranges::reverse(raw);
    next_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t next_, last_ = 0;
  bool swap_;
  PlyItem item_{};
};

}  // namespace fathom::files
