// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: the header says what follows; text and binary bodies differ only in how one value is taken.
// Values are exact whatever their declared type: a binary float is itself, a text "0.1" is read
// like any other decimal.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

// ---- the header: which elements follow, how many, and what each consists of ----

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The bytes of one value in a binary file.
std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::float64: return 8;
    default: return 4;
  }
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

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

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array type_names{
    TypeName{"char", PlyType::int8},       TypeName{"int8", PlyType::int8},       TypeName{"uchar", PlyType::uint8},
    TypeName{"uint8", PlyType::uint8},     TypeName{"short", PlyType::int16},     TypeName{"int16", PlyType::int16},
    TypeName{"ushort", PlyType::uint16},   TypeName{"uint16", PlyType::uint16},   TypeName{"int", PlyType::int32},
    TypeName{"int32", PlyType::int32},     TypeName{"uint", PlyType::uint32},     TypeName{"uint32", PlyType::uint32},
    TypeName{"float", PlyType::float32},   TypeName{"float32", PlyType::float32}, TypeName{"double", PlyType::float64},
    TypeName{"float64", PlyType::float64},
};

PlyType read_type(TextScanner& scanner) {
  const std::string_view token = scanner.next_token();
  for (const TypeName& known : type_names)
    if (known.name == token) return known.type;
  scanner.fail("a type such as uchar, int, float or double", token);
}

PlyEncoding read_encoding(TextScanner& scanner) {
  const std::string_view token = scanner.next_token();
  PlyEncoding encoding = PlyEncoding::ascii;
  if (token == "binary_little_endian") {
    encoding = PlyEncoding::little_endian;
  } else if (token == "binary_big_endian") {
    encoding = PlyEncoding::big_endian;
  } else if (token != "ascii") {
    scanner.fail("'ascii', 'binary_little_endian' or 'binary_big_endian'", token);
  }
  const std::string_view version = scanner.next_token();
  if (version != "1.0") scanner.fail("version 1.0", version);
  return encoding;
}

std::string read_name(TextScanner& scanner) {
  const std::string_view token = scanner.next_token();
  if (token.empty()) scanner.fail("a name", token);
  return std::string(token);
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = read_name(scanner);
  element.count = scanner.count("how many '" + element.name + "' there are");
  return element;
}

PlyProperty read_property(TextScanner& scanner) {
  TextScanner ahead = scanner;
  if (ahead.next_token() != "list") {
    const PlyType type = read_type(scanner);
    return {read_name(scanner), type, std::nullopt};
  }
  scanner.next_token();
  const PlyType count_type = read_type(scanner);
  if (!is_integer(count_type)) scanner.fail("an integer type for the length of a list", "a floating-point one");
  const PlyType type = read_type(scanner);
  return {read_name(scanner), type, count_type};
}

// Lines by hand, not by the scanner: the first line decides how lines end, since after "end_header"
// CR a binary body may itself begin with the byte LF.
class HeaderLines {
 public:
  HeaderLines(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    separator_ = bytes.substr(end, bytes.substr(end).starts_with("\r\n") ? 2 : 1);
    TextScanner magic = next();
    const std::string_view token = magic.next_token();
    if (token != "ply" || !bytes.starts_with(token)) magic.fail("the header 'ply'", token);
  }
  TextScanner next() {
    const std::size_t start = next_;
    const std::size_t end =
        separator_.empty() ? bytes_.size() : std::min(bytes_.find(separator_, start), bytes_.size());
    next_ = std::min(end + separator_.size(), bytes_.size());
    TextScanner line(bytes_.substr(start, end - start), name_, {}, ++line_);
    line.next_line();
    return line;
  }
  [[nodiscard]] bool at_end() const { return next_ == bytes_.size(); }
  [[nodiscard]] std::size_t offset() const { return next_; }
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::string_view bytes_, separator_;
  const std::string& name_;
  std::size_t next_ = 0, line_ = 0;
};

void read_line(std::string_view keyword, TextScanner& line, PlyHeader& header) {
  if (keyword == "element") {
    header.elements.push_back(read_element(line));
  } else if (keyword == "property") {
    if (header.elements.empty()) line.fail("'element'", keyword);
    header.elements.back().properties.push_back(read_property(line));
  } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
    line.fail("'element', 'property', 'comment' or 'end_header'", keyword);
  }
}

/// Throws InputError for anything but a complete header. Its lines end in LF, CR LF or CR, all like
/// the first.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  HeaderLines lines(bytes, name);
  PlyHeader header;
  bool has_format = false;
  while (true) {
    TextScanner line = lines.next();
    const std::string_view keyword = line.next_token();
    if (keyword == "end_header") {
      if (!has_format) line.fail("'format' before the header ends", keyword);
      header.body = lines.offset();
      header.body_line = lines.line() + 1;
      return header;
    }
    if (lines.at_end()) line.fail_at_end("'end_header'");
    if (keyword == "format") {
      header.encoding = read_encoding(line);
      has_format = true;
    } else {
      read_line(keyword, line, header);
    }
  }
}

