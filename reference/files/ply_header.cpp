// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/ply_header.hpp"

#include <algorithm>
#include <array>

#include "reference/files/text_scanner.hpp"

namespace fathom::files {
namespace {

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

// Lines by hand, not by the scanner: the first line decides how lines end, since after "end_header" CR a binary body
// may itself begin with the byte LF.
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
    const std::size_t end = separator_.empty() ? bytes_.size() : std::min(bytes_.find(separator_, start), bytes_.size());
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

}  // namespace

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

}  // namespace fathom::files
