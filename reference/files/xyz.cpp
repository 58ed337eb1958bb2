// SPDX-License-Identifier: GPL-3.0-or-later
// Plain points, one a line: x y z, or x,y,z. Skips further columns (normals, colours), if every line has as many.
// A first line with a single whole number announces how many points follow (as in .pts files), and must be right.
#include <array>
#include <optional>
#include <utility>

#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\v\f\r";
  const std::size_t start = text.find_first_not_of(blanks);
  return start == std::string_view::npos ? std::string_view{} : text.substr(start, text.find_last_not_of(blanks) - start + 1);
}

// A line with a comma is separated by commas alone: "1,5 2,5 3,5" (commas as decimal points) must not pass for numbers.
void split(TextScanner& scanner, std::vector<std::string_view>& columns) {
  columns.clear();
  std::string_view line = scanner.rest_of_line();
  if (line.find(',') == std::string_view::npos) {
    for (std::string_view token = scanner.next_token(); !token.empty(); token = scanner.next_token()) columns.push_back(token);
    return;
  }
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    columns.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  columns.push_back(trimmed(line));
}

std::string number_of(std::size_t columns) { return std::to_string(columns) + (columns == 1 ? " column" : " columns"); }

}  // namespace

Body parse_xyz(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#'});
  CollectedPoints points;
  std::optional<std::uint64_t> announced;
  std::vector<std::string_view> columns;
  std::size_t width = 0;
  while (scanner.next_line()) {
    split(scanner, columns);
    std::uint64_t count = 0;
    if (width == 0 && !announced && columns.size() == 1 && parse_count(columns[0], count)) {
      announced = count;
      reserve_within(points, count, scanner.bytes_left(), 6);  // "0 0 0\n"
      continue;
    }
    const std::string expected = width ? number_of(width) + " as in the lines before" : "three numbers x y z";
    if (columns.size() < 3 || (width && columns.size() != width)) {
      throw InputError(name, scanner.line(), "expected " + expected + ", found " + number_of(columns.size()));
    }
    width = columns.size();
    std::array<Coordinate, 3> point;
    for (std::size_t i = 0; i < point.size(); ++i) point[i] = parse_coordinate(columns[i], scanner, decimals);
    points.add(std::move(point));
  }
  if (points.empty()) scanner.fail_at_end("at least one point x y z");
  if (announced && *announced != points.size()) {
    scanner.fail("the number of points announced, " + std::to_string(*announced), std::to_string(points.size()));
  }
  return {points.take()};
}

}  // namespace fathom::files