// ---- one value after another from the body: as text, or as bytes; an error names the line, or the
// byte ----

/// One of the items of an element, for messages.
struct PlyItem {
  const PlyElement* element;
  std::uint64_t index;
};

std::string described(const PlyItem& item) {
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
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    scanner_.fail(expected, found);
  }

 private:
  TextScanner scanner_;
  Decimals decimals_;
};

/// Values side by side, without padding.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, const std::string& name, const PlyHeader& header)
      : bytes_(bytes),
        name_(name),
        next_(header.body),
        swap_((header.encoding == PlyEncoding::big_endian) != big_endian_machine) {}

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

bool is_list(const PlyProperty& property) { return property.count_type.has_value(); }

template <class Values>
void skip_property(Values& values, const PlyProperty& property) {
  if (!is_list(property)) return values.skip(property.type, 1);
  const std::int64_t length = values.integer(*property.count_type);
  if (length < 0) values.fail("the length of a list", std::to_string(length));
  values.skip(property.type, static_cast<std::uint64_t>(length));
}

template <class Values>
void read_vertex(Values& values, const PlyElement& element, CollectedPoints& points) {
  std::array<Coordinate, 3> point;
  for (const PlyProperty& property : element.properties) {
    const bool is_coordinate = property.name == "x" || property.name == "y" || property.name == "z";
    if (is_coordinate) point[static_cast<std::size_t>(property.name[0] - 'x')] = values.coordinate(property.type);
    else skip_property(values, property);
  }
  points.add(std::move(point));
}

template <class Values>
void read_face(Values& values, const PlyElement& element, std::uint64_t vertices, MeshFaces& faces) {
  for (const PlyProperty& property : element.properties) {
    if (property.name != "vertex_indices" && property.name != "vertex_index") {
      skip_property(values, property);
      continue;
    }
    const std::int64_t corners = values.integer(*property.count_type);
    if (corners < 0) values.fail("the number of corners of a face", std::to_string(corners));
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t index = values.integer(property.type);
      const bool good = index >= 0 && static_cast<std::uint64_t>(index) < vertices;
      if (!good) values.fail("a vertex index below " + std::to_string(vertices), std::to_string(index));
      faces.corners.push_back(static_cast<std::uint32_t>(index));
    }
    faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
}

// Bytes that one element takes at least: what bounds the room reserved for a count that nobody has
// checked yet.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += encoding == PlyEncoding::ascii ? 2 : size_of(property.count_type.value_or(property.type));
  return size;
}

template <class Values>
Body read_elements(Values values, const PlyHeader& header, std::uint64_t vertices) {
  CollectedPoints points;
  MeshFaces faces;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no room, whatever its count
    if (element.name == "vertex")
      reserve_within(points, vertices, values.bytes_left(), least_size(element, header.encoding));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.begin({&element, i});
      if (element.name == "vertex") {
        read_vertex(values, element, points);
      } else if (element.name == "face") {
        read_face(values, element, vertices, faces);
      } else {
        for (const PlyProperty& property : element.properties) skip_property(values, property);
      }
      values.end();
    }
  }
  values.finish();
  return mesh_body(std::move(points), std::move(faces));
}

// Checks the shape of what will be read; returns the number of vertices.
std::uint64_t require_vertices(const PlyHeader& header, const std::string& name) {
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  const auto refuse = [&](const std::string& expected, const std::string& found) {
    throw InputError(name, header.body_line - 1, "expected " + expected + ", found " + found + " in the header");
  };
  if (vertex == header.elements.end()) refuse("an element 'vertex'", "none");
  for (const PlyElement& element : header.elements) {
    const bool again = element.name == "vertex" && &element != &*vertex;
    if (again) refuse("one element 'vertex'", "two");
    for (const PlyProperty& property : element.properties) {
      const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
      if (element.name == "face" && indices && !(is_list(property) && is_integer(property.type)))
        refuse("'" + property.name + "' to be a list of integers", "another type");
    }
  }
  for (const std::string coordinate : {"x", "y", "z"}) {
    const auto count = std::ranges::count(vertex->properties, coordinate, &PlyProperty::name);
    const auto property = std::ranges::find(vertex->properties, coordinate, &PlyProperty::name);
    if (count != 1) refuse("one property '" + coordinate + "' of the vertices", std::to_string(count));
    if (is_list(*property)) refuse("'" + coordinate + "' to be a number", "a list");
  }
  if (vertex->count == 0) refuse("at least one vertex", "0");
  return vertex->count;
}

}  // namespace

Body parse_ply(std::string_view bytes, const std::string& name, Decimals decimals) {
  const PlyHeader header = parse_ply_header(bytes, name);
  const std::uint64_t vertices = require_vertices(header, name);
  if (header.encoding == PlyEncoding::ascii)
    return read_elements(TextValues(bytes, name, header, decimals), header, vertices);
  return read_elements(BinaryValues(bytes, name, header), header, vertices);
}

}  // namespace fathom::files
