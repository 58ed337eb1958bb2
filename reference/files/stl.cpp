// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text or binary. "solid" at the start does not tell them apart (binary headers begin so too):
// the size does, 84 + 50 n. A corner is a vertex of its own each time it is written; normals are
// not read (many programs write zeros or nan).
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/messages.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50, normal_size = 12, corners = 3;

std::uint32_t read_word(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = (word << 8) | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

std::uint64_t announced_size(std::string_view bytes) {
  return header_size + facet_size * std::uint64_t{read_word(bytes, 80)};
}

double read_float(std::string_view bytes, std::size_t offset, const std::string& name) {
  const float number = std::bit_cast<float>(read_word(bytes, offset));
  if (std::isfinite(number)) return static_cast<double>(number);
  throw InputError(name, 0,
                   std::string("expected a finite number, found ") + (std::isnan(number) ? "nan" : "inf") +
                       " at byte " + std::to_string(offset));
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_size && bytes.size() == announced_size(bytes);
}

namespace {

/// Each three points are a triangle.
Body soup(GivenPoints points) {
  Body body{std::move(points)};
  body.faces = std::make_shared<const MeshFaces>();
  return body;
}

Body parse_binary(std::string_view bytes, const std::string& name) {
  if (!is_binary_stl(bytes)) {
    const std::string expected = bytes.size() < header_size
                                     ? "at least 84 bytes of a binary STL, or 'solid'"
                                     : std::to_string(announced_size(bytes)) + " bytes for " +
                                           std::to_string(read_word(bytes, 80)) + " triangles of a binary STL";
    throw InputError(name, 0, "expected " + expected + ", found " + std::to_string(bytes.size()) + " bytes");
  }
  if (bytes.size() == header_size) throw InputError(name, 0, "expected at least one triangle, found 0");
  std::vector<std::array<double, 3>> points;
  points.reserve((bytes.size() - header_size) / facet_size * corners);
  for (std::size_t facet = header_size; facet < bytes.size(); facet += facet_size) {
    for (std::size_t corner = 0; corner < corners; ++corner) {
      const std::size_t at = facet + normal_size + 12 * corner;
      points.push_back({read_float(bytes, at, name), read_float(bytes, at + 4, name), read_float(bytes, at + 8, name)});
    }
  }
  return soup(GivenPoints(std::move(points)));
}

// Keywords are compared without case.
bool is_keyword(std::string_view token, std::string_view keyword) {
  if (token.size() != keyword.size()) return false;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (kernels::lower(token[i]) != keyword[i]) return false;
  }
  return true;
}

void expect_keyword(TextScanner& scanner, std::string_view keyword) {
  const std::string_view token = scanner.next_token_anywhere();
  if (is_keyword(token, keyword)) return;
  const std::string expected = "'" + std::string(keyword) + "'";
  if (token.empty()) scanner.fail_at_end(expected);
  scanner.fail(expected, token);
}

// After "facet".
void read_facet(TextScanner& scanner, Decimals decimals, CollectedPoints& points) {
  expect_keyword(scanner, "normal");
  for (int i = 0; i < 3; ++i)
    if (scanner.next_token().empty()) scanner.fail("three components of a normal", {});
  expect_keyword(scanner, "outer");
  expect_keyword(scanner, "loop");
  for (std::size_t i = 0; i < corners; ++i) {
    expect_keyword(scanner, "vertex");
    read_point(scanner, decimals, points);
  }
  expect_keyword(scanner, "endloop");
  expect_keyword(scanner, "endfacet");
}

// After "solid" and its name.
void read_solid(TextScanner& scanner, Decimals decimals, CollectedPoints& points) {
  scanner.next_line();
  while (true) {
    const std::string_view token = scanner.next_token_anywhere();
    if (is_keyword(token, "endsolid")) break;
    if (token.empty()) scanner.fail_at_end("'facet' or 'endsolid'");
    if (!is_keyword(token, "facet")) scanner.fail("'facet' or 'endsolid'", token);
    read_facet(scanner, decimals, points);
  }
}

/// Calls f with the name of each solid, where its facets are to come.
template <class F>
void for_each_solid(std::string_view text, const std::string& name, F f) {
  TextScanner scanner(text, name);
  bool any = false;
  while (scanner.next_line()) {
    const std::string_view token = scanner.next_token();
    if (!is_keyword(token, "solid")) scanner.fail(any ? "'solid' or the end of the file" : "'solid'", token);
    any = f(scanner, scanner.rest_of_line()) || any;
  }
  if (!any) scanner.fail_at_end("at least one facet");
}

bool is_text_stl(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, header_size - sizeof(std::uint32_t));
  const std::size_t first = std::min(start.find_first_not_of(" \t\r\n"), start.size());
  const bool reads_as_text = is_keyword(start.substr(first, 5), "solid") && start.find('\0') == std::string_view::npos;
  return reads_as_text && !is_binary_stl(bytes);
}

}  // namespace

Body parse_stl(std::string_view bytes, const std::string& name, Decimals decimals) {
  if (!is_text_stl(bytes)) return parse_binary(bytes, name);
  CollectedPoints points;
  for_each_solid(bytes, name, [&](TextScanner& scanner, std::string_view) {
    read_solid(scanner, decimals, points);
    return !points.empty();
  });
  return soup(points.take());
}

std::vector<NamedPiece> parse_stl_pieces(std::string_view bytes, const std::string& name, Decimals decimals) {
  std::vector<NamedPiece> pieces;
  if (!is_text_stl(bytes)) pieces.push_back({parse_binary(bytes, name), ""});
  else
    for_each_solid(bytes, name, [&](TextScanner& scanner, std::string_view called) {
      CollectedPoints points;
      read_solid(scanner, decimals, points);
      if (!points.empty()) pieces.push_back({soup(points.take()), std::string(called)});
      return !pieces.empty();
    });
  return pieces;
}

}  // namespace fathom::files
